/* SPDX-License-Identifier: MIT */
/**
 * @file picture_glue.c
 * Pictures of a drum that sounds: its heads, its wires and what strikes it; and its modes.
 */
#include <math.h>

#include "glue.h"

static uint32_t places(const TaborView *view) { return view->radii * view->angles; }

static uint32_t points(const TaborView *view) { return view->wire_count * view->wire_points; }

/* Heads, circles, angles, wires, points of a wire; sticks at most, and the numbers of each; which
 * head has the wires. */
EXPORT("picture_shape")
uint32_t web_picture_shape(const WebInstrument *web, uint32_t drum, uint32_t index) {
  const TaborView *const view = web->views[drum];
  const uint32_t head = web_definition(web, drum)->wires.head;
  const uint32_t shape[] = {view->heads, view->radii,    view->angles, view->wire_count,
                            WIRE_POINTS, PICTURE_STICKS, STICK_VALUES, head};
  return index < sizeof shape / sizeof *shape ? shape[index] : 0;
}

/* Numbers of a picture: heights of the heads [m], heights of the wires [m], forces on them [N]; how
 * many sticks, and of each radius [m], angle [deg], height [m] and 1 on the hoop, 0 on the head. */
EXPORT("picture_size") uint32_t web_picture_size(const WebInstrument *web, uint32_t drum) {
  const TaborView *const view = web->views[drum];
  return view->heads * places(view) + 2 * points(view) + 1 + PICTURE_STICKS * STICK_VALUES;
}

/* Four numbers for each wire: x and y of one end, x and y of the other [m]. */
EXPORT("wire_places") const double *web_wire_places(const WebInstrument *web, uint32_t drum) {
  return web->views[drum]->wire_place;
}

static float *put(float *to, const double *values, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) to[i] = (float)values[i];
  return to + count;
}

static void put_sticks(float *to, const TaborView *view) {
  const uint32_t count = view->stick_count < PICTURE_STICKS ? view->stick_count : PICTURE_STICKS;
  *to++ = (float)count;
  for (uint32_t i = 0; i < count; i++) {
    const TaborViewStick *stick = &view->sticks[i];
    const double values[STICK_VALUES] = {stick->radius, stick->angle, stick->height,
                                         stick->on_hoop};
    to = put(to, values, STICK_VALUES);
  }
}

void web_take_picture(WebInstrument *web, float *to) {
  TaborView *const view = web->views[web->filmed];
  if (!tabor_drum_view(web_drum(web, web->filmed), view)) return;
  for (uint32_t h = 0; h < view->heads; h++) to = put(to, view->displacement[h], places(view));
  to = put(to, view->wires, points(view));
  to = put(to, view->wire_force, points(view));
  put_sticks(to, view);
}

/* A mode by its number, in order of frequency: frequency [Hz], time for 60 dB [s], nodal diameters,
 * a TaborModePart, phase; 0 past the last. */
EXPORT("mode_value")
double web_mode_value(const WebInstrument *web, uint32_t drum, uint32_t mode, uint32_t index) {
  TaborModeInfo info;
  if (!tabor_model_mode(web->models[drum], mode, &info)) return 0;
  const double values[] = {info.frequency, log(1000) / info.decay_rate, info.m, info.part,
                           info.phase};
  return index < sizeof values / sizeof *values ? values[index] : 0;
}

/* tabor_model_mode_shape(). */
EXPORT("mode_shape")
double web_mode_shape(const WebInstrument *web, uint32_t drum, uint32_t mode, uint32_t surface,
                      double radius) {
  double shape;
  (void)tabor_model_mode_shape(web->models[drum], mode, surface, radius, &shape);
  return shape;
}

/* The pictures of the block that was filmed last. */
EXPORT("instrument_pictures") const float *web_instrument_pictures(const WebInstrument *web) {
  return web->pictures;
}
