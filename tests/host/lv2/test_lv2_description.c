/* SPDX-License-Identifier: MIT */
/*
 * The bundle as hosts see it, through lilv: what validators miss. The description against the
 * binary, indices, symbols, ranges, and the factory presets, which are the built-in ones.
 *
 * test_lv2_description BUNDLE
 */
#include "plugin_host.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#ifdef TABOR_HAVE_LILV
#  include <lilv/lilv.h>
#  include <lv2/port-groups/port-groups.h>
#  include <lv2/presets/presets.h>

#  include "drums/definition_text.h"
#  include "lv2/plugins.h"
#  include "midi/kit_map.h"
#  include "plugin/knob_text.h"

static const char *bundle;
static LilvWorld *world;
static TaborDrumDef usual;

static const char *const plugin_uris[] = {URI_DRUM, URI_DRUM_MULTI, URI_EFFECT, URI_KIT};
enum { DRUMS = 2, PLUGINS = 4 }; /* the first two have presets */

static LilvNode *uri(const char *text) { return lilv_new_uri(world, text); }

static int open_world(void **state) {
  (void)state;
  world = lilv_world_new();
  char path[4096];
  (void)snprintf(path, sizeof path, "%s/", bundle); /* as lilv has folders */
  LilvNode *const folder = lilv_new_file_uri(world, NULL, path);
  lilv_world_load_bundle(world, folder);
  lilv_node_free(folder);
  return tabor_drum_def_preset(&usual, DEFAULT_PRESET, NULL) == TABOR_OK ? 0 : 1;
}

static int close_world(void **state) {
  (void)state;
  lilv_world_free(world);
  return 0;
}

static const LilvPlugin *find_plugin(const char *text) {
  LilvNode *const node = uri(text);
  const LilvPlugin *const plugin = lilv_plugins_get_by_uri(lilv_world_get_all_plugins(world), node);
  lilv_node_free(node);
  assert_non_null(plugin);
  return plugin;
}

static uint32_t count_values(const LilvPlugin *plugin, const char *predicate) {
  LilvNode *const node = uri(predicate);
  LilvNodes *const values = lilv_plugin_get_value(plugin, node);
  const uint32_t count = lilv_nodes_size(values);
  lilv_nodes_free(values);
  lilv_node_free(node);
  return count;
}

static bool port_is(const LilvPlugin *plugin, const LilvPort *port, const char *class) {
  LilvNode *const node = uri(class);
  const bool is_one = lilv_port_is_a(plugin, port, node);
  lilv_node_free(node);
  return is_one;
}

static bool port_has(const LilvPlugin *plugin, const LilvPort *port, const char *property) {
  LilvNode *const node = uri(property);
  const bool has = lilv_port_has_property(plugin, port, node);
  lilv_node_free(node);
  return has;
}

/* ---- the plugins ---------------------------------------------------------------------------- */

static const InstrumentKind *kind_of(size_t plugin) {
  return &instrument_kinds[lv2_plugin_find(plugin_uris[plugin])->kind];
}

/* Port number `number` of plugin_uris[plugin]. */
static Port binary_port(size_t plugin, uint32_t number) { return port_at(kind_of(plugin), number); }

static uint32_t port_count(size_t plugin) {
  uint32_t count = 0;
  while (binary_port(plugin, count).kind != PORT_NONE) count++;
  return count;
}

/* As many ports are described as have an index of their own: lilv keeps one of each index. */
static void test_ports_are_those_of_the_binary(void **state) {
  (void)state;
  for (size_t i = 0; i < PLUGINS; i++) {
    const LilvPlugin *const plugin = find_plugin(plugin_uris[i]);
    const uint32_t count = port_count(i);
    assert_int_equal(lilv_plugin_get_num_ports(plugin), count);
    assert_int_equal(count_values(plugin, LV2_CORE__port), count);
    assert_true(lilv_plugin_verify(plugin));
    const char *const binary =
      lilv_file_uri_parse(lilv_node_as_uri(lilv_plugin_get_library_uri(plugin)), NULL);
    const LV2_Descriptor *const descriptor = host_descriptor(binary, plugin_uris[i]);
    assert_non_null(descriptor->extension_data(LV2_STATE__interface));
    assert_non_null(descriptor->extension_data(LV2_WORKER__interface));
    assert_int_equal(count_values(plugin, LV2_CORE__extensionData), 2);
    assert_null(descriptor->extension_data("urn:tabor:nothing"));
    lilv_free((void *)binary);
  }
}

