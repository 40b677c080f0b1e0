/* SPDX-License-Identifier: MIT */
/* All data computed once from a definition and a sample rate; immutable afterwards. A model steps
 * once per frame of its output, or twice; "sample" means a step.
 *
 * All state counts from the static equilibrium (rest) under strainer, gravity and contact. A drum
 * at rest is therefore exactly zero, and stays so. */
#ifndef TB_MODEL_H
#define TB_MODEL_H

#include <stdatomic.h>

#include "kernels/kernels.h"
#include "kernels/precision.h"
#include "model/brush_shapes.h"
#include "model/cascade.h"
#include "model/compliance.h"
#include "model/contact_rows.h"
#include "model/high_band.h"
#include "model/mic_response.h"
#include "model/plate_coupling.h"
#include "model/projection.h"
#include "model/radiated_power.h"
#include "model/rims.h"
#include "model/state_arrays.h"
#include "model/stick_bending.h"
#include "model/stretch_mixing.h"
#include "model/truncated_modes.h"

/* Patch over which a damping hand spreads its force [m]. */
#define TB_HAND_RADIUS 0.018
/* The same of a palm, 8 by 10 cm [m]. */
#define TB_PALM_RADIUS 0.0505
/* Contact curvature times compliance: the stiffest contact that one sample resolves. */
#define TB_SLOPE_LIMIT 10.0

/* The signal of a microphone is A(n+1) - A(n) - B(n) + B(n-1) [Pa], A(n) = Sum ahead q^n,
 * B(n) = Sum behind q^n, `delay` steps later: see mics.h. */
typedef struct TbMic {
  double *ahead, *behind; /* [padded] */
  /* [padded]: forces on the modes by sound from its place [N kg^-1/2/Pa]: see air/incident_sound.h
   */
  double *push_now, *push_before;
  uint32_t travel, delay; /* of sound to it, without and with what the output takes [steps] */
  TbMicResponse response;
} TbMic;

typedef struct TbRest {
  double *q;      /* [padded] modal displacement at rest [m kg^1/2] */
  double *v;      /* [node_count] wires [m] */
  double *bend;   /* [node_count] their second differences [m] */
  double *eta;    /* [stride] penetration [m] */
  double *force;  /* [rows] contact force [N]; zero for the striker pool */
  double *grid;   /* [grid size] `force` on the grid under the wires */
  double *offset; /* [wires] of the ends [m] */
  double head;    /* height of the centre of the wires' head [m] */
} TbRest;

/* Data of the heads' stretching, see stretch.h. */
typedef struct TbStretch {
  uint32_t count;              /* heads that stretch */
  uint32_t head[TB_COUPLINGS]; /* which */
  TbParts parts;               /* the modes that stretch, of each group first (modes.h) */
  TbParts felt[TB_HEADS];      /* the parts among tb_modes_of_head() of each head */
  double *gain[TB_COUPLINGS];  /* [padded] G, diagonal, of each head [1/kg] */
  double factor[TB_COUPLINGS]; /* S/2A [N/m3] */
  double least[TB_COUPLINGS];  /* rise of tension that counts [N/m] */
  uint32_t hold; /* steps without such a rise after which heads are linear; UINT32_MAX: never */
  TbMixing mixing;
} TbStretch;

/* Uneven lugs couple at most this many modes, copies and padding counted. */
#define TB_LUG_MODES 128u

/* Data of uneven lugs, see lug_forces.h. */
typedef struct TbLugs {
  uint32_t count;      /* coupled modes, with padding; 0 if all lugs are alike */
  uint32_t from[5];    /* start of the coupled modes in each group (modes.h) */
  uint32_t size[5];    /* number of coupled modes in each group, a multiple of 8 */
  float *pull;         /* [count/8][count][8] dK */
  uint32_t row_count;  /* modes of the uneven heads; copies are separate if coupled */
  TaborModeInfo *rows; /* those modes, sorted by frequency */
} TbLugs;

/* See resting.h. */
typedef struct TbResting {
  uint32_t floor[TB_MODE_PARTS]; /* so many modes of each part (TbStretch.parts) never rest */
  double *most; /* [padded/8]: each mode of a block of eight rests below this energy [J] */
  double *heard,
    *heard_high; /* [padded], of the high band [high.padded]: see resting.h [1/(m2 kg)] */
  bool sounds;   /* some microphone hears some mode */
} TbResting;

