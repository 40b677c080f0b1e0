/* SPDX-License-Identifier: MIT */
/* Saved models: the same bits as those that were built, and no bytes that are not right. */
#include "math/arena.h"
#include "physics.h"

/* usage: test_saved_model [brief]: small drums alone, for slow builds. */
static bool brief;

enum { FRAMES = 2400, BLOCK = 96 };

typedef struct Saved {
  size_t size;
  unsigned char *bytes;
} Saved;

static Saved save(const TaborModel *model) {
  Saved saved = {.size = tabor_model_saved_size(model)};
  saved.bytes = malloc(saved.size);
  assert_non_null(saved.bytes);
  tabor_model_save(model, saved.bytes);
  return saved;
}

static TaborModel *load(const Saved *saved) {
  TaborModel *model;
  TaborError error = {0};
  if (tabor_model_load(saved->bytes, saved->size, NULL, &model, &error) != TABOR_OK)
    fail_msg("%s", error.message);
  return model;
}

/* A built model, its bytes, and what they load as. */
typedef struct Pair {
  TaborModel *built, *loaded;
  Saved saved;
} Pair;

static Pair pair_of(const TaborDrumDef *def, double rate, uint32_t quality) {
  Pair pair = {.built = physics_model(def, rate, quality)};
  pair.saved = save(pair.built);
  pair.loaded = load(&pair.saved);
  return pair;
}

static void pair_end(Pair *pair) {
  tabor_model_release(pair->built);
  tabor_model_release(pair->loaded);
  free(pair->saved.bytes);
}

static void refuse(const Saved *saved, const char *why) {
  TaborModel *model = (TaborModel *)saved;
  TaborError error = {0};
  assert_int_equal(tabor_model_load(saved->bytes, saved->size, NULL, &model, &error),
                   TABOR_ERROR_STATE);
  assert_null(model);
  assert_int_equal(error.status, TABOR_ERROR_STATE);
  if (!strstr(error.message, why)) fail_msg("'%s' does not say '%s'", error.message, why);
}

/* One stroke of each striker, at all microphones: sound[mics][FRAMES]. */
static void play(TaborDrum *drum, float *sound) {
  const TaborModel *model = tabor_drum_model(drum);
  const TaborDrumDef *def = tabor_model_definition(model);
  for (uint32_t n = 0, next = 0; n < FRAMES; n += BLOCK) {
    float *outputs[TABOR_MAX_MICS];
    for (uint32_t mic = 0; mic < def->mic_count; mic++) outputs[mic] = sound + mic * FRAMES + n;
    TaborEvent stroke = physics_strike(def);
    stroke.striker = next;
    const bool strikes = n % 480 == 0 && next < def->striker_count;
    next += strikes;
    tabor_drum_process(drum, &stroke, strikes, outputs, BLOCK);
  }
}

static float *sound_of(TaborModel *model) {
  float *sound = calloc((size_t)TABOR_MAX_MICS * FRAMES, sizeof *sound);
  assert_non_null(sound);
  TaborDrum *drum = physics_drum(model);
  play(drum, sound);
  tabor_drum_destroy(drum);
  return sound;
}

static void expect_same_sound(TaborModel *built, TaborModel *loaded, const char *name) {
  float *const first = sound_of(built), *const second = sound_of(loaded);
  double peak = 0.0;
  for (size_t i = 0; i < FRAMES; i++) peak = fmax(peak, fabs((double)first[i]));
  assert_true(peak > 0.0);
  if (memcmp(first, second, sizeof *first * TABOR_MAX_MICS * FRAMES) != 0)
    fail_msg("%s sounds otherwise once it is saved and loaded", name);
  free(first);
  free(second);
}

/* The bytes of a model are saved again as they were: no pointer of this process is among them. */
static void expect_same_bytes(const Saved *saved, const TaborModel *loaded, const char *name) {
  const Saved again = save(loaded);
  assert_int_equal(again.size, saved->size);
  if (memcmp(again.bytes, saved->bytes, saved->size) != 0)
    fail_msg("%s has other bytes once it is saved again", name);
  free(again.bytes);
}

