/* SPDX-License-Identifier: MIT */
#include "kit/song_events.h"

#include <stdio.h>
#include <stdlib.h>

#include "kit/kit_song.h"
#include "midi/midi_song.h"

struct SongEvents {
  MidiFile file;
  MidiFileReport report;
  KitSong song;
  char unplayed[KIT_SONG_LINE]; /* "" if the kit plays all notes */
};

size_t song_events_most_bytes(void) { return MIDI_FILE_LIMIT; }

SongEvents *song_events_read(const void *bytes, size_t size) {
  SongEvents *const song = calloc(1, sizeof *song);
  if (!song) return NULL;
  if (size > MIDI_FILE_LIMIT) {
    (void)snprintf(song->report.error, MIDI_FILE_TEXT, "the file is larger than %d bytes",
                   MIDI_FILE_LIMIT);
    return song;
  }
  switch (midi_file_decode(bytes, size, &song->file, &song->report)) {
  case MIDI_FILE_OK: return song;
  case MIDI_FILE_REFUSED: song->report.lines = 0; return song; /* the error says enough */
  case MIDI_FILE_NO_MEMORY: break;
  }
  song_events_free(song);
  return NULL;
}

const char *song_events_error(const SongEvents *song) { return song->report.error; }

uint32_t song_events_warning_count(const SongEvents *song) {
  return song->report.lines + (*song->unplayed ? 1 : 0);
}

const char *song_events_warning(const SongEvents *song, uint32_t index) {
  return index < song->report.lines ? song->report.warning[index] : song->unplayed;
}

/* True for a file that can be composed; what was composed before is gone. */
static bool begin(SongEvents *song) {
  char *const error = song->report.error;
  kit_song_free(&song->song);
  *song->unplayed = '\0';
  return !*error && midi_song_check_time(&song->file, error);
}

/* ---- a drum ---- */

static TaborEvent event_of(const MidiSongItem *item) {
  const MidiAction *const action = &item->action;
  TaborEvent event = action->event;
  switch (action->type) {
  case MIDI_ACTION_EVENT: break;
  case MIDI_ACTION_GAIN:
    event = (TaborEvent){.type = TABOR_EVENT_GAIN, .value = action->value};
    break;
  case MIDI_ACTION_SILENCE: event = (TaborEvent){.type = TABOR_EVENT_SILENCE}; break;
  case MIDI_ACTION_PRESET:
    event = (TaborEvent){.type = TABOR_EVENT_REPLACE, .index = action->preset};
    break;
  }
  event.frame = item->frame;
  return event;
}

static bool list_items(const MidiSong *song, KitSong *list) {
  list->events = calloc(song->count + 1, sizeof *list->events);
  if (!list->events) return false;
  for (size_t i = 0; i < song->count; i++) list->events[i].event = event_of(&song->items[i]);
  list->count = song->count;
  return true;
}

bool song_events_of_drum(SongEvents *song, const TaborDrumDef *def, bool programs, int preset,
                         double rate) {
  MidiMap map;
  MidiSong drum = {.file = song->file, .first_preset = preset};
  if (!begin(song)) return false;
  midi_map_default(&map);
  map.programs = programs;
  const bool complete = midi_song_compose(&drum, &map, def, rate) &&
                        midi_song_check(&drum, &map, song->report.error) &&
                        list_items(&drum, &song->song);
  drum.file = (MidiFile){0}; /* it stays the song's */
  midi_song_free(&drum);
  return complete;
}

/* ---- a kit ---- */

bool song_events_of_kit(SongEvents *song, const TaborKitDef *kit, int map, uint32_t snare_place,
                        uint32_t toms_place, double rate) {
  KitMidiSetup setup = kit_midi_setup_default;
  setup.snare_place = (uint8_t)(snare_place % MIDI_VALUES);
  setup.toms_place = (uint8_t)(toms_place % MIDI_VALUES);
  if (map >= 0 && (size_t)map < kit_map_count) setup.map = &kit_maps[map];
  if (!begin(song)) return false;
  KitMidi *const midi = malloc(sizeof *midi);
  if (!midi) return false;
  kit_midi_begin(midi, kit, &setup);
  const bool complete = kit_song_compose(&song->song, &song->file, midi, humanizer(0, 0), rate) &&
                        kit_song_check(midi, song->report.error);
  if (!complete || !kit_song_unplayed(midi, song->unplayed)) *song->unplayed = '\0';
  free(midi);
  return complete;
}

const char *song_events_map_name(uint32_t map) {
  return map < kit_map_count ? kit_maps[map].name : NULL;
}

/* ---- events ---- */

const TaborKitEvent *song_events_list(const SongEvents *song) { return song->song.events; }

size_t song_events_count(const SongEvents *song) { return song->song.count; }

void song_events_free(SongEvents *song) {
  if (!song) return;
  midi_file_free(&song->file);
  kit_song_free(&song->song);
  free(song);
}
