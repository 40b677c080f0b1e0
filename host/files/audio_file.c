/* SPDX-License-Identifier: MIT */
#include "files/audio_file.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "files/wav_header.h"
#include "platform/paths.h"

#define FLAC_CHANNELS 8u
/* libFLAC's level 2, of 8: fixed predictors alone, whose choice does not hang on the last bit of a
 * C library's cosine, so that files are the same bytes everywhere. */
#define FLAC_LEVEL 0.25

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

/* True if a WAV file could pass 4 GiB, which a plain header cannot express: then the header is our
 * own. */
static bool has_own_header(const AudioFormat *format, const OutputFile *output) {
  const uint64_t frame_size = (uint64_t)format->channels * sizeof(float); /* at most */
  return format->container == AUDIO_WAV && output->kind != OUTPUT_STREAMED &&
         format->most_frames > (UINT32_MAX - 65536) / frame_size;
}

static int sndfile_format(const AudioFile *file) {
  static const int containers[] = {SF_FORMAT_WAV, SF_FORMAT_FLAC, SF_FORMAT_AU};
  static const int encodings[] = {SF_FORMAT_PCM_16, SF_FORMAT_PCM_24, SF_FORMAT_FLOAT};
  const int container =
    file->own_header ? SF_FORMAT_RAW | SF_ENDIAN_LITTLE : containers[file->format.container];
  return container | encodings[file->format.encoding];
}

static WavFormat wav_format(const AudioFormat *format) {
  static const uint32_t bits[] = {16, 24, 32};
  return (WavFormat){.is_float = format->encoding == AUDIO_FLOAT,
                     .bits = bits[format->encoding],
                     .rate = format->rate,
                     .channels = format->channels};
}

/* libsndfile's own message is the second choice. */
static Outcome sound_failure(const AudioFile *file, SNDFILE *stream) {
  if (file->io.error != 0) errno = file->io.error;
  if (errno != 0) return output_failure(file->output);
  return fail("cannot write '%s': %s", file->output->name, sf_strerror(stream));
}

static Outcome write_at(const AudioFile *file, off_t place, const void *bytes, size_t size) {
  const int descriptor = file->output->descriptor;
  const off_t before = lseek(descriptor, 0, SEEK_CUR);
  const bool written = before >= 0 && lseek(descriptor, place, SEEK_SET) == place &&
                       write(descriptor, bytes, size) == (ssize_t)size &&
                       lseek(descriptor, before, SEEK_SET) == before;
  return written ? OUTCOME_OK : output_failure(file->output);
}

static Outcome write_header(const AudioFile *file) {
  const WavFormat format = wav_format(&file->format);
  uint8_t header[WAV_HEADER_MOST];
  wav_header(&format, file->frames, header);
  return write_at(file, 0, header, wav_header_size(&format));
}

/* Chunks have an even number of bytes. */
static Outcome complete_header(const AudioFile *file) {
  const WavFormat format = wav_format(&file->format);
  const uint64_t size = wav_data_size(&format, file->frames);
  const Outcome outcome = write_header(file);
  if (outcome != OUTCOME_OK || size % 2 == 0) return outcome;
  return write_at(file, (off_t)(wav_header_size(&format) + size), "", 1);
}

Outcome audio_file_open(AudioFile *file, const AudioFormat *format, OutputFile *output) {
  *file =
    (AudioFile){.output = output, .format = *format, .own_header = has_own_header(format, output)};
  file->buffer = malloc((size_t)format->channels * AUDIO_BLOCK * sizeof(int));
  if (!file->buffer) return fail_memory();
  SF_INFO info = {.samplerate = (int)format->rate,
                  .channels = (int)format->channels,
                  .format = sndfile_format(file)};
  const WavFormat wav = wav_format(format);
  long before = 0;
  errno = 0;
  if (file->own_header) {
    const Outcome outcome = write_header(file);
    if (outcome != OUTCOME_OK) return outcome;
    before = wav_header_size(&wav);
    if (lseek(output->descriptor, before, SEEK_SET) < 0) return output_failure(output);
  }
  file->stream = output->kind == OUTPUT_STREAMED
                   ? sf_open_fd(output->descriptor, SFM_WRITE, &info, SF_FALSE)
                   : sndfile_io_open(&file->io, output->descriptor, before, &info);
  if (!file->stream) return sound_failure(file, NULL);
  (void)sf_command(file->stream, SFC_SET_ADD_PEAK_CHUNK, NULL, SF_FALSE); /* holds the time */
  double level = FLAC_LEVEL;
  (void)sf_command(file->stream, SFC_SET_COMPRESSION_LEVEL, &level, sizeof level);
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
  if (file->own_header) return write_header(file);
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
  const Outcome outcome = file->own_header ? complete_header(file) : OUTCOME_OK;
  if (outcome != OUTCOME_OK) return outcome;
  return file->output->kind == OUTPUT_STREAMED ? OUTCOME_OK : verify(file);
}

/* Part of a block may have been written, and counted by libsndfile. It forgets that, and goes to
   the end of the last whole one; but it cannot cut the file. The header is there: renewing it takes
   no room. */
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
