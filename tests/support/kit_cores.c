/* SPDX-License-Identifier: MIT */
/**
 * @file kit_cores.c
 * Benchmark of a kit on several cores: plays a MIDI file with the kit `standard` at `live`, in
 * blocks of 128 frames, each at its time, in the plugins of CLAP and LV2. Prints the processor time
 * of the busiest thread and of all threads together, from the first block on, beside what the drums
 * cost one after another in the engine alone, and the time of the dearest part if they are divided
 * in the best way.
 *
 *     kit_cores TABOR.CLAP TABOR.SO SONG.MID
 */
#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "live_kit.h"
#include "midi/midi_file_input.h"

/* It has a macro that is named as a function of the program. */
#include <cmocka.h>

#include "clap_host.h"
#include "kit/kit_midi.h"
#include "lv2/uris.h"
#include "platform/clock.h"
#include "plugin_host.h"

enum { BLOCK = 128, RATE = 48000, MOST_THREADS = 64 };

static HostMessage *messages;
static size_t message_count;
static uint32_t frames;

static void read_song(const char *path) {
  MidiFile file;
  assert_int_equal(midi_file_read(path, false, &file), OUTCOME_OK);
  messages = calloc(file.count + 1, sizeof *messages);
  assert_non_null(messages);
  for (size_t i = 0; i < file.count; i++) {
    messages[i].frame = (uint64_t)(file.events[i].time * RATE + 0.5);
    messages[i].message = file.events[i].message;
  }
  message_count = file.count;
  frames = (uint32_t)(file.length + 1) * RATE / BLOCK * BLOCK;
  midi_file_free(&file);
}

/* ---- processor time ------------------------------------------------------------------------- */

typedef struct Times {
  uint32_t count;
  int thread[MOST_THREADS];
  double seconds[MOST_THREADS];
} Times;

static void read_times(Times *times) {
  DIR *const folder = opendir("/proc/self/task");
  assert_non_null(folder);
  times->count = 0;
  for (struct dirent *entry; (entry = readdir(folder));) {
    char path[300];
    unsigned long long run = 0;
    (void)snprintf(path, sizeof path, "/proc/self/task/%s/schedstat", entry->d_name);
    FILE *const stream = entry->d_name[0] == '.' ? NULL : fopen(path, "r");
    if (!stream) continue;
    assert_int_equal(fscanf(stream, "%llu", &run), 1);
    (void)fclose(stream);
    assert_true(times->count < MOST_THREADS);
    times->thread[times->count] = atoi(entry->d_name);
    times->seconds[times->count++] = 1e-9 * (double)run;
  }
  (void)closedir(folder);
}

static double before(const Times *times, int thread) {
  for (uint32_t i = 0; i < times->count; i++) {
    if (times->thread[i] == thread) return times->seconds[i];
  }
  return 0;
}

static void print_times(const char *name, const Times *begin, double best, double one) {
  Times end;
  double busiest = 0, all = 0;
  read_times(&end);
  for (uint32_t i = 0; i < end.count; i++) {
    const double seconds = end.seconds[i] - before(begin, end.thread[i]);
    all += seconds;
    if (seconds > busiest) busiest = seconds;
  }
  (void)printf("%-24s busiest %.2f s, %.2f of the best division; all %.2f s, %.2f of one thread\n",
               name, busiest, busiest / best, all, all / one);
  (void)fflush(stdout);
}

/* ---- the engine alone ----------------------------------------------------------------------- */

static double cost[TABOR_KIT_DRUMS];

static void run_in_turn(void *context, TaborKitJob *job, void *kit, uint32_t count) {
  (void)context;
  for (uint32_t i = 0; i < count; i++) {
    const double begun = processor_seconds();
    job(kit, i);
    cost[i] += processor_seconds() - begun;
  }
}

