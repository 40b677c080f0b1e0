/* SPDX-License-Identifier: MIT */
/* Which modes of the enclosed air the high band radiates and offers for its choice (high_band.h): a
 * few dozen in each sixth of an octave, where a floor tom has thousands. Fewer than twice
 * TB_AIR_MET, evenly spread, are looked at. The more the batter head has of a mode, the more likely
 * that is kept:
 *   p = min(1, b/(n <b>)), b = in_head, <b> its mean over the order, n the modes for each one that
 *   is kept,
 * and stands for 1/p modes. The energy that strokes bring to a microphone grows with b, so that few
 * of those kept stand out. They are drawn by summing p, not by chance. Set-up only. */
#ifndef TB_HIGH_AIR_CHOICE_H
#define TB_HIGH_AIR_CHOICE_H

#include "high_band/high_band_choice.h"
#include "high_band/high_cavity.h"

#define TB_AIR_MET 1024u
#define TB_AIR_KEPT 48u

/* For all orders, and how far they are. */
typedef struct TbHighAirPlan {
  double from, to;               /* [rad/s] */
  uint32_t met_every[TB_SIXTHS]; /* of so many modes one is looked at */
  double kept_every[TB_SIXTHS];  /* of so many of these one is kept */
  uint32_t met[TB_SIXTHS];       /* modes so far */
  double due[TB_SIXTHS];         /* sum of p, less those kept */
} TbHighAirPlan;

typedef struct TbAirChoice {
  uint32_t radial, axial, sixth;
  double in_head; /* of the batter head */
  double count;   /* of the modes that it stands for */
} TbAirChoice;

typedef struct TbAirChoices {
  TbAirChoice *choices;
  uint32_t count;
} TbAirChoices;

/* Plans for the modes between two frequencies [rad/s]. */
void tb_high_air_plan(TbHighAirPlan *plan, const TaborDrumDef *def, double from, double to);

/* Chooses from the modes of one order, and lets those that it looks at take their part of the
 * heads' functions. `mode` is scratch. Returns false if memory ran out. */
bool tb_air_choose(TbHighAirPlan *plan, TbArena *arena, TbHighCavity *cavity, TbAirMode *mode,
                   TbAirChoices *chosen);

#endif
