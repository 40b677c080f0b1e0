/* SPDX-License-Identifier: MIT */
/*
 * Hosts do not wait for models that nobody wants any more, nor longer than a limit for one that is
 * wanted. In real time no model is better than at live.
 *
 * test_clap_builds PLUGINS [brief]: without models at studio that are played, for slow builds.
 */
#define _POSIX_C_SOURCE 200809L
#include "clap_host.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#define FRAMES 480u

static const clap_plugin_entry_t *entry;
static double whole; /* [s] that a costly model took */

static double now(void) {
  struct timespec time;
  (void)clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void wait_seconds(double seconds) {
  const struct timespec time = {.tv_nsec = (long)(1e9 * seconds)};
  (void)nanosleep(&time, NULL);
}

static ClapHost *open_draft(void) {
  ClapHost *const host = clap_host_open(entry, ID_DRUM);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_flush(host);
  clap_host_activate(host);
  clap_host_run(host, FRAMES);
  return host;
}

/* Sets what the lines "key = value" say. */
static void set_lines(TaborDrumDef *def, const char *lines) {
  char key[2 * TABOR_NAME_SIZE], value[TABOR_NAME_SIZE];
  int used;
  for (; sscanf(lines, "%127s = %63s\n%n", key, value, &used) == 2; lines += used) {
    assert_int_equal(tabor_drum_def_set(def, key, value, NULL), TABOR_OK);
  }
}

/* Loads the instance's own state with `lines` in its drum. */
static void change_drum(ClapHost *host, const char *lines) {
  static ClapState saved;
  TaborDrumDef def;
  size_t length;
  clap_host_save(host, &saved);
  char *const text = strstr(saved.bytes, "definition\n") + strlen("definition\n");
  const size_t before = (size_t)(text - saved.bytes);
  assert_int_equal(tabor_drum_def_read(&def, text, saved.size - before, NULL), TABOR_OK);
  set_lines(&def, lines);
  assert_int_equal(
    tabor_drum_def_write(&def, TABOR_TEXT_KEEP, text, sizeof saved.bytes - before, &length, NULL),
    TABOR_OK);
  saved.size = before + length;
  saved.at = 0;
  assert_true(clap_host_load(host, &saved));
}

/* As long to build as a snare drum at studio, whatever the quality. */
#define COSTLY                                                                                     \
  "quality.two_way_bandwidth = 16000\nquality.bandwidth = 20000\nquality.wire_points = 200\n"

/* Asks for a costly model that no other instance has, by its tension [N/m]; `offline`: and waits
 * for it. */
static void ask_for_costly(ClapHost *host, int tension, bool offline) {
  char lines[256];
  (void)snprintf(lines, sizeof lines, COSTLY "batter.tension = %d\n", tension);
  clap_host_render(host, offline);
  change_drum(host, lines);
  clap_host_run(host, FRAMES);
}

/* Seconds that such a model takes. */
static double whole_build(int tension) {
  ClapHost *const host = open_draft();
  const double start = now();
  ask_for_costly(host, tension, true);
  const double seconds = now() - start;
  clap_host_close(host);
  return seconds;
}

static void closing_ends_a_build(void **state) {
  (void)state;
  whole = whole_build(3610);
  ClapHost *const host = open_draft();
  ask_for_costly(host, 3620, false);
  wait_seconds(0.05);
  const double start = now();
  clap_host_close(host);
  const double closing = now() - start;
  print_message("a model takes %.2f s, closing %.3f s\n", whole, closing);
  assert_true(closing < 0.5 * whole);
}

static void record(ClapHost *host, float *sound) {
  clap_host_render(host, true);
  clap_host_run(host, 8192); /* and what glides arrives */
  clap_host_midi(host, 0, &(MidiMessage){0x99, {38, 100}});
  clap_host_run(host, FRAMES);
  memcpy(sound, host->sound[0], FRAMES * sizeof *sound);
}

/* What was not built when the host switched the plugin off is built when it switches it on. */
static void a_cancelled_drum_comes_later(void **state) {
  (void)state;
  static float cancelled[FRAMES], straight[FRAMES];
  ClapHost *const one = open_draft();
  ask_for_costly(one, 3630, false);
  wait_seconds(0.05);
  clap_host_deactivate(one);
  clap_host_activate(one);
  record(one, cancelled);
  ClapHost *const other = open_draft();
  ask_for_costly(other, 3630, true);
  clap_host_deactivate(other);
  clap_host_activate(other);
  record(other, straight);
  assert_memory_equal(cancelled, straight, sizeof straight);
  clap_host_close(one);
  clap_host_close(other);
}

/* A wish that comes while a model is built for long ends this build. */
static void a_newer_wish_ends_a_build(void **state) {
  (void)state;
  ClapHost *const host = open_draft();
  ask_for_costly(host, 3650, false);
  wait_seconds(0.05);
  const double start = now();
  change_drum(host,
              "quality.two_way_bandwidth = 0\nquality.bandwidth = 0\nquality.wire_points = 0\n");
  clap_host_run(host, FRAMES);
  clap_host_render(host, true);
  clap_host_run(host, FRAMES); /* waits for the draft */
  const double waiting = now() - start;
  print_message("a model takes %.2f s, its end and a draft %.3f s\n", whole, waiting);
  assert_true(waiting < 0.6 * whole);
  clap_host_close(host);
}

/* Nothing about this drum is out of range, and its model takes as long as any. */
static const char LARGEST[] =
  "wires.count = 40\nquality.wire_points = 400\nquality.bandwidth = 40000\n"
  "quality.two_way_bandwidth = 40000\nshell.radius = 0.6\nshell.depth = 0.6\n"
  "batter.tension = 20000\nresonant.tension = 20000\n";

/* The plugin begins to build the largest drum, and is destroyed meanwhile. */
static void closing_ends_the_build_of_the_largest_drum(void **state) {
  (void)state;
  ClapHost *const host = open_draft();
  change_drum(host, LARGEST);
  clap_host_run(host, FRAMES);
  wait_seconds(0.2);
  const double start = now();
  clap_host_close(host);
  const double closing = now() - start;
  print_message("closing beside the largest drum %.3f s\n", closing);
  assert_true(closing < 0.5 * whole);
}

/* ---- what is for export alone ---- */

typedef struct Heard {
  float sound[FRAMES];
  char said[512]; /* newest line of the log */
} Heard;

static void set_quality(ClapHost *host, uint32_t quality) {
  if (strcmp(host->plugin->desc->id, ID_KIT) == 0) {
    clap_host_set_id(host, 0, KIT_KNOB_KIT, 3); /* frame drums: soon built */
    clap_host_set_id(host, 0, KIT_KNOB_QUALITY, CLAP_QUALITY(quality));
  } else {
    clap_host_set(host, 0, KNOB_BATTER_TENSION, 0.7);
    clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(quality));
  }
}

