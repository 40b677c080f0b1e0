/* SPDX-License-Identifier: MIT */
/**
 * @file instrument.h
 * An instance of a plugin. instrument.c creates, runs and destroys it; instrument_state.c saves and restores it.
 */
#ifndef TABOR_LV2_INSTRUMENT_H
#define TABOR_LV2_INSTRUMENT_H

#include <lv2/atom/atom.h>
#include <lv2/log/logger.h>
#include <lv2/state/state.h>
#include <lv2/urid/urid.h>
#include <lv2/worker/worker.h>

#include "lv2/ports.h"
#include "lv2/sequence.h"
#include "plugin/plugin_run.h"
#include "plugin/worker_thread.h"

/** The numbers that the host has mapped the URIs to. */
typedef struct Urids {
  LV2_URID sequence, midi, atom_int, atom_float, atom_string;
  LV2_URID version, definition; /**< properties of a saved state */
  LV2_URID controls[KNOB_KEYS]; /**< properties of a saved state, too */
} Urids;

typedef struct Instrument {
  Urids urids;
  LV2_Log_Logger logger;               /**< silent if the host has no log */
  const LV2_Worker_Schedule *schedule; /**< of the host, or NULL */
  WorkerThread thread;                 /**< without a schedule */
  bool asks;                           /**< a request waits for a worker */

  const LV2_Atom_Sequence *events;
  PluginOutputs outputs;
  const float *freewheel;
  float *ready;
  const float *knob_ports[KNOB_COUNT];
  Sequence sequence; /**< events that the run has not yet taken */
  uint32_t frames;   /**< of the run */

  ModelWorker worker;
  PluginPlayer player;
} Instrument;

extern const LV2_State_Interface instrument_state;

#endif
