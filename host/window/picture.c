/* SPDX-License-Identifier: MIT */
#include "window/picture.h"

#include <math.h>
#include <stdio.h>

#include "window/drum_picture.h"
#include "window/kit_picture.h"

/* Places, at scale 1. */
static const double LEFT = 420, WIDE = 276, TOP = 66, ROW = 40; /* of controls */
static const double SAYING_X = 205, SAYING_Y = 422;

double picture_position(double scale, double x) {
  return fmin(fmax((x / scale - LEFT) / WIDE, 0), 1);
}

WindowPlace picture_place(const WindowScene *scene, double scale, double x, double y) {
  const double at = x / scale, down = y / scale;
  WindowPlace place = {.part = WINDOW_NOTHING, .button = button_at(at, down)};
  if (place.button != BUTTON_COUNT) {
    place.part = WINDOW_BUTTON;
  } else if (scene->sounds && sound_list_has(at, down)) {
    place.part = WINDOW_SOUNDS;
    place.sound = sound_list_at(scene->sounds, at, down);
  } else if (!scene->sounds && box_has(&(Box){LEFT, TOP, WIDE, KNOB_PAGE * ROW}, at, down)) {
    place.number = (uint32_t)((down - TOP) / ROW);
    if (place.number < scene->control_count) place.part = WINDOW_CONTROL;
  } else if (scene->is_kit) {
    kit_picture_find(scene, at, down, &place);
  } else {
    drum_picture_find(scene, at, down, &place);
  }
  return place;
}

static void draw_control(cairo_t *cairo, uint32_t row, const WindowControl *control) {
  const double y = TOP + ROW * row;
  const Box way = {LEFT, y + 22, WIDE, 8};
  pale(cairo);
  paint_text(cairo, LEFT, y + 15, AT_LEFT, control->name);
  if (!control->is_idle) ink(cairo);
  paint_text(cairo, LEFT + WIDE, y + 15, AT_RIGHT, control->value);
  paint_way(cairo, &way, control->is_idle ? 0 : control->position);
}

static void say(cairo_t *cairo, const WindowScene *scene) {
  char text[2 * WINDOW_TEXT];
  if (!scene->is_kit && scene->mic < scene->mic_count) {
    drum_picture_say_mic(&scene->mics[scene->mic], text, sizeof text);
  } else {
    (void)snprintf(text, sizeof text, "click to strike at %.1f m/s; the wheel changes it",
                   scene->speed);
  }
  pale(cairo);
  paint_text(cairo, SAYING_X, SAYING_Y, AT_MIDDLE, text);
}

void picture_draw(const WindowScene *scene, cairo_t *cairo, double scale) {
  paint_paper(cairo, scale);
  if (scene->is_kit) {
    kit_picture_draw(scene, cairo);
  } else {
    drum_picture_draw(scene, cairo);
  }
  say(cairo, scene);
  if (scene->sounds) {
    sound_list_draw(scene->sounds, cairo, scene->title);
  } else {
    for (uint32_t i = 0; i < scene->control_count; i++) draw_control(cairo, i, &scene->controls[i]);
  }
  paint_button(cairo, BUTTON_PAGE, scene->page, true);
  paint_frame(cairo, scene->title, scene->is_second, scene->can_undo, scene->meters);
}
