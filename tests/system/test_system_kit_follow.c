/* SPDX-License-Identifier: MIT */
/* Kits that take the place of others while these ring. */
#include "kits.h"

enum { HALF = 4800 };

static const char *const PRESETS[] = {"bass-drum-22", "snare-14x5.5", "tom-12"};

/* What a kit gives: the mix, and the first microphone of each drum. */
typedef struct Heard {
  float stereo[2][LENGTH], mic[TABOR_KIT_DRUMS][LENGTH];
} Heard;

static void play(TaborKit *kit, const TaborKitEvent *events, uint32_t count, Heard *heard,
                 uint32_t from, uint32_t frames) {
  TaborKitOutputs outputs = {.stereo = {heard->stereo[0] + from, heard->stereo[1] + from}};
  for (uint32_t i = 0; i < tabor_kit_definition(kit)->drum_count; i++) {
    outputs.mic[i][0] = heard->mic[i] + from;
  }
  tabor_kit_process(kit, events, count, &outputs, frames);
}

/* Strokes on the first three drums, so that all ring when the kit changes. */
static void begin(TaborKit *kit, const TaborKitDef *def, Heard *heard) {
  const TaborKitEvent events[] = {stroke(def, 0, 10, 4.0), stroke(def, 1, 333, 3.0),
                                  stroke(def, 2, 2000, 6.0)};
  play(kit, events, 3, heard, 0, HALF);
}

static void follow(TaborKit *kit, TaborKit *from, const uint8_t *drums) {
  TaborError error = {0};
  if (tabor_kit_follow(kit, from, drums, &error) != TABOR_OK) fail_msg("%s", error.message);
  tabor_kit_take_over(kit, from);
}

/* Without a change nothing changes; a saved state, too, is what it would have been. */
static void a_kit_that_follows_its_like_plays_on_to_the_bit(void **state) {
  (void)state;
  static Heard one, other;
  static const uint8_t drums[] = {0, 1, 2};
  TaborKitDef *const def = kit_of(3, PRESETS);
  TaborModel *models[3];
  set(def, "room.kind", "studio");
  models_of(def, models);
  TaborKit *const whole = kit_with(def, models), *const first = kit_with(def, models),
                  *const second = kit_with(def, models);
  const TaborKitEvent events[] = {value_at(0, TABOR_KIT_OVERHEADS, -6), stroke(def, 2, 77, 2.0)};
  begin(whole, def, &one);
  begin(first, def, &other);
  follow(second, first, drums);
  play(whole, events, 2, &one, HALF, LENGTH - HALF);
  play(second, events, 2, &other, HALF, LENGTH - HALF);
  assert_memory_equal(&one, &other, sizeof one);
  const size_t size = tabor_kit_state_size(whole);
  assert_int_equal(size, tabor_kit_state_size(second));
  char *const bytes[2] = {malloc(size), malloc(size)};
  tabor_kit_state_save(whole, bytes[0]);
  tabor_kit_state_save(second, bytes[1]);
  assert_memory_equal(bytes[0], bytes[1], size);
  assert_true(tabor_kit_is_silent(first));
  free(bytes[0]);
  free(bytes[1]);
  tabor_kit_destroy(first);
  tabor_kit_destroy(second);
  tabor_kit_destroy(whole);
  release_models(def, models);
  free(def);
}

/* The same as by a swap of that drum; the others hear it. */
static void a_drum_that_is_tuned_is_swapped(void **state) {
  (void)state;
  static Heard one, other;
  static const uint8_t drums[] = {0, 1, 2};
  TaborKitDef *const def = kit_of(3, PRESETS), *const tuned = kit_of(3, PRESETS);
  TaborModel *models[3], *after[3];
  TaborSwap *swap;
  set(tuned, "drum.d2.batter.tension", "3000");
  models_of(def, models);
  memcpy(after, models, sizeof models);
  after[2] = placed_model(tuned, 2);
  TaborKit *const swapped = kit_with(def, models), *const first = kit_with(def, models),
                  *const second = kit_with(tuned, after);
  begin(swapped, def, &one);
  begin(first, def, &other);
  assert_int_equal(tabor_swap_create(models[2], after[2], &swap, NULL), TABOR_OK);
  const TaborKitEvent event = {.drum = 2, .event = {.type = TABOR_EVENT_SWAP, .swap = swap}};
  follow(second, first, drums);
  tabor_kit_destroy(first); /* nothing of it is needed */
  play(swapped, &event, 1, &one, HALF, LENGTH - HALF);
  play(second, NULL, 0, &other, HALF, LENGTH - HALF);
  assert_memory_equal(&one, &other, sizeof one);
  tabor_kit_destroy(swapped);
  tabor_swap_destroy(swap);
  tabor_kit_destroy(second);
  tabor_model_release(after[2]);
  release_models(def, models);
  free(tuned);
  free(def);
}

