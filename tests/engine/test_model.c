/* SPDX-License-Identifier: MIT */
/* What tabor_model_create() and its like refuse, and how they say it. */
#include "math/bessel.h"
#include "model/build_estimate.h"
#include "physics.h"

static void options_out_of_range_are_named_with_their_value_and_range(void **state) {
  (void)state;
  const struct {
    double rate;
    uint32_t quality, instructions;
    const char *key, *value;
    double minimum, maximum;
  } wrong[] = {
    {22049.5, 0, 0, "sample_rate", "22049.5", 22050.0, 192000.0},
    {INFINITY, 0, 0, "sample_rate", "inf", 22050.0, 192000.0},
    {48000.0, TABOR_QUALITY_REFERENCE + 1, 0, "quality", "5", 0.0, TABOR_QUALITY_REFERENCE},
    {48000.0, 0, 77, "instructions", "77", 0.0, TABOR_INSTRUCTIONS_AVX512},
  };
  const TaborDrumDef def = physics_preset("frame-drum");
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    TaborModelOptions options;
    TaborModel *model;
    TaborError error;
    tabor_model_options_default(&options);
    options.sample_rate = wrong[i].rate;
    options.quality = wrong[i].quality;
    options.instructions = wrong[i].instructions;
    assert_int_equal(tabor_model_create(&def, &options, &model, &error), TABOR_ERROR_RANGE);
    assert_null(model);
    assert_int_equal(error.status, TABOR_ERROR_RANGE);
    assert_string_equal(error.key, wrong[i].key);
    assert_string_equal(error.value, wrong[i].value);
    assert_true(error.minimum == wrong[i].minimum && error.maximum == wrong[i].maximum);
    assert_non_null(strstr(error.message, wrong[i].value));
  }
}

static void expect_null(TaborStatus status, const TaborError *error, const char *message) {
  assert_int_equal(status, TABOR_ERROR_ARGUMENT);
  assert_int_equal(error->status, TABOR_ERROR_ARGUMENT);
  assert_string_equal(error->message, message);
}

static void what_is_null_is_named(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT), *none;
  TaborDrum *drum;
  TaborSwap *swap;
  TaborError error;
  expect_null(tabor_model_create(NULL, NULL, &none, &error), &error, "the definition is NULL");
  expect_null(tabor_model_create(&def, NULL, NULL, &error), &error,
              "the place for the model is NULL");
  expect_null(tabor_drum_create(NULL, &drum, &error), &error, "the model is NULL");
  expect_null(tabor_drum_create(model, NULL, &error), &error, "the place for the drum is NULL");
  expect_null(tabor_swap_create(NULL, model, &swap, &error), &error, "the old model is NULL");
  expect_null(tabor_swap_create(model, NULL, &swap, &error), &error, "the new model is NULL");
  expect_null(tabor_swap_create(model, model, NULL, &error), &error,
              "the place for the swap is NULL");
  expect_null(tabor_drum_def_preset(NULL, "tabor", &error), &error, "the definition is NULL");
  expect_null(tabor_drum_def_preset(&def, NULL, &error), &error, "the preset's name is NULL");
  tabor_model_release(model);
}

/* ---- what a build takes ---------------------------------------------------------------------- */

/* Of everything that costs time a legal extreme: minutes at live, hours at reference. */
static TaborDrumDef largest_drum(void) {
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.wires.count = 40;
  def.shell.radius = 0.6;
  def.quality.wire_points = 400;
  def.quality.two_way_bandwidth = 40000.0;
  def.quality.bandwidth = 40000.0;
  return def;
}

/* The memory, which a test can count, is right within the factor of 3 that the header promises. */
static size_t most_bytes, now_bytes;

enum { ALIGNMENT = 64 };

/* Stands before each block of memory. Not every system has an aligned allocation that free() takes
 * back. */
typedef struct Counted {
  void *start; /* of malloc() */
  size_t size;
} Counted;

static void *counted_allocate(size_t size, void *context) {
  (void)context;
  char *const start = malloc(size + sizeof(Counted) + ALIGNMENT);
  if (!start) return NULL;
  char *const least = start + sizeof(Counted);
  char *const memory = least + (ALIGNMENT - (uintptr_t)least % ALIGNMENT);
  ((Counted *)memory)[-1] = (Counted){start, size};
  now_bytes += size;
  if (now_bytes > most_bytes) most_bytes = now_bytes;
  return memory;
}

