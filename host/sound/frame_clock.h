/* SPDX-License-Identifier: MIT */
/**
 * @file frame_clock.h
 * Converts the time at which a key or note arrived into a frame.
 *
 * Blocks come a little early or late, and a device's rate differs from its nominal rate by some
 * parts in 10^5. The time of frame 0 is therefore estimated from many blocks with a low-pass
 * filter. An event at time t falls on frame (t - zero) rate + delay. The delay is constant, one
 * block of the device, so that this frame cannot have been computed yet.
 */
#ifndef TABOR_HOST_FRAME_CLOCK_H
#define TABOR_HOST_FRAME_CLOCK_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/realtime.h"

typedef struct FrameClock {
  double rate;            /**< [Hz] */
  _Atomic double zero;    /**< time of frame 0 [s] */
  atomic_uint delay;      /**< frames from an event to its sound: the largest block so far */
  atomic_bool is_running; /**< a block has been seen */
} FrameClock;

/** Call before the threads start. @p delay: the block size [frames], as far as it is known. */
void frame_clock_start(FrameClock *clock, double rate, uint32_t delay);
/** AUDIO: the device asks at time @p now [s] for @p frames frames, starting at @p frame. */
void frame_clock_tick(FrameClock *clock, uint64_t frame, uint32_t frames, double now) REALTIME;
/** ANY: the frame of an event at time @p time [s]; 0 before the first block. */
uint64_t frame_clock_frame(const FrameClock *clock, double time) REALTIME;

#endif
