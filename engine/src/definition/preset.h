/* SPDX-License-Identifier: MIT */
/**
 * @file preset.h
 * The built-in presets: a table of the files of presets/, written by engine/embed-presets.cmake
 * when the library is built.
 */
#ifndef TABOR_SRC_PRESET_H
#define TABOR_SRC_PRESET_H

#include "tabor/tabor.h"

typedef struct TbPreset {
  TaborPresetInfo info;
  const char *text; /**< for tabor_drum_def_read() or tabor_kit_def_read(); no terminator */
  size_t size;
} TbPreset;

extern const TbPreset tb_presets[];
extern const uint32_t tb_preset_count;

/** A row of a table by its name. NULL, with an error that calls it a @p what and suggests a similar
 * name, if there is none. */
const TbPreset *tb_preset_find(const TbPreset *table, uint32_t count, const char *what,
                               const char *name, TaborError *error);

#endif /* TABOR_SRC_PRESET_H */
