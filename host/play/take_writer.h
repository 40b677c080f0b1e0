/* SPDX-License-Identifier: MIT */
/**
 * @file take_writer.h
 * Everything that is played goes into a sound file, which a thread of its own writes.
 *
 * If the disk fails, that is said once and playing goes on; the file holds what came before.
 */
#ifndef TABOR_HOST_TAKE_WRITER_H
#define TABOR_HOST_TAKE_WRITER_H

#include "files/audio_file.h"
#include "sound/player.h"

typedef struct TakeWriter TakeWriter;

/** Starts to write what @p player records. @p output is planned, and must outlive the writer. */
Outcome take_writer_start(const AudioFormat *format, OutputFile *output, Player *player,
                          TakeWriter **writer);
/** Waits until the recording has room for @p frames more, or the disk has failed. */
void take_writer_wait(const TakeWriter *writer, uint32_t frames);
/**
 * Writes what is left, once the player is halted, and gives the file its name; @p kept: how many frames it
 * got. Frees. NULL is allowed, and then @p kept stays as it is.
 */
Outcome take_writer_finish(TakeWriter *writer, uint64_t *kept);

#endif
