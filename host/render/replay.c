/* SPDX-License-Identifier: MIT */
#include "render/replay.h"

#include <stdlib.h>
#include <string.h>

#include "base/input_file.h"

#define LIMIT ((size_t)1 << 30) /* bytes of a log: some weeks of playing */

/* A log while it is being read. */
typedef struct Reader {
  Replay *replay;
  char where[INPUT_PLACE_SIZE];      /* "take.log:3:" */
  uint32_t swapped[TABOR_KIT_DRUMS]; /* number of the model that each drum was changed to last */
  bool is_over;                      /* the last line has been read */
} Reader;

/* ---- lists ---- */

/* Makes room for one more item of @p size bytes; NULL if memory is short, and then @p items stays.
 */
static void *grow(void *items, size_t count, size_t *capacity, size_t size) {
  if (count < *capacity) return items;
  const size_t wanted = *capacity ? 2 * *capacity : 256;
  void *const grown = realloc(items, wanted * size);
  if (grown) *capacity = wanted;
  return grown;
}

static Outcome append_message(Replay *replay, const PlayerMessage *message) {
  PlayerMessage *const messages =
    grow(replay->messages, replay->count, &replay->capacity, sizeof *messages);
  if (!messages) return fail_memory();
  replay->messages = messages;
  messages[replay->count++] = *message;
  return OUTCOME_OK;
}

/* Takes the drum over if there is memory for it. */
static Outcome append_model(Replay *replay, LogDrum **drum) {
  LogDrum **const models =
    grow(replay->models, replay->model_count, &replay->model_capacity, sizeof *models);
  if (!models) return fail_memory();
  replay->models = models;
  models[replay->model_count++] = *drum;
  *drum = NULL;
  return OUTCOME_OK;
}

/* ---- lines ---- */

static Outcome take_start(Reader *reader, LogLine *line) {
  if (reader->replay->drum) return refuse("%s the log starts twice", reader->where);
  reader->replay->start = line->start;
  reader->replay->drum = line->drum;
  reader->replay->kit = line->kit;
  line->drum = NULL;
  line->kit = NULL;
  return OUTCOME_OK;
}

static Outcome take_model(const Reader *reader, LogLine *line) {
  const size_t expected = reader->replay->model_count + 1;
  if (line->model == expected) return append_model(reader->replay, &line->drum);
  return refuse("%s model %u: expected number %zu", reader->where, (unsigned)line->model, expected);
}

/* A drum of the kit, one of its samples, or the only drum. */
static Outcome check_address(const Reader *reader, const PlayerMessage *message) {
  const TaborKitDef *const kit = reader->replay->kit;
  const uint32_t drums = kit ? kit->drum_count : 1, drum = message->drum;
  const bool is_note = drum >= TABOR_KIT_NOTE && drum < TABOR_KIT_NOTE + MIDI_VALUES;
  const bool is_event = message->type != PLAYER_MODEL;
  const bool is_whole = drum == TABOR_KIT_ALL || drum == TABOR_KIT_MIX;
  if (drum < drums || (kit && is_event && is_whole)) return OUTCOME_OK;
  if (kit && is_event && is_note && kit->note[drum - TABOR_KIT_NOTE].sample[0]) return OUTCOME_OK;
  if (is_note) {
    return refuse("%s note %u: there is no sample for it", reader->where,
                  (unsigned)(drum - TABOR_KIT_NOTE));
  }
  return refuse("%s drum: not one of the log's, which has %u", reader->where, (unsigned)drums);
}

static Outcome take_message(Reader *reader, const PlayerMessage *message) {
  Replay *const replay = reader->replay;
  const Outcome outcome = check_address(reader, message);
  if (outcome != OUTCOME_OK) return outcome;
  if (replay->count > 0 && message->frame < replay->messages[replay->count - 1].frame) {
    return refuse("%s frame %llu: earlier than the one before", reader->where,
                  (unsigned long long)message->frame);
  }
  if (message->type == PLAYER_MODEL) {
    uint32_t *const swapped = &reader->swapped[message->drum];
    if (message->model <= *swapped || message->model > replay->model_count) {
      return refuse("%s model %u: not a new one of the lines before", reader->where,
                    (unsigned)message->model);
    }
    *swapped = message->model;
  }
  return append_message(replay, message);
}

