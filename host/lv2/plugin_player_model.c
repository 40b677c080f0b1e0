/* SPDX-License-Identifier: MIT */
/* How a voice gets another model while its drum rings. */
#include <math.h>
#include <string.h>

#include "lv2/plugin_player_internal.h"

#define CROSS_HOLD 0.008 /* [s] after which a swapped drum is heard at all usual microphones */

static void take_restoration(Voice *voice, const Offer *offer) {
  voice->wish.restoration = offer->restoration;
  voice->wish.program = WORKSHOP_NO_PROGRAM;
  voice_forget_choice(voice);
  atomic_store(&voice->workshop->program, WORKSHOP_NO_PROGRAM);
  voice_forget_turns(&voice->wish);
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (!isnan(offer->seen[i])) voice->seen[i] = offer->seen[i];
  }
}

/* Both sides of a drum without a stereo pair are heard by its first microphone. */
static void attend(Voice *voice, const Offer *offer) {
  for (uint32_t i = 0; i < VOICE_MICS; i++) {
    const bool may_replace = voice->stereo && i >= VOICE_LEFT;
    voice->mics[i] = offer->mics[i] == WORKSHOP_NO_MIC && may_replace ? 0 : offer->mics[i];
  }
}

static void read_model(Voice *voice, const Offer *offer) {
  attend(voice, offer);
  voice->striker_count = offer->def.striker_count;
  voice->built_grip = offer->def.hand.grip;
  voice->strainer = offer->binding.strainer;
  memcpy(voice->built, offer->built, sizeof voice->built);
}

/* The value that a live knob is to have: as MIDI says, else the knob, else the drum. */
static double live_value(const Voice *voice, KnobId id) {
  if (id == KNOB_STRAINER && !isnan(voice->wish.strainer)) return voice->wish.strainer;
  if (!isnan(voice->wish.values[id])) return voice->wish.values[id];
  return id == KNOB_STRAINER ? voice->strainer : voice->built[id];
}

/* The engine carries what was moved over to the new model; there it is put right. */
void voice_move_live(Voice *voice) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (knobs[i].kind != KNOB_LIVE || isnan(voice->built[i])) continue;
    const double value = live_value(voice, (KnobId)i);
    const bool differs = value != voice->built[i];
    if (differs || voice->moved[i]) voice_move_parameter(voice, voice->ids[i], value);
    voice->moved[i] = differs;
  }
  const double grip = isnan(voice->wish.grip) ? voice->built_grip : voice->wish.grip;
  if (voice->grip_moved) voice_move_parameter(voice, voice->grip_id, grip);
  voice->grip_moved = grip != voice->built_grip;
}

/* There is room: a wish empties it, and until the next two drums at most join those that sound. */
void voice_throw_away(Voice *voice, TaborDrum *drum) {
  uint32_t i = 0;
  if (!drum) return;
  while (i + 1 < WORKSHOP_TRASH && voice->trash[i]) i++;
  voice->trash[i] = drum;
}

void voice_end_crossing(Voice *voice) {
  voice_throw_away(voice, voice->crossing.drum);
  voice->crossing.drum = NULL;
}

void voice_clear_up(Voice *voice) {
  TaborDrum *drum;
  while ((drum = leaving_take(&voice->leaving)) != NULL) voice_throw_away(voice, drum);
}

void voice_cut_others(Voice *voice) {
  voice_end_crossing(voice);
  leaving_cut(&voice->leaving);
  voice_clear_up(voice);
}

/* A copy of the drum goes on as it was. */
static void copy_drum(Voice *voice, const Offer *offer) {
  tabor_drum_state_save(voice->drum, offer->state);
  const size_t size = tabor_drum_state_size(offer->spare);
  const bool copied = tabor_drum_state_load(offer->spare, offer->state, size) == TABOR_OK;
  voice_end_crossing(voice);
  if (copied && !tabor_drum_is_silent(voice->drum)) {
    voice->crossing = (Crossing){.drum = offer->spare,
                                 .hold = (uint32_t)(CROSS_HOLD * voice->rate),
                                 .fade = (uint32_t)(CROSS_FADE * voice->rate)};
  } else {
    voice_throw_away(voice, offer->spare);
  }
}

static void swap(Voice *voice, const Offer *offer) {
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = offer->swap};
  if (offer->spare) copy_drum(voice, offer);
  tabor_drum_process(voice->drum, &event, 1, NULL, 0);
  voice->swap = offer->swap;
}

static void replace(Voice *voice, TaborDrum *drum) {
  TaborDrum *const before = voice->drum;
  voice_end_crossing(voice);
  if (before) {
    voice_throw_away(voice, leaving_add(&voice->leaving, before, voice->mics, VOICE_MICS));
  }
  voice->drum = drum;
  memset(voice->moved, 0, sizeof voice->moved);
  voice->grip_moved = false;
}

/* Messages may be meant for a still newer preset already. */
static bool speaks_of(const Voice *voice, const Offer *offer) {
  return voice->chosen == WORKSHOP_NO_PROGRAM || voice->chosen == offer->program;
}

static void land(Voice *voice, const Offer *offer) {
  if (!offer->is_news) return;
  voice->answered = offer->number;
  voice->answered_restoration = offer->restoration;
  if (offer->restoration != voice->wish.restoration) take_restoration(voice, offer);
  if (offer->failed) return;
  if (offer->drum) replace(voice, offer->drum);
  if (offer->swap) swap(voice, offer);
  if (offer->begins_anew) silencer_forget(&voice->silencer);
  read_model(voice, offer);
  if (speaks_of(voice, offer)) {
    voice->midi.binding = offer->binding;
    voice_place_strokes(voice);
  }
  voice_move_live(voice);
}

static bool wants(const Voice *voice) {
  return voice->wish.number != voice->asked ||
         atomic_load(&voice->workshop->restoration) != voice->asked_restoration;
}

void voice_receive(Voice *voice) {
  const Offer *const offer = workshop_offer(voice->workshop);
  if (!offer) return;
  land(voice, offer);
  workshop_accept(voice->workshop);
}

static bool is_littered(const Voice *voice) {
  return voice->trash[0] || (voice->swap && tabor_swap_done(voice->swap));
}

bool voice_ask(Voice *voice) {
  if (!workshop_is_idle(voice->workshop) || !(wants(voice) || is_littered(voice))) return false;
  voice->asked = voice->wish.number;
  voice->asked_restoration = atomic_load(&voice->workshop->restoration);
  voice->swap = NULL; /* the worker may clear it up now */
  memcpy(voice->wish.seen, voice->seen, sizeof voice->wish.seen);
  memcpy(voice->wish.trash, voice->trash, sizeof voice->wish.trash);
  memset(voice->trash, 0, sizeof voice->trash);
  workshop_ask(voice->workshop, &voice->wish);
  return true;
}

bool voice_is_ready(const Voice *voice) {
  return voice->drum && voice->answered == voice->wish.number &&
         voice->answered_restoration == atomic_load(&voice->workshop->restoration);
}

bool voice_is_settled(const Voice *voice) {
  return workshop_is_idle(voice->workshop) && !wants(voice);
}