static double measure_drums(void) {
  static KitMidi midi;
  static float sound[2][BLOCK];
  static TaborKitDef def;
  TaborKit *const kit = live_kit_create(&def);
  size_t next = 0;
  kit_midi_begin(&midi, &def, &kit_midi_setup_default);
  tabor_kit_set_runner(kit, run_in_turn, NULL);
  const double begun = processor_seconds();
  for (uint32_t at = 0; at < frames; at += BLOCK) {
    static TaborKitEvent events[KIT_MIDI_MOST_EVENTS * 16];
    uint32_t count = 0;
    for (; next < message_count && messages[next].frame < at + BLOCK; next++)
      count += kit_midi_take(&midi, &messages[next].message, events + count);
    const TaborKitOutputs outputs = {.stereo = {sound[0], sound[1]}};
    tabor_kit_process(kit, events, count, &outputs, BLOCK);
  }
  const double seconds = processor_seconds() - begun;
  tabor_kit_destroy(kit);
  return seconds;
}

/* The dearest of two parts, by trying all divisions. */
static double best_division(void) {
  double least = 1e9;
  for (uint32_t part = 0; part < 1u << TABOR_KIT_DRUMS; part++) {
    double sums[2] = {0, 0};
    for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) sums[part >> i & 1u] += cost[i];
    const double dearest = sums[0] > sums[1] ? sums[0] : sums[1];
    if (dearest < least) least = dearest;
  }
  return least;
}

/* ---- hosts ---------------------------------------------------------------------------------- */

static void play_clap(const char *name, const char *binary, HostThreads *threads, double best,
                      double one) {
  const clap_plugin_entry_t *const entry = clap_host_entry(binary);
  ClapHost *const host = clap_host_open_threaded(entry, ID_KIT, threads);
  Times begin;
  size_t next = 0;
  clap_host_set_id(host, 0, KIT_KNOB_HUMANIZE, 0); /* the same strokes as in the engine alone */
  clap_host_flush(host);
  clap_host_activate(host);
  read_times(&begin);
  const double start = stopwatch_seconds(CLOCK_MONOTONIC);
  for (uint32_t at = 0; at < frames; at += BLOCK) {
    for (; next < message_count && messages[next].frame < at + BLOCK; next++)
      clap_host_midi(host, (uint32_t)messages[next].frame - at, &messages[next].message);
    clap_host_run(host, BLOCK);
    clock_sleep_until(start + (double)(at + BLOCK) / RATE);
  }
  print_times(name, &begin, best, one);
  clap_host_close(host);
}

static void play_lv2(const char *binary, double best, double one) {
  const LV2_Descriptor *const descriptor = host_descriptor(binary, URI_KIT);
  PluginHost *const host = host_open(descriptor, HOST_WITHOUT_WORKER);
  float *sound[HOST_OUTPUTS];
  static float blocks[HOST_OUTPUTS][BLOCK];
  Times begin;
  size_t next = 0;
  for (uint32_t i = 0; i < HOST_OUTPUTS; i++) sound[i] = blocks[i];
  *host_knob(host, KIT_KNOB_HUMANIZE) = 0;
  host_wait(host);
  read_times(&begin);
  const double start = stopwatch_seconds(CLOCK_MONOTONIC);
  for (uint32_t at = 0; at < frames; at += BLOCK) {
    const size_t first = next;
    while (next < message_count && messages[next].frame < at + BLOCK) messages[next++].frame -= at;
    host_play(host, messages + first, next - first, BLOCK, BLOCK, sound);
    clock_sleep_until(start + (double)(at + BLOCK) / RATE);
  }
  print_times("LV2", &begin, best, one);
  host_close(host);
}

int main(int argc, char **argv) {
  if (argc != 4) return 2;
  read_song(argv[3]);
  const double one = measure_drums(), best = best_division();
  (void)printf("%.2f s of sound; on one thread %.2f s; of drums", (double)frames / RATE, one);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS && cost[i] > 0; i++) (void)printf(" %.2f", cost[i]);
  (void)printf(" s; the best division between two %.2f s\n", best);
  HostThreads *const threads = host_threads_begin(1);
  play_clap("CLAP with its threads", argv[1], threads, best, one);
  host_threads_end(threads);
  play_clap("CLAP", argv[1], NULL, best, one);
  (void)setenv("TABOR_THREADS", "1", 1);
  play_clap("CLAP, TABOR_THREADS=1", argv[1], NULL, best, one);
  (void)unsetenv("TABOR_THREADS");
  play_lv2(argv[2], best, one);
  free(messages);
  return 0;
}
