/* SPDX-License-Identifier: MIT */
#include "window/drum_window.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "window/drum_picture.h"
#include "window/x11_window.h"

static const double LEAST_SPEED = 0.5, MOST_SPEED = 12.0, FIRST_SPEED = 4.5; /* [m/s] */
static const double SPEED_STEP = 1.1892;                                     /* 1.5 dB a notch */
static const double METER_FALL = 0.85;                                       /* a frame */
static const double WHEEL_STEP = 0.02; /* of a control's way */
static const double DEGREE = 57.29577951308232;
static const double LEAST_WAY = 0.011,
                    MOST_WAY = 10;   /* of a microphone from the nearest head [m] */
static const double WAY_STEP = 0.06; /* of this way, a notch */

struct DrumWindow {
  DrumWindowShell shell;
  X11Window *outside;
  DrumPicture picture;
  uint32_t width, height;
  bool is_dragging;
  uint32_t dragged; /* a control */
  bool has_moved;   /* the microphone that is held, picture.mic */
  bool holds_mic;
  DrumMic held;
};

/* ---- what was done -------------------------------------------------------------------------- */

static DrumPlace place_at(const DrumWindow *window, double x, double y) {
  return drum_picture_place(painting_scale(window->width, window->height), x, y);
}

static void strike(DrumWindow *window, const DrumPlace *place) {
  DrumPicture *const picture = &window->picture;
  picture->struck[0] = place->x;
  picture->struck[1] = place->y;
  picture->glow = 1.0;
  window->shell.strike(window->shell.context, picture->speed, hypot(place->x, place->y),
                       DEGREE * atan2(place->y, place->x));
}

static void push_button(DrumWindow *window, Button button) {
  const DrumWindowShell *const shell = &window->shell;
  switch (button) {
  case BUTTON_BEFORE: shell->step_preset(shell->context, -1); break;
  case BUTTON_NEXT: shell->step_preset(shell->context, 1); break;
  case BUTTON_COMPARE: shell->compare(shell->context); break;
  case BUTTON_UNDO: shell->undo(shell->context); break;
  case BUTTON_PAGE: shell->turn_page(shell->context); break;
  default: break;
  }
}

/* False: there is none. */
static bool take_mic(DrumWindow *window, double x, double y) {
  DrumPicture *const picture = &window->picture;
  picture->mic = drum_picture_mic(picture, painting_scale(window->width, window->height), x, y);
  window->holds_mic = picture->mic != DRUM_NO_MIC;
  window->has_moved = false;
  if (window->holds_mic) window->held = picture->scene.mics[picture->mic];
  return window->holds_mic;
}

static bool can_turn(const DrumWindow *window, uint32_t control) {
  const DrumPicture *const picture = &window->picture;
  return control < picture->controls && !picture->control[control].is_idle;
}

static void press(void *context, double x, double y) {
  DrumWindow *const window = context;
  void *const shell = window->shell.context;
  const DrumPlace place = place_at(window, x, y);
  if (take_mic(window, x, y)) return;
  switch (place.part) {
  case DRUM_PART_HEAD: strike(window, &place); break;
  case DRUM_PART_BUTTON: push_button(window, place.button); break;
  case DRUM_PART_CONTROL:
    if (!can_turn(window, place.control)) break;
    window->is_dragging = true;
    window->dragged = place.control;
    window->shell.begin(shell, place.control);
    window->shell.move(shell, place.control, place.x);
    break;
  default: break;
  }
}

static void drag(void *context, double x, double y) {
  DrumWindow *const window = context;
  const double scale = painting_scale(window->width, window->height);
  if (window->holds_mic) {
    drum_picture_move_mic(&window->picture, scale, x, y, &window->held);
    window->has_moved = true;
  }
  if (!window->is_dragging) return;
  window->shell.move(window->shell.context, window->dragged, drum_picture_position(scale, x));
}

static void release(void *context) {
  DrumWindow *const window = context;
  void *const shell = window->shell.context;
  if (window->is_dragging) window->shell.end(shell, window->dragged);
  if (window->has_moved) window->shell.move_mic(shell, window->picture.mic, &window->held);
  window->is_dragging = window->holds_mic = window->has_moved = false;
}

static void turn(DrumWindow *window, uint32_t control, int steps) {
  void *const shell = window->shell.context;
  if (!can_turn(window, control) || window->is_dragging) return;
  const double position = window->picture.control[control].position + WHEEL_STEP * steps;
  window->shell.begin(shell, control);
  window->shell.move(shell, control, fmin(fmax(position, 0), 1));
  window->shell.end(shell, control);
}

