/* SPDX-License-Identifier: MIT */
#include "midi/midi_song_input.h"

#include <stdlib.h>

#include "drums/drum_args.h"

Outcome midi_song_read(const Arguments *arguments, const MidiMap *map, const TaborDrumDef *def,
                       double rate, MidiSong *song) {
  const char *const name = arguments_value(arguments, "midi-file");
  char error[MIDI_FILE_TEXT];
  *song = (MidiSong){.first_preset = drum_listed_preset(arguments)};
  if (!name) return OUTCOME_OK;
  const Outcome outcome = midi_file_of_arguments(arguments, &song->file);
  if (outcome != OUTCOME_OK) return outcome;
  if (!midi_song_check_time(&song->file, error)) return refuse("%s: %s", input_name(name), error);
  if (!midi_song_compose(song, map, def, rate)) return fail_memory();
  if (!midi_song_check(song, map, error)) return refuse("%s: %s", input_name(name), error);
  return OUTCOME_OK;
}

Outcome midi_song_take_events(MidiSong *song, TaborEvent **events, size_t *count) {
  size_t kept = 0;
  *count = 0;
  *events = calloc(song->count + 1, sizeof **events);
  if (!*events) return fail_memory();
  for (size_t i = 0; i < song->count; i++) {
    const MidiSongItem item = song->items[i];
    if (item.action.type == MIDI_ACTION_EVENT) {
      (*events)[*count] = item.action.event;
      (*events)[(*count)++].frame = item.frame;
    } else {
      song->items[kept++] = item;
    }
  }
  song->count = kept;
  return OUTCOME_OK;
}

void midi_song_note(const Arguments *arguments, const MidiSong *song) {
  const unsigned long long ignored = song->counts.ignored_notes;
  if (ignored == 0) return;
  const bool is_kits = ignored >= song->counts.strokes; /* half of the notes find no drum */
  note("%s: %llu of %llu notes are not in the map and were passed over%s",
       input_name(arguments_value(arguments, "midi-file")), ignored, ignored + song->counts.strokes,
       is_kits ? "; --kit standard plays a drum track on several drums" : "");
}
