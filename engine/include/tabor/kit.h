/* SPDX-License-Identifier: MIT */
/**
 * @file kit.h
 * Several drums that are played as one instrument, in one room, and hear each other.
 *
 * - A *kit definition* (TaborKitDef) is a plain struct: drums, where they stand, which notes play
 *   them, how loud they are in the mix. It has some 170 kB: allocate it.
 * - A *kit* (TaborKit) is the sounding instrument. It takes events that are addressed to drums and
 *   fills outputs: a stereo mix, each drum's part of it, each microphone.
 *
 * Places are in metres: x to the player's right, y away from the player, height above the floor. A
 * drum's place is the centre of its batter head.
 *
 * **The mix.** Two microphones hang over the kit, the overheads, and hear every drum from where
 * they are; a room answers what they hear. To their sound the mix adds one close microphone of each
 * drum, with a gain and a place between left and right.
 *
 * **Drums hear each other.** The sound pressure p of a drum falls with the distance r from its
 * centre as 1/r. Each other drum is pushed by it as by a source at that distance, after the sound's
 * way from head to head:
 *
 *   p_B(t) = c Sum_A (d/r_AB) p_A(t - t_AB),
 *
 * p_A what a microphone at the large distance d hears of drum A in the direction of the kit's
 * middle, and c the coupling. Drum B is pushed by the same weights by which it is heard there
 * (tabor_drum_process_sound()), so that two drums act on each other by the same numbers. The work
 * is booked as injected. Limits: of a drum only the one direction is taken; drums closer than their
 * own size have no near field, and their sound takes a third of a millisecond at least; the modes
 * up to the two-way bandwidth hear and are heard through their head's own motion, not hoops and
 * stands.
 *
 * A drum that sleeps is woken by the others' sound only if it has wires and the pressure reaches
 * `wake`, that is, if the wires may be lifted off their head. So a stroke on one drum does not make
 * all others cost processor time.
 *
 * Threads, errors and units are those of tabor.h.
 */
#ifndef TABOR_KIT_H
#define TABOR_KIT_H

#include <tabor/tabor.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TABOR_KIT_DRUMS 16              /**< drums of one kit */
#define TABOR_KIT_NOTES 128             /**< notes of MIDI */
#define TABOR_KIT_ALL UINT32_MAX        /**< address of an event that goes to every drum */
#define TABOR_KIT_MIX (UINT32_MAX - 1u) /**< address of an event for the kit's own values */
#define TABOR_KIT_NOTE                                                                             \
  0x1000u                   /**< address of an event for the sound of a note: this and the note */
#define TABOR_KIT_NEW 0xffu /**< a drum that goes on with none, for tabor_kit_follow() */
#define TABOR_KIT_OWN_MICS                                                                         \
  5 /**< a drum's own microphones in a kit at most; the kit adds three of its own */

/** @name Microphones that a kit adds to each drum: its overheads, and the one by which drums hear
 * each other */
/** @{ */
#define TABOR_KIT_LEFT "left"   /**< the left overhead */
#define TABOR_KIT_RIGHT "right" /**< the right overhead */
#define TABOR_KIT_AIR "kit"     /**< by which the other drums hear the drum */
/** @} */

/** The effect of a note on a drum. */
typedef enum TaborKitStroke {
  TABOR_KIT_STROKE_NONE,        /**< the note belongs to another drum or to none */
  TABOR_KIT_STROKE_HEAD,        /**< a stroke on the head */
  TABOR_KIT_STROKE_RIMSHOT,     /**< head and hoop at once */
  TABOR_KIT_STROKE_CROSS_STICK, /**< the stick lies on the head and strikes the hoop */
  TABOR_KIT_STROKE_RIM,         /**< the hoop alone */
  TABOR_KIT_STROKE_BUZZ,        /**< the stick is pressed until the note ends */
  TABOR_KIT_STROKE_SWEEP,       /**< a brush is drawn over the head until the note ends */
  TABOR_KIT_STROKE_BELL,        /**< of a cymbal: on its bell */
  TABOR_KIT_STROKE_BOW,         /**< of a cymbal: between bell and edge */
  TABOR_KIT_STROKE_EDGE,        /**< of a cymbal: on its edge */
  TABOR_KIT_STROKE_CLOSED,      /**< of a hi-hat: closed by the foot, on its bow */
  TABOR_KIT_STROKE_OPEN,        /**< of a hi-hat: opened by the foot, on its bow */
  TABOR_KIT_STROKE_PEDAL        /**< of a hi-hat: the foot stamps on the pedal */
} TaborKitStroke;

