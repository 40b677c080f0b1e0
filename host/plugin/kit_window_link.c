/* SPDX-License-Identifier: MIT */
#include "plugin/kit_window_link.h"

#include <math.h>

enum { STROKES = 256 };

bool kit_window_link_begin(KitWindowLink *link) {
  return spsc_queue_create(&link->strokes, sizeof(KitPluginStroke), STROKES);
}

void kit_window_link_end(KitWindowLink *link) { spsc_queue_destroy(&link->strokes); }

void kit_window_link_play(KitWindowLink *link, KitPluginPlayer *player) {
  const KitPluginStroke *stroke;
  while ((stroke = spsc_queue_peek(&link->strokes)) != NULL) {
    kit_plugin_player_strike(player, stroke);
    spsc_queue_pop(&link->strokes);
  }
}

static void raise(_Atomic float *most, float value) REALTIME;
static void raise(_Atomic float *most, float value) {
  if (value > atomic_load(most)) atomic_store(most, value);
}

void kit_window_link_show(KitWindowLink *link, KitPluginPlayer *player,
                          const KitPluginOutputs *outputs, uint32_t frames) {
  float struck[TABOR_KIT_DRUMS];
  kit_plugin_player_struck(player, struck);
  if (!atomic_load(&link->is_shown)) return;
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) raise(&link->struck[i], struck[i]);
  for (uint32_t side = 0; side < 2; side++) {
    const float *const channel = outputs->mix[side];
    for (uint32_t i = 0; channel && i < frames; i++) raise(&link->peaks[side], fabsf(channel[i]));
  }
}
