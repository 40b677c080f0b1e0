/* SPDX-License-Identifier: MIT */
#include "window/kit_picture.h"

#include <math.h>
#include <stdio.h>

static const double PI = 3.14159265358979323846;

/* ---- places, at scale 1 --------------------------------------------------------------------- */

static const Box FLOOR = {20, 20, 370, 370};
static const double SIDEWAYS = 45; /* [deg]: a drum that is tilted by more shows its shell */
static const double NAMES = 420, LEVELS = 512, TUNES = 608, WAY = 88;
static const double TOP = 76, ROW = 33;                   /* of the drums' controls */
static const double BOTTOM = 352, HALF = 144, WIDE = 132; /* of those for all */
static const double NAME_PLACE = 0.85;                    /* of a drum's depth */
static const double HEADING = 62;
static const double WAY_DOWN = 6, WAY_HEIGHT = 8;

static bool is_sideways(const KitWindowDrum *drum) {
  return drum->tilt > SIDEWAYS && drum->tilt < 180 - SIDEWAYS;
}

KitKnobId kit_picture_knob(const KitPicture *picture, uint32_t number) {
  static const KitKnobId all[] = {KIT_KNOB_OVERHEADS, KIT_KNOB_GAIN};
  const uint32_t drums =
    picture->scene.drum_count < KIT_KNOB_DRUMS ? picture->scene.drum_count : KIT_KNOB_DRUMS;
  if (number < drums) return (KitKnobId)(KIT_KNOB_LEVEL + number);
  if (number < 2 * drums) return (KitKnobId)(KIT_KNOB_TUNE + number - drums);
  if (number - 2 * drums < sizeof all / sizeof *all) return all[number - 2 * drums];
  return KIT_KNOB_COUNT;
}

/* The way of a control. */
static Box way_of(KitKnobId knob) {
  if (knob == KIT_KNOB_OVERHEADS || knob == KIT_KNOB_GAIN) {
    const double x = knob == KIT_KNOB_GAIN ? NAMES + HALF : NAMES;
    return (Box){x, BOTTOM + WAY_DOWN, WIDE, WAY_HEIGHT};
  }
  const bool tunes = knob >= KIT_KNOB_TUNE;
  const double row = knob - (tunes ? KIT_KNOB_TUNE : KIT_KNOB_LEVEL);
  return (Box){tunes ? TUNES : LEVELS, TOP + ROW * row + WAY_DOWN, WAY, WAY_HEIGHT};
}

double kit_picture_position(KitKnobId knob, double scale, double x) {
  const Box way = way_of(knob);
  return fmin(fmax((x / scale - way.x) / way.width, 0), 1);
}

/* ---- the floor ------------------------------------------------------------------------------ */

/* From metres to the picture. */
typedef struct Floor {
  double x, y, scale; /* of the picture's middle [m]; pixels a metre */
} Floor;

