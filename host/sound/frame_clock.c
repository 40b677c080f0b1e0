/* SPDX-License-Identifier: MIT */
#include "sound/frame_clock.h"

#include <math.h>

static const double SMOOTHING = 1.0; /* time constant of the low-pass [s] */
static const double JUMP = 0.1;      /* [s]: further off, the device has stopped and gone on */

void frame_clock_start(FrameClock *clock, double rate, uint32_t delay) {
  clock->rate = rate;
  atomic_init(&clock->zero, 0);
  atomic_init(&clock->delay, delay);
  atomic_init(&clock->is_running, false);
}

void frame_clock_tick(FrameClock *clock, uint64_t frame, uint32_t frames, double now) {
  const double seen = now - (double)frame / clock->rate;
  const double zero = atomic_load_explicit(&clock->zero, memory_order_relaxed);
  const double error = seen - zero, part = frames / (SMOOTHING * clock->rate);
  const bool known = atomic_load_explicit(&clock->is_running, memory_order_relaxed);
  const bool follows = known && fabs(error) < JUMP;
  atomic_store_explicit(&clock->zero, follows ? zero + fmin(part, 1) * error : seen,
                        memory_order_relaxed);
  if (frames > atomic_load_explicit(&clock->delay, memory_order_relaxed)) {
    atomic_store_explicit(&clock->delay, frames, memory_order_relaxed);
  }
  atomic_store_explicit(&clock->is_running, true, memory_order_release);
}

uint64_t frame_clock_frame(const FrameClock *clock, double time) {
  if (!atomic_load_explicit(&clock->is_running, memory_order_acquire)) return 0;
  const double zero = atomic_load_explicit(&clock->zero, memory_order_relaxed);
  const unsigned delay = atomic_load_explicit(&clock->delay, memory_order_relaxed);
  const double frame = (time - zero) * clock->rate + delay;
  return frame > 0 ? (uint64_t)llround(frame) : 0;
}
