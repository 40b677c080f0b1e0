/* SPDX-License-Identifier: MIT */
/* What the binary exports: the list of its plugins. */
#include "lv2/instance.h"

LV2_SYMBOL_EXPORT const LV2_Descriptor *lv2_descriptor(uint32_t index) {
  return index < INSTRUMENT_KINDS ? &instance_descriptors[index] : NULL;
}
