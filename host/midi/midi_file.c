/* SPDX-License-Identifier: MIT */
#include "midi/midi_file.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHUNK_HEAD 8 /* bytes: its name and its length */
#define HEADER_LEAST 6
#define USUAL_TEMPO 500000u /* [us] for a quarter */

enum { META = 0xFF, SYSEX = 0xF0, SYSEX_REST = 0xF7 };
enum { META_END = 0x2F, META_TEMPO = 0x51 };
static const uint64_t MOST_TICKS = (uint64_t)1 << 53; /* exact as a double */
enum { MOST_LENGTH_BYTES = 8, STANDARD_LENGTH_BYTES = 4 };

/* A channel message or, with status 0, a tempo [us] for a quarter. */
typedef struct Entry {
  uint64_t tick;
  size_t place; /* in the file, to keep the order of what comes at one tick */
  uint32_t tempo;
  MidiMessage message;
} Entry;

/* A file being read. */
typedef struct Reader {
  const uint8_t *bytes;
  size_t at, end;   /* end: of the chunk that is read, or of the file */
  unsigned track;   /* from 1; 0 outside of tracks */
  unsigned found;   /* tracks so far */
  unsigned format;  /* 0 or 1 */
  unsigned tracks;  /* that the header announces */
  uint64_t quarter; /* ticks of a quarter, or 0: ticks have their own length */
  double tick_time; /* [s], without quarter */
  uint64_t tick;    /* now, in this track */
  uint64_t last;    /* tick, of all tracks */
  uint8_t status;   /* running, or 0 */
  bool ended;       /* the track */
  Entry *entries;
  size_t count, capacity;
  MidiFileReport *report;
} Reader;

#if defined(__GNUC__)
#  define PRINTF_PLACE __attribute__((format(printf, 3, 4)))
#else
#  define PRINTF_PLACE
#endif

/* ---- bytes ---- */

static void print_place(const Reader *reader, size_t at, const char *format, va_list arguments,
                        char text[MIDI_FILE_TEXT]) {
  const int used = reader->track == 0
                     ? snprintf(text, MIDI_FILE_TEXT, "byte %zu: ", at)
                     : snprintf(text, MIDI_FILE_TEXT, "byte %zu, track %u: ", at, reader->track);
  (void)vsnprintf(text + used, MIDI_FILE_TEXT - (size_t)used, format, arguments);
}

/* What makes the file unreadable, at byte `at`. */
PRINTF_PLACE static MidiFileStatus refuse_at(const Reader *reader, size_t at, const char *format,
                                             ...) {
  va_list arguments;
  va_start(arguments, format);
  print_place(reader, at, format, arguments, reader->report->error);
  va_end(arguments);
  return MIDI_FILE_REFUSED;
}

/* What is passed over, at byte `at`. */
PRINTF_PLACE static void warn_at(const Reader *reader, size_t at, const char *format, ...) {
  MidiFileReport *const report = reader->report;
  va_list arguments;
  if (report->warnings++ >= MIDI_FILE_MOST_WARNINGS) return;
  va_start(arguments, format);
  print_place(reader, at, format, arguments, report->warning[report->warnings - 1]);
  va_end(arguments);
}

static size_t left(const Reader *reader) { return reader->end - reader->at; }

/* Of a number of @p count bytes, the highest first, which are known to be there. */
static uint32_t take_number(Reader *reader, size_t count) {
  uint32_t number = 0;
  for (size_t i = 0; i < count; i++) number = number << 8 | reader->bytes[reader->at++];
  return number;
}

static MidiFileStatus take_byte(Reader *reader, uint8_t *byte) {
  if (left(reader) == 0) return refuse_at(reader, reader->at, "the track breaks off in an event");
  *byte = reader->bytes[reader->at++];
  return MIDI_FILE_OK;
}

/* Seven bits a byte; the standard has at most four of them. */
static MidiFileStatus take_length(Reader *reader, uint64_t *length) {
  const size_t start = reader->at;
  uint8_t byte = 0x80;
  int count = 0;
  *length = 0;
  while (count < MOST_LENGTH_BYTES && byte & 0x80u) {
    const MidiFileStatus status = take_byte(reader, &byte);
    if (status != MIDI_FILE_OK) return status;
    *length = *length << 7 | (byte & 0x7Fu);
    count++;
  }
  if (byte & 0x80u) {
    return refuse_at(reader, start, "a time or length of more than %d bytes", MOST_LENGTH_BYTES);
  }
  if (count > STANDARD_LENGTH_BYTES) {
    warn_at(reader, start, "a time or length of %d bytes; allowed: up to %d", count,
            STANDARD_LENGTH_BYTES);
  }
  return MIDI_FILE_OK;
}

/* ---- events ---- */

