/* SPDX-License-Identifier: MIT */
/* Set-up memory: arrays are taken one by one and released all at once. Never used on the audio
 * path. */
#ifndef TB_ARENA_H
#define TB_ARENA_H

#include "math/arithmetic.h"
#include "tabor/tabor.h"

#define TB_ALIGNMENT 64u

typedef struct TbArenaChunk TbArenaChunk;

typedef struct TbArena {
  TaborAllocator allocator;
  TbArenaChunk *chunks; /* newest first */
  size_t bytes;         /* taken so far */
  bool failed;          /* an allocation returned NULL */
} TbArena;

/* The C library's allocator if both functions are NULL, otherwise the caller's. */
TaborAllocator tb_allocator_resolve(const TaborAllocator *allocator);

void tb_arena_prepare(TbArena *arena, const TaborAllocator *allocator);
/* Returns zeroed memory aligned to 64 bytes. On failure it returns NULL, and `failed` stays set. */
void *tb_arena_take(TbArena *arena, size_t count, size_t size);
double *tb_arena_doubles(TbArena *arena, size_t count);
void tb_arena_release(TbArena *arena);

/* Rounds up to a multiple of 8, the number of SIMD lanes in every kernel. */
static inline uint32_t tb_pad(uint32_t count) { return (count + 7u) & ~7u; }

#endif
