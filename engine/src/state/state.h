/* SPDX-License-Identifier: MIT */
/* The state of one sounding drum: one memory block without internal pointers, and a view of its
 * arrays. All displacements count from the model's rest state. A slot is a place in the striker
 * pool. Audio-safe. */
#ifndef TB_STATE_H
#define TB_STATE_H

#include "model/model.h"
#include "state/halve_rate.h"
#include "contact/solve.h"

/* Values that may move while the drum rings. */
typedef enum TbLiveIndex {
  TB_LIVE_TENSION,
  TB_LIVE_DAMPING_0,
  TB_LIVE_DAMPING_1,
  TB_LIVE_STRAINER,
  TB_LIVE_MUFFLE, /* of the batter head; the resonant head's is next */
  TB_LIVE_MUFFLE_RESONANT,
  TB_LIVE_FULL_SCALE,
  TB_LIVE_GRIP, /* of hands that press a stick */
  TB_LIVE_GAIN, /* of the first microphone; the others follow in order */
  TB_LIVE_COUNT = TB_LIVE_GAIN + TABOR_MAX_MICS
} TbLiveIndex;

typedef struct TbLiveParam {
  double now, target, step; /* step per sample while `left` samples remain */
  uint32_t left;
} TbLiveParam;

#define TB_NO_TAP UINT32_MAX

typedef enum TbSlotKind { TB_SLOT_FREE, TB_SLOT_STRIKER, TB_SLOT_HAND } TbSlotKind;

/* The slot of the batter head's muffler, a permanent hand. The resonant head's muffler has the next
 * slot. */
#define TB_MUFFLERS ((uint32_t)TABOR_MAX_ACTIVE)

/* Brushes in play at once, bristle groups of each brush (brush.h), and the first brush's first
 * slot. */
#define TB_BRUSHES 2u
#define TB_BRISTLE_GROUPS 3u
#define TB_BRISTLES (TB_MUFFLERS + 2u)

/* A striker in flight or contact, or a damping hand. Its height is z, relative to the head's rest
 * height at its place. Penetration eta = w + d - z (a hand: eta = w); d is the displacement of the
 * truncated modes. On the hoop, w is the hoop's displacement. A stick that touches both head and hoop
 * has a slot for each: see stick_rigid.h. */
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
  uint32_t partner;                         /* 1 + the slot of the stick's other end; 0: none */
  uint32_t rests;                           /* this end is held onto the head */
  uint32_t palm;                            /* a hand that lifts off by itself */
  uint32_t bends;                           /* 1 + the TbGrip of a stick; 0: it does not bend */
  double cross;                             /* C_12 of both ends [1/kg] */
  double along;                             /* from the stick's tip [m] */
  double bend[TB_BENDS];                    /* phi of the stick's bending there [kg^-1/2] */
  double press, anchor;                     /* F0 [N], z0 [m] */
  uint32_t bristles;                        /* 1: a bristle group of a brush */
  uint32_t sounded;                         /* a striker has touched */
  double force_before;                      /* on the head, a sample ago [N] */
  double part;                              /* fraction of a striker; 1: all of it */
  uint32_t leaving;                         /* samples since its lifting began; 0: not lifting */
  double resistance, push;                  /* of its wires, when held [N s/m], [N] */
  double coat;                              /* height of the coating under it [m] */
  double due;                               /* brush's path length at its next slip [m] */
  double radius, angle, velocity, strength; /* as asked: a swap rebuilds the slot from them */
} TbSlot;

/* Motion of a brush by a hand: see brush.h. Path lengths are per sample. */
typedef struct TbBrush {
  uint32_t active, id;
  uint32_t definition;  /* which striker */
  uint32_t lifting;     /* samples left of the hand's lifting; 0: not lifting */
  uint64_t seed;        /* of its tracks */
  uint64_t moved;       /* clock at the last move */
  double radius, angle; /* target of the hand [m], [deg] */
  double along, around; /* motion of the target per sample [m], [deg] */
  uint32_t left;        /* samples left of it; 0: endless, `around` alone */
  double x, y, dx, dy;  /* the middle of the fan [m] */
  double slide;         /* extra slide of its bristles [m] */
  double way, track;    /* path so far of the middle and of the bristles [m] */
  double press;         /* target of F0 [N] */
} TbBrush;

/* A microphone's sums over the modes: A(n), B(n), B(n-1); see TbMic. */
typedef struct TbEar {
  double ahead, behind, behind_before;
} TbEar;

