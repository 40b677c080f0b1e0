/* SPDX-License-Identifier: MIT */
/**
 * @file kit_glue.c
 * A kit for JavaScript: what the page calls of the engine as WebAssembly (docs/web.md), as glue.c has it for a drum.
 *
 * A kit is first a definition, which kit_create() takes from a built-in kit and kit_set() changes; kit_build() then makes
 * it sound. It plays its mix, as `tabor render --kit`.
 */
#include <math.h>
#include <stdlib.h>

#include "glue.h"
#include "kit/kit_midi.h"
#include "kit/song_events.h"
#include "tabor/kit.h"

typedef struct WebKit {
  TaborKitDef def;
  TaborKit *kit; /**< NULL before it is built */
  uint32_t building, modes;
  TaborError error;
  uint32_t event_count;
  TaborKitEvent events[MOST_EVENTS];
  float sound[2][BLOCK];
  TaborLedger ledger;
  KitMidi *midi; /**< NULL before kit_begin_midi() */
  WebMidiAction midi_action;
} WebKit;

/* ---- built-in kits -------------------------------------------------------------------------- */

EXPORT("kit_count") uint32_t web_kit_count(void) { return tabor_kit_count(); }

EXPORT("kit_name") const char *web_kit_name(uint32_t index) { return tabor_kit(index)->name; }

EXPORT("kit_comment") const char *web_kit_comment(uint32_t index) {
  return tabor_kit(index)->comment;
}

/* ---- definition ----------------------------------------------------------------------------- */

/* NULL if there is no memory. Any other error is in kit_error(). */
EXPORT("kit_create") WebKit *web_kit_create(const char *name) {
  WebKit *const web = calloc(1, sizeof *web);
  if (web) web->error.status = tabor_kit_def_preset(&web->def, name, &web->error);
  return web;
}

/* Before kit_build(). False with an error; the definition is then as before. */
EXPORT("kit_set") bool web_kit_set(WebKit *web, const char *key, const char *value) {
  web->error.status = tabor_kit_def_set(&web->def, key, value, &web->error);
  return web->error.status == TABOR_OK;
}

/* One line for a person; "" if there is none. */
EXPORT("kit_error") const char *web_kit_error(const WebKit *web) {
  return web->error.status == TABOR_OK ? "" : web->error.message;
}

EXPORT("kit_drum_count") uint32_t web_kit_drum_count(const WebKit *web) {
  return web->def.drum_count;
}

EXPORT("kit_drum_name") const char *web_kit_drum_name(const WebKit *web, uint32_t drum) {
  return web->def.drum[drum].name;
}

/* For the functions of definition_glue.c. */
EXPORT("kit_definition") const TaborDrumDef *web_kit_definition(const WebKit *web, uint32_t drum) {
  return &web->def.drum[drum].def;
}

/* Where a drum stands [m]: 0, to the player's right; 1, away from the player; 2, above the floor. */
EXPORT("kit_drum_place")
double web_kit_drum_place(const WebKit *web, uint32_t drum, uint32_t axis) {
  const TaborKitDrumDef *const def = &web->def.drum[drum];
  const double place[] = {def->x, def->y, def->height};
  return place[axis];
}

/* What a MIDI note does to a drum: a TaborKitStroke. */
EXPORT("kit_stroke") uint32_t web_kit_stroke(const WebKit *web, uint32_t drum, uint32_t note) {
  return web->def.drum[drum].notes[note];
}

/* ---- MIDI ----------------------------------------------------------------------------------- */

/* Begins to play MIDI on the kit as it is defined now. False if there is no memory. */
EXPORT("kit_begin_midi") bool web_kit_begin_midi(WebKit *web) {
  if (!web->midi) web->midi = malloc(sizeof *web->midi);
  if (web->midi) kit_midi_begin(web->midi, &web->def, &kit_midi_setup_default);
  return web->midi != NULL;
}

/* What a message does, until the next call. It does not act on the kit. A controller that moves several drums' snares
 * moves them alike: the first one tells. */
EXPORT("kit_take_midi")
const WebMidiAction *web_kit_take_midi(WebKit *web, uint32_t status, uint32_t first,
                                       uint32_t second) {
  const MidiMessage message = web_midi_message(status, first, second);
  TaborKitEvent events[KIT_MIDI_MOST_EVENTS];
  const uint32_t count = kit_midi_take(web->midi, &message, events);
  web->midi_action = (WebMidiAction){.kind = WEB_MIDI_NOTHING};
  if (count > 0) web->midi_action = web_midi_action(events[0].drum, &events[0].event);
  return &web->midi_action;
}

/* Makes a file's events of the kit as it is defined now. False without memory, or with song_error(). */
EXPORT("kit_compose") bool web_kit_compose(const WebKit *web, SongEvents *song, double rate) {
  return song_events_of_kit(song, &web->def, -1, 0, 0, rate);
}

/* The velocity at which a note plays nearest to a speed [m/s], as a ratio. */
EXPORT("kit_velocity")
uint32_t web_kit_velocity(WebKit *web, uint32_t note, double speed) {
  uint32_t nearest = 1;
  double least = INFINITY;
  for (uint32_t velocity = 1; velocity < MIDI_VALUES; velocity++) {
    const double played = web_kit_take_midi(web, MIDI_NOTE_ON, note, velocity)->value;
    const double off = fmax(played / speed, speed / played);
    if (off < least) {
      least = off;
      nearest = velocity;
    }
  }
  return nearest;
}