/** One drum of a kit. */
typedef struct TaborKitDrumDef {
  char name[TABOR_NAME_SIZE]; /**< 1 to TABOR_NAME_LENGTH letters, digits, '-' and '_' */
  TaborDrumDef def;           /**< the drum itself; its room is not used */
  double x;                   /**< place, to the right [m], -5 to 5 */
  double y;                   /**< place, away from the player [m], -5 to 5 */
  double height;              /**< of the batter head above the floor [m], 0.05 to 3, default 0.7 */
  /** Angle between the drum's axis and the vertical [deg], 0 to 180: 0, the default, is a head that
   * looks up, 90 the batter head of a bass drum. */
  double tilt;
  /** Direction to which a tilted batter head looks, seen from above [deg], -360 to 360, default
   * 270: to the player. */
  double facing;
  double gain; /**< of the close microphone in the mix [dB], -120 (none) to 24, default 0 */
  double pan;  /**< of the close microphone, -1 (left) to 1 (right), default 0 */
  double wake; /**< pressure at which others' sound wakes the drum if it has wires [Pa], 0 to 1000,
                  default 1 */
  uint32_t
    choke; /**< a stroke silences other drums of the same group; 0, the default: none, to 15 */
  char mic[TABOR_NAME_SIZE];      /**< name of its close microphone; "", the default: the first */
  uint8_t notes[TABOR_KIT_NOTES]; /**< a TaborKitStroke for each note */
} TaborKitDrumDef;

/**
 * A sound file that a note plays: what a kit does not model, as a hi-hat. The library does not read
 * files, it only keeps their names; the program that plays the kit gives it the sound
 * (tabor_kit_set_sample()). It is added to the mix; no drum hears it, and the room does not.
 */
typedef struct TaborKitNoteDef {
  char sample[TABOR_TEXT_SIZE]; /**< name of the file; "", the default: the note plays none */
  double gain;                  /**< of it [dB], -120 to 24, default 0 */
  uint32_t choke; /**< a stroke fades others of the same group; 0, the default: none, to 15 */
} TaborKitNoteDef;

/** A whole kit. Plain data. */
typedef struct TaborKitDef {
  uint32_t struct_size;          /**< set by tabor_kit_def_default() */
  char name[TABOR_NAME_SIZE];    /**< name of the kit */
  char comment[TABOR_TEXT_SIZE]; /**< description, one line */
  char license[TABOR_NAME_SIZE]; /**< licence of the definition */
  uint32_t coupled;              /**< 1, the default: drums hear each other; 0: they do not */
  double
    coupling; /**< how loud others are heard beside what physics says [dB], -60 to 24, default 0 */
  double overheads;  /**< gain of the overheads in the mix [dB], -120 (none) to 24, default 0 */
  double full_scale; /**< pressure at the overheads that gives 1.0 in the mix [Pa], 1e-3 to 1e5,
                        default 20 */
  double overhead_spacing;               /**< between the overheads [m], 0.1 to 5, default 1 */
  double overhead_x;                     /**< place of their middle, as of a drum [m], -5 to 5 */
  double overhead_y;                     /**< likewise [m], -5 to 5 */
  double overhead_height;                /**< above the floor [m], 0.3 to 5, default 1.6 */
  TaborRoomDef room;                     /**< around the kit; heard through the overheads */
  uint32_t drum_count;                   /**< 0 to TABOR_KIT_DRUMS; a kit that plays needs one */
  TaborKitDrumDef drum[TABOR_KIT_DRUMS]; /**< the drums */
  TaborKitNoteDef note[TABOR_KIT_NOTES]; /**< sound files by their notes of General MIDI */
} TaborKitDef;

/** A built-in kit: name for tabor_kit_def_preset(), description, and name of its text file in
 * kits/. */
typedef TaborPresetInfo TaborKitInfo;

/** @name Set-up: kit definitions
 * SET-UP: any thread but the audio thread. */
/** @{ */

/** Number of built-in kits. */
TABOR_API uint32_t tabor_kit_count(void);
/** Built-in kit @p index in listed order, from 0; NULL past the end. Static storage. */
TABOR_API const TaborKitInfo *tabor_kit(uint32_t index);

/** Sets every field to its default: no drums. */
TABOR_API void tabor_kit_def_default(TaborKitDef *def);
/** Loads the built-in kit @p name. TABOR_ERROR_NAME if there is none; the message suggests a
 * similar name. */
