/* SPDX-License-Identifier: MIT */
/* The same bits from every instruction set, and from every thread.
 *
 * usage: test_system_kernels [brief | narrow]: at draft and live alone; or all of it, of drums with
 * few modes. */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "drum_script.h"

static bool brief, narrow;

static bool processor_has_avx2(void) {
#if defined(__GNUC__) && defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

static Take play_fresh(TaborModel *model, const Script *script) {
  TaborDrum *drum = script_drum(model);
  Take take = take_create(model, SCRIPT_FRAMES);
  script_play_all(drum, script, &take);
  tabor_drum_destroy(drum);
  return take;
}

/* Wires of `stiffness`, or as the preset has them where it is NULL. */
static Take play_with(const char *preset, const char *stiffness, TaborQuality quality,
                      TaborInstructions instructions) {
  Script script;
  script_everything(&script);
  TaborDrumDef def;
  assert_int_equal(tabor_drum_def_preset(&def, preset, NULL), TABOR_OK);
  if (stiffness) {
    assert_int_equal(tabor_drum_def_set(&def, "wires.contact_stiffness", stiffness, NULL),
                     TABOR_OK);
  }
  if (narrow) script_narrow(&def);
  TaborModel *model = script_model_of(&def, quality, instructions);
  Take take = play_fresh(model, &script);
  tabor_model_release(model);
  return take;
}

static void compare_stiff(const char *preset, const char *stiffness, TaborQuality quality,
                          TaborInstructions other) {
  Take a = play_with(preset, stiffness, quality, TABOR_INSTRUCTIONS_BASELINE);
  Take b = play_with(preset, stiffness, quality, other);
  char what[128];
  snprintf(what, sizeof what, "%s, wires of %s, at quality %d, baseline and instructions %d",
           preset, stiffness ? stiffness : "its own", (int)quality, (int)other);
  assert_true(take_peak(&a) > 0.0);
  take_assert_same(&a, &b, what);
  take_destroy(&a);
  take_destroy(&b);
}

static void compare_kernels(const char *preset, TaborQuality quality, TaborInstructions other) {
  compare_stiff(preset, NULL, quality, other);
}

/* Penetrations pass the knee of the law here, in some lanes of a register and not in others. */
static void stiff_wires_give_the_same_bits_too(void **state) {
  (void)state;
  if (!processor_has_avx2()) {
    print_message("SKIPPED: the processor has no AVX2\n");
    skip();
  }
  static const TaborInstructions WIDER[] = {TABOR_INSTRUCTIONS_AVX2, TABOR_INSTRUCTIONS_AVX512};
  for (int i = 0; i < (brief ? 1 : 2); i++) {
    compare_stiff("tabor", "2e9", TABOR_QUALITY_DRAFT, WIDER[i]);
    compare_stiff("tabor", "2e9", TABOR_QUALITY_LIVE, WIDER[i]);
    if (!brief) compare_stiff("tabor", "1e12", TABOR_QUALITY_STUDIO, WIDER[i]);
  }
}

static void avx2_gives_the_same_bits_as_baseline(void **state) {
  (void)state;
  if (!processor_has_avx2()) {
    print_message("SKIPPED: the processor has no AVX2\n");
    skip();
  }
  const int finest = brief ? TABOR_QUALITY_LIVE : TABOR_QUALITY_REFERENCE;
  for (int quality = TABOR_QUALITY_DRAFT; quality <= finest; quality++) {
    compare_kernels("tabor", (TaborQuality)quality, TABOR_INSTRUCTIONS_AVX2);
  }
  if (!brief) compare_kernels("bodhran-d-string", TABOR_QUALITY_STUDIO, TABOR_INSTRUCTIONS_AVX2);
}

/* Where the processor lacks it, the next narrower kernels run. */
static void avx512_gives_the_same_bits_as_baseline(void **state) {
  (void)state;
  compare_kernels("tabor", TABOR_QUALITY_LIVE, TABOR_INSTRUCTIONS_AVX512);
  compare_kernels("bodhran-d-string", TABOR_QUALITY_STUDIO, TABOR_INSTRUCTIONS_AVX512);
}

static void the_automatic_choice_gives_the_same_bits_as_baseline(void **state) {
  (void)state;
  compare_kernels("tabor", TABOR_QUALITY_DEFAULT, TABOR_INSTRUCTIONS_AUTO);
}

/* All that a thread needs is made before it starts: a failing assertion may not jump out of it. */
typedef struct Player {
  TaborDrum *drum;
  const Script *script;
  Take take;
} Player;

static void *play_in_thread(void *context) {
  Player *player = context;
  script_play_all(player->drum, player->script, &player->take);
  return NULL;
}

static void two_threads_on_one_model_give_what_one_gives(void **state) {
  (void)state;
  Script scripts[2];
  script_everything(&scripts[0]);
  scripts[1] = (Script){.count = 0};
  script_add(&scripts[1], script_strike(11, 6.0, 0.02, 0.0));
  script_add(&scripts[1], script_strike(2001, 1.5, 0.08, 90.0));

  TaborModel *model = (narrow ? script_narrow_model : script_model)("tabor", TABOR_QUALITY_DEFAULT,
                                                                    TABOR_INSTRUCTIONS_AUTO);
  Player players[2];
  pthread_t threads[2];
  for (int i = 0; i < 2; i++) {
    players[i] = (Player){script_drum(model), &scripts[i], take_create(model, SCRIPT_FRAMES)};
  }
  for (int i = 0; i < 2; i++) {
    assert_int_equal(pthread_create(&threads[i], NULL, play_in_thread, &players[i]), 0);
  }
  for (int i = 0; i < 2; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
  for (int i = 0; i < 2; i++) {
    Take alone = play_fresh(model, &scripts[i]);
    take_assert_same(&alone, &players[i].take, "alone and beside another thread");
    take_destroy(&alone);
    take_destroy(&players[i].take);
    tabor_drum_destroy(players[i].drum);
  }
  tabor_model_release(model);
}

int main(int count, char **words) {
  brief = count > 1 && strcmp(words[1], "brief") == 0;
  narrow = count > 1 && strcmp(words[1], "narrow") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(avx2_gives_the_same_bits_as_baseline),
    cmocka_unit_test(stiff_wires_give_the_same_bits_too),
    cmocka_unit_test(avx512_gives_the_same_bits_as_baseline),
    cmocka_unit_test(the_automatic_choice_gives_the_same_bits_as_baseline),
    cmocka_unit_test(two_threads_on_one_model_give_what_one_gives),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