static void counted_release(void *memory, void *context) {
  (void)context;
  if (!memory) return;
  const Counted *const counted = (Counted *)memory - 1;
  now_bytes -= counted->size;
  free(counted->start);
}

static TaborModelOptions counted_options(uint32_t quality) {
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.quality = quality;
  options.allocator = (TaborAllocator){counted_allocate, counted_release, NULL};
  return options;
}

static void check_memory(const char *preset, uint32_t quality) {
  const TaborDrumDef def = physics_preset(preset);
  const TaborModelOptions options = counted_options(quality);
  TaborModelEstimate estimate;
  TaborModel *model = NULL;
  assert_int_equal(tabor_model_estimate(&def, &options, &estimate, NULL), TABOR_OK);
  most_bytes = now_bytes = 0;
  assert_int_equal(tabor_model_create(&def, &options, &model, NULL), TABOR_OK);
  print_message("%s, quality %u: estimated %.2g s, %.3g MB; took %.3g MB\n", preset, quality,
                estimate.seconds, 1e-6 * (double)estimate.bytes, 1e-6 * (double)most_bytes);
  assert_true(estimate.bytes > most_bytes / 3 && estimate.bytes < most_bytes * 3);
  tabor_model_release(model);
  assert_int_equal(now_bytes, 0);
}

static void memory_is_estimated_within_a_factor_of_3(void **state) {
  (void)state;
  static const char *const presets[] = {"snare-14x5.5", "tom-12", "bass-drum-22", "tabor"};
  for (size_t i = 0; i < sizeof presets / sizeof *presets; i++) {
    check_memory(presets[i], TABOR_QUALITY_LIVE);
  }
  check_memory("piccolo-13x3.5", TABOR_QUALITY_STUDIO);
}

static TaborModelEstimate estimate_of(const TaborDrumDef *def, uint32_t quality) {
  TaborModelOptions options;
  TaborModelEstimate estimate;
  TaborError error;
  tabor_model_options_default(&options);
  options.quality = quality;
  options.sample_rate = 192000.0;
  if (tabor_model_estimate(def, &options, &estimate, &error) != TABOR_OK)
    fail_msg("%s", error.message);
  return estimate;
}

/* More of anything takes longer; half of the parameter that is named takes less. */
static void the_dearest_parameter_is_named(void **state) {
  (void)state;
  TaborDrumDef def = largest_drum();
  const TaborModelEstimate most = estimate_of(&def, TABOR_QUALITY_REFERENCE);
  assert_true(most.seconds > 60.0);
  assert_true(most.seconds > estimate_of(&def, TABOR_QUALITY_LIVE).seconds);
  assert_string_equal(most.key, "wires.count");
  def.wires.count = 20;
  const TaborModelEstimate fewer = estimate_of(&def, TABOR_QUALITY_REFERENCE);
  assert_true(fewer.seconds < 0.7 * most.seconds && fewer.bytes < most.bytes);
  const TaborModelEstimate many_points = estimate_of(&def, TABOR_QUALITY_LIVE);
  def.quality.wire_points = 100;
  assert_true(estimate_of(&def, TABOR_QUALITY_LIVE).seconds < many_points.seconds);
}

/* A bass drum has no wires. At reference its model took 3.7 s, at half the two-way bandwidth 2.4 s,
 * and at half the bandwidth 3.7 s on one core. */
static void what_saves_nothing_is_not_named(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("bass-drum-22");
  const TaborModelEstimate most = estimate_of(&def, TABOR_QUALITY_REFERENCE);
  assert_string_equal(most.key, "quality.two_way_bandwidth");
  assert_true(estimate_of(&def, TABOR_QUALITY_LIVE).seconds < 0.5 * most.seconds);
}