TABOR_API TaborStatus tabor_kit_def_preset(TaborKitDef *def, const char *name, TaborError *error);
/**
 * Sets one field from text. Keys are `kit.KEY` and `room.KEY`, as the fields above and those of
 * TaborRoomDef are called; `note.N.sample`, `note.N.gain` and `note.N.choke`; and `drum.NAME.KEY`,
 * where a new NAME adds a drum. KEY is
 *
 * - `preset`: the drum becomes this built-in preset, or with "none" what tabor_drum_def_clear()
 *   makes of it; place, mix and notes stay;
 * - a field of TaborKitDrumDef: `x`, `y`, `height`, `tilt`, `facing`, `gain`, `pan`, `wake`,
 *   `choke`, `mic`;
 * - `head`, `rimshot`, `cross-stick`, `rim`, `buzz`, `sweep`, `bell`, `bow`, `edge`: the notes that
 *   play it so, as "38, 40"; "" none;
 * - a key of the drum itself, as `batter.pitch`.
 *
 * `kit.coupling` takes "off", too. On an error @p def is unchanged: TABOR_ERROR_KEY,
 * TABOR_ERROR_VALUE, TABOR_ERROR_RANGE, TABOR_ERROR_NAME for an unknown preset, TABOR_ERROR_FULL
 * for a drum too many.
 */
TABOR_API TaborStatus tabor_kit_def_set(TaborKitDef *def, const char *key, const char *value,
                                        TaborError *error);
/** Begins a section of a kit file: `kit`, `room`, `note.N` or `drum.NAME`, which adds that drum.
 * TABOR_ERROR_KEY, TABOR_ERROR_FULL. */
TABOR_API TaborStatus tabor_kit_def_section(TaborKitDef *def, const char *section,
                                            TaborError *error);
/**
 * Writes the value of @p key, which tabor_kit_def_set() takes, to @p text, in at most @p size bytes
 * with the terminator; it reads back to the same bits. The value of `drum.NAME.preset` is the
 * built-in preset of the drum's own name if the drum has all parameters of it, otherwise "none".
 * TABOR_ERROR_NAME for a drum that the kit lacks; TABOR_ERROR_KEY; TABOR_ERROR_ARGUMENT if the text
 * does not fit, for which 2 * TABOR_TEXT_SIZE bytes are enough.
 */
TABOR_API TaborStatus tabor_kit_def_get(const TaborKitDef *def, const char *key, char *text,
                                        size_t size, TaborError *error);
/**
 * Writes full key @p index of @p def, from 0 in the order of kit files, to @p key, which has @p
 * size bytes. False past the last key, or if the key does not fit; 4 * TABOR_NAME_SIZE bytes are
 * enough. Notes without a sound file are skipped.
 */
TABOR_API bool tabor_kit_def_key(const TaborKitDef *def, uint32_t index, char *key, size_t size);
/**
 * Reads a definition from the text of a kit file: what tabor_kit_def_set() makes of each key, after
 * tabor_kit_def_default(). On an error @p def is unchanged: those of tabor_text_read(),
 * tabor_kit_def_set() and tabor_kit_def_section(). Rules that involve several fields are left to
 * tabor_kit_def_validate().
 */
TABOR_API TaborStatus tabor_kit_def_read(TaborKitDef *def, const char *text, size_t size,
                                         TaborError *error);
/** Writes a definition as the text of a kit file, which tabor_kit_def_read() reads back to the same
 * bits: parameters and errors as of tabor_drum_def_write(). */
TABOR_API TaborStatus tabor_kit_def_write(const TaborKitDef *def, uint32_t form, char *text,
                                          size_t size, size_t *length, TaborError *error);
/**
 * Checks ranges and rules: every drum by tabor_drum_def_validate(), one drum for each note, names
 * that differ. The message names the drum.
 */
TABOR_API TaborStatus tabor_kit_def_validate(const TaborKitDef *def, TaborError *error);
/** Index of the drum @p name, or -1. */
TABOR_API int tabor_kit_def_find(const TaborKitDef *def, const char *name);
/**
 * Writes to @p placed the definition of drum @p drum as it stands in the kit, for
 * tabor_model_create(): with the kit's own microphones in place of the preset's `left`, `right` and
 * `far`. TABOR_ERROR_ARGUMENT if there is no such drum; TABOR_ERROR_FULL if more than
 * TABOR_KIT_OWN_MICS microphones are left; TABOR_ERROR_NAME for a close microphone that it lacks;
 * TABOR_ERROR_RANGE for an overhead within the drum.
 */
TABOR_API TaborStatus tabor_kit_def_place(const TaborKitDef *def, uint32_t drum,
                                          TaborDrumDef *placed, TaborError *error);
/** @} */

/** A sounding kit. */
typedef struct TaborKit TaborKit;

