/* SPDX-License-Identifier: MIT */
/**
 * @file wav.h
 * Writes one channel of float samples as a WAV file, for C and C++.
 */
#ifndef TABOR_EXAMPLES_WAV_H
#define TABOR_EXAMPLES_WAV_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { WAV_HEADER_SIZE = 44, WAV_FLOAT = 3 };

/* Puts the lowest @p bytes of @p value to @p at, lowest first. */
static inline void wav_put(uint8_t *at, uint32_t value, int bytes) {
  for (int i = 0; i < bytes; i++) at[i] = (uint8_t)(value >> (8 * i));
}

static inline void wav_put_samples(uint8_t *bytes, const float *samples, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) {
    uint32_t bits;
    memcpy(&bits, &samples[i], sizeof bits);
    wav_put(bytes + 4 * i, bits, 4);
  }
}

/** Writes @p count samples of rate @p rate [Hz] to the file @p path; false if that failed. */
static inline bool wav_write(const char *path, uint32_t rate, const float *samples,
                             uint32_t count) {
  uint8_t header[WAV_HEADER_SIZE] = "RIFF    WAVEfmt ";
  wav_put(header + 4, WAV_HEADER_SIZE - 8 + 4 * count, 4);
  wav_put(header + 16, 16, 4); /* bytes of the format */
  wav_put(header + 20, WAV_FLOAT, 2);
  wav_put(header + 22, 1, 2); /* channel */
  wav_put(header + 24, rate, 4);
  wav_put(header + 28, 4 * rate, 4); /* bytes a second */
  wav_put(header + 32, 4, 2);        /* bytes a frame */
  wav_put(header + 34, 32, 2);       /* bits a sample */
  memcpy(header + 36, "data", 4);
  wav_put(header + 40, 4 * count, 4);

  FILE *const file = fopen(path, "wb");
  if (!file) return false;
  bool good = fwrite(header, 1, sizeof header, file) == sizeof header;
  for (uint32_t i = 0; i < count && good; i += 256) {
    uint8_t bytes[4 * 256];
    const uint32_t some = count - i < 256 ? count - i : 256;
    wav_put_samples(bytes, samples + i, some);
    good = fwrite(bytes, 4, some, file) == some;
  }
  return fclose(file) == 0 && good;
}

#endif
