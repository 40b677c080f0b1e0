/* SPDX-License-Identifier: MIT */
/**
 * @file instrument.h
 * A plugin without its format: what Tabor, Tabor Multi, Tabor Rattle and Tabor Kit are to a host.
 * The shells of the formats know this alone. drum_instrument.c and kit_instrument.c have the two
 * sorts.
 *
 * An instrument is there from beginning to end with its knobs, its own drum or kit, and what passes
 * between it and its window; it sounds while it is open, at one sample rate.
 *
 * Threads: MAIN is one that the host has for all but sound, WORKER any but the audio thread,
 * several at once. What says nothing is MAIN.
 */
#ifndef TABOR_PLUGIN_INSTRUMENT_H
#define TABOR_PLUGIN_INSTRUMENT_H

#include <stdatomic.h>

#include "kit/kit_threads.h"
#include "midi/midi_map.h"
#include "plugin/builder.h"
#include "plugin/definition.h"
#include "plugin/knob.h"
#include "plugin/plugin_buffers.h"
#include "plugin/window_link.h"

#define INSTRUMENT_KNOBS 32         /**< room for the knobs of any instrument */
#define INSTRUMENT_PATH 4096        /**< longest path of a file, with its terminator */
#define INSTRUMENT_MESSAGE 1024     /**< room for a line that says what is wrong */
#define INSTRUMENT_LEAST_RATE 22050 /**< [Hz] at which instruments sound, and the highest */
#define INSTRUMENT_MOST_RATE 192000

/** An output of the instrument: channels of its block, from `first` on. */
typedef struct InstrumentOutput {
  const char *name;
  uint32_t first, channels;
} InstrumentOutput;

/** What a hand or a session has set: the knobs, and the drum that is played. */
typedef struct InstrumentSetting {
  float values[INSTRUMENT_KNOBS]; /**< of the knobs */
  float seen[INSTRUMENT_KNOBS];   /**< of those that the drum was noted with: where they stood then;
                                     NaN: unknown */
  TaborDrumDef def;               /**< of an instrument that is one drum */
} InstrumentSetting;

typedef struct Instrument Instrument;
typedef struct InstrumentCalls InstrumentCalls;

typedef enum InstrumentKindId {
  INSTRUMENT_STEREO, /**< one drum, a pair */
  INSTRUMENT_MULTI,  /**< one drum, an output per microphone */
  INSTRUMENT_KIT,
  INSTRUMENT_EFFECT, /**< one drum before a loudspeaker */
  INSTRUMENT_KINDS
} InstrumentKindId;

/** A plugin, as it stands in a host's list. */
typedef struct InstrumentKind {
  InstrumentKindId id;
  const char *name, *brief, *comment; /**< displayed: a name, a line, and what it does */
  const InstrumentCalls *calls;
  uint32_t variant;  /**< which of those that the calls have */
  bool has_input;    /**< stereo sound comes in */
  uint32_t channels; /**< of all outputs */
  uint32_t output_count;
  const InstrumentOutput *outputs; /**< the first is what is heard, in stereo */
  uint32_t knob_count;
  const Knob *knobs;     /**< by their ids */
  const uint32_t *order; /**< ids in the order of ports, where new ones come last; NULL: by ids */
  uint32_t main_knob;    /**< takes another drum or kit */
  uint32_t seen_count;   /**< number of knobs, the first ones, that a drum is noted with */
  const KnobGroup *groups;
  uint32_t group_count;
  const KnobPage *pages;
  uint32_t page_count;
  const TaborPresetInfo *(*preset)(uint32_t place); /**< a built-in drum or kit */
  uint32_t (*preset_count)(void);
} InstrumentKind;

extern const InstrumentKind instrument_kinds[INSTRUMENT_KINDS];

struct Instrument {
  const InstrumentKind *kind;
  void (*say)(void *context, const char *line); /**< to the host's log; WORKER and MAIN; or NULL */
  void *context;
  const KitPool *pool;    /**< the host's threads: set before it is open; or NULL */
  bool has_movable_knobs; /**< the shell can move the host's knobs: set before it is open */
  KnobRange ranges[INSTRUMENT_KNOBS];
  _Atomic float values[INSTRUMENT_KNOBS];  /**< of the knobs, in their own units */
  _Atomic float offsets[INSTRUMENT_KNOBS]; /**< by which the host modulates them, on the knob's way
                                              if it is bent */
  atomic_bool has_moved;                   /**< a knob has, of which the host does not know */
  atomic_bool is_renamed;                  /**< notes have other names */
  atomic_bool is_offline;                  /**< the host renders, and is in no hurry */
  double rate;
  bool is_open;     /**< changes only while no block is played */
  Builder *builder; /**< of its models */

