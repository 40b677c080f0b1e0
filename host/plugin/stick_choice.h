/* SPDX-License-Identifier: MIT */
/**
 * @file stick_choice.h
 * Drum sticks by the names of the trade, for the plugins, with the numbers of docs/presets.md,
 * "Sticks". A stick gives the drum's usual striker a mass, a pitch of bending and, of nylon, a
 * harder tip; what is no stick, as a bass drum's beater, stays as it is.
 *
 * - mass: a fifth of the stick's weight, 0.915 of a cylinder of hickory of 790 kg/m3, since its tip
 *   is thinner;
 * - bending frequency: 400 Hz for 15 mm and 406 mm, in proportion to diameter/length^2 (beam, both
 *   ends free);
 * - tip: contact stiffness K = (4/3) E/(1 - nu^2) sqrt(R) [Hertz], R = 5 mm. Wood across its grain,
 *   0.95 GPa, has 9e7 N/m^1.5, as the presets; nylon, 1.7 GPa, 1.6e8.
 */
#ifndef TABOR_PLUGIN_STICK_CHOICE_H
#define TABOR_PLUGIN_STICK_CHOICE_H

#include <tabor/tabor.h>

/** Words of the choices, of which the first is the drum's own stick. */
#define STICK_CHOICES                                                                              \
  "The drum's own|7A wood|5A wood|5B wood|2B wood|7A nylon|5A nylon|5B nylon|2B nylon"
enum { STICK_CHOICE_COUNT = 9 };

/** SET-UP. Puts stick @p choice, from 0 to STICK_CHOICE_COUNT - 1, into the hands of who plays @p
 * def. */
void stick_choice_take(uint32_t choice, TaborDrumDef *def);

#endif