static MidiFileStatus add_entry(Reader *reader, size_t at, Entry entry) {
  if (reader->count == MIDI_FILE_MOST_EVENTS) {
    return refuse_at(reader, at, "too many events; allowed: up to %d", MIDI_FILE_MOST_EVENTS);
  }
  if (reader->count == reader->capacity) {
    const size_t capacity = reader->capacity ? 2 * reader->capacity : 1024;
    Entry *const entries = realloc(reader->entries, capacity * sizeof *entries);
    if (!entries) return MIDI_FILE_NO_MEMORY;
    reader->entries = entries;
    reader->capacity = capacity;
  }
  entry.tick = reader->tick;
  entry.place = reader->count;
  reader->entries[reader->count++] = entry;
  return MIDI_FILE_OK;
}

/* The end of the track within an event costs nothing if that is no note. */
static MidiFileStatus break_off(Reader *reader, size_t at) {
  warn_at(reader, at, "the track breaks off in an event, which is passed over");
  reader->at = reader->end;
  reader->ended = true;
  return MIDI_FILE_OK;
}

/* A wrong data byte takes the place of a right one. */
static MidiFileStatus take_message(Reader *reader, size_t at, uint8_t status) {
  MidiMessage message = {.status = status};
  const bool is_note = midi_kind(&message) <= MIDI_NOTE_ON;
  const uint8_t count = midi_data_count(status);
  bool is_right = true;
  if (left(reader) < count && !is_note) return break_off(reader, at);
  for (uint8_t i = 0; i < count; i++) {
    const MidiFileStatus taken = take_byte(reader, &message.data[i]);
    if (taken != MIDI_FILE_OK) return taken;
    if (!(message.data[i] & 0x80u)) continue;
    if (is_note) return refuse_at(reader, reader->at - 1, "a data byte over 127 in a note");
    warn_at(reader, reader->at - 1,
            "a data byte of %u in a message, which is passed over; allowed: "
            "up to 127",
            message.data[i]);
    is_right = false;
  }
  return is_right ? add_entry(reader, at, (Entry){.message = message}) : MIDI_FILE_OK;
}

/* What only belongs on a cable, with its data. */
static MidiFileStatus skip_system_message(Reader *reader, size_t at, uint8_t status) {
  const size_t data = status == 0xF2 ? 2 : status == 0xF1 || status == 0xF3 ? 1 : 0;
  warn_at(reader, at, "a system message %02X, which no file may hold, is passed over", status);
  reader->at += data < left(reader) ? data : left(reader);
  return MIDI_FILE_OK;
}

static MidiFileStatus take_tempo(Reader *reader, size_t at, uint64_t length) {
  if (length != 3) return MIDI_FILE_OK; /* named by check_meta() */
  const uint32_t tempo = take_number(reader, 3);
  if (tempo > 0) return add_entry(reader, at, (Entry){.tempo = tempo});
  warn_at(reader, at, "a tempo of 0 us for a quarter is passed over; allowed: 1 to 16777215");
  return MIDI_FILE_OK;
}

/* Meta events whose length the standard fixes. */
static void check_meta(const Reader *reader, size_t at, uint8_t type, uint64_t length) {
  static const struct {
    uint8_t type, length;
    const char *name;
  } KNOWN[] = {{0x20, 1, "channel prefix"},   {0x21, 1, "port"},
               {META_END, 0, "end of track"}, {META_TEMPO, 3, "tempo"},
               {0x54, 5, "SMPTE offset"},     {0x58, 4, "time signature"},
               {0x59, 2, "key signature"}};
  for (size_t i = 0; i < sizeof KNOWN / sizeof *KNOWN; i++) {
    if (type != KNOWN[i].type || length == KNOWN[i].length) continue;
    warn_at(reader, at, "%s of %llu bytes is passed over; allowed: %u", KNOWN[i].name,
            (unsigned long long)length, KNOWN[i].length);
  }
}

/* A meta event or system exclusive data: a length and as many bytes. */
static MidiFileStatus take_block(Reader *reader, size_t at, uint8_t status) {
  uint8_t type = 0;
  uint64_t length = 0;
  MidiFileStatus taken = status == META ? take_byte(reader, &type) : MIDI_FILE_OK;
  if (taken == MIDI_FILE_OK) taken = take_length(reader, &length);
  if (taken != MIDI_FILE_OK) return taken;
  if (length > left(reader)) {
    return refuse_at(reader, at, "an event is longer than the rest of its track");
  }
  const size_t end = reader->at + (size_t)length;
  if (status == META) check_meta(reader, at, type, length);
  if (status == META && type == META_TEMPO) taken = take_tempo(reader, at, length);
  reader->ended = status == META && type == META_END;
  reader->at = end;
  return taken;
}

