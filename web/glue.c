/* SPDX-License-Identifier: MIT */
/**
 * @file glue.c
 * A drum in its room for JavaScript: what the page and the package for npm call of the engine as WebAssembly
 * (docs/web.md).
 *
 * A drum is first a definition, which drum_create() takes from a preset and drum_set() changes; drum_build()
 * then makes it sound. In the page a worker does this, and copies its memory to an instance on the audio
 * thread. So all that a drum consists of lies in memory, and addresses mean the same in both.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "glue.h"
#include "kit/song_events.h"

enum { PICTURES = 4, WIRE_POINTS = 17, PICTURE_STICKS = 4, STICK_VALUES = 4 };

/* Of a picture: two heads on 16 by 48 places, the heights of 40 wires and the forces on them, and sticks. */
enum {
  MOST_PLACES = 2 * 16 * 48,
  MOST_POINTS = 2 * TABOR_MAX_WIRES * WIRE_POINTS,
  MOST_VALUES = MOST_PLACES + MOST_POINTS + 1 + PICTURE_STICKS * STICK_VALUES
};

static const double gain_db = 12; /* of a pair of microphones, as `tabor render --stereo` has it */

/** A drum in a room, heard by its microphones left and right, as `tabor render --stereo` plays it, or by chosen ones,
 * as with --mic. */
typedef struct WebDrum {
  TaborDrumDef def;    /**< before it is built */
  bool is_room_chosen; /**< by drum_set() */
  uint32_t channels;   /**< 0 before it is built, unless microphones are chosen */
  bool is_pair;        /**< no microphones are chosen */
  TaborModel *model;
  TaborDrum *drum;
  TaborRoom *room;
  TaborModelInfo info;
  TaborError error;
  uint32_t event_count;
  TaborEvent events[MOST_EVENTS];
  uint32_t mics[TABOR_MAX_MICS]; /**< of the channels */
  float sound[TABOR_MAX_MICS][BLOCK];
  TaborLedger ledger;
  float feed[2][BLOCK];             /**< what the room hears by microphones that are no channels */
  float wet[TABOR_MAX_MICS][BLOCK]; /**< what the room sends to the microphones */
  char text[TABOR_TEXT_SIZE];       /**< for JavaScript, until the next call */
  TaborView *view;
  float pictures[PICTURES * MOST_VALUES]; /**< of the last block, one after the other */
  MidiMap map;
  MidiToEvents midi;
  WebMidiAction midi_action;
} WebDrum;

/* ---- presets -------------------------------------------------------------------------------- */

EXPORT("version") const char *web_version(void) { return tabor_version(); }

EXPORT("preset_count") uint32_t web_preset_count(void) { return tabor_preset_count(); }

EXPORT("preset_name") const char *web_preset_name(uint32_t index) {
  return tabor_preset(index)->name;
}

EXPORT("preset_comment") const char *web_preset_comment(uint32_t index) {
  return tabor_preset(index)->comment;
}

/* ---- definition ----------------------------------------------------------------------------- */

static const TaborDrumDef *definition(const WebDrum *web) {
  return web->model ? tabor_model_definition(web->model) : &web->def;
}

/* NULL if there is no memory. Any other error is in drum_error(). */
EXPORT("drum_create") WebDrum *web_drum_create(const char *preset) {
  WebDrum *const web = calloc(1, sizeof *web);
  if (web) web->error.status = tabor_drum_def_preset(&web->def, preset, &web->error);
  return web;
}

/* Before drum_build(). False with an error; the definition is then as before. */
EXPORT("drum_set") bool web_drum_set(WebDrum *web, const char *key, const char *value) {
  web->error.status = tabor_drum_def_set(&web->def, key, value, &web->error);
  if (web->error.status != TABOR_OK) return false;
  if (strcmp(key, "room.kind") == 0) web->is_room_chosen = true;
  return true;
}

/* Another channel, in place of the pair. False if the drum has no such microphone, or all channels are taken. */
EXPORT("drum_add_mic") bool web_drum_add_mic(WebDrum *web, const char *name) {
  const int mic = tabor_drum_def_find_mic(&web->def, name);
  if (mic < 0 || web->channels == TABOR_MAX_MICS) return false;
  for (uint32_t i = 0; i < web->channels; i++) {
    if (web->mics[i] == (uint32_t)mic) return false;
  }
  web->mics[web->channels++] = (uint32_t)mic;
  return true;
}

