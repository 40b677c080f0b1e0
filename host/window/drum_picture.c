/* SPDX-License-Identifier: MIT */
#include "window/drum_picture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* ---- places, at scale 1 --------------------------------------------------------------------- */

static const double MIDDLE[2] = {205, 215}, RADIUS = 175, HOOP = 10;
static const double LEFT = 420, WIDE = 276, TOP = 66, ROW = 40; /* of controls */
static const double MIC = 9;                                    /* radius of a microphone */
static const double AROUND =
  0.15; /* of the head's radius, in which all lies that is outside of it */
static const double MOST_MIC = 10; /* [m] from the axis */
static const double DEPTH = 5e-4;  /* [m] of a head that is as bright or dark as can be */

double drum_picture_position(double scale, double x) {
  return fmin(fmax((x / scale - LEFT) / WIDE, 0), 1);
}

DrumPlace drum_picture_place(double scale, double x, double y) {
  const double at = x / scale, down = y / scale;
  DrumPlace place = {
    .part = DRUM_PART_NONE, .x = (at - MIDDLE[0]) / RADIUS, .y = (MIDDLE[1] - down) / RADIUS};
  place.button = button_at(at, down);
  if (place.button != BUTTON_COUNT) place.part = DRUM_PART_BUTTON;
  if (hypot(place.x, place.y) <= 1) {
    place.part = DRUM_PART_HEAD;
  } else if (box_has(&(Box){LEFT, TOP, WIDE, DRUM_WINDOW_CONTROLS * ROW}, at, down)) {
    place.part = DRUM_PART_CONTROL;
    place.control = (uint32_t)((down - TOP) / ROW);
    place.x = drum_picture_position(scale, x);
  }
  return place;
}

/* ---- microphones ---------------------------------------------------------------------------- */

/* Parts of the head's radius as they are seen: beyond the head, 1 to infinity is 1 to 1 + AROUND. */
static double seen(double part) { return part <= 1 ? part : 1 + AROUND * (1 - 1 / part); }

static double unseen(double part) {
  return part <= 1 ? part : 1 / fmax(1 - (part - 1) / AROUND, 1e-3);
}

static void mic_place(const DrumPicture *picture, const DrumMic *mic, double *x, double *y) {
  const double away = RADIUS * seen(mic->radius / picture->scene.radius),
               angle = mic->angle * PI / 180;
  *x = MIDDLE[0] + away * cos(angle);
  *y = MIDDLE[1] - away * sin(angle);
}

uint32_t drum_picture_mic(const DrumPicture *picture, double scale, double x, double y) {
  uint32_t found = DRUM_NO_MIC;
  double nearest = MIC;
  for (uint32_t i = 0; i < picture->scene.mic_count; i++) {
    double at, down;
    mic_place(picture, &picture->scene.mics[i], &at, &down);
    const double away = hypot(x / scale - at, y / scale - down);
    if (away >= nearest) continue;
    nearest = away;
    found = i;
  }
  return found;
}

void drum_picture_move_mic(const DrumPicture *picture, double scale, double x, double y,
                           DrumMic *mic) {
  const double at = (x / scale - MIDDLE[0]) / RADIUS, up = (MIDDLE[1] - y / scale) / RADIUS;
  mic->radius = fmin(unseen(hypot(at, up)) * picture->scene.radius, MOST_MIC);
  mic->angle = atan2(up, at) * 180 / PI;
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

static void draw_stroke(cairo_t *cairo, const DrumPicture *picture) {
  cairo_set_source_rgba(cairo, 0.95, 0.45, 0.10, picture->glow);
  cairo_new_path(cairo);
  cairo_arc(cairo, MIDDLE[0] + RADIUS * picture->struck[0], MIDDLE[1] - RADIUS * picture->struck[1],
            4 + 14 * (1 - picture->glow), 0, 2 * PI);
  cairo_set_line_width(cairo, 3);
  cairo_stroke(cairo);
}

/* Those above the batter head are full, those below it or in the drum are hollow. */
static void draw_mic(cairo_t *cairo, const DrumPicture *picture, uint32_t number) {
  const DrumMic *const mic = &picture->scene.mics[number];
  const char letter[] = {mic->name[0], '\0'};
  double x, y;
  mic_place(picture, mic, &x, &y);
  cairo_new_path(cairo);
  cairo_arc(cairo, x, y, MIC - 1, 0, 2 * PI);
  cairo_set_source_rgba(cairo, 0.13, 0.20, 0.32, mic->height > 0 ? 0.85 : 0.35);
  cairo_fill_preserve(cairo);
  cairo_set_source_rgba(cairo, 0.13, 0.20, 0.32, 0.85);
  if (number == picture->mic) accent(cairo);
  cairo_set_line_width(cairo, 1.5);
  cairo_stroke(cairo);
  ink(cairo);
  paint_text(cairo, x, y + 4, AT_MIDDLE, letter);
}

static void say_mic(const DrumMic *mic, char *text, size_t size) {
  (void)snprintf(text, size, "%s: %.0f mm out, %.0f deg, %.0f mm %s; the wheel lifts it", mic->name,
                 1e3 * mic->radius, mic->angle, 1e3 * fabs(mic->height),
                 mic->height > 0 ? "up" : "down");
}

static void draw_drum(cairo_t *cairo, const DrumPicture *picture) {
  char text[2 * WINDOW_TEXT];
  cairo_set_source_rgb(cairo, 0.70, 0.72, 0.75);
  circle(cairo, RADIUS + HOOP);
  cairo_fill(cairo);
  cairo_set_source_rgb(cairo, 0.74, 0.725, 0.69);
  circle(cairo, RADIUS);
  cairo_fill(cairo);
  if (picture->scene.view) {
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
    draw_head(cairo, picture->scene.view);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
    draw_wires(cairo, picture->scene.view);
  }
  if (picture->glow > 0.02) draw_stroke(cairo, picture);
  for (uint32_t i = 0; i < picture->scene.mic_count; i++) draw_mic(cairo, picture, i);
  if (picture->mic < picture->scene.mic_count) {
    say_mic(&picture->scene.mics[picture->mic], text, sizeof text);
  } else {
    (void)snprintf(text, sizeof text, "click to strike at %.1f m/s; the wheel changes it",
                   picture->speed);
  }
  pale(cairo);
  paint_text(cairo, MIDDLE[0], 422, AT_MIDDLE, text);
}

/* ---- controls and meters -------------------------------------------------------------------- */

static void draw_control(cairo_t *cairo, uint32_t row, const DrumControl *control) {
  const double y = TOP + ROW * row;
  const Box way = {LEFT, y + 22, WIDE, 8};
  pale(cairo);
  paint_text(cairo, LEFT, y + 15, AT_LEFT, control->name);
  if (!control->is_idle) ink(cairo);
  paint_text(cairo, LEFT + WIDE, y + 15, AT_RIGHT, control->value);
  paint_way(cairo, &way, control->is_idle ? 0 : control->position);
}

void drum_picture_draw(const DrumPicture *picture, cairo_t *cairo, double scale) {
  const DrumWindowScene *const scene = &picture->scene;
  paint_paper(cairo, scale);
  draw_drum(cairo, picture);
  for (uint32_t i = 0; i < picture->controls; i++) draw_control(cairo, i, &picture->control[i]);
  paint_button(cairo, BUTTON_PAGE, scene->page, true);
  paint_frame(cairo, scene->title, scene->is_second, scene->can_undo, picture->meters);
}