/* While drums do not hear each other, those that stay have the same bits, and what is left rings on
 * in the kit before. */
static void drums_come_and_go_while_others_ring(void **state) {
  (void)state;
  static Heard one, left, other;
  static const char *const AFTER[] = {"tom-12", "snare-14x5.5", "frame-drum"};
  static const uint8_t drums[] = {2, 1, TABOR_KIT_NEW};
  TaborKitDef *const def = kit_of(3, PRESETS), *const changed = kit_of(3, AFTER);
  TaborModel *models[3], *after[3];
  set(def, "kit.coupling", "off");
  set(changed, "kit.coupling", "off");
  models_of(def, models);
  after[0] = models[2];
  after[1] = models[1];
  after[2] = placed_model(changed, 2);
  TaborKit *const whole = kit_with(def, models), *const first = kit_with(def, models),
                  *const second = kit_with(changed, after);
  begin(whole, def, &one);
  begin(first, def, &left);
  memcpy(&other, &left, sizeof other);
  follow(second, first, drums);
  const TaborKitEvent events[] = {stroke(changed, 2, 100, 3.0)};
  play(whole, NULL, 0, &one, HALF, LENGTH - HALF);
  play(first, NULL, 0, &left, HALF, LENGTH - HALF);
  play(second, events, 1, &other, HALF, LENGTH - HALF);
  const size_t rest = (LENGTH - HALF) * sizeof(float);
  assert_memory_equal(left.mic[0], one.mic[0], sizeof one.mic[0]); /* the bass drum */
  assert_memory_equal(other.mic[1] + HALF, one.mic[1] + HALF, rest);
  assert_memory_equal(other.mic[0] + HALF, one.mic[2] + HALF, rest);
  float loudest = 0;
  for (uint32_t i = HALF; i < LENGTH; i++) loudest = fmaxf(loudest, fabsf(other.mic[2][i]));
  assert_true(loudest > 1e-4f);
  for (uint32_t i = HALF; i < LENGTH; i++) assert_true(left.mic[1][i] == 0 && left.mic[2][i] == 0);
  tabor_kit_destroy(first);
  tabor_kit_destroy(second);
  tabor_kit_destroy(whole);
  tabor_model_release(after[2]);
  release_models(def, models);
  free(changed);
  free(def);
}

/* The sound in a room that is exchanged goes on in it, and new sound is in the other one: at the
 * moment of the change the mix of both has no step. */
static void a_room_that_is_exchanged_rings_on(void **state) {
  (void)state;
  static Heard one, left, other;
  static const uint8_t drums[] = {0, 1, 2};
  TaborKitDef *const def = kit_of(3, PRESETS), *const hall = kit_of(3, PRESETS);
  TaborModel *models[3];
  set(def, "room.kind", "booth");
  set(hall, "room.kind", "hall");
  models_of(def, models);
  TaborKit *const whole = kit_with(def, models), *const first = kit_with(def, models),
                  *const second = kit_with(hall, models);
  begin(whole, def, &one);
  begin(first, def, &left);
  memcpy(&other, &left, sizeof other);
  follow(second, first, drums);
  play(whole, NULL, 0, &one, HALF, LENGTH - HALF);
  play(first, NULL, 0, &left, HALF, LENGTH - HALF);
  play(second, NULL, 0, &other, HALF, LENGTH - HALF);
  assert_memory_equal(other.mic, one.mic, sizeof one.mic);
  /* Until the first reflection of what is new, both together are the old room; it takes 108 frames.
   */
  for (uint32_t i = HALF; i < HALF + 100; i++) {
    for (int side = 0; side < 2; side++) {
      const double sum = (double)left.stereo[side][i] + (double)other.stereo[side][i];
      assert_true(fabs(sum - (double)one.stereo[side][i]) < 1e-6);
    }
  }
  double apart = 0;
  for (uint32_t i = HALF; i < LENGTH; i++) {
    apart = fmax(apart, fabs((double)left.stereo[0][i] + (double)other.stereo[0][i] -
                             (double)one.stereo[0][i]));
  }
  assert_true(apart > 1e-4); /* it is another room */
  tabor_kit_destroy(first);
  tabor_kit_destroy(second);
  tabor_kit_destroy(whole);
  release_models(def, models);
  free(hall);
  free(def);
}

