/* SPDX-License-Identifier: MIT */
/* The high band: modes above the two-way bandwidth. The actual contact forces drive them and the
 * microphones hear them, but they do not act back on the contacts, which hardly feel them.
 *
 * There are too many modes up there to keep, and most are silent: they are slower than sound and
 * radiate from the edge alone. So each Bessel function of either head counts as a mode of its own.
 * Its mass is that of the air, 2 rho0/(K sqrt(1 - (k0/K)^2)) per area, K = z/R (a plane wave slower
 * than sound on both sides). Its radiation is the baffled one (of the outer side, on a drum with a
 * cavity), times one factor per microphone and one for the resistance, of each head. The factors
 * stand for the edge and for the coupling of modes by the air. They depend on the place and hardly
 * on the frequency (an open edge: 5.4, 6.5 and 7.7 dB less than a baffled one at three places,
 * within 0.5 dB from z = 20 to 108, tests/engine/test_high_band.c), so they are measured on the
 * upper two-way modes.
 *
 * Modes of the enclosed air (high_cavity.h) ring on where the heads' own have died: those of a tom
 * decay with 20 to 30 1/s, its heads' with 40 to 75 1/s. Strikers drive them through the batter
 * head, of whose functions they take a part. Wires do not drive them: functions that wires damp
 * pass nothing on to the air. (With modes for the wires' pushes, too, the first 50 ms of a snare
 * drum were 4 to 5 dB too loud from 5 to 16 kHz, without them within 2.5 dB.) Of thousands of modes
 * a few dozen in each sixth of an octave are kept (high_air_choice.h). Without any, toms were 3 to
 * 12 dB too soft from 5 to 10 kHz after 50 ms.
 *
 * A microphone inside hears the air's modes and what a head's function drives in a cavity of rigid
 * walls (cavity_pressure.h). Against all modes up to 16 kHz as two-way ones, third octaves from 5
 * kHz on are within 2.6 dB in the mean over nine places, inside within 2.5 dB
 * (tests/engine/test_high_band.c).
 *
 * In each sixth of an octave, the modes of a head, and apart from them those of the air, are sorted
 * by the energy that they can bring to a microphone outside the shell, (gain sin(wk)/(wk))^2/(4 s),
 * and kept until they hold 99.9 % of it. If that makes more than TB_HIGH_MOST modes
 * (TB_HIGH_MOST_LIVE at live), every sixth of an octave keeps less. The modes kept carry the energy
 * of the others, and walk in phase as if they were those, too (scattering.h): without that, each
 * rings as a tone. With 512 modes at live lines would be as few, but third octaves 3 to 9 dB off,
 * most of all from 10 kHz on; 2,048 modes move them by up to 2 dB. 1,024 modes cost a snare drum 7
 * % and a tom 8 %.
 *
 * A force that stays would only make modes lean, and scattering, which turns them about their rest,
 * would make noise of that: thrown off, a snare drum's wires hissed at -86 dBFS for good, by the
 * load that they had taken from the head. So modes are pushed by what is left of a push behind a
 * high-pass filter of first order at 200 Hz, which takes 0.03 dB at 2.5 kHz.
 *
 * Strikers drive the modes through their patches. The wires' points are gathered in groups along
 * the bed; each group pushes at its middle. Evenly spaced forces along a wire almost cancel at the
 * head's own wavelength, so groups must be even: a group is the same point of every wire, or as
 * many neighbouring points as it takes to have at most TB_HIGH_GROUPS. (Sixteen uneven groups on a
 * snare drum's 23 points: 3 to 5 dB too loud at 6 and 8 kHz.)
 *
 * Wires in contact also damp the head: wire_hold.h says by how much. A two-way mode feels this
 * through the solve. Without it, everything is 5 to 9 dB too loud.
 *
 * Limits: the wires do not feel the band. The push of one group acts at its middle, so forces that
 * neighbouring wires share are heard a little too much: 2 to 6 dB while a stroke is fresh.
 *
 * At draft and live the band moves in single precision: rounding changes a mode by some 1e-6 of
 * itself, and no energy balance depends on it. */
#ifndef TB_HIGH_BAND_H
#define TB_HIGH_BAND_H

#include "kernels/precision.h"
#include "model/modes.h"
#include "model/wire_hold.h"

#define TB_HIGH_GROUPS 64u
#define TB_HIGH_MOST 2048u
#define TB_HIGH_MOST_LIVE 1024u