/* Offsets of the arrays of a drum's state, in bytes from the first array. */
typedef struct TbLayout {
#define OFFSETS(name, kind, most, copies, count) size_t name[most];
#define OFFSETS_VIEWED(name, kind, most, copies, count, field) size_t name[most];
  TB_OTHER_ARRAYS(OFFSETS)
  TB_VIEWED_ARRAYS(OFFSETS_VIEWED)
#undef OFFSETS
#undef OFFSETS_VIEWED
  size_t total;
} TbLayout;

struct TaborModel {
  atomic_uint references;
  TbArena arena;
  TaborDrumDef def;
  uint32_t quality;
  uint32_t steps;     /* per frame of the output */
  double sample_rate; /* of the output [Hz] */
  double step_rate;   /* 1/k [Hz] */
  double time_step;   /* k [s] */
  double top;         /* of the high band [Hz] */
  double axis; /* [deg] from which the modes' angles count: that of the wires; of a drum without, of
                  its own stroke */
  TbPrecision precision; /* of the high band */
  TbPrecision contacts;  /* of contacts, if the kernels have their laws */
  uint32_t newton_cap, inner_cap;
  double tolerance, inner_tolerance; /* of the contact solve: see solve.h */
  double grid_tolerance;             /* see projection.h */
  double *reach;                     /* [modes padded] see wire_clearance.h */
  const TbKernels *kernels;          /* for this processor, in double */
  const TbKernelsF *kernelsf;        /* for this processor, in single precision */
  TbBody body;
  TbWires wires;
  TbRows rows;
  TbModes modes;
  TbMic mics[TABOR_MAX_MICS];
  TbRadiatedPower power;
  TbHighBand high;
  TbStick stick[TABOR_MAX_STRIKERS];
  double *high_patches[TABOR_MAX_STRIKERS]; /* [high.padded] of each striker */
  TbBrushShapes places[TABOR_MAX_STRIKERS]; /* of each brush */
  TbRest rest;
  TbResting resting;
  TbProjection projection;
  TbCompliance compliance; /* of the head over one step */
  /* [rows]: the head's compliance at a point, to a force there [m/N] */
  float *yield;
  TbWireGridF wire_gridf;    /* for contacts in single precision */
  TbComplianceF compliancef; /* for contacts in single precision */
  TbStretch stretch;
  TbPlateCoupling plate;
  TbCascade cascade;
  TbModeForce rod;
  TbHihatAir hihat_air;
  TbLugs lugs;
  double *patches[TABOR_MAX_STRIKERS + 1]; /* of each striker, then of a hand */
  double *palm_patch;
  TbTruncatedModes truncated[TABOR_MAX_STRIKERS + 1]; /* likewise; zero for a hand */
  double *center; /* [padded]: shape at the centre of the wires' head */
  TbLayout layout;
  uint64_t fingerprint; /* hash of all that a saved state depends on */
};

/* ---- set-up that building and loading share ---- */

/* Checks options, and puts them or the defaults into `chosen`, with an allocator; the quality may
 * be the default. */
TaborStatus tb_model_resolve_options(const TaborModelOptions *options, TaborModelOptions *chosen,
                                     TaborError *error);
/* A model of zeros with one reference and an arena; NULL and an error if memory is short. */
TaborModel *tb_model_allocate(const TaborModelOptions *options, TaborError *error);
TaborStatus tb_model_memory_error(TaborError *error);
/* The kernels for this processor, of TaborInstructions at most. */
void tb_model_choose_kernels(TaborModel *model, uint32_t instructions);
/* Hash of all that a saved state depends on. */
uint64_t tb_model_fingerprint(const TaborModel *model);

/* Computes the static equilibrium, into model->rest (equilibrium.c). */
TaborStatus tb_rest_prepare(TaborModel *model, TbArena *scratch);

/* Computes shape[padded], the shape of every mode on a TaborHead at radius [m] and angle [deg,
 * absolute]. `patch` as in tb_body_radial(); radial is scratch of head.row_count. Audio-safe. */
void tb_model_shape(const TaborModel *model, uint32_t which, double radius, double angle,
                    const double *patch, double *radial, double *shape);

/* Computes shape[padded], the motion of the batter's hoop at an angle, likewise. Audio-safe. */
void tb_model_hoop_shape(const TaborModel *model, double angle, double *radial, double *shape);

/* The high band's response to a unit force of a striker at this place: drive[high.padded].
 * Audio-safe. */
void tb_model_high_drive(const TaborModel *model, uint32_t striker, double radius, double angle,
                         double *drive);

#endif
