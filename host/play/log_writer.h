/* SPDX-License-Identifier: MIT */
/**
 * @file log_writer.h
 * Writes the log of a performance (log_line.h), on a separate thread: every message that acted,
 * with its frame.
 *
 * While it plays, the file has a name that a person finds (output_file.h) and ends with a mark,
 * which says up to where the log is complete. It is renewed with every line, and at least every
 * half second of sound.
 *
 * If the disk fails, one message reports it, playing continues, and there is no log: it could not
 * be replayed.
 */
#ifndef TABOR_HOST_LOG_WRITER_H
#define TABOR_HOST_LOG_WRITER_H

#include "base/output_file.h"
#include "render/log_line.h"
#include "sound/player.h"

typedef struct LogWriter LogWriter;

/** What a log starts with. */
typedef struct LogWriterSetup {
  Player *player;
  LogStart start;          /**< without the program's version */
  const TaborModel *model; /**< of the drum at the start, or of one of the kit's */
  const char *preset;
} LogWriterSetup;

/** Starts to write. @p output is planned and must outlive the writer. */
Outcome log_writer_start(const LogWriterSetup *setup, OutputFile *output, LogWriter **writer);
/** Adds a model before the message that changes a drum to it is sent; returns its number for that
 * message. Any thread but the audio thread. NULL is allowed. */
uint32_t log_writer_add_model(LogWriter *writer, const TaborModel *model, const char *preset);
/** Waits until the log has room for what may wait. NULL is allowed. */
void log_writer_wait(const LogWriter *writer);
/**
 * Writes the rest, gives the file its name, unless nothing was played, and frees the writer. Call
 * once the player is halted and no more models are added. NULL is allowed.
 */
Outcome log_writer_finish(LogWriter *writer);

#endif
