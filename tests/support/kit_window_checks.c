/* SPDX-License-Identifier: MIT */
#include "kit_window_checks.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { FLOOR_X = 20, FLOOR_Y = 20, FLOOR_SIZE = 370 };

uint32_t kit_drum_named(const TaborKitDef *kit, const char *name) {
  uint32_t found = 0;
  while (found < kit->drum_count && strcmp(kit->drum[found].name, name) != 0) found++;
  assert_true(found < kit->drum_count);
  return found;
}

/* All drums fill the square. A drum on its side reaches as far as it is deep. */
void kit_pixel_of(const TaborKitDef *kit, double x, double y, int *across, int *down) {
  double least[2] = {9, 9}, most[2] = {-9, -9};
  for (uint32_t i = 0; i < kit->drum_count; i++) {
    const TaborKitDrumDef *const drum = &kit->drum[i];
    const TaborShellDef *const shell = &drum->def.shell;
    const double reach = drum->tilt > 45 ? fmax(shell->radius, shell->depth) : shell->radius;
    least[0] = fmin(least[0], drum->x - reach);
    most[0] = fmax(most[0], drum->x + reach);
    least[1] = fmin(least[1], drum->y - reach);
    most[1] = fmax(most[1], drum->y + reach);
  }
  const double scale = FLOOR_SIZE / fmax(most[0] - least[0], most[1] - least[1]);
  *across = (int)lround(FLOOR_X + FLOOR_SIZE / 2 + scale * (x - 0.5 * (least[0] + most[0])));
  *down = (int)lround(FLOOR_Y + FLOOR_SIZE / 2 - scale * (y - 0.5 * (least[1] + most[1])));
}
