/* SPDX-License-Identifier: MIT */
/**
 * @file instrument.h
 * An instance of a plugin. instrument.c is its life and its runs, instrument_state.c what it saves.
 */
#ifndef TABOR_LV2_INSTRUMENT_H
#define TABOR_LV2_INSTRUMENT_H

#include <lv2/atom/atom.h>
#include <lv2/log/logger.h>
#include <lv2/state/state.h>
#include <lv2/urid/urid.h>
#include <lv2/worker/worker.h>

#include "lv2/plugin_player.h"
#include "lv2/ports.h"

/** What URIs are called in this host. */
typedef struct Urids {
  LV2_URID sequence, midi, atom_int, atom_float, atom_string;
  LV2_URID version, definition; /**< properties of states */
  LV2_URID controls[KNOB_KEYS]; /**< likewise */
} Urids;

typedef struct Instrument {
  Urids urids;
  LV2_Log_Logger logger;               /**< without a log of the host it says nothing */
  const LV2_Worker_Schedule *schedule; /**< or NULL: */
  pthread_t thread;                    /**< there is a thread of its own */
  bool has_thread;
  atomic_bool stops;
  bool asks; /**< somebody has to work */

  KnobRange ranges[KNOB_COUNT];
  const LV2_Atom_Sequence *events;
  PluginOutputs outputs;
  const float *freewheel;
  float *ready;
  const float *knob_ports[KNOB_COUNT];

  ModelWorker worker;
  PluginPlayer player;
} Instrument;

extern const LV2_State_Interface instrument_state;

#endif