/* The rest of the track is the beginning of a time. */
static bool is_unfinished_time(const Reader *reader) {
  size_t at = reader->at;
  while (at < reader->end && reader->bytes[at] & 0x80u) at++;
  return at == reader->end;
}

/* Running status goes on behind meta events: not as the standard says, but as files are. */
static MidiFileStatus take_event(Reader *reader) {
  const size_t start = reader->at;
  uint64_t delta = 0;
  uint8_t byte = 0;
  if (is_unfinished_time(reader)) return break_off(reader, start);
  const MidiFileStatus taken = take_length(reader, &delta);
  if (taken != MIDI_FILE_OK) return taken;
  reader->tick += delta;
  if (reader->tick > MOST_TICKS) {
    return refuse_at(reader, start, "a time of %llu ticks; allowed: up to %llu",
                     (unsigned long long)reader->tick, (unsigned long long)MOST_TICKS);
  }
  const size_t at = reader->at;
  if (left(reader) == 0) return break_off(reader, start);
  (void)take_byte(reader, &byte);
  if (byte == META || byte == SYSEX || byte == SYSEX_REST) return take_block(reader, at, byte);
  if (byte >= SYSEX) return skip_system_message(reader, at, byte);
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
static MidiFileStatus enter_chunk(Reader *reader, uint32_t *length) {
  const size_t at = reader->at;
  reader->at += 4;
  *length = take_number(reader, 4);
  if (*length <= left(reader)) return MIDI_FILE_OK;
  return refuse_at(reader, at, "the file ends %zu bytes before its chunk of %u does",
                   *length - left(reader), (unsigned)*length);
}

static MidiFileStatus take_track(Reader *reader, uint32_t length) {
  const size_t file_end = reader->end, end = reader->at + length;
  MidiFileStatus status = MIDI_FILE_OK;
  if (reader->found == MIDI_FILE_MOST_TRACKS) {
    return refuse_at(reader, reader->at, "too many tracks; allowed: up to %d",
                     MIDI_FILE_MOST_TRACKS);
  }
  reader->track = ++reader->found;
  reader->end = end;
  reader->tick = 0;
  reader->status = 0;
  reader->ended = false;
  while (status == MIDI_FILE_OK && !reader->ended && left(reader) > 0) status = take_event(reader);
  if (status == MIDI_FILE_OK && !reader->ended) {
    warn_at(reader, reader->at, "the track ends without an event that says so");
  }
  if (status == MIDI_FILE_OK && left(reader) > 0) {
    warn_at(reader, reader->at, "%zu bytes behind the end of the track are passed over",
            left(reader));
  }
  if (reader->tick > reader->last) reader->last = reader->tick;
  reader->track = 0;
  reader->at = end;
  reader->end = file_end;
  return status;
}

/* A chunk that the file has room for: of a track, or one that its four letters name. */
static bool is_other_chunk(const Reader *reader) {
  const uint8_t *const head = reader->bytes + reader->at;
  const uint32_t length =
    (uint32_t)head[4] << 24 | (uint32_t)head[5] << 16 | (uint32_t)head[6] << 8 | head[7];
  for (int i = 0; i < 4; i++) {
    if (head[i] < 0x20 || head[i] > 0x7E) return false;
  }
  return length <= left(reader) - CHUNK_HEAD;
}

/* Bytes that belong to no chunk, up to the next track or the end of the file. */
static void skip_junk(Reader *reader) {
  const size_t start = reader->at;
  while (left(reader) > 0 && !(left(reader) >= CHUNK_HEAD && is_chunk(reader, "MTrk")))
    reader->at++;
  warn_at(reader, start, "%zu bytes that belong to no chunk are passed over", reader->at - start);
}

/* All tracks that are there, whatever the header says. */
static MidiFileStatus take_tracks(Reader *reader) {
  MidiFileStatus status = MIDI_FILE_OK;
  while (status == MIDI_FILE_OK && left(reader) > 0) {
    uint32_t length = 0;
    if (left(reader) >= CHUNK_HEAD && is_chunk(reader, "MTrk")) {
      status = enter_chunk(reader, &length);
      if (status == MIDI_FILE_OK) status = take_track(reader, length);
    } else if (left(reader) >= CHUNK_HEAD && is_other_chunk(reader)) {
      (void)enter_chunk(reader, &length);
      reader->at += length;
    } else {
      skip_junk(reader);
    }
  }
  return status;
}

static MidiFileStatus check_tracks(const Reader *reader) {
  const unsigned found = reader->found;
  if (found == 0) return refuse_at(reader, reader->end, "the file has no track");
  if (found != reader->tracks) {
    warn_at(reader, 10, "%u tracks are announced, %u are there and play", reader->tracks, found);
  } else if (reader->format == 0 && found > 1) {
    warn_at(reader, 10, "%u tracks in a file of format 0, all of which play; allowed: 1", found);
  }
  return MIDI_FILE_OK;
}

/* ---- header ---- */

static MidiFileStatus take_frame_division(Reader *reader, uint32_t division) {
  const unsigned frames = 256 - (division >> 8), ticks = division & 0xFFu;
  const double rate = frames == 29 ? 30000.0 / 1001 : frames;
  if ((frames != 24 && frames != 25 && frames != 29 && frames != 30) || ticks == 0) {
    return refuse_at(
      reader, reader->at - 2,
      "%u ticks in each of %u frames a second; allowed: 1 to 255 in 24, 25, 29 or 30", ticks,
      frames);
  }
  reader->tick_time = 1 / (rate * ticks);
  return MIDI_FILE_OK;
}

static MidiFileStatus take_division(Reader *reader, uint32_t division) {
  if (division & 0x8000u) return take_frame_division(reader, division);
  if (division == 0) {
    return refuse_at(reader, reader->at - 2, "0 ticks for a quarter; allowed: 1 to 32767");
  }
  reader->quarter = division;
  return MIDI_FILE_OK;
}

/* The data of a RIFF file of the kind RMID; other files are left as they are. */
static MidiFileStatus enter_riff(Reader *reader) {
  if (left(reader) < 12 || !is_chunk(reader, "RIFF") || memcmp(reader->bytes + 8, "RMID", 4) != 0) {
    return MIDI_FILE_OK;
  }
  reader->at = 12;
  while (left(reader) >= CHUNK_HEAD) {
    const uint8_t *const size = reader->bytes + reader->at + 4;
    const uint32_t length =
      (uint32_t)size[3] << 24 | (uint32_t)size[2] << 16 | (uint32_t)size[1] << 8 | size[0];
    const bool is_data = is_chunk(reader, "data");
    reader->at += CHUNK_HEAD;
    if (length > left(reader)) break;
    if (is_data) {
      reader->end = reader->at + length;
      return MIDI_FILE_OK;
    }
    reader->at += length + (length & 1u) <= left(reader) ? length + (length & 1u) : left(reader);
  }
  return refuse_at(reader, 0, "not a Standard MIDI File, nor a RIFF file that holds one");
}

static MidiFileStatus take_header(Reader *reader) {
  uint32_t length = 0;
  MidiFileStatus status = enter_riff(reader);
  if (status != MIDI_FILE_OK) return status;
  const size_t at = reader->at;
  if (left(reader) < CHUNK_HEAD || !is_chunk(reader, "MThd")) {
    return refuse_at(reader, at,
                     "not a Standard MIDI File: it does not begin with a header 'MThd'");
  }
  if (left(reader) < CHUNK_HEAD + HEADER_LEAST) {
    return refuse_at(reader, at, "the file breaks off in its header");
  }
  status = enter_chunk(reader, &length);
  if (status != MIDI_FILE_OK) return status;
  if (length < HEADER_LEAST) return refuse_at(reader, at + 4, "a header of less than 6 bytes");
  reader->format = take_number(reader, 2);
  reader->tracks = take_number(reader, 2);
  if (reader->format > 1) {
    return refuse_at(reader, at + 8, "format %u; allowed: 0 and 1", reader->format);
  }
  status = take_division(reader, take_number(reader, 2));
  reader->at += length - HEADER_LEAST;
  return status;
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

static MidiFileStatus give_times(Reader *reader, MidiFile *file) {
  file->events = calloc(reader->count + 1, sizeof *file->events);
  if (!file->events) return MIDI_FILE_NO_MEMORY;
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
  return MIDI_FILE_OK;
}

/* ---- files ---- */

/* Those that are not told are counted in one line. */
static void count_warnings(MidiFileReport *report) {
  const uint32_t most = MIDI_FILE_MOST_WARNINGS;
  report->lines = report->warnings < most ? report->warnings : most;
  if (report->warnings == report->lines) return;
  (void)snprintf(report->warning[report->lines++], MIDI_FILE_TEXT, "%u more warnings",
                 (unsigned)(report->warnings - most));
}

MidiFileStatus midi_file_decode(const void *bytes, size_t size, MidiFile *file,
                                MidiFileReport *report) {
  *file = (MidiFile){0};
  *report = (MidiFileReport){.warnings = 0};
  Reader reader = {.bytes = bytes, .end = size, .report = report};
  MidiFileStatus status = take_header(&reader);
  if (status == MIDI_FILE_OK) status = take_tracks(&reader);
  if (status == MIDI_FILE_OK) status = check_tracks(&reader);
  if (status == MIDI_FILE_OK) status = give_times(&reader, file);
  free(reader.entries);
  count_warnings(report);
  return status;
}

void midi_file_free(MidiFile *file) {
  free(file->events);
  *file = (MidiFile){0};
}
