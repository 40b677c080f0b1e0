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

static const TbPreset *find_preset(const char *name) {
  for (uint32_t i = 0; i < tb_preset_count; i++) {
    if (strcmp(tb_presets[i].info.name, name) == 0) return &tb_presets[i];
  }
  return NULL;
}

static const char *nearest_preset(const char *name) {
  const char *nearest = "";
  size_t smallest = SIZE_MAX;
  for (uint32_t i = 0; i < tb_preset_count; i++) {
    const char *const candidate = tb_presets[i].info.name;
    if (tb_word_is_nearer(name, candidate, &smallest)) nearest = candidate;
  }
  return nearest;
}

static TaborStatus refuse_preset(const char *name, TaborError *error) {
  const char *const nearest = nearest_preset(name);
  return tb_error_set(error, TABOR_ERROR_NAME, NULL, name, NAN, NAN, "unknown preset '%s'%s%s%s",
                      name, *nearest ? "; did you mean '" : "", nearest, *nearest ? "'?" : "");
}

TaborStatus tabor_drum_def_preset(TaborDrumDef *def, const char *name, TaborError *error) {
  if (!def) return tb_error_null(error, "definition");
  if (!name) return tb_error_null(error, "preset's name");
  const TbPreset *const preset = find_preset(name);
  if (!preset) return refuse_preset(name, error);
  return tabor_drum_def_read(def, preset->text, preset->size, error);
}