static void check_symbol(const LilvPlugin *plugin, uint32_t index) {
  const char *const symbol =
    lilv_node_as_string(lilv_port_get_symbol(plugin, lilv_plugin_get_port_by_index(plugin, index)));
  assert_int_equal(strspn(symbol, "abcdefghijklmnopqrstuvwxyz_12345678"), strlen(symbol));
  assert_null(strchr("12345678", symbol[0]));
  for (uint32_t other = 0; other < index; other++) {
    const LilvPort *const port = lilv_plugin_get_port_by_index(plugin, other);
    assert_string_not_equal(lilv_node_as_string(lilv_port_get_symbol(plugin, port)), symbol);
  }
}

static void test_symbols_are_unique(void **state) {
  (void)state;
  for (size_t i = 0; i < PLUGINS; i++) {
    const LilvPlugin *const plugin = find_plugin(plugin_uris[i]);
    for (uint32_t index = 0; index < port_count(i); index++) check_symbol(plugin, index);
  }
}

static void check_symbols(const char *plugin_uri, const char *const *symbols, uint32_t count) {
  const LilvPlugin *const plugin = find_plugin(plugin_uri);
  for (uint32_t i = 0; i < count; i++) {
    const LilvPort *const port = lilv_plugin_get_port_by_index(plugin, i);
    assert_string_equal(lilv_node_as_string(lilv_port_get_symbol(plugin, port)), symbols[i]);
  }
  assert_int_equal(lilv_plugin_get_num_ports(plugin), count);
}

#  define SHARED_KNOBS                                                                             \
    "batter_tension", "resonant_tension", "batter_muffle_strength", "resonant_muffle_strength",    \
      "wires_strainer", "wires_tension", "striker_contact_stiffness", "strike_radius",             \
      "strike_angle", "velocity_curve", "humanize", "quality_level", "gain"

/* Symbols for ever: sessions of users name them. New ones go to the end. */
static void test_symbols_do_not_change(void **state) {
  (void)state;
  static const char *const stereo[] = {
    "events",     "out_left",         "out_right",    "freewheel",    "ready",
    SHARED_KNOBS, "level_pair",       "level_top",    "level_bottom", "level_near",
    "level_far",  "velocity_range",   "level_inside", "batter_pitch", "resonant_pitch",
    "room",       "wires_unevenness", "stick",        "drum"};
  static const char *const multi[] = {
    "events",         "out_top",    "out_bottom",   "out_near",       "out_far",
    "out_left",       "out_right",  "freewheel",    "ready",          SHARED_KNOBS,
    "velocity_range", "out_inside", "batter_pitch", "resonant_pitch", "wires_unevenness",
    "stick",          "drum"};
  static const char *const kit[] = {"events",      "out_left",   "out_right",      "out_1_left",
                                    "out_1_right", "out_2_left", "out_2_right",    "out_3_left",
                                    "out_3_right", "out_4_left", "out_4_right",    "out_5_left",
                                    "out_5_right", "out_6_left", "out_6_right",    "out_7_left",
                                    "out_7_right", "out_8_left", "out_8_right",    "freewheel",
                                    "ready",       "kit",        "quality",        "room",
                                    "coupling",    "overheads",  "velocity_curve", "velocity_range",
                                    "notes",       "gain",       "level_1",        "level_2",
                                    "level_3",     "level_4",    "level_5",        "level_6",
                                    "level_7",     "level_8",    "tune_1",         "tune_2",
                                    "tune_3",      "tune_4",     "tune_5",         "tune_6",
                                    "tune_7",      "tune_8",     "humanize"};
  check_symbols(URI_DRUM, stereo, sizeof stereo / sizeof stereo[0]);
  check_symbols(URI_DRUM_MULTI, multi, sizeof multi / sizeof multi[0]);
  static const char *const effect[] = {"events",
                                       "in_left",
                                       "in_right",
                                       "out_left",
                                       "out_right",
                                       "freewheel",
                                       "ready",
                                       SHARED_KNOBS,
                                       "level_pair",
                                       "level_top",
                                       "level_bottom",
                                       "level_near",
                                       "level_far",
                                       "velocity_range",
                                       "level_inside",
                                       "batter_pitch",
                                       "resonant_pitch",
                                       "room",
                                       "wires_unevenness",
                                       "sound_level",
                                       "mix",
                                       "stick",
                                       "enabled",
                                       "drum"};
  check_symbols(URI_EFFECT, effect, sizeof effect / sizeof effect[0]);
  check_symbols(URI_KIT, kit, sizeof kit / sizeof kit[0]);
}

