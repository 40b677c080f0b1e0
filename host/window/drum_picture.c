/* SPDX-License-Identifier: MIT */
#include "window/drum_picture.h"

#include <math.h>
#include <stdio.h>

static const double PI = 3.14159265358979323846;

/* ---- places, at scale 1 --------------------------------------------------------------------- */

static const double MIDDLE[2] = {205, 215}, RADIUS = 175, HOOP = 10;
static const double MIC = 9; /* radius of a microphone */
static const double AROUND =
  0.15; /* of the head's radius, in which all lies that is outside of it */
static const double MOST_MIC = 10; /* [m] from the axis */
static const double DEPTH = 5e-4;  /* [m] of a head that is as bright or dark as can be */

/* ---- microphones ---------------------------------------------------------------------------- */

/* Parts of the head's radius as they are seen: beyond the head, 1 to infinity is 1 to 1 + AROUND.
 */
static double seen(double part) { return part <= 1 ? part : 1 + AROUND * (1 - 1 / part); }

static double unseen(double part) {
  return part <= 1 ? part : 1 / fmax(1 - (part - 1) / AROUND, 1e-3);
}

static void mic_place(const WindowScene *scene, const WindowMic *mic, double *x, double *y) {
  const double away = RADIUS * seen(mic->radius / scene->radius), angle = mic->angle * PI / 180;
  *x = MIDDLE[0] + away * cos(angle);
  *y = MIDDLE[1] - away * sin(angle);
}

static bool find_mic(const WindowScene *scene, double x, double y, uint32_t *found) {
  double nearest = MIC;
  for (uint32_t i = 0; i < scene->mic_count; i++) {
    double at, down;
    mic_place(scene, &scene->mics[i], &at, &down);
    const double away = hypot(x - at, y - down);
    if (away >= nearest) continue;
    nearest = away;
    *found = i;
  }
  return nearest < MIC;
}

void drum_picture_find(const WindowScene *scene, double x, double y, WindowPlace *place) {
  const double at = (x - MIDDLE[0]) / RADIUS, up = (MIDDLE[1] - y) / RADIUS;
  place->number = 0;
  place->radius = hypot(at, up);
  place->angle = atan2(up, at) * 180 / PI;
  if (place->radius <= 1) place->part = WINDOW_DRUM;
  if (find_mic(scene, x, y, &place->number)) place->part = WINDOW_MIC;
}

void drum_picture_move_mic(const WindowScene *scene, double x, double y, WindowMic *mic) {
  const double at = (x - MIDDLE[0]) / RADIUS, up = (MIDDLE[1] - y) / RADIUS;
  mic->radius = fmin(unseen(hypot(at, up)) * scene->radius, MOST_MIC);
  mic->angle = atan2(up, at) * 180 / PI;
}

void drum_picture_say_mic(const WindowMic *mic, char *text, size_t size) {
  (void)snprintf(text, size, "%s: %.0f mm out, %.0f deg, %.0f mm %s; the wheel lifts it", mic->name,
                 1e3 * mic->radius, mic->angle, 1e3 * fabs(mic->height),
                 mic->height > 0 ? "up" : "down");
}

/* ---- the drum ------------------------------------------------------------------------------- */

static void circle(cairo_t *cairo, double radius) {
  cairo_new_path(cairo);
  cairo_arc(cairo, MIDDLE[0], MIDDLE[1], radius, 0, 2 * PI);
}

/* Cells of the grid between two circles and two angles, as bright as the head is high there. */
static void draw_head(cairo_t *cairo, const TaborView *view) {
  const double ring = RADIUS / (view->radii - 1u), step = 2 * PI / view->angles;
  for (uint32_t i = 0; i + 1 < view->radii; i++) {
    for (uint32_t j = 0; j < view->angles; j++) {
      const double height = view->displacement[0][i * view->angles + j];
      const double light = 0.74 + 0.22 * tanh(height / DEPTH);
      cairo_set_source_rgb(cairo, light, 0.98 * light, 0.93 * light);
      cairo_new_path(cairo);
      cairo_arc_negative(cairo, MIDDLE[0], MIDDLE[1], (i + 1) * ring, -(j - 0.5) * step,
                         -(j + 0.5) * step);
      cairo_arc(cairo, MIDDLE[0], MIDDLE[1], i * ring, -(j + 0.5) * step, -(j - 0.5) * step);
      cairo_fill(cairo);
    }
  }
}

/* Seen through the head, by what they press. */
static void draw_wires(cairo_t *cairo, const TaborView *view) {
  const double scale = RADIUS / view->radius;
  cairo_set_line_width(cairo, 1.5);
  for (uint32_t w = 0; w < view->wire_count; w++) {
    const double *const place = view->wire_place + 4 * w;
    double force = 0;
    for (uint32_t p = 0; p < view->wire_points; p++)
      force += view->wire_force[w * view->wire_points + p];
    cairo_set_source_rgba(cairo, 0.35, 0.20, 0.05, 0.25 + 0.75 * tanh(force));
    cairo_move_to(cairo, MIDDLE[0] + scale * place[0], MIDDLE[1] - scale * place[1]);
    cairo_line_to(cairo, MIDDLE[0] + scale * place[2], MIDDLE[1] - scale * place[3]);
    cairo_stroke(cairo);
  }
}

static void draw_stroke(cairo_t *cairo, const WindowScene *scene) {
  const double away = RADIUS * scene->struck[0], angle = scene->struck[1] * PI / 180;
  cairo_set_source_rgba(cairo, 0.95, 0.45, 0.10, scene->glow[0]);
  cairo_new_path(cairo);
  cairo_arc(cairo, MIDDLE[0] + away * cos(angle), MIDDLE[1] - away * sin(angle),
            4 + 14 * (1 - scene->glow[0]), 0, 2 * PI);
  cairo_set_line_width(cairo, 3);
  cairo_stroke(cairo);
}

/* Those above the batter head are full, those below it or in the drum are hollow. */
static void draw_mic(cairo_t *cairo, const WindowScene *scene, uint32_t number) {
  const WindowMic *const mic = &scene->mics[number];
  const char letter[] = {mic->name[0], '\0'};
  double x, y;
  mic_place(scene, mic, &x, &y);
  cairo_new_path(cairo);
  cairo_arc(cairo, x, y, MIC - 1, 0, 2 * PI);
  cairo_set_source_rgba(cairo, 0.13, 0.20, 0.32, mic->height > 0 ? 0.85 : 0.35);
  cairo_fill_preserve(cairo);
  cairo_set_source_rgba(cairo, 0.13, 0.20, 0.32, 0.85);
  if (number == scene->mic) accent(cairo);
  cairo_set_line_width(cairo, 1.5);
  cairo_stroke(cairo);
  ink(cairo);
  paint_text(cairo, x, y + 4, AT_MIDDLE, letter);
}

void drum_picture_draw(const WindowScene *scene, cairo_t *cairo) {
  cairo_set_source_rgb(cairo, 0.70, 0.72, 0.75);
  circle(cairo, RADIUS + HOOP);
  cairo_fill(cairo);
  cairo_set_source_rgb(cairo, 0.74, 0.725, 0.69);
  circle(cairo, RADIUS);
  cairo_fill(cairo);
  if (scene->view) {
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
    draw_head(cairo, scene->view);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
    draw_wires(cairo, scene->view);
  }
  if (scene->glow[0] > 0.02) draw_stroke(cairo, scene);
  for (uint32_t i = 0; i < scene->mic_count; i++) draw_mic(cairo, scene, i);
}
