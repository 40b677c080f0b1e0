/* SPDX-License-Identifier: MIT */
/**
 * @file frame_clock.h
 * Which frame is heard when: turns the time at which a key or note arrived into a frame.
 *
 * The audio thread gets its blocks a little early or late, and a device's rate differs from its name
 * by some parts in 10^5; so the time of frame 0 is what a low-pass sees of many blocks. An event of
 * time t falls on frame (t - zero) rate + delay: always the same delay, one block of the device, after
 * which that frame cannot have been computed yet.
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

/** Before the threads begin; @p delay in frames as far as it is known. */
void frame_clock_start(FrameClock *clock, double rate, uint32_t delay);
/** AUDIO: a block of @p frames frames from @p frame on is asked for at time @p now [s]. */
void frame_clock_tick(FrameClock *clock, uint64_t frame, uint32_t frames, double now) REALTIME;
/** ANY: the frame on which an event of time @p time [s] falls; 0 before the first block. */
uint64_t frame_clock_frame(const FrameClock *clock, double time) REALTIME;

#endif
