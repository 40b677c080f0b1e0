/* SPDX-License-Identifier: MIT */
/**
 * @file instrument.h
 * An instance of Tabor, Tabor Multi or Tabor Rattle. instrument.c creates, runs and destroys it; instrument_state.c saves and restores it.
 */
#ifndef TABOR_LV2_INSTRUMENT_H
#define TABOR_LV2_INSTRUMENT_H

#include <lv2/core/lv2.h>
#include <lv2/state/state.h>

#include "lv2/host_features.h"
#include "lv2/midi_sequence.h"
#include "lv2/ports.h"
#include "plugin/plugin_run.h"
#include "plugin/window_link.h"
#include "plugin/worker_thread.h"

/** The numbers that the host has mapped the URIs to. */
typedef struct Urids {
  LV2_URID sequence, midi, atom_int, atom_float, atom_string;
  LV2_URID version, definition; /**< properties of a saved state */
  LV2_URID controls[KNOB_SEEN]; /**< properties of a saved state, too */
} Urids;

typedef struct Instrument {
  size_t size;         /**< of this struct, and */
  const char *version; /**< of Tabor: by both the window knows whether it is of the same build */
  KnobSet set;
  KnobRange ranges[KNOB_COUNT];
  Urids urids;
  HostFeatures host;
  WorkerThread thread; /**< if the host has no schedule */
  bool asks;           /**< a request waits for a worker */

  const LV2_Atom_Sequence *events;
  PluginOutputs outputs;
  const float *freewheel;
  float *ready;
  const float *knob_ports[KNOB_COUNT];
  MidiSequence messages; /**< that the run has not yet taken */

  ModelWorker worker;
  PluginPlayer player;
  WindowLink window;
} Instrument;

extern const LV2_Descriptor instrument_stereo, instrument_multi, instrument_effect;
extern const LV2_State_Interface instrument_state;

#endif
