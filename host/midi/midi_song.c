/* SPDX-License-Identifier: MIT */
#include "midi/midi_song.h"

#include <stdlib.h>
#include <string.h>

#include "drums/drum_args.h"
#include "midi/midi_order.h"

/* What follows is meant for another preset. */
static void bind_preset(MidiToEvents *drum, uint32_t preset) {
  TaborDrumDef def;
  if (tabor_drum_def_preset(&def, tabor_preset(preset)->name, NULL) != TABOR_OK) return;
  midi_binding_make(drum->map, &def, &drum->binding);
}

/* Makes room for what a message may do. */
static bool grow(MidiSong *song, size_t *room) {
  if (song->count + MIDI_MOST_ACTIONS <= *room) return true;
  const size_t larger = 2 * *room + 64;
  MidiSongItem *const items = realloc(song->items, larger * sizeof *items);
  if (!items) return false;
  song->items = items;
  *room = larger;
  return true;
}

/* The preset chosen once more changes nothing. */
static bool changes(MidiSong *song, const MidiAction *action, int *preset) {
  if (action->type != MIDI_ACTION_PRESET) return true;
  if (*preset == (int)action->preset) return false;
  *preset = (int)action->preset;
  song->presets++;
  return true;
}

static void add_item(MidiSong *song, const MidiAction *action, const MidiToEvents *drum,
                     uint32_t frame) {
  song->items[song->count] = (MidiSongItem){.frame = frame,
                                            .place = song->count,
                                            .head_radius = drum->binding.head_radius,
                                            .action = *action};
  song->count++;
}

static bool take_messages(const MidiPlace *places, MidiToEvents *drum, MidiSong *song) {
  const MidiFile *const file = &song->file;
  int preset = song->first_preset;
  size_t room = 0;
  for (size_t i = 0; i < file->count && song->presets <= MIDI_SONG_MOST_PRESETS; i++) {
    MidiAction actions[MIDI_MOST_ACTIONS];
    const uint32_t count =
      midi_to_events_take(drum, &file->events[places[i].index].message, actions);
    if (!grow(song, &room)) return false;
    for (uint32_t k = 0; k < count; k++) {
      if (!changes(song, &actions[k], &preset)) continue;
      if (actions[k].type == MIDI_ACTION_PRESET) bind_preset(drum, actions[k].preset);
      add_item(song, &actions[k], drum, places[i].frame);
    }
  }
  song->counts = drum->counts;
  return true;
}

/* ---- what acts first ---- */

static int rank(const MidiSongItem *item) {
  if (item->action.type == MIDI_ACTION_PRESET) return 0;
  return item->action.type == MIDI_ACTION_EVENT ? 2 : 1;
}

static int compare_items(const void *left, const void *right) {
  const MidiSongItem *const a = left, *const b = right;
  if (a->frame != b->frame) return a->frame < b->frame ? -1 : 1;
  if (rank(a) != rank(b)) return rank(a) < rank(b) ? -1 : 1;
  return a->place < b->place ? -1 : a->place > b->place;
}

static bool is_overtaken(const MidiSong *song, size_t index) {
  const MidiSongItem *const item = &song->items[index], *const next = item + 1;
  return index + 1 < song->count && next->action.type == MIDI_ACTION_PRESET &&
         next->frame == item->frame;
}

/* Changes that others overtake at the same frame, or to what is there already. */
static void drop_presets(MidiSong *song) {
  size_t kept = 0;
  int preset = song->first_preset;
  for (size_t i = 0; i < song->count; i++) {
    const MidiAction *const action = &song->items[i].action;
    if (action->type == MIDI_ACTION_PRESET) {
      if (is_overtaken(song, i) || preset == (int)action->preset) continue;
      preset = (int)action->preset;
    }
    song->items[kept++] = song->items[i];
  }
  song->count = kept;
}

static void settle(MidiSong *song) {
  if (song->count > 0) qsort(song->items, song->count, sizeof *song->items, compare_items);
  drop_presets(song);
}

/* ---- the whole song ---- */

Outcome midi_song_compose(MidiSong *song, const MidiMap *map, const TaborDrumDef *def,
                          double rate) {
  MidiBinding binding;
  MidiToEvents drum;
  MidiPlace *const places = midi_order(&song->file, rate);
  song->count = song->presets = 0;
  midi_binding_make(map, def, &binding);
  midi_to_events_begin(&drum, map, &binding);
  const bool complete = places && take_messages(places, &drum, song);
  if (complete) settle(song);
  free(places);
  return complete ? OUTCOME_OK : fail_memory();
}

/* The file is in order of time. */
static Outcome check_times(const char *name, const MidiFile *file) {
  const double last = file->count > 0 ? file->events[file->count - 1].time : 0;
  if (last <= MIDI_SONG_LONGEST) return OUTCOME_OK;
  return refuse("%s: its last event comes at %.10g s; allowed: up to %d", input_name(name), last,
                MIDI_SONG_LONGEST);
}

static Outcome check_counts(const char *name, const MidiMap *map, const MidiSong *song) {
  const unsigned long long ignored = song->counts.ignored_notes;
  if (song->counts.strokes > MIDI_SONG_MOST_STROKES) {
    return refuse("%s: too many strokes; allowed: up to %d", input_name(name),
                  MIDI_SONG_MOST_STROKES);
  }
  if (song->presets > MIDI_SONG_MOST_PRESETS) {
    return refuse("%s: too many program changes; allowed: up to %d", input_name(name),
                  MIDI_SONG_MOST_PRESETS);
  }
  if (song->counts.strokes > 0) return OUTCOME_OK;
  if (map->channel == MIDI_OMNI) {
    return refuse("%s: no note in it is a stroke: %llu are not in the map", input_name(name),
                  ignored);
  }
  return refuse("%s: no note on channel %d is a stroke: %llu are not in the map", input_name(name),
                map->channel + 1, ignored);
}

Outcome midi_song_read(const Arguments *arguments, const MidiMap *map, const TaborDrumDef *def,
                       double rate, MidiSong *song) {
  const char *const name = arguments_value(arguments, "midi-file");
  *song = (MidiSong){.first_preset = drum_listed_preset(arguments)};
  if (!name) return OUTCOME_OK;
  Outcome outcome = midi_file_of_arguments(arguments, &song->file);
  if (outcome == OUTCOME_OK) outcome = check_times(name, &song->file);
  if (outcome == OUTCOME_OK) outcome = midi_song_compose(song, map, def, rate);
  return outcome == OUTCOME_OK ? check_counts(name, map, song) : outcome;
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

void midi_song_free(MidiSong *song) {
  midi_file_free(&song->file);
  free(song->items);
  *song = (MidiSong){0};
}