static void check_comment(const LilvPlugin *plugin, const LilvPort *port) {
  LilvNode *const predicate = uri("http://www.w3.org/2000/01/rdf-schema#comment");
  LilvNode *const comment = lilv_port_get(plugin, port, predicate);
  assert_non_null(comment);
  assert_true(strlen(lilv_node_as_string(comment)) > 10);
  lilv_node_free(comment);
  lilv_node_free(predicate);
}

static void check_range(const LilvPlugin *plugin, const LilvPort *port, const KnobRange *range) {
  LilvNode *fallback, *minimum, *maximum;
  assert_true(port_is(plugin, port, LV2_CORE__InputPort));
  assert_true(port_is(plugin, port, LV2_CORE__ControlPort));
  lilv_port_get_range(plugin, port, &fallback, &minimum, &maximum);
  assert_true(lilv_node_is_float(fallback) && lilv_node_is_float(minimum) &&
              lilv_node_is_float(maximum));
  assert_true(lilv_node_as_float(fallback) == range->fallback);
  assert_true(lilv_node_as_float(minimum) == port_minimum(range));
  assert_true(lilv_node_as_float(maximum) == range->maximum);
  assert_true(range->minimum <= range->fallback && range->fallback <= range->maximum);
  assert_true(range->minimum < range->maximum);
  lilv_node_free(fallback);
  lilv_node_free(minimum);
  lilv_node_free(maximum);
}

/* The value of a scale point by its name; a NaN if there is none. */
static float point_of(const LilvPlugin *plugin, const LilvPort *port, const char *label) {
  LilvScalePoints *const points = lilv_port_get_scale_points(plugin, port);
  float value = NAN;
  LILV_FOREACH(scale_points, at, points) {
    const LilvScalePoint *const point = lilv_scale_points_get(points, at);
    if (strcmp(lilv_node_as_string(lilv_scale_point_get_label(point)), label) == 0) {
      value = lilv_node_as_float(lilv_scale_point_get_value(point));
    }
  }
  lilv_scale_points_free(points);
  return value;
}

static void check_knob(const LilvPlugin *plugin, const LilvPort *port, const Knob *knob,
                       const KnobRange *range) {
  const bool is_built = knob->kind == KNOB_REBUILD || knob->kind == KNOB_REPLACE;
  assert_string_equal(lilv_node_as_string(lilv_port_get_symbol(plugin, port)), knob->symbol);
  LilvNode *const name = lilv_port_get_name(plugin, port);
  assert_string_equal(lilv_node_as_string(name), knob->name);
  lilv_node_free(name);
  check_range(plugin, port, range);
  const bool ratios = port_has(plugin, port, "http://lv2plug.in/ns/ext/port-props#logarithmic");
  assert_int_equal(ratios, knob_is_bent(range));
  if (ratios) assert_true(port_minimum(range) > 0);
  assert_int_equal(port_has(plugin, port, LV2_CORE__enumeration), knob->choices != NULL);
  assert_int_equal(port_has(plugin, port, "http://lv2plug.in/ns/ext/port-props#expensive"),
                   is_built || knob->is_costly);
  if (!isnan(knob->off)) {
    assert_true(point_of(plugin, port, knob_off_word(knob)) ==
                fmaxf((float)knob->off, port_minimum(range)));
  }
  if (knob->top_word) assert_true(point_of(plugin, port, knob->top_word) == range->maximum);
  check_comment(plugin, port);
}

