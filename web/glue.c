/* SPDX-License-Identifier: MIT */
/**
 * @file glue.c
 * A drum in its room for a web page: what JavaScript calls of the engine as WebAssembly (docs/web.md).
 *
 * A worker creates the drum, and copies its memory to an instance on the audio thread. So all that a
 * drum consists of lies in memory, and addresses mean the same in both.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tabor/tabor.h"

enum { BLOCK = 128, MOST_EVENTS = 64, CHANNELS = 2 };
enum { PICTURES = 4, WIRE_POINTS = 17, PICTURE_STICKS = 4, STICK_VALUES = 4 };

/* Of a picture: two heads on 16 by 48 places, the heights of 40 wires and the forces on them, and sticks. */
enum {
  MOST_PLACES = 2 * 16 * 48,
  MOST_POINTS = 2 * TABOR_MAX_WIRES * WIRE_POINTS,
  MOST_VALUES = MOST_PLACES + MOST_POINTS + 1 + PICTURE_STICKS * STICK_VALUES
};

static const double gain_db = 12; /* of a pair of microphones, as `tabor render --stereo` has it */

#define EXPORT(name) __attribute__((export_name(name)))
#define IMPORT(name) __attribute__((import_module("tabor"), import_name(name)))

/** A drum in a room, heard by its microphones left and right: what `tabor render --stereo` plays. */
typedef struct WebDrum {
  TaborModel *model;
  TaborDrum *drum;
  TaborRoom *room;
  TaborModelInfo info;
  TaborError error;
  uint32_t event_count;
  TaborEvent events[MOST_EVENTS];
  uint32_t mics[CHANNELS];
  float sound[CHANNELS][BLOCK];
  TaborLedger ledger;
  float wet[CHANNELS][BLOCK]; /**< what the room sends to the microphones */
  TaborView *view;
  float pictures[PICTURES * MOST_VALUES]; /**< of the last block, one after the other */
} WebDrum;

/* Hears how far a model is, 0 to 1. */
IMPORT("progress") void report_progress(double done);

/* ---- presets -------------------------------------------------------------------------------- */

EXPORT("preset_count") uint32_t web_preset_count(void) { return tabor_preset_count(); }

EXPORT("preset_name") const char *web_preset_name(uint32_t index) {
  return tabor_preset(index)->name;
}

EXPORT("preset_comment") const char *web_preset_comment(uint32_t index) {
  return tabor_preset(index)->comment;
}

/* ---- the drum ------------------------------------------------------------------------------- */

static bool pass_progress(double done, void *context) {
  (void)context;
  report_progress(done);
  return true;
}

static TaborStatus build_model(WebDrum *web, const TaborDrumDef *def, uint32_t quality,
                               double rate) {
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.sample_rate = rate;
  options.quality = quality;
  options.progress = pass_progress;
  return tabor_model_create(def, &options, &web->model, &web->error);
}

/* An event at the beginning of the next block; false if there are too many. */
static bool add_event(WebDrum *web, const TaborEvent *event) {
  if (web->event_count == MOST_EVENTS) return false;
  web->events[web->event_count++] = *event;
  return true;
}

static void add_gain(WebDrum *web) {
  const TaborEvent event = {.type = TABOR_EVENT_GAIN, .value = pow(10, gain_db / 20)};
  (void)add_event(web, &event);
}

/* All presets have both. A preset's booth is that of its close microphones. */
static void choose_pair(WebDrum *web, TaborDrumDef *def) {
  web->mics[0] = (uint32_t)tabor_drum_def_find_mic(def, "left");
  web->mics[1] = (uint32_t)tabor_drum_def_find_mic(def, "right");
  if (def->room.kind == TABOR_ROOM_NONE || def->room.kind == TABOR_ROOM_BOOTH) {
    def->room.kind = TABOR_ROOM_STUDIO;
  }
}

static TaborStatus build_view(WebDrum *web) {
  const TaborViewGrid grid = {.radii = 16, .angles = 48, .wire_points = WIRE_POINTS};
  return tabor_view_create(web->model, &grid, &web->view, &web->error);
}

