/* SPDX-License-Identifier: MIT */
/* The state of one sounding drum: one memory block without internal pointers, and a view of its
 * arrays. All displacements count from the model's rest state. A slot is a place in the striker
 * pool. Audio-safe. */
#ifndef TB_STATE_H
#define TB_STATE_H

#include "contact/solve.h"
#include "state/high_band_state.h"
#include "state/ledger_state.h"
#include "state/live_values.h"
#include "state/mic_state.h"
#include "state/plate_state.h"
#include "state/stretch_view.h"
#include "state/striker_state.h"
#include "state/wire_state.h"

/* Each part belongs to the module that its header names. */
typedef struct TbState {
  uint64_t fingerprint;
  uint64_t clock;  /* steps since reset */
  uint32_t newest; /* which of the three phases holds the newest instant */
  uint32_t asleep, quiet_checks;
  uint32_t hushed;      /* nobody hears it until it is played or sleeps: see silence.c */
  uint32_t unstretched; /* steps since heads' tensions last rose: see stretch.h */
  uint32_t stretches;   /* 1 if heads stretched in the last step, and store energy by it */
  uint32_t moving[TB_MODE_PARTS]; /* modes of each part that move: see moving_modes.h */
  uint32_t airborne;   /* nothing touched in the last step; `modal` and `high_force` assume that */
  uint32_t event_debt; /* see event_budget.h */
  double incident;     /* sound from outside at the last frame [Pa] */
  TbLiveValues live;
  TbStrikerState strikers;
  TbPlateState plate;
  TbHihatAirState air;
  TbWireState wires;
  TbHighBandState high;
  TbMicState mics;
  TbLedgerState ledger;
} TbState;

/* One instant: modal displacements, wires' nodes, penetrations of all rows (a row is one contact),
 * heights of strikers, psi of heads/von_karman.h between it and the instant before, modes of the
 * high band, the head's truncated modes under each striker, and bending of sticks. */
typedef struct TbPhase {
  double *q, *v, *eta, *z, *psi;
  void *high; /* in the high band's precision */
  double (*truncated)[TB_TRUNCATED], (*bow)[TB_BENDS];
} TbPhase;

/* Sound from outside: pressure [Pa] at this step and at the one before, from the place of a
 * microphone. */
typedef struct TbIncident {
  uint32_t mic;
  bool low; /* the low modes alone hear it */
  double now, before;
} TbIncident;

/* The three instants that a step touches, n + 1, n, n - 1, and the arrays of all parts. */
typedef struct TbView {
  const TaborModel *model;
  TbState *state;
  TbPhase next, now, last;
  TbParts moving; /* the modes' parts, of which those that rest are left out */
  bool all_move;
  double *bend;      /* [nodes] scratch of the wires' step */
  double *head;      /* [rows] the head's displacement under the wires' points [m] */
  double *rest_load; /* [rows] part of b that the load at rest causes [m] */
  double *contact_compliance, *b, *s; /* [rows] see solve.h */
  double *change, *modal;      /* contact forces counted from rest, on the grid and on the modes */
  float *modalf[TB_COUPLINGS]; /* [modes padded] where contacts are of single precision */
  TbModesEnd end;              /* of the last pass over the modes: see step.c */
  TbIncident incident;         /* see incident_sound.h */
  TbStrikerView strikers;
  TbStretchView stretch;
  TbHighBandView high;
  TbMicView mics;
  TbSolve solve;
} TbView;

size_t tb_state_bytes(const TaborModel *model);
/* Bytes of a state before its arrays. */
size_t tb_state_head_bytes(void);

TbView tb_view(TbState *state, const TaborModel *model);
/* Makes `next` the newest instant. Call after `next` was filled. */
void tb_view_rotate(TbView *view);
/* Call after state->moving has changed. */
void tb_view_move(TbView *view);

/* Marks the wires as lifted or not. While they are lifted, contacts are solved in double, which is
 * fast enough. */
static inline void tb_view_lift(TbView *view, bool lifted) {
  view->solve.in.lifted = lifted;
  view->solve.in.precision = lifted ? TB_IN_DOUBLE : view->model->contacts;
}

/* How far the foot of a hi-hat's rod is above its place at rest [m]. */
static inline double tb_pedal_risen(const TbView *view) {
  return view->state->live.values[TB_LIVE_OPENING].now - view->model->def.hihat.opening;
}

/* Displacement of a mode at which the edges of a hi-hat and its pedal hold it, by the forces of the
 * last step; 0 of other bodies. */
static inline double tb_mode_held(const TbView *view, uint32_t mode) {
  const TaborModel *model = view->model;
  if (!model->wires.rims || mode >= model->modes.group[model->modes.groups]) return 0.0;
  const double edges = view->state->wires.lifted ? 0.0 : model->wires.side * view->modal[mode];
  const double force = model->rod.along[mode] * tb_pedal_risen(view) - edges;
  return model->modes.stiffness[mode] > 0.0 ? force / model->modes.stiffness[mode] : 0.0;
}

/* Energy of a mode's motion between the last two instants, about where it is held [J]. */
static inline double tb_mode_energy(const TbView *view, uint32_t mode) {
  const TaborModel *model = view->model;
  const double held = tb_mode_held(view, mode);
  return 0.5 * tb_pole_energy(model->step_rate, model->modes.stiffness[mode],
                              view->now.q[mode] - held, view->last.q[mode] - held);
}

/* Multiplies a mode's motion about where it is held. */
static inline void tb_mode_scale(const TbView *view, uint32_t mode, double factor) {
  const double held = tb_mode_held(view, mode);
  view->now.q[mode] = held + (view->now.q[mode] - held) * factor;
  view->last.q[mode] = held + (view->last.q[mode] - held) * factor;
}

static inline TbSlot *tb_slot(const TbView *view, uint32_t slot) {
  return &view->state->strikers.slots[slot];
}
/* The other end of a stick on head and hoop; otherwise the slot itself. */
static inline uint32_t tb_slot_other_end(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  return tb_slot_is_end(s) ? s->end.other : slot;
}
/* True if a striker or a hand is in play; mufflers, which stay, do not count. */
static inline bool tb_slots_play(const TbView *view) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    const TbSlot *s = tb_slot(view, i);
    if (tb_slot_in_play(s) && !tb_slot_is_muffler(s)) return true;
  }
  return false;
}
/* One slot's part of the per-slot arrays. */
static inline double *tb_slot_shape(const TbView *view, uint32_t slot) {
  return view->strikers.shape + (size_t)slot * view->model->modes.padded;
}
static inline double *tb_slot_drive(const TbView *view, uint32_t slot) {
  return view->strikers.drive + (size_t)slot * view->model->modes.padded;
}
/* The modes that a slot in play can move; its shape is 0 at the others. */
static inline TbModeRanges tb_slot_modes(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  return s->on_hoop ? tb_modes_all(&view->model->modes)
                    : tb_modes_of_head(&view->model->modes, s->head);
}
static inline const TbTruncatedModes *tb_slot_truncated(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  const bool on_head = tb_slot_strikes(s) && !s->on_hoop;
  return &view->model->truncated[on_head ? s->striker.definition : TABOR_MAX_STRIKERS];
}
static inline double *tb_slot_coupling(const TbView *view, uint32_t slot) {
  return view->strikers.coupling + (size_t)slot * view->model->projection.wire_grid.size;
}

#endif
