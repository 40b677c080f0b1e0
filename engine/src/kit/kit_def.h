/* SPDX-License-Identifier: MIT */
/* Kit definitions inside the engine. Set-up only. */
#ifndef TB_KIT_DEF_H
#define TB_KIT_DEF_H

#include "definition/def_key.h"
#include "definition/preset.h"
#include "tabor/kit.h"

/* The built-in kits: the files of kits/, written by engine/embed-presets.cmake. */
extern const TbPreset tb_kits[];
extern const uint32_t tb_kit_count;

/* Visits the keys of tabor_kit_def_key(), in order. Returns false if a visit returned false. */
bool tb_kit_walk_keys(const TaborKitDef *def, TbKeyVisit *visit, void *context);

/* A drum that carries the kit's room, since a drum's definition knows the keys of one. */
void tb_kit_carry_room(const TaborKitDef *def, TaborDrumDef *carrier);

/* Checks that `def` is not NULL and has this library's size. */
TaborStatus tb_kit_check_struct(const TaborKitDef *def, TaborError *error);

#endif
