/* SPDX-License-Identifier: MIT */
#include "midi/midi_order.h"

#include <math.h>
#include <stdlib.h>

#include "midi/midi_map.h"

static int compare(const void *left, const void *right) {
  const MidiPlace *const a = left, *const b = right;
  if (a->frame != b->frame) return a->frame < b->frame ? -1 : 1;
  if (a->is_note != b->is_note) return a->is_note ? 1 : -1;
  return a->index < b->index ? -1 : a->index > b->index;
}

MidiPlace *midi_order(const MidiFile *file, double rate) {
  MidiPlace *const places = calloc(file->count + 1, sizeof *places);
  if (!places) return NULL;
  for (size_t i = 0; i < file->count; i++) {
    const MidiFileEvent *const event = &file->events[i];
    places[i] =
      (MidiPlace){(uint32_t)llround(event->time * rate), midi_goes_with_notes(&event->message), i};
  }
  if (file->count > 0) qsort(places, file->count, sizeof *places, compare);
  return places;
}
