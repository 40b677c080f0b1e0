/* SPDX-License-Identifier: MIT */
#include "plugin/window_link.h"

#include <math.h>

enum { STROKES = 256 };

bool window_link_begin(WindowLink *link) {
  return spsc_queue_create(&link->strokes, sizeof(WindowStroke), STROKES);
}

void window_link_end(WindowLink *link) { spsc_queue_destroy(&link->strokes); }

void window_link_play(WindowLink *link, PluginPlayer *player) {
  const WindowStroke *stroke;
  while ((stroke = spsc_queue_peek(&link->strokes)) != NULL) {
    plugin_player_strike(player, stroke->velocity, stroke->radius, stroke->angle);
    spsc_queue_pop(&link->strokes);
  }
}

static float peak_of(const float *samples, uint32_t frames, float peak) REALTIME;
static float peak_of(const float *samples, uint32_t frames, float peak) {
  for (uint32_t i = 0; i < frames; i++) peak = fmaxf(peak, fabsf(samples[i]));
  return peak;
}

void window_link_show(WindowLink *link, const PluginPlayer *player, const PluginOutputs *outputs,
                      uint32_t frames) {
  if (!atomic_load(&link->is_shown)) return;
  for (uint32_t side = 0; side < 2; side++) {
    const float *const channel = outputs->channels[side];
    if (!channel) continue;
    const float before = atomic_load(&link->peaks[side]);
    atomic_store(&link->peaks[side], peak_of(channel, frames, before));
  }
  TaborView *const view = atomic_exchange(&link->asked, NULL);
  if (!view) return;
  const TaborDrum *const drum = player->core.drum;
  if (!drum || !tabor_drum_view(drum, view)) atomic_store(&link->is_stale, true);
  atomic_store(&link->seen, view);
}
