/* SPDX-License-Identifier: MIT */
/*
 * Drums and kits, built in and the user's, as a host's browser finds and loads them, and the pages
 * of remote controls.
 *
 * test_clap_presets PLUGINS
 */
#include "clap_host.h"

#include <ctype.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "user_files.h"
#include "windows_names.h"

#define MOST 64 /* presets */
#define FRAMES 4000
#define SIX_DIGITS 5e-6 /* relative: to which values of parameters are rounded */

static const clap_plugin_entry_t *entry;

/* ---- discovery ------------------------------------------------------------------------------ */

/* What a browser has heard of. */
static struct {
  uint32_t locations, filetypes, presets, plugins, kits, errors, limit;
  char folder[512]; /* of the user */
  char names[MOST][CLAP_NAME_SIZE], keys[MOST][CLAP_NAME_SIZE];
} heard;

static bool hear_location(const clap_preset_discovery_indexer_t *indexer,
                          const clap_preset_discovery_location_t *location) {
  (void)indexer;
  const bool is_file = location->kind == CLAP_PRESET_DISCOVERY_LOCATION_FILE;
  assert_int_equal(location->location != NULL, is_file);
  assert_int_equal(location->flags, is_file ? CLAP_PRESET_DISCOVERY_IS_USER_CONTENT
                                            : CLAP_PRESET_DISCOVERY_IS_FACTORY_CONTENT);
  if (is_file) (void)snprintf(heard.folder, sizeof heard.folder, "%s", location->location);
  heard.locations++;
  return true;
}

static bool hear_filetype(const clap_preset_discovery_indexer_t *indexer,
                          const clap_preset_discovery_filetype_t *filetype) {
  (void)indexer;
  assert_string_equal(filetype->file_extension, "ini");
  heard.filetypes++;
  return true;
}

static void hear_error(const clap_preset_discovery_metadata_receiver_t *receiver, int32_t error,
                       const char *message) {
  (void)receiver;
  (void)error;
  assert_true(strlen(message) > 0 && !strchr(message, '\n'));
  heard.errors++;
}

static bool hear_preset(const clap_preset_discovery_metadata_receiver_t *receiver, const char *name,
                        const char *key) {
  (void)receiver;
  if (heard.presets == heard.limit) return false;
  (void)snprintf(heard.names[heard.presets], CLAP_NAME_SIZE, "%s", name);
  (void)snprintf(heard.keys[heard.presets++], CLAP_NAME_SIZE, "%s", key ? key : "");
  return true;
}

static void hear_plugin(const clap_preset_discovery_metadata_receiver_t *receiver,
                        const clap_universal_plugin_id_t *plugin) {
  (void)receiver;
  assert_string_equal(plugin->abi, "clap");
  heard.plugins += strcmp(plugin->id, ID_DRUM) == 0 || strcmp(plugin->id, ID_DRUM_MULTI) == 0;
  heard.kits += strcmp(plugin->id, ID_KIT) == 0;
}

static void hear_text(const clap_preset_discovery_metadata_receiver_t *receiver, const char *text) {
  (void)receiver;
  assert_true(strlen(text) > 0);
}

static void hear_flags(const clap_preset_discovery_metadata_receiver_t *receiver, uint32_t flags) {
  (void)receiver;
  assert_true(flags == CLAP_PRESET_DISCOVERY_IS_FACTORY_CONTENT ||
              flags == CLAP_PRESET_DISCOVERY_IS_USER_CONTENT);
}

static const clap_preset_discovery_metadata_receiver_t receiver = {.on_error = hear_error,
                                                                   .begin_preset = hear_preset,
                                                                   .add_plugin_id = hear_plugin,
                                                                   .set_flags = hear_flags,
                                                                   .set_description = hear_text,
                                                                   .add_feature = hear_text};

/* A provider that has told its places; to be destroyed. Listens until `limit` presets have come. */
static const clap_preset_discovery_provider_t *open_provider(uint32_t limit) {
  static const clap_preset_discovery_indexer_t indexer = {.clap_version = CLAP_VERSION_INIT,
                                                          .name = "test",
                                                          .declare_filetype = hear_filetype,
                                                          .declare_location = hear_location};
  const clap_preset_discovery_factory_t *const factory =
    entry->get_factory(CLAP_PRESET_DISCOVERY_FACTORY_ID);
  assert_non_null(factory);
  assert_int_equal(factory->count(factory), 1);
  memset(&heard, 0, sizeof heard);
  heard.limit = limit;
  assert_null(factory->create(factory, &indexer, "nobody"));
  const clap_preset_discovery_provider_t *const provider =
    factory->create(factory, &indexer, factory->get_descriptor(factory, 0)->id);
  assert_non_null(provider);
  assert_true(provider->init(provider));
  return provider;
}

