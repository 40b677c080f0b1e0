/* SPDX-License-Identifier: MIT */
/* The built-in kits. */
#include <math.h>
#include <string.h>

#include "definition/def_text.h"
#include "definition/error.h"
#include "kit/kit_def.h"

uint32_t tabor_kit_count(void) { return tb_kit_count; }

const TaborKitInfo *tabor_kit(uint32_t index) {
  return index < tb_kit_count ? &tb_kits[index].info : NULL;
}

static TaborStatus refuse_kit(const char *name, TaborError *error) {
  const char *nearest = "";
  size_t smallest = SIZE_MAX;
  for (uint32_t i = 0; i < tb_kit_count; i++) {
    if (tb_word_is_nearer(name, tb_kits[i].info.name, &smallest)) nearest = tb_kits[i].info.name;
  }
  return tb_error_set(error, TABOR_ERROR_NAME, NULL, name, NAN, NAN, "unknown kit '%s'%s%s%s", name,
                      *nearest ? "; did you mean '" : "", nearest, *nearest ? "'?" : "");
}

static TaborStatus read_kit(const TbPreset *kit, TaborKitDef *def, TaborError *error) {
  TaborStatus status = TABOR_OK;
  tabor_kit_def_default(def);
  for (uint32_t i = 0; i < kit->pair_count && status == TABOR_OK; i++) {
    const TbPresetPair *const pair = &kit->pairs[i];
    status = pair->value ? tabor_kit_def_set(def, pair->key, pair->value, error)
                         : tabor_kit_def_section(def, pair->key, error);
  }
  return status; /* test_kit_def sees to it that it is never an error */
}

TaborStatus tabor_kit_def_preset(TaborKitDef *def, const char *name, TaborError *error) {
  if (!def) return tb_error_null(error, "kit definition");
  if (!name) return tb_error_null(error, "kit's name");
  for (uint32_t i = 0; i < tb_kit_count; i++) {
    if (strcmp(tb_kits[i].info.name, name) == 0) return read_kit(&tb_kits[i], def, error);
  }
  return refuse_kit(name, error);
}