  PluginBuffers buffers; /**< AUDIO: of the block */
  uint32_t at;           /**< AUDIO: frames of it that were played */
  WindowLink window;

  atomic_uint file_phase;     /**< whose the path is */
  char file[INSTRUMENT_PATH]; /**< that was asked for */
};

/** The two sorts of instruments. A call that is NULL does nothing, or says no. */
struct InstrumentCalls {
  size_t size; /**< of the whole, which begins with an Instrument */
  bool (*has_knob)(const InstrumentKind *kind, uint32_t id) REALTIME;
  bool (*is_modulated)(uint32_t id) REALTIME; /**< whether hosts may modulate the knob */
  /** Of a part that the drum has. */
  bool (*has_part)(const InstrumentSetting *setting, uint32_t id);
  bool (*begin)(Instrument *instrument); /**< with its ranges; false if memory is short */
  void (*end)(Instrument *instrument);

  bool (*open)(Instrument *instrument, double rate); /**< false if memory is short */
  void (*close)(Instrument *instrument);             /**< while no worker works */
  void (*work)(Instrument *instrument);              /**< WORKER. Does what there is to do */

  /* A drum or kit as a whole. */
  void (*note)(Instrument *instrument, InstrumentSetting *setting);      /**< all but the knobs */
  void (*use)(Instrument *instrument, const InstrumentSetting *setting); /**< likewise */
  /** Fills a setting that says nothing. */
  void (*blank)(Instrument *instrument, InstrumentSetting *setting);
  /** What sessions have to save besides knobs, terminated, to be freed by the caller; NULL:
   * nothing, or memory is short. */
  char *(*text)(Instrument *instrument, const InstrumentSetting *setting);
  /** Reads such a text. False, with a line in @p message of INSTRUMENT_MESSAGE bytes. */
  bool (*read)(Instrument *instrument, const char *text, size_t length, InstrumentSetting *setting,
               char *message);
  /** Puts a built-in drum or kit, or one of a file, into a setting, with the knobs where they are
   * with it. */
  bool (*load)(Instrument *instrument, const char *name, bool is_file, InstrumentSetting *setting,
               char *message);
  /** The drum or kit that a setting and its knobs say. False: memory is short. */
  bool (*define)(Instrument *instrument, const InstrumentSetting *setting, Definition *definition);
  /** Puts an edited one into a setting, with the knobs where they are with it. False, with a line
   * in @p message of INSTRUMENT_MESSAGE bytes. */
  bool (*redefine)(Instrument *instrument, const Definition *definition, InstrumentSetting *setting,
                   char *message);
  /** The name of what the main knob takes, if sessions have it in place of a number; and the other
   * way round. */
  const char *(*name)(float value);
  bool (*find)(const char *name, float *value);
  double (*tail)(const Instrument *instrument); /**< [s] until it has died away */
  /** Names what a note plays; false if it plays nothing. */
  bool (*name_note)(Instrument *instrument, uint32_t note, char *name, size_t size);

