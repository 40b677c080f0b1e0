/* SPDX-License-Identifier: MIT */
/*
 * What a careless host may do: malformed MIDI and atoms, knobs that are no numbers, runs of no
 * frames, ports that are not connected. The sound stays finite, and afterwards the instance is as
 * good as new.
 *
 * test_lv2_robust PLUGINS
 */
#include "plugin_host.h"

#include <lv2/midi/midi.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lv2/uris.h"

#define FRAMES 4800u

static const char *plugins;
static const char *const plugin_uris[] = {URI_DRUM, URI_DRUM_MULTI};

static PluginHost *open_plugin(const char *uri) {
  PluginHost *const host = host_open(host_descriptor(plugins, uri), HOST_WITHOUT_WORKER);
  host->knobs[KNOB_QUALITY] = 0;
  host->freewheel = 1;
  host_run(host, 16);
  return host;
}

static void check_sound(const PluginHost *host, uint32_t frames) {
  for (uint32_t i = 0; i < host->outputs; i++) {
    for (uint32_t at = 0; at < frames; at++) assert_true(isfinite(host->sound[i][at]));
  }
}

static void run_checked(PluginHost *host, uint32_t frames) {
  host_run(host, frames);
  check_sound(host, frames);
}

/* With the state of @p fresh, after a new beginning, a stroke sounds as there. */
static void as_good_as_new(PluginHost *host, PluginHost *fresh) {
  HostState state;
  host_save(fresh, &state);
  assert_int_equal(host_restore(host, &state), LV2_STATE_SUCCESS);
  host_state_free(&state);
  memcpy(host->knobs, fresh->knobs, sizeof host->knobs);
  host_run(host, 16);
  PluginHost *const both[] = {host, fresh};
  for (int i = 0; i < 2; i++) {
    both[i]->descriptor->activate(both[i]->handle);
    host_note(both[i], 7, 38, 90);
    host_run(both[i], FRAMES);
  }
  for (uint32_t i = 0; i < host->outputs; i++) {
    assert_true(memcmp(host->sound[i], fresh->sound[i], FRAMES * sizeof(float)) == 0);
    assert_true(host_peak(host->sound[i], FRAMES) > 1e-5);
  }
}

static void on_both(void (*torture)(PluginHost *)) {
  for (int i = 0; i < 2; i++) {
    PluginHost *const host = open_plugin(plugin_uris[i]), *const fresh =
                                                            open_plugin(plugin_uris[i]);
    torture(host);
    as_good_as_new(host, fresh);
    host_close(host);
    host_close(fresh);
  }
}

/* ---- MIDI ----------------------------------------------------------------------------------- */

static void send_noise(PluginHost *host) {
  uint64_t random = 3;
  for (int run = 0; run < 60; run++) {
    const uint32_t frames = (uint32_t)(200 * host_random(&random));
    for (int i = 0; i < 20; i++) {
      uint8_t bytes[12];
      const uint32_t size = (uint32_t)(sizeof bytes * host_random(&random));
      for (uint32_t k = 0; k < size; k++) bytes[k] = (uint8_t)(256 * host_random(&random));
      host_event(host, (int64_t)(600 * host_random(&random)) - 200, size, bytes);
    }
    run_checked(host, frames);
  }
}

static void test_any_bytes_at_any_time(void **state) {
  (void)state;
  on_both(send_noise);
}

static void send_exclusive(PluginHost *host) {
  static uint8_t exclusive[20000];
  memset(exclusive, 0x7D, sizeof exclusive);
  exclusive[0] = 0xF0;
  host_event(host, 0, sizeof exclusive, exclusive);
  run_checked(host, 64);
  assert_true(host_peak(host->sound[0], 64) == 0);
  for (int i = 0; i < 2000; i++) host_note(host, 0, 38, 127);
  run_checked(host, 64);
}

static void test_far_too_much(void **state) {
  (void)state;
  on_both(send_exclusive);
}

