/* SPDX-License-Identifier: MIT */
#include "strokes/humanize.h"

#include <math.h>

#define PI 3.14159265358979323846

/* SplitMix64 (Steele, Lea, Flood 2014): every seed is a good one, also 0 and its neighbours. */
static uint64_t next_bits(Humanizer *humanizer) {
  humanizer->state += 0x9E3779B97F4A7C15u;
  uint64_t z = humanizer->state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/* Evenly in [0, 1). */
static double next_share(Humanizer *humanizer) {
  return (double)(next_bits(humanizer) >> 11) * 0x1p-53;
}

Humanizer humanizer(double amount, uint32_t seed) {
  return (Humanizer){.amount = amount, .state = seed};
}

/* In the frame of the stroke: x leads away from the centre. */
static void scatter_place(Humanizer *humanizer, double head_radius, TaborEvent *event) {
  /* the square root makes it even over the disc: without it the middle would be denser */
  const double move = humanizer->amount * HUMANIZE_PLACE * sqrt(next_share(humanizer));
  const double direction = 2 * PI * next_share(humanizer);
  const double x = event->radius + move * cos(direction), y = move * sin(direction);
  const double radius = hypot(x, y);
  event->radius = radius > head_radius ? fmax(0, 2 * head_radius - radius) : radius;
  event->angle += atan2(y, x) * 180 / PI;
}

static void scatter_speed(Humanizer *humanizer, TaborEvent *event) {
  const double faster = next_share(humanizer), slower = next_share(humanizer);
  event->velocity *= 1 + humanizer->amount * HUMANIZE_SPEED * (faster - slower);
}

void humanize(Humanizer *humanizer, double head_radius, TaborEvent *event) {
  if (humanizer->amount == 0 || event->type != TABOR_EVENT_STRIKE) return;
  if (event->technique == TABOR_TECHNIQUE_PLUCK) return; /* a place on a wire, not on a head */
  scatter_place(humanizer, head_radius, event);
  scatter_speed(humanizer, event);
}
