/* SPDX-License-Identifier: MIT */
/* Plays events by frame in pieces and checks that pieces, saves, resets and swaps do not change the
 * sound. */
#ifndef TEST_EVENT_SCRIPT_H
#define TEST_EVENT_SCRIPT_H

#include "physics.h"

/* Returns true if there is an event at this frame, and fills it in. */
typedef uint32_t EventScript(uint32_t frame, TaborEvent *event);

/* Plays frames from .. to in blocks into out[from ..]. */
static inline void event_script_play(EventScript *script, TaborDrum *drum, uint32_t from,
                                     uint32_t to, uint32_t block, float *out) {
  for (uint32_t start = from; start < to; start += block) {
    const uint32_t size = to - start < block ? to - start : block;
    TaborEvent events[64];
    uint32_t count = 0;
    for (uint32_t i = 0; i < size; i++) {
      if (!script(start + i, &events[count])) continue;
      events[count++].frame = i;
    }
    float *outputs[TABOR_MAX_MICS] = {out + start};
    tabor_drum_process(drum, events, count, outputs, size);
  }
}

/* `whole` and `parts` have room for `frames`, more than 7000. */
static inline void event_script_keeps_every_bit(EventScript *script, TaborModel *model,
                                                uint32_t frames, float *whole, float *parts) {
  TaborDrum *drum = physics_drum(model), *other = physics_drum(model);
  event_script_play(script, drum, 0, frames, frames / 8, whole);
  event_script_play(script, other, 0, 5000, 1, parts);
  const size_t size = tabor_drum_state_size(other);
  void *saved = malloc(size);
  tabor_drum_state_save(other, saved);
  event_script_play(script, other, 5000, 7000, 100, parts); /* goes astray */
  tabor_drum_reset(drum);
  assert_int_equal(tabor_drum_state_load(drum, saved, size), TABOR_OK);
  event_script_play(script, drum, 5000, frames, 77, parts);
  assert_memory_equal(whole, parts, frames * sizeof *whole);
  tabor_drum_reset(drum);
  event_script_play(script, drum, 0, frames, 1000, parts);
  assert_memory_equal(whole, parts, frames * sizeof *whole);
  free(saved);
  tabor_drum_destroy(drum);
  tabor_drum_destroy(other);
}

/* Plays a drum that is swapped to another model at frame `at`. */
static inline TaborDrum *event_script_swapped(EventScript *script, TaborModel *from, TaborModel *to,
                                              uint32_t at, uint32_t frames, float *out) {
  TaborDrum *drum = physics_drum(from);
  TaborSwap *swap;
  assert_int_equal(tabor_swap_create(from, to, &swap, NULL), TABOR_OK);
  event_script_play(script, drum, 0, at, 100, out);
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 0);
  event_script_play(script, drum, at, frames, 100, out);
  assert_true(tabor_swap_done(swap));
  tabor_swap_destroy(swap);
  return drum;
}

#endif
