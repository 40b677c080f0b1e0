/* SPDX-License-Identifier: MIT */
#include "model/body_kind.h"

#include "bodies/drum/drum_modes.h"

const TbBodyKind *tb_body_kind(const TaborDrumDef *def) {
  (void)def;
  return &tb_body_drum;
}