static void listen(uint32_t limit) {
  const clap_preset_discovery_provider_t *const provider = open_provider(limit);
  assert_true(
    provider->get_metadata(provider, CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN, NULL, &receiver));
  provider->destroy(provider);
}

static const char *name_of(uint32_t place) {
  const uint32_t drums = tabor_preset_count();
  return (place < drums ? tabor_preset(place) : tabor_kit(place - drums))->name;
}

static void test_a_browser_finds_every_drum_and_kit(void **state) {
  (void)state;
  assert_int_equal(setenv(USER_DATA, "/nonexistent", 1), 0);
  listen(MOST);
  assert_int_equal(heard.locations, 1);
  assert_int_equal(heard.filetypes, 0);
  assert_int_equal(heard.presets, tabor_preset_count() + tabor_kit_count());
  assert_int_equal(heard.plugins, 2 * tabor_preset_count());
  assert_int_equal(heard.kits, tabor_kit_count());
  for (uint32_t i = 0; i < heard.presets; i++) {
    assert_string_equal(heard.keys[i], name_of(i));
    assert_true(isupper((unsigned char)heard.names[i][0]));
    assert_null(strchr(heard.names[i], '-'));
  }
  listen(2); /* then the browser has enough */
  assert_int_equal(heard.presets, 2);
}

/* ---- files of the user ---------------------------------------------------------------------- */

static void test_a_browser_finds_the_users_files(void **state) {
  (void)state;
  const clap_preset_discovery_provider_t *const provider = open_provider(MOST);
  const uint32_t kind = CLAP_PRESET_DISCOVERY_LOCATION_FILE;
  assert_int_equal(heard.locations, 2);
  assert_int_equal(heard.filetypes, 1);
  assert_true(strncmp(heard.folder, user_data(), strlen(user_data())) == 0);
  assert_true(provider->get_metadata(provider, kind, user_file("drum.ini"), &receiver));
  assert_string_equal(heard.names[0], "mine");
  assert_int_equal(heard.plugins, 2);
  assert_int_equal(heard.kits, 0);
  assert_true(provider->get_metadata(provider, kind, user_file("kit.ini"), &receiver));
  assert_string_equal(heard.names[1], "my-kit");
  assert_int_equal(heard.kits, 1);
  assert_int_equal(heard.errors, 0);
  assert_false(provider->get_metadata(provider, kind, user_file("else.ini"), &receiver));
  assert_false(provider->get_metadata(provider, kind, user_file("none.ini"), &receiver));
  assert_int_equal(heard.errors, 2);
  assert_int_equal(heard.presets, 2);
  provider->destroy(provider);
}

/* ---- loading -------------------------------------------------------------------------------- */

static bool load(ClapHost *host, uint32_t kind, const char *location, const char *key) {
  const clap_plugin_preset_load_t *const loader = clap_host_extension(host, CLAP_EXT_PRESET_LOAD);
  host->loaded[0] = host->refused[0] = '\0';
  return loader->from_location(host->plugin, kind, location, key);
}

/* In free air. */
static ClapHost *open_plugin(const char *id) {
  ClapHost *const host = clap_host_open(entry, id);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_set(host, 0, KNOB_ROOM, TABOR_ROOM_NONE);
  clap_host_flush(host);
  clap_host_render(host, true);
  return host;
}

static ClapHost *open_drum(void) { return open_plugin(ID_DRUM); }

/* Of the left side, after `program` was chosen by MIDI, if it is one. */
static void record(ClapHost *host, int program, float *sound) {
  if (!host->is_active) clap_host_activate(host);
  if (program >= 0) clap_host_midi(host, 0, &(MidiMessage){0xC9, {(uint8_t)program, 0}});
  clap_host_run(host, FRAMES); /* what a preset replaces fades */
  clap_host_midi(host, 0, &(MidiMessage){0x99, {38, 100}});
  clap_host_run(host, FRAMES);
  memcpy(sound, host->sound[0], FRAMES * sizeof *sound);
}

