/* SPDX-License-Identifier: MIT */
#include "plugin/stick_choice.h"

#include "plugin/knobs.h"

static const double NYLON = 1.6e8 / 9e7; /* contact stiffness of its tip by that of wood */

typedef struct Stick {
  double mass;              /* of the tip [kg] */
  double bending_frequency; /* [Hz] */
} Stick;

static const Stick sticks[] = {
  {0.0084, 387}, /* 7A */
  {0.0095, 383}, /* 5A */
  {0.0105, 402}, /* 5B */
  {0.0120, 412}, /* 2B */
};
enum { STICKS = sizeof sticks / sizeof *sticks };

void stick_choice_take(uint32_t choice, TaborDrumDef *def) {
  TaborStrikerDef *const striker = knob_usual_striker(def);
  if (choice == 0 || choice >= STICK_CHOICE_COUNT || striker->kind != TABOR_STRIKER_STICK) return;
  const Stick *const stick = &sticks[(choice - 1) % STICKS];
  striker->mass = stick->mass;
  striker->bending_frequency = stick->bending_frequency;
  if (choice > STICKS) striker->contact_stiffness *= NYLON;
}
