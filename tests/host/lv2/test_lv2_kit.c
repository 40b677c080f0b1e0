/* SPDX-License-Identifier: MIT */
/*
 * The LV2 plugin Tabor Kit plays a MIDI file as `tabor render --kit` does, to the bit, its mix and
 * each drum, whatever the sizes of the runs are; its knobs do what they say, and are all that a
 * session needs.
 *
 * test_lv2_kit PROGRAM PLUGINS [brief | songs NUMBER]
 *
 * `songs` plays NUMBER random songs on all kits.
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

#include "lv2/uris.h"

static const char *plugins;
static bool brief;
static unsigned random_songs = 1;

static const char rendered[] = "render -o";

/* Freewheeling, at draft. */
static PluginHost *open_kit(uint32_t kit) {
  PluginHost *const host = host_open(host_descriptor(plugins, URI_KIT), HOST_WITHOUT_WORKER);
  host->kit_knobs[KIT_KNOB_KIT] = (float)kit;
  host->kit_knobs[KIT_KNOB_QUALITY] = 0;
  host->freewheel = 1;
  return host;
}

static void play_song(uint32_t kit, uint32_t block, Take *take) {
  PluginHost *const host = open_kit(kit);
  host_play(host, song.messages, song.count, take->frames, block, take->sound);
  host_close(host);
}

/* Pair 0 of a take of all outputs is the mix, the others are the drums. */
static Take pair_of(const Take *take, uint32_t pair) {
  Take sides = {.frames = take->frames, .channels = 2};
  sides.sound[0] = take->sound[2 * pair];
  sides.sound[1] = take->sound[2 * pair + 1];
  return sides;
}

static void same_mix(uint32_t kit, const char *options, const uint32_t *blocks, size_t count) {
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, PLUGIN_CHANNELS);
  take_from(rendered, options, NULL, &expected);
  for (size_t i = 0; i < count; i++) {
    play_song(kit, blocks[i], &take);
    const Take mix = pair_of(&take, 0);
    take_compare(&expected, &mix, blocks[i]);
  }
  take_close(&expected);
  take_close(&take);
}

static void the_mix_is_that_of_render(void **state) {
  (void)state;
  static const uint32_t blocks[] = {0, 37, 1024, HOST_BLOCK};
  song_write_all();
  same_mix(0, "--kit standard --quality draft", blocks, brief ? 1 : 4);
}

static void the_usual_quality_is_live(void **state) {
  (void)state;
  Take expected, take;
  if (brief) {
    print_message("SKIPPED: it takes too long under sanitizers\n");
    skip();
  }
  take_open(&expected, 2);
  take_open(&take, PLUGIN_CHANNELS);
  song_write_all();
  take_from(rendered, "--kit standard --quality live", NULL, &expected);
  PluginHost *const host = host_open(host_descriptor(plugins, URI_KIT), HOST_WITHOUT_WORKER);
  host->freewheel = 1;
  host_play(host, song.messages, song.count, take.frames, 512, take.sound);
  const Take mix = pair_of(&take, 0);
  take_compare(&expected, &mix, 512);
  host_close(host);
  take_close(&expected);
  take_close(&take);
}

/* Outputs of drums that the kit does not have are silent. */
static void each_drum_is_that_of_split(void **state) {
  (void)state;
  static const char *const drums[] = {"kick",      "snare", "high-tom", "low-tom",
                                      "floor-tom", "crash", "ride",     "hihat"};
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, PLUGIN_CHANNELS);
  song_write_all();
  take_from(rendered, "--kit standard --quality draft --split", NULL, &expected);
  play_song(0, 256, &take);
  for (uint32_t i = 0; i < 8; i++) {
    char name[64], path[256];
    (void)snprintf(name, sizeof name, "song-%s.wav", drums[i]);
    song_path(path, sizeof path, name);
    take_read(path, &expected);
    const Take drum = pair_of(&take, 1 + i);
    take_compare(&expected, &drum, 256);
  }
  for (uint32_t i = 18; i < PLUGIN_CHANNELS; i++) {
    assert_true(host_peak(take.sound[i], take.frames) == 0);
  }
  take_close(&expected);
  take_close(&take);
}

static void random_songs_are_those_of_render(void **state) {
  (void)state;
  static const uint32_t blocks[] = {0};
  for (uint64_t seed = 1; seed <= random_songs; seed++) {
    char options[64];
    const uint32_t kit = seed % tabor_kit_count();
    print_message("seed %u, kit %s\n", (unsigned)seed, tabor_kit(kit)->name);
    (void)snprintf(options, sizeof options, "--kit %s --quality draft", tabor_kit(kit)->name);
    song_write_random(seed);
    same_mix(kit, options, blocks, 1);
  }
}

