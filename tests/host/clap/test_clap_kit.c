/* SPDX-License-Identifier: MIT */
/*
 * The CLAP plugin Tabor Kit plays a MIDI file as `tabor render --kit` does, to the bit, its mix and
 * each drum, whatever the sizes of the blocks are; knobs, states, chokes and names do what they
 * say.
 *
 * test_clap_kit PROGRAM PLUGINS [brief | songs NUMBER]
 *
 * `songs` plays NUMBER random songs on all kits.
 */
#include "clap_songs.h"
#include "midi/kit_map.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "windows_names.h"

static const clap_plugin_entry_t *entry;
static bool brief;
static unsigned random_songs = 1;

static const char rendered[] = "render -o";

/* Active and offline, at draft. */
static ClapHost *activate_kit(ClapHost *host, double kit) {
  clap_host_set_id(host, 0, KIT_KNOB_KIT, kit);
  clap_host_set_id(host, 0, KIT_KNOB_QUALITY, 0);
  clap_host_flush(host);
  clap_host_render(host, true);
  clap_host_activate(host);
  return host;
}

static ClapHost *open_kit(double kit) { return activate_kit(clap_host_open(entry, ID_KIT), kit); }

static void same_mix(double kit, const char *options, const uint32_t *blocks, size_t count) {
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  take_from(rendered, options, NULL, &expected);
  for (size_t i = 0; i < count; i++) {
    ClapHost *const host = open_kit(kit);
    clap_host_play(host, blocks[i], 0, &take);
    take_compare(&expected, &take, blocks[i]);
    clap_host_close(host);
  }
  take_close(&expected);
  take_close(&take);
}

static void the_mix_is_that_of_render(void **state) {
  (void)state;
  static const uint32_t blocks[] = {0, 37, CLAP_BLOCK};
  song_write_all();
  same_mix(0, "--kit standard --quality draft", blocks, brief ? 1 : 3);
}

/* Those of the host, which gives them, or says no. */
static void threads_change_no_bit(void **state) {
  (void)state;
  HostThreads *const threads = host_threads_begin(2);
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  take_from(rendered, "--kit standard --quality draft -j 1", NULL, &expected);
  for (int i = 0; i < 2; i++) {
    ClapHost *const host = activate_kit(clap_host_open_threaded(entry, ID_KIT, threads), 0);
    host->refuses_threads = i == 1;
    clap_host_play(host, 128, 0, &take);
    take_compare(&expected, &take, 128);
    clap_host_close(host);
  }
  assert_true(host_threads_runs(threads) > 0);
  host_threads_end(threads);
  take_close(&expected);
  take_close(&take);
}