static TaborStatus build(WebDrum *web, const char *preset, uint32_t quality, double rate) {
  TaborDrumDef def;
  TaborError *const error = &web->error;
  TaborStatus status = tabor_drum_def_preset(&def, preset, error);
  if (status != TABOR_OK) return status;
  choose_pair(web, &def);
  status = build_model(web, &def, quality, rate);
  if (status == TABOR_OK) status = tabor_drum_create(web->model, &web->drum, error);
  if (status == TABOR_OK) status = tabor_room_create(&def, rate, NULL, &web->room, error);
  if (status == TABOR_OK) status = build_view(web);
  if (status != TABOR_OK) return status;
  tabor_model_info(web->model, &web->info);
  add_gain(web);
  return TABOR_OK;
}

/* NULL if there is no memory. Any other error is in drum_error(). */
EXPORT("drum_create")
WebDrum *web_drum_create(const char *preset, uint32_t quality, double rate) {
  WebDrum *const web = calloc(1, sizeof *web);
  if (web) web->error.status = build(web, preset, quality, rate);
  return web;
}

/* One line for a person; "" if the drum was created. */
EXPORT("drum_error") const char *web_drum_error(const WebDrum *web) {
  return web->error.status == TABOR_OK ? "" : web->error.message;
}

EXPORT("drum_destroy") void web_drum_destroy(WebDrum *web) {
  if (!web) return;
  tabor_view_destroy(web->view);
  tabor_room_destroy(web->room);
  tabor_drum_destroy(web->drum);
  tabor_model_release(web->model);
  free(web);
}

/* As if it had just been created. */
EXPORT("drum_reset") void web_drum_reset(WebDrum *web) {
  web->event_count = 0;
  tabor_drum_reset(web->drum);
  tabor_room_reset(web->room);
  add_gain(web);
}

/* ---- facts ---------------------------------------------------------------------------------- */

/* A number of the definition, such as "shell.radius"; 0 if the drum has no such part. */
EXPORT("drum_number") double web_drum_number(const WebDrum *web, const char *key) {
  char text[TABOR_TEXT_SIZE] = "";
  const TaborDrumDef *const def = tabor_model_definition(web->model);
  (void)tabor_drum_def_get(def, key, text, sizeof text, NULL);
  return strtod(text, NULL);
}

EXPORT("drum_mode_count") uint32_t web_drum_mode_count(const WebDrum *web) {
  return web->info.mode_count + web->info.high_mode_count;
}

/* ---- pictures ------------------------------------------------------------------------------- */

static uint32_t places(const WebDrum *web) { return web->view->radii * web->view->angles; }

static uint32_t points(const WebDrum *web) {
  return web->view->wire_count * web->view->wire_points;
}

/* Heads, circles, angles, wires, points of a wire; sticks at most, and the numbers of each; which head has the wires. */
EXPORT("picture_shape") uint32_t web_picture_shape(const WebDrum *web, uint32_t index) {
  const TaborView *view = web->view;
  const uint32_t head = tabor_model_definition(web->model)->wires.head;
  const uint32_t shape[] = {view->heads, view->radii,    view->angles, view->wire_count,
                            WIRE_POINTS, PICTURE_STICKS, STICK_VALUES, head};
  return index < sizeof shape / sizeof *shape ? shape[index] : 0;
}

/* Numbers of a picture: heights of the heads [m], heights of the wires [m], forces on them [N]; how many sticks, and
 * of each radius [m], angle [deg], height [m] and 1 on the hoop, 0 on the head. */
EXPORT("picture_size") uint32_t web_picture_size(const WebDrum *web) {
  return web->view->heads * places(web) + 2 * points(web) + 1 + PICTURE_STICKS * STICK_VALUES;
}