/* A drum that has no such head leaves the parameter where it is. */
static void shows_pitch(const ClapHost *host, KnobId id, const TaborDrumDef *def, TaborHead head) {
  double pitch;
  const bool is_there = tabor_drum_def_pitch(def, head, &pitch, NULL) == TABOR_OK;
  const double shown = clap_host_value(host, id);
  if (is_there && fabs(shown - clap_host_pitch(pitch)) > SIX_DIGITS) {
    fail_msg("%s: %g, not that of %g Hz", knobs[id].symbol, shown, pitch);
  }
}

/* Every preset is loaded; its parameters stand where the drum does. */
static void test_parameters_show_the_drum(void **state) {
  (void)state;
  ClapHost *const host = open_drum();
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    const char *const name = tabor_preset(i)->name;
    TaborDrumDef def;
    assert_int_equal(tabor_drum_def_preset(&def, name, NULL), TABOR_OK);
    if (!load(host, CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN, NULL, name)) fail_msg("%s", name);
    assert_string_equal(host->loaded, name);
    assert_int_equal(host->rescans, i + 1);
    assert_true(clap_host_value(host, KNOB_DRUM) == i);
    const double muffling = clap_host_value(host, KNOB_BATTER_MUFFLING);
    const double *const field = knob_field(&def, KNOB_BATTER_MUFFLING);
    if (field && fabs(muffling - *field) > 1e-6 * fabs(*field)) fail_msg("%s: %g", name, muffling);
    shows_pitch(host, KNOB_BATTER_PITCH, &def, TABOR_HEAD_BATTER);
    shows_pitch(host, KNOB_RESONANT_PITCH, &def, TABOR_HEAD_RESONANT);
  }
  clap_host_close(host);
}

static void test_a_loaded_drum_sounds_as_one_chosen_by_midi(void **state) {
  (void)state;
  static float one[FRAMES], other[FRAMES];
  ClapHost *const host = open_drum(), *const chosen = open_drum();
  assert_true(load(host, CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN, NULL, tabor_preset(1)->name));
  record(host, -1, one);
  record(chosen, 1, other);
  assert_memory_equal(one, other, sizeof one);
  double peak = 0;
  for (uint32_t i = 0; i < FRAMES; i++) peak = fmax(peak, fabs((double)one[i]));
  assert_true(peak > 1e-3);
  clap_host_close(host);
  clap_host_close(chosen);
}

/* With another control at the same frame, which turns the new drum. */
static void test_the_parameter_chooses_a_drum_as_midi_does(void **state) {
  (void)state;
  static float one[FRAMES], other[FRAMES];
  static const char *const plugins[] = {ID_DRUM, ID_EFFECT};
  for (size_t i = 0; i < sizeof plugins / sizeof plugins[0]; i++) {
    ClapHost *const host = open_plugin(plugins[i]), *const chosen = open_plugin(plugins[i]);
    clap_host_activate(host);
    clap_host_set(host, 0, KNOB_BATTER_TENSION, 0.5);
    clap_host_set(host, 0, KNOB_DRUM, 1);
    clap_host_run(host, 2);
    record(host, -1, one);
    clap_host_activate(chosen);
    clap_host_midi(chosen, 0, &(MidiMessage){0xC9, {1, 0}});
    clap_host_run(chosen, 1);
    clap_host_set(chosen, 0, KNOB_BATTER_TENSION, 0.5);
    clap_host_run(chosen, 1);
    record(chosen, -1, other);
    assert_memory_equal(one, other, sizeof one);
    clap_host_close(host);
    clap_host_close(chosen);
  }
}

static void test_the_parameter_follows_a_program_change(void **state) {
  (void)state;
  ClapHost *const host = open_drum();
  clap_host_activate(host);
  clap_host_midi(host, 0, &(MidiMessage){0xC9, {1, 0}});
  clap_host_run(host, 1);
  clap_host_run(host, 1);
  assert_true(clap_host_value(host, KNOB_DRUM) == 1);
  assert_int_equal(host->callbacks, 1);
  host->plugin->on_main_thread(host->plugin);
  assert_int_equal(host->rescans, 1);
  clap_host_close(host);
}

