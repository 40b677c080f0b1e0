/* SPDX-License-Identifier: MIT */
#include "midi/midi_file.h"

#include <stdlib.h>
#include <string.h>

#include "base/input_file.h"

#define CHUNK_HEAD 8 /* bytes: its name and its length */
#define HEADER_LEAST 6
#define USUAL_TEMPO 500000u /* [us] for a quarter */

enum { META = 0xFF, SYSEX = 0xF0, SYSEX_REST = 0xF7 };
enum { META_END = 0x2F, META_TEMPO = 0x51 };

/* A channel message or, with status 0, a tempo [us] for a quarter. */
typedef struct Entry {
  uint64_t tick;
  size_t place; /* in the file, to keep the order of what comes at one tick */
  uint32_t tempo;
  MidiMessage message;
} Entry;

/* A file being read. */
typedef struct Reader {
  const char *name;
  const uint8_t *bytes;
  size_t at, end;   /* end: of the chunk that is read, or of the file */
  unsigned track;   /* from 1; 0 in the header */
  unsigned tracks;  /* that the header announces */
  uint64_t quarter; /* ticks of a quarter, or 0: ticks have their own length */
  double tick_time; /* [s], without quarter */
  uint64_t tick;    /* now, in this track */
  uint64_t last;    /* tick, of all tracks */
  uint8_t status;   /* running, or 0 */
  bool ended;       /* the track */
  Entry *entries;
  size_t count, capacity;
} Reader;

/* ---- bytes ---- */

/* What is wrong, at byte @p at. */
static Outcome refuse_at(const Reader *reader, size_t at, const char *what) {
  if (reader->track == 0) return refuse("%s: byte %zu: %s", input_name(reader->name), at, what);
  return refuse("%s: byte %zu, track %u: %s", input_name(reader->name), at, reader->track, what);
}

static size_t left(const Reader *reader) { return reader->end - reader->at; }

/* Of a number of @p count bytes, the highest first, which are known to be there. */
static uint32_t take_number(Reader *reader, size_t count) {
  uint32_t number = 0;
  for (size_t i = 0; i < count; i++) number = number << 8 | reader->bytes[reader->at++];
  return number;
}

static Outcome take_byte(Reader *reader, uint8_t *byte) {
  if (left(reader) == 0) return refuse_at(reader, reader->at, "the track breaks off in an event");
  *byte = reader->bytes[reader->at++];
  return OUTCOME_OK;
}

/* Seven bits a byte, at most four of them. */
static Outcome take_length(Reader *reader, uint32_t *length) {
  const size_t start = reader->at;
  uint8_t byte = 0x80;
  *length = 0;
  for (int i = 0; i < 4 && byte & 0x80u; i++) {
    const Outcome outcome = take_byte(reader, &byte);
    if (outcome != OUTCOME_OK) return outcome;
    *length = *length << 7 | (byte & 0x7Fu);
  }
  if (!(byte & 0x80u)) return OUTCOME_OK;
  return refuse_at(reader, start, "a time or length of more than 4 bytes; allowed: up to 4");
}

/* ---- events ---- */

static Outcome add_entry(Reader *reader, size_t at, Entry entry) {
  if (reader->count == MIDI_FILE_MOST_EVENTS) {
    return refuse("%s: byte %zu, track %u: too many events; allowed: up to %d",
                  input_name(reader->name), at, reader->track, MIDI_FILE_MOST_EVENTS);
  }
  if (reader->count == reader->capacity) {
    const size_t capacity = reader->capacity ? 2 * reader->capacity : 1024;
    Entry *const entries = realloc(reader->entries, capacity * sizeof *entries);
    if (!entries) return fail_memory();
    reader->entries = entries;
    reader->capacity = capacity;
  }
  entry.tick = reader->tick;
  entry.place = reader->count;
  reader->entries[reader->count++] = entry;
  return OUTCOME_OK;
}

static Outcome take_message(Reader *reader, size_t at, uint8_t status) {
  MidiMessage message = {.status = status};
  for (uint8_t i = 0; i < midi_data_count(status); i++) {
    const Outcome outcome = take_byte(reader, &message.data[i]);
    if (outcome != OUTCOME_OK) return outcome;
    if (message.data[i] & 0x80u) {
      return refuse_at(reader, reader->at - 1, "a data byte over 127 in a message");
    }
  }
  return add_entry(reader, at, (Entry){.message = message});
}

