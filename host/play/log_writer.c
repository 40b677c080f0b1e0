/* SPDX-License-Identifier: MIT */
#include "play/log_writer.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define MARK_TIME 0.5 /* [s] of sound from one mark to the next */

struct LogWriter {
  Player *player;
  OutputFile *output;
  double rate; /* [Hz] */
  pthread_t thread;
  atomic_bool stops;
  uint64_t end; /* behind the last message */

  pthread_mutex_t lock; /* of a line, and of what follows */
  Outcome outcome;      /* of writing */
  uint32_t models;      /* number of the newest */
  uint64_t complete;    /* frame up to which the log has every message */
  uint64_t marked;      /* frame of the mark in the file */
  size_t mark_size;     /* its length: the next line is written over it [bytes] */
};

static void pause_ms(long milliseconds) {
  const struct timespec moment = {.tv_nsec = milliseconds * 1000000};
  (void)nanosleep(&moment, NULL);
}

/* Takes the lines over, or NULL if memory was short; writes them over the mark. No later text is
   shorter than the mark that it replaces, so nothing of that is left behind it. */
static Outcome write_over_mark(LogWriter *writer, char *lines, size_t mark_size) {
  Outcome outcome = lines ? OUTCOME_OK : fail_memory();
  if (outcome == OUTCOME_OK && writer->mark_size > 0) {
    outcome = output_step_back(writer->output, writer->mark_size);
  }
  if (outcome == OUTCOME_OK) outcome = output_write(writer->output, lines, strlen(lines));
  writer->mark_size = mark_size;
  free(lines);
  return outcome;
}

/* The line and a mark in one piece, so that a log never lacks both the old mark and the new one. */
static Outcome write_marked(LogWriter *writer, const char *line) {
  char *const mark = log_line_mark(writer->complete, player_log_lost(writer->player));
  const size_t mark_size = mark ? strlen(mark) : 0, size = strlen(line) + mark_size + 1;
  char *const lines = mark ? malloc(size) : NULL;
  if (lines) (void)snprintf(lines, size, "%s%s", line, mark);
  free(mark);
  if (writer->marked == 0 && writer->complete > 0) output_keep(writer->output);
  writer->marked = writer->complete;
  return write_over_mark(writer, lines, mark_size);
}

/* Adds a line while the drum plays, which it takes over; NULL means that memory was short. What
   goes wrong is said once. Needs the lock. */
static void add_line_locked(LogWriter *writer, char *line) {
  char reason[1000];
  const Outcome before = writer->outcome;
  const MessageCapture capture = message_capture(reason, sizeof reason);
  if (before == OUTCOME_OK) {
    writer->outcome = line ? write_marked(writer, line) : fail_memory();
  }
  free(line);
  message_release(capture);
  if (writer->outcome != before) (void)fail("%s; there is no log then, playing goes on", reason);
}

static void add_line(LogWriter *writer, char *line) {
  (void)pthread_mutex_lock(&writer->lock);
  add_line_locked(writer, line);
  (void)pthread_mutex_unlock(&writer->lock);
}

static void write_messages(LogWriter *writer) {
  const PlayerMessage *message;
  while ((message = player_log(writer->player)) != NULL) {
    add_line(writer, log_line_message(message));
    writer->end = message->frame + 1;
    player_log_next(writer->player);
  }
}

/* Everything that acted before this frame has been written. */
static void note_complete(LogWriter *writer, uint64_t frame) {
  (void)pthread_mutex_lock(&writer->lock);
  writer->complete = frame;
  if ((double)(frame - writer->marked) >= MARK_TIME * writer->rate) {
    add_line_locked(writer, strdup(""));
  }
  (void)pthread_mutex_unlock(&writer->lock);
}

static void *run(void *context) {
  LogWriter *const writer = context;
  while (!atomic_load(&writer->stops)) {
    const uint64_t played = player_position(writer->player); /* before the messages are looked at */
    write_messages(writer);
    note_complete(writer, played);
    pause_ms(5);
  }
  return NULL;
}

static void log_writer_free(LogWriter *writer) {
  (void)pthread_mutex_destroy(&writer->lock);
  free(writer);
}

static Outcome write_start(LogWriter *writer, const LogWriterSetup *setup) {
  LogStart start = setup->start;
  (void)snprintf(start.program, sizeof start.program, "%s", tabor_version());
  return write_over_mark(writer, log_line_start(&start, setup->model, setup->preset), 0);
}

Outcome log_writer_start(const LogWriterSetup *setup, OutputFile *output, LogWriter **started) {
  LogWriter *const writer = calloc(1, sizeof *writer);
  *started = NULL;
  if (!writer) return fail_memory();
  writer->player = setup->player;
  writer->output = output;
  writer->output->findable = true;
  writer->rate = setup->start.rate;
  (void)pthread_mutex_init(&writer->lock, NULL);
  Outcome outcome = output_open(output, true);
  if (outcome == OUTCOME_OK) outcome = write_start(writer, setup);
  if (outcome == OUTCOME_OK && pthread_create(&writer->thread, NULL, run, writer) != 0) {
    outcome = fail("cannot start a thread for the log");
  }
  if (outcome == OUTCOME_OK) {
    *started = writer;
  } else {
    log_writer_free(writer);
  }
  return outcome;
}

uint32_t log_writer_add_model(LogWriter *writer, const TaborModel *model, const char *preset) {
  if (!writer) return 0;
  (void)pthread_mutex_lock(&writer->lock);
  const uint32_t number = ++writer->models;
  add_line_locked(writer, log_line_model(number, model, preset));
  (void)pthread_mutex_unlock(&writer->lock);
  return number;
}

void log_writer_wait(const LogWriter *writer) {
  while (writer && !player_log_has_room(writer->player)) pause_ms(1);
}

/* With its last line, which it takes over. */
static Outcome deliver(LogWriter *writer, char *end) {
  Outcome outcome = writer->outcome;
  if (outcome == OUTCOME_OK) {
    outcome = write_over_mark(writer, end, 0);
  } else {
    free(end);
  }
  if (outcome == OUTCOME_OK) outcome = output_complete(writer->output);
  return outcome == OUTCOME_OK ? output_deliver(&writer->output, 1) : outcome;
}

/* If the audio thread hangs within a block, messages may be ahead of what counts as played. */
Outcome log_writer_finish(LogWriter *writer) {
  if (!writer) return OUTCOME_OK;
  atomic_store(&writer->stops, true);
  (void)pthread_join(writer->thread, NULL);
  write_messages(writer);
  const uint64_t played = player_position(writer->player);
  const uint64_t frames = played > writer->end ? played : writer->end;
  const uint64_t lost = player_log_lost(writer->player);
  const Outcome outcome =
    frames > 0 ? deliver(writer, log_line_end(frames, lost)) : writer->outcome;
  log_writer_free(writer);
  return outcome;
}