/** Computes a drum of @p kit: for a TaborKitRun. */
typedef void TaborKitJob(void *kit, uint32_t drum);
/** Calls @p job(kit, drum) for each drum < @p count: see tabor_kit_set_runner(). */
typedef void TaborKitRun(void *context, TaborKitJob *job, void *kit, uint32_t count);

/**
 * Values of a kit that move while it plays: the `parameter` of a TABOR_EVENT_PARAMETER for
 * TABOR_KIT_MIX, whose `value` is in dB, within the range of the field in TaborKitDef; otherwise it
 * is dropped. A value is reached over 5 ms, or at once by a kit that has not played since it was
 * created or reset. tabor_kit_reset() brings back the definition's.
 */
typedef enum TaborKitParameter {
  TABOR_KIT_OVERHEADS, /**< gain of the overheads, -120 (none) to 24 */
  TABOR_KIT_COUPLING,  /**< how loud others are heard, -60 to 24, or -120: not at all. A kit with
                          `coupled` 0 drops it */
  TABOR_KIT_SAMPLES    /**< gain of the sounds of notes, -120 (none) to 24; at first, and after a
                          reset, 0 */
} TaborKitParameter;

/** An event of a drum. */
typedef struct TaborKitEvent {
  uint32_t drum; /**< index of the drum, TABOR_KIT_ALL, TABOR_KIT_MIX or TABOR_KIT_NOTE and a note;
                    another one: the event is dropped */
  /** As for tabor_drum_process(). For the sound of a note a stroke, whose `velocity` is its
   * strength from 0 to 1, the square of which is how loud it is, or a silence, which fades it and
   * others of its group within 15 ms; otherwise it is dropped. A note whose definition names a
   * file, but that was given no sound, is silent. */
  TaborEvent event;
} TaborKitEvent;

/** Outputs of a block. Any pointer may be NULL: that output is not computed. */
typedef struct TaborKitOutputs {
  float *stereo[2];                            /**< the mix, left and right */
  float *drum[TABOR_KIT_DRUMS][2];             /**< each drum's part of it, without the room */
  float *mic[TABOR_KIT_DRUMS][TABOR_MAX_MICS]; /**< microphones, in the order of the drum's placed
                                                  definition; TABOR_KIT_AIR is silent */
} TaborKitOutputs;

/** @name Set-up: kits
 * SET-UP: any thread but the audio thread. */
/** @{ */

/**
 * Creates a kit at rest.
 *
 * @param def     its definition, which is copied.
 * @param models  [def->drum_count]: the models of the drums, built from what tabor_kit_def_place()
 *                gives, at one sample rate and with one allocator. The kit keeps references. They
 *                may be built in parallel.
 * @param kit     receives the kit; NULL on an error.
 * @param error   says what is wrong; may be NULL.
 *
 * Errors: those of tabor_kit_def_validate() and tabor_room_create(), TABOR_ERROR_ARGUMENT for
 * models that do not fit, TABOR_ERROR_MEMORY.
 */
TABOR_API TaborStatus tabor_kit_create(const TaborKitDef *def, TaborModel *const *models,
                                       TaborKit **kit, TaborError *error);
/** Frees a kit. Ignores NULL. Swaps that are not done must be destroyed after it. */
TABOR_API void tabor_kit_destroy(TaborKit *kit);
/**
 * Lets the drums of a kit be computed on several threads: @p run is called within
 * tabor_kit_process(), some thousand times a second, and calls @p job once for each drum from 0 to
 * @p count - 1, in any order and on any threads, and returns when all are done. The sound does not
 * depend on it. NULL, the default: one after another on the caller's thread. The caller provides @p
 * run: for an audio thread it must not lock.
 */
TABOR_API void tabor_kit_set_runner(TaborKit *kit, TaborKitRun *run, void *context);
/**
 * Gives a note of a kit, which must not play meanwhile, its sound, with the gain and the group of
 * its definition.
 *
 * @param kit    the kit.
 * @param note   0 to TABOR_KIT_NOTES - 1.
 * @param left   [frames]: copied.
 * @param right  [frames], or NULL: the same as the left side.
 * @param frames number of frames; may be 0.
 * @param rate   of the sound, 1000 to 1e6 Hz; it is converted to that of the kit.
 * @param error  may be NULL. TABOR_ERROR_ARGUMENT, TABOR_ERROR_RANGE, TABOR_ERROR_MEMORY; the note
 * keeps the sound that it had.
 */
TABOR_API TaborStatus tabor_kit_set_sample(TaborKit *kit, uint32_t note, const float *left,
                                           const float *right, uint32_t frames, double rate,
                                           TaborError *error);
