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

/* The angle from the x axis to (x, y) [deg]: halved four times, by its tangent t, which is 0.2 at
 * most then, so that the series of the arctangent up to t^15 is right to 1e-12. Made of + - * / and
 * sqrt, so every machine has the same bits. */
static double degrees_of(double x, double y) {
  const double length = sqrt(x * x + y * y);
  if (y == 0) return x < 0 ? 180 : 0;
  double t = x > 0 ? y / (length + x) : (length - x) / y, sum = 0;
  for (int half = 0; half < 3; half++) t = t / (1 + sqrt(1 + t * t));
  for (int power = 15; power > 0; power -= 2) sum = 1.0 / power - t * t * sum;
  return 16 * 180 / PI * t * sum;
}

/* Evenly in a disc of radius 1: a place in the square around it, the first of 16 that is inside. */
static void place_in_disc(Humanizer *humanizer, double *x, double *y) {
  for (int trial = 0; trial < 16; trial++) {
    *x = 2 * next_share(humanizer) - 1;
    *y = 2 * next_share(humanizer) - 1;
    if (*x * *x + *y * *y <= 1) return;
  }
  *x = *y = 0;
}

/* In the frame of the stroke: x leads away from the centre. */
static void scatter_place(Humanizer *humanizer, double head_radius, TaborEvent *event) {
  double x, y;
  place_in_disc(humanizer, &x, &y);
  x = event->radius + humanizer->amount * HUMANIZE_PLACE * x;
  y *= humanizer->amount * HUMANIZE_PLACE;
  const double radius = sqrt(x * x + y * y);
  event->radius = radius > head_radius ? fmax(0, 2 * head_radius - radius) : radius;
  event->angle += degrees_of(x, y);
}

static void scatter_speed(Humanizer *humanizer, TaborEvent *event) {
  const double faster = next_share(humanizer), slower = next_share(humanizer);
  event->velocity *= 1 + humanizer->amount * HUMANIZE_SPEED * (faster - slower);
}

void humanize(Humanizer *humanizer, double head_radius, TaborEvent *event) {
  if (humanizer->amount == 0 || event->type != TABOR_EVENT_STRIKE) return;
  if (event->technique == TABOR_TECHNIQUE_PLUCK) return; /* a place on a wire, not on a head */
  if (event->technique != TABOR_TECHNIQUE_PEDAL) scatter_place(humanizer, head_radius, event);
  scatter_speed(humanizer, event);
}
