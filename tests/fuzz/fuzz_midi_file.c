/* SPDX-License-Identifier: MIT */
/* Standard MIDI files, and what the default map makes of them: refused with one line, or messages
 * in order. */
#include <math.h>

#include "fuzz.h"
#include "midi/midi_file_input.h"
#include "midi/midi_song.h"

static void check_file(const MidiFile *file) {
  for (size_t i = 0; i < file->count; i++) {
    const MidiFileEvent *const event = &file->events[i];
    fuzz_require(isfinite(event->time) && event->time >= 0.0, "times are finite");
    fuzz_require(i == 0 || event->time >= file->events[i - 1].time, "messages are in order");
    fuzz_require(event->message.status >= 0x80 && event->message.status < 0xF0, "channel messages");
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static TaborDrumDef def;
  static MidiMap map;
  if (def.struct_size == 0) {
    fuzz_require(tabor_drum_def_preset(&def, "snare-14x5.5", NULL) == TABOR_OK, "a preset");
    midi_map_default(&map);
  }
  char message[1000] = "";
  MidiSong song = {.first_preset = 0};
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = midi_file_parse("input", data, size, false, &song.file);
  if (outcome == OUTCOME_OK) {
    check_file(&song.file);
    fuzz_require(midi_song_compose(&song, &map, &def, 48000.0), "there is memory");
  }
  message_release(before);
  fuzz_require(outcome == OUTCOME_OK || message[0] != '\0', "a refusal has a reason");
  for (size_t i = 1; outcome == OUTCOME_OK && i < song.count; i++) {
    fuzz_require(song.items[i].frame >= song.items[i - 1].frame, "actions are in order");
  }
  midi_song_free(&song);
  return 0;
}