  /* AUDIO */
  void (*rest)(Instrument *instrument) REALTIME; /**< brings all to rest; knobs stay */
  void (*begin_block)(Instrument *instrument) REALTIME;
  void (*export_sound)(Instrument *instrument,
                       bool exports) REALTIME;      /**< the quality may be one for export */
  void (*receive)(Instrument *instrument) REALTIME; /**< takes what was built */
  bool (*ask)(Instrument *instrument)
    REALTIME; /**< asks for what the knobs want; true: a worker has to run */
  void (*end_leaving)(Instrument *instrument) REALTIME; /**< what leaves makes room at once */
  void (*turn)(Instrument *instrument, uint32_t id, float value) REALTIME;
  void (*modulate)(Instrument *instrument, uint32_t id, float offset) REALTIME;
  /** Says once that a knob stands at *asked, and that the drum has *given. */
  bool (*take_given)(Instrument *instrument, uint32_t id, float *asked, float *given) REALTIME;
  void (*begin_frame)(Instrument *instrument) REALTIME;
  void (*choke)(Instrument *instrument, int key,
                uint32_t frame) REALTIME; /**< a negative key: all */
  void (*take)(Instrument *instrument, const MidiMessage *message, uint32_t frame) REALTIME;
  void (*end_frame)(Instrument *instrument, uint32_t frame) REALTIME;
  bool (*is_full)(
    const Instrument *instrument) REALTIME; /**< of messages: play before there are more */
  void (*play)(Instrument *instrument,
               uint32_t end) REALTIME; /**< up to frame @p end of the block */
  /** On a thread of the pool: a part of what is being played. */
  void (*play_part)(Instrument *instrument, uint32_t part);
  void (*strike)(Instrument *instrument, const WindowStroke *stroke) REALTIME;
  void (*show)(Instrument *instrument) REALTIME;             /**< the window what has been played */
  bool (*is_ready)(const Instrument *instrument) REALTIME;   /**< what sounds is what is wanted */
  bool (*is_there)(const Instrument *instrument) REALTIME;   /**< what was restored last sounds */
  bool (*is_settled)(const Instrument *instrument) REALTIME; /**< and nothing more is under way */
  bool (*is_silent)(const Instrument *instrument) REALTIME;
};

/* ---- beginning and end ---------------------------------------------------------------------- */

/** Creates an instrument with its knobs at their defaults. NULL if memory is short. */
Instrument *instrument_create(const InstrumentKind *kind);
/** Ignores NULL. */
void instrument_destroy(Instrument *instrument);
/** Closes it, and opens it at another rate, if that is one at which it sounds; else the log says
 * why it is silent. False if memory is short. */
bool instrument_open(Instrument *instrument, double rate);
void instrument_close(Instrument *instrument);
/** Writes an error line to the host's log. WORKER and MAIN. */
void instrument_say(const Instrument *instrument, const char *line);
/** WORKER. Loads the file that was asked for, if one was, and builds what there is to build. */
void instrument_work(void *instrument);

/* ---- knobs ---------------------------------------------------------------------------------- */

/** ANY. The id of knob number @p number in the order of ports; knob_count if this instrument has
 * none there. */
uint32_t instrument_knob(const InstrumentKind *kind, uint32_t number) REALTIME;
/** ANY. The id of the knob at @p place among those that it has; knob_count past the last. */
uint32_t instrument_knob_at(const InstrumentKind *kind, uint32_t place) REALTIME;
/** The number of a knob in the order of ports. */
uint32_t instrument_number(const InstrumentKind *kind, uint32_t id);
uint32_t instrument_knob_count(const InstrumentKind *kind);
/** Page number @p place of those that it has, NULL past the last: it has all knobs of a page or
 * none, but for a knob that other pages have as well. */
const KnobPage *instrument_page(const InstrumentKind *kind, uint32_t place);
/** Knob number @p place of a page, of those that it has; knob_count past the last. */
uint32_t instrument_knob_on_page(const InstrumentKind *kind, const KnobPage *page, uint32_t place);
/** Displayed name of a knob's group. */
const char *instrument_group_name(const InstrumentKind *kind, uint32_t id);
/** ANY. Sets a knob to @p value, within its range; what is no number does nothing. */
void instrument_set(Instrument *instrument, uint32_t id, double value) REALTIME;
/** ANY. The same for all knobs. */
void instrument_set_all(Instrument *instrument, const float values[INSTRUMENT_KNOBS]);

/* ---- settings ------------------------------------------------------------------------------- */

/** Notes all. A knob of which the drum does not know where it stood has not been turned since. */
void instrument_note(Instrument *instrument, InstrumentSetting *setting);
/** AUDIO. Asks for the drum or kit of a file, whose path has @p length bytes. False: the last one
 * is not yet loaded, or the path is too long. */
bool instrument_ask_file(Instrument *instrument, const char *path, size_t length) REALTIME;

/* ---- AUDIO ---------------------------------------------------------------------------------- */

/** Begins a block; instrument->buffers are those of the block. */
void instrument_begin_block(Instrument *instrument) REALTIME;
/** Lets the knobs act at the next frame that is played. */
void instrument_turn_knobs(Instrument *instrument) REALTIME;
/** True if nothing is to be built or loaded. */
bool instrument_is_settled(const Instrument *instrument) REALTIME;

#endif
