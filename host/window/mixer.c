/* SPDX-License-Identifier: MIT */
#include "window/mixer.h"

static bool has_solo(const Mixer *mixer, const InstrumentKind *kind) {
  uint32_t id = 0;
  while (id < kind->knob_count && !mixer->is_solo[id]) id++;
  return id < kind->knob_count;
}

float mixer_wanted(Mixer *mixer, const InstrumentKind *kind, uint32_t id, float value) {
  const bool is_heard = has_solo(mixer, kind) ? mixer->is_solo[id] : !mixer->is_mute[id];
  if (is_heard == !mixer->is_off[id]) return value;
  mixer->is_off[id] = !is_heard;
  if (is_heard) return mixer->level[id];
  mixer->level[id] = value;
  return (float)kind->knobs[id].off;
}

void mixer_note(Mixer *mixer, const InstrumentKind *kind, uint32_t id, float value) {
  if (!mixer->is_off[id] || (double)value <= kind->knobs[id].off) return;
  mixer->is_off[id] = mixer->is_mute[id] = false;
}