/* Four numbers for each wire: x and y of one end, x and y of the other [m]. */
EXPORT("wire_places") const double *web_wire_places(const WebDrum *web) {
  return web->view->wire_place;
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

static void take_picture(WebDrum *web, float *to) {
  if (!tabor_drum_view(web->drum, web->view)) return;
  for (uint32_t h = 0; h < web->view->heads; h++) {
    to = put(to, web->view->displacement[h], places(web));
  }
  to = put(to, web->view->wires, points(web));
  to = put(to, web->view->wire_force, points(web));
  put_sticks(to, web->view);
}

/* The pictures of the last block, if it was filmed. */
EXPORT("drum_pictures") const float *web_drum_pictures(const WebDrum *web) { return web->pictures; }

/* ---- on the audio thread -------------------------------------------------------------------- */

/* A stroke of the preset's own striker, @p radius [m] from the centre. */
EXPORT("drum_strike")
bool web_drum_strike(WebDrum *web, double velocity, double radius, double angle,
                     uint32_t technique) {
  const TaborDrumDef *const def = tabor_model_definition(web->model);
  const int striker = tabor_drum_def_find_striker(def, def->strike.striker);
  const TaborEvent event = {.type = TABOR_EVENT_STRIKE,
                            .striker = striker < 0 ? 0 : (uint32_t)striker,
                            .technique = technique,
                            .velocity = velocity,
                            .radius = radius,
                            .angle = angle};
  return add_event(web, &event);
}

/* Puts the snares on the head, 1, or off it, 0. */
EXPORT("drum_set_strainer") bool web_drum_set_strainer(WebDrum *web, double strainer) {
  const TaborParameter *const parameter = tabor_parameter_find("wires.strainer");
  const TaborEvent event = {
    .type = TABOR_EVENT_PARAMETER, .parameter = parameter->id, .value = strainer};
  return add_event(web, &event);
}

static void add_room(WebDrum *web, float *const *outputs) {
  float *wet[TABOR_MAX_MICS] = {NULL};
  memset(web->wet, 0, sizeof web->wet);
  for (uint32_t i = 0; i < CHANNELS; i++) wet[web->mics[i]] = web->wet[i];
  tabor_room_process(web->room, (const float *const *)outputs, wet, BLOCK);
  for (uint32_t i = 0; i < CHANNELS; i++) {
    for (uint32_t n = 0; n < BLOCK; n++) web->sound[i][n] += web->wet[i][n];
  }
}

/* The sound does not depend on the division into blocks. */
static void process_filmed(WebDrum *web, float *const *outputs) {
  enum { FRAMES = BLOCK / PICTURES };
  for (uint32_t i = 0; i < PICTURES; i++) {
    float *part[TABOR_MAX_MICS] = {NULL};
    for (uint32_t k = 0; k < CHANNELS; k++) {
      part[web->mics[k]] = outputs[web->mics[k]] + (size_t)i * FRAMES;
    }
    tabor_drum_process(web->drum, web->events, i == 0 ? web->event_count : 0, part, FRAMES);
    take_picture(web, web->pictures + (size_t)i * web_picture_size(web));
  }
}

/* The next 128 frames of the left channel, then of the right one, until the next call. If the block is @p filmed, there
 * are four pictures of it, one each 32 frames. */
EXPORT("drum_process") const float *web_drum_process(WebDrum *web, uint32_t filmed) {
  float *outputs[TABOR_MAX_MICS] = {NULL};
  for (uint32_t i = 0; i < CHANNELS; i++) outputs[web->mics[i]] = web->sound[i];
  if (filmed) {
    process_filmed(web, outputs);
  } else {
    tabor_drum_process(web->drum, web->events, web->event_count, outputs, BLOCK);
  }
  web->event_count = 0;
  add_room(web, outputs);
  return web->sound[0];
}

/* The energy account [J], as numbers in the order of TaborLedger; until the next call. */
EXPORT("drum_ledger") const TaborLedger *web_drum_ledger(WebDrum *web) {
  tabor_drum_ledger(web->drum, &web->ledger);
  return &web->ledger;
}
