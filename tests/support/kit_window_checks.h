/* SPDX-License-Identifier: MIT */
/**
 * @file kit_window_checks.h
 * What the tests of the window of Tabor Kit share: where things are in it at scale 1.
 */
#ifndef TABOR_TESTS_KIT_WINDOW_CHECKS_H
#define TABOR_TESTS_KIT_WINDOW_CHECKS_H

#include "tabor/kit.h"

enum {
  KIT_UNDO_X = 498,
  KIT_COMPARE_X = 450,
  KIT_BUTTON_Y = 410,
  KIT_BEFORE_X = 434,
  KIT_NEXT_X = 682,
  KIT_NEXT_Y = 34
};
enum { KIT_WAY_X = 420, KIT_WAY = 276, KIT_FIRST_ROW = 92, KIT_ROW = 40 }; /* of controls */
enum { KIT_PAGE_X = 592 };

/** The number of a drum; asserts that there is one of this name. */
uint32_t kit_drum_named(const TaborKitDef *kit, const char *name);
/** Where a point of the floor [m] is seen [px]. */
void kit_pixel_of(const TaborKitDef *kit, double x, double y, int *across, int *down);

#endif
