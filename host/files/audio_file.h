/* SPDX-License-Identifier: MIT */
/**
 * @file audio_file.h
 * Sound files: WAV (RF64 beyond 4 GiB), FLAC, AU. The same samples give the same bytes.
 */
#ifndef TABOR_HOST_AUDIO_FILE_H
#define TABOR_HOST_AUDIO_FILE_H

#include <sndfile.h>
#include <stdint.h>

#include "base/output_file.h"
#include "files/sndfile_io.h"

#define DEFAULT_ENCODING "pcm24" /**< of commands that are given none */

typedef enum AudioContainer { AUDIO_WAV, AUDIO_FLAC, AUDIO_AU } AudioContainer;
typedef enum AudioEncoding { AUDIO_PCM16, AUDIO_PCM24, AUDIO_FLOAT } AudioEncoding;

typedef struct AudioFormat {
  AudioContainer container;
  AudioEncoding encoding;
  uint32_t rate; /**< [Hz] */
  uint32_t channels;
  uint64_t most_frames; /**< longest length of the sound */
} AudioFormat;

/** A sound file being written to an open OutputFile, which it does not own. Must not be moved or
 * copied. */
typedef struct AudioFile {
  OutputFile *output;
  AudioFormat format;
  bool own_header; /**< a WAV of unknown length: see wav_header.h */
  SndfileIo io;    /**< destination of stream, unless that is a pipe */
  SNDFILE *stream;
  void *buffer; /**< the encoded samples of one block */
  uint64_t frames;
} AudioFile;

/** Most frames that audio_file_write() takes. */
#define AUDIO_BLOCK 256

/** Finds the container by the extension of @p name; false for another extension. */
bool audio_container(const char *name, AudioContainer *container);
/** Finds the encoding called @p name ("pcm16", "pcm24", "float"). */
Outcome audio_encoding(const char *name, AudioEncoding *encoding);
/** Refuses a format that the container cannot hold: FLAC has no float, up to 8 channels, only round
 * rates. */
Outcome audio_format_check(const AudioFormat *format);
/** Largest sample that the encoding holds (1 is full scale; infinite for float). */
double audio_largest(AudioEncoding encoding);

/** Half of the encoding's step: smaller samples become zero (0 for float). */
double audio_least(AudioEncoding encoding);

/** Starts the file. Free with audio_file_free(), whatever the outcome. */
Outcome audio_file_open(AudioFile *file, const AudioFormat *format, OutputFile *output);
/** Appends @p frames frames, interleaved; integer encodings round and saturate. */
Outcome audio_file_write(AudioFile *file, const double *samples, uint32_t frames);
/** Writes the header for the frames so far, so that the file can be read up to here if the program
 * is killed. Only if the file can be read back, and not for FLAC. */
Outcome audio_file_refresh(AudioFile *file);
/** Completes the file; if it can be read back, reopens it and checks that it is complete. */
Outcome audio_file_finish(AudioFile *file);
/**
 * Call after audio_file_write() has failed: makes a valid file of the frames written before. Works
 * only if the file can be read back, and not for FLAC.
 */
Outcome audio_file_salvage(AudioFile *file);
void audio_file_free(AudioFile *file);

#endif
