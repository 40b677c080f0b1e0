/* SPDX-License-Identifier: MIT */
#include "window/kit_window.h"

#include <math.h>
#include <stdlib.h>

#include "window/kit_picture.h"
#include "window/x11_window.h"

static const double LEAST_SPEED = 0.5, MOST_SPEED = 12.0, FIRST_SPEED = 4.5; /* [m/s] */
static const double SPEED_STEP = 1.1892;                                     /* 1.5 dB a notch */
static const double METER_FALL = 0.85;                                       /* a frame */
static const double WHEEL_STEP = 0.02; /* of a control's way */
static const double BRIGHT = 5;        /* [m/s]: a stroke that lights a drum up */

struct KitWindow {
  KitWindowShell shell;
  X11Window *outside;
  KitPicture picture;
  uint32_t width, height;
  KitKnobId dragged; /* KIT_KNOB_COUNT: none */
};

/* ---- what was done -------------------------------------------------------------------------- */

static double scale_of(const KitWindow *window) {
  return painting_scale(window->width, window->height);
}

static void strike(KitWindow *window, const KitPlace *place) {
  KitPicture *const picture = &window->picture;
  picture->glow[place->drum] = 1.0;
  window->shell.strike(window->shell.context, place->drum, picture->speed, place->radius,
                       place->angle);
}

static void push_button(const KitWindow *window, Button button) {
  const KitWindowShell *const shell = &window->shell;
  switch (button) {
  case BUTTON_BEFORE: shell->step_kit(shell->context, -1); break;
  case BUTTON_NEXT: shell->step_kit(shell->context, 1); break;
  case BUTTON_COMPARE: shell->compare(shell->context); break;
  case BUTTON_UNDO: shell->undo(shell->context); break;
  default: break;
  }
}

static void move(KitWindow *window, double x) {
  const double position = kit_picture_position(window->dragged, scale_of(window), x);
  window->shell.move(window->shell.context, window->dragged, position);
}

static void press(void *context, double x, double y) {
  KitWindow *const window = context;
  const KitPlace place = kit_picture_place(&window->picture, scale_of(window), x, y);
  switch (place.part) {
  case KIT_PART_DRUM: strike(window, &place); break;
  case KIT_PART_BUTTON: push_button(window, place.button); break;
  case KIT_PART_CONTROL:
    window->dragged = place.knob;
    window->shell.begin(window->shell.context, place.knob);
    move(window, x);
    break;
  default: break;
  }
}

static void drag(void *context, double x, double y) {
  KitWindow *const window = context;
  (void)y;
  if (window->dragged != KIT_KNOB_COUNT) move(window, x);
}

static void release(void *context) {
  KitWindow *const window = context;
  if (window->dragged != KIT_KNOB_COUNT) window->shell.end(window->shell.context, window->dragged);
  window->dragged = KIT_KNOB_COUNT;
}

static void turn(KitWindow *window, KitKnobId knob, int steps) {
  void *const shell = window->shell.context;
  if (window->dragged != KIT_KNOB_COUNT) return;
  const double position = window->picture.position[knob] + WHEEL_STEP * steps;
  window->shell.begin(shell, knob);
  window->shell.move(shell, knob, fmin(fmax(position, 0), 1));
  window->shell.end(shell, knob);
}

/* Over a drum it changes how fast the next strokes are. */
static void scroll(void *context, double x, double y, int steps) {
  KitWindow *const window = context;
  const KitPlace place = kit_picture_place(&window->picture, scale_of(window), x, y);
  double *const speed = &window->picture.speed;
  if (place.part == KIT_PART_DRUM)
    *speed =
      fmin(fmax(*speed * (steps > 0 ? SPEED_STEP : 1 / SPEED_STEP), LEAST_SPEED), MOST_SPEED);
  if (place.part == KIT_PART_CONTROL) turn(window, place.knob, steps);
}

/* ---- what is shown -------------------------------------------------------------------------- */

static void look(KitWindow *window) {
  KitPicture *const picture = &window->picture;
  void *const shell = window->shell.context;
  KitKnobId knob;
  window->shell.scene(shell, &picture->scene);
  for (uint32_t side = 0; side < 2; side++) {
    picture->meters[side] =
      fmax(METER_FALL * picture->meters[side], (double)picture->scene.peaks[side]);
  }
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    const bool is_there = i < picture->scene.drum_count;
    const double lit = is_there ? fmin(picture->scene.drums[i].struck / BRIGHT, 1) : 0;
    picture->glow[i] = fmax(METER_FALL * picture->glow[i], lit);
  }
  for (uint32_t i = 0; (knob = kit_picture_knob(picture, i)) != KIT_KNOB_COUNT; i++) {
    window->shell.control(shell, knob, picture->value[knob], &picture->position[knob]);
  }
}

static void draw(void *context, cairo_t *cairo, uint32_t width, uint32_t height) {
  const KitWindow *const window = context;
  kit_picture_draw(&window->picture, cairo, painting_scale(width, height));
}

/* ---- beginning and end ---------------------------------------------------------------------- */

KitWindow *kit_window_create(unsigned long parent, uint32_t width, uint32_t height,
                             const KitWindowShell *shell) {
  KitWindow *const window = calloc(1, sizeof *window);
  if (!window) return NULL;
  window->shell = *shell;
  window->picture.speed = FIRST_SPEED;
  window->width = width;
  window->height = height;
  window->dragged = KIT_KNOB_COUNT;
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

void kit_window_destroy(KitWindow *window) {
  if (!window) return;
  release(window);
  x11_window_destroy(window->outside);
  free(window);
}

unsigned long kit_window_id(const KitWindow *window) { return x11_window_id(window->outside); }

void kit_window_show(KitWindow *window, bool shown) { x11_window_show(window->outside, shown); }

void kit_window_resize(KitWindow *window, uint32_t width, uint32_t height) {
  window->width = width;
  window->height = height;
  x11_window_resize(window->outside, width, height);
}

void kit_window_update(KitWindow *window) {
  x11_window_take_events(window->outside);
  look(window);
  x11_window_draw(window->outside);
}