static void a_limit_refuses_what_takes_more(void **state) {
  (void)state;
  const TaborDrumDef def = largest_drum();
  TaborModelOptions options;
  TaborModel *model = (TaborModel *)&options; /* anything but NULL */
  TaborError error;
  tabor_model_options_default(&options);
  options.sample_rate = 192000.0;
  options.quality = TABOR_QUALITY_REFERENCE;
  options.most_seconds = 10.0;
  assert_int_equal(tabor_model_create(&def, &options, &model, &error), TABOR_ERROR_LIMIT);
  assert_null(model);
  assert_string_equal(error.key, "wires.count");
  assert_non_null(strstr(error.message, "10 s"));
  assert_non_null(strstr(error.message, "lower wires.count"));
  options.most_seconds = 0.0;
  options.most_bytes = 100000000;
  assert_int_equal(tabor_model_create(&def, &options, &model, &error), TABOR_ERROR_LIMIT);
  assert_non_null(strstr(error.message, "100 MB"));
}

static TaborModelEstimate draft_estimate(const char *preset, const char *key, const char *value) {
  TaborDrumDef def = physics_preset(preset);
  TaborModelOptions options;
  TaborModelEstimate estimate;
  TaborError error;
  if (tabor_drum_def_set(&def, key, value, &error) != TABOR_OK) fail_msg("%s", error.message);
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_DRAFT;
  if (tabor_model_estimate(&def, &options, &estimate, &error) != TABOR_OK) {
    fail_msg("%s", error.message);
  }
  return estimate;
}

/* These took 3.4 s, 0.11 s and, for the pitch in the deep shell, 1.9 s on one core of a server. */
static void slow_air_and_pitches_in_deep_shells_are_estimated(void **state) {
  (void)state;
  const TaborModelEstimate slow = draft_estimate("marching-14x12", "air.sound_speed", "100");
  assert_true(slow.seconds > 3.4 / 3.0 && slow.seconds < 3.4 * 3.0);
  const TaborModelEstimate deep = draft_estimate("tom-12", "shell.depth", "1.5");
  assert_true(deep.seconds > 0.11 / 3.0 && deep.seconds < 0.11 * 3.0);
  TaborDrumDef def = physics_preset("tom-12");
  def.shell.depth = 1.5;
  def.batter.pitch = 630.0;
  TaborModelOptions options;
  TaborModelEstimate pitched;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_DRAFT;
  assert_int_equal(tabor_model_estimate(&def, &options, &pitched, NULL), TABOR_OK);
  assert_true(pitched.seconds > 1.9 / 3.0 && pitched.seconds < 1.9 * 3.0);
}

static bool wrong_estimate; /* all builds are said to take no time */

TaborStatus __real_tb_build_estimate(const TaborDrumDef *def, uint32_t quality, double sample_rate,
                                     const TaborAllocator *allocator, TaborModelEstimate *estimate,
                                     TaborError *error);
TaborStatus __wrap_tb_build_estimate(const TaborDrumDef *def, uint32_t quality, double sample_rate,
                                     const TaborAllocator *allocator, TaborModelEstimate *estimate,
                                     TaborError *error);
TaborStatus __wrap_tb_build_estimate(const TaborDrumDef *def, uint32_t quality, double sample_rate,
                                     const TaborAllocator *allocator, TaborModelEstimate *estimate,
                                     TaborError *error) {
  const TaborStatus status =
    __real_tb_build_estimate(def, quality, sample_rate, allocator, estimate, error);
  if (wrong_estimate) estimate->seconds = 0.0;
  return status;
}

/* A limit that every build exceeds, by an estimate that is too low: the search for a pitch is
 * ended, and so is what comes after it. */
static void a_limit_ends_what_was_estimated_too_low(void **state) {
  (void)state;
  for (int pitched = 0; pitched < 2; pitched++) {
    TaborDrumDef def = physics_preset("snare-14x5.5");
    TaborModelOptions options = counted_options(TABOR_QUALITY_DRAFT);
    TaborModel *model = NULL;
    TaborError error;
    if (pitched) def.batter.pitch = 200.0;
    options.most_seconds = 1e-6;
    now_bytes = 0;
    wrong_estimate = true;
    const TaborStatus status = tabor_model_create(&def, &options, &model, &error);
    wrong_estimate = false;
    assert_int_equal(status, TABOR_ERROR_LIMIT);
    assert_null(model);
    assert_int_equal(now_bytes, 0);
    assert_non_null(strstr(error.message, "longer to build than the limit of 1e-6 s: lower "));
    assert_non_null(tabor_parameter_find(error.key));
  }
}

/* ---- progress and cancellation --------------------------------------------------------------- */

typedef struct Listener {
  uint64_t calls, end; /* so far; the call that cancels, 0: none */
  double done;
} Listener;