/* ---- atoms ---------------------------------------------------------------------------------- */

static void damage_events(PluginHost *host) {
  uint64_t random = 5;
  LV2_Atom_Sequence *const sequence = &host->events.sequence;
  for (int run = 0; run < 300; run++) {
    for (int i = 0; i < 5; i++) host_event(host, 3 * i, 3, (const uint8_t[]){0xB9, 16, 60});
    const uint32_t size = (uint32_t)(sizeof(LV2_Atom) + sequence->atom.size);
    uint8_t *const bytes = (uint8_t *)host->events.room;
    for (int i = 0; i < 3; i++) { /* behind the sequence's own size, which hosts know */
      bytes[4 + (uint32_t)((size - 4) * host_random(&random))] =
        (uint8_t)(256 * host_random(&random));
    }
    if (run % 3 == 0) sequence->atom.size = (uint32_t)(sequence->atom.size * host_random(&random));
    run_checked(host, 16);
  }
}

static void test_damaged_sequences(void **state) {
  (void)state;
  on_both(damage_events);
}

static void send_others(PluginHost *host) {
  LV2_Atom_Sequence *const sequence = &host->events.sequence;
  host_note(host, 0, 38, 127);
  sequence->atom.type = host_map(LV2_ATOM__Chunk); /* what stands in a buffer that is for output */
  run_checked(host, 64);
  assert_true(host_peak(host->sound[0], 64) == 0);
  host_note(host, 0, 38, 127);
  ((LV2_Atom_Event *)(sequence + 1))->body.type = host_map(LV2_ATOM__String);
  run_checked(host, 64);
  assert_true(host_peak(host->sound[0], 64) == 0);
  host_note(host, 0, 38, 127);
  ((LV2_Atom_Event *)(sequence + 1))->body.size = UINT32_MAX;
  run_checked(host, 64);
  assert_true(host_peak(host->sound[0], 64) == 0);
}

static void test_atoms_of_other_kinds(void **state) {
  (void)state;
  on_both(send_others);
}

/* ---- knobs, frames, ports ------------------------------------------------------------------- */

static void turn_wildly(PluginHost *host) {
  static const float values[] = {NAN, INFINITY, -INFINITY, 1e30f, -1e30f, 0, -0.0f, 1e-40f};
  uint64_t random = 9;
  for (int run = 0; run < 40; run++) {
    for (uint32_t i = 0; i < KNOB_COUNT; i++) {
      if (knobs[i].kind == KNOB_REBUILD || i == KNOB_QUALITY) continue; /* below */
      host->knobs[i] = values[(uint32_t)(8 * host_random(&random))];
    }
    host_note(host, 0, 38, 127);
    run_checked(host, 100);
  }
  const KnobId heavy[] = {KNOB_BATTER_TENSION, KNOB_RESONANT_TENSION, KNOB_STICK_HARDNESS};
  for (size_t i = 0; i < sizeof heavy / sizeof heavy[0]; i++) {
    const float before = host->knobs[heavy[i]];
    host->knobs[heavy[i]] = i == 0 ? NAN : 1e30f;
    host_note(host, 0, 38, 127);
    run_checked(host, 100);
    host->knobs[heavy[i]] = before;
  }
  host->knobs[KNOB_QUALITY] = -INFINITY; /* which is no number: it stays at draft */
  run_checked(host, 100);
}

static void test_knobs_that_are_no_numbers(void **state) {
  (void)state;
  on_both(turn_wildly);
}

