/* SPDX-License-Identifier: MIT */
/**
 * @file instance.h
 * An instance of an LV2 plugin: an instrument (plugin/instrument.h) in a host. instance.c creates,
 * runs and destroys it; state.c saves and restores what its ports do not say.
 */
#ifndef TABOR_LV2_INSTANCE_H
#define TABOR_LV2_INSTANCE_H

#include <lv2/core/lv2.h>
#include <lv2/state/state.h>

#include "lv2/host_features.h"
#include "lv2/midi_sequence.h"
#include "lv2/plugins.h"
#include "lv2/ports.h"
#include "lv2/set_path.h"
#include "plugin/worker_thread.h"

/** The numbers that the host has mapped the URIs to. */
typedef struct Urids {
  LV2_URID sequence, midi, atom_int, atom_float, atom_string;
  LV2_URID file;                       /**< property that the host sets */
  LV2_URID version, text;              /**< properties of a saved state */
  LV2_URID controls[INSTRUMENT_KNOBS]; /**< properties of a saved state, too */
  SetPathUrids set_path;
} Urids;

typedef struct Instance {
  size_t size;         /**< of this struct, and */
  const char *version; /**< of Tabor: by both the window knows whether it is of the same build */
  const Lv2Plugin *plugin;
  Instrument *instrument;
  Urids urids;
  HostFeatures host;
  WorkerThread thread; /**< if the host has no schedule */
  bool asks;           /**< a request waits for a worker */

  const LV2_Atom_Sequence *events;
  PluginBuffers buffers; /**< the ports */
  const float *freewheel;
  float *ready;
  const float *knob_ports[INSTRUMENT_KNOBS];
  MidiSequence messages; /**< that the run has not yet taken */
} Instance;

/** Plugin number @p number of the binary. */
extern const LV2_Descriptor instance_descriptors[INSTRUMENT_KINDS];
extern const LV2_State_Interface instance_state;

/** Writes an error line to the host's log. Any thread but the audio thread. */
static inline void instance_say(Instance *instance, const char *line) {
  (void)lv2_log_error(&instance->host.logger, "%s: %s\n", instance->instrument->kind->name, line);
}

#endif
