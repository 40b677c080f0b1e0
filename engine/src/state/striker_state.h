/* SPDX-License-Identifier: MIT */
/* The striker pool's part of a drum's state (strikers/striker_pool.h). A slot is a place in the pool. */
#ifndef TB_STRIKER_STATE_H
#define TB_STRIKER_STATE_H

#include "contact/solve.h"
#include "model/model.h"

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
  double resistance, push;                  /* of its wires or shaft, when held [N s/m], [N] */
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

/* Instants: see TbPhase. */
typedef struct TbStrikerState {
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
