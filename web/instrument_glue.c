/* SPDX-License-Identifier: MIT */
/**
 * @file instrument_glue.c
 * Presets, and what an instrument is: its definition, before and after it is built.
 */
#include <stdlib.h>
#include <string.h>

#include "glue.h"

/* ---- presets -------------------------------------------------------------------------------- */

EXPORT("version") const char *web_version(void) { return tabor_version(); }

EXPORT("preset_count") uint32_t web_preset_count(void) { return tabor_preset_count(); }

EXPORT("preset_name") const char *web_preset_name(uint32_t index) {
  return tabor_preset(index)->name;
}

EXPORT("preset_comment") const char *web_preset_comment(uint32_t index) {
  return tabor_preset(index)->comment;
}

EXPORT("preset_category") const char *web_preset_category(uint32_t index) {
  return tabor_preset(index)->category;
}

EXPORT("kit_count") uint32_t web_kit_count(void) { return tabor_kit_count(); }

EXPORT("kit_name") const char *web_kit_name(uint32_t index) { return tabor_kit(index)->name; }

EXPORT("kit_comment") const char *web_kit_comment(uint32_t index) {
  return tabor_kit(index)->comment;
}

/* ---- definition ----------------------------------------------------------------------------- */

static TaborDrumDef *alone(WebInstrument *web) { return &web->def.drum[0].def; }

const TaborDrumDef *web_definition(const WebInstrument *web, uint32_t drum) {
  if (!web->is_kit && web->models[0]) return tabor_model_definition(web->models[0]);
  return &web->def.drum[drum].def;
}

static TaborStatus load(WebInstrument *web, const char *name) {
  if (web->is_kit) return tabor_kit_def_preset(&web->def, name, &web->error);
  web->def.drum_count = 1;
  return tabor_drum_def_preset(alone(web), name, &web->error);
}

/* A preset, or a built-in kit. NULL if there is no memory; any other error is in
 * instrument_error(). */
EXPORT("instrument_create")
WebInstrument *web_instrument_create(const char *name, uint32_t is_kit) {
  WebInstrument *const web = calloc(1, sizeof *web);
  if (!web) return NULL;
  web->is_kit = is_kit != 0;
  web->error.status = load(web, name);
  return web;
}

/* Before instrument_build(). False with an error; the definition is then as before. */
EXPORT("instrument_set")
bool web_instrument_set(WebInstrument *web, const char *key, const char *value) {
  web->error.status = web->is_kit ? tabor_kit_def_set(&web->def, key, value, &web->error)
                                  : tabor_drum_def_set(alone(web), key, value, &web->error);
  if (web->error.status != TABOR_OK) return false;
  if (strcmp(key, "room.kind") == 0) web->is_room_chosen = true;
  return true;
}

static bool add_channels(WebInstrument *web, int what, uint32_t count) {
  if (what < 0 || web->channels + count > MOST_CHANNELS) return false;
  for (uint32_t i = web->is_kit ? 2 : 0; i < web->channels; i++) {
    if (web->chosen[i] == (uint32_t)what) return false;
  }
  for (uint32_t i = 0; i < count; i++) web->chosen[web->channels++] = (uint32_t)what;
  return true;
}

/* Another microphone of a drum as a channel, in place of the pair; or a drum's part of a kit's mix
 * as two, behind it. False if there is none of the name, or it is a channel already. */
EXPORT("instrument_add_output")
bool web_instrument_add_output(WebInstrument *web, const char *name) {
  if (!web->is_kit) return add_channels(web, tabor_drum_def_find_mic(alone(web), name), 1);
  if (web->channels == 0) web->channels = 2;
  return add_channels(web, tabor_kit_def_find(&web->def, name), 2);
}

/* One line for a person; "" if there is none. */
EXPORT("instrument_error") const char *web_instrument_error(const WebInstrument *web) {
  return web->error.status == TABOR_OK ? "" : web->error.message;
}

