/* SPDX-License-Identifier: MIT */
#include "files/audio_file.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "platform/paths.h"

#define FLAC_CHANNELS 8u

/* ---- formats ---- */

bool audio_container(const char *name, AudioContainer *container) {
  static const struct {
    const char *extension;
    AudioContainer container;
  } known[] = {{".wav", AUDIO_WAV}, {".flac", AUDIO_FLAC}, {".au", AUDIO_AU}};
  const char *const base = path_base(name);
  const char *const extension = strrchr(base, '.');
  if (extension == base) return false; /* ".wav" is a hidden file without an extension */
  for (size_t i = 0; extension && i < sizeof known / sizeof known[0]; i++) {
    if (strcasecmp(extension, known[i].extension) == 0) {
      *container = known[i].container;
      return true;
    }
  }
  return false;
}

Outcome audio_encoding(const char *name, AudioEncoding *encoding) {
  static const char *const names[] = {"pcm16", "pcm24", "float"};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    if (strcmp(name, names[i]) == 0) {
      *encoding = (AudioEncoding)i;
      return OUTCOME_OK;
    }
  }
  return refuse("--format '%.80s': unknown; allowed: pcm16, pcm24, float", name);
}

/* libFLAC writes its "streamable subset" only: above 65,535 Hz whole multiples of 10 Hz. */
static bool flac_holds_rate(uint32_t rate) { return rate < 65536 || rate % 10 == 0; }

Outcome audio_format_check(const AudioFormat *format) {
  if (format->container != AUDIO_FLAC) return OUTCOME_OK;
  if (format->encoding == AUDIO_FLOAT) {
    return refuse("--format 'float': FLAC holds whole numbers; allowed: pcm16, pcm24");
  }
  if (format->channels > FLAC_CHANNELS) {
    return refuse("--mic: FLAC holds at most %u channels, %u were asked for", FLAC_CHANNELS,
                  (unsigned)format->channels);
  }
  if (!flac_holds_rate(format->rate)) {
    return refuse("--rate '%u': FLAC holds multiples of 10 above 65535", (unsigned)format->rate);
  }
  return OUTCOME_OK;
}

/* Steps from 0 to full scale. */
static double full_scale_steps(AudioEncoding encoding) {
  return encoding == AUDIO_PCM16 ? 32768.0 : 8388608.0;
}

double audio_largest(AudioEncoding encoding) {
  if (encoding == AUDIO_FLOAT) return INFINITY;
  const double steps = full_scale_steps(encoding);
  return (steps - 1) / steps;
}

double audio_least(AudioEncoding encoding) {
  return encoding == AUDIO_FLOAT ? 0 : 0.5 / full_scale_steps(encoding);
}

/* ---- writing ---- */

/* True if a WAV file could pass 4 GiB, which its header cannot express. */
static bool may_need_rf64(const AudioFormat *format) {
  const uint64_t frame_size = (uint64_t)format->channels * sizeof(float); /* at most */
  return format->container == AUDIO_WAV && format->most_frames > (UINT32_MAX - 65536) / frame_size;
}

static int sndfile_format(const AudioFormat *format) {
  static const int containers[] = {SF_FORMAT_WAV, SF_FORMAT_FLAC, SF_FORMAT_AU};
  static const int encodings[] = {SF_FORMAT_PCM_16, SF_FORMAT_PCM_24, SF_FORMAT_FLOAT};
  const int container = may_need_rf64(format) ? SF_FORMAT_RF64 : containers[format->container];
  return container | encodings[format->encoding];
}

/* libsndfile's own message is the second choice. */
static Outcome sound_failure(const AudioFile *file, SNDFILE *stream) {
  if (file->io.error != 0) errno = file->io.error;
  if (errno != 0) return output_failure(file->output);
  return fail("cannot write '%s': %s", file->output->name, sf_strerror(stream));
}

Outcome audio_file_open(AudioFile *file, const AudioFormat *format, OutputFile *output) {
  *file = (AudioFile){.output = output, .format = *format};
  file->buffer = malloc((size_t)format->channels * AUDIO_BLOCK * sizeof(int));
  if (!file->buffer) return fail_memory();
  SF_INFO info = {.samplerate = (int)format->rate,
                  .channels = (int)format->channels,
                  .format = sndfile_format(format)};
  errno = 0;
  file->stream = output->kind == OUTPUT_STREAMED
                   ? sf_open_fd(output->descriptor, SFM_WRITE, &info, SF_FALSE)
                   : sndfile_io_open(&file->io, output->descriptor, &info);
  if (!file->stream) return sound_failure(file, NULL);
  (void)sf_command(file->stream, SFC_SET_ADD_PEAK_CHUNK, NULL, SF_FALSE); /* holds the time */
  if (may_need_rf64(format)) { /* what turns out to be short is a WAV all the same */
    (void)sf_command(file->stream, SFC_RF64_AUTO_DOWNGRADE, NULL, SF_TRUE);
  }
  return OUTCOME_OK;
}

