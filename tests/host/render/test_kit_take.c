/* SPDX-License-Identifier: MIT */
/* What a kit's sound costs is counted in processor time, whatever else the machine does meanwhile: here the clocks of the
 * system are the test's own. */
#include "render/kit_take.h" /* before cmocka, whose fail() is a macro */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

#include <cmocka.h>

#include "kit/kit_build.h"

enum { RATE = 48000, BLOCKS = 3 };

static const char NAME[] = "test_kit_take.wav";

int __wrap_clock_gettime(clockid_t clock, struct timespec *time);

/* At each look a second of processor time has passed, and an hour of the day. */
int __wrap_clock_gettime(clockid_t clock, struct timespec *time) {
  static time_t looks;
  looks++;
  *time = (struct timespec){.tv_sec = clock == CLOCK_PROCESS_CPUTIME_ID ? looks : 3600 * looks};
  return 0;
}

static void the_cost_is_processor_time(void **state) {
  (void)state;
  static KitTake take;
  TaborKitDef kit;
  TaborModelOptions model;
  kit_take_begin(&take);
  assert_int_equal(tabor_kit_def_preset(&kit, "standard", NULL), TABOR_OK);
  kit.drum_count = 1;
  tabor_model_options_default(&model);
  model.quality = TABOR_QUALITY_DRAFT;
  assert_int_equal(kit_build(&kit, &model, 1, &take.kit), OUTCOME_OK);
  take.format =
    (KitFormat){.audio = {.channels = 2, .rate = RATE}, .gain = 1, .frames = BLOCKS * AUDIO_BLOCK};
  assert_int_equal(audio_encoding(DEFAULT_ENCODING, &take.format.audio.encoding), OUTCOME_OK);
  assert_int_equal(output_plan(&take.outputs[take.output_count++], NAME, false), OUTCOME_OK);
  assert_int_equal(kit_take_write(&take, NULL, NULL), OUTCOME_OK);
  assert_int_equal(take.position, BLOCKS * AUDIO_BLOCK);
  assert_float_equal(take.computing, BLOCKS, 1e-9);
  kit_take_free(&take);
  (void)remove(NAME);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(the_cost_is_processor_time)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
