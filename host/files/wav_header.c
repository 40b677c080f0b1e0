/* SPDX-License-Identifier: MIT */
#include "files/wav_header.h"

#include <string.h>

enum { PCM = 1, IEEE_FLOAT = 3 };
enum {
  LENGTHS = 28,
  FORMAT = 16,
  FLOAT_FORMAT = 18,
  FACT = 4
}; /* bytes of the chunks ds64, fmt, fact */

/* Where the header is written next. */
typedef struct Writer {
  uint8_t *to;
} Writer;

static void put_name(Writer *writer, const char *name) {
  memcpy(writer->to, name, 4);
  writer->to += 4;
}

static void put_number(Writer *writer, uint32_t bytes, uint64_t number) {
  for (uint32_t i = 0; i < bytes; i++) *writer->to++ = (uint8_t)(number >> 8 * i);
}

static uint32_t frame_size(const WavFormat *format) { return format->bits / 8 * format->channels; }

uint64_t wav_data_size(const WavFormat *format, uint64_t frames) {
  return frames * frame_size(format);
}

static void put_lengths(Writer *writer, bool large, uint64_t riff, uint64_t data, uint64_t frames) {
  put_name(writer, large ? "ds64" : "JUNK");
  put_number(writer, 4, LENGTHS);
  put_number(writer, 8, large ? riff : 0);
  put_number(writer, 8, large ? data : 0);
  put_number(writer, 8, large ? frames : 0);
  put_number(writer, 4, 0); /* no further lengths */
}

static void put_format(Writer *writer, const WavFormat *format) {
  put_name(writer, "fmt ");
  put_number(writer, 4, format->is_float ? FLOAT_FORMAT : FORMAT);
  put_number(writer, 2, format->is_float ? IEEE_FLOAT : PCM);
  put_number(writer, 2, format->channels);
  put_number(writer, 4, format->rate);
  put_number(writer, 4, (uint64_t)format->rate * frame_size(format));
  put_number(writer, 2, frame_size(format));
  put_number(writer, 2, format->bits);
  if (format->is_float) put_number(writer, 2, 0); /* no further fields */
}

/* The length, which all encodings but PCM give again. */
static void put_fact(Writer *writer, uint64_t frames) {
  put_name(writer, "fact");
  put_number(writer, 4, FACT);
  put_number(writer, 4, frames < UINT32_MAX ? frames : UINT32_MAX);
}

uint32_t wav_header_size(const WavFormat *format) { return format->is_float ? 94 : 80; }

void wav_header(const WavFormat *format, uint64_t frames, uint8_t header[WAV_HEADER_MOST]) {
  const uint64_t data = wav_data_size(format, frames);
  const uint64_t riff = wav_header_size(format) - 8 + data + (data & 1u);
  const bool large = riff > UINT32_MAX;
  Writer writer = {header};
  put_name(&writer, large ? "RF64" : "RIFF");
  put_number(&writer, 4, large ? UINT32_MAX : riff);
  put_name(&writer, "WAVE");
  put_lengths(&writer, large, riff, data, frames);
  put_format(&writer, format);
  if (format->is_float) put_fact(&writer, frames);
  put_name(&writer, "data");
  put_number(&writer, 4, large ? UINT32_MAX : data);
}
