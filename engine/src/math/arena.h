/* SPDX-License-Identifier: MIT */
/* Set-up memory: arrays are taken one by one and released all at once. Never used on the audio
 * path. */
#ifndef TB_ARENA_H
#define TB_ARENA_H

#include "math/arithmetic.h"
#include "tabor/tabor.h"

#define TB_ALIGNMENT 64u
/* Rounds bytes up to a multiple of it. */
#define TB_ALIGNED(bytes) (((bytes) + TB_ALIGNMENT - 1u) / TB_ALIGNMENT * TB_ALIGNMENT)

typedef struct TbArenaChunk TbArenaChunk;

/* Who waits for what is built: hears how far it is, and may end it. So does a limit on processor
 * time. */
typedef struct TbWatch {
  TaborBuildProgress go_on; /* or NULL */
  void *context;
  double done, stage;   /* parts of the whole: before this stage, and of this stage */
  double part;          /* of this stage that is done */
  double began, limit;  /* of the thread's time [s]; 0: no limit */
  double asked;         /* when go_on was called last [s] */
  bool cancelled, late; /* go_on ended it; the limit did */
} TbWatch;

typedef struct TbArena {
  TaborAllocator allocator;
  TbWatch *watch;       /* or NULL */
  TbArenaChunk *chunks; /* newest first */
  size_t bytes;         /* taken so far */
  bool failed;          /* an allocation returned NULL, or the watch cancelled what is built */
} TbArena;

/* The C library's allocator if both functions are NULL, otherwise the caller's. */
TaborAllocator tb_allocator_resolve(const TaborAllocator *allocator);

void tb_arena_prepare(TbArena *arena, const TaborAllocator *allocator);
/* An arena with the allocator and the watch of another one. */
void tb_arena_beside(TbArena *arena, const TbArena *other);
/* Asks the watch, as each allocation does: call in loops without one, so that it is asked every 50
 * ms. If it cancels, this arena and all that share the watch have failed. Returns false if the
 * arena has failed. */
bool tb_arena_go_on(TbArena *arena);
/* The same when `part` of the stage is done, 0 to 1. */
bool tb_arena_go_on_at(TbArena *arena, double part);
/* Returns zeroed memory aligned to 64 bytes. On failure it returns NULL, and `failed` stays set. */
void *tb_arena_take(TbArena *arena, size_t count, size_t size);
double *tb_arena_doubles(TbArena *arena, size_t count);
void tb_arena_release(TbArena *arena);

/* Rounds up to a multiple of 8, the number of SIMD lanes in every kernel. */
static inline uint32_t tb_pad(uint32_t count) { return (count + 7u) & ~7u; }

#endif