/* One sample as the upper bits of an int, rounded to the encoding's steps. libsndfile takes just
   these bits, so every container gets the same numbers. */
static int quantise(double sample, double steps) {
  const double number = rint(sample * steps);
  const double largest = steps - 1;
  const double bounded = number > largest ? largest : number >= -steps ? number : -steps;
  return (int)bounded * (int)(2147483648.0 / steps);
}

static sf_count_t write_floats(AudioFile *file, const double *samples, uint32_t frames) {
  float *const encoded = file->buffer;
  const size_t count = (size_t)frames * file->format.channels;
  for (size_t i = 0; i < count; i++) encoded[i] = (float)samples[i];
  return sf_writef_float(file->stream, encoded, frames);
}

static sf_count_t write_integers(AudioFile *file, const double *samples, uint32_t frames) {
  int *const encoded = file->buffer;
  const double steps = full_scale_steps(file->format.encoding);
  const size_t count = (size_t)frames * file->format.channels;
  for (size_t i = 0; i < count; i++) encoded[i] = quantise(samples[i], steps);
  return sf_writef_int(file->stream, encoded, frames);
}

Outcome audio_file_write(AudioFile *file, const double *samples, uint32_t frames) {
  errno = 0;
  const sf_count_t written = file->format.encoding == AUDIO_FLOAT
                               ? write_floats(file, samples, frames)
                               : write_integers(file, samples, frames);
  const bool complete = written == (sf_count_t)frames && file->io.error == 0;
  if (!complete) return sound_failure(file, file->stream);
  file->frames += frames;
  return OUTCOME_OK;
}

/* libsndfile keeps no samples to itself: all of them are in the file. */
Outcome audio_file_refresh(AudioFile *file) {
  errno = 0;
  (void)sf_command(file->stream, SFC_UPDATE_HEADER_NOW, NULL, 0);
  return file->io.error == 0 ? OUTCOME_OK : sound_failure(file, file->stream);
}

/* ---- completing ---- */

/* What cannot be seen in a single write, as a file that has grown too large for its header. */
static Outcome verify(const AudioFile *file) {
  const AudioFormat *const format = &file->format;
  SF_INFO info = {0};
  if (lseek(file->output->descriptor, 0, SEEK_SET) != 0) return output_failure(file->output);
  SNDFILE *const stream = sf_open_fd(file->output->descriptor, SFM_READ, &info, SF_FALSE);
  const bool complete = stream && info.frames == (sf_count_t)file->frames &&
                        info.channels == (int)format->channels &&
                        info.samplerate == (int)format->rate;
  if (stream) (void)sf_close(stream);
  if (complete) return OUTCOME_OK;
  return fail("cannot write '%s': read back, it is not complete", file->output->name);
}

Outcome audio_file_finish(AudioFile *file) {
  SNDFILE *const stream = file->stream;
  file->stream = NULL;
  errno = 0;
  if (sf_close(stream) != 0 || file->io.error != 0) return sound_failure(file, NULL);
  return file->output->kind == OUTPUT_STREAMED ? OUTCOME_OK : verify(file);
}

/* Part of a block may have been written, and counted by libsndfile. It forgets that, and goes to the end of
   the last whole one; but it cannot cut the file. The header is there: renewing it takes no room. */
Outcome audio_file_salvage(AudioFile *file) {
  sf_count_t frames = (sf_count_t)file->frames;
  if (file->output->kind == OUTPUT_STREAMED) return OUTCOME_OK;
  (void)sf_command(file->stream, SFC_FILE_TRUNCATE, &frames, sizeof frames);
  const off_t length = lseek(file->output->descriptor, 0, SEEK_CUR);
  if (ftruncate(file->output->descriptor, length) != 0) return output_failure(file->output);
  file->io.error = 0;
  return audio_file_finish(file);
}

void audio_file_free(AudioFile *file) {
  if (file->stream) (void)sf_close(file->stream);
  free(file->buffer);
  *file = (AudioFile){0};
}
