/* SPDX-License-Identifier: MIT */
#include "window/kit_picture.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

/* ---- places, at scale 1 --------------------------------------------------------------------- */

static const Box FLOOR = {20, 20, 370, 370};
static const double SIDEWAYS = 45;     /* [deg]: a drum that is tilted by more shows its shell */
static const double NAME_PLACE = 0.85; /* of a drum's depth */
static const double BELL = 0.22;       /* radius of a cymbal's, of its own */
static const double NAME_SIZE = 11, TEXT_SIZE = 13; /* of letters: names, and all else */

static bool is_sideways(const WindowDrum *drum) {
  return drum->tilt > SIDEWAYS && drum->tilt < 180 - SIDEWAYS;
}

/* ---- the floor ------------------------------------------------------------------------------ */

/* From metres to the picture. */
typedef struct Floor {
  double x, y, scale; /* of the picture's middle [m]; pixels a metre */
} Floor;

static Floor floor_of(const WindowScene *scene) {
  double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
  for (uint32_t i = 0; i < scene->drum_count; i++) {
    const WindowDrum *const drum = &scene->drums[i];
    const double reach = is_sideways(drum) ? fmax(drum->radius, drum->depth) : drum->radius;
    least[0] = fmin(least[0], drum->x - reach);
    least[1] = fmin(least[1], drum->y - reach);
    most[0] = fmax(most[0], drum->x + reach);
    most[1] = fmax(most[1], drum->y + reach);
  }
  if (scene->drum_count == 0) return (Floor){0, 0, 1};
  return (Floor){0.5 * (least[0] + most[0]), 0.5 * (least[1] + most[1]),
                 fmin(FLOOR.width / (most[0] - least[0]), FLOOR.height / (most[1] - least[1]))};
}

static double across(const Floor *floor, double x) {
  return FLOOR.x + 0.5 * FLOOR.width + floor->scale * (x - floor->x);
}
static double down(const Floor *floor, double y) {
  return FLOOR.y + 0.5 * FLOOR.height - floor->scale * (y - floor->y);
}

/* A place in the frame of a drum on its side: along its axis from the batter head on, and aside
 * [m]. */
static void turned(const WindowDrum *drum, double x, double y, double *along, double *aside) {
  const double angle = drum->facing * PI / 180;
  const double away_x = x - drum->x, away_y = y - drum->y;
  *along = -(away_x * cos(angle) + away_y * sin(angle));
  *aside = -away_x * sin(angle) + away_y * cos(angle);
}

static bool is_over(const WindowDrum *drum, double x, double y) {
  double along, aside;
  if (!is_sideways(drum)) return hypot(x - drum->x, y - drum->y) <= drum->radius;
  turned(drum, x, y, &along, &aside);
  return along >= 0 && along <= drum->depth && fabs(aside) <= drum->radius;
}

/* Higher drums hide lower ones. */
static bool find_drum(const WindowScene *scene, double x, double y, uint32_t *found) {
  double highest = -INFINITY;
  for (uint32_t i = 0; i < scene->drum_count; i++) {
    const WindowDrum *const drum = &scene->drums[i];
    const double top = drum->height + (is_sideways(drum) ? drum->radius : 0);
    if (top <= highest || !is_over(drum, x, y)) continue;
    highest = top;
    *found = i;
  }
  return highest > -INFINITY;
}

void kit_picture_find(const WindowScene *scene, double x, double y, WindowPlace *place) {
  const Floor floor = floor_of(scene);
  const double there = floor.x + (x - across(&floor, floor.x)) / floor.scale;
  const double away = floor.y - (y - down(&floor, floor.y)) / floor.scale;
  if (!find_drum(scene, there, away, &place->number)) return;
  const WindowDrum *const drum = &scene->drums[place->number];
  place->part = WINDOW_DRUM;
  place->radius = is_sideways(drum) ? -1 : hypot(there - drum->x, away - drum->y) / drum->radius;
  place->angle = atan2(away - drum->y, there - drum->x) * 180 / PI;
}

