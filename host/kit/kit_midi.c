/* SPDX-License-Identifier: MIT */
#include "kit/kit_midi.h"

#include <math.h>
#include <string.h>

/* ---- set-up --------------------------------------------------------------------------------- */

/* The strokes of both have the same order. */
_Static_assert((int)MIDI_STROKE_PEDAL == (int)TABOR_KIT_STROKE_PEDAL &&
                 (int)MIDI_STROKE_HEAD == (int)TABOR_KIT_STROKE_HEAD,
               "strokes of notes");

const KitMidiSetup kit_midi_setup_default = {
  .response = {MIDI_CURVE_LINEAR, MIDI_RANGE_NORMAL},
  .channel = MIDI_OMNI,
  .snare_place = 16,
  .toms_place = 18,
};

MidiStroke kit_midi_stroke(const TaborKitDrumDef *drum, const KitMapNote *note) {
  if (note->general == KIT_MAP_NOTHING) return MIDI_STROKE_NONE;
  const MidiStroke own = (MidiStroke)drum->notes[note->general];
  return own == MIDI_STROKE_NONE || note->stroke == MIDI_STROKE_NONE ? own : note->stroke;
}

static bool plays_any(const TaborKitDrumDef *drum, const uint8_t *notes, size_t count) {
  for (size_t i = 0; i < count; i++) {
    if (drum->notes[notes[i]] != TABOR_KIT_STROKE_NONE) return true;
  }
  return false;
}

/* A drum module says the place of a stroke on its snare pad and on its toms by a controller each.
 */
static void map_places(const TaborKitDrumDef *drum, const KitMidiSetup *setup, MidiMap *map) {
  static const uint8_t snare[] = {37, 38, 40}, toms[] = {41, 43, 45, 47, 48, 50};
  map->controls[16].target = map->controls[17].target = MIDI_TARGET_NONE;
  if (plays_any(drum, snare, sizeof snare)) {
    map->controls[setup->snare_place].target = MIDI_TARGET_RADIUS;
  }
  if (plays_any(drum, toms, sizeof toms)) {
    map->controls[setup->toms_place].target = MIDI_TARGET_RADIUS;
  }
}

static void map_drum(const TaborKitDrumDef *drum, const KitMidiSetup *setup,
                     const KitMapNote *table, MidiMap *map) {
  midi_map_default(map);
  map->response = setup->response;
  map->channel = setup->channel;
  map->programs = false;
  for (int note = 0; note < MIDI_VALUES; note++) {
    map->notes[note] = (MidiNote){
      .stroke = kit_midi_stroke(drum, &table[note]), .radius = NAN, .angle = NAN, .speed = 1};
  }
  if (setup->map) map_places(drum, setup, map);
}

void kit_midi_begin(KitMidi *midi, const TaborKitDef *kit, const KitMidiSetup *setup) {
  KitMapNote table[MIDI_VALUES];
  kit_map_table(setup->map, table);
  memset(midi, 0, sizeof *midi);
  for (int note = 0; note < MIDI_VALUES; note++) midi->general[note] = table[note].general;
  for (int note = 0; note < MIDI_VALUES; note++) midi->has_sample[note] = kit->note[note].sample[0];
  memset(midi->owner, KIT_MIDI_NOBODY, sizeof midi->owner);
  midi->count = kit->drum_count;
  for (uint32_t i = 0; i < kit->drum_count; i++) {
    const TaborKitDrumDef *const drum = &kit->drum[i];
    MidiBinding binding;
    map_drum(drum, setup, table, &midi->maps[i]);
    midi_binding_make(&midi->maps[i], &drum->def, &binding);
    midi_to_events_begin(&midi->drums[i], &midi->maps[i], &binding);
    midi->head_radius[i] = drum->def.shell.radius;
    for (int note = 0; note < MIDI_VALUES; note++) {
      if (midi->maps[i].notes[note].stroke != MIDI_STROKE_NONE) midi->owner[note] = (uint8_t)i;
    }
  }
}

void kit_midi_follow(KitMidi *midi, const KitMidi *from) {
  memcpy(midi->unknown, from->unknown, sizeof midi->unknown);
  memcpy(midi->strokes, from->strokes, sizeof midi->strokes);
  for (uint32_t i = 0; i < midi->count && i < from->count; i++) {
    const MidiBinding binding = midi->drums[i].binding;
    midi->drums[i] = from->drums[i];
    midi->drums[i].map = &midi->maps[i];
    midi->drums[i].binding = binding;
  }
}

void kit_midi_rest(KitMidi *midi) {
  for (uint32_t i = 0; i < midi->count; i++) {
    const MidiBinding binding = midi->drums[i].binding;
    midi_to_events_begin(&midi->drums[i], &midi->maps[i], &binding);
  }
}

void kit_midi_humanize(const KitMidi *midi, Humanizer *humanizer, TaborKitEvent *event) {
  if (event->drum < midi->count) humanize(humanizer, midi->head_radius[event->drum], &event->event);
}

uint64_t kit_midi_unknown(const KitMidi *midi) {
  uint64_t sum = 0;
  for (int note = 0; note < MIDI_VALUES; note++) sum += midi->unknown[note];
  return sum;
}