/**
 * Prepares that @p kit, which has not played yet, takes the place of the kit @p from, which plays:
 * so a kit's tuning, room, mix, places and drums change while it rings.
 *
 * @param kit   the follower.
 * @param from  the kit before. Until tabor_kit_take_over() no drum of it may be swapped.
 * @param drums [drum_count of @p kit]: drum of @p from that each drum goes on with, or
 *              TABOR_KIT_NEW. One that has the same model rings on as it is, to the bit; one of
 *              another model continues as by a swap (tabor_swap_create()).
 * @param error may be NULL. TABOR_ERROR_ARGUMENT for kits of two sample rates, a drum that is not
 *              there or asked for twice, or a kit that follows already; those of
 *              tabor_swap_create().
 */
TABOR_API TaborStatus tabor_kit_follow(TaborKit *kit, const TaborKit *from, const uint8_t *drums,
                                       TaborError *error);
/** @} */

/** @name Looking at kits
 * ANY: real-time safe. */
/** @{ */

/** The drum @p drum of a kit, for queries; NULL past the last. */
TABOR_API const TaborDrum *tabor_kit_drum(const TaborKit *kit, uint32_t drum);
/** The definition with which the kit was created. */
TABOR_API const TaborKitDef *tabor_kit_definition(const TaborKit *kit);
/** @} */

/** @name Kits on the audio thread
 * AUDIO: real-time safe; one thread at a time for one kit. */
/** @{ */

/**
 * Computes @p frames samples of all drums, the mix and the room.
 *
 * @param kit     the kit.
 * @param events  @p count events, sorted by frame; may be NULL when count is 0. A swap must be made
 *                for a model of a placed definition; only microphones with the kit's own names are
 *                mixed, and of a drum that lacks its close microphone the first.
 * @param count   number of events.
 * @param outputs where the sound goes; samples overwrite the arrays. NULL: nowhere.
 * @param frames  samples of each output; may be 0: all events then act at once.
 *
 * The output does not depend on the division into blocks. The latency is 0. The work is bounded:
 * each drum bounds its own as tabor_drum_process() says, and counts what it drops. A stroke
 * silences the other drums of its choke group even if its own drum drops it.
 */
TABOR_API void tabor_kit_process(TaborKit *kit, const TaborKitEvent *events, uint32_t count,
                                 const TaborKitOutputs *outputs, uint32_t frames);
/**
 * Lets @p kit take the place of @p from as tabor_kit_follow() has prepared it: its next frame is
 * the one that @p from would have played. Drums that go on ring on in @p kit, with their gains and
 * live values, and hear what is on its way to them; so does the room if it is the same, and so do
 * the sounds of notes if these are defined alike: @p kit needs none of its own then. Overheads and
 * coupling move to the values of the definition within 5 ms. Drums of @p from that are left, and a
 * room that is another one, ring on in @p from, which may be played beside @p kit as long as they
 * are to be heard. Does nothing if @p kit was not prepared for @p from.
 */
TABOR_API void tabor_kit_take_over(TaborKit *kit, TaborKit *from);
/** Number of strokes on notes with a sound that still sound. */
TABOR_API uint32_t tabor_kit_sounds(const TaborKit *kit);
/** True if every drum, the room and all sounds of notes are silent: the outputs are then exactly 0
 * until the next event. */
TABOR_API bool tabor_kit_is_silent(const TaborKit *kit);
/** Brings all drums and the room to rest, by tabor_drum_reset() and tabor_room_reset(): the kit is
 * as a new one. */
TABOR_API void tabor_kit_reset(TaborKit *kit);
/** Number of events that were addressed to no drum of the kit. The drums' own statistics count
 * those that drums dropped. */
TABOR_API uint64_t tabor_kit_dropped(const TaborKit *kit);
/** Number of bytes that tabor_kit_state_save() writes; it changes with the drums' models. */
TABOR_API size_t tabor_kit_state_size(const TaborKit *kit);
/** Writes the whole state to @p bytes. A kit of the same definition and models continues from it
 * with the same bits. */
TABOR_API void tabor_kit_state_save(const TaborKit *kit, void *bytes);
/** Restores a saved state. If the bytes are damaged or belong to another kit, it returns
 * TABOR_ERROR_STATE and the kit is as it was, or at rest. */
TABOR_API TaborStatus tabor_kit_state_load(TaborKit *kit, const void *bytes, size_t size);
/** @} */

#ifdef __cplusplus
}
#endif

#endif /* TABOR_KIT_H */