/* One line for a person; "" if there is none. */
EXPORT("drum_error") const char *web_drum_error(const WebDrum *web) {
  return web->error.status == TABOR_OK ? "" : web->error.message;
}

EXPORT("drum_error_key") const char *web_drum_error_key(const WebDrum *web) {
  return web->error.key;
}

EXPORT("drum_error_value") const char *web_drum_error_value(const WebDrum *web) {
  return web->error.value;
}

/* Least, 0, or greatest, 1, allowed value; NaN where no range applies. */
EXPORT("drum_error_bound") double web_drum_error_bound(const WebDrum *web, uint32_t which) {
  return which == 0 ? web->error.minimum : web->error.maximum;
}

/* Key @p index; "" past the last. */
EXPORT("drum_key") const char *web_drum_key(WebDrum *web, uint32_t index) {
  if (!tabor_drum_def_key(definition(web), index, web->text, sizeof web->text)) return "";
  return web->text;
}

/* The value of a key; "" with an error if the drum has no such part. */
EXPORT("drum_text") const char *web_drum_text(WebDrum *web, const char *key) {
  web->text[0] = '\0';
  web->error.status =
    tabor_drum_def_get(definition(web), key, web->text, sizeof web->text, &web->error);
  return web->text;
}

/* For the functions of definition_glue.c; another one once it is built. */
EXPORT("drum_definition") const TaborDrumDef *web_drum_definition(const WebDrum *web) {
  return definition(web);
}

/* Begins to play MIDI on the drum as it is defined now, by the default map of docs/midi.md. */
EXPORT("drum_begin_midi") void web_drum_begin_midi(WebDrum *web) {
  MidiBinding binding;
  midi_map_default(&web->map);
  midi_binding_make(&web->map, definition(web), &binding);
  midi_to_events_begin(&web->midi, &web->map, &binding);
}

/* What a message does, until the next call. It does not act on the drum. */
EXPORT("drum_take_midi")
const WebMidiAction *web_drum_take_midi(WebDrum *web, uint32_t status, uint32_t first,
                                        uint32_t second) {
  const MidiMessage message = web_midi_message(status, first, second);
  MidiAction actions[MIDI_MOST_ACTIONS];
  const uint32_t count = midi_to_events_take(&web->midi, &message, actions);
  web->midi_action = (WebMidiAction){.kind = WEB_MIDI_NOTHING};
  if (count > 0 && actions[0].type == MIDI_ACTION_EVENT)
    web->midi_action = web_midi_action(0, &actions[0].event);
  return &web->midi_action;
}

/* Makes a file's events of the drum as it is defined now. False without memory, or with song_error(). */
EXPORT("drum_compose")
bool web_drum_compose(const WebDrum *web, SongEvents *song, double rate) {
  return song_events_of_drum(song, definition(web), false, -1, rate);
}

/* NULL past the last. */
EXPORT("mic_name") const char *web_mic_name(const WebDrum *web, uint32_t index) {
  return index < web->def.mic_count ? web->def.mic[index].name : NULL;
}

/* ---- the drum ------------------------------------------------------------------------------- */

static bool pass_progress(double done, void *context) {
  (void)context;
  return report_progress(done);
}

static TaborStatus build_model(WebDrum *web, uint32_t quality, double rate, WebLimit most) {
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.sample_rate = rate;
  options.quality = quality;
  options.progress = pass_progress;
  options.most_seconds = most.seconds;
  options.most_bytes = (size_t)most.bytes;
  return tabor_model_create(&web->def, &options, &web->model, &web->error);
}

/* False if there are too many for a block. */
static bool add_event(WebDrum *web, const TaborEvent *event) {
  if (web->event_count == MOST_EVENTS) return false;
  web->events[web->event_count++] = *event;
  return true;
}

static void add_gain(WebDrum *web) {
  const TaborEvent event = {.type = TABOR_EVENT_GAIN, .value = pow(10, gain_db / 20)};
  if (web->is_pair) (void)add_event(web, &event);
}