/* ---- knobs ---------------------------------------------------------------------------------- */

/* Peak of the drum's own output in the run after a stroke on `note`. */
static double strike(PluginHost *host, uint8_t note, uint32_t drum) {
  host_note(host, 0, note, 100);
  host_run(host, HOST_BLOCK);
  return host_peak(host->sound[2 + 2 * drum], HOST_BLOCK);
}

/* Gain and level are factors of the drum's part, and "Off" is silence. */
static void levels_are_factors(void **state) {
  (void)state;
  PluginHost *host = open_kit(0);
  const double whole = strike(host, 38, 1);
  host_close(host);
  assert_true(whole > 1e-3);
  host = open_kit(0);
  host->kit_knobs[KIT_KNOB_GAIN] = -6;
  host->kit_knobs[KIT_KNOB_LEVEL + 1] = -14;
  host_run(host, HOST_BLOCK); /* gains glide */
  assert_true(fabs(strike(host, 38, 1) / whole - 0.1) < 1e-4);
  host->kit_knobs[KIT_KNOB_LEVEL + 1] = -60;
  host_run(host, HOST_BLOCK);
  assert_true(strike(host, 38, 1) == 0);
  host_close(host);
}

static double rate_of_crossings(const float *sound) {
  uint32_t count = 0;
  for (uint32_t i = 1; i < HOST_BLOCK; i++) count += sound[i - 1] < 0 && sound[i] >= 0;
  return 48000.0 * count / HOST_BLOCK;
}

/* A tom an octave higher rings an octave higher, more or less: its air does not go along. */
static void tuning_moves_the_pitch(void **state) {
  (void)state;
  double rates[2];
  for (int i = 0; i < 2; i++) {
    PluginHost *const host = open_kit(0);
    host->kit_knobs[KIT_KNOB_TUNE + 4] = i == 0 ? 0 : 12;
    (void)strike(host, 41, 4);
    host_run(host, HOST_BLOCK);
    rates[i] = rate_of_crossings(host->sound[10]);
    host_close(host);
  }
  print_message("floor tom: %.0f Hz, tuned up %.0f Hz\n", rates[0], rates[1]);
  assert_true(rates[1] > 1.5 * rates[0]);
}

/* ---- the user's own kit ---------------------------------------------------------------------- */

static PluginHost *open_own_kit(void) {
  char path[256];
  PluginHost *const host = open_kit(tabor_kit_count());
  song_path(path, sizeof path, "kit.ini");
  host_set_path(host, 0, URI_KIT_FILE, path);
  host_run(host, 0);
  return host;
}

/* Whatever stands in the file: by render, by the file backend of play, and here. */
static void random_kits_are_those_of_render(void **state) {
  (void)state;
  static const char performed[] = "play --backend file --record";
  char path[256], options[300], softer[320];
  Take expected, played, soft, take;
  take_open(&expected, 2);
  take_open(&soft, 2);
  take_open(&played, 2);
  take_open(&take, PLUGIN_CHANNELS);
  song_path(path, sizeof path, "kit.ini");
  (void)snprintf(options, sizeof options, "--kit '%s' --quality draft", path);
  for (uint64_t seed = 1; seed <= random_songs; seed++) {
    print_message("seed %u\n", (unsigned)seed);
    kit_write_random(seed);
    song_write_random(seed);
    take_from(rendered, options, NULL, &expected);
    const int gain = take_peak(&expected) < 0.9 ? 0 : -12; /* `play` clips */
    (void)snprintf(softer, sizeof softer, "%s --gain %d", options, gain);
    take_from(rendered, softer, NULL, &soft);
    take_from(performed, softer, NULL, &played);
    take_compare(&soft, &played, 0);
    PluginHost *const host = open_own_kit();
    host_play(host, song.messages, song.count, take.frames, 0, take.sound);
    const Take mix = pair_of(&take, 0);
    take_compare(&expected, &mix, 0);
    host_close(host);
  }
  take_close(&expected);
  take_close(&soft);
  take_close(&played);
  take_close(&take);
}