static Outcome take_tempo(Reader *reader, size_t at, uint32_t length) {
  if (length != 3) return refuse_at(reader, at, "a tempo that is not of 3 bytes");
  const uint32_t tempo = take_number(reader, 3);
  if (tempo == 0) {
    return refuse_at(reader, at, "a tempo of 0 us for a quarter; allowed: 1 to 16777215");
  }
  return add_entry(reader, at, (Entry){.tempo = tempo});
}

/* A meta event or system exclusive data: a length and as many bytes. */
static Outcome take_block(Reader *reader, size_t at, uint8_t status) {
  uint8_t type = 0;
  uint32_t length = 0;
  Outcome outcome = status == META ? take_byte(reader, &type) : OUTCOME_OK;
  if (outcome == OUTCOME_OK) outcome = take_length(reader, &length);
  if (outcome != OUTCOME_OK) return outcome;
  if (length > left(reader)) {
    return refuse_at(reader, at, "an event is longer than the rest of its track");
  }
  if (status == META && type == META_TEMPO) return take_tempo(reader, at, length);
  reader->ended = status == META && type == META_END;
  reader->at += length;
  return OUTCOME_OK;
}

/* Running status goes on behind meta events: not as the standard says, but as files are. */
static Outcome take_event(Reader *reader) {
  uint32_t delta = 0;
  Outcome outcome = take_length(reader, &delta);
  if (outcome != OUTCOME_OK) return outcome;
  reader->tick += delta; /* 2^28 at most, for every two bytes of the file: far below 2^64 */
  const size_t at = reader->at;
  uint8_t byte = 0;
  outcome = take_byte(reader, &byte);
  if (outcome != OUTCOME_OK) return outcome;
  if (byte == META || byte == SYSEX || byte == SYSEX_REST) return take_block(reader, at, byte);
  if (byte >= SYSEX) return refuse_at(reader, at, "a system message, which no file may hold");
  if (byte & 0x80u) {
    reader->status = byte;
  } else {
    reader->at = at;
  }
  if (reader->status == 0) return refuse_at(reader, at, "data without a status byte before them");
  return take_message(reader, at, reader->status);
}

/* ---- chunks ---- */

static bool is_chunk(const Reader *reader, const char *name) {
  return memcmp(reader->bytes + reader->at, name, 4) == 0;
}

/* Its length, which must be there; reader->at moves behind it. */
static Outcome enter_chunk(Reader *reader, uint32_t *length) {
  const size_t at = reader->at;
  reader->at += 4;
  *length = take_number(reader, 4);
  if (*length <= left(reader)) return OUTCOME_OK;
  return refuse("%s: byte %zu: the file ends %zu bytes before its chunk of %u does",
                input_name(reader->name), at, *length - left(reader), (unsigned)*length);
}

static Outcome take_track(Reader *reader, uint32_t length) {
  const size_t file_end = reader->end, end = reader->at + length;
  reader->end = end;
  reader->tick = 0;
  reader->status = 0;
  reader->ended = false;
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK && !reader->ended && left(reader) > 0) outcome = take_event(reader);
  if (reader->tick > reader->last) reader->last = reader->tick;
  reader->at = end;
  reader->end = file_end;
  return outcome;
}

static Outcome take_tracks(Reader *reader) {
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK && reader->track < reader->tracks) {
    uint32_t length = 0;
    if (left(reader) < CHUNK_HEAD) {
      return refuse("%s: byte %zu: the file ends after %u of its %u tracks",
                    input_name(reader->name), reader->at, reader->track, reader->tracks);
    }
    const bool is_track = is_chunk(reader, "MTrk");
    outcome = enter_chunk(reader, &length);
    if (outcome != OUTCOME_OK) return outcome;
    if (is_track) {
      reader->track++;
      outcome = take_track(reader, length);
    } else {
      reader->at += length;
    }
  }
  return outcome;
}

/* ---- header ---- */

static Outcome take_frame_division(Reader *reader, uint32_t division) {
  const unsigned frames = 256 - (division >> 8), ticks = division & 0xFFu;
  const double rate = frames == 29 ? 30000.0 / 1001 : frames;
  if ((frames != 24 && frames != 25 && frames != 29 && frames != 30) || ticks == 0) {
    return refuse("%s: byte 12: %u ticks in each of %u frames a second; allowed: 1 to 255 in 24, "
                  "25, 29 or 30",
                  input_name(reader->name), ticks, frames);
  }
  reader->tick_time = 1 / (rate * ticks);
  return OUTCOME_OK;
}