static Floor floor_of(const KitWindowScene *scene) {
  double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
  for (uint32_t i = 0; i < scene->drum_count; i++) {
    const KitWindowDrum *const drum = &scene->drums[i];
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

/* A place in the frame of a drum on its side: along its axis from the batter head on, and aside [m]. */
static void turned(const KitWindowDrum *drum, double x, double y, double *along, double *aside) {
  const double angle = drum->facing * PI / 180;
  const double away_x = x - drum->x, away_y = y - drum->y;
  *along = -(away_x * cos(angle) + away_y * sin(angle));
  *aside = -away_x * sin(angle) + away_y * cos(angle);
}

static bool is_over(const KitWindowDrum *drum, double x, double y) {
  double along, aside;
  if (!is_sideways(drum)) return hypot(x - drum->x, y - drum->y) <= drum->radius;
  turned(drum, x, y, &along, &aside);
  return along >= 0 && along <= drum->depth && fabs(aside) <= drum->radius;
}

/* Higher drums hide lower ones. */
static bool find_drum(const KitWindowScene *scene, double x, double y, uint32_t *found) {
  double highest = -INFINITY;
  for (uint32_t i = 0; i < scene->drum_count; i++) {
    const KitWindowDrum *const drum = &scene->drums[i];
    const double top = drum->height + (is_sideways(drum) ? drum->radius : 0);
    if (top <= highest || !is_over(drum, x, y)) continue;
    highest = top;
    *found = i;
  }
  return highest > -INFINITY;
}

KitPlace kit_picture_place(const KitPicture *picture, double scale, double x, double y) {
  const double at = x / scale, low = y / scale;
  KitPlace place = {.part = KIT_PART_NONE, .button = button_at(at, low)};
  KitKnobId knob;
  if (place.button != BUTTON_COUNT) place.part = KIT_PART_BUTTON;
  for (uint32_t i = 0; (knob = kit_picture_knob(picture, i)) != KIT_KNOB_COUNT; i++) {
    const Box way = way_of(knob), reach = {way.x, way.y - 18, way.width, way.height + 22};
    if (!box_has(&reach, at, low)) continue;
    place.part = KIT_PART_CONTROL;
    place.knob = knob;
  }
  const Floor floor = floor_of(&picture->scene);
  const double there = floor.x + (at - across(&floor, floor.x)) / floor.scale;
  const double away = floor.y - (low - down(&floor, floor.y)) / floor.scale;
  if (place.part != KIT_PART_NONE || !find_drum(&picture->scene, there, away, &place.drum))
    return place;
  const KitWindowDrum *const drum = &picture->scene.drums[place.drum];
  place.part = KIT_PART_DRUM;
  place.radius = is_sideways(drum) ? -1 : hypot(there - drum->x, away - drum->y) / drum->radius;
  place.angle = atan2(away - drum->y, there - drum->x) * 180 / PI;
  return place;
}

/* ---- the drums ------------------------------------------------------------------------------ */

/* Its outline from above. */
static void trace_drum(cairo_t *cairo, const Floor *floor, const KitWindowDrum *drum) {
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

static void draw_drum(cairo_t *cairo, const Floor *floor, const KitWindowDrum *drum, double glow) {
  trace_drum(cairo, floor, drum);
  const double rest[3] = {is_sideways(drum) ? 0.36 : 0.74, is_sideways(drum) ? 0.30 : 0.725,
                          is_sideways(drum) ? 0.26 : 0.69};
  cairo_set_source_rgb(cairo, rest[0] + glow * (0.95 - rest[0]), rest[1] + glow * (0.62 - rest[1]),
                       rest[2] + glow * (0.20 - rest[2]));
  cairo_fill_preserve(cairo);
  cairo_set_source_rgb(cairo, 0.50, 0.52, 0.55);
  cairo_set_line_width(cairo, 4);
  cairo_stroke(cairo);
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
static void draw_drums(cairo_t *cairo, const KitPicture *picture) {
  const KitWindowScene *const scene = &picture->scene;
  const Floor floor = floor_of(scene);
  double below = -INFINITY;
  for (uint32_t drawn = 0; drawn < scene->drum_count;) {
    double next = INFINITY;
    for (uint32_t i = 0; i < scene->drum_count; i++) {
      if (scene->drums[i].height > below) next = fmin(next, scene->drums[i].height);
    }
    for (uint32_t i = 0; i < scene->drum_count; i++) {
      if (scene->drums[i].height != next) continue;
      draw_drum(cairo, &floor, &scene->drums[i], picture->glow[i]);
      drawn++;
    }
    below = next;
  }
}

/* ---- controls ------------------------------------------------------------------------------- */

static void draw_control(cairo_t *cairo, const KitPicture *picture, KitKnobId knob) {
  const Box way = way_of(knob);
  paint_way(cairo, &way, picture->position[knob]);
  ink(cairo);
  paint_text(cairo, way.x + way.width, way.y - 4, AT_RIGHT, picture->value[knob]);
  pale(cairo);
  if (knob >= KIT_KNOB_TUNE) return;
  if (knob >= KIT_KNOB_LEVEL) {
    paint_text(cairo, NAMES, way.y + 7, AT_LEFT, picture->scene.drums[knob - KIT_KNOB_LEVEL].name);
  } else {
    paint_text(cairo, way.x, way.y - 4, AT_LEFT, kit_knobs[knob].name);
  }
}

void kit_picture_draw(const KitPicture *picture, cairo_t *cairo, double scale) {
  const KitWindowScene *const scene = &picture->scene;
  char text[WINDOW_TEXT];
  KitKnobId knob;
  paint_paper(cairo, scale);
  cairo_set_font_size(cairo, 11);
  draw_drums(cairo, picture);
  pale(cairo);
  paint_text(cairo, LEVELS, HEADING, AT_LEFT, "level");
  paint_text(cairo, TUNES, HEADING, AT_LEFT, "tuning");
  for (uint32_t i = 0; (knob = kit_picture_knob(picture, i)) != KIT_KNOB_COUNT; i++)
    draw_control(cairo, picture, knob);
  cairo_set_font_size(cairo, 13);
  (void)snprintf(text, sizeof text, "click to strike at %.1f m/s; the wheel changes it",
                 picture->speed);
  pale(cairo);
  paint_text(cairo, FLOOR.x + 0.5 * FLOOR.width, 422, AT_MIDDLE, text);
  paint_frame(cairo, scene->title, scene->is_second, scene->can_undo, picture->meters);
}
