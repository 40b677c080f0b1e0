/* SPDX-License-Identifier: MIT */
#include "kit/kit_song.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "midi/midi_order.h"
#include "midi/midi_song.h"

/* Makes room for what a message may do. */
static bool grow(KitSong *song, size_t *room) {
  if (song->count + KIT_MIDI_MOST_EVENTS <= *room) return true;
  const size_t larger = 2 * *room + 4 * KIT_MIDI_MOST_EVENTS;
  TaborKitEvent *const events = realloc(song->events, larger * sizeof *events);
  if (!events) return false;
  song->events = events;
  *room = larger;
  return true;
}

static bool take_messages(const MidiFile *file, const MidiPlace *places, KitMidi *midi,
                          Humanizer *humanizer, KitSong *song) {
  size_t room = 0;
  for (size_t i = 0; i < file->count; i++) {
    if (!grow(song, &room)) return false;
    TaborKitEvent *const events = song->events + song->count;
    const uint32_t count = kit_midi_take(midi, &file->events[places[i].index].message, events);
    for (uint32_t k = 0; k < count; k++) {
      events[k].event.frame = places[i].frame;
      kit_midi_humanize(midi, humanizer, &events[k]);
    }
    song->count += count;
    if (count > 0) song->last_frame = places[i].frame;
  }
  return true;
}

bool kit_song_compose(KitSong *song, const MidiFile *file, KitMidi *midi, Humanizer humanizer,
                      double rate) {
  MidiPlace *const places = midi_order(file, rate);
  *song = (KitSong){0};
  const bool complete = places && take_messages(file, places, midi, &humanizer, song);
  free(places);
  return complete;
}

/* Both are in order of time; at one frame the song's events come first. */
static bool merge(KitSong *song, uint32_t drum, const TaborEvent *events, size_t count) {
  TaborKitEvent *const merged = calloc(song->count + count, sizeof *merged);
  if (!merged) return false;
  size_t own = 0, added = 0;
  for (size_t i = 0; i < song->count + count; i++) {
    const bool is_own =
      own < song->count && (added == count || song->events[own].event.frame <= events[added].frame);
    merged[i] = is_own ? song->events[own++] : (TaborKitEvent){drum, events[added++]};
  }
  free(song->events);
  song->events = merged;
  song->count += count;
  song->last_frame = merged[song->count - 1].event.frame;
  return true;
}

bool kit_song_add_strokes(KitSong *song, const TaborKitDef *kit, Humanizer humanizer,
                          const Strokes strokes[TABOR_KIT_DRUMS]) {
  for (uint32_t drum = 0; drum < kit->drum_count; drum++) {
    const Strokes *const own = &strokes[drum];
    if (own->count == 0) continue;
    for (size_t i = 0; i < own->count; i++) {
      humanize(&humanizer, kit->drum[drum].def.shell.radius, &own->events[i]);
    }
    if (!merge(song, drum, own->events, own->count)) return false;
  }
  return true;
}

uint32_t kit_song_last_stroke(const KitSong *song) {
  size_t last = song->count;
  while (last > 0 && song->events[last - 1].event.type == TABOR_EVENT_RELEASE) last--;
  return last > 0 ? song->events[last - 1].event.frame : 0;
}

bool kit_song_check(const KitMidi *midi, char error[MIDI_FILE_TEXT]) {
  uint64_t strokes = 0;
  for (uint32_t i = 0; i < midi->count; i++) strokes += midi->strokes[i];
  if (!midi_song_check_strokes(strokes, error)) return false;
  if (strokes > 0) return true;
  (void)snprintf(error, MIDI_FILE_TEXT, "no note in it plays a drum of the kit");
  return false;
}

bool kit_song_unplayed(const KitMidi *midi, char line[KIT_SONG_LINE]) {
  static const char *const begin = "notes that play no drum of the kit: ";
  size_t length = strlen(strcpy(line, begin));
  for (int i = 0; i < MIDI_VALUES && length < KIT_SONG_LINE - 80; i++) {
    const char *const known = kit_midi_note_name(midi->general[i]);
    if (midi->unknown[i] == 0) continue;
    const int written = snprintf(line + length, KIT_SONG_LINE - length, "%s%d%s%s (%llu)",
                                 length > strlen(begin) ? ", " : "", i, known ? " " : "",
                                 known ? known : "", (unsigned long long)midi->unknown[i]);
    length += written > 0 ? (size_t)written : 0;
  }
  return length > strlen(begin);
}

void kit_song_free(KitSong *song) {
  free(song->events);
  *song = (KitSong){0};
}
