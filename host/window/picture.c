/* SPDX-License-Identifier: MIT */
#include "window/picture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "window/drum_picture.h"
#include "window/kit_picture.h"

/* Places, at scale 1. */
static const double LEFT = 420, WIDE = 276, TOP = 66, ROW = 40; /* of controls */
static const double TEXT_DOWN = 15, WAY_DOWN = 22, WAY_HIGH = 8, VALUE_WIDE = 96;
static const double SWITCH = 18, SWITCH_HIGH = 15, SWITCH_GAP = 4, SWITCHES = 150;
static const double LEAST_LOAD = 0.01, MOST_LOAD = 0.8; /* that is shown; that may leave gaps */
static const double SAYING_X = 205, SAYING_Y = 420, SAYING_WIDE = 385;

double picture_position(double scale, double x) {
  return fmin(fmax((x / scale - LEFT) / WIDE, 0), 1);
}

/* ---- places --------------------------------------------------------------------------------- */

static Box switch_box(uint32_t row, int number) {
  return (Box){LEFT + SWITCHES + number * (SWITCH + SWITCH_GAP), TOP + ROW * row + 3, SWITCH,
               SWITCH_HIGH};
}

static WindowPart part_of_control(const WindowControl *control, uint32_t row, double x, double y) {
  const Box mute = switch_box(row, 0), solo = switch_box(row, 1);
  if (control->is_level && box_has(&mute, x, y)) return WINDOW_MUTE;
  if (control->is_level && box_has(&solo, x, y)) return WINDOW_SOLO;
  const bool is_value = x >= LEFT + WIDE - VALUE_WIDE && y < TOP + ROW * row + WAY_DOWN - 2;
  return is_value ? WINDOW_VALUE : WINDOW_CONTROL;
}

static void find_control(const WindowScene *scene, double x, double y, WindowPlace *place) {
  place->number = (uint32_t)((y - TOP) / ROW);
  if (place->number < scene->control_count)
    place->part = part_of_control(&scene->controls[place->number], place->number, x, y);
}

WindowPlace picture_place(const WindowScene *scene, double scale, double x, double y) {
  const double at = x / scale, down = y / scale;
  WindowPlace place = {.part = WINDOW_NOTHING, .button = button_at(at, down)};
  if (place.button != BUTTON_COUNT) {
    place.part = WINDOW_BUTTON;
  } else if (scene->list && list_view_has(at, down)) {
    place.part = WINDOW_LIST;
    place.line = list_view_at(scene->list, at, down);
    place.is_star = list_view_is_star(scene->list, at);
  } else if (!scene->list && box_has(&(Box){LEFT, TOP, WIDE, KNOB_PAGE * ROW}, at, down)) {
    find_control(scene, at, down, &place);
  } else if (scene->is_kit) {
    kit_picture_find(scene, at, down, &place);
  } else {
    drum_picture_find(scene, at, down, &place);
  }
  return place;
}

/* ---- controls ------------------------------------------------------------------------------- */

/* What is typed, with a mark where the next letter comes. */
static void draw_typed(cairo_t *cairo, double right, double y, const LineEditor *typed) {
  char text[LINE_SIZE + 8];
  (void)snprintf(text, sizeof text, "%.*s|%s", (int)typed->cursor, typed->text,
                 typed->text + typed->cursor);
  accent(cairo);
  paint_text(cairo, right, y, AT_RIGHT, text);
}

static void draw_switches(cairo_t *cairo, uint32_t row, const WindowControl *control) {
  const Box mute = switch_box(row, 0), solo = switch_box(row, 1);
  paint_switch(cairo, &mute, "M", control->is_mute);
  paint_switch(cairo, &solo, "S", control->is_solo);
}