typedef struct TbState {
  uint64_t fingerprint;
  uint64_t clock;  /* samples stepped since reset */
  uint32_t newest; /* which of the three phases holds the newest samples */
  uint32_t asleep, quiet_checks;
  uint32_t hushed;         /* nobody hears it until it is played or sleeps: see silence.c */
  uint32_t slot_mask;      /* slots in play */
  uint32_t lifted;         /* wires hang clear of the head: see wire_clearance.h */
  double gap;              /* least clearance of lifted wires [m] */
  uint32_t held;           /* wires hold the high band's modes: `high_held` */
  uint32_t hold_steps;     /* samples since `high_held` was renewed */
  TbWireContacts contacts; /* sums over these samples */
  uint32_t unstretched;    /* steps since heads' tensions last rose: see stretch.h */
  uint32_t airborne;   /* nothing touched in the last step; `modal` and `high_force` assume that */
  uint32_t event_debt; /* see event_budget.h */
  double incident;     /* sound from outside at the last frame [Pa] */
  double sound_work;   /* that it has done since the last reset [J] */
  double
    radiated_beyond; /* part of sums.radiated that the modes did not lose to the air (radiated_power.h) [J] */
  uint64_t serial;
  uint32_t delay_at[TABOR_MAX_MICS];
  double treble[TABOR_MAX_MICS][3]; /* last input, last two outputs: see force_equalizer.h */
  double halved[TABOR_MAX_MICS][TB_HALVE_MEMORY]; /* see halve_rate.h */
  TbResponseMemory response[TABOR_MAX_MICS];      /* see mic_response.h */
  uint32_t heard; /* microphones whose `ears` are those of this instant */
  TbEar ears[TABOR_MAX_MICS];
  TbLiveParam live[TB_LIVE_COUNT];
  TbLiveParam output; /* gain of all outputs, which moves even while the drum sleeps */
  TbWireCoefficients wires[TABOR_MAX_WIRES];
  double shift[TABOR_MAX_WIRES]; /* penetration gained since rest by moving the ends [m] */
  TbSlot slots[TB_SLOTS];
  TbContactLaw slot_laws[TB_SLOTS];
  TbBrush brushes[TB_BRUSHES];
  double z[3][TB_SLOTS];
  double truncated[3][TB_SLOTS][TB_TRUNCATED];
  double bow[3][TB_SLOTS][TB_BENDS]; /* bending of sticks; of a pair, the tip has it */
  TaborLedger sums;                  /* stored and residual are not kept */
  TaborStatistics statistics;
} TbState;

/* One instant: modal displacements, wires' nodes, penetrations of all rows (a row is one contact),
 * heights of strikers, modes of the high band, the head's truncated modes under each striker, and
 * bending of sticks. */
typedef struct TbPhase {
  double *q, *v, *eta, *z;
  void *high; /* in the high band's precision */
  double (*truncated)[TB_TRUNCATED], (*bow)[TB_BENDS];
} TbPhase;

/* Sound from outside: pressure [Pa] at this step and at the one before, from the place of a microphone. */
typedef struct TbIncident {
  uint32_t mic;
  bool low; /* the low modes alone hear it */
  double now, before;
} TbIncident;

#define TB_NO_EAR UINT32_MAX

/* The three instants that a step touches: n + 1, n, n - 1. */
typedef struct TbView {
  const TaborModel *model;
  TbState *state;
  TbPhase next, now, last;
  double *bend, *head, *rest_load, *contact_compliance, *b, *s;
  double *change, *modal; /* contact forces counted from rest, on the grid and on the modes */
  void *high_drive;       /* [TB_SLOTS][high padded], in its precision */
  double *high_scratch;
  void *high_held; /* [high padded], in its precision: see high_band_step.h */
  float *high_force,
    *modalf[2]; /* [high padded]; [modes padded] where contacts are of single precision */
  double *stretch_pull[2];                  /* [padded]: see stretch.h */
  double *stretch_mixed[2];                 /* [padded] G q off G's diagonal */
  double stretch_along[2], stretch_rest[2]; /* Y^T (x + q-), and the effect of rest forces on it */
  uint32_t stretch_count;  /* heads that stretch in this step: all that can, or none */
  TbStretching stretching; /* the sums of this sample, if `stretched` */
  bool stretched;
  TbModesEnd end;        /* of the last pass over the modes: see step.c */
  uint32_t ear;          /* the microphone that is heard there, or TB_NO_EAR */
  double *stretch_carry; /* [grid size + TB_SLOTS]: part of `product` due to past stretch */
  double *coupling, *slot_coupling, *shape, *drive, *radial;
  double *delay[TABOR_MAX_MICS];
  TbIncident incident; /* see incident_sound.h */
  uint32_t tap;        /* a microphone whose signal is wanted before its delay, or TB_NO_TAP */
  double tapped;       /* this signal of the newest step [Pa] */
  TbSolve solve;
} TbView;

size_t tb_state_bytes(const TaborModel *model);
/* Bytes of a state before its arrays. */
size_t tb_state_head_bytes(void);

TbView tb_view(TbState *state, const TaborModel *model);
/* Makes `next` the newest instant. Call after `next` was filled. */
void tb_view_rotate(TbView *view);

/* Marks the wires as lifted or not. While they are lifted, contacts are solved in double, which is
 * fast enough. */
static inline void tb_view_lift(TbView *view, bool lifted) {
  view->solve.in.lifted = lifted;
  view->solve.in.precision = lifted ? TB_IN_DOUBLE : view->model->contacts;
}

/* One slot's part of the per-slot arrays. */
static inline double *tb_slot_shape(const TbView *view, uint32_t slot) {
  return view->shape + (size_t)slot * view->model->modes.padded;
}
static inline double *tb_slot_drive(const TbView *view, uint32_t slot) {
  return view->drive + (size_t)slot * view->model->modes.padded;
}
/* The modes that a slot in play can move; its shape is 0 at the others. */
static inline TbModeRanges tb_slot_modes(const TbView *view, uint32_t slot) {
  const TbSlot *s = &view->state->slots[slot];
  return s->on_hoop ? tb_modes_all(&view->model->modes)
                    : tb_modes_of_head(&view->model->modes, s->head);
}
static inline const TbTruncatedModes *tb_slot_truncated(const TbView *view, uint32_t slot) {
  const TbSlot *s = &view->state->slots[slot];
  const bool on_head = s->kind == TB_SLOT_STRIKER && !s->on_hoop;
  return &view->model->truncated[on_head ? s->definition : TABOR_MAX_STRIKERS];
}
static inline double *tb_slot_coupling(const TbView *view, uint32_t slot) {
  return view->coupling + (size_t)slot * view->model->projection.wire_grid.size;
}

#endif
