/* SPDX-License-Identifier: MIT */
#include "definition/preset.h"
#include "definition/def_text.h"
#include "definition/error.h"

#include <math.h>
#include <string.h>

uint32_t tabor_preset_count(void) { return tb_preset_count; }

const TaborPresetInfo *tabor_preset(uint32_t index) {
  return index < tb_preset_count ? &tb_presets[index].info : NULL;
}

static const char *nearest_name(const TbPreset *table, uint32_t count, const char *name) {
  const char *nearest = "";
  size_t smallest = SIZE_MAX;
  for (uint32_t i = 0; i < count; i++) {
    const char *const candidate = table[i].info.name;
    if (tb_word_is_nearer(name, candidate, &smallest)) nearest = candidate;
  }
  return nearest;
}

const TbPreset *tb_preset_find(const TbPreset *table, uint32_t count, const char *what,
                               const char *name, TaborError *error) {
  for (uint32_t i = 0; i < count; i++) {
    if (strcmp(table[i].info.name, name) == 0) return &table[i];
  }
  const char *const nearest = nearest_name(table, count, name);
  (void)tb_error_set(error, TABOR_ERROR_NAME, NULL, name, NAN, NAN, "unknown %s '%s'%s%s%s", what,
                     name, *nearest ? "; did you mean '" : "", nearest, *nearest ? "'?" : "");
  return NULL;
}
