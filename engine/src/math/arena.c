/* SPDX-License-Identifier: MIT */
#include "math/arena.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "math/thread_time.h"

struct TbArenaChunk {
  TbArenaChunk *next;
  char padding[TB_ALIGNMENT - sizeof(TbArenaChunk *)];
};

/* C11's aligned_alloc() is missing on Windows. The block that malloc() gave is remembered before
 * the memory. */
static void *system_allocate(size_t size, void *context) {
  (void)context;
  const size_t extra = TB_ALIGNMENT + sizeof(void *);
  char *const block = size <= SIZE_MAX - extra ? malloc(size + extra) : NULL;
  if (!block) return NULL;
  char *const first = block + sizeof(void *);
  char *const memory = first + (TB_ALIGNMENT - (uintptr_t)first % TB_ALIGNMENT) % TB_ALIGNMENT;
  memcpy(memory - sizeof(void *), &block, sizeof(void *));
  return memory;
}

static void system_release(void *memory, void *context) {
  (void)context;
  if (!memory) return;
  void *block;
  memcpy(&block, (char *)memory - sizeof(void *), sizeof(void *));
  free(block);
}

TaborAllocator tb_allocator_resolve(const TaborAllocator *allocator) {
  if (allocator && allocator->allocate && allocator->release) return *allocator;
  return (TaborAllocator){system_allocate, system_release, NULL};
}

void tb_arena_prepare(TbArena *arena, const TaborAllocator *allocator) {
  *arena = (TbArena){.allocator = *allocator};
}

void tb_arena_beside(TbArena *arena, const TbArena *other) {
  tb_arena_prepare(arena, &other->allocator);
  arena->watch = other->watch;
}

static const double GLANCE = 0.005; /* [s] of processor time between two questions to the watch */

static void ask(TbWatch *watch) {
  const double done = watch->done + watch->part * watch->stage, now = tb_thread_time();
  watch->late |= watch->limit > 0.0 && now - watch->began > watch->limit;
  if (!watch->go_on || watch->cancelled || fabs(now - watch->asked) < GLANCE) return;
  watch->asked = now;
  watch->cancelled = !watch->go_on(done < 1.0 ? done : 1.0, watch->context);
}

bool tb_arena_go_on(TbArena *arena) {
  TbWatch *watch = arena->watch;
  if (!watch || !(watch->go_on || watch->limit > 0.0)) return !arena->failed;
  ask(watch);
  arena->failed |= watch->cancelled || watch->late;
  return !arena->failed;
}

bool tb_arena_go_on_at(TbArena *arena, double part) {
  TbWatch *watch = arena->watch;
  if (watch && part > watch->part) watch->part = part;
  return tb_arena_go_on(arena);
}

/* In pieces, as a system takes a while to give large memory. */
static bool clear(TbArena *arena, char *bytes, size_t size) {
  static const size_t PIECE = (size_t)1 << 24;
  for (size_t at = 0; at < size; at += PIECE) {
    if (arena->watch && !tb_arena_go_on(arena)) return false;
    memset(bytes + at, 0, size - at < PIECE ? size - at : PIECE);
  }
  return true;
}

void *tb_arena_take(TbArena *arena, size_t count, size_t size) {
  if (count == 0) count = 1;
  if (count > (SIZE_MAX / 2) / size) {
    arena->failed = true;
    return NULL;
  }
  const size_t bytes = TB_ALIGNED(count * size) + sizeof(TbArenaChunk);
  TbArenaChunk *chunk = arena->allocator.allocate(bytes, arena->allocator.context);
  if (!chunk) {
    arena->failed = true;
    return NULL;
  }
  chunk->next = arena->chunks;
  arena->chunks = chunk;
  arena->bytes += bytes;
  return clear(arena, (char *)(chunk + 1), bytes - sizeof(TbArenaChunk)) ? chunk + 1 : NULL;
}

double *tb_arena_doubles(TbArena *arena, size_t count) {
  return tb_arena_take(arena, count, sizeof(double));
}

void tb_arena_release(TbArena *arena) {
  while (arena->chunks) {
    TbArenaChunk *next = arena->chunks->next;
    arena->allocator.release(arena->chunks, arena->allocator.context);
    arena->chunks = next;
  }
  arena->bytes = 0;
}