/* ---- the drums ------------------------------------------------------------------------------ */

/* Its outline from above. */
static void trace_drum(cairo_t *cairo, const Floor *floor, const WindowDrum *drum) {
  cairo_save(cairo);
  cairo_translate(cairo, across(floor, drum->x), down(floor, drum->y));
  cairo_new_path(cairo);
  if (is_sideways(drum)) {
    cairo_rotate(cairo, -(drum->facing + 180) * PI / 180);
    cairo_rectangle(cairo, 0, -floor->scale * drum->radius, floor->scale * drum->depth,
                    2 * floor->scale * drum->radius);
  } else {
    cairo_arc(cairo, 0, 0, floor->scale * drum->radius, 0, 2 * PI);
  }
  cairo_restore(cairo);
}

/* A shell's wood, a cymbal's bronze, a head. */
static const double *color_of(const WindowDrum *drum) {
  static const double WOOD[3] = {0.36, 0.30, 0.26}, BRONZE[3] = {0.80, 0.66, 0.36},
                      HEAD[3] = {0.74, 0.725, 0.69};
  if (drum->is_plate) return BRONZE;
  return is_sideways(drum) ? WOOD : HEAD;
}

static void draw_bell(cairo_t *cairo, const Floor *floor, const WindowDrum *drum) {
  cairo_new_path(cairo);
  cairo_arc(cairo, across(floor, drum->x), down(floor, drum->y), BELL * floor->scale * drum->radius,
            0, 2 * PI);
  cairo_set_source_rgba(cairo, 0.30, 0.22, 0.08, 0.6);
  cairo_set_line_width(cairo, 1);
  cairo_stroke(cairo);
}

static void draw_drum(cairo_t *cairo, const Floor *floor, const WindowDrum *drum, double glow) {
  trace_drum(cairo, floor, drum);
  const double *const rest = color_of(drum);
  cairo_set_source_rgb(cairo, rest[0] + glow * (0.95 - rest[0]), rest[1] + glow * (0.62 - rest[1]),
                       rest[2] + glow * (0.20 - rest[2]));
  cairo_fill_preserve(cairo);
  cairo_set_source_rgb(cairo, 0.50, 0.52, 0.55);
  cairo_set_line_width(cairo, drum->is_plate ? 1.5 : 4);
  cairo_stroke(cairo);
  if (drum->is_plate) draw_bell(cairo, floor, drum);
  double x = across(floor, drum->x), y = down(floor, drum->y);
  if (is_sideways(drum)) { /* at its far end, where no tom hangs over it */
    x -= NAME_PLACE * floor->scale * drum->depth * cos(drum->facing * PI / 180);
    y += NAME_PLACE * floor->scale * drum->depth * sin(drum->facing * PI / 180);
  }
  if (is_sideways(drum) && glow < 0.5) {
    ink(cairo);
  } else {
    paper(cairo);
  }
  paint_text(cairo, x, y + 4, AT_MIDDLE, drum->name);
}

/* From the lowest to the highest. */
void kit_picture_draw(const WindowScene *scene, cairo_t *cairo) {
  const Floor floor = floor_of(scene);
  double below = -INFINITY;
  cairo_set_font_size(cairo, NAME_SIZE);
  for (uint32_t drawn = 0; drawn < scene->drum_count;) {
    double next = INFINITY;
    for (uint32_t i = 0; i < scene->drum_count; i++) {
      if (scene->drums[i].height > below) next = fmin(next, scene->drums[i].height);
    }
    for (uint32_t i = 0; i < scene->drum_count; i++) {
      if (scene->drums[i].height != next) continue;
      draw_drum(cairo, &floor, &scene->drums[i], scene->glow[i]);
      drawn++;
    }
    below = next;
  }
  cairo_set_font_size(cairo, TEXT_SIZE);
}
