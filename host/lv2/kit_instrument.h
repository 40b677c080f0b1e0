/* SPDX-License-Identifier: MIT */
/**
 * @file kit_instrument.h
 * The LV2 plugin Tabor Kit. Its ports are all that a session saves: it has no other state. Kits are built in a thread of its
 * own.
 */
#ifndef TABOR_LV2_KIT_INSTRUMENT_H
#define TABOR_LV2_KIT_INSTRUMENT_H

#include <lv2/core/lv2.h>

extern const LV2_Descriptor kit_instrument;

#endif