/* The engine allows whatever a knob can be turned to. */
static void check_key(KnobId id) {
  const KnobRange range = knob_range(id, &usual);
  const TaborParameter *const parameter = tabor_parameter_find(knobs[id].key);
  assert_non_null(parameter);
  assert_true((double)range.minimum >= (double)(float)parameter->minimum);
  assert_true((double)range.maximum <= (double)(float)parameter->maximum);
  assert_int_equal(knobs[id].kind == KNOB_LIVE, parameter->live);
  const double shown = knob_shown(&usual, id); /* the table has the pitches as numbers */
  if ((float)shown != range.fallback) fail_msg("%s: %.6g", knobs[id].symbol, shown);
}

static void test_knobs(void **state) {
  (void)state;
  for (size_t i = 0; i < PLUGINS; i++) {
    const LilvPlugin *const plugin = find_plugin(plugin_uris[i]);
    Instrument *const instrument = instrument_create(kind_of(i));
    Port port;
    for (uint32_t index = 0; (port = binary_port(i, index)).kind != PORT_NONE; index++) {
      if (port.kind != PORT_KNOB) continue;
      check_knob(plugin, lilv_plugin_get_port_by_index(plugin, index),
                 &instrument->kind->knobs[port.index], &instrument->ranges[port.index]);
      if (instrument->kind->knobs[port.index].key) check_key((KnobId)port.index);
    }
    instrument_destroy(instrument);
  }
}

/* Numbers for ever: sessions of users have them, and programs of MIDI. They are the engine's drums.
 */
static void test_choices_of_the_drum_do_not_change(void **state) {
  (void)state;
  static const char *const drums[] = {"tabor",
                                      "frame-drum",
                                      "bodhran-piano-string",
                                      "bodhran-d-string",
                                      "bodhran-d-string-tensioned",
                                      "snare-14x5.5",
                                      "snare-14x5.5-off",
                                      "snare-14x6.5-loose",
                                      "piccolo-13x3.5",
                                      "marching-14x12",
                                      "tom-12",
                                      "floor-tom-16",
                                      "bass-drum-22",
                                      "timpani-26",
                                      "snare-14x8",
                                      "snare-14x5-steel",
                                      "tom-10",
                                      "bass-drum-18"};
  const uint32_t count = sizeof drums / sizeof drums[0];
  const KnobRange range = knob_range(KNOB_DRUM, &usual);
  char word[64];
  assert_true(tabor_preset_count() >= count);
  assert_true(range.maximum == (float)tabor_preset_count() - 1);
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    (void)knob_label(&knobs[KNOB_DRUM], &range, i, word, sizeof word);
    assert_string_equal(word, tabor_preset(i)->name);
    if (i < count) assert_string_equal(word, drums[i]);
  }
  assert_string_equal(tabor_preset((uint32_t)range.fallback)->name, DEFAULT_PRESET);
}

static void check_point(const LilvPlugin *plugin, KitKnobId id, const char *label, float value) {
  LilvNode *const symbol = lilv_new_string(world, kit_knobs[id].symbol);
  const LilvPort *const port = lilv_plugin_get_port_by_symbol(plugin, symbol);
  if (point_of(plugin, port, label) != value) fail_msg("'%s' is another value", label);
  lilv_node_free(symbol);
}

