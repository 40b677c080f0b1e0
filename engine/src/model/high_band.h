/* SPDX-License-Identifier: MIT */
/* The high band: modes above the two-way bandwidth, driven by the actual contact forces and heard, but
 * not fed back to the contacts, which hardly feel them.
 *
 * Up there the modes are too many to keep, and most are silent: they are slower than sound and radiate
 * from the edge alone. So each Bessel function of either head counts as a mode of its own (what lies
 * between the heads does not couple them any more), with the air's mass
 * 2 rho0/(K sqrt(1 - (k0/K)^2)) per area, K = z/R (a plane wave slower than sound on both sides), and its
 * baffled radiation (of its outer side, on a drum with a cavity), times one factor per microphone and one
 * for the resistance, of each head. These stand for the
 * edge and for the coupling of modes by the air, which depend on the place and hardly on the frequency
 * (an open edge: 5.4, 6.5 and 7.7 dB less than a baffled one at three places, within 0.5 dB from z = 20
 * to 108, tests/engine/test_high_band.c), so they are measured on the upper two-way modes. Per sixth of an
 * octave the modes are sorted by the energy that they can bring to a microphone,
 * (gain sin(wk)/(wk))^2/(4 s), and kept until 99.9 % of it is there, head by head, or less of every band
 * where those were more than TB_HIGH_MOST (TB_HIGH_MOST_LIVE at live); they carry the energy of those left out. With 384
 * at live levels of third octaves were as good, but toms rang in single tones from 2 to 10 kHz: geometric over arithmetic
 * mean -13 dB, recorded -3 to -10, with 1,024 -4 to -8. They cost a snare drum 4 % and a tom 12 %.
 *
 * Strikers drive through their patches; the wires' points are gathered in groups along the bed, each
 * group pushing at its middle. Forces along a wire cancel at the head's own wavelength but for the little that
 * is left where they are evenly spaced: a group is a point of every wire, or as many neighbours as it takes
 * to have at most TB_HIGH_GROUPS. (Sixteen uneven groups on a snare drum's 23 points: 3 to 5 dB too loud at 6
 * and 8 kHz.)
 *
 * Wires that touch also hold the head: by their contacts' loss, f lambda v, lambda [s/m] of a force f, a mode's
 * amplitude decays by Sum lambda f phi^2/2 more, 100 to 200 1/s on a snare drum whose modes lose 75 to 200
 * by themselves. A two-way mode feels this through the solve; here phi^2 counts by its mean over the bed. Without
 * it all is 4 to 9 dB too loud.
 *
 * Limits: where wires are pressed firmly the band is too soft, not being felt by them (marching-14x12 at live lacks
 * 16 to 22 dB at 5 to 10 kHz once the stroke is over). And at live wires' points are 12.5 mm apart on a snare drum, as
 * long as the head's waves at 12 kHz, which they push 4 to 5 dB too much.
 *
 * At draft and live the band is moved in single precision: rounding brings a mode some 1e-6 of itself, and no
 * energy hangs on it. */
#ifndef TB_HIGH_BAND_H
#define TB_HIGH_BAND_H

#include "kernels/precision.h"
#include "model/modes.h"

#define TB_HIGH_GROUPS 64u
#define TB_HIGH_MOST 2048u
#define TB_HIGH_MOST_LIVE 1024u

#define TB_TEMPLATE "model/high_band_tmpl.h"
#include "kernels/both.h"

/* What groups do to neighbouring modes of their head. */
typedef struct TbHighPush {
  uint32_t from, size; /* the modes */
  uint32_t rows;
  float *table; /* [rows][size]: -side g phi at the groups' middles */
} TbHighPush;

typedef struct TbHighBand {
  uint32_t count, padded; /* modes kept, sine copies counted; 0: no high band */
  uint32_t begin[3];      /* where each head's modes begin, padded: */
  uint32_t odd[2];        /* so many cosine copies of odd order, padded, among */
  uint32_t cosines[2];    /* ... so many of all orders, those of order 0 last, padded, */
  uint32_t sines[2];      /* ... then so many sine copies in the same order */
  uint32_t candidates;    /* Bessel functions that there were to choose from */
  uint32_t orders;        /* all angular orders are below */
  uint32_t *order;        /* [padded] angular order m */
  double *zero, *scale;   /* [padded] z, and the shape's factor for unit modal mass */
  double *g, *stiffness;  /* [padded] the recursion's gain, and K': see modes.h */
  TbRinging ringing;
  TbPrecision precision; /* what it is moved in: */
  TbRingingF ringingf;   /* ... the same in single precision, for TB_IN_FLOAT alone */
  uint32_t groups;
  uint32_t driven;    /* modes of the wires' head that groups push: on the x axis, cosines alone */
  uint8_t *row_group; /* [stride] group of each contact point, */
  bool apart;         /* ... each the group of its own number */
  bool folded; /* groups are their own mirror images under x -> -x: odd orders feel differences */
  TbHighPush push[2]; /* ... and even ones sums; else the first is all */
  float *rest;        /* [padded] what wires do at rest */
  double *row_loss;   /* [stride] lambda of each contact point [s/m], 0 where there is none */
  double radius;      /* of the head [m] */
} TbHighBand;

struct TaborModel;
/* Modes from the head's own up to `top` [Hz]. */
TaborStatus tb_high_band_prepare(TbHighBand *band, TbArena *arena, const struct TaborModel *model,
                                 double top);

/* What the wires do at rest, which the band does not count. */
TaborStatus tb_high_band_rest(struct TaborModel *model, TbArena *scratch);

/* What forces of the wires' contact points, force[stride], do to the modes beyond those at rest, for which it is 0
 * to the bit: out[padded], where wires push; returns Sum lambda f. sums[stride] is scratch. Audio-safe. */
double tb_high_band_push(const struct TaborModel *model, const double *force, double *sums,
                         float *out);

/* Factors 2 J_1(Ka)/(Ka) of a patch of radius `patch_radius` [m]: patch[padded]. */
void tb_high_band_patch(const TbHighBand *band, double patch_radius, double *patch);

/* drive = -g phi at radius [m] and the angle from the wires' direction: what a unit force on head `which`
 * does, in that head's part of drive[padded] alone. `patch` may be NULL. Audio-safe. */
void tb_high_band_drive(const TbHighBand *band, uint32_t which, double radius, double sin_angle,
                        double cos_angle, const double *patch, double *drive);

/* What of this belongs to a radius alone, waves[cosines[which]], and the drive from it. Audio-safe. */
void tb_high_band_waves(const TbHighBand *band, uint32_t which, double radius, const double *patch,
                        double *waves);
void tb_high_band_turn(const TbHighBand *band, uint32_t which, const double *waves,
                       double sin_angle, double cos_angle, double *drive);

#endif