#define TB_TEMPLATE "model/high_band_tmpl.h"
#include "kernels/both.h"

/* Push of the groups on consecutive modes of their head. */
typedef struct TbHighPush {
  uint32_t from, size; /* the modes */
  uint32_t rows;
  float *table; /* [rows][size]: -side g phi at the groups' middles */
} TbHighPush;

typedef struct TbHighBand {
  uint32_t count, padded; /* modes kept, sine copies counted; 0: no high band */
  uint32_t begin[3];      /* start of each head's modes, padded */
  uint32_t odd[2];        /* cosine copies of odd order, padded; they come first */
  uint32_t cosines[2];    /* cosine copies of all orders, padded; order 0 is last */
  uint32_t sines[2];      /* sine copies; they follow in the same order */
  uint32_t candidates;    /* Bessel functions to choose from */
  uint32_t orders;        /* all angular orders are below */
  uint32_t *order;        /* [padded] angular order m */
  uint8_t *of_air;        /* [padded] 1: a mode of the enclosed air, which no wire moves */
  double *zero, *scale;   /* [padded] z, and the shape's factor for unit modal mass */
  double *g, *stiffness;  /* [padded] the recursion's gain, and K': see modes.h */
  TbRinging ringing;
  TbPrecision precision; /* of the recursion */
  TbRingingF ringingf;   /* `ringing` in single precision, for TB_IN_FLOAT alone */
  uint32_t groups;
  uint32_t driven;    /* modes of the wires' head that groups push: on the x axis, cosines alone */
  uint8_t *row_group; /* [stride] group of each contact point */
  bool apart;         /* each contact point of a wire is a group of its own number */
  bool folded;        /* groups are their own mirror images under x -> -x */
  TbHighPush push[2]; /* folded: odd orders feel differences, even ones sums; else [0] has all */
  float follow;       /* part of its way to the push that goes in a step what stays of it */
  uint32_t vanishes;  /* steps without a force after which nothing of it is left */
  TbWireHold wire_hold;   /* what wires in contact take from modes */
  uint8_t *hold_band;     /* [padded] band of each mode of the wires' head in that table */
  double radius;          /* of the head [m] */
  uint64_t seed;          /* draws the scattering */
  uint32_t scatter_steps; /* after which every mode's frequency is drawn anew */
  float scatter_by_wires; /* what wires add to `walk`, against view->high.taken */
} TbHighBand;

struct TaborModel;
/* Prepares the modes from the head's own bandwidth up to `top` [Hz]. */
TaborStatus tb_high_band_prepare(TbHighBand *band, TbArena *arena, const struct TaborModel *model,
                                 double top);

/* Zeroed: what of the push stays is not known, and the next push is what stays. */
typedef struct TbWirePush {
  uint32_t known; /* 1: it is */
  uint32_t left;  /* steps without a force until nothing of it is left */
  double share;   /* of out[] and steady[] that is left since there was a force */
} TbWirePush;

/* Effect of the changes of the forces at the wires' contact points, force[stride], on the modes:
 * out[padded], where wires push; steady[padded] is what stays of it. Returns sums over the
 * contacts; s[stride] as in solve.h. sums[stride] is scratch. Audio-safe. */
TbWireContacts tb_high_band_push(const struct TaborModel *model, const double *force,
                                 const double *s, TbWirePush *push, double *sums, float *out,
                                 float *steady);
/* The same, if there were no forces in this step and in the last one: `share` of out[]. */
void tb_high_band_push_nothing(const struct TaborModel *model, TbWirePush *push);

/* Factors 2 J_1(Ka)/(Ka) of a patch of radius `patch_radius` [m]: patch[padded]. */
void tb_high_band_patch(const TbHighBand *band, double patch_radius, double *patch);

/* drive = -g phi at radius [m] and the angle from the axis: the response to a unit
 * force on head `which`. Writes that head's part of drive[padded] alone. `patch` may be NULL.
 * Audio-safe. */
void tb_high_band_drive(const TbHighBand *band, uint32_t which, double radius, double sin_angle,
                        double cos_angle, const double *patch, double *drive);

/* The drive computed from its part that depends on the radius alone, waves[cosines[which]].
 * Audio-safe. */
void tb_high_band_turn(const TbHighBand *band, uint32_t which, const double *waves,
                       double sin_angle, double cos_angle, double *drive);

#endif
