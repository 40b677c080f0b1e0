/* SPDX-License-Identifier: MIT */
/* Headers of WAV files of unknown length, as libsndfile reads them. */
#include "files/wav_header.h"

#include <setjmp.h>
#include <sndfile.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

/* A file of which the header is there, and zeros. */
typedef struct Zeros {
  uint8_t header[WAV_HEADER_MOST];
  sf_count_t header_size, size, at;
} Zeros;

static sf_count_t length(void *context) { return ((Zeros *)context)->size; }
static sf_count_t tell(void *context) { return ((Zeros *)context)->at; }

static sf_count_t seek(sf_count_t offset, int whence, void *context) {
  Zeros *const file = context;
  const sf_count_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? file->at : file->size;
  return file->at = from + offset;
}

static sf_count_t read_bytes(void *bytes, sf_count_t count, void *context) {
  Zeros *const file = context;
  sf_count_t i = 0;
  for (; i < count && file->at < file->size; i++, file->at++) {
    ((uint8_t *)bytes)[i] = file->at < file->header_size ? file->header[file->at] : 0;
  }
  return i;
}

static void read_back(const WavFormat *format, uint64_t frames, int expected) {
  SF_VIRTUAL_IO calls = {.get_filelen = length, .seek = seek, .read = read_bytes, .tell = tell};
  Zeros file = {.header_size = wav_header_size(format)};
  SF_INFO info = {0};
  const uint64_t data = wav_data_size(format, frames);
  wav_header(format, frames, file.header);
  file.size = file.header_size + (sf_count_t)(data + data % 2);
  SNDFILE *const stream = sf_open_virtual(&calls, SFM_READ, &info, &file);
  assert_non_null(stream);
  assert_int_equal(info.frames, frames);
  assert_int_equal(info.channels, format->channels);
  assert_int_equal(info.samplerate, format->rate);
  assert_int_equal(info.format, expected);
  sf_close(stream);
}

/* Plain up to 4 GiB, RF64 beyond; no WAVE_FORMAT_EXTENSIBLE, whose tag is 65534. */
static void every_length_is_read_back(void **state) {
  (void)state;
  static const struct {
    WavFormat format;
    int encoding;
  } KINDS[] = {{{false, 16, 48000, 1}, SF_FORMAT_PCM_16},
               {{false, 24, 44100, 1}, SF_FORMAT_PCM_24},
               {{true, 32, 96000, 2}, SF_FORMAT_FLOAT}};
  static const uint64_t FRAMES[] = {0, 1, 48001, (uint64_t)1 << 29, 3000000000u};
  for (size_t k = 0; k < 3; k++) {
    for (size_t i = 0; i < sizeof FRAMES / sizeof *FRAMES; i++) {
      const WavFormat *const format = &KINDS[k].format;
      uint8_t header[WAV_HEADER_MOST];
      const bool large = wav_data_size(format, FRAMES[i]) > 4294967295u - WAV_HEADER_MOST;
      read_back(format, FRAMES[i], KINDS[k].encoding | (large ? SF_FORMAT_RF64 : SF_FORMAT_WAV));
      wav_header(format, FRAMES[i], header);
      assert_memory_equal(header, large ? "RF64" : "RIFF", 4);
      assert_int_equal(header[56], format->is_float ? 3 : 1); /* the tag */
      assert_int_equal(header[57], 0);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(every_length_is_read_back)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
