/* SPDX-License-Identifier: MIT */
/* Memory comes from where the caller says, and running out of it at any moment is an error like another. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tabor/tabor.h"

enum { ALIGNMENT = 64, MOST_ALLOCATIONS = 1000 };

/* Gives memory @p left times, then fails; counts what has not come back. */
typedef struct Supply {
  int left, taken;
} Supply;

static void *supply_allocate(size_t size, void *context) {
  Supply *supply = context;
  if (supply->left == 0) return NULL;
  supply->left--;
  supply->taken++;
  return aligned_alloc(ALIGNMENT, (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
}

static void supply_release(void *memory, void *context) {
  Supply *supply = context;
  if (memory) supply->taken--;
  free(memory);
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
  TaborError error;
  TaborStatus status = tabor_model_create(def, &options, &model, &error);
  if (status == TABOR_OK) status = tabor_drum_create(model, &drum, &error);
  if (status == TABOR_OK) status = tabor_swap_create(model, model, &swap, &error);
  if (status != TABOR_OK) {
    assert_int_equal(error.status, status);
    assert_true(error.message[0] != '\0');
  }
  tabor_swap_destroy(swap);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return status;
}

static void every_allocation_may_fail(void **state) {
  (void)state;
  TaborDrumDef def;
  assert_int_equal(tabor_drum_def_preset(&def, "tabor", NULL), TABOR_OK);
  int allowed = 0;
  for (; allowed < MOST_ALLOCATIONS; allowed++) {
    Supply supply = {.left = allowed};
    const TaborStatus status = build_everything(&def, &supply);
    assert_int_equal(supply.taken, 0);
    if (status == TABOR_OK) break;
    assert_int_equal(status, TABOR_ERROR_MEMORY);
  }
  assert_true(allowed > 0);
  assert_true(allowed < MOST_ALLOCATIONS);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(every_allocation_may_fail),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
