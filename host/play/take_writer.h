/* SPDX-License-Identifier: MIT */
/**
 * @file take_writer.h
 * Records everything that is played into a sound file, on a separate thread.
 *
 * While it plays, the file has a name that a person finds (output_file.h), and its header is
 * renewed every half second of sound: a program that is killed leaves a sound file that lacks its
 * last moments only.
 *
 * If the disk fails, one message reports it and playing continues; the file keeps the sound up to
 * then.
 */
#ifndef TABOR_HOST_TAKE_WRITER_H
#define TABOR_HOST_TAKE_WRITER_H

#include "files/audio_file.h"
#include "sound/recording.h"

typedef struct TakeWriter TakeWriter;

/** Starts to write @p recording. @p output is planned; both must outlive the writer. */
Outcome take_writer_start(const AudioFormat *format, OutputFile *output, Recording *recording,
                          TakeWriter **writer);
/** Waits until the recording has room for @p frames more frames, or the disk has failed. */
void take_writer_wait(const TakeWriter *writer, uint32_t frames);
/**
 * Writes the rest, gives the file its name and frees the writer. Call once the recording is handed
 * over. @p kept: number of frames in the file; unchanged if the writer is NULL, which is allowed.
 */
Outcome take_writer_finish(TakeWriter *writer, uint64_t *kept);

#endif