/* Numbers for ever: sessions of users have them. They are the engine's kits, and the maps. */
static void test_choices_of_the_kit_do_not_change(void **state) {
  (void)state;
  static const char *const kits[] = {"standard", "jazz", "marching", "frame-drums"};
  static const char *const maps[] = {"General MIDI", "roland",   "yamaha",
                                     "alesis",       "superior", "addictive"};
  const LilvPlugin *const plugin = find_plugin(URI_KIT);
  for (uint32_t i = 0; i < sizeof kits / sizeof kits[0]; i++) {
    check_point(plugin, KIT_KNOB_KIT, kits[i], (float)i);
    assert_string_equal(tabor_kit(i)->name, kits[i]);
  }
  for (uint32_t i = 0; i < sizeof maps / sizeof maps[0]; i++) {
    check_point(plugin, KIT_KNOB_NOTES, maps[i], (float)i);
    if (i > 0) assert_string_equal(kit_maps[i - 1].name, maps[i]);
  }
}

/* A port of the class `direction`. */
static void check_designation(size_t number, const char *direction, const char *designation,
                              PortKind kind) {
  LilvNode *const node = uri(designation), *const class = uri(direction);
  const LilvPlugin *const plugin = find_plugin(plugin_uris[number]);
  const LilvPort *const port = lilv_plugin_get_port_by_designation(plugin, class, node);
  assert_non_null(port);
  assert_int_equal(binary_port(number, lilv_port_get_index(plugin, port)).kind, kind);
  lilv_node_free(class);
  lilv_node_free(node);
}

static bool is_instrument(const LilvPlugin *plugin) {
  LilvNode *const type = uri("http://www.w3.org/1999/02/22-rdf-syntax-ns#type");
  LilvNode *const instrument = uri(LV2_CORE__InstrumentPlugin);
  LilvNodes *const types = lilv_plugin_get_value(plugin, type);
  const bool is_one = lilv_nodes_contains(types, instrument);
  lilv_nodes_free(types);
  lilv_node_free(instrument);
  lilv_node_free(type);
  return is_one;
}

static void test_what_hosts_look_for(void **state) {
  (void)state;
  for (size_t i = 0; i < PLUGINS; i++) {
    const LilvPlugin *const plugin = find_plugin(plugin_uris[i]);
    LilvNodes *const required = lilv_plugin_get_required_features(plugin);
    assert_int_equal(lilv_nodes_size(required), 1);
    assert_string_equal(lilv_node_as_uri(lilv_nodes_get_first(required)), LV2_URID__map);
    lilv_nodes_free(required);
    LilvNode *const hard = uri(LV2_CORE__hardRTCapable);
    assert_true(lilv_plugin_has_feature(plugin, hard));
    lilv_node_free(hard);
    assert_false(lilv_plugin_has_latency(plugin));
    const bool is_effect = strcmp(plugin_uris[i], URI_EFFECT) == 0;
    check_designation(i, LV2_CORE__InputPort, LV2_CORE__freeWheeling, PORT_FREEWHEEL);
    check_designation(i, LV2_CORE__InputPort, LV2_CORE__control, PORT_EVENTS);
    check_designation(i, LV2_CORE__OutputPort, LV2_PORT_GROUPS__left, PORT_OUTPUT);
    check_designation(i, LV2_CORE__OutputPort, LV2_PORT_GROUPS__right, PORT_OUTPUT);
    if (is_effect) check_designation(i, LV2_CORE__InputPort, LV2_PORT_GROUPS__left, PORT_INPUT);
    if (is_effect) check_designation(i, LV2_CORE__InputPort, LV2_PORT_GROUPS__right, PORT_INPUT);
    assert_int_equal(is_instrument(plugin), !is_effect);
  }
}

/* ---- presets -------------------------------------------------------------------------------- */

static void set_knob(const char *symbol, void *context, const void *value, uint32_t size,
                     uint32_t type) {
  PluginHost *const host = context;
  assert_int_equal(size, sizeof(float));
  assert_int_equal(type, host_map(LV2_ATOM__Float));
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    const KnobRange range = knob_range((KnobId)i, &usual);
    if (strcmp(knobs[i].symbol, symbol) != 0) continue;
    memcpy(&host->knobs[i], value, size);
    if (!(host->knobs[i] >= port_minimum(&range) && host->knobs[i] <= range.maximum)) {
      fail_msg("a preset sets %s = %g", symbol, (double)host->knobs[i]);
    }
    return;
  }
  fail_msg("a preset sets '%s', which is no knob", symbol);
}

