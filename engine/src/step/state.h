/* SPDX-License-Identifier: MIT */
/* The state of one sounding drum: one block without pointers into itself, and a view of its arrays.
 * Everything counts from the model's rest state. Audio-safe. */
#ifndef TB_STATE_H
#define TB_STATE_H

#include "model/model.h"
#include "step/solve.h"

/* Values that may move while the drum rings. */
typedef enum TbLiveIndex {
  TB_LIVE_TENSION,
  TB_LIVE_DAMPING_0,
  TB_LIVE_DAMPING_1,
  TB_LIVE_STRAINER,
  TB_LIVE_REST_OFFSET,
  TB_LIVE_MUFFLE, /* of the batter head; the resonant one's follows */
  TB_LIVE_MUFFLE_RESONANT,
  TB_LIVE_FULL_SCALE,
  TB_LIVE_GRIP, /* of hands that press a stick */
  TB_LIVE_GAIN, /* of the first microphone; the others follow */
  TB_LIVE_COUNT = TB_LIVE_GAIN + TABOR_MAX_MICS
} TbLiveIndex;

typedef struct TbLiveParam {
  double now, target, step; /* step per sample while `left` samples remain */
  uint32_t left;
} TbLiveParam;

typedef enum TbSlotKind { TB_SLOT_FREE, TB_SLOT_STRIKER, TB_SLOT_HAND } TbSlotKind;

/* The slot of the batter head's muffler, a hand that stays; the resonant head's follows. */
#define TB_MUFFLERS ((uint32_t)TABOR_MAX_ACTIVE)

/* Brushes in play at once, the groups of bristles of each (brush.h), and the first one's first slot. */
#define TB_BRUSHES 2u
#define TB_BRISTLE_GROUPS 3u
#define TB_BRISTLES (TB_MUFFLERS + 2u)

/* A striker in flight or contact, or a damping hand. Its height is z, relative to the head's rest
 * height at its place; penetration eta = w + d - z (a hand: eta = w), d by the missing modes. On the hoop w is
 * the hoop's. A stick that touches both has a slot for each: see stick_rigid.h. */
typedef struct TbSlot {
  uint32_t kind, id;
  uint64_t serial;                          /* order of arrival */
  uint64_t age;                             /* samples in play */
  double mass;                              /* [kg] */
  double rest_height;                       /* of the head at its place [m] */
  uint32_t definition;                      /* which striker */
  uint32_t head;                            /* a TaborHead */
  uint32_t held;                            /* a hand presses it: see striker_pool.h */
  uint32_t on_hoop;                         /* not on the head */
  uint32_t partner;                         /* 1 + the slot of the stick's other end, 0: none */
  uint32_t rests;                           /* ... and this one is held onto the head */
  uint32_t palm;                            /* a hand that lifts by itself */
  double cross;                             /* C_12 of both ends [1/kg] */
  double bend[TB_BENDS];                    /* psi m^(-1/2) of the stick's bending here [kg^-1/2] */
  double press, anchor;                     /* F0 [N], z0 [m] */
  uint32_t bristles;                        /* it is a group of a brush's */
  double part;                              /* ... or all of a striker: 1 */
  uint32_t leaving;                         /* samples since the hand began to lift it, or 0 */
  double resistance, push;                  /* of its wires, when held [N s/m], [N] */
  double coat;                              /* height of the coating under it [m] */
  double due;                               /* the brush's way when it slips on [m] */
  double radius, angle, velocity, strength; /* as asked for: a swap rebuilds the slot from them */
} TbSlot;

/* What a hand does with a brush: see brush.h. Lengths of a way are per sample. */
typedef struct TbBrush {
  uint32_t active, id;
  uint32_t definition;  /* which striker */
  uint32_t lifting;     /* the hand is lifting it, for so many samples yet */
  uint64_t seed;        /* of its tracks */
  uint64_t moved;       /* clock at the last move */
  double radius, angle; /* where the hand aims [m], [deg], */
  double along, around; /* ... by how much that moves, */
  uint32_t left;        /* ... for so many samples; 0: forever, `around` alone */
  double x, y, dx, dy;  /* the middle of the fan [m] */
  double slide;         /* of its bristles besides [m] */
  double way, track;    /* of the middle and of the bristles so far [m] */
  double press;         /* F0 that it is going to [N] */
} TbBrush;

/* What a microphone's sums over the modes were, A(n), B(n), B(n-1): see TbMic. */
typedef struct TbEar {
  double ahead, behind, behind_before;
} TbEar;

