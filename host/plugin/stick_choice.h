/* SPDX-License-Identifier: MIT */
/**
 * @file stick_choice.h
 * Drum sticks by the names of the trade, for the plugins. A stick gives the drum's usual striker a mass, a pitch of bending and
 * a harder tip; what is no stick, as a bass drum's beater, stays as it is.
 *
 * Diameter and length are those that makers list. The others are computed as those of the presets' stick:
 * - mass of the tip: a fifth of the stick's, 0.92 of a cylinder of hickory of 820 kg/m3: it turns about a third from its butt;
 * - bending frequency: 400 Hz for 15 mm and 406 mm, in proportion to diameter/length^2 (beam, both ends free);
 * - tip: contact stiffness K = (4/3) E' sqrt(R) [Hertz]. Wood across its grain has E' = 0.95 GPa and R = 5 mm in the presets. Nylon
 *   (dry nylon 66, E = 2.8 GPa, nu = 0.39) has E' = 3.3 GPa, on a round tip of R = 4 mm: K is 3.1 times as large.
 *
 * | name | diameter, length [mm] |
 * |------|-----------------------|
 * | 7A   | 13.7, 394             |
 * | 5A   | 14.4, 406             |
 * | 5B   | 15.1, 406             |
 * | 2B   | 16.0, 413             |
 */
#ifndef TABOR_PLUGIN_STICK_CHOICE_H
#define TABOR_PLUGIN_STICK_CHOICE_H

#include <tabor/tabor.h>

/** Words of the choices, of which the first is the drum's own stick. */
#define STICK_CHOICES                                                                              \
  "The drum's own|7A wood|5A wood|5B wood|2B wood|7A nylon|5A nylon|5B nylon|2B nylon"
enum { STICK_CHOICE_COUNT = 9 };

/** SET-UP. Puts stick @p choice, from 0 to STICK_CHOICE_COUNT - 1, into the hands of who plays @p def. */
void stick_choice_take(uint32_t choice, TaborDrumDef *def);

#endif
