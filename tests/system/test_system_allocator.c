/* SPDX-License-Identifier: MIT */
/* Memory comes from where the caller says, and running out of it at any moment is an error like
 * another. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tabor/tabor.h"
#include "windows_names.h"

enum { ALIGNMENT = 64, PLENTY = 1000000, EDGE = 40, SAMPLES = 100 };

/* Gives memory @p left times, then fails; counts what has not come back. */
typedef struct Supply {
  int left, taken;
} Supply;

static void *supply_allocate(size_t size, void *context) {
  Supply *supply = context;
  if (supply->left == 0) return NULL;
  supply->left--;
  supply->taken++;
  return aligned_memory(ALIGNMENT, size);
}

static void supply_release(void *memory, void *context) {
  Supply *supply = context;
  if (memory) supply->taken--;
  free_aligned_memory(memory);
}

/* Makes everything that allocates and takes it down again; the first error, or TABOR_OK. */
static TaborStatus build_everything(const TaborDrumDef *def, Supply *supply) {
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_DRAFT;
  options.allocator = (TaborAllocator){supply_allocate, supply_release, supply};
  TaborModel *model = NULL;
  TaborDrum *drum = NULL;
  TaborSwap *swap = NULL;
  TaborView *view = NULL;
  TaborError error;
  TaborStatus status = tabor_model_create(def, &options, &model, &error);
  if (status == TABOR_OK) status = tabor_drum_create(model, &drum, &error);
  if (status == TABOR_OK) status = tabor_swap_create(model, model, &swap, &error);
  if (status == TABOR_OK) status = tabor_view_create(model, NULL, &view, &error);
  if (status != TABOR_OK) {
    assert_int_equal(error.status, status);
    assert_true(error.message[0] != '\0');
  }
  tabor_view_destroy(view);
  tabor_swap_destroy(swap);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return status;
}

static void assert_fails_without_a_trace(const TaborDrumDef *def, int allowed) {
  Supply supply = {.left = allowed};
  assert_int_equal(build_everything(def, &supply), TABOR_ERROR_MEMORY);
  assert_int_equal(supply.taken, 0);
}

/* The first and the last ones, and an even spread between: there are thousands. */
static void any_allocation_may_fail(void **state) {
  (void)state;
  TaborDrumDef def;
  assert_int_equal(tabor_drum_def_preset(&def, "tabor", NULL), TABOR_OK);
  assert_int_equal(tabor_drum_def_set(&def, "batter.pitch", "F4", NULL),
                   TABOR_OK); /* tuned first */
  Supply supply = {.left = PLENTY};
  assert_int_equal(build_everything(&def, &supply), TABOR_OK);
  assert_int_equal(supply.taken, 0);
  const int needed = PLENTY - supply.left;
  assert_true(needed > 0);
  const int stride = needed / SAMPLES + 1;
  for (int allowed = 0; allowed < needed; allowed++) {
    const bool near_edge = allowed < EDGE || allowed >= needed - EDGE;
    if (near_edge || allowed % stride == 0) assert_fails_without_a_trace(&def, allowed);
  }
}

/* Memory of one allocator may not go to another. */
static void half_an_allocator_is_refused(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  for (int half = 0; half < 2; half++) {
    TaborModelOptions options;
    tabor_model_options_default(&options);
    options.allocator =
      (TaborAllocator){half ? supply_allocate : NULL, half ? NULL : supply_release, NULL};
    TaborModel *model = NULL;
    TaborError error;
    assert_int_equal(tabor_model_create(&def, &options, &model, &error), TABOR_ERROR_ARGUMENT);
    assert_null(model);
    assert_non_null(strstr(error.message, "allocator"));
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(half_an_allocator_is_refused),
    cmocka_unit_test(any_allocation_may_fail),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
