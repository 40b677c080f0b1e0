/* SPDX-License-Identifier: MIT */
/* What tabor_model_create() and its like refuse, and how they say it. */
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

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(options_out_of_range_are_named_with_their_value_and_range),
    cmocka_unit_test(what_is_null_is_named),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
