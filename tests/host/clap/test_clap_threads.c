/* SPDX-License-Identifier: MIT */
/*
 * Two instances play in two threads, while the main thread saves and loads them and reads their
 * parameters: for ThreadSanitizer (test_plugin_races.sh), and what they play is what one by itself
 * plays.
 *
 * test_clap_threads [BLOCKS]
 */
#include "clap_host.h"

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "plugin/model_cache.h"

#define FRAMES 512

extern const clap_plugin_entry_t clap_entry;

static uint32_t blocks = 120;
static atomic_int playing;

static ClapHost *open_plugin(const char *id) {
  ClapHost *const host = clap_host_open(&clap_entry, id);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_flush(host);
  return host;
}

static void pause_briefly(void) {
  const struct timespec moment = {.tv_nsec = 1000000};
  (void)nanosleep(&moment, NULL);
}

/* Both wish for the same drums, so that they meet in the cache. */
static void *play(void *context) {
  ClapHost *const host = context;
  for (uint32_t i = 0; i < blocks; i++) {
    if (i % 100 == 3) clap_host_midi(host, 0, &(MidiMessage){0xC9, {(uint8_t)(i / 100 % 2), 0}});
    if (i % 4 == 0) clap_host_note(host, 3, CLAP_EVENT_NOTE_ON, 38, 0.2 + 0.7 * (i % 7) / 7);
    if (i % 16 == 1) clap_host_set(host, 4, KNOB_STRAINER, i % 3 / 2.0);
    if (i % 16 == 5) clap_host_modulate(host, 5, KNOB_STRAINER, -0.5 * (i % 2));
    if (i % 50 == 2) clap_host_set(host, 6, KNOB_BATTER_TENSION, 0.6 + 0.001 * (i % 200));
    clap_host_run(host, FRAMES);
    if (host->status == CLAP_PROCESS_SLEEP) pause_briefly();
  }
  atomic_fetch_sub(&playing, 1);
  return NULL;
}

/* What a main thread does meanwhile. */
static void keep(ClapHost *const *hosts) {
  static ClapState state;
  for (uint32_t i = 0; atomic_load(&playing) > 0; i++) {
    ClapHost *const host = hosts[i % 2];
    const clap_plugin_tail_t *const tail = clap_host_extension(host, CLAP_EXT_TAIL);
    assert_true(tail->get(host->plugin) > 0);
    for (uint32_t knob = 0; knob < KNOB_KEYS; knob++) (void)clap_host_value(host, (KnobId)knob);
    clap_host_save(host, &state);
    if (i % 5 == 0) assert_true(clap_host_load(hosts[i / 5 % 2], &state));
    clap_host_render(host, i % 7 == 0);
    pause_briefly();
  }
}

static void test_two_threads(void **state) {
  (void)state;
  ClapHost *const hosts[] = {open_plugin(ID_DRUM), open_plugin(ID_DRUM_MULTI)};
  pthread_t threads[2];
  atomic_store(&playing, 2);
  for (int i = 0; i < 2; i++) {
    clap_host_activate(hosts[i]);
    assert_int_equal(pthread_create(&threads[i], NULL, play, hosts[i]), 0);
  }
  keep(hosts);
  for (int i = 0; i < 2; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
  for (int i = 0; i < 2; i++) clap_host_close(hosts[i]);
  assert_int_equal(model_cache_count(), 0);
}

/* ---- the same sound ------------------------------------------------------------------------- */

typedef struct Solo {
  ClapHost *host;
  float sound[16 * FRAMES];
} Solo;

static void *play_solo(void *context) {
  Solo *const solo = context;
  clap_host_note(solo->host, 0, CLAP_EVENT_NOTE_ON, 38, 0.8);
  for (uint32_t i = 0; i < 16; i++) {
    clap_host_run(solo->host, FRAMES);
    memcpy(solo->sound + i * FRAMES, solo->host->sound[0], FRAMES * sizeof(float));
  }
  return NULL;
}

static void test_neither_hears_the_other(void **state) {
  (void)state;
  static Solo solos[3];
  pthread_t threads[2];
  double peak = 0;
  for (int i = 0; i < 3; i++) {
    solos[i].host = open_plugin(ID_DRUM);
    clap_host_activate(solos[i].host);
  }
  for (int i = 0; i < 2; i++) {
    assert_int_equal(pthread_create(&threads[i], NULL, play_solo, &solos[i]), 0);
  }
  for (int i = 0; i < 2; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
  (void)play_solo(&solos[2]);
  for (int i = 0; i < 2; i++) {
    assert_memory_equal(solos[i].sound, solos[2].sound, sizeof solos[i].sound);
  }
  for (uint32_t i = 0; i < 16 * FRAMES; i++) {
    if ((double)solos[2].sound[i] > peak) peak = (double)solos[2].sound[i];
  }
  assert_true(peak > 1e-3);
  for (int i = 0; i < 3; i++) clap_host_close(solos[i].host);
}

/* ---- many ----------------------------------------------------------------------------------- */

/* Under AddressSanitizer: nothing of them is left. */
static void test_many_come_and_go(void **state) {
  (void)state;
  for (uint32_t i = 0; i < 1000; i++) {
    ClapHost *const host = open_plugin(i % 2 ? ID_DRUM : ID_DRUM_MULTI);
    if (i % 250 == 0) clap_host_activate(host);
    clap_host_close(host);
  }
  assert_int_equal(model_cache_count(), 0);
}

int main(int argc, char **argv) {
  if (argc > 1) blocks = (uint32_t)atoi(argv[1]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_two_threads),
    cmocka_unit_test(test_neither_hears_the_other),
    cmocka_unit_test(test_many_come_and_go),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