static Outcome take_division(Reader *reader, uint32_t division) {
  if (division & 0x8000u) return take_frame_division(reader, division);
  if (division == 0) return refuse_at(reader, 12, "0 ticks for a quarter; allowed: 1 to 32767");
  reader->quarter = division;
  return OUTCOME_OK;
}

static Outcome check_header(const Reader *reader, uint32_t format) {
  const char *const name = input_name(reader->name);
  if (format > 1) return refuse("%s: byte 8: format %u; allowed: 0 and 1", name, (unsigned)format);
  const unsigned most = format == 0 ? 1 : MIDI_FILE_MOST_TRACKS;
  if (reader->tracks >= 1 && reader->tracks <= most) return OUTCOME_OK;
  return refuse("%s: byte 10: %u tracks in a file of format %u; allowed: 1 to %u", name,
                reader->tracks, (unsigned)format, most);
}

static Outcome take_header(Reader *reader) {
  if (left(reader) < CHUNK_HEAD + HEADER_LEAST || !is_chunk(reader, "MThd")) {
    return refuse("%s: not a Standard MIDI File: it does not begin with a header 'MThd'",
                  input_name(reader->name));
  }
  uint32_t length = 0;
  Outcome outcome = enter_chunk(reader, &length);
  if (outcome != OUTCOME_OK) return outcome;
  if (length < HEADER_LEAST) return refuse_at(reader, 4, "a header of less than 6 bytes");
  const uint32_t format = take_number(reader, 2);
  reader->tracks = take_number(reader, 2);
  outcome = check_header(reader, format);
  if (outcome == OUTCOME_OK) outcome = take_division(reader, take_number(reader, 2));
  reader->at += length - HEADER_LEAST;
  return outcome;
}

/* ---- time ---- */

static int compare_entries(const void *left_entry, const void *right_entry) {
  const Entry *const a = left_entry, *const b = right_entry;
  if (a->tick != b->tick) return a->tick < b->tick ? -1 : 1;
  return a->place < b->place ? -1 : a->place > b->place;
}

/* From one change of tempo to the next. */
typedef struct Tempo {
  const Reader *reader;
  uint64_t tick;    /* of its beginning */
  double time;      /* of its beginning [s] */
  uint32_t quarter; /* [us] */
} Tempo;

static double time_at(const Tempo *tempo, uint64_t tick) {
  const double ticks = (double)(tick - tempo->tick);
  if (tempo->reader->quarter == 0) return ticks * tempo->reader->tick_time;
  return tempo->time + ticks * tempo->quarter / (1e6 * (double)tempo->reader->quarter);
}

static void change_tempo(Tempo *tempo, const Entry *entry) {
  if (tempo->reader->quarter == 0) return;
  tempo->time = time_at(tempo, entry->tick);
  tempo->tick = entry->tick;
  tempo->quarter = entry->tempo;
}

static Outcome give_times(Reader *reader, MidiFile *file) {
  file->events = calloc(reader->count + 1, sizeof *file->events);
  if (!file->events) return fail_memory();
  if (reader->count > 0) {
    qsort(reader->entries, reader->count, sizeof *reader->entries, compare_entries);
  }
  Tempo tempo = {.reader = reader, .quarter = USUAL_TEMPO};
  for (size_t i = 0; i < reader->count; i++) {
    const Entry *const entry = &reader->entries[i];
    if (entry->message.status == 0) {
      change_tempo(&tempo, entry);
    } else {
      file->events[file->count++] = (MidiFileEvent){time_at(&tempo, entry->tick), entry->message};
    }
  }
  file->length = time_at(&tempo, reader->last);
  return OUTCOME_OK;
}

/* ---- files ---- */

Outcome midi_file_parse(const char *name, const void *bytes, size_t size, MidiFile *file) {
  *file = (MidiFile){0};
  Reader reader = {.name = name, .bytes = bytes, .end = size};
  Outcome outcome = take_header(&reader);
  if (outcome == OUTCOME_OK) outcome = take_tracks(&reader);
  if (outcome == OUTCOME_OK) outcome = give_times(&reader, file);
  free(reader.entries);
  return outcome;
}

Outcome midi_file_read(const char *name, MidiFile *file) {
  char *bytes = NULL;
  size_t size = 0;
  *file = (MidiFile){0};
  Outcome outcome = input_file_read(name, MIDI_FILE_LIMIT, &bytes, &size);
  if (outcome == OUTCOME_OK) outcome = midi_file_parse(name, bytes, size, file);
  free(bytes);
  return outcome;
}

void midi_file_free(MidiFile *file) {
  free(file->events);
  *file = (MidiFile){0};
}
