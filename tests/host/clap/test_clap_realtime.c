/* SPDX-License-Identifier: MIT */
/*
 * Random playing of the CLAP plugins, with parameters, modulation, program changes, note
 * expressions and states that are loaded meanwhile: blocks allocate nothing, lock nothing, sleep
 * nowhere and touch no file, and leave the processor's floating-point mode as the host has set it.
 *
 * test_clap_realtime [SECONDS of sound [CHANGES of the model, at least]]
 */
#include "clap_host.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <cmocka.h>

#include "counted_calls.h"
#include "float_mode.h"
#include "midi_writer.h"
#include "plugin/model_cache.h"

extern const clap_plugin_entry_t clap_entry;

static double seconds = 4;
static uint32_t least_changes = 5;

static double random_part(uint64_t *random) {
  return (double)(midi_random(random) >> 11) * 0x1p-53;
}

static bool is_ready(const ClapHost *host) {
  const Instrument *const instrument = instrument_of(host->plugin);
  return instrument->kind->calls->is_ready(instrument);
}

static void counted_run(ClapHost *host, uint32_t frames) {
  float_mode_set();
  count_calls_begin();
  clap_host_run(host, frames);
  const long calls = count_calls_end();
  float_mode_check();
  float_mode_reset();
  if (calls > 0) fail_msg("%ld calls", calls);
  uint32_t channels = 0;
  for (uint32_t i = 0; i < host->port_count; i++) channels += host->widths[i];
  for (uint32_t i = 0; i < channels; i++) {
    for (uint32_t at = 0; at < frames; at++) assert_true(isfinite(host->sound[i][at]));
  }
}

static void send_controller(ClapHost *host, uint32_t at, uint64_t *random) {
  static const uint8_t controllers[] = {1, 7, 11, 16, 17, 20, 88};
  const uint8_t which = controllers[midi_random(random) % 7];
  clap_host_midi(host, at, &(MidiMessage){0xB9, {which, (uint8_t)(midi_random(random) % 128)}});
}

static void send_one(ClapHost *host, uint32_t at, uint64_t *random) {
  static const KnobId knobs_moved[] = {KNOB_STRAINER, KNOB_BATTER_MUFFLING, KNOB_GAIN};
  const double dice = random_part(random), value = random_part(random);
  const int16_t key = (int16_t)(36 + midi_random(random) % 14);
  if (dice < 0.4) {
    clap_host_note(host, at, CLAP_EVENT_NOTE_ON, key, value);
  } else if (dice < 0.5) {
    clap_host_note(host, at, CLAP_EVENT_NOTE_OFF, key, value);
  } else if (dice < 0.6) {
    clap_host_express(host, at, CLAP_NOTE_EXPRESSION_BRIGHTNESS, key, value);
  } else if (dice < 0.7) {
    clap_host_express(host, at, CLAP_NOTE_EXPRESSION_PRESSURE, key, value);
  } else if (dice < 0.8) {
    send_controller(host, at, random);
  } else if (dice < 0.9) {
    clap_host_set(host, at, KNOB_STRAINER, value);
  } else if (dice < 0.98) {
    clap_host_modulate(host, at, knobs_moved[midi_random(random) % 3], value);
  } else {
    clap_host_note(host, at, CLAP_EVENT_NOTE_CHOKE, -1, 0);
  }
}

/* What takes another model, now and then. */
static void change_model(ClapHost *host, uint64_t *random) {
  static ClapState state;
  const double dice = random_part(random);
  if (dice < 0.4) {
    clap_host_set(host, 0, KNOB_BATTER_TENSION, 0.6 + 0.2 * random_part(random));
  } else if (dice < 0.9) {
    clap_host_midi(host, 0, &(MidiMessage){0xC9, {midi_random(random) % 2, 0}});
  } else {
    clap_host_save(host, &state);
    assert_true(clap_host_load(host, &state));
  }
}

static ClapHost *open_plugin(const char *id) {
  ClapHost *const host = clap_host_open(&clap_entry, id);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_flush(host);
  clap_host_activate(host);
  return host;
}

static void play_random(const char *id, uint64_t random) {
  const struct timespec moment = {.tv_nsec = 1000000};
  const uint64_t least = (uint64_t)(48000 * seconds);
  uint32_t changes = 0;
  bool was_ready = true;
  ClapHost *const host = open_plugin(id);
  for (uint64_t position = 0; position < least || changes < least_changes;) {
    const uint32_t frames = (uint32_t)(midi_random(&random) % 1500);
    if (is_ready(host) && random_part(&random) < 0.1) change_model(host, &random);
    for (uint32_t at = 0; at < frames; at += (uint32_t)(midi_random(&random) % 2000)) {
      send_one(host, at, &random);
    }
    counted_run(host, frames);
    position += frames;
    changes += !was_ready && is_ready(host);
    was_ready = is_ready(host);
    if (!was_ready) (void)nanosleep(&moment, NULL); /* sound must not be over before it is built */
  }
  printf("%.0f s, %u changes of the model\n", seconds, (unsigned)changes);
  clap_host_close(host);
  assert_int_equal(model_cache_count(), 0);
}

static void blocks_call_nothing_that_waits(void **state) {
  (void)state;
  play_random(ID_DRUM, 1);
}

static void nor_those_with_an_output_per_microphone(void **state) {
  (void)state;
  play_random(ID_DRUM_MULTI, 2);
}

/* Now and then another kit, room or tuning; levels and notes all the time. */
static void send_to_kit(ClapHost *host, uint64_t *random, bool change) {
  static const KitKnobId rebuilt[] = {KIT_KNOB_KIT, KIT_KNOB_ROOM, KIT_KNOB_TUNE};
  const double value = random_part(random);
  if (change) clap_host_set_id(host, 0, rebuilt[midi_random(random) % 3], 3 * value);
  clap_host_set_id(host, 0, KIT_KNOB_LEVEL + (clap_id)(midi_random(random) % 8), -20 * value);
  clap_host_note(host, 0, CLAP_EVENT_NOTE_ON, (int16_t)(35 + midi_random(random) % 16), value);
  send_controller(host, 0, random);
  if (value > 0.95) clap_host_note(host, 0, CLAP_EVENT_NOTE_CHOKE, 38, 0);
}

static void nor_those_of_a_kit(void **state) {
  (void)state;
  const struct timespec moment = {.tv_nsec = 1000000};
  uint64_t random = 3;
  uint32_t changes = 0;
  ClapHost *const host = clap_host_open(&clap_entry, ID_KIT);
  clap_host_set_id(host, 0, KIT_KNOB_QUALITY, 0);
  clap_host_flush(host);
  clap_host_activate(host);
  for (uint64_t position = 0; position < (uint64_t)(48000 * seconds) || changes < least_changes;) {
    const bool change = is_ready(host) && random_part(&random) < 0.1;
    const uint32_t frames = (uint32_t)(midi_random(&random) % 1500);
    send_to_kit(host, &random, change);
    counted_run(host, frames);
    position += frames;
    changes += change;
    if (!is_ready(host)) (void)nanosleep(&moment, NULL);
  }
  clap_host_close(host);
  assert_int_equal(model_cache_count(), 0);
}

int main(int argc, char **argv) {
  if (argc > 1) seconds = atof(argv[1]);
  if (argc > 2) least_changes = (uint32_t)atoi(argv[2]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_counters_count),
    cmocka_unit_test(blocks_call_nothing_that_waits),
    cmocka_unit_test(nor_those_with_an_output_per_microphone),
    cmocka_unit_test(nor_those_of_a_kit),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