static void try_drum(const TaborDrumDef *def, const char *name, uint32_t quality) {
  Pair pair = pair_of(def, 48000.0, quality);
  expect_same_bytes(&pair.saved, pair.loaded, name);
  expect_same_sound(pair.built, pair.loaded, name);
  pair_end(&pair);
}

static void each_preset_has_the_same_bits(void **state) {
  (void)state;
  for (uint32_t i = 0; i < (brief ? 2u : tabor_preset_count()); i++) {
    const char *const name = tabor_preset(i)->name;
    const TaborDrumDef def = physics_preset(name);
    try_drum(&def, name, TABOR_QUALITY_LIVE);
  }
}

/* Double precision, a brush, uneven lugs, a wire on an axis of its own. */
static void so_have_other_qualities_and_parts(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset(brief ? "bodhran-d-string" : "snare-14x5.5");
  if (tabor_drum_def_set(&def, "batter.lug_spread", "0.03", NULL) != TABOR_OK) fail();
  if (tabor_drum_def_set(&def, "striker.brush.kind", "brush", NULL) != TABOR_OK) fail();
  def = physics_small(&def);
  try_drum(&def, "a drum with a brush", TABOR_QUALITY_STUDIO);
  try_drum(&def, "a drum with a brush", TABOR_QUALITY_DRAFT);
}

static void instructions_do_not_matter(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *const built = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const Saved saved = save(built);
  TaborModelOptions options;
  TaborModel *loaded;
  tabor_model_options_default(&options);
  options.instructions = TABOR_INSTRUCTIONS_BASELINE;
  assert_int_equal(tabor_model_load(saved.bytes, saved.size, &options, &loaded, NULL), TABOR_OK);
  expect_same_sound(built, loaded, "frame-drum");
  tabor_model_release(built);
  tabor_model_release(loaded);
  free(saved.bytes);
}

static void facts_and_modes_are_those_of_the_built_one(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("tom-12");
  Pair pair = pair_of(&def, 44100.0, TABOR_QUALITY_DRAFT);
  TaborModelInfo info[2];
  tabor_model_info(pair.built, &info[0]);
  tabor_model_info(pair.loaded, &info[1]);
  assert_true(info[0].sample_rate == info[1].sample_rate && info[0].quality == info[1].quality &&
              info[0].mode_count == info[1].mode_count && info[0].drum_bytes == info[1].drum_bytes);
  TaborModeInfo mode, same;
  for (uint32_t row = 0; tabor_model_mode(pair.built, row, &mode); row++) {
    assert_true(tabor_model_mode(pair.loaded, row, &same));
    assert_true(mode.m == same.m && mode.n == same.n && mode.part == same.part);
    assert_true(mode.frequency == same.frequency && mode.decay_rate == same.decay_rate);
    double shape[2];
    assert_true(tabor_model_mode_shape(pair.built, row, 1, 0.05, &shape[0]));
    assert_true(tabor_model_mode_shape(pair.loaded, row, 1, 0.05, &shape[1]));
    assert_true(shape[0] == shape[1]);
  }
  pair_end(&pair);
}

