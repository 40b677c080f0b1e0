/* SPDX-License-Identifier: MIT */
#include "window/window_size.h"

#include <math.h>

#include "window/painting.h"

static const double LEAST_SCALE = 0.5, MOST_SCALE = 4;

void window_size(double scale, uint32_t *width, uint32_t *height) {
  const double kept = fmin(fmax(scale, LEAST_SCALE), MOST_SCALE);
  *width = (uint32_t)lround(kept * WINDOW_WIDTH);
  *height = (uint32_t)lround(kept * WINDOW_HEIGHT);
}

void window_fit(uint32_t *width, uint32_t *height) {
  window_size(fmin((double)*width / WINDOW_WIDTH, (double)*height / WINDOW_HEIGHT), width, height);
}
