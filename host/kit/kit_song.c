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

static Outcome take_messages(const MidiFile *file, const MidiPlace *places, KitMidi *midi,
                             Humanizer *humanizer, KitSong *song) {
  size_t room = 0;
  for (size_t i = 0; i < file->count; i++) {
    if (!grow(song, &room)) return fail_memory();
    TaborKitEvent *const events = song->events + song->count;
    const uint32_t count = kit_midi_take(midi, &file->events[places[i].index].message, events);
    for (uint32_t k = 0; k < count; k++) {
      events[k].event.frame = places[i].frame;
      if (events[k].drum >= midi->count) continue; /* a sample */
      humanize(humanizer, midi->head_radius[events[k].drum], &events[k].event);
    }
    song->count += count;
    if (count > 0) song->last_frame = places[i].frame;
  }
  return OUTCOME_OK;
}

static Outcome check(const char *name, const MidiFile *file, const KitMidi *midi) {
  const double last = file->count > 0 ? file->events[file->count - 1].time : 0;
  uint64_t strokes = 0;
  for (uint32_t i = 0; i < midi->count; i++) strokes += midi->strokes[i];
  if (last > MIDI_SONG_LONGEST) {
    return refuse("%s: its last event comes at %.10g s; allowed: up to %d", input_name(name), last,
                  MIDI_SONG_LONGEST);
  }
  if (strokes > MIDI_SONG_MOST_STROKES) {
    return refuse("%s: too many strokes; allowed: up to %d", input_name(name),
                  MIDI_SONG_MOST_STROKES);
  }
  if (strokes > 0) return OUTCOME_OK;
  return refuse("%s: no note in it plays a drum of the kit", input_name(name));
}

Outcome kit_song_read(const Arguments *arguments, KitMidi *midi, Humanizer humanizer, double rate,
                      KitSong *song) {
  const char *const name = arguments_value(arguments, "midi-file");
  MidiFile file = {0};
  *song = (KitSong){0};
  Outcome outcome = midi_file_of_arguments(arguments, &file);
  MidiPlace *const places = outcome == OUTCOME_OK ? midi_order(&file, rate) : NULL;
  if (outcome == OUTCOME_OK && !places) outcome = fail_memory();
  if (outcome == OUTCOME_OK) outcome = take_messages(&file, places, midi, &humanizer, song);
  if (outcome == OUTCOME_OK) outcome = check(name, &file, midi);
  free(places);
  midi_file_free(&file);
  return outcome;
}

void kit_song_note(const char *name, const KitMidi *midi) {
  char text[1024] = "";
  size_t length = 0;
  for (int i = 0; i < MIDI_VALUES && length < sizeof text - 80; i++) {
    const char *const known = kit_midi_note_name(midi->general[i]);
    if (midi->unknown[i] == 0) continue;
    const int written =
      snprintf(text + length, sizeof text - length, "%s%d%s%s (%llu)", length > 0 ? ", " : "", i,
               known ? " " : "", known ? known : "", (unsigned long long)midi->unknown[i]);
    length += written > 0 ? (size_t)written : 0;
  }
  if (length > 0) note("%s: notes that play no drum of the kit: %s", input_name(name), text);
}

void kit_song_free(KitSong *song) {
  free(song->events);
  *song = (KitSong){0};
}
