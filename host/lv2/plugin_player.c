/* SPDX-License-Identifier: MIT */
#include "lv2/plugin_player_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define HUMANIZE_SEED 1

/* ---- beginning and end ---------------------------------------------------------------------- */

static bool bind_presets(Voice *voice) {
  const uint32_t count = tabor_preset_count();
  voice->bindings = calloc(count, sizeof *voice->bindings);
  for (uint32_t i = 0; voice->bindings && i < count; i++) {
    TaborDrumDef def;
    if (tabor_drum_def_preset(&def, tabor_preset(i)->name, NULL) != TABOR_OK) return false;
    midi_binding_make(&voice->map, &def, &voice->bindings[i]);
    if (strcmp(tabor_preset(i)->name, DEFAULT_PRESET) == 0) voice->wish.program = (int32_t)i;
  }
  voice->chosen = voice->chosen_before = voice->wish.program;
  return voice->bindings != NULL;
}

static void prepare_knobs(Voice *voice) {
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    const KnobId id = (KnobId)i;
    voice->seen[i] = NAN;
    voice->levels[i] = fader_at(0, voice->rate);
    if (i >= KNOB_KEYS) continue;
    voice->seen[i] = knob_range(id, &voice->workshop->base).fallback;
    voice->built[i] = NAN;
    if (knobs[i].kind == KNOB_LIVE) voice->ids[i] = tabor_parameter_find(knobs[i].key)->id;
  }
}

static void start_over(Voice *voice, const MidiBinding *binding) {
  midi_to_events_begin(&voice->midi, &voice->map, binding);
  voice->humanizer.state = HUMANIZE_SEED;
  voice->silencer = silencer_begin(voice->rate);
  voice->expression = fader_at(1, voice->rate);
  voice->event_count = voice->action_count = 0;
  voice->held_events = voice->held_actions = 0;
}

bool voice_begin(Voice *voice, Workshop *workshop, double rate, bool stereo) {
  MidiBinding binding;
  voice->workshop = workshop;
  voice->rate = rate;
  voice->stereo = stereo;
  voice->map = workshop->map;
  voice->grip_id = tabor_parameter_find("hand.grip")->id;
  voice->gain = fader_at(1, rate);
  leaving_begin(&voice->leaving, rate);
  voice->wish = (Wish){.number = 1, .quality = TABOR_QUALITY_LIVE};
  voice_forget_turns(&voice->wish);
  prepare_knobs(voice);
  midi_binding_make(&voice->map, &workshop->base, &binding);
  start_over(voice, &binding);
  return bind_presets(voice);
}

void voice_end(Voice *voice) {
  voice_cut_others(voice);
  for (uint32_t i = 0; i < WORKSHOP_TRASH; i++) tabor_drum_destroy(voice->trash[i]);
  tabor_drum_destroy(voice->drum);
  free(voice->bindings);
}

/* ---- a new beginning ------------------------------------------------------------------------- */

/* The messages that have come are meant for it already. */
static void choose_waiting(Voice *voice) {
  for (uint32_t i = 0; i < voice->action_count; i++) {
    const MidiAction *const action = &voice->actions[i].action;
    if (action->type == MIDI_ACTION_PRESET) voice_choose_preset(voice, action->preset);
  }
}

void voice_rest(Voice *voice) {
  const MidiBinding binding = voice->midi.binding;
  choose_waiting(voice);
  if (voice->drum) tabor_drum_reset(voice->drum);
  voice_cut_others(voice);
  start_over(voice, &binding);
  voice->gain = fader_at(voice->gain.target, voice->rate);
  for (uint32_t i = KNOB_LEVEL_PAIR; i <= KNOB_LEVEL_FAR; i++) {
    voice->levels[i] = fader_at(voice->levels[i].target, voice->rate);
    voice->waits[i] = 0;
  }
  voice->wish.strainer = voice->wish.grip = NAN;
  memset(voice->moved, 0, sizeof voice->moved); /* the drum has the values of its model */
  voice->grip_moved = false;
  voice_move_live(voice);
  voice->silencer.at_rest = true; /* these values are how it begins */
}