static void states_go_from_one_to_the_other(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("bodhran-d-string");
  Pair pair = pair_of(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *const first = physics_drum(pair.built), *const second = physics_drum(pair.loaded);
  float *const sound[2] = {calloc((size_t)TABOR_MAX_MICS * FRAMES, sizeof(float)),
                           calloc((size_t)TABOR_MAX_MICS * FRAMES, sizeof(float))};
  play(first, sound[0]);
  const size_t size = tabor_drum_state_size(first);
  void *const bytes = malloc(size);
  tabor_drum_state_save(first, bytes);
  assert_int_equal(tabor_drum_state_load(second, bytes, size), TABOR_OK);
  play(first, sound[0]);
  play(second, sound[1]);
  assert_memory_equal(sound[0], sound[1], sizeof(float) * TABOR_MAX_MICS * FRAMES);
  free(sound[0]);
  free(sound[1]);
  free(bytes);
  tabor_drum_destroy(first);
  tabor_drum_destroy(second);
  pair_end(&pair);
}

/* ---- bytes that are not right ---------------------------------------------------------------- */

/* One bit of the head, or of a few hundred places behind it, from a seed. */
static void damaged_bytes_are_refused(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("tabor");
  TaborModel *const built = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  const Saved saved = save(built);
  uint64_t seed = 1;
  for (uint32_t i = 0; i < (brief ? 20u : 300u); i++) {
    const uint64_t draw = physics_random(&seed);
    const size_t at = i < 64 ? i : draw % saved.size;
    const unsigned char bit = (unsigned char)(1u << (draw >> 61));
    saved.bytes[at] ^= bit;
    refuse(&saved, "saved model");
    saved.bytes[at] ^= bit;
  }
  tabor_model_release(load(&saved));
  free(saved.bytes);
  tabor_model_release(built);
}

static void other_bytes_are_refused_by_name(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("tabor");
  TaborModel *const built = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  const Saved saved = save(built);
  refuse(&(Saved){.size = 0, .bytes = saved.bytes}, "cut off");
  refuse(&(Saved){.size = 200, .bytes = saved.bytes}, "cut off");
  refuse(&(Saved){.size = saved.size - 1, .bytes = saved.bytes}, "cut off");
  saved.bytes[8] ^= 1; /* the version */
  refuse(&saved, "another version");
  saved.bytes[8] ^= 1;
  saved.bytes[0] ^= 1;
  refuse(&saved, "no saved model");
  saved.bytes[0] ^= 1;
  saved.bytes[saved.size / 2] ^= 1;
  refuse(&saved, "damaged");
  free(saved.bytes);
  tabor_model_release(built);
}

static void what_is_null_is_named(void **state) {
  (void)state;
  TaborModel *model;
  TaborError error = {0};
  assert_int_equal(tabor_model_load(NULL, 0, NULL, &model, &error), TABOR_ERROR_ARGUMENT);
  assert_string_equal(error.message, "the saved model is NULL");
  assert_int_equal(tabor_model_load("", 1, NULL, NULL, &error), TABOR_ERROR_ARGUMENT);
}

/* ---- memory ---------------------------------------------------------------------------------- */

static int left; /* allocations that succeed */

static void *give(size_t size, void *context) {
  const TaborAllocator usual = tb_allocator_resolve(NULL);
  return left-- > 0 ? usual.allocate(size, context) : NULL;
}

static void take(void *memory, void *context) {
  tb_allocator_resolve(NULL).release(memory, context);
}

static void short_memory_is_said(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("tabor");
  TaborModel *const built = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  const Saved saved = save(built);
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.allocator = (TaborAllocator){give, take, NULL};
  TaborModel *model;
  int allocations = 0;
  for (TaborStatus status = TABOR_ERROR_MEMORY; status != TABOR_OK; allocations++) {
    TaborError error = {0};
    left = allocations;
    status = tabor_model_load(saved.bytes, saved.size, &options, &model, &error);
    if (status == TABOR_OK) break;
    assert_int_equal(status, TABOR_ERROR_MEMORY);
    assert_int_equal(error.status, TABOR_ERROR_MEMORY);
    assert_null(model);
  }
  assert_int_equal(allocations, 2); /* the model, and its arrays */
  tabor_model_release(model);
  free(saved.bytes);
  tabor_model_release(built);
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(each_preset_has_the_same_bits),
    cmocka_unit_test(so_have_other_qualities_and_parts),
    cmocka_unit_test(instructions_do_not_matter),
    cmocka_unit_test(facts_and_modes_are_those_of_the_built_one),
    cmocka_unit_test(states_go_from_one_to_the_other),
    cmocka_unit_test(damaged_bytes_are_refused),
    cmocka_unit_test(other_bytes_are_refused_by_name),
    cmocka_unit_test(what_is_null_is_named),
    cmocka_unit_test(short_memory_is_said),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
