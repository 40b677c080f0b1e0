/* SPDX-License-Identifier: MIT */
/**
 * @file clap_host.h
 * A minimal host for the CLAP plugins: parameters, notes, blocks, states in memory. Any failure
 * fails the test.
 */
#ifndef TABOR_TESTS_CLAP_HOST_H
#define TABOR_TESTS_CLAP_HOST_H

#include <clap/clap.h>

#include "clap/instance.h"
#include "host_threads.h"
#include "midi/midi_stream.h"
#include "plugin/kit_knobs.h"
#include "plugin/knobs.h"

#define CLAP_BLOCK 8192 /**< most frames of a block */
#define CLAP_EVENTS 1024
#define CLAP_CHANNELS 18   /**< most channels of all outputs */
#define CLAP_PORTS 9       /**< most outputs */
#define CLAP_STATE 1200000 /**< most bytes of a state */

typedef union ClapEvent {
  clap_event_header_t header;
  clap_event_note_t note;
  clap_event_note_expression_t expression;
  clap_event_param_value_t value;
  clap_event_param_mod_t modulation;
  clap_event_midi_t midi;
} ClapEvent;

typedef struct ClapHost {
  clap_host_t host;
  const clap_plugin_t *plugin;
  bool stereo, is_active;
  HostThreads *threads;                    /**< that the plugin may use, or NULL; the user's */
  bool refuses_threads;                    /**< from now on */
  uint32_t port_count, widths[CLAP_PORTS]; /**< outputs, and channels of each */
  ClapEvent events[CLAP_EVENTS];           /**< of the next block, in order of time */
  uint32_t event_count, ended; /**< ended: number of note ends that the plugin has sent */
  bool has_input;
  float input[2][CLAP_BLOCK];             /**< of an effect, for the next block */
  float sound[CLAP_CHANNELS][CLAP_BLOCK]; /**< left and right first, then the other outputs */
  char said[512];                         /**< newest line of the log, or "" */
  char loaded[64],
    refused[512]; /**< key of the newest preset, and newest complaint about one; or "" */
  uint32_t rescans, requests,
    callbacks; /**< of the values of all parameters; for blocks; for the main thread */
  clap_process_status status; /**< of the newest block */
  uint32_t timers;            /**< that run */
  uint32_t menus;             /**< of parameters that the plugin has asked for, and the newest */
  clap_id menu_of;
  uint32_t turns, gestures; /**< values and begins of gestures that the plugin has told of */
  clap_id turned;           /**< the newest of these parameters, and its value */
  double turned_to;
} ClapHost;

typedef struct ClapState {
  char bytes[CLAP_STATE];
  size_t size, at;
} ClapState;

/** The entry of the file @p binary. */
const clap_plugin_entry_t *clap_host_entry(const char *binary);
/** Whether kits have sounds of files, which take libsndfile at run time. */
bool clap_host_has_sound_files(void);
/** Creates the plugin @p id at its defaults; not active. */
ClapHost *clap_host_open(const clap_plugin_entry_t *entry, const char *id);
/** The same with a host that has threads for plugins. */
ClapHost *clap_host_open_threaded(const clap_plugin_entry_t *entry, const char *id,
                                  HostThreads *threads);
/** The first with a host that has no extensions, as hosts that scan have none. */
ClapHost *clap_host_scan(const clap_plugin_entry_t *entry, const char *id);
void clap_host_close(ClapHost *host);
/** Activates at 48 kHz. */
void clap_host_activate(ClapHost *host);
void clap_host_deactivate(ClapHost *host);
void clap_host_render(ClapHost *host, bool offline); /**< the render mode */
const void *clap_host_extension(const ClapHost *host, const char *id);

/** Id of the parameter of a knob. */
clap_id clap_host_id(KnobId knob);
/** The parameter's value at which the pitch of a head is @p hertz. */
double clap_host_pitch(double hertz);
/** Adds an event for the next block; call in order of time. */
void clap_host_set_id(ClapHost *host, uint32_t time, clap_id id, double value);
void clap_host_set(ClapHost *host, uint32_t time, KnobId knob, double value);
/** Value of the quality knob, whose first place is draft, for a TaborQuality. */
#define CLAP_QUALITY(quality) ((quality)-TABOR_QUALITY_DRAFT)
void clap_host_modulate(ClapHost *host, uint32_t time, KnobId knob, double amount);
void clap_host_midi(ClapHost *host, uint32_t time, const MidiMessage *message);
void clap_host_note(ClapHost *host, uint32_t time, uint16_t type, int16_t key, double velocity);
void clap_host_express(ClapHost *host, uint32_t time, clap_note_expression what, int16_t key,
                       double value);
/** Lets an inactive plugin take the added events. */
void clap_host_flush(ClapHost *host);
/** Value of a parameter. */
double clap_host_value(const ClapHost *host, KnobId knob);
/** Plays a block with the added events. */
void clap_host_run(ClapHost *host, uint32_t frames);

void clap_host_save(ClapHost *host, ClapState *state);
bool clap_host_load(ClapHost *host, ClapState *state);
/** The same in a context of CLAP's, as CLAP_STATE_CONTEXT_FOR_PRESET. */
bool clap_host_load_in(ClapHost *host, ClapState *state, uint32_t context);

#endif