/* A session has the kit itself, not its file. */
static void a_session_has_the_own_kit(void **state) {
  (void)state;
  static const char empty[] = "[kit]\nname = x\n";
  HostState saved = {.count = 0};
  kit_write_random(7);
  PluginHost *const host = open_own_kit(), *const other = open_kit(tabor_kit_count());
  host_save(host, &saved);
  assert_int_equal(saved.count, 2);
  const HostProperty *const kit = host_property(&saved, URI_STATE_KIT);
  const HostState of_before = {.properties = {*kit}, .count = 1}; /* without a version */
  assert_int_equal(host_restore(other, &saved), LV2_STATE_SUCCESS);
  assert_int_equal(host_restore(other, &of_before), LV2_STATE_SUCCESS);
  assert_true(strike(host, 36, 0) > 0);
  assert_true(strike(other, 36, 0) > 0);
  assert_memory_equal(host->sound[0], other->sound[0], sizeof host->sound[0]);
  host_set_property(&saved, URI_STATE_KIT, LV2_ATOM__String, empty, sizeof empty);
  assert_int_not_equal(host_restore(other, &saved), LV2_STATE_SUCCESS);
  assert_non_null(strstr(other->said, "no drum"));
  host_state_free(&saved);
  host_close(host);
  host_close(other);
}

/* The kit that was there plays on, and a line says why. */
static void refuse_file(PluginHost *host, const char *path, const char *reason) {
  host->said[0] = '\0';
  host_set_path(host, 0, URI_KIT_FILE, path);
  host_run(host, 0);
  assert_non_null(strstr(host->said, reason));
  assert_true(strike(host, 36, 0) > 0);
}

static void files_that_are_no_kits(void **state) {
  (void)state;
  char path[256];
  PluginHost *const none = open_kit(tabor_kit_count());
  assert_true(strike(none, 38, 1) > 1e-3);
  assert_non_null(strstr(none->said, "no kit file has been loaded"));
  host_close(none);
  kit_write_random(7);
  song_write_all();
  PluginHost *const host = open_own_kit();
  refuse_file(host, "/nonexistent/kit.ini", "/nonexistent/kit.ini: No such file");
  song_path(path, sizeof path, "song.mid");
  refuse_file(host, path, "song.mid:1: a control character");
  host->said[0] = '\0';
  host_set_path(host, 0, "urn:tabor:nothing", path);
  host_run(host, 0);
  assert_string_equal(host->said, "");
  host_close(host);
}

/* ---- sessions ------------------------------------------------------------------------------- */

/* Bits that the session has: every knob's port. The one instance has got there by ways, and begins
 * anew. */
static void ports_are_all_that_a_session_needs(void **state) {
  (void)state;
  PluginHost *const fresh = open_kit(2), *const used = open_kit(0);
  (void)strike(used, 41, 4);
  host_event(used, 0, 3, (const uint8_t[]){0xB9, 7, 20});
  used->kit_knobs[KIT_KNOB_KIT] = 2;
  PluginHost *const both[] = {fresh, used};
  for (int i = 0; i < 2; i++) {
    both[i]->kit_knobs[KIT_KNOB_TUNE] = 1.25f;
    both[i]->kit_knobs[KIT_KNOB_GAIN] = -3.5f;
    both[i]->kit_knobs[KIT_KNOB_VELOCITY_CURVE] = 2;
    host_run(both[i], HOST_BLOCK);
    both[i]->descriptor->deactivate(both[i]->handle);
    both[i]->descriptor->activate(both[i]->handle);
    assert_true(strike(both[i], 38, 0) > 1e-4);
  }
  for (uint32_t i = 0; i < PLUGIN_CHANNELS; i++) {
    assert_memory_equal(fresh->sound[i], used->sound[i], sizeof fresh->sound[i]);
  }
  host_close(fresh);
  host_close(used);
}

/* ---- another kit ---------------------------------------------------------------------------- */

/* Largest step from one sample of the mix to the next, `last` being the one before. */
static double largest_step(const float *sound, uint32_t count, float *last) {
  double most = 0;
  for (uint32_t i = 0; i < count; i++) {
    most = fmax(most, fabs((double)(sound[i] - *last)));
    *last = sound[i];
  }
  return most;
}

/* A kit that is exchanged while it rings fades out: nothing jumps. */
static void another_kit_comes_without_a_click(void **state) {
  (void)state;
  PluginHost *const host = open_kit(0);
  (void)strike(host, 41, 4);
  float last = host->sound[0][HOST_BLOCK - 1];
  const double loud = host_peak(host->sound[0], HOST_BLOCK);
  host->kit_knobs[KIT_KNOB_KIT] = 1;
  host_run(host, HOST_BLOCK);
  const double step = largest_step(host->sound[0], HOST_BLOCK, &last);
  print_message("peak %.3f, largest step %.4f\n", loud, step);
  assert_true(loud > 0.01 && step < 0.05 * loud);
  assert_true(host_peak(host->sound[0], HOST_BLOCK) > 0);
  host_run(host, HOST_BLOCK);
  assert_true(host_peak(host->sound[0], HOST_BLOCK) == 0);
  host_close(host);
}

