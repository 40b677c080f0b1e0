/* SPDX-License-Identifier: MIT */
#include "clap/stream_text.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Hosts may take less at once than they are given. */
bool stream_write(const clap_ostream_t *stream, const char *text, size_t size) {
  while (size > 0) {
    const int64_t written = stream->write(stream, text, size);
    if (written <= 0 || (uint64_t)written > size) return false;
    text += written;
    size -= (size_t)written;
  }
  return true;
}

char *stream_read(const clap_istream_t *stream, size_t limit) {
  char *const text = calloc(1, limit + 1);
  size_t size = 0;
  while (text && size <= limit) {
    const size_t left = limit + 1 - size;
    const int64_t count = stream->read(stream, text + size, left);
    if (count < 0 || (uint64_t)count > left) break;
    if (count == 0) return text;
    size += (size_t)count;
  }
  free(text);
  return NULL;
}

void stream_float_digits(float value, char digits[9]) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  (void)snprintf(digits, 9, "%08" PRIx32, bits);
}

bool stream_float(const char *digits, float *value) {
  char *end;
  const uint32_t bits = (uint32_t)strtoul(digits, &end, 16);
  memcpy(value, &bits, sizeof bits);
  return end == digits + 8 && isfinite(*value);
}
