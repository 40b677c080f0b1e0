/* SPDX-License-Identifier: MIT */
/*
 * Random playing of the plugins, with knobs, program changes and states that another thread
 * restores: runs allocate nothing, lock nothing, sleep nowhere and touch no file, and leave the
 * processor's floating-point mode as the host has set it.
 *
 * test_lv2_realtime [SECONDS of sound]
 */
#include "plugin_host.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "counted_calls.h"
#include "float_mode.h"
#include "lv2/uris.h"
#include "plugin/model_cache.h"

static double seconds = 10;

static const LV2_Descriptor *plugin(const char *uri) {
  for (uint32_t i = 0;; i++) {
    const LV2_Descriptor *const descriptor = lv2_descriptor(i);
    assert_non_null(descriptor);
    if (strcmp(descriptor->URI, uri) == 0) return descriptor;
  }
}

/* ---- playing -------------------------------------------------------------------------------- */

static void counted_run(PluginHost *host, uint32_t frames) {
  float_mode_set();
  count_calls_begin();
  host->descriptor->run(host->handle, frames);
  const long calls = count_calls_end();
  float_mode_check();
  float_mode_reset();
  if (calls > 0) fail_msg("%ld calls at frame %llu", calls, (unsigned long long)host->position);
  for (uint32_t i = 0; i < host->outputs; i++) {
    for (uint32_t at = 0; at < frames; at++) assert_true(isfinite(host->sound[i][at]));
  }
  host_clear(host);
  host->position += frames;
}

static void send_random(PluginHost *host, uint64_t *random, uint32_t frames) {
  static const uint8_t controllers[] = {1, 7, 11, 16, 17, 20, 88};
  for (int64_t at = 0; at < frames; at += (int64_t)(2000 * host_random(random))) {
    const double dice = host_random(random);
    const uint8_t value = (uint8_t)(128 * host_random(random));
    if (dice < 0.6) {
      host_note(host, at, (uint8_t)(36 + 14 * host_random(random)), value);
    } else if (dice < 0.9) {
      const uint8_t which = controllers[(uint32_t)(7 * host_random(random))];
      host_event(host, at, 3, (const uint8_t[]){0xB9, which, value});
    } else if (dice < 0.97) {
      host_event(host, at, 2, (const uint8_t[]){0xD9, value});
    } else {
      host_event(host, at, 3, (const uint8_t[]){0xB9, 120, 0});
    }
  }
}

/* Live knobs often; others, which take a model, now and then. */
static void turn_random(PluginHost *host, uint64_t *random) {
  host->knobs[KNOB_STRAINER] = (float)host_random(random);
  host->knobs[KNOB_BATTER_MUFFLING] = (float)(5 * host_random(random));
  host->knobs[KNOB_STRIKE_RADIUS] = (float)(0.3 * host_random(random));
  host->knobs[KNOB_GAIN] = (float)(6 * host_random(random));
  host->knobs[KNOB_LEVEL_TOP] = (float)(-60 + 72 * host_random(random));
  if (host->ready < 1 || host_random(random) > 0.1) return;
  const double dice = host_random(random);
  if (dice < 0.4) {
    host->knobs[KNOB_BATTER_TENSION] = (float)(2500 + 2000 * host_random(random));
  } else if (dice < 0.9) {
    const uint8_t program = (uint8_t)(2 * host_random(random));
    host_event(host, 0, 2, (const uint8_t[]){0xC9, program});
  } else {
    HostState state;
    host_save(host, &state);
    assert_int_equal(host_restore(host, &state), LV2_STATE_SUCCESS);
    host_state_free(&state);
  }
}

static void play_random(const char *uri, HostWorker worker, uint64_t random) {
  const struct timespec moment = {.tv_nsec = 1000000};
  const uint64_t least = (uint64_t)(48000 * seconds);
  uint32_t changes = 0;
  float was_ready = 0;
  PluginHost *const host = host_open(plugin(uri), worker);
  host->knobs[KNOB_QUALITY] = 0;
  host_event(host, 0, 2, (const uint8_t[]){0xC9, 0});
  while (host->position < least || changes < 5) {
    const uint32_t frames = (uint32_t)(1500 * host_random(&random));
    turn_random(host, &random);
    send_random(host, &random, frames);
    counted_run(host, frames);
    changes += was_ready < 1 && host->ready >= 1;
    was_ready = host->ready;
    if (host->ready < 1)
      (void)nanosleep(&moment, NULL); /* sound must not be over before it is built */
  }
  printf("%.0f s, %u changes of the model\n", (double)host->position / 48000, (unsigned)changes);
  host_close(host);
  assert_int_equal(model_cache_count(), 0);
}

static void runs_call_nothing_that_waits(void **state) {
  (void)state;
  play_random(URI_DRUM, HOST_WORKER_THREAD, 1);
}

static void nor_without_a_worker(void **state) {
  (void)state;
  play_random(URI_DRUM_MULTI, HOST_WITHOUT_WORKER, 2);
}

static void nor_in_the_effect(void **state) {
  (void)state;
  play_random(URI_EFFECT, HOST_WORKER_THREAD, 3);
}

/* Now and then another kit, room or tuning; levels and notes all the time. */
static void send_to_kit(PluginHost *host, uint64_t *random, bool change) {
  static const KitKnobId rebuilt[] = {KIT_KNOB_KIT, KIT_KNOB_ROOM, KIT_KNOB_TUNE};
  const float value = (float)host_random(random);
  if (change) host->kit_knobs[rebuilt[(uint32_t)(3 * host_random(random))]] = 3 * value;
  host->kit_knobs[KIT_KNOB_LEVEL + (uint32_t)(8 * host_random(random))] = -20 * value;
  host->kit_knobs[KIT_KNOB_VELOCITY_CURVE] = 2 * value;
}

static void nor_those_of_a_kit(void **state) {
  (void)state;
  const struct timespec moment = {.tv_nsec = 1000000};
  uint64_t random = 3;
  uint32_t changes = 0;
  PluginHost *const host = host_open(plugin(URI_KIT), HOST_WITHOUT_WORKER);
  host->kit_knobs[KIT_KNOB_QUALITY] = 0;
  host_wait(host);
  while (host->position < (uint64_t)(12000 * seconds) || changes < 3) { /* five drums at once */
    const bool change = host->ready == 1 && host_random(&random) < 0.1;
    const uint32_t frames = (uint32_t)(1500 * host_random(&random));
    send_to_kit(host, &random, change);
    send_random(host, &random, frames);
    counted_run(host, frames);
    changes += change;
    if (host->ready < 1) (void)nanosleep(&moment, NULL);
  }
  printf("%.0f s, %u changes of the kit\n", (double)host->position / 48000, (unsigned)changes);
  host_close(host);
  assert_int_equal(model_cache_count(), 0);
}

int main(int argc, char **argv) {
  if (argc > 1) seconds = atof(argv[1]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_counters_count),   cmocka_unit_test(runs_call_nothing_that_waits),
    cmocka_unit_test(nor_without_a_worker), cmocka_unit_test(nor_in_the_effect),
    cmocka_unit_test(nor_those_of_a_kit),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
