/* SPDX-License-Identifier: MIT */
/**
 * @file wav_header.h
 * The header of a WAV file whose length is not known before it ends: a plain one, which every
 * reader knows, as long as the file has less than 4 GiB, else that of RF64 (EBU Tech 3306). Both
 * have the same length: until it is needed for the lengths of RF64, a chunk JUNK keeps the room.
 *
 * libsndfile would make such a file WAVE_FORMAT_EXTENSIBLE and leave it so, which trackers and
 * Python 3.11 refuse.
 */
#ifndef TABOR_HOST_WAV_HEADER_H
#define TABOR_HOST_WAV_HEADER_H

#include <stdbool.h>
#include <stdint.h>

#define WAV_HEADER_MOST 94 /**< bytes of a header at most */

typedef struct WavFormat {
  bool is_float;
  uint32_t bits; /**< of a sample: 16, 24 or 32 */
  uint32_t rate; /**< [Hz] */
  uint32_t channels;
} WavFormat;

/** Bytes before the first sample, whatever the length. */
uint32_t wav_header_size(const WavFormat *format);
/** Fills in the header of a file of @p frames frames. */
void wav_header(const WavFormat *format, uint64_t frames, uint8_t header[WAV_HEADER_MOST]);
/** Bytes of the frames, without the one that fills up an odd number. */
uint64_t wav_data_size(const WavFormat *format, uint64_t frames);

#endif
