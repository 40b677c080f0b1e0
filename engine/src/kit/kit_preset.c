/* SPDX-License-Identifier: MIT */
/* The built-in kits. */
#include "definition/error.h"
#include "kit/kit_def.h"

uint32_t tabor_kit_count(void) { return tb_kit_count; }

const TaborKitInfo *tabor_kit(uint32_t index) {
  return index < tb_kit_count ? &tb_kits[index].info : NULL;
}

TaborStatus tabor_kit_def_preset(TaborKitDef *def, const char *name, TaborError *error) {
  if (!def) return tb_error_null(error, "kit definition");
  if (!name) return tb_error_null(error, "kit's name");
  const TbPreset *const kit = tb_preset_find(tb_kits, tb_kit_count, "kit", name, error);
  if (!kit) return TABOR_ERROR_NAME;
  return tabor_kit_def_read(def, kit->text, kit->size, error);
}