static bool listen(double done, void *context) {
  Listener *listener = context;
  assert_true(done >= 0.0 && done <= 1.0);
  listener->done = done;
  return ++listener->calls != listener->end;
}

static TaborStatus build_with(Listener *listener, TaborModel **model) {
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  TaborModelOptions options = counted_options(TABOR_QUALITY_DRAFT);
  TaborError error;
  options.progress = listen;
  options.progress_context = listener;
  return tabor_model_create(&def, &options, model, &error);
}

/* At whichever call it is cancelled, a build ends there and gives all memory back. */
static void a_build_can_be_cancelled_anywhere(void **state) {
  (void)state;
  TaborModel *model = NULL;
  Listener whole = {0};
  now_bytes = 0;
  assert_int_equal(build_with(&whole, &model), TABOR_OK);
  assert_true(whole.calls > 1 && whole.done == 1.0);
  tabor_model_release(model);
  for (uint64_t i = 1; i < whole.calls; i++) {
    Listener cancelling = {.end = i};
    const TaborStatus status = build_with(&cancelling, &model);
    if (status == TABOR_OK) { /* it was so quick that it was never asked so often */
      assert_true(cancelling.calls < i || cancelling.done == 1.0);
      tabor_model_release(model);
      continue;
    }
    assert_int_equal(status, TABOR_ERROR_CANCELLED);
    assert_int_equal(cancelling.calls, i);
    assert_null(model);
    assert_int_equal(now_bytes, 0);
  }
}

/* In a vacuum J_m(z r/R) over the square root of its mass, sigma pi R^2 J_{m+1}(z)^2, half of that
 * for m > 0. */
static void the_shape_of_a_mode_is_its_bessel_function(void **state) {
  (void)state;
  static const struct {
    uint32_t m, n;
    double zero; /* of J_m: [DLMF] 10.21 */
  } modes[] = {{0, 1, 2.404825557695773}, {1, 1, 3.831705970207512}, {0, 2, 5.520078110286311}};
  TaborDrumDef def = physics_preset("frame-drum");
  def.air.density = 0.0;
  def.batter.bending_stiffness = 0.0;
  const double r = def.shell.radius;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborModeInfo info;
  uint32_t found = 0;
  double shape;
  for (uint32_t row = 0; tabor_model_mode(model, row, &info); row++) {
    for (uint32_t i = 0; i < sizeof modes / sizeof *modes; i++) {
      if (info.m != modes[i].m || info.n != modes[i].n) continue;
      const double slope = tb_bessel_j(info.m + 1, modes[i].zero);
      const double disc = def.batter.surface_density * 3.14159265358979323846 * r * r;
      const double mass = (info.m > 0 ? 0.5 : 1.0) * disc * slope * slope;
      for (double part = 0.0; part <= 1.0; part += 0.125) {
        assert_true(tabor_model_mode_shape(model, row, 0, part * r, &shape));
        const double expected = tb_bessel_j(info.m, modes[i].zero * part) / sqrt(mass);
        assert_true(fabs(fabs(shape) - fabs(expected)) < 1e-6 / sqrt(mass));
      }
      found++;
    }
  }
  assert_int_equal(found, 3);
  assert_false(tabor_model_mode_shape(model, 0, 1, 0.0, &shape));
  assert_false(tabor_model_mode_shape(model, 0, 0, 1.01 * r, &shape));
  assert_false(tabor_model_mode_shape(model, 0, 0, NAN, &shape));
  assert_false(tabor_model_mode_shape(model, UINT32_MAX, 0, 0.0, &shape));
  assert_true(shape == 0.0);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_shape_of_a_mode_is_its_bessel_function),
    cmocka_unit_test(options_out_of_range_are_named_with_their_value_and_range),
    cmocka_unit_test(what_is_null_is_named),
    cmocka_unit_test(memory_is_estimated_within_a_factor_of_3),
    cmocka_unit_test(the_dearest_parameter_is_named),
    cmocka_unit_test(what_saves_nothing_is_not_named),
    cmocka_unit_test(a_limit_refuses_what_takes_more),
    cmocka_unit_test(slow_air_and_pitches_in_deep_shells_are_estimated),
    cmocka_unit_test(a_limit_ends_what_was_estimated_too_low),
    cmocka_unit_test(a_build_can_be_cancelled_anywhere),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
