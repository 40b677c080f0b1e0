/* SPDX-License-Identifier: MIT */
/**
 * @file host_calls.h
 * What an instance asks of its host when something has changed that the host did not. MAIN: all
 * functions.
 */
#ifndef TABOR_CLAP_HOST_CALLS_H
#define TABOR_CLAP_HOST_CALLS_H

#include "clap/instance.h"

/** Tells that knobs have moved. */
void host_rescan(const Instance *instance);
/** A block has to ask for what a session, a preset or a knob wants. */
void host_wake(const Instance *instance);
/** Takes a setting, knobs and all, and tells the host. */
void host_use(const Instance *instance, const InstrumentSetting *setting);

#endif