/* In real time the kit rings on until the other one has been built, which `ready` says. */
static void nor_does_it_click_in_real_time(void **state) {
  (void)state;
  const struct timespec moment = {.tv_nsec = 1000000};
  PluginHost *const host = open_kit(0);
  host_run(host, 64);
  assert_true(host->ready == 1);
  host->freewheel = 0;
  (void)strike(host, 41, 4);
  float last = host->sound[0][HOST_BLOCK - 1];
  const double loud = host_peak(host->sound[0], HOST_BLOCK);
  double step = 0;
  host->kit_knobs[KIT_KNOB_KIT] = 1;
  host_run(host, 64);
  step = fmax(step, largest_step(host->sound[0], 64, &last));
  assert_true(host->ready == 0);
  for (uint32_t left = 60, runs = 0; left > 0; left -= host->ready == 1) { /* 80 ms after it came */
    assert_true(++runs < 20000);
    host_run(host, 64);
    step = fmax(step, largest_step(host->sound[0], 64, &last));
    if (host->ready < 1) (void)nanosleep(&moment, NULL);
  }
  print_message("peak %.3f, largest step %.4f\n", loud, step);
  assert_true(loud > 0.01 && step < 0.05 * loud);
  assert_true(strike(host, 38, 1) > 1e-3);
  host_close(host);
}

/* ---- careless hosts ------------------------------------------------------------------------- */

static void connect_nothing(PluginHost *host, PortKind kind, uint32_t index) {
  Port port;
  for (uint32_t number = 0; (port = host_port(host, number)).kind != PORT_NONE; number++) {
    if (port.kind != kind || port.index != index) continue;
    host->descriptor->connect_port(host->handle, number, NULL);
    return;
  }
  fail_msg("there is no such port");
}

/* What is no number leaves a knob where it is, and what is far out is at its end. */
static void knobs_that_are_no_numbers(void **state) {
  (void)state;
  static const float odd[] = {NAN, INFINITY, -INFINITY};
  PluginHost *const host = open_kit(0), *const plain = open_kit(0);
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    if (i != KIT_KNOB_QUALITY) host->kit_knobs[i] = odd[i % 3];
  }
  host->kit_knobs[KIT_KNOB_QUALITY] = -1e30f;
  assert_true(strike(host, 38, 1) == strike(plain, 38, 1));
  assert_string_equal(host->said, "");
  for (uint32_t i = 0; i < PLUGIN_CHANNELS; i++) {
    assert_memory_equal(host->sound[i], plain->sound[i], sizeof host->sound[i]);
  }
  host_close(host);
  host_close(plain);
}

/* The mix is the same without what is optional, and without knobs they are at their defaults. */
static void ports_that_are_not_connected(void **state) {
  (void)state;
  PluginHost *const host = open_kit(0), *const plain = open_kit(0);
  for (uint32_t i = 2; i < PLUGIN_CHANNELS; i++) connect_nothing(host, PORT_OUTPUT, i);
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    if (i != KIT_KNOB_QUALITY) connect_nothing(host, PORT_KNOB, i);
  }
  connect_nothing(host, PORT_READY, 0);
  (void)strike(host, 38, 1);
  assert_true(strike(plain, 38, 1) > 1e-3);
  for (uint32_t i = 0; i < 2; i++) {
    assert_memory_equal(host->sound[i], plain->sound[i], sizeof host->sound[i]);
  }
  connect_nothing(host, PORT_EVENTS, 0);
  connect_nothing(host, PORT_FREEWHEEL, 0);
  host_run(host, 0);
  host_run(host, 64);
  host_close(host);
  host_close(plain);
}

int main(int argc, char **argv) {
  if (argc < 3) return 1;
  plugins = argv[2];
  brief = argc == 4;
  if (argc == 5) random_songs = (unsigned)atoi(argv[4]);
  if (!songs_begin(argv[1], argc != 5)) return 1;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_mix_is_that_of_render),
    cmocka_unit_test(the_usual_quality_is_live),
    cmocka_unit_test(each_drum_is_that_of_split),
    cmocka_unit_test(random_songs_are_those_of_render),
    cmocka_unit_test(random_kits_are_those_of_render),
    cmocka_unit_test(a_session_has_the_own_kit),
    cmocka_unit_test(files_that_are_no_kits),
    cmocka_unit_test(levels_are_factors),
    cmocka_unit_test(tuning_moves_the_pitch),
    cmocka_unit_test(ports_are_all_that_a_session_needs),
    cmocka_unit_test(another_kit_comes_without_a_click),
    cmocka_unit_test(nor_does_it_click_in_real_time),
    cmocka_unit_test(knobs_that_are_no_numbers),
    cmocka_unit_test(ports_that_are_not_connected),
  };
  const int failed = cmocka_run_group_tests(tests, NULL, NULL);
  return songs_end() ? failed : 1;
}
