/* SPDX-License-Identifier: MIT */
/**
 * @file kit_instrument.h
 * The instrument that is a kit: Tabor Kit.
 */
#ifndef TABOR_PLUGIN_KIT_INSTRUMENT_H
#define TABOR_PLUGIN_KIT_INSTRUMENT_H

#include "plugin/instrument.h"
#include "plugin/own_kit.h"

extern const InstrumentCalls kit_instrument;

/** ANY but AUDIO. The kit of the user's. */
OwnKit *kit_instrument_own(Instrument *instrument);

#endif
