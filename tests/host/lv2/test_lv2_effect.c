/* SPDX-License-Identifier: MIT */
/*
 * The LV2 plugin Tabor Rattle: the drum alone equals `tabor render --input` to the bit, whatever
 * the sizes of the runs are, also where the host uses the same buffers for input and output; at a
 * mix of 0 what comes in goes out. What it does with silence and bad samples is the same as in
 * CLAP: test_clap_effect.
 *
 * test_lv2_effect PROGRAM PLUGINS
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

#include "lv2/uris.h"
#include "sound_burst.h"

static const LV2_Descriptor *plugin;
static const char *program;

static PluginHost *open_effect(float mix) {
  PluginHost *const host = host_open(plugin, HOST_WITHOUT_WORKER);
  host->knobs[KNOB_QUALITY] = 0; /* draft */
  host->knobs[KNOB_LEVEL_PAIR] = 12;
  host->knobs[KNOB_LEVEL_BOTTOM] = -60;
  host->knobs[KNOB_MIX] = mix;
  host->freewheel = 1;
  return host;
}

/* In `place`, the outputs are the inputs' buffers. */
static void play_burst(PluginHost *host, uint32_t block, bool in_place, Take *take) {
  Port port;
  for (uint32_t i = 0; in_place && (port = host_port(host, i)).kind != PORT_NONE; i++) {
    if (port.kind == PORT_OUTPUT) plugin->connect_port(host->handle, i, host->input[port.index]);
  }
  float(*const out)[HOST_BLOCK] = in_place ? host->input : host->sound;
  for (uint32_t at = 0; at < take->frames; at += block) {
    const uint32_t run = block < take->frames - at ? block : take->frames - at;
    for (uint32_t i = 0; i < run; i++) {
      host->input[0][i] = host->input[1][i] = burst_at(at + i);
    }
    host_run(host, run);
    for (uint32_t side = 0; side < 2; side++) {
      memcpy(take->sound[side] + at, out[side], run * sizeof(float));
    }
  }
}

static void the_drum_is_that_of_render(void **state) {
  (void)state;
  static const uint32_t blocks[] = {HOST_BLOCK, 100, 1};
  Take expected, take;
  take_open(&expected, 2);
  take_open(&take, 2);
  burst_render(program, &expected);
  for (size_t i = 0; i < 2 * sizeof blocks / sizeof blocks[0]; i++) {
    PluginHost *const host = open_effect(1);
    play_burst(host, blocks[i / 2], i % 2, &take);
    take_compare(&expected, &take, blocks[i / 2]);
    host_close(host);
  }
  take_close(&expected);
  take_close(&take);
}

static void without_the_drum_what_comes_in_goes_out(void **state) {
  (void)state;
  Take take;
  take_open(&take, 2);
  PluginHost *const host = open_effect(0);
  play_burst(host, 480, false, &take);
  for (uint32_t i = 0; i < take.frames; i++) {
    const float in = burst_at(i);
    assert_true(take.sound[0][i] == in && take.sound[1][i] == in);
  }
  host_close(host);
  take_close(&take);
}

int main(int argc, char **argv) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_drum_is_that_of_render),
    cmocka_unit_test(without_the_drum_what_comes_in_goes_out),
  };
  if (argc != 3) return 2;
  program = argv[1];
  plugin = host_descriptor(argv[2], URI_EFFECT);
  burst_make();
  if (!songs_begin(program, true)) return 1;
  const int failed = cmocka_run_group_tests(tests, NULL, NULL);
  return songs_end() ? failed : 1;
}
