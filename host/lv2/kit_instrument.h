/* SPDX-License-Identifier: MIT */
/**
 * @file kit_instrument.h
 * The LV2 plugin Tabor Kit. kit_instrument.c creates, runs and destroys it; kit_instrument_state.c saves and restores what
 * its ports do not say: the user's own kit. Kits are built in a thread of its own.
 */
#ifndef TABOR_LV2_KIT_INSTRUMENT_H
#define TABOR_LV2_KIT_INSTRUMENT_H

#include <lv2/core/lv2.h>
#include <lv2/state/state.h>

#include "lv2/host_features.h"
#include "lv2/midi_sequence.h"
#include "lv2/set_path.h"
#include "plugin/kit_window_link.h"
#include "plugin/worker_thread.h"

typedef struct KitInstrument {
  size_t size;         /**< of this struct, and */
  const char *version; /**< of Tabor: by both the window knows whether it is of the same build */
  HostFeatures host;
  LV2_URID sequence, midi, file, state, atom_string; /**< the host's numbers for URIs */
  SetPathUrids set_path;

  const LV2_Atom_Sequence *events;
  KitPluginOutputs outputs;
  const float *freewheel;
  float *ready;
  const float *knob_ports[KIT_KNOB_COUNT];

  OwnKit own;
  KitWorker worker;
  WorkerThread thread;
  KitPluginPlayer player;
  KitWindowLink window;
} KitInstrument;

extern const LV2_Descriptor kit_instrument;
extern const LV2_State_Interface kit_instrument_state;

/** Writes an error line to the host's log. Any thread but the audio thread. */
static inline void kit_instrument_say(KitInstrument *kit, const char *line) {
  (void)lv2_log_error(&kit->host.logger, "Tabor Kit: %s\n", line);
}

#endif