EXPORT("instrument_error_key") const char *web_instrument_error_key(const WebInstrument *web) {
  return web->error.key;
}

EXPORT("instrument_error_value") const char *web_instrument_error_value(const WebInstrument *web) {
  return web->error.value;
}

/* Least, 0, or greatest, 1, allowed value; NaN where no range applies. */
EXPORT("instrument_error_bound")
double web_instrument_error_bound(const WebInstrument *web, uint32_t which) {
  return which == 0 ? web->error.minimum : web->error.maximum;
}

/* Key @p index; "" past the last. */
EXPORT("instrument_key") const char *web_instrument_key(WebInstrument *web, uint32_t index) {
  const bool is_there =
    web->is_kit ? tabor_kit_def_key(&web->def, index, web->text, sizeof web->text)
                : tabor_drum_def_key(web_definition(web, 0), index, web->text, sizeof web->text);
  return is_there ? web->text : "";
}

/* The value of a key; "" with an error if there is no such part. */
EXPORT("instrument_text") const char *web_instrument_text(WebInstrument *web, const char *key) {
  char *const text = web->text;
  *text = '\0';
  web->error.status =
    web->is_kit
      ? tabor_kit_def_get(&web->def, key, text, sizeof web->text, &web->error)
      : tabor_drum_def_get(web_definition(web, 0), key, text, sizeof web->text, &web->error);
  return text;
}

/* ---- its drums ------------------------------------------------------------------------------ */

EXPORT("instrument_drum_count") uint32_t web_instrument_drum_count(const WebInstrument *web) {
  return web->def.drum_count;
}

/* NULL past the last. */
EXPORT("instrument_drum_name")
const char *web_instrument_drum_name(const WebInstrument *web, uint32_t drum) {
  return drum < web->def.drum_count ? web->def.drum[drum].name : NULL;
}

/* For the functions of definition_glue.c; of a drum alone another one once it is built. */
EXPORT("instrument_definition")
const TaborDrumDef *web_instrument_definition(const WebInstrument *web, uint32_t drum) {
  return web_definition(web, drum);
}

/* Where a drum stands [m]: 0, to the player's right; 1, away from the player; 2, above the floor.
 */
EXPORT("instrument_drum_place")
double web_instrument_drum_place(const WebInstrument *web, uint32_t drum, uint32_t axis) {
  const TaborKitDrumDef *const def = &web->def.drum[drum];
  const double place[] = {def->x, def->y, def->height};
  return place[axis];
}

/* What a MIDI note does to a drum of a kit: a TaborKitStroke. */
EXPORT("instrument_stroke")
uint32_t web_instrument_stroke(const WebInstrument *web, uint32_t drum, uint32_t note) {
  return web->def.drum[drum].notes[note];
}

/* NULL past the last. */
EXPORT("mic_name") const char *web_mic_name(const WebInstrument *web, uint32_t index) {
  const TaborDrumDef *const def = &web->def.drum[0].def;
  return index < def->mic_count ? def->mic[index].name : NULL;
}

/* ---- its channels --------------------------------------------------------------------------- */

EXPORT("instrument_channels") uint32_t web_instrument_channels(const WebInstrument *web) {
  return web->channels;
}

/* The microphone of a channel, or the drum of one behind a kit's mix. */
EXPORT("instrument_channel")
uint32_t web_instrument_channel(const WebInstrument *web, uint32_t channel) {
  return web->chosen[channel];
}

/* A kit's mix comes first, then the parts of its drums. */
uint32_t web_output(const WebInstrument *web, uint32_t channel) {
  if (!web->is_kit) return web->chosen[channel];
  return channel < 2 ? channel : 2 + 2 * web->chosen[channel] + channel % 2;
}

EXPORT("instrument_mode_count") uint32_t web_instrument_mode_count(const WebInstrument *web) {
  return web->modes;
}
