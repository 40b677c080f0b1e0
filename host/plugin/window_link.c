/* SPDX-License-Identifier: MIT */
#include "plugin/window_link.h"

#include <math.h>

#include "plugin/instrument.h"

enum { STROKES = 256 };

bool window_link_begin(WindowLink *link) {
  return spsc_queue_create(&link->strokes, sizeof(WindowStroke), STROKES);
}

void window_link_end(WindowLink *link) { spsc_queue_destroy(&link->strokes); }

void window_link_play(Instrument *instrument) {
  SpscQueue *const strokes = &instrument->window.strokes;
  const WindowStroke *stroke;
  while ((stroke = spsc_queue_peek(strokes)) != NULL) {
    instrument->kind->calls->strike(instrument, stroke);
    spsc_queue_pop(strokes);
  }
}

static float peak_of(const float *samples, uint32_t frames, float peak) REALTIME;
static float peak_of(const float *samples, uint32_t frames, float peak) {
  for (uint32_t i = 0; i < frames; i++) peak = fmaxf(peak, fabsf(samples[i]));
  return peak;
}

void window_link_show(Instrument *instrument, uint32_t frames) {
  WindowLink *const link = &instrument->window;
  const uint32_t first = instrument->kind->outputs[0].first;
  instrument->kind->calls->show(instrument);
  if (!atomic_load(&link->is_shown)) return;
  for (uint32_t side = 0; side < 2; side++) {
    const float *const channel = instrument->buffers.channels[first + side];
    if (!channel) continue;
    atomic_store(&link->peaks[side], peak_of(channel, frames, atomic_load(&link->peaks[side])));
  }
}
