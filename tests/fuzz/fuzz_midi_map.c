/* SPDX-License-Identifier: MIT */
/* MIDI map files: refused with one line, or a map that drums with and without brushes can be played
 * by. */
#include <math.h>

#include "fuzz.h"
#include "midi/midi_map_file.h"
#include "midi/midi_to_events.h"

static void require_finite(const MidiAction *action) {
  fuzz_require(isfinite(action->event.velocity) && isfinite(action->event.radius) &&
                 isfinite(action->event.angle) && isfinite(action->event.value) &&
                 isfinite(action->value),
               "actions are finite");
}

static void play_every_message(const MidiMap *map, const char *preset) {
  TaborDrumDef def;
  MidiBinding binding;
  MidiToEvents drum;
  fuzz_require(tabor_drum_def_preset(&def, preset, NULL) == TABOR_OK, "a preset");
  midi_binding_make(map, &def, &binding);
  midi_to_events_begin(&drum, map, &binding);
  for (unsigned kind = 8; kind < 15; kind++) {
    for (unsigned first = 0; first < 128; first++) {
      const MidiMessage message = {.status = (uint8_t)(kind << 4 | (first & 15u)),
                                   .data = {(uint8_t)first, (uint8_t)(127 - first)}};
      MidiAction actions[MIDI_MOST_ACTIONS];
      const uint32_t count = midi_to_events_take(&drum, &message, actions);
      for (uint32_t i = 0; i < count; i++) require_finite(&actions[i]);
    }
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  MidiMap map;
  char message[1000] = "";
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = midi_map_file_read(fuzz_file(data, size), &map);
  message_release(before);
  fuzz_require(outcome == OUTCOME_OK || message[0] != '\0', "a refusal has a reason");
  if (outcome != OUTCOME_OK) return 0;
  play_every_message(&map, "snare-14x5.5");
  play_every_message(&map, "timpani-26");
  return 0;
}
