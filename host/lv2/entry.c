/* SPDX-License-Identifier: MIT */
/* What the binary exports: the list of its plugins. */
#include "lv2/instrument.h"
#include "lv2/kit_instrument.h"

LV2_SYMBOL_EXPORT const LV2_Descriptor *lv2_descriptor(uint32_t index) {
  const LV2_Descriptor *const plugins[] = {&instrument_stereo, &instrument_multi, &kit_instrument,
                                           &instrument_effect};
  return index < sizeof plugins / sizeof plugins[0] ? plugins[index] : NULL;
}
