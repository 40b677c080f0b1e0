/* SPDX-License-Identifier: MIT */
/* FNV-1a over 8-byte words, the last one filled up with zeros: tells damage of saved bytes, not
 * malice. Audio-safe. */
#ifndef TB_CHECKSUM_H
#define TB_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline uint64_t tb_checksum(const void *bytes, size_t size) {
  const unsigned char *p = bytes;
  uint64_t hash = 14695981039346656037u;
  for (size_t i = 0; i < size; i += 8) {
    uint64_t word = 0;
    memcpy(&word, p + i, size - i < 8 ? size - i : 8);
    hash = (hash ^ word) * 1099511628211u;
  }
  return hash;
}

#endif