/* Kits that tune up and down in turn, as fast as a knob moves, pump no energy into their drums. */
static void kits_in_turn_create_no_energy(void **state) {
  (void)state;
  enum { TURNS = 60 };
  const int turns = brief ? 12 : TURNS;
  static Heard heard;
  static const uint8_t drums[] = {0, 1, 2};
  TaborKitDef *const defs[2] = {kit_of(3, PRESETS), kit_of(3, PRESETS)};
  TaborModel *models[2][3];
  TaborKit *kits[TURNS + 1];
  set(defs[1], "drum.d0.batter.tension", "1100");
  set(defs[1], "drum.d2.batter.tension", "3000");
  for (int i = 0; i < 2; i++) models_of(defs[i], models[i]);
  kits[0] = kit_with(defs[0], models[0]);
  begin(kits[0], defs[0], &heard);
  for (int i = 1; i <= turns; i++) {
    kits[i] = kit_with(defs[i % 2], models[i % 2]);
    follow(kits[i], kits[i - 1], drums);
    tabor_kit_destroy(kits[i - 1]); /* whose swaps may sound on */
    play(kits[i], NULL, 0, &heard, 0, i < turns / 2 ? 480 : 64);
  }
  for (uint32_t i = 0; i < 3; i++) {
    TaborLedger ledger;
    tabor_drum_ledger(tabor_kit_drum(kits[turns], i), &ledger);
    assert_true(ledger.stored >= 0 && ledger.stored < ledger.injected);
    assert_true(fabs(ledger.residual) <= 1e-6 * ledger.injected);
  }
  tabor_kit_destroy(kits[turns]);
  for (int i = 0; i < 2; i++) {
    release_models(defs[i], models[i]);
    free(defs[i]);
  }
}

static void what_cannot_follow_is_refused(void **state) {
  (void)state;
  static const uint8_t twice[] = {0, 0, 2}, beyond[] = {0, 1, 3}, good[] = {2, TABOR_KIT_NEW, 0};
  TaborKitDef *const def = kit_of(3, PRESETS);
  TaborModel *models[3];
  TaborError error;
  static Heard heard;
  models_of(def, models);
  TaborKit *const first = kit_with(def, models), *const second = kit_with(def, models);
  assert_int_equal(tabor_kit_follow(second, first, twice, &error), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_kit_follow(second, first, beyond, &error), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_kit_follow(second, second, good, &error), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_kit_follow(second, first, NULL, &error), TABOR_ERROR_ARGUMENT);
  assert_true(error.message[0] != '\0');
  tabor_kit_take_over(second, first); /* was not prepared: nothing happens */
  assert_int_equal(tabor_kit_follow(second, first, good, &error), TABOR_OK);
  assert_int_equal(tabor_kit_follow(second, first, good, &error), TABOR_ERROR_ARGUMENT);
  tabor_kit_take_over(first, second);
  play(first, NULL, 0, &heard, 0, 64);
  tabor_kit_destroy(second); /* its swaps were never sent */
  tabor_kit_destroy(first);
  release_models(def, models);
  free(def);
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_kit_that_follows_its_like_plays_on_to_the_bit),
    cmocka_unit_test(a_drum_that_is_tuned_is_swapped),
    cmocka_unit_test(drums_come_and_go_while_others_ring),
    cmocka_unit_test(a_room_that_is_exchanged_rings_on),
    cmocka_unit_test(kits_in_turn_create_no_energy),
    cmocka_unit_test(what_cannot_follow_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
