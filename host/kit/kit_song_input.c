/* SPDX-License-Identifier: MIT */
#include "kit/kit_song_input.h"

#include "midi/midi_song.h"
#include "strokes/stroke_options.h"

static Outcome add_strokes(const Arguments *arguments, const TaborKitDef *kit, Humanizer humanizer,
                           double rate, KitSong *song) {
  Strokes strokes[TABOR_KIT_DRUMS];
  Outcome outcome = strokes_read_for_kit(arguments, kit, rate, strokes);
  if (outcome == OUTCOME_OK && !kit_song_add_strokes(song, kit, humanizer, strokes)) {
    outcome = fail_memory();
  }
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) strokes_free(&strokes[i]);
  return outcome;
}

static Outcome read_file(const Arguments *arguments, KitMidi *midi, Humanizer humanizer,
                         double rate, KitSong *song) {
  const char *const name = arguments_value(arguments, "midi-file");
  char error[MIDI_FILE_TEXT] = "";
  MidiFile file = {0};
  Outcome outcome = midi_file_of_arguments(arguments, &file);
  if (outcome == OUTCOME_OK && midi_song_check_time(&file, error)) {
    if (!kit_song_compose(song, &file, midi, humanizer, rate)) {
      outcome = fail_memory();
    } else {
      (void)kit_song_check(midi, error);
    }
  }
  midi_file_free(&file);
  return *error ? refuse("%s: %s", input_name(name), error) : outcome;
}

Outcome kit_song_read(const Arguments *arguments, const TaborKitDef *kit, KitMidi *midi,
                      Humanizer humanizer, double rate, KitSong *song) {
  *song = (KitSong){0};
  Outcome outcome = OUTCOME_OK;
  if (arguments_has(arguments, "midi-file"))
    outcome = read_file(arguments, midi, humanizer, rate, song);
  return outcome == OUTCOME_OK ? add_strokes(arguments, kit, humanizer, rate, song) : outcome;
}

void kit_song_note(const char *name, const KitMidi *midi) {
  char line[KIT_SONG_LINE];
  if (kit_song_unplayed(midi, line)) note("%s: %s", input_name(name), line);
}
