/* SPDX-License-Identifier: MIT */
/* The striker pool's part of a drum's state (strikers/striker_pool.h). A slot is a place in the
 * pool. */
#ifndef TB_STRIKER_STATE_H
#define TB_STRIKER_STATE_H

#include "contact/solve.h"
#include "model/model.h"

/* Contents of a slot. */
typedef enum TbSlotKind {
  TB_SLOT_FREE,
  TB_SLOT_TIP,      /* a striker that touches in one place, head or hoop */
  TB_SLOT_END,      /* one of the two ends of a stick on head and hoop: see stick.h */
  TB_SLOT_BRISTLES, /* a group of a brush's bristles: see brush.h */
  TB_SLOT_HAND,     /* a damping hand */
  TB_SLOT_PALM,     /* that of a cross-stick, which lifts off by itself */
  TB_SLOT_MUFFLER   /* a hand that stays where the definition puts it */
} TbSlotKind;

/* The slot of the batter head's muffler, a permanent hand. The resonant head's muffler has the next
 * slot. */
#define TB_MUFFLERS ((uint32_t)TABOR_MAX_ACTIVE)

/* Brushes in play at once, bristle groups of each brush (brush.h), and the first brush's first
 * slot. */
#define TB_BRUSHES 2u
#define TB_BRISTLE_GROUPS 3u
#define TB_BRISTLES (TB_MUFFLERS + 2u)

/* A striker in flight or contact, in slots of the first three kinds. */
typedef struct TbStriker {
  double mass;         /* [kg] */
  double part;         /* fraction of a striker; 1: all of it */
  double velocity;     /* of the stroke [m/s] */
  double force_before; /* on the head, a sample ago [N] */
  uint32_t definition; /* which striker */
  uint32_t sounded;    /* it has touched */
} TbStriker;

/* The hand that presses a striker: see striker_hold.h. */
typedef struct TbHold {
  uint32_t held;           /* 0: none presses it */
  uint32_t leaving;        /* samples since its lifting began; 0: not lifting */
  double press, anchor;    /* F0 [N], z0 [m] */
  double resistance, push; /* of bristles or of a pressed shaft [N s/m]; a further force [N] */
} TbHold;

/* The place where a stick touches: see stick.h. */
typedef struct TbStickEnd {
  uint32_t bends;        /* 0: it is stiff, or no stick */
  uint32_t grip;         /* a TbGrip, if it bends */
  uint32_t other;        /* slot of the other end, of TB_SLOT_END */
  uint32_t rests;        /* a tip that lies on the head */
  double along;          /* from the stick's tip [m] */
  double cross;          /* C_12 of both ends [1/kg] */
  double bend[TB_BENDS]; /* phi of the stick's bending there [kg^-1/2] */
} TbStickEnd;

/* A group of bristles on the coating of the head. */
typedef struct TbBristles {
  double coat; /* height of the coating under it [m] */
  double due;  /* brush's path length at its next slip [m] */
} TbBristles;

/* Height is z, relative to the head's rest height at its place. Penetration eta = w + d - z (a
 * hand: eta = w); d is the displacement of the truncated modes. On the hoop, w is the hoop's
 * displacement. */
typedef struct TbSlot {
  uint32_t kind, id;
  uint64_t serial;      /* order of arrival */
  uint64_t age;         /* samples in play */
  uint32_t head;        /* a TaborHead */
  uint32_t on_hoop;     /* not on the head */
  double radius, angle; /* [m], [deg] */
  double rest_height;   /* of head or hoop at its place [m] */
  double resistance;    /* of a damping hand, palm or muffler [N s/m] */
  TbStriker striker;
  TbHold hold;
  TbStickEnd end;
  TbBristles bristles;
} TbSlot;

/* A kind is looked at here, where strikers/ makes a slot, and in step/state_check.c alone. */
static inline bool tb_slot_in_play(const TbSlot *slot) { return slot->kind != TB_SLOT_FREE; }
static inline bool tb_slot_is_tip(const TbSlot *slot) { return slot->kind == TB_SLOT_TIP; }
static inline bool tb_slot_is_end(const TbSlot *slot) { return slot->kind == TB_SLOT_END; }
static inline bool tb_slot_is_bristles(const TbSlot *slot) {
  return slot->kind == TB_SLOT_BRISTLES;
}
static inline bool tb_slot_is_hand(const TbSlot *slot) { return slot->kind == TB_SLOT_HAND; }
static inline bool tb_slot_is_palm(const TbSlot *slot) { return slot->kind == TB_SLOT_PALM; }
static inline bool tb_slot_is_muffler(const TbSlot *slot) { return slot->kind == TB_SLOT_MUFFLER; }
/* A striker, as against what only damps. */
static inline bool tb_slot_strikes(const TbSlot *slot) {
  return tb_slot_is_tip(slot) || tb_slot_is_end(slot) || tb_slot_is_bristles(slot);
}

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

/* A hand that grips the edge of a plate: see step/edge_friction.h. */
typedef struct TbEdgeGrip {
  double strength; /* [N s/m] */
  uint32_t held, id;
} TbEdgeGrip;

/* Instants: see TbPhase. */
typedef struct TbStrikerState {
  TbEdgeGrip edge;
  uint32_t mask;   /* slots in play */
  uint64_t serial; /* of the last arrival */
  TbSlot slots[TB_SLOTS];
  TbContactLaw laws[TB_SLOTS];
  TbBrush brushes[TB_BRUSHES];
  double z[3][TB_SLOTS];
  double truncated[3][TB_SLOTS][TB_TRUNCATED];
  double bow[3][TB_SLOTS][TB_BENDS]; /* bending of sticks; of a pair, the tip has it */
} TbStrikerState;

/* Its arrays, for each slot. */
typedef struct TbStrikerView {
  double *coupling;      /* [TB_SLOTS][grid size] */
  double *slot_coupling; /* [TB_SLOTS][TB_SLOTS] */
  double *shape, *drive; /* [TB_SLOTS][modes padded] */
  double *radial;        /* [rows of the head] scratch */
} TbStrikerView;

#endif
