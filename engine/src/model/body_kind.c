/* SPDX-License-Identifier: MIT */
#include "model/body_kind.h"

#include "bodies/drum/drum_modes.h"
#include "bodies/plate/plate_modes.h"

const TbBodyKind *tb_body_kind(const TaborDrumDef *def) {
  static const TbBodyKind *const KINDS[] = {
    [TABOR_BODY_DRUM] = &tb_body_drum,
    [TABOR_BODY_PLATE] = &tb_body_plate,
    [TABOR_BODY_HIHAT] = &tb_body_plate,
  };
  return KINDS[def->body.kind];
}