/* General MIDI's percussion [GeneralMIDI], from note 35 on. */
const char *kit_midi_note_name(int note) {
  static const char *const NAMES[] = {
    "acoustic bass drum",
    "bass drum 1",
    "side stick",
    "acoustic snare",
    "hand clap",
    "electric snare",
    "low floor tom",
    "closed hi-hat",
    "high floor tom",
    "pedal hi-hat",
    "low tom",
    "open hi-hat",
    "low-mid tom",
    "hi-mid tom",
    "crash cymbal 1",
    "high tom",
    "ride cymbal 1",
    "Chinese cymbal",
    "ride bell",
    "tambourine",
    "splash cymbal",
    "cowbell",
    "crash cymbal 2",
    "vibraslap",
    "ride cymbal 2",
    "hi bongo",
    "low bongo",
    "mute hi conga",
    "open hi conga",
    "low conga",
    "high timbale",
    "low timbale",
    "high agogo",
    "low agogo",
    "cabasa",
    "maracas",
    "short whistle",
    "long whistle",
    "short guiro",
    "long guiro",
    "claves",
    "hi wood block",
    "low wood block",
    "mute cuica",
    "open cuica",
    "mute triangle",
    "open triangle",
  };
  const int first = 35, count = (int)(sizeof NAMES / sizeof *NAMES);
  return note >= first && note < first + count ? NAMES[note - first] : NULL;
}

/* ---- messages ------------------------------------------------------------------------------- */

static bool event_of(const MidiAction *action, TaborEvent *event) {
  switch (action->type) {
  case MIDI_ACTION_EVENT: *event = action->event; return true;
  case MIDI_ACTION_GAIN:
    *event = (TaborEvent){.type = TABOR_EVENT_GAIN, .value = action->value};
    return true;
  case MIDI_ACTION_SILENCE: *event = (TaborEvent){.type = TABOR_EVENT_SILENCE}; return true;
  default: return false;
  }
}

static uint32_t take_for(KitMidi *midi, uint32_t drum, const MidiMessage *message,
                         TaborKitEvent *events) {
  MidiAction actions[MIDI_MOST_ACTIONS];
  const uint32_t acts = midi_to_events_take(&midi->drums[drum], message, actions);
  uint32_t count = 0;
  for (uint32_t i = 0; i < acts; i++) {
    if (!event_of(&actions[i], &events[count].event)) continue;
    midi->strokes[drum] += events[count].event.type == TABOR_EVENT_STRIKE;
    events[count++].drum = drum;
  }
  return count;
}

/* A prefix is for one note only, whichever drum that is for. */
static void forget_prefix(KitMidi *midi, uint8_t channel) {
  for (uint32_t i = 0; i < midi->count; i++) midi->drums[i].prefixes[channel] = 0;
}

/* Key pressure as a module sends it when a cymbal is grabbed; 1 and 0 do not choke [RolandTD17]. */
static bool chokes(const MidiMessage *message) {
  return midi_kind(message) == MIDI_POLY_PRESSURE && message->data[1] > 1;
}

/* 0 to 1, with the prefix of high resolution. */
static double strength(const KitMidi *midi, const MidiMessage *message) {
  const uint8_t prefix = midi->drums[0].prefixes[midi_channel(message)];
  return fmin(1, (message->data[1] + prefix / 128.0) / 127);
}

static uint32_t take_for_sample(const KitMidi *midi, const MidiMessage *message,
                                TaborKitEvent *event) {
  const bool choke = chokes(message);
  const bool strikes = midi_kind(message) == MIDI_NOTE_ON && message->data[1] > 0;
  if (!choke && !strikes) return 0;
  *event = (TaborKitEvent){.drum = TABOR_KIT_NOTE + midi->general[message->data[0]]};
  event->event.type = choke ? TABOR_EVENT_SILENCE : TABOR_EVENT_STRIKE;
  if (strikes) event->event.velocity = strength(midi, message);
  return 1;
}

static bool has_sample(const KitMidi *midi, uint8_t note) {
  return midi->general[note] != KIT_MAP_NOTHING && midi->has_sample[midi->general[note]];
}

uint32_t kit_midi_address(const KitMidi *midi, uint8_t note) {
  if (has_sample(midi, note)) return TABOR_KIT_NOTE + midi->general[note];
  return midi->owner[note] != KIT_MIDI_NOBODY ? midi->owner[note] : KIT_MIDI_NOWHERE;
}

static uint32_t take_note(KitMidi *midi, const MidiMessage *message, TaborKitEvent *event) {
  const uint8_t note = message->data[0], owner = midi->owner[note];
  const int channel = midi->maps[0].channel;
  const bool strikes = midi_kind(message) == MIDI_NOTE_ON && message->data[1] > 0;
  if (channel != MIDI_OMNI && channel != midi_channel(message)) return 0;
  uint32_t count = 0;
  if (has_sample(midi, note)) {
    count = take_for_sample(midi, message, event);
  } else if (owner != KIT_MIDI_NOBODY) {
    count = take_for(midi, owner, message, event);
  } else if (strikes) {
    midi->unknown[note]++;
  }
  if (midi_kind(message) != MIDI_POLY_PRESSURE) forget_prefix(midi, midi_channel(message));
  return count;
}

uint32_t kit_midi_take(KitMidi *midi, const MidiMessage *message,
                       TaborKitEvent events[KIT_MIDI_MOST_EVENTS]) {
  uint32_t count = 0;
  switch (midi_kind(message)) {
  case MIDI_NOTE_ON:
  case MIDI_NOTE_OFF:
  case MIDI_POLY_PRESSURE: return take_note(midi, message, events);
  default: break;
  }
  for (uint32_t i = 0; i < midi->count; i++) count += take_for(midi, i, message, events + count);
  return count;
}
