/* SPDX-License-Identifier: MIT */
#include "midi/midi_song.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

bool midi_song_compose(MidiSong *song, const MidiMap *map, const TaborDrumDef *def, double rate) {
  MidiBinding binding;
  MidiToEvents drum;
  MidiPlace *const places = midi_order(&song->file, rate);
  song->count = song->presets = 0;
  midi_binding_make(map, def, &binding);
  midi_to_events_begin(&drum, map, &binding);
  const bool complete = places && take_messages(places, &drum, song);
  if (complete) settle(song);
  free(places);
  return complete;
}

bool midi_song_check_time(const MidiFile *file, char error[MIDI_FILE_TEXT]) {
  const double last = file->count > 0 ? file->events[file->count - 1].time : 0;
  if (last <= MIDI_SONG_LONGEST) return true;
  (void)snprintf(error, MIDI_FILE_TEXT, "its last event comes at %.10g s; allowed: up to %d", last,
                 MIDI_SONG_LONGEST);
  return false;
}

bool midi_song_check_strokes(uint64_t strokes, char error[MIDI_FILE_TEXT]) {
  if (strokes <= MIDI_SONG_MOST_STROKES) return true;
  (void)snprintf(error, MIDI_FILE_TEXT, "too many strokes; allowed: up to %d",
                 MIDI_SONG_MOST_STROKES);
  return false;
}

bool midi_song_check(const MidiSong *song, const MidiMap *map, char error[MIDI_FILE_TEXT]) {
  const unsigned long long ignored = song->counts.ignored_notes;
  if (!midi_song_check_strokes(song->counts.strokes, error)) return false;
  if (song->presets > MIDI_SONG_MOST_PRESETS) {
    (void)snprintf(error, MIDI_FILE_TEXT, "too many program changes; allowed: up to %d",
                   MIDI_SONG_MOST_PRESETS);
    return false;
  }
  if (song->counts.strokes > 0) return true;
  char channel[40] = "in it";
  if (map->channel != MIDI_OMNI) {
    (void)snprintf(channel, sizeof channel, "on channel %d", map->channel + 1);
  }
  (void)snprintf(error, MIDI_FILE_TEXT, "no note %s is a stroke: %llu are not in the map", channel,
                 ignored);
  return false;
}

void midi_song_free(MidiSong *song) {
  midi_file_free(&song->file);
  free(song->items);
  *song = (MidiSong){0};
}