/* Knobs that have never been numbers stand at their defaults. */
static void test_knobs_that_are_no_numbers_from_the_start(void **state) {
  (void)state;
  for (int i = 0; i < 2; i++) {
    const LV2_Descriptor *const plugin = host_descriptor(plugins, plugin_uris[i]);
    PluginHost *const host = host_open(plugin, HOST_WITHOUT_WORKER);
    PluginHost *const usual = host_open(plugin, HOST_WITHOUT_WORKER);
    PluginHost *const both[] = {host, usual};
    for (uint32_t knob = 0; knob < KNOB_COUNT; knob++) host->knobs[knob] = NAN;
    usual->knobs[KNOB_ROOM] = TABOR_ROOM_STUDIO;
    usual->knobs[KNOB_LEVEL_PAIR] = 12;
    for (int k = 0; k < 2; k++) {
      both[k]->freewheel = 1;
      host_note(both[k], 0, 38, 100);
      host_run(both[k], FRAMES);
    }
    for (uint32_t output = 0; output < host->outputs; output++) {
      assert_true(host_peak(usual->sound[output], FRAMES) > 1e-5);
      assert_memory_equal(host->sound[output], usual->sound[output], FRAMES * sizeof(float));
    }
    host_close(host);
    host_close(usual);
  }
}

static void run_nothing(PluginHost *host) {
  for (int i = 0; i < 100; i++) {
    host_event(host, 0, 3, (const uint8_t[]){0xB9, 16, 20});
    host_run(host, 0);
  }
}

static void test_runs_of_no_frames(void **state) {
  (void)state;
  on_both(run_nothing);
}

/* A note in a run without frames is heard in the next. */
static void test_a_note_in_a_run_without_frames(void **state) {
  (void)state;
  PluginHost *const host = open_plugin(URI_DRUM), *const other = open_plugin(URI_DRUM);
  host_note(host, 0, 38, 100);
  host_run(host, 0);
  host_note(other, 0, 38, 100);
  host_run(host, FRAMES);
  host_run(other, FRAMES);
  assert_true(memcmp(host->sound[0], other->sound[0], FRAMES * sizeof(float)) == 0);
  host_close(host);
  host_close(other);
}

/* All but one output of the plugin with an output per microphone, and whatever else is optional. */
static void test_optional_ports(void **state) {
  (void)state;
  enum { BOTTOM = 1 };
  PluginHost *const host = open_plugin(URI_DRUM_MULTI), *const all = open_plugin(URI_DRUM_MULTI);
  Port port;
  for (uint32_t i = 0; (port = host_port(host, i)).kind != PORT_NONE; i++) {
    const bool optional = port.kind == PORT_OUTPUT ? port.index != BOTTOM : port.kind != PORT_KNOB;
    if (optional && port.kind != PORT_EVENTS) {
      host->descriptor->connect_port(host->handle, i, NULL);
    }
  }
  host_note(host, 0, 38, 100);
  host_note(all, 0, 38, 100);
  host_run(host, FRAMES);
  host_run(all, FRAMES);
  assert_true(memcmp(host->sound[BOTTOM], all->sound[BOTTOM], FRAMES * sizeof(float)) == 0);
  assert_true(host_peak(host->sound[BOTTOM], FRAMES) > 1e-3);
  host_close(host);
  host_close(all);
}

/* Nothing at all. */
static void test_no_port_is_connected(void **state) {
  (void)state;
  for (int i = 0; i < 2; i++) {
    PluginHost *const host = open_plugin(plugin_uris[i]);
    for (uint32_t k = 0; k < 100; k++) {
      host->descriptor->connect_port(host->handle, k, NULL);
    }
    host_run(host, 64);
    host_close(host);
  }
}

int main(int argc, char **argv) {
  if (argc < 2) return 1;
  plugins = argv[1];
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_any_bytes_at_any_time),
    cmocka_unit_test(test_far_too_much),
    cmocka_unit_test(test_damaged_sequences),
    cmocka_unit_test(test_atoms_of_other_kinds),
    cmocka_unit_test(test_knobs_that_are_no_numbers),
    cmocka_unit_test(test_knobs_that_are_no_numbers_from_the_start),
    cmocka_unit_test(test_runs_of_no_frames),
    cmocka_unit_test(test_a_note_in_a_run_without_frames),
    cmocka_unit_test(test_optional_ports),
    cmocka_unit_test(test_no_port_is_connected),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