static void each_drum_is_that_of_split(void **state) {
  (void)state;
  static const char *const drums[] = {"kick", "snare", "high-tom"};
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  song_write_all();
  take_from(rendered, "--kit standard --quality draft --split", NULL, &expected);
  for (uint32_t i = 0; i < 3; i++) {
    char name[64], path[256];
    (void)snprintf(name, sizeof name, "song-%s.wav", drums[i]);
    song_path(path, sizeof path, name);
    take_read(path, &expected);
    ClapHost *const host = open_kit(0);
    clap_host_play(host, 256, 2 + 2 * i, &take);
    take_compare(&expected, &take, 256);
    clap_host_close(host);
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

static double peak(const ClapHost *host, uint32_t channel, uint32_t frames) {
  double most = 0;
  for (uint32_t i = 0; i < frames; i++) most = fmax(most, fabs((double)host->sound[channel][i]));
  return most;
}

/* Peak of the drum's own output in the first block after a stroke on `note`. */
static double strike(ClapHost *host, uint8_t note, uint32_t drum) {
  clap_host_midi(host, 0, &(MidiMessage){0x99, {note, 100}});
  clap_host_run(host, CLAP_BLOCK);
  return peak(host, 2 + 2 * drum, CLAP_BLOCK);
}

/* Gain and level are factors of the drum's part, and "Off" is silence. */
static void levels_are_factors(void **state) {
  (void)state;
  ClapHost *host = open_kit(0);
  const double whole = strike(host, 38, 1);
  clap_host_close(host);
  assert_true(whole > 1e-3);
  host = clap_host_open(entry, ID_KIT);
  clap_host_set_id(host, 0, KIT_KNOB_QUALITY, 0);
  clap_host_set_id(host, 0, KIT_KNOB_GAIN, -6);
  clap_host_set_id(host, 0, KIT_KNOB_LEVEL + 1, -14);
  clap_host_flush(host);
  clap_host_render(host, true);
  clap_host_activate(host);
  clap_host_run(host, CLAP_BLOCK); /* gains glide */
  assert_true(fabs(strike(host, 38, 1) / whole - 0.1) < 1e-4);
  clap_host_set_id(host, 0, KIT_KNOB_LEVEL + 1, -60);
  clap_host_run(host, CLAP_BLOCK);
  assert_true(strike(host, 38, 1) == 0);
  clap_host_close(host);
}

/* Overheads that move every 10 ms while a drum rings move at once, and what rings goes on: nothing
 * is built or faded. */
static void overheads_move_while_drums_ring(void **state) {
  (void)state;
  enum { STEP = 480, STEPS = 20, RINGS = 2 + 2 * 2 };
  ClapHost *const still = open_kit(0), *const moved = open_kit(0);
  (void)strike(still, 48, 2);
  (void)strike(moved, 48, 2);
  for (int i = 0; i < STEPS; i++) {
    clap_host_set_id(moved, 0, KIT_KNOB_OVERHEADS, i % 2 == 0 ? -60 : 0);
    clap_host_run(moved, STEP);
    clap_host_run(still, STEP);
    const float a = still->sound[RINGS][STEP - 1], b = moved->sound[RINGS][STEP - 1];
    if (i % 2 == 0) assert_true(a != b);
    if (i % 2 == 1)
      assert_memory_equal(still->sound[RINGS] + STEP / 2, moved->sound[RINGS] + STEP / 2,
                          STEP / 2 * sizeof a);
  }
  assert_true(peak(moved, RINGS, STEP) > 1e-4);
  clap_host_close(still);
  clap_host_close(moved);
}

/* Where drums do not hear each other, a drum that is not struck is silent. */
static void the_coupling_moves_at_once(void **state) {
  (void)state;
  static const double couplings[] = {0, -60};
  for (int i = 0; i < 2; i++) {
    ClapHost *const host = open_kit(0);
    clap_host_run(host, CLAP_BLOCK);
    clap_host_set_id(host, 0, KIT_KNOB_COUPLING, couplings[i]);
    clap_host_run(host, CLAP_BLOCK);
    (void)strike(host, 48, 2);
    clap_host_run(host, CLAP_BLOCK);
    print_message("snare drum beside a tom at %g dB: %g\n", couplings[i],
                  peak(host, 2 + 2 * 1, CLAP_BLOCK));
    assert_true((peak(host, 2 + 2 * 1, CLAP_BLOCK) > 0) == (i == 0));
    clap_host_close(host);
  }
}

/* A new beginning forgets controllers, not knobs. */
static void knobs_outlive_a_reset(void **state) {
  (void)state;
  ClapHost *const host = open_kit(0);
  double peaks[3];
  clap_host_set_id(host, 0, KIT_KNOB_GAIN, -6);
  clap_host_set_id(host, 0, KIT_KNOB_LEVEL + 1, -14);
  clap_host_run(host, CLAP_BLOCK);
  for (int i = 0; i < 3; i++) {
    peaks[i] = strike(host, 38, 1);
    clap_host_midi(host, 0, &(MidiMessage){0xB9, {7, 20}});
    clap_host_run(host, CLAP_BLOCK);
    if (i == 0) host->plugin->reset(host->plugin);
    if (i > 0) clap_host_deactivate(host);
    if (i == 1) clap_host_activate(host);
  }
  print_message("peaks %g %g %g\n", peaks[0], peaks[1], peaks[2]);
  assert_true(peaks[0] > 1e-4 && peaks[1] == peaks[0] && peaks[2] == peaks[0]);
  clap_host_close(host);
}

static double rate_of_crossings(const ClapHost *host, uint32_t channel) {
  uint32_t count = 0;
  for (uint32_t i = 1; i < CLAP_BLOCK; i++) {
    count += host->sound[channel][i - 1] < 0 && host->sound[channel][i] >= 0;
  }
  return 48000.0 * count / CLAP_BLOCK;
}

/* A tom an octave higher rings an octave higher, more or less: its air does not go along. */
static void tuning_moves_the_pitch(void **state) {
  (void)state;
  double rates[2];
  for (int i = 0; i < 2; i++) {
    ClapHost *const host = open_kit(0);
    clap_host_set_id(host, 0, KIT_KNOB_TUNE + 4, i == 0 ? 0 : 12);
    (void)strike(host, 41, 4);
    clap_host_run(host, CLAP_BLOCK);
    rates[i] = rate_of_crossings(host, 10);
    clap_host_close(host);
  }
  print_message("floor tom: %.0f Hz, tuned up %.0f Hz\n", rates[0], rates[1]);
  assert_true(rates[1] > 1.5 * rates[0]);
}

/* What a knob does, in every second block, to a tom that rings beside others. */
typedef struct Automation {
  KitKnobId knob;
  double values[2];
  bool keeps_tom; /* the tom itself has the same bits, too */
} Automation;

/* While a drum is tuned or the room changes, nothing fades: the other drums have the same bits, and
 * the tom rings on. */
static void automate(const Automation *automation) {
  enum { STEP = 480, STEPS = 12, KICKS = 2, SNARES = 4, TOMS = 6 }; /* channels */
  ClapHost *const hosts[2] = {open_kit(0), open_kit(0)};
  for (int i = 0; i < 2; i++) {
    clap_host_set_id(hosts[i], 0, KIT_KNOB_COUPLING, -60);
    clap_host_run(hosts[i], CLAP_BLOCK);
    (void)strike(hosts[i], 36, 2);
    (void)strike(hosts[i], 48, 2);
    (void)strike(hosts[i], 38, 2);
  }
  ClapHost *const still = hosts[0], *const moved = hosts[1];
  for (int i = 0; i < STEPS; i++) {
    clap_host_set_id(moved, 0, automation->knob, automation->values[i % 2]);
    clap_host_run(moved, STEP);
    clap_host_run(still, STEP);
    const size_t bytes = STEP * sizeof(float);
    assert_memory_equal(still->sound[SNARES], moved->sound[SNARES], bytes);
    assert_memory_equal(still->sound[KICKS], moved->sound[KICKS], bytes);
    const bool is_same = memcmp(still->sound[TOMS], moved->sound[TOMS], bytes) == 0;
    assert_int_equal(is_same, automation->keeps_tom);
    assert_true(peak(still, SNARES, STEP) > 0 && peak(still, KICKS, STEP) > 0);
    assert_true(peak(moved, TOMS, STEP) > 0.3 * peak(still, TOMS, STEP));
  }
  assert_string_equal(moved->said, "");
  clap_host_close(still);
  clap_host_close(moved);
}

static void tuning_and_rooms_move_while_drums_ring(void **state) {
  (void)state;
  automate(&(Automation){KIT_KNOB_TUNE + 2, {2, -1}, false});
  automate(&(Automation){KIT_KNOB_ROOM, {4, 1}, true});
}

/* A kit that is exchanged while it rings fades out: nothing jumps. */
static void another_kit_comes_without_a_click(void **state) {
  (void)state;
  ClapHost *const host = open_kit(0);
  (void)strike(host, 41, 4);
  const float before = host->sound[0][CLAP_BLOCK - 1];
  const double loud = peak(host, 0, CLAP_BLOCK);
  clap_host_set_id(host, 0, KIT_KNOB_KIT, 1);
  clap_host_run(host, CLAP_BLOCK);
  double step = fabs((double)(host->sound[0][0] - before));
  for (uint32_t i = 1; i < CLAP_BLOCK; i++) {
    step = fmax(step, fabs((double)(host->sound[0][i] - host->sound[0][i - 1])));
  }
  print_message("peak %.3f, largest step %.4f\n", loud, step);
  assert_true(loud > 0.01 && step < 0.05 * loud);
  assert_true(peak(host, 0, CLAP_BLOCK) > 0);
  clap_host_run(host, CLAP_BLOCK);
  assert_true(peak(host, 0, CLAP_BLOCK) == 0);
  assert_true(host->callbacks > 0); /* notes have other names */
  clap_host_close(host);
}

/* ---- events --------------------------------------------------------------------------------- */

static void a_choke_silences_its_drum_alone(void **state) {
  (void)state;
  ClapHost *const host = open_kit(0);
  (void)strike(host, 41, 4);
  (void)strike(host, 48, 2);
  clap_host_note(host, 0, CLAP_EVENT_NOTE_CHOKE, 41, 0);
  clap_host_run(host, CLAP_BLOCK);
  clap_host_run(host, CLAP_BLOCK);
  assert_true(peak(host, 10, CLAP_BLOCK) == 0);
  assert_true(peak(host, 6, CLAP_BLOCK) > 0);
  clap_host_note(host, 5, CLAP_EVENT_NOTE_ON, 41, 0.8);
  clap_host_note(host, 5, CLAP_EVENT_NOTE_CHOKE, 41, 0);
  clap_host_run(host, CLAP_BLOCK);
  assert_true(peak(host, 10, CLAP_BLOCK) == 0);
  clap_host_note(host, 5, CLAP_EVENT_NOTE_CHOKE, -1, 0);
  clap_host_run(host, CLAP_BLOCK);
  clap_host_run(host, CLAP_BLOCK);
  assert_true(peak(host, 6, CLAP_BLOCK) == 0);
  assert_int_equal(host->ended, 3);
  clap_host_close(host);
}

/* By General MIDI and by a drum module. */
static void notes_have_names(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_KIT);
  const clap_plugin_note_name_t *const names = clap_host_extension(host, CLAP_EXT_NOTE_NAME);
  const uint32_t count = names->count(host->plugin);
  clap_note_name_t name;
  bool found = false;
  for (uint32_t i = 0; i < count; i++) {
    assert_true(names->get(host->plugin, i, &name));
    if (name.key == 37) found = strcmp(name.name, "snare cross-stick") == 0;
  }
  assert_true(count >= 11 && found);
  assert_false(names->get(host->plugin, count, &name));
  clap_host_set_id(host, 0, KIT_KNOB_NOTES, 1);
  clap_host_flush(host);
  found = false;
  for (uint32_t i = 0; names->get(host->plugin, i, &name); i++) {
    if (name.key == 58) found = strcmp(name.name, "floor-tom rimshot") == 0;
  }
  assert_true(found);
  clap_host_close(host);
}

/* ---- states --------------------------------------------------------------------------------- */

static void states_come_back(void **state) {
  (void)state;
  static ClapState saved, again;
  ClapHost *const host = open_kit(2);
  clap_host_set_id(host, 0, KIT_KNOB_TUNE, 1.25);
  clap_host_run(host, 64);
  clap_host_save(host, &saved);
  clap_host_close(host);
  ClapHost *const other = open_kit(0);
  assert_true(clap_host_load(other, &saved));
  assert_int_equal(other->rescans, 1);
  const clap_plugin_params_t *const params = clap_host_extension(other, CLAP_EXT_PARAMS);
  double kit, tune;
  assert_true(params->get_value(other->plugin, KIT_KNOB_KIT, &kit));
  assert_true(params->get_value(other->plugin, KIT_KNOB_TUNE, &tune));
  assert_true(kit == 2 && tune == 1.25);
  clap_host_save(other, &again);
  assert_int_equal(saved.size, again.size);
  assert_memory_equal(saved.bytes, again.bytes, saved.size);
  memcpy(saved.bytes, "tabor-kit-state 9", 17);
  assert_false(clap_host_load(other, &saved));
  assert_non_null(strstr(other->said, "this version"));
  char *const name = strstr(again.bytes, "marching");
  assert_non_null(name);
  *name = 'x';
  assert_false(clap_host_load(other, &again));
  assert_non_null(strstr(other->said, "no such kit"));
  clap_host_close(other);
}

/* ---- the user's own kit ---------------------------------------------------------------------- */

static bool load_file(ClapHost *host, const char *path) {
  const clap_plugin_preset_load_t *const loader = clap_host_extension(host, CLAP_EXT_PRESET_LOAD);
  host->loaded[0] = host->refused[0] = '\0';
  return loader->from_location(host->plugin, CLAP_PRESET_DISCOVERY_LOCATION_FILE, path, NULL);
}

static ClapHost *open_own_kit(void) {
  char path[256];
  ClapHost *const host = open_kit(0);
  song_path(path, sizeof path, "kit.ini");
  if (!load_file(host, path)) fail_msg("%s", host->refused);
  assert_string_equal(host->loaded, path);
  return host;
}

static void random_kits_are_those_of_render(void **state) {
  (void)state;
  if (!clap_host_has_sound_files()) skip();
  char path[256], options[300];
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  song_path(path, sizeof path, "kit.ini");
  (void)snprintf(options, sizeof options, "--kit " QUOTED("%s") " --quality draft", path);
  for (uint64_t seed = 1; seed <= random_songs; seed++) {
    print_message("seed %u\n", (unsigned)seed);
    kit_write_random(seed);
    song_write_random(seed);
    take_from(rendered, options, NULL, &expected);
    ClapHost *const host = open_own_kit();
    clap_host_run(host, 0);
    clap_host_play(host, 0, 0, &take);
    take_compare(&expected, &take, 0);
    clap_host_close(host);
  }
  take_close(&expected);
  take_close(&take);
}

/* A state has the kit itself, not its file; notes have the names of its drums. */
static void a_state_has_the_own_kit(void **state) {
  (void)state;
  if (!clap_host_has_sound_files()) skip();
  static ClapState saved, again;
  static float sound[CLAP_BLOCK];
  kit_write_random(7);
  ClapHost *const host = open_own_kit(), *const other = open_kit(0);
  clap_host_save(host, &saved);
  assert_true(clap_host_load(other, &saved));
  clap_host_save(other, &again);
  assert_int_equal(saved.size, again.size);
  assert_memory_equal(saved.bytes, again.bytes, saved.size);
  assert_true(strike(host, 36, 0) > 0);
  memcpy(sound, host->sound[0], sizeof sound);
  assert_true(strike(other, 36, 0) > 0);
  assert_memory_equal(sound, other->sound[0], sizeof sound);
  clap_host_run(other, CLAP_BLOCK);
  other->plugin->reset(other->plugin);
  (void)strike(other, 48, 0); /* has a sound file, and no drum */
  assert_true(peak(other, 0, CLAP_BLOCK) > 1e-3 && peak(other, 2, CLAP_BLOCK) == 0);
  const clap_plugin_note_name_t *const names = clap_host_extension(other, CLAP_EXT_NOTE_NAME);
  clap_note_name_t name;
  assert_true(names->get(other->plugin, 0, &name));
  assert_int_equal(name.key, 36);
  assert_string_equal(name.name, "d0");
  clap_host_close(host);
  clap_host_close(other);
}

/* A note whose file is gone is silent, and the host's log has the reason; all else plays. */
static void a_sound_that_is_gone_is_said(void **state) {
  (void)state;
  if (!clap_host_has_sound_files()) skip();
  char path[256];
  kit_write_random(7);
  song_path(path, sizeof path, "sound-one.wav");
  assert_int_equal(remove(path), 0);
  ClapHost *const host = open_own_kit();
  (void)strike(host, 48, 0);
  assert_true(peak(host, 0, CLAP_BLOCK) == 0);
  (void)strike(host, 47, 0);
  assert_true(peak(host, 0, CLAP_BLOCK) > 1e-3);
  assert_non_null(strstr(host->said, "sound-one.wav"));
  clap_host_close(host);
}

static void files_that_are_no_kits(void **state) {
  (void)state;
  static ClapState saved;
  char path[256];
  ClapHost *const host = open_kit(tabor_kit_count());
  assert_non_null(strstr(host->said, "no kit file has been loaded"));
  assert_true(strike(host, 38, 1) > 1e-3);
  assert_false(load_file(host, "/nonexistent/kit.ini"));
  assert_non_null(strstr(host->refused, "/nonexistent/kit.ini: No such file"));
  song_write_all();
  song_path(path, sizeof path, "song.mid");
  assert_false(load_file(host, path));
  assert_non_null(strstr(host->refused, "song.mid:1: a control character"));
  clap_host_close(host);
  kit_write_random(7);
  ClapHost *const own = open_own_kit();
  clap_host_save(own, &saved);
  char *const preset = strstr(saved.bytes, "preset =");
  assert_non_null(preset);
  *preset = 'x';
  assert_false(clap_host_load(own, &saved));
  assert_non_null(strstr(own->said, "xreset"));
  assert_true(strike(own, 36, 0) > 0);
  clap_host_close(own);
}

/* ---- words ---------------------------------------------------------------------------------- */

static void expect_word(ClapHost *host, KitKnobId id, uint32_t choice, const char *word) {
  const clap_plugin_params_t *const params = clap_host_extension(host, CLAP_EXT_PARAMS);
  char text[64];
  double value;
  assert_true(params->value_to_text(host->plugin, id, choice, text, sizeof text));
  assert_string_equal(text, word);
  assert_true(params->text_to_value(host->plugin, id, text, &value));
  assert_true(value == choice);
}

/* The words of the knobs are the kits and the maps, in their order. */
static void choices_are_kits_and_maps(void **state) {
  (void)state;
  ClapHost *const host = clap_host_open(entry, ID_KIT);
  assert_true(kit_knobs[KIT_KNOB_KIT].maximum == (float)tabor_kit_count());
  assert_true(kit_knobs[KIT_KNOB_NOTES].maximum == (float)kit_map_count);
  for (uint32_t i = 0; i < tabor_kit_count(); i++) {
    expect_word(host, KIT_KNOB_KIT, i, tabor_kit(i)->name);
  }
  expect_word(host, KIT_KNOB_KIT, tabor_kit_count(), "Own kit");
  for (uint32_t i = 0; i < kit_map_count; i++) {
    expect_word(host, KIT_KNOB_NOTES, i + 1u, kit_maps[i].name);
  }
  clap_host_close(host);
}

int main(int argc, char **argv) {
  if (argc < 3) return 1;
  entry = clap_host_entry(argv[2]);
  brief = argc == 4;
  if (argc == 5) random_songs = (unsigned)atoi(argv[4]);
  if (!songs_begin(argv[1], argc != 5)) return 1;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_mix_is_that_of_render),
    cmocka_unit_test(threads_change_no_bit),
    cmocka_unit_test(each_drum_is_that_of_split),
    cmocka_unit_test(random_songs_are_those_of_render),
    cmocka_unit_test(random_kits_are_those_of_render),
    cmocka_unit_test(a_state_has_the_own_kit),
    cmocka_unit_test(a_sound_that_is_gone_is_said),
    cmocka_unit_test(files_that_are_no_kits),
    cmocka_unit_test(levels_are_factors),
    cmocka_unit_test(overheads_move_while_drums_ring),
    cmocka_unit_test(the_coupling_moves_at_once),
    cmocka_unit_test(knobs_outlive_a_reset),
    cmocka_unit_test(tuning_moves_the_pitch),
    cmocka_unit_test(tuning_and_rooms_move_while_drums_ring),
    cmocka_unit_test(another_kit_comes_without_a_click),
    cmocka_unit_test(a_choke_silences_its_drum_alone),
    cmocka_unit_test(notes_have_names),
    cmocka_unit_test(states_come_back),
    cmocka_unit_test(choices_are_kits_and_maps),
  };
  const int failed = cmocka_run_group_tests(tests, NULL, NULL);
  return songs_end() ? failed : 1;
}