/* Frame of the last message so far. */
static uint64_t last_frame(const Replay *replay) {
  return replay->count > 0 ? replay->messages[replay->count - 1].frame : 0;
}

static Outcome take_length(const Reader *reader, uint64_t frames) {
  if (frames > UINT32_MAX) return refuse("%s more than 2^32 frames", reader->where);
  reader->replay->frames = (uint32_t)frames;
  return OUTCOME_OK;
}

static Outcome take_end(Reader *reader, const LogLine *line) {
  if (line->frames <= last_frame(reader->replay)) {
    return refuse("%s frames %llu: not after the last message", reader->where,
                  (unsigned long long)line->frames);
  }
  reader->is_over = true;
  reader->replay->lost = line->lost;
  return take_length(reader, line->frames);
}

/* Whatever comes after the last message's frame is not known, unless there is a mark. Other
   messages may have acted at that frame, too: so the sound ends before it. */
static Outcome take_missing_end(const Reader *reader, uint64_t complete) {
  Replay *const replay = reader->replay;
  const uint64_t last = last_frame(replay), frames = complete > last ? complete : last;
  if (!replay->drum) return refuse("%s the log breaks off before its drum", reader->where);
  if (frames == 0) return refuse("%s the log breaks off before any sound", reader->where);
  while (replay->count > 0 && last_frame(replay) >= frames) replay->count--;
  replay->is_cut = true;
  return take_length(reader, frames);
}

static Outcome take_mark(Reader *reader, const LogLine *line) {
  reader->is_over = true;
  reader->replay->lost = line->lost;
  return take_missing_end(reader, line->frames);
}

static Outcome take_line(Reader *reader, LogLine *line) {
  if (reader->is_over) return refuse("%s text follows the end of the log", reader->where);
  if (line->type != LOG_START && !reader->replay->drum) {
    return refuse("%s not the start of a log", reader->where);
  }
  switch (line->type) {
  case LOG_START: return take_start(reader, line);
  case LOG_MODEL: return take_model(reader, line);
  case LOG_MESSAGE: return take_message(reader, &line->message);
  case LOG_MARK: return take_mark(reader, line);
  case LOG_END: break;
  }
  return take_end(reader, line);
}

static Outcome read_line(Reader *reader, const char *text, size_t length) {
  LogLine line;
  Outcome outcome = log_line_read(reader->where, text, length, &line);
  if (outcome == OUTCOME_OK) outcome = take_line(reader, &line);
  free(line.drum);
  free(line.kit);
  return outcome;
}

/* The last line before an end: its writer was killed within it. */
static bool is_cut(const Reader *reader, const char *text, size_t length) {
  return !reader->is_over && log_line_is_cut(text, length);
}

static Outcome read_lines(const char *name, const char *text, size_t length, Replay *replay) {
  Reader reader = {.replay = replay};
  const char *const end = text + length;
  unsigned number = 1;
  input_place(reader.where, name, number);
  while (text < end) {
    const char *const feed = memchr(text, '\n', (size_t)(end - text));
    const char *const stop = feed ? feed : end;
    const size_t size = (size_t)(stop - text);
    if (stop + 1 >= end && is_cut(&reader, text, size)) break;
    const Outcome outcome = read_line(&reader, text, size);
    if (outcome != OUTCOME_OK) return outcome;
    text = feed ? feed + 1 : end;
    input_place(reader.where, name, ++number);
  }
  return reader.is_over ? OUTCOME_OK : take_missing_end(&reader, 0);
}

Outcome replay_read(const char *name, Replay *replay) {
  char *text = NULL;
  size_t length = 0;
  *replay = (Replay){0};
  if (!*name) return refuse("--replay needs the name of a file");
  Outcome outcome = input_file_read(name, LIMIT, &text, &length);
  if (outcome == OUTCOME_OK) outcome = read_lines(name, text, length, replay);
  free(text);
  return outcome;
}

void replay_free(Replay *replay) {
  for (size_t i = 0; i < replay->model_count; i++) free(replay->models[i]);
  free(replay->models);
  free(replay->messages);
  free(replay->drum);
  free(replay->kit);
  *replay = (Replay){0};
}