/* Before it is built. */
EXPORT("kit_destroy") void web_kit_destroy(WebKit *web) {
  if (!web) return;
  free(web->midi);
  free(web);
}

/* ---- the kit -------------------------------------------------------------------------------- */

static bool pass_progress(double done, void *context) {
  const WebKit *const web = context;
  return report_progress((web->building + done) / web->def.drum_count);
}

static TaborStatus build_model(WebKit *web, uint32_t quality, double rate, WebLimit most,
                               TaborModel **model) {
  TaborModelOptions options;
  TaborDrumDef placed;
  TaborModelInfo info;
  tabor_model_options_default(&options);
  options.sample_rate = rate;
  options.quality = quality;
  options.progress = pass_progress;
  options.most_seconds = most.seconds;
  options.most_bytes = (size_t)most.bytes;
  options.progress_context = web;
  TaborStatus status = tabor_kit_def_place(&web->def, web->building, &placed, &web->error);
  if (status == TABOR_OK) status = tabor_model_create(&placed, &options, model, &web->error);
  if (status != TABOR_OK) return status;
  tabor_model_info(*model, &info);
  web->modes += info.mode_count + info.high_mode_count;
  return TABOR_OK;
}

/* Once. False with an error, also if a drum's model takes more than is allowed. */
EXPORT("kit_build")
bool web_kit_build(WebKit *web, uint32_t quality, double rate, double most_seconds,
                   double most_bytes) {
  const WebLimit most = {most_seconds, most_bytes};
  TaborModel *models[TABOR_KIT_DRUMS] = {NULL};
  TaborStatus status = tabor_kit_def_validate(&web->def, &web->error);
  for (; status == TABOR_OK && web->building < web->def.drum_count; web->building++) {
    status = build_model(web, quality, rate, most, &models[web->building]);
  }
  if (status == TABOR_OK) status = tabor_kit_create(&web->def, models, &web->kit, &web->error);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) tabor_model_release(models[i]);
  web->error.status = status;
  return status == TABOR_OK;
}

EXPORT("kit_mode_count") uint32_t web_kit_mode_count(const WebKit *web) { return web->modes; }

/* As if it had just been built. */
EXPORT("kit_reset") void web_kit_reset(WebKit *web) {
  web->event_count = 0;
  tabor_kit_reset(web->kit);
}

/* ---- on the audio thread -------------------------------------------------------------------- */

/* False if there are too many for a block. */
static bool add_event(WebKit *web, uint32_t drum, const TaborEvent *event) {
  if (web->event_count == MOST_EVENTS) return false;
  web->events[web->event_count++] = (TaborKitEvent){.drum = drum, .event = *event};
  return true;
}

/* A stroke at the beginning of the next block, with the drum's own stick, @p radius [m] from the centre. */
EXPORT("kit_strike")
bool web_kit_strike(WebKit *web, uint32_t drum, double velocity, double radius, double angle,
                    uint32_t technique) {
  if (drum >= web->def.drum_count) return false;
  const TaborEvent event = {.type = TABOR_EVENT_STRIKE,
                            .striker = web_definition_own_striker(&web->def.drum[drum].def),
                            .technique = technique,
                            .velocity = velocity,
                            .radius = radius,
                            .angle = angle};
  return add_event(web, drum, &event);
}

/* Puts the snares of all drums that have some on the head, 1, or off it, 0. */
EXPORT("kit_set_strainer") void web_kit_set_strainer(WebKit *web, double strainer) {
  const TaborEvent event = {.type = TABOR_EVENT_PARAMETER,
                            .parameter = tabor_parameter_find("wires.strainer")->id,
                            .value = strainer};
  for (uint32_t i = 0; i < web->def.drum_count; i++) {
    if (web->def.drum[i].def.wires.count > 0) (void)add_event(web, i, &event);
  }
}

/* The next 128 frames of the mix, left; right begins 128 frames later. They stay until the next call. */
EXPORT("kit_process") const float *web_kit_process(WebKit *web) {
  const TaborKitOutputs outputs = {.stereo = {web->sound[0], web->sound[1]}};
  tabor_kit_process(web->kit, web->events, web->event_count, &outputs, BLOCK);
  web->event_count = 0;
  return web->sound[0];
}

/* The drums' energy accounts in one [J], as numbers in the order of TaborLedger; until the next call. */
EXPORT("kit_ledger") const TaborLedger *web_kit_ledger(WebKit *web) {
  double *const sums = (double *)&web->ledger;
  for (size_t i = 0; i < sizeof web->ledger / sizeof *sums; i++) sums[i] = 0;
  for (uint32_t drum = 0; drum < web->def.drum_count; drum++) {
    TaborLedger ledger;
    tabor_drum_ledger(tabor_kit_drum(web->kit, drum), &ledger);
    for (size_t i = 0; i < sizeof ledger / sizeof *sums; i++) sums[i] += ((double *)&ledger)[i];
  }
  return &web->ledger;
}
