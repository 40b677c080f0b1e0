/* SPDX-License-Identifier: MIT */
#include "strokes/humanize.h"

#include <math.h>

#include "base/random.h"

#define PI 3.14159265358979323846

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
    *x = 2 * random_share(&humanizer->state) - 1;
    *y = 2 * random_share(&humanizer->state) - 1;
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
  const double faster = random_share(&humanizer->state), slower = random_share(&humanizer->state);
  event->velocity *= 1 + humanizer->amount * HUMANIZE_SPEED * (faster - slower);
}

void humanize(Humanizer *humanizer, double head_radius, TaborEvent *event) {
  if (humanizer->amount == 0 || event->type != TABOR_EVENT_STRIKE) return;
  if (event->technique == TABOR_TECHNIQUE_PLUCK) return; /* a place on a wire, not on a head */
  if (event->technique != TABOR_TECHNIQUE_PEDAL) scatter_place(humanizer, head_radius, event);
  scatter_speed(humanizer, event);
}