/* All presets have both. */
static void choose_pair(WebDrum *web) {
  TaborRoomDef *const room = &web->def.room;
  web->is_pair = true;
  web->channels = 2;
  web->mics[0] = (uint32_t)tabor_drum_def_find_mic(&web->def, "left");
  web->mics[1] = (uint32_t)tabor_drum_def_find_mic(&web->def, "right");
  if (room->kind == TABOR_ROOM_NONE && !web->is_room_chosen) room->kind = TABOR_ROOM_STUDIO;
}

static TaborStatus build_view(WebDrum *web) {
  const TaborViewGrid grid = {.radii = 16, .angles = 48, .wire_points = WIRE_POINTS};
  return tabor_view_create(web->model, &grid, &web->view, &web->error);
}

static TaborStatus build(WebDrum *web, uint32_t quality, double rate, WebLimit most) {
  TaborError *const error = &web->error;
  if (web->channels == 0) choose_pair(web);
  TaborStatus status = build_model(web, quality, rate, most);
  if (status == TABOR_OK) status = tabor_drum_create(web->model, &web->drum, error);
  if (status == TABOR_OK) status = tabor_room_create(&web->def, rate, NULL, &web->room, error);
  if (status == TABOR_OK) status = build_view(web);
  if (status != TABOR_OK) return status;
  tabor_model_info(web->model, &web->info);
  add_gain(web);
  return TABOR_OK;
}

/* Once. False with an error, also if the model takes more than is allowed; 0 is no limit. */
EXPORT("drum_build")
bool web_drum_build(WebDrum *web, uint32_t quality, double rate, double most_seconds,
                    double most_bytes) {
  const WebLimit most = {most_seconds, most_bytes};
  web->error.status = build(web, quality, rate, most);
  return web->error.status == TABOR_OK;
}

EXPORT("drum_destroy") void web_drum_destroy(WebDrum *web) {
  if (!web) return;
  tabor_view_destroy(web->view);
  tabor_room_destroy(web->room);
  tabor_drum_destroy(web->drum);
  tabor_model_release(web->model);
  free(web);
}

/* As if it had just been built. */
EXPORT("drum_reset") void web_drum_reset(WebDrum *web) {
  web->event_count = 0;
  tabor_drum_reset(web->drum);
  tabor_room_reset(web->room);
  add_gain(web);
}

EXPORT("drum_channels") uint32_t web_drum_channels(const WebDrum *web) { return web->channels; }

