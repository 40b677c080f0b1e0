/* SPDX-License-Identifier: MIT */
/* Set-up memory: many arrays taken one by one, given back all at once. Never used on the audio path. */
#ifndef TB_ARENA_H
#define TB_ARENA_H

#include "tabor/tabor.h"

#define TB_ALIGNMENT 64u

typedef struct TbArenaChunk TbArenaChunk;

typedef struct TbArena {
  TaborAllocator allocator;
  TbArenaChunk *chunks; /* newest first */
  size_t bytes;         /* taken so far */
  bool failed;          /* an allocation returned NULL */
} TbArena;

/* The C library's allocator where both functions are NULL, else the caller's. */
TaborAllocator tb_allocator_resolve(const TaborAllocator *allocator);

void tb_arena_prepare(TbArena *arena, const TaborAllocator *allocator);
/* Zeroed memory aligned to 64 bytes. On failure NULL, and `failed` stays set. */
void *tb_arena_take(TbArena *arena, size_t count, size_t size);
double *tb_arena_doubles(TbArena *arena, size_t count);
void tb_arena_release(TbArena *arena);

/* Rounds up to the 8 lanes that every kernel works in. */
static inline uint32_t tb_pad(uint32_t count) { return (count + 7u) & ~7u; }

#endif
