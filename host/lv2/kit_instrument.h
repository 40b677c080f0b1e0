/* SPDX-License-Identifier: MIT */
/**
 * @file kit_instrument.h
 * The LV2 plugin Tabor Kit. Its ports are all that a session saves: it has no other state. Kits are built in a thread of its
 * own.
 */
#ifndef TABOR_LV2_KIT_INSTRUMENT_H
#define TABOR_LV2_KIT_INSTRUMENT_H

#include <lv2/core/lv2.h>

#include "lv2/host_features.h"
#include "lv2/midi_sequence.h"
#include "plugin/kit_window_link.h"
#include "plugin/worker_thread.h"

typedef struct KitInstrument {
  size_t size;         /**< of this struct, and */
  const char *version; /**< of Tabor: by both the window knows whether it is of the same build */
  HostFeatures host;
  LV2_URID sequence, midi; /**< numbers that the host has mapped URIs to */

  const LV2_Atom_Sequence *events;
  KitPluginOutputs outputs;
  const float *freewheel;
  float *ready;
  const float *knob_ports[KIT_KNOB_COUNT];

  KitWorker worker;
  WorkerThread thread;
  KitPluginPlayer player;
  KitWindowLink window;
} KitInstrument;

extern const LV2_Descriptor kit_instrument;

#endif
