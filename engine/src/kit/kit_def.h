/* SPDX-License-Identifier: MIT */
/* Kit definitions inside the engine. Set-up only. */
#ifndef TB_KIT_DEF_H
#define TB_KIT_DEF_H

#include "definition/preset.h"
#include "tabor/kit.h"

/* The built-in kits: the files of kits/, written by engine/embed-presets.cmake. */
extern const TbPreset tb_kits[];
extern const uint32_t tb_kit_count;

/* Checks that `def` is not NULL and has this library's size. */
TaborStatus tb_kit_check_struct(const TaborKitDef *def, TaborError *error);

#endif