static void draw_control(cairo_t *cairo, const WindowScene *scene, uint32_t row) {
  const WindowControl *const control = &scene->controls[row];
  const double y = TOP + ROW * row;
  const Box way = {LEFT, y + WAY_DOWN, WIDE, WAY_HIGH};
  const bool is_typed = scene->typed && scene->typed_at == row;
  pale(cairo);
  paint_text_in(cairo, LEFT, y + TEXT_DOWN,
                control->is_level ? SWITCHES - SWITCH_GAP : WIDE - VALUE_WIDE, control->name);
  if (control->is_level && !control->is_idle) draw_switches(cairo, row, control);
  pale(cairo);
  if (!control->is_idle) ink(cairo);
  if (is_typed) {
    draw_typed(cairo, LEFT + WIDE, y + TEXT_DOWN, scene->typed);
  } else if (control->position >= 0) {
    paint_text(cairo, LEFT + WIDE, y + TEXT_DOWN, AT_RIGHT, control->value);
  } else { /* a text, which may be long */
    paint_text_in(cairo, LEFT, y + WAY_DOWN + WAY_HIGH, WIDE, control->value);
  }
  if (control->position >= 0)
    paint_way(cairo, &way, control->is_idle ? 0 : control->position, !control->is_quiet);
  if (scene->focus == row) paint_focus(cairo, &(Box){LEFT - 5, y - 1, WIDE + 10, ROW - 6});
}

/* ---- all ------------------------------------------------------------------------------------ */

/* Where the newest stroke fell, and how fast; nothing before the first. */
static int write_struck(const WindowScene *scene, char *text, size_t size) {
  if (scene->struck_speed <= 0) return 0;
  if (scene->is_kit && scene->struck_drum < scene->drum_count)
    return snprintf(text, size, "%s struck at %.1f m/s; ", scene->drums[scene->struck_drum].name,
                    scene->struck_speed);
  if (scene->is_kit) return 0;
  return snprintf(text, size, "struck at %.1f m/s, %.0f %% out; ", scene->struck_speed,
                  100 * scene->struck[0]);
}

static void write_load(const WindowScene *scene, char *text, size_t size) {
  if (scene->load > MOST_LOAD && !scene->is_draft) {
    (void)snprintf(text, size, "; load %.0f %%: the quality Draft takes less", 100 * scene->load);
  } else if (scene->load > LEAST_LOAD) {
    (void)snprintf(text, size, "; load %.0f %%", 100 * scene->load);
  }
}

static void say_usual(const WindowScene *scene, char *text, size_t size) {
  if (!scene->is_kit && scene->mic < scene->mic_count) {
    drum_picture_say_mic(&scene->mics[scene->mic], text, size);
  } else {
    const int told = write_struck(scene, text, size);
    (void)snprintf(text + told, size - (size_t)told, "click: %.1f m/s, wheel changes it; ?: keys",
                   scene->speed);
    write_load(scene, text + strlen(text), size - strlen(text));
  }
}

static void say(cairo_t *cairo, const WindowScene *scene) {
  char text[WINDOW_MESSAGE + LINE_SIZE];
  const bool is_question = scene->typed && scene->typed_at == WINDOW_NO_CONTROL;
  say_usual(scene, text, sizeof text);
  if (is_question) {
    (void)snprintf(text, sizeof text, "%s %.*s|%s", scene->message, (int)scene->typed->cursor,
                   scene->typed->text, scene->typed->text + scene->typed->cursor);
  } else if (*scene->message) {
    (void)snprintf(text, sizeof text, "%s", scene->message);
  }
  pale(cairo);
  if (is_question) ink(cairo);
  if (*scene->message && scene->is_alarm) alarm(cairo);
  cairo_set_font_size(cairo, SMALL_TEXT + 1);
  paint_lines(cairo, SAYING_X, SAYING_Y, SAYING_WIDE, 2, text);
  cairo_set_font_size(cairo, USUAL_TEXT);
}

static void draw_controls(cairo_t *cairo, const WindowScene *scene) {
  for (uint32_t i = 0; i < scene->control_count; i++) draw_control(cairo, scene, i);
}

void picture_draw(const WindowScene *scene, cairo_t *cairo, double scale) {
  const Frame frame = {.title = scene->title,
                       .page = scene->page,
                       .is_second = scene->is_second,
                       .can_undo = scene->can_undo,
                       .can_redo = scene->can_redo,
                       .peaks = {scene->meters[0], scene->meters[1]}};
  paint_paper(cairo, scale);
  if (scene->is_kit) {
    kit_picture_draw(scene, cairo);
  } else {
    drum_picture_draw(scene, cairo);
  }
  say(cairo, scene);
  if (scene->list) {
    list_view_draw(scene->list, cairo, scene->marked);
  } else {
    draw_controls(cairo, scene);
  }
  paint_frame(cairo, &frame);
}