static void strike(ClapHost *host, Heard *heard) {
  clap_host_run(host, 8192); /* what glides arrives */
  clap_host_midi(host, 0, &(MidiMessage){0x99, {38, 100}});
  clap_host_run(host, FRAMES);
  memcpy(heard->sound, host->sound[0], sizeof heard->sound);
  memcpy(heard->said, host->said, sizeof heard->said);
}

/* A stroke in a host that exports, or does not; and with `then` one that begins to after a block.
 */
static Heard hear(const char *id, uint32_t quality, bool exports, bool then) {
  Heard heard;
  ClapHost *const host = clap_host_open(entry, id);
  clap_host_render(host, exports);
  set_quality(host, quality);
  clap_host_flush(host);
  clap_host_activate(host);
  if (then) {
    clap_host_run(host, FRAMES);
    clap_host_render(host, true);
  }
  strike(host, &heard);
  clap_host_close(host);
  return heard;
}

static void check_export(const char *id) {
  const Heard live = hear(id, TABOR_QUALITY_LIVE, false, false),
              held = hear(id, TABOR_QUALITY_STUDIO, false, false),
              studio = hear(id, TABOR_QUALITY_STUDIO, true, false),
              later = hear(id, TABOR_QUALITY_STUDIO, false, true);
  assert_memory_equal(held.sound, live.sound, sizeof live.sound);
  assert_memory_not_equal(studio.sound, live.sound, sizeof live.sound);
  assert_memory_equal(later.sound, studio.sound, sizeof studio.sound);
  assert_non_null(strstr(held.said, "studio and reference are for export"));
  assert_string_equal(live.said, "");
  assert_string_equal(studio.said, "");
}

static void studio_is_for_export(void **state) {
  (void)state;
  check_export(ID_DRUM);
}

static void so_it_is_for_a_kit(void **state) {
  (void)state;
  check_export(ID_KIT);
}

/* Offline, the host waits in its audio thread: of a drum of 30 wires at reference it gets studio,
 * and is told. */
static void what_takes_too_long_plays_at_a_lower_quality(void **state) {
  (void)state;
  ClapHost *const host = open_draft();
  change_drum(host, "wires.count = 30\n");
  clap_host_render(host, true);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_REFERENCE));
  clap_host_run(host, FRAMES);
  assert_non_null(strstr(host->said, "lower"));
  print_message("%s\n", host->said);
  clap_host_midi(host, 0, &(MidiMessage){0x99, {38, 100}});
  clap_host_run(host, FRAMES);
  double peak = 0.0;
  for (uint32_t i = 0; i < FRAMES; i++) peak = fmax(peak, fabs((double)host->sound[0][i]));
  assert_true(peak > 1e-3);
  clap_host_close(host);
}

int main(int argc, char **argv) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(closing_ends_a_build),
    cmocka_unit_test(closing_ends_the_build_of_the_largest_drum),
    cmocka_unit_test(a_cancelled_drum_comes_later),
    cmocka_unit_test(a_newer_wish_ends_a_build),
    cmocka_unit_test(what_takes_too_long_plays_at_a_lower_quality),
  };
  const struct CMUnitTest of_sound[] = {
    cmocka_unit_test(studio_is_for_export),
    cmocka_unit_test(so_it_is_for_a_kit),
  };
  if (argc != 2 && argc != 3) return 2;
  entry = clap_host_entry(argv[1]);
  const int failed = cmocka_run_group_tests(tests, NULL, NULL);
  return argc == 3 ? failed : failed + cmocka_run_group_tests(of_sound, NULL, NULL);
}
