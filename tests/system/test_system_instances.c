/* SPDX-License-Identifier: MIT */
/* Many drums: each sounds as if it were alone, creating one is cheap, and none leaves anything
 * behind.
 *
 *     test_system_instances [CYCLES [CASES]]
 *
 * CYCLES drums are created and destroyed, 1000 unless given; CASES is a pattern of the names of
 * those to run, for valgrind. */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <cmocka.h>

#include "drum_script.h"
#include "windows_names.h"

enum { ALIGNMENT = 64, HANDLE = 256 /* bytes that point to the state, at most */ };

static int cycles = 1000;

/* ---- side by side --------------------------------------------------------------------------- */

/* A drum with its performance, and what it sounds like alone. */
typedef struct Player {
  TaborModel *model;
  TaborDrum *drum;
  Script script;
  uint32_t block, position;
  Take take, alone;
} Player;

static void player_prepare(Player *player, TaborModel *model, uint32_t block) {
  *player = (Player){.model = tabor_model_retain(model), .block = block};
  script_everything(&player->script);
  player->script.events[0].velocity += block; /* no two play the same */
  player->alone = take_create(model, SCRIPT_FRAMES);
  player->take = take_create(model, SCRIPT_FRAMES);
  TaborDrum *drum = script_drum(model);
  script_play_all(drum, &player->script, &player->alone);
  tabor_drum_destroy(drum);
  player->drum = script_drum(model);
}

/* Plays one block; false at the end. */
static bool player_go_on(Player *player) {
  uint32_t end = player->position + player->block;
  if (end > SCRIPT_FRAMES) end = SCRIPT_FRAMES;
  script_play(player->drum, &player->script, player->position, end, blocks_of, &player->block,
              &player->take);
  player->position = end;
  return end < SCRIPT_FRAMES;
}

static void player_finish(Player *player, const char *what) {
  assert_true(take_peak(&player->take) > 0.0);
  take_assert_same(&player->alone, &player->take, what);
  take_destroy(&player->alone);
  take_destroy(&player->take);
  tabor_drum_destroy(player->drum);
  tabor_model_release(player->model);
}

/* Two drums of one model and one of another. */
static void three_players(Player *players) {
  TaborModel *one = script_model("tabor", TABOR_QUALITY_LIVE, TABOR_INSTRUCTIONS_AUTO);
  TaborModel *other = script_model("frame-drum", TABOR_QUALITY_LIVE, TABOR_INSTRUCTIONS_AUTO);
  player_prepare(&players[0], one, 1);
  player_prepare(&players[1], one, 48);
  player_prepare(&players[2], other, 7);
  tabor_model_release(one);
  tabor_model_release(other);
}

static void interleaved_drums_equal_each_alone(void **state) {
  (void)state;
  Player players[3];
  three_players(players);
  bool playing = true;
  while (playing) {
    playing = false;
    for (int i = 0; i < 3; i++) playing = player_go_on(&players[i]) || playing;
  }
  for (int i = 0; i < 3; i++) player_finish(&players[i], "interleaved");
}

static void *play_through(void *player) {
  while (player_go_on(player)) {}
  return NULL;
}

static void drums_on_threads_equal_each_alone(void **state) {
  (void)state;
  Player players[3];
  pthread_t threads[3];
  three_players(players);
  for (int i = 0; i < 3; i++)
    assert_int_equal(pthread_create(&threads[i], NULL, play_through, &players[i]), 0);
  for (int i = 0; i < 3; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
  for (int i = 0; i < 3; i++) player_finish(&players[i], "on a thread of its own");
}

/* ---- created and destroyed ------------------------------------------------------------------ */

/* Counts what was taken, and what is not yet back. */
typedef struct Supply {
  int taken, out;
  size_t bytes;
} Supply;

static void *supply_allocate(size_t size, void *context) {
  Supply *supply = context;
  supply->taken++;
  supply->out++;
  supply->bytes += size;
  return aligned_memory(ALIGNMENT, size);
}

static void supply_release(void *memory, void *context) {
  Supply *supply = context;
  if (memory) supply->out--;
  free_aligned_memory(memory);
}

static TaborModel *model_from(Supply *supply) {
  TaborDrumDef def;
  TaborModelOptions options;
  TaborModel *model = NULL;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_DRAFT;
  options.allocator = (TaborAllocator){supply_allocate, supply_release, supply};
  assert_int_equal(tabor_drum_def_preset(&def, "tabor", NULL), TABOR_OK);
  assert_int_equal(tabor_model_create(&def, &options, &model, NULL), TABOR_OK);
  return model;
}

/* A drum takes its own piece of memory, one for its state, and two for what a silence lets fade. It
 * computes nothing but its rest: that is why it is cheap. */
static void a_drum_takes_the_memory_that_its_model_says(void **state) {
  (void)state;
  Supply supply = {0};
  TaborModel *model = model_from(&supply);
  TaborModelInfo info;
  tabor_model_info(model, &info);
  const Supply before = supply;
  TaborDrum *drum = script_drum(model);
  assert_int_equal(supply.taken - before.taken, 4);
  assert_in_range(supply.bytes - before.bytes, info.drum_bytes, info.drum_bytes + HANDLE);
  tabor_drum_destroy(drum);
  assert_int_equal(supply.out, before.out);
  tabor_model_release(model);
  assert_int_equal(supply.out, 0);
}

static void cycle(TaborModel *model) {
  const TaborEvent strike = script_strike(0, 3.0, 0.03, 0.0);
  TaborSwap *swap = NULL;
  TaborDrum *drum = script_drum(model);
  tabor_drum_process(drum, &strike, 1, NULL, 4);
  assert_int_equal(tabor_swap_create(model, model, &swap, NULL), TABOR_OK);
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 4);
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
}

static void nothing_is_left_of_many_drums(void **state) {
  (void)state;
  Supply supply = {0};
  TaborModel *model = model_from(&supply);
  const int before = supply.out;
  for (int i = 0; i < cycles; i++) cycle(model);
  assert_int_equal(supply.out, before);
  tabor_model_release(model);
  assert_int_equal(supply.out, 0);
}

/* Told, not asserted: machines differ. */
static void time_of_creation(void **state) {
  (void)state;
  TaborModel *model = script_model("snare-14x5.5", TABOR_QUALITY_LIVE, TABOR_INSTRUCTIONS_AUTO);
  const clock_t start = clock();
  for (int i = 0; i < cycles; i++) tabor_drum_destroy(script_drum(model));
  const double each = (double)(clock() - start) / CLOCKS_PER_SEC / cycles;
  print_message("a drum of snare-14x5.5 is created and destroyed in %.4f ms\n", 1e3 * each);
  tabor_model_release(model);
}

int main(int argc, char **argv) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(interleaved_drums_equal_each_alone),
    cmocka_unit_test(drums_on_threads_equal_each_alone),
    cmocka_unit_test(a_drum_takes_the_memory_that_its_model_says),
    cmocka_unit_test(nothing_is_left_of_many_drums),
    cmocka_unit_test(time_of_creation),
  };
  if (argc > 1) cycles = atoi(argv[1]);
  if (argc > 2) cmocka_set_test_filter(argv[2]);
  return cmocka_run_group_tests(tests, NULL, NULL);
}