static void test_a_drum_is_loaded_from_a_file(void **state) {
  (void)state;
  static float one[FRAMES], other[FRAMES];
  ClapHost *const host = open_drum(), *const plain = open_drum();
  const uint32_t kind = CLAP_PRESET_DISCOVERY_LOCATION_FILE;
  if (!load(host, kind, user_file("drum.ini"), NULL)) fail_msg("%s", host->refused);
  assert_string_equal(host->loaded, user_file("drum.ini"));
  record(host, -1, one);
  record(plain, -1, other);
  assert_memory_not_equal(one, other, sizeof one);
  assert_false(load(host, kind, user_file("kit.ini"), NULL));
  assert_non_null(strstr(host->refused, "kit.ini:1"));
  clap_host_close(host);
  clap_host_close(plain);
}

static void test_what_is_no_preset_changes_nothing(void **state) {
  (void)state;
  static ClapState before, after;
  ClapHost *const host = open_drum();
  clap_host_save(host, &before);
  assert_false(load(host, CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN, NULL, "no-such-drum"));
  assert_non_null(strstr(host->refused, "no-such-drum"));
  assert_false(load(host, CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN, NULL, NULL));
  assert_non_null(strstr(host->refused, "built-in drums"));
  assert_false(load(host, CLAP_PRESET_DISCOVERY_LOCATION_FILE, "/none", tabor_preset(1)->name));
  assert_non_null(strstr(host->refused, "/none: No such file"));
  assert_string_equal(host->loaded, "");
  assert_int_equal(host->rescans, 0);
  clap_host_save(host, &after);
  assert_int_equal(before.size, after.size);
  assert_memory_equal(before.bytes, after.bytes, before.size);
  clap_host_close(host);
}

/* ---- pages of remote controls --------------------------------------------------------------- */

static bool has_parameter(const ClapHost *host, clap_id id) {
  const clap_plugin_params_t *const params = clap_host_extension(host, CLAP_EXT_PARAMS);
  clap_param_info_t info;
  for (uint32_t i = 0; i < params->count(host->plugin); i++) {
    assert_true(params->get_info(host->plugin, i, &info));
    if (info.id == id) return true;
  }
  return false;
}

/* Tensions come second. A host knows a page by its id. */
static void check_page(uint32_t index, const clap_remote_controls_page_t *page) {
  static const clap_id ids[] = {0, 2, 1, 3, 4};
  assert_int_equal(page->page_id, ids[index]);
  if (index == 0) assert_int_equal(page->param_ids[0], clap_host_id(KNOB_BATTER_PITCH));
  if (index == 1) assert_int_equal(page->param_ids[0], clap_host_id(KNOB_BATTER_TENSION));
}

static void check_pages(const char *plugin, uint32_t expected) {
  ClapHost *const host = clap_host_open(entry, plugin);
  const clap_plugin_remote_controls_t *const pages =
    clap_host_extension(host, CLAP_EXT_REMOTE_CONTROLS);
  clap_remote_controls_page_t page;
  assert_int_equal(pages->count(host->plugin), expected);
  for (uint32_t i = 0; i < expected; i++) {
    assert_true(pages->get(host->plugin, i, &page));
    assert_true(strlen(page.page_name) > 0);
    for (uint32_t k = 0; k < CLAP_REMOTE_CONTROLS_COUNT; k++) {
      if (page.param_ids[k] == CLAP_INVALID_ID) continue;
      assert_true(has_parameter(host, page.param_ids[k]));
    }
    check_page(i, &page);
  }
  assert_false(pages->get(host->plugin, expected, &page));
  clap_host_close(host);
}

static void test_pages_have_parameters_of_the_plugin(void **state) {
  (void)state;
  check_pages(ID_DRUM, 4);
  check_pages(ID_DRUM_MULTI, 3);
  check_pages(ID_EFFECT, 5);
}

int main(int argc, char **argv) {
  if (argc < 2) return 1;
  entry = clap_host_entry(argv[1]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_a_browser_finds_every_drum_and_kit),
    cmocka_unit_test_setup_teardown(test_a_browser_finds_the_users_files, user_files_make,
                                    user_files_remove),
    cmocka_unit_test_setup_teardown(test_a_drum_is_loaded_from_a_file, user_files_make,
                                    user_files_remove),
    cmocka_unit_test(test_parameters_show_the_drum),
    cmocka_unit_test(test_a_loaded_drum_sounds_as_one_chosen_by_midi),
    cmocka_unit_test(test_the_parameter_chooses_a_drum_as_midi_does),
    cmocka_unit_test(test_the_parameter_follows_a_program_change),
    cmocka_unit_test(test_what_is_no_preset_changes_nothing),
    cmocka_unit_test(test_pages_have_parameters_of_the_plugin),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