/* What the plugin saves with the preset and its knobs is the built-in preset. */
static void check_definition(PluginHost *host, const char *name) {
  TaborDrumDef def;
  HostState saved;
  assert_int_equal(tabor_drum_def_preset(&def, name, NULL), TABOR_OK);
  host->freewheel = 1;
  host->knobs[KNOB_QUALITY] = 0;
  host_run(host, 64);
  host_run(host, 64);
  host_save(host, &saved);
  char *const expected = definition_write(&def, TABOR_TEXT_KEEP, NULL, NULL);
  const char *const text = host_property(&saved, URI_STATE_DEFINITION)->value;
  size_t same = 0;
  while (text[same] && text[same] == expected[same]) same++;
  if (text[same] != expected[same]) {
    fail_msg("%s: not '%.60s' but '%.60s'", name, expected + same, text + same);
  }
  free(expected);
  host_state_free(&saved);
}

static void check_preset(const LilvPlugin *plugin, LilvState *preset, uint64_t *seen) {
  const char *const binary =
    lilv_file_uri_parse(lilv_node_as_uri(lilv_plugin_get_library_uri(plugin)), NULL);
  PluginHost *const host = host_open(
    host_descriptor(binary, lilv_node_as_uri(lilv_plugin_get_uri(plugin))), HOST_WITHOUT_WORKER);
  LilvInstance instance = {host->descriptor, host->handle, NULL};
  const char *const name = lilv_state_get_label(preset);
  lilv_state_restore(preset, &instance, set_knob, host, 0, NULL);
  assert_string_equal(host->said, "");
  check_definition(host, name);
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    if (strcmp(tabor_preset(i)->name, name) == 0) *seen |= UINT64_C(1) << i;
  }
  host_close(host);
  lilv_free((void *)binary);
}

static void test_presets_are_the_built_in_ones(void **state) {
  (void)state;
  LilvNode *const class = uri(LV2_PRESETS__Preset);
  LV2_URID_Map urids = {NULL, host_map_feature};
  for (size_t i = 0; i < PLUGINS; i++) {
    const LilvPlugin *const plugin = find_plugin(plugin_uris[i]);
    LilvNodes *const presets = lilv_plugin_get_related(plugin, class);
    uint64_t seen = 0;
    assert_int_equal(lilv_nodes_size(presets), i < DRUMS ? tabor_preset_count() : 0);
    LILV_FOREACH(nodes, at, presets) {
      const LilvNode *const node = lilv_nodes_get(presets, at);
      assert_true(lilv_world_load_resource(world, node) >= 0);
      LilvState *const preset = lilv_state_new_from_world(world, &urids, node);
      assert_non_null(preset);
      check_preset(plugin, preset, &seen);
      lilv_state_free(preset);
    }
    assert_int_equal(seen, i < DRUMS ? (UINT64_C(1) << tabor_preset_count()) - 1 : 0);
    lilv_nodes_free(presets);
  }
  lilv_node_free(class);
}

int main(int argc, char **argv) {
  if (argc < 2) return 1;
  bundle = argv[1];
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_ports_are_those_of_the_binary),
    cmocka_unit_test(test_symbols_are_unique),
    cmocka_unit_test(test_symbols_do_not_change),
    cmocka_unit_test(test_knobs),
    cmocka_unit_test(test_choices_of_the_drum_do_not_change),
    cmocka_unit_test(test_choices_of_the_kit_do_not_change),
    cmocka_unit_test(test_what_hosts_look_for),
    cmocka_unit_test(test_presets_are_the_built_in_ones),
  };
  return cmocka_run_group_tests(tests, open_world, close_world);
}

#else

int main(void) {
  puts("SKIPPED: needs liblilv-dev");
  return 77;
}

#endif
