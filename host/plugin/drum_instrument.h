/* SPDX-License-Identifier: MIT */
/**
 * @file drum_instrument.h
 * Instruments that are one drum: Tabor, Tabor Multi and Tabor Rattle. Their variants are the
 * KnobSets.
 */
#ifndef TABOR_PLUGIN_DRUM_INSTRUMENT_H
#define TABOR_PLUGIN_DRUM_INSTRUMENT_H

#include "plugin/instrument.h"

extern const InstrumentCalls drum_instrument;

/** WORKER. The model that was built last, to be released by the caller; NULL if there is none. */
TaborModel *drum_instrument_model(Instrument *instrument);

#endif