/* The microphone of a channel. */
EXPORT("drum_mic") uint32_t web_drum_mic(const WebDrum *web, uint32_t channel) {
  return web->mics[channel];
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
  const uint32_t head = definition(web)->wires.head;
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

/* A stroke at a frame of the next block, @p radius [m] from the centre. A @p striker below 0 is the definition's own. */
EXPORT("drum_strike")
bool web_drum_strike(WebDrum *web, uint32_t frame, double velocity, double radius, double angle,
                     uint32_t technique, int32_t striker) {
  const uint32_t own = web_definition_own_striker(definition(web));
  const TaborEvent event = {.type = TABOR_EVENT_STRIKE,
                            .frame = frame,
                            .striker = striker < 0 ? own : (uint32_t)striker,
                            .technique = technique,
                            .velocity = velocity,
                            .radius = radius,
                            .angle = angle};
  return add_event(web, &event);
}

/* The number of a parameter that may change while the drum rings; 0 if there is none. */
EXPORT("live_parameter") uint32_t web_live_parameter(const char *key) {
  const TaborParameter *const parameter = tabor_parameter_find(key);
  return parameter && parameter->live ? parameter->id : 0;
}

/* Least, 0, or greatest, 1, value of a live parameter. */
EXPORT("parameter_bound") double web_parameter_bound(uint32_t id, uint32_t which) {
  const TaborParameter *parameter;
  for (uint32_t i = 0; (parameter = tabor_parameter(i)) != NULL; i++) {
    if (parameter->id == id) return which == 0 ? parameter->minimum : parameter->maximum;
  }
  return NAN;
}

/* Moves a live parameter at a frame of the next block; one of a microphone's has its @p index. */
EXPORT("drum_change")
bool web_drum_change(WebDrum *web, uint32_t frame, uint32_t parameter, uint32_t index,
                     double value) {
  const TaborEvent event = {.type = TABOR_EVENT_PARAMETER,
                            .frame = frame,
                            .parameter = parameter,
                            .index = index,
                            .value = value};
  return add_event(web, &event);
}

/* Puts the snares on the head, 1, or off it, 0. */
EXPORT("drum_set_strainer") bool web_drum_set_strainer(WebDrum *web, double strainer) {
  return web_drum_change(web, 0, web_live_parameter("wires.strainer"), 0, strainer);
}

/* The room also hears microphones that are no channels. */
static void connect_feeds(WebDrum *web, float **outputs) {
  TaborRoomInfo info;
  tabor_room_info(web->room, &info);
  if (info.kind == TABOR_ROOM_NONE) return;
  for (uint32_t i = 0; i < 2; i++) {
    if (!outputs[info.feed[i]]) outputs[info.feed[i]] = web->feed[i];
  }
}

static void connect(WebDrum *web, float **outputs) {
  for (uint32_t i = 0; i < web->channels; i++) outputs[web->mics[i]] = web->sound[i];
  connect_feeds(web, outputs);
}

static void add_room(WebDrum *web, float *const *outputs, uint32_t frames) {
  float *wet[TABOR_MAX_MICS] = {NULL};
  memset(web->wet, 0, sizeof web->wet);
  for (uint32_t i = 0; i < web->channels; i++) wet[web->mics[i]] = web->wet[i];
  tabor_room_process(web->room, (const float *const *)outputs, wet, frames);
  for (uint32_t i = 0; i < web->channels; i++) {
    for (uint32_t n = 0; n < frames; n++) web->sound[i][n] += web->wet[i][n];
  }
}

/* The sound does not depend on the division into blocks. All events of the page are at frame 0. */
static void process_filmed(WebDrum *web, float *const *outputs) {
  enum { FRAMES = BLOCK / PICTURES };
  for (uint32_t i = 0; i < PICTURES; i++) {
    float *part[TABOR_MAX_MICS] = {NULL};
    for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) {
      if (outputs[mic]) part[mic] = outputs[mic] + (size_t)i * FRAMES;
    }
    tabor_drum_process(web->drum, web->events, i == 0 ? web->event_count : 0, part, FRAMES);
    take_picture(web, web->pictures + (size_t)i * web_picture_size(web));
  }
}

static void process(WebDrum *web, uint32_t frames, bool filmed) {
  float *outputs[TABOR_MAX_MICS] = {NULL};
  connect(web, outputs);
  if (filmed) {
    process_filmed(web, outputs);
  } else {
    tabor_drum_process(web->drum, web->events, web->event_count, outputs, frames);
  }
  web->event_count = 0;
  add_room(web, outputs, frames);
}

/* The next frames, at most 128, of the first channel; each further channel begins 128 frames after the one before.
 * They stay until the next call. */
EXPORT("drum_play") const float *web_drum_play(WebDrum *web, uint32_t frames) {
  process(web, frames, false);
  return web->sound[0];
}

/* The next 128 frames in the same way. If the block is @p filmed, there are four pictures of it, one each 32 frames. */
EXPORT("drum_process") const float *web_drum_process(WebDrum *web, uint32_t filmed) {
  process(web, BLOCK, filmed);
  return web->sound[0];
}

/* The energy account [J], as numbers in the order of TaborLedger; until the next call. */
EXPORT("drum_ledger") const TaborLedger *web_drum_ledger(WebDrum *web) {
  tabor_drum_ledger(web->drum, &web->ledger);
  return &web->ledger;
}

/* Events that the engine did not carry out (TaborStatistics). */
EXPORT("drum_dropped_events") double web_drum_dropped_events(const WebDrum *web) {
  TaborStatistics statistics;
  tabor_drum_statistics(web->drum, &statistics);
  return (double)statistics.dropped_events;
}

/* Everything has died away, but perhaps in the room. */
EXPORT("drum_is_silent") bool web_drum_is_silent(const WebDrum *web) {
  return tabor_drum_is_silent(web->drum);
}

/* Energy of what the room holds, of no unit; 0 if it is silent. */
EXPORT("room_energy") double web_room_energy(const WebDrum *web) {
  return tabor_room_energy(web->room);
}
