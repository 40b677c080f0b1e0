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

TaborStatus tabor_kit_def_preset(TaborKitDef *def, const char *name, TaborError *error) {
  if (!def) return tb_error_null(error, "kit definition");
  if (!name) return tb_error_null(error, "kit's name");
  for (uint32_t i = 0; i < tb_kit_count; i++) {
    const TbPreset *const kit = &tb_kits[i];
    if (strcmp(kit->info.name, name) != 0) continue;
    return tabor_kit_def_read(def, kit->text, kit->size, error);
  }
  return refuse_kit(name, error);
}
