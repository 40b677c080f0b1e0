/* SPDX-License-Identifier: MIT */
/**
 * @file build_glue.c
 * Models, beginning and end of what sounds.
 */
#include <math.h>
#include <stdlib.h>

#include "glue.h"

static const double gain_db = 12; /* of a pair of microphones, as `tabor render --stereo` has it */

static bool pass_progress(double done, void *context) {
  const WebInstrument *const web = context;
  return report_progress((web->building + done) / web->def.drum_count);
}

/* A kit's drum is built as it stands in the kit. */
static TaborStatus build_model(WebInstrument *web, const TaborModelOptions *options) {
  const uint32_t drum = web->building;
  const TaborViewGrid grid = {.radii = 16, .angles = 48, .wire_points = WIRE_POINTS};
  TaborDrumDef placed = web->def.drum[drum].def;
  TaborModelInfo info;
  TaborStatus status = TABOR_OK;
  if (web->is_kit) status = tabor_kit_def_place(&web->def, drum, &placed, &web->error);
  if (status == TABOR_OK)
    status = tabor_model_create(&placed, options, &web->models[drum], &web->error);
  if (status == TABOR_OK)
    status = tabor_view_create(web->models[drum], &grid, &web->views[drum], &web->error);
  if (status != TABOR_OK) return status;
  tabor_model_info(web->models[drum], &info);
  web->modes += info.mode_count + info.high_mode_count;
  return TABOR_OK;
}

/* All presets have both. */
static void choose_pair(WebInstrument *web) {
  TaborDrumDef *const def = &web->def.drum[0].def;
  web->is_pair = true;
  web->channels = 2;
  web->chosen[0] = (uint32_t)tabor_drum_def_find_mic(def, "left");
  web->chosen[1] = (uint32_t)tabor_drum_def_find_mic(def, "right");
  if (def->room.kind == TABOR_ROOM_NONE && !web->is_room_chosen) def->room.kind = TABOR_ROOM_STUDIO;
}

static TaborStatus begin_kit(WebInstrument *web, double rate) {
  if (web->channels == 0) web->channels = 2;
  const TaborStatus status = tabor_kit_create(&web->def, web->models, &web->kit, &web->error);
  if (status != TABOR_OK) return status;
  drum_player_begin(&web->player, 2 + 2 * web->def.drum_count, 1);
  drum_player_set_kit(&web->player, web->kit, rate);
  for (uint32_t i = 0; i < web->channels; i++)
    web->player.heard |= UINT64_C(1) << web_output(web, i);
  return TABOR_OK;
}

/* All its microphones are outputs. */
static TaborStatus begin_drum(WebInstrument *web, double rate) {
  const TaborDrumDef *const def = &web->def.drum[0].def;
  uint8_t mics[TABOR_MAX_MICS];
  TaborStatus status = tabor_drum_create(web->models[0], &web->drum, &web->error);
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) mics[i] = (uint8_t)i;
  if (status == TABOR_OK)
    status = room_mix_create(&web->room, def, rate, mics, def->mic_count, &web->error);
  if (status != TABOR_OK) return status;
  drum_player_begin(&web->player, def->mic_count, web->is_pair ? pow(10, gain_db / 20) : 1);
  drum_player_set_room(&web->player, &web->room);
  drum_player_set_drum(&web->player, web->drum, def->striker_count);
  for (uint32_t i = 0; i < web->channels; i++)
    web->player.heard |= UINT64_C(1) << web_output(web, i);
  return TABOR_OK;
}

/* Once. False with an error, also if a model takes more than is allowed by its estimate
 * (TaborModelOptions), time [s] on a server of 2024 and memory; 0 is no limit. */
EXPORT("instrument_build")
bool web_instrument_build(WebInstrument *web, uint32_t quality, double rate, double most_seconds,
                          double most_bytes) {
  TaborModelOptions options;
  TaborStatus status = TABOR_OK;
  tabor_model_options_default(&options);
  options.sample_rate = rate;
  options.quality = quality;
  options.most_seconds = most_seconds;
  options.most_bytes = (size_t)most_bytes;
  options.progress = pass_progress;
  options.progress_context = web;
  if (web->is_kit) status = tabor_kit_def_validate(&web->def, &web->error);
  if (!web->is_kit && web->channels == 0) choose_pair(web);
  for (; status == TABOR_OK && web->building < web->def.drum_count; web->building++) {
    status = build_model(web, &options);
    if (status != TABOR_OK) break;
  }
  if (status == TABOR_OK) status = web->is_kit ? begin_kit(web, rate) : begin_drum(web, rate);
  if (status == TABOR_OK && !web_make_room(web)) status = TABOR_ERROR_MEMORY;
  web->rate = rate;
  web->error.status = status;
  return status == TABOR_OK;
}

EXPORT("instrument_destroy") void web_instrument_destroy(WebInstrument *web) {
  if (!web) return;
  room_mix_free(&web->room);
  tabor_drum_destroy(web->drum);
  tabor_kit_destroy(web->kit);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    tabor_view_destroy(web->views[i]);
    tabor_model_release(web->models[i]);
  }
  free(web->messages);
  free(web->kit_midi);
  free(web);
}

/* As if it had just been built. */
EXPORT("instrument_reset") void web_instrument_reset(WebInstrument *web) {
  web->message_count = 0;
  drum_player_rest(&web->player);
  web->player.position = 0;
}
