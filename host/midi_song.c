/* SPDX-License-Identifier: MIT */
#include "midi_song.h"

#include <stdlib.h>
#include <string.h>

#include "drum_source.h"
#include "midi_file.h"

/* A message of the file and its place among the others. */
typedef struct Place {
  double time;  /* [s] */
  bool is_note; /* or belongs to one */
  size_t index;
} Place;

static int compare_places(const void *left, const void *right) {
  const Place *const a = left, *const b = right;
  if (a->time != b->time) return a->time < b->time ? -1 : 1;
  if (a->is_note != b->is_note) return a->is_note ? 1 : -1;
  return a->index < b->index ? -1 : a->index > b->index;
}

static Place *sort_messages(const MidiFile *file) {
  Place *const places = calloc(file->count + 1, sizeof *places);
  if (!places) return NULL;
  for (size_t i = 0; i < file->count; i++) {
    places[i] = (Place){file->events[i].time, midi_goes_with_notes(&file->events[i].message), i};
  }
  if (file->count > 0) qsort(places, file->count, sizeof *places, compare_places);
  return places;
}

/* What follows is meant for another preset. */
static void bind_preset(MidiDrum *drum, uint32_t preset) {
  TaborDrumDef def;
  if (tabor_drum_def_preset(&def, tabor_preset(preset)->name, NULL) != TABOR_OK) return;
  midi_binding_make(drum->map, &def, &drum->binding);
}

/* The preset chosen once more changes nothing. */
static bool changes(MidiSong *song, const MidiAction *action, int *preset) {
  if (action->type != MIDI_ACTION_PRESET) return true;
  if (*preset == (int)action->preset) return false;
  *preset = (int)action->preset;
  song->presets++;
  return true;
}

static void take_messages(const MidiFile *file, const Place *places, MidiDrum *drum,
                          MidiSong *song) {
  int preset = song->first_preset;
  for (size_t i = 0; i < file->count && song->presets <= MIDI_SONG_MOST_PRESETS; i++) {
    MidiSongItem *const item = &song->items[song->count];
    if (!midi_drum_take(drum, &file->events[places[i].index].message, &item->action)) continue;
    if (!changes(song, &item->action, &preset)) continue;
    item->time = places[i].time;
    song->count++;
    if (item->action.type == MIDI_ACTION_PRESET) bind_preset(drum, item->action.preset);
  }
  song->counts = drum->counts;
}

/* The file is in order of time. */
static Outcome check_times(const char *name, const MidiFile *file) {
  const double last = file->count > 0 ? file->events[file->count - 1].time : 0;
  if (last <= MIDI_SONG_LONGEST) return OUTCOME_OK;
  return refuse("%s: its last event comes at %.10g s; allowed: up to %d", input_name(name), last,
                MIDI_SONG_LONGEST);
}

static Outcome compose(const MidiFile *file, MidiDrum *drum, MidiSong *song) {
  Place *const places = sort_messages(file);
  song->items = calloc(file->count + 1, sizeof *song->items);
  const bool complete = places && song->items;
  if (complete) take_messages(file, places, drum, song);
  free(places);
  return complete ? OUTCOME_OK : fail_memory();
}

static Outcome check_counts(const char *name, const MidiSong *song) {
  if (song->counts.strokes > MIDI_SONG_MOST_STROKES) {
    return refuse("%s: too many strokes; allowed: up to %d", input_name(name),
                  MIDI_SONG_MOST_STROKES);
  }
  if (song->presets > MIDI_SONG_MOST_PRESETS) {
    return refuse("%s: too many program changes; allowed: up to %d", input_name(name),
                  MIDI_SONG_MOST_PRESETS);
  }
  if (song->counts.strokes > 0) return OUTCOME_OK;
  return refuse("%s: no note in it is a stroke: %llu are not in the map", input_name(name),
                (unsigned long long)song->counts.ignored_notes);
}

Outcome midi_song_read(const Arguments *arguments, const MidiMap *map, const TaborDrumDef *def,
                       MidiSong *song) {
  const char *const name = arguments_value(arguments, "midi-file");
  *song = (MidiSong){.first_preset = drum_listed_preset(arguments)};
  if (!name) return OUTCOME_OK;
  if (!*name) return refuse("--midi-file needs the name of a file");
  MidiFile file;
  MidiBinding binding;
  MidiDrum drum;
  midi_binding_make(map, def, &binding);
  midi_drum_begin(&drum, map, &binding);
  Outcome outcome = midi_file_read(name, &file);
  if (outcome == OUTCOME_OK) outcome = check_times(name, &file);
  if (outcome == OUTCOME_OK) outcome = compose(&file, &drum, song);
  if (outcome == OUTCOME_OK) outcome = check_counts(name, song);
  midi_file_free(&file);
  return outcome;
}

/* Puts @p item before the others of its frame, which begin at @p first. */
static void put_first(MidiSong *song, size_t first, size_t count, const MidiSongItem *item) {
  memmove(song->items + first + 1, song->items + first, (count - first) * sizeof *item);
  song->items[first] = *item;
}

static void drop_overtaken(MidiSong *song, double rate) {
  size_t kept = 0, first = 0; /* of the frame */
  bool has_preset = false;
  for (size_t i = 0; i < song->count; i++) {
    const MidiSongItem item = song->items[i];
    const bool is_preset = item.action.type == MIDI_ACTION_PRESET;
    if (kept == first ||
        midi_song_frame(&song->items[first], rate) != midi_song_frame(&item, rate)) {
      first = kept;
      has_preset = false;
    }
    if (is_preset && has_preset) {
      song->items[first] = item;
    } else {
      put_first(song, is_preset ? first : kept, kept, &item);
      kept++;
    }
    has_preset = has_preset || is_preset;
  }
  song->count = kept;
}

static void drop_repeated(MidiSong *song) {
  size_t kept = 0;
  int preset = song->first_preset;
  for (size_t i = 0; i < song->count; i++) {
    const MidiAction *const action = &song->items[i].action;
    if (action->type == MIDI_ACTION_PRESET) {
      if (preset == (int)action->preset) continue;
      preset = (int)action->preset;
    }
    song->items[kept++] = song->items[i];
  }
  song->count = kept;
}

void midi_song_settle(MidiSong *song, double rate) {
  drop_overtaken(song, rate);
  drop_repeated(song);
}

Outcome midi_song_take_events(MidiSong *song, double rate, TaborEvent **events, size_t *count) {
  size_t kept = 0;
  *count = 0;
  *events = calloc(song->count + 1, sizeof **events);
  if (!*events) return fail_memory();
  for (size_t i = 0; i < song->count; i++) {
    const MidiSongItem item = song->items[i];
    if (item.action.type == MIDI_ACTION_EVENT) {
      (*events)[*count] = item.action.event;
      (*events)[(*count)++].frame = midi_song_frame(&item, rate);
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
  note("%s: %llu of %llu notes are not in the map and were passed over",
       input_name(arguments_value(arguments, "midi-file")), ignored,
       ignored + song->counts.strokes);
}

void midi_song_free(MidiSong *song) {
  free(song->items);
  *song = (MidiSong){0};
}
