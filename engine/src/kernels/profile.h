/* SPDX-License-Identifier: MIT */
/* Time spent in each stage of a sample, in a profiling build (CMake option TABOR_PROFILE, see
 * tools/profile_stages.c). In any other build TB_STAGE() is empty, and this header defines nothing
 * else.
 *
 * TB_STAGE(X) ends the current stage and begins stage X. Every moment belongs to one stage, so the
 * stages add up to the total. The counter is read without waiting for earlier instructions: some
 * ten nanoseconds of work still in flight when a stage ends may count for the next stage. */
#ifndef TB_PROFILE_H
#define TB_PROFILE_H

#ifdef TABOR_PROFILE
#  include <stdbool.h>
#  include <stdint.h>
#  if defined(__x86_64__)
#    include <x86intrin.h>
#  else
#    include <time.h>
#  endif

typedef enum TbStage {
  TB_STAGE_OTHER, /* events, live parameters, housekeeping, and the caller */
  TB_STAGE_MODES,
  TB_STAGE_PROJECTION, /* modes to points of the wires' grid; forces back to modes */
  TB_STAGE_WIRES,
  TB_STAGE_STRIKERS,
  TB_STAGE_STRETCH, /* of the heads */
  TB_STAGE_LAWS,    /* the contact solve without TB_STAGE_PRODUCT */
  TB_STAGE_PRODUCT, /* the heads' response to contact forces */
  TB_STAGE_LEDGER,  /* losses of energy */
  TB_STAGE_HIGH,    /* the one-way high band */
  TB_STAGE_MICS,
  TB_STAGE_COUNT
} TbStage;

typedef struct TbProfile {
  bool on;
  TbStage stage;
  uint64_t since; /* start of the stage [ticks] */
  uint64_t ticks[TB_STAGE_COUNT], entries[TB_STAGE_COUNT];
} TbProfile;

extern _Thread_local TbProfile tb_profile;

static inline uint64_t tb_profile_ticks(void) {
#  if defined(__x86_64__)
  return __rdtsc();
#  else
  struct timespec now = {0};
  (void)clock_gettime(CLOCK_MONOTONIC, &now);
  return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
#  endif
}

static inline void tb_profile_enter(TbStage stage) {
  TbProfile *profile = &tb_profile;
  if (!profile->on) return;
  const uint64_t now = tb_profile_ticks();
  profile->ticks[profile->stage] += now - profile->since;
  profile->entries[profile->stage]++;
  profile->stage = stage;
  profile->since = now;
}

#  define TB_STAGE(name) tb_profile_enter(TB_STAGE_##name)
#else
#  define TB_STAGE(name) ((void)0)
#endif

#endif
