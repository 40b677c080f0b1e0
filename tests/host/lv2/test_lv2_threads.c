/* SPDX-License-Identifier: MIT */
/*
 * Two instances play in two threads with workers of their own, while a third saves and restores
 * them: for ThreadSanitizer (test_plugin_races.sh), and what they play is what one by itself plays.
 *
 * test_lv2_threads [RUNS]
 */
#include "plugin_host.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "lv2/uris.h"
#include "plugin/model_cache.h"

#define FRAMES 512

static uint32_t runs = 400;
static atomic_bool over;

static PluginHost *open_plugin(uint32_t which, HostWorker worker) {
  PluginHost *const host = host_open(lv2_descriptor(which), worker);
  host->knobs[KNOB_QUALITY] = 0;
  return host;
}

static void pause_briefly(void) {
  const struct timespec moment = {.tv_nsec = 1000000};
  (void)nanosleep(&moment, NULL);
}

/* Both wish for the same drums, so that they meet in the cache. */
static void *play(void *context) {
  PluginHost *const host = context;
  for (uint32_t run = 0; run < runs; run++) {
    if (run % 4 == 0) host_note(host, 3, 38, (uint8_t)(20 + run % 100));
    if (run % 16 == 1) host->knobs[KNOB_STRAINER] = (float)(run % 3) / 2;
    if (run % 50 == 2) host->knobs[KNOB_BATTER_TENSION] = 3000 + (float)(run % 200);
    if (run % 100 == 3) host_event(host, 0, 2, (const uint8_t[]){0xC9, (uint8_t)(run / 100 % 2)});
    host_run(host, FRAMES);
    if (host->ready < 1) pause_briefly();
  }
  return NULL;
}

static void *keep(void *context) {
  PluginHost *const *const hosts = context;
  for (uint32_t i = 0; !atomic_load(&over); i++) {
    HostState state;
    host_save(hosts[i % 2], &state);
    if (i % 5 == 0) (void)host_restore(hosts[i / 5 % 2], &state);
    host_state_free(&state);
    pause_briefly();
  }
  return NULL;
}

static void play_both(HostWorker worker) {
  PluginHost *const hosts[] = {open_plugin(0, worker), open_plugin(1, worker)};
  pthread_t threads[2], keeper;
  atomic_store(&over, false);
  assert_int_equal(pthread_create(&keeper, NULL, keep, (void *)hosts), 0);
  for (int i = 0; i < 2; i++) {
    assert_int_equal(pthread_create(&threads[i], NULL, play, hosts[i]), 0);
  }
  for (int i = 0; i < 2; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
  atomic_store(&over, true);
  assert_int_equal(pthread_join(keeper, NULL), 0);
  for (int i = 0; i < 2; i++) host_close(hosts[i]);
  assert_int_equal(model_cache_count(), 0);
}

static void test_two_threads_with_workers(void **state) {
  (void)state;
  play_both(HOST_WORKER_THREAD);
}

static void test_two_threads_without(void **state) {
  (void)state;
  play_both(HOST_WITHOUT_WORKER);
}

/* ---- the same sound ------------------------------------------------------------------------- */

typedef struct Solo {
  PluginHost *host;
  float sound[16 * FRAMES];
} Solo;

static void *play_solo(void *context) {
  Solo *const solo = context;
  solo->host->freewheel = 1;
  host_note(solo->host, 0, 38, 100);
  for (uint32_t run = 0; run < 16; run++) {
    host_run(solo->host, FRAMES);
    memcpy(solo->sound + run * FRAMES, solo->host->sound[0], FRAMES * sizeof(float));
  }
  return NULL;
}

static void test_neither_hears_the_other(void **state) {
  (void)state;
  static Solo solos[3];
  pthread_t threads[2];
  for (int i = 0; i < 3; i++) solos[i].host = open_plugin(0, HOST_WITHOUT_WORKER);
  for (int i = 0; i < 2; i++) {
    assert_int_equal(pthread_create(&threads[i], NULL, play_solo, &solos[i]), 0);
  }
  for (int i = 0; i < 2; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
  (void)play_solo(&solos[2]);
  for (int i = 0; i < 2; i++) {
    assert_true(memcmp(solos[i].sound, solos[2].sound, sizeof solos[i].sound) == 0);
  }
  assert_true(host_peak(solos[2].sound, 16 * FRAMES) > 1e-3);
  for (int i = 0; i < 3; i++) host_close(solos[i].host);
}

int main(int argc, char **argv) {
  if (argc > 1) runs = (uint32_t)atoi(argv[1]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_two_threads_with_workers),
    cmocka_unit_test(test_two_threads_without),
    cmocka_unit_test(test_neither_hears_the_other),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
