/* SPDX-License-Identifier: MIT */
/* The kind of body that a definition describes. A new kind is a folder of bodies/ and a row here.
 */
#ifndef TB_BODY_KIND_H
#define TB_BODY_KIND_H

#include "bodies/body.h"

const TbBodyKind *tb_body_kind(const TaborDrumDef *def);

#endif
