/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_host.h
 * A minimal host for the LV2 plugins: knobs, MIDI, runs, a worker, states in memory. Any failure
 * fails the test.
 */
#ifndef TABOR_TESTS_PLUGIN_HOST_H
#define TABOR_TESTS_PLUGIN_HOST_H

#include <lv2/atom/atom.h>
#include <lv2/core/lv2.h>
#include <lv2/log/log.h>
#include <lv2/state/state.h>
#include <lv2/urid/urid.h>
#include <lv2/worker/worker.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

#include "lv2/ports.h"
#include "plugin/kit_knobs.h"
#include "plugin/knobs.h"
#include "plugin_songs.h"

#define HOST_BLOCK 8192 /**< most frames of a run */
#define HOST_OUTPUTS PLUGIN_CHANNELS
#define HOST_ROOM 65536 /**< buffer for the events of a run [bytes] */
#define HOST_PROPERTIES 64

/** Executor of the work that the plugin schedules. */
typedef enum HostWorker {
  HOST_WITHOUT_WORKER, /**< none: the plugin uses a thread of its own */
  HOST_WORKER_THREAD,
  HOST_WORKER_AT_ONCE, /**< the thread that runs the plugin, within the request */
  HOST_WORKER_REFUSES  /**< none: every request fails for lack of space */
} HostWorker;

/** A property of a saved state. */
typedef struct HostProperty {
  char uri[128];
  uint32_t type, flags;
  size_t size;
  void *value;
} HostProperty;

typedef struct HostState {
  HostProperty properties[HOST_PROPERTIES];
  uint32_t count;
} HostState;

typedef struct PluginHost {
  const LV2_Descriptor *descriptor;
  LV2_Handle handle;
  const InstrumentKind *kind;
  bool is_kit;
  HostWorker worker;
  uint32_t outputs;
  float knobs[KNOB_COUNT], freewheel, ready;
  float kit_knobs[KIT_KNOB_COUNT]; /**< in place of knobs, of Tabor Kit */
  float sound[HOST_OUTPUTS][HOST_BLOCK];
  float input[2][HOST_BLOCK]; /**< of the effect, for the next run */
  union {
    LV2_Atom_Sequence sequence;
    uint64_t room[HOST_ROOM / 8];
  } events;
  LV2_Worker_Schedule scheduler;
  LV2_URID_Map urids;
  LV2_Log_Log log;
  char said[512];    /**< newest line of the log, or "" */
  uint64_t position; /**< frames run so far */
  pthread_t thread;
  atomic_uint asked, done; /**< calls of the worker */
  atomic_bool stops;
} PluginHost;

/** Maps a URI, the same for all hosts. Any thread. */
LV2_URID host_map(const char *uri);
/** host_map() with the signature of LV2's feature. */
LV2_URID host_map_feature(LV2_URID_Map_Handle handle, const char *uri);
/** Loads the plugin @p uri from the file @p binary. */
const LV2_Descriptor *host_descriptor(const char *binary, const char *uri);

/** Port number @p number of the plugin. */
Port host_port(const PluginHost *host, uint32_t number);
/** What the port of the knob is connected to. */
float *host_knob(PluginHost *host, uint32_t id);
/** Instantiates, connects all ports and activates at 48 kHz, with knobs at their defaults, but in
 * free air and with the stereo pair at 0 dB, as `tabor render --mic left --mic right` hears a
 * preset. */
PluginHost *host_open(const LV2_Descriptor *descriptor, HostWorker worker);
void host_close(PluginHost *host);
/** Adds an event for the next run; call in order of @p frame. */
void host_event(PluginHost *host, int64_t frame, uint32_t size, const void *bytes);
/** Adds a note for the next run. */
void host_note(PluginHost *host, int64_t frame, uint8_t key, uint8_t velocity);
/** Adds a patch:Set of property @p uri to a file, for the next run. */
void host_set_path(PluginHost *host, int64_t frame, const char *uri, const char *path);
/** Removes the events of the next run. */
void host_clear(PluginHost *host);
/** Runs with the added events and removes them. */
void host_run(PluginHost *host, uint32_t frames);
/** Runs until the plugin is ready, whether it sounds or not, 20 s at most. */
void host_wait(PluginHost *host);
/**
 * Plays @p count messages, in order of frames that count from now, until @p frames have been played
 * into
 * @p sound, [channel][frame]. Runs have @p block frames; 0: random sizes from 0 to HOST_BLOCK.
 */
void host_play(PluginHost *host, const HostMessage *messages, size_t count, uint32_t frames,
               uint32_t block, float *const *sound);

/** Saves the state. Free with host_state_free(). */
void host_save(PluginHost *host, HostState *state);
LV2_State_Status host_restore(PluginHost *host, const HostState *state);
void host_state_free(HostState *state);
/** Finds a property; NULL if there is none. */
HostProperty *host_property(HostState *state, const char *uri);
/** Adds a property or replaces its value. */
void host_set_property(HostState *state, const char *uri, const char *type, const void *value,
                       size_t size);

/** Largest absolute value of @p count samples. */
double host_peak(const float *samples, uint32_t count);
/** Returns the next random number, at least 0 and below 1. */
double host_random(uint64_t *state);

#endif