/* Between the ends of its part of space: above the drum, in it, or below it. */
static double raised(const DrumWindowScene *scene, double height, int steps) {
  const double bottom = scene->depth > 0 ? -scene->depth : 0;
  const double away = fmin(fabs(height), fabs(height - bottom));
  const double to = height + steps * WAY_STEP * away;
  if (height > 0) return fmin(fmax(to, LEAST_WAY), MOST_WAY);
  if (height > bottom) return fmin(fmax(to, bottom + LEAST_WAY), -LEAST_WAY);
  return fmin(fmax(to, -MOST_WAY), bottom - LEAST_WAY);
}

static void raise_mic(DrumWindow *window, uint32_t mic, int steps) {
  const DrumWindowScene *const scene = &window->picture.scene;
  DrumMic to = scene->mics[mic];
  to.height = raised(scene, to.height, steps);
  window->picture.mic = mic;
  window->shell.move_mic(window->shell.context, mic, &to);
}

/* Over the head it changes how fast the next strokes are. */
static void scroll(void *context, double x, double y, int steps) {
  DrumWindow *const window = context;
  const DrumPlace place = place_at(window, x, y);
  const uint32_t mic =
    drum_picture_mic(&window->picture, painting_scale(window->width, window->height), x, y);
  if (window->holds_mic) return;
  if (mic != DRUM_NO_MIC) {
    raise_mic(window, mic, steps);
    return;
  }
  double *const speed = &window->picture.speed;
  if (place.part == DRUM_PART_HEAD)
    *speed =
      fmin(fmax(*speed * (steps > 0 ? SPEED_STEP : 1 / SPEED_STEP), LEAST_SPEED), MOST_SPEED);
  if (place.part == DRUM_PART_CONTROL) turn(window, place.control, steps);
}

/* ---- what is shown -------------------------------------------------------------------------- */

static void look(DrumWindow *window) {
  DrumPicture *const picture = &window->picture;
  void *const shell = window->shell.context;
  picture->scene.view = NULL;
  window->shell.scene(shell, &picture->scene);
  if (window->holds_mic && picture->mic < picture->scene.mic_count)
    picture->scene.mics[picture->mic] = window->held;
  for (uint32_t i = 0; i < 2; i++) {
    picture->meters[i] = fmax(METER_FALL * picture->meters[i], (double)picture->scene.peaks[i]);
  }
  picture->glow *= METER_FALL;
  picture->controls = 0;
  for (uint32_t i = 0; i < DRUM_WINDOW_CONTROLS; i++) {
    if (!window->shell.control(shell, i, &picture->control[i])) break;
    picture->controls++;
  }
}

static void draw(void *context, cairo_t *cairo, uint32_t width, uint32_t height) {
  DrumWindow *const window = context;
  drum_picture_draw(&window->picture, cairo, painting_scale(width, height));
}

/* ---- beginning and end ---------------------------------------------------------------------- */

DrumWindow *drum_window_create(unsigned long parent, uint32_t width, uint32_t height,
                               const DrumWindowShell *shell) {
  DrumWindow *const window = calloc(1, sizeof *window);
  if (!window) return NULL;
  window->shell = *shell;
  window->picture.speed = FIRST_SPEED;
  window->picture.mic = DRUM_NO_MIC;
  window->width = width;
  window->height = height;
  const X11Handler handler = {.context = window,
                              .draw = draw,
                              .press = press,
                              .drag = drag,
                              .release = release,
                              .scroll = scroll};
  window->outside = x11_window_create(parent, width, height, &handler);
  if (window->outside) {
    look(window);
    return window;
  }
  free(window);
  return NULL;
}

void drum_window_destroy(DrumWindow *window) {
  if (!window) return;
  release(window);
  x11_window_destroy(window->outside);
  free(window);
}

unsigned long drum_window_id(const DrumWindow *window) { return x11_window_id(window->outside); }

void drum_window_show(DrumWindow *window, bool shown) { x11_window_show(window->outside, shown); }

void drum_window_resize(DrumWindow *window, uint32_t width, uint32_t height) {
  window->width = width;
  window->height = height;
  x11_window_resize(window->outside, width, height);
}

void drum_window_update(DrumWindow *window) {
  x11_window_take_events(window->outside);
  look(window);
  x11_window_draw(window->outside);
}