typedef struct TbState {
  uint64_t fingerprint;
  uint64_t clock;  /* samples stepped since reset */
  uint32_t newest; /* which of the three phases holds the newest samples */
  uint32_t asleep, quiet_checks;
  uint32_t slot_mask; /* slots in play */
  uint32_t lifted;    /* wires hang clear of the head: see wire_clearance.h */
  double gap;         /* ... by this at least [m] */
  uint32_t rings;     /* the hoop moves, or something may strike it */
  uint32_t airborne;  /* nothing touched in the last step: `modal` and `high_force` hold for this */
  uint64_t serial;
  uint32_t delay_at[TABOR_MAX_MICS];
  double treble[TABOR_MAX_MICS][3]; /* last input, last two outputs: see force_equalizer.h */
  uint32_t heard;                   /* microphones whose sums below are those of this instant */
  TbEar ears[TABOR_MAX_MICS];
  TbLiveParam live[TB_LIVE_COUNT];
  TbWireCoefficients wires[TABOR_MAX_WIRES];
  double shift[TABOR_MAX_WIRES]; /* penetration gained since rest by moving the ends [m] */
  TbSlot slots[TB_SLOTS];
  TbContactLaw slot_laws[TB_SLOTS];
  TbBrush brushes[TB_BRUSHES];
  double z[3][TB_SLOTS];
  double missing[3][TB_SLOTS][TB_MISSING];
  double hoop[3][TB_HOOP_MODES];
  double bow[3][TB_SLOTS][TB_BENDS];          /* how sticks bend, by the slots of their tips */
  double hoop_shape[TB_SLOTS][TB_HOOP_MODES]; /* of the slots on it, 0 for others */
  TaborLedger sums;                           /* stored and residual are not kept */
  TaborStatistics statistics;
} TbState;

/* One instant: modal displacements, wires' nodes, penetrations of all rows, heights of strikers, modes of the
 * high band, what stands for the head's missing modes under each striker, modes of the hoop,
 * and how sticks bend. */
typedef struct TbPhase {
  double *q, *v, *eta, *z;
  void *high; /* of the high band's precision */
  double (*missing)[TB_MISSING], *hoop, (*bow)[TB_BENDS];
} TbPhase;

/* The three instants that a step touches: n + 1, n, n - 1. */
typedef struct TbView {
  const TaborModel *model;
  TbState *state;
  TbPhase next, now, last;
  double *bend, *head, *rest_load, *own, *b, *s;
  double *change, *modal; /* contact forces counted from rest, on the grid and on the modes */
  void *high_drive;       /* [TB_SLOTS][high padded], of its precision */
  double *high_scratch;
  float *high_force,
    *modalf[2]; /* [high padded]; [modes padded] where contacts are of single precision */
  double *stretch_pull[2];                  /* [padded]: see stretch.h */
  double stretch_along[2], stretch_rest[2]; /* Y^T (x + q-), and what the forces at rest do to it */
  double *stretch_carry; /* [bed size + TB_SLOTS]: what `product` has of a stretch that is past */
  double *coupling, *slot_coupling, *shape, *drive, *radial;
  double *delay[TABOR_MAX_MICS];
  TbSolve solve;
} TbView;

size_t tb_state_bytes(const TaborModel *model);

TbView tb_view(TbState *state, const TaborModel *model);
/* After `next` was filled: it becomes the newest. */
void tb_view_rotate(TbView *view);

/* Wires that are lifted, or no longer: then double is precise and fast enough. */
static inline void tb_view_lift(TbView *view, bool lifted) {
  view->solve.in.lifted = lifted;
  view->solve.in.precision = lifted ? TB_IN_DOUBLE : view->model->contacts;
}

/* Places of one slot in the per-slot arrays. */
static inline double *tb_slot_shape(const TbView *view, uint32_t slot) {
  return view->shape + (size_t)slot * view->model->modes.padded;
}
static inline double *tb_slot_drive(const TbView *view, uint32_t slot) {
  return view->drive + (size_t)slot * view->model->modes.padded;
}
static inline const TbResidualModes *tb_slot_missing(const TbView *view, uint32_t slot) {
  const TbSlot *s = &view->state->slots[slot];
  const bool on_head = s->kind == TB_SLOT_STRIKER && !s->on_hoop;
  return &view->model->missing[on_head ? s->definition : TABOR_MAX_STRIKERS];
}
static inline double *tb_slot_coupling(const TbView *view, uint32_t slot) {
  return view->coupling + (size_t)slot * view->model->projection.wire_grid.size;
}

#endif
