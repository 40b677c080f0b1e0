/* SPDX-License-Identifier: MIT */
/**
 * @file library_plan.h
 * Plans the sounds of a sample library: every velocity at every position, in several takes.
 *
 * Each position has its own key, from the centre outwards; the keys are the notes for the head
 * (docs/midi.md). So any position can follow any other at once, from pads, keyboards and patterns.
 * A key switch would need an extra note between two strokes, in every pattern.
 */
#ifndef TABOR_HOST_LIBRARY_PLAN_H
#define TABOR_HOST_LIBRARY_PLAN_H

#include <stdbool.h>

#include "base/message.h"
#include "midi/midi_speed.h"
#include "midi/midi_stream.h"
#include "strokes/humanize.h"

#define LIBRARY_MOST_POSITIONS 8
#define LIBRARY_MOST_TAKES 32
#define LIBRARY_MOST_SOUNDS 4096
#define LIBRARY_TECHNIQUES 5

/** A technique of libraries, with the keys of its positions. */
typedef struct LibraryTechnique {
  const char *name;
  TaborTechnique technique;
  int up;      /**< semitones of its keys above the keys of the head */
  bool places; /**< whether its strokes differ by their place on the head */
} LibraryTechnique;

extern const LibraryTechnique library_techniques[LIBRARY_TECHNIQUES];

/** The requested contents of a library. */
typedef struct LibraryShape {
  uint32_t velocities; /**< number of velocities, 1 to 127, spread over MIDI's 1 to 127 */
  /** From the centre to 80 % of the head's radius; a single one is the preset's position. */
  uint32_t positions;
  uint32_t takes;                      /**< per velocity and position */
  bool techniques[LIBRARY_TECHNIQUES]; /**< which of library_techniques are wanted */
  MidiResponse response;
  Humanizer humanizer; /**< scatter of the takes, in the order of the sounds */
} LibraryShape;

/** One sound: a stroke and a file. */
typedef struct LibrarySound {
  char *file;                /**< its name in the library's folder */
  const char *technique;     /**< its name, or the name of a kit's stroke */
  uint8_t keys[MIDI_VALUES]; /**< MIDI notes that play it */
  uint32_t key_count;        /**< 1 of a single drum */
  uint32_t low, high;        /**< range of MIDI velocities that it serves */
  uint32_t midi;             /**< MIDI velocity that it is played with */
  uint32_t take;             /**< from 1 */
  /** Radius of the position [% of the head's], before the scatter. */
  uint32_t radius_share;
  uint32_t drum;    /**< of a kit; otherwise 0 */
  TaborEvent pedal; /**< what moves the pedal of a hi-hat first; type 0: nothing */
  TaborEvent event; /**< the stroke, after the scatter */
} LibrarySound;

/** Sounds in order of drum, technique, position, velocity, take. Initialise with {0}. */
typedef struct LibraryPlan {
  LibraryShape shape;
  LibrarySound *sounds;
  size_t count;
} LibraryPlan;

/** Number of sounds of a shape. */
uint32_t library_count(const LibraryShape *shape);
/** Velocities of layer @p layer of @p layers: the one that it is played with, and those that it
 * serves. */
void library_set_layer(LibrarySound *sound, uint32_t layer, uint32_t layers);
/**
 * Plans the sounds of @p def; file names start with library_stem() of @p preset. Free with
 * library_plan_free(), whatever the outcome.
 */
Outcome library_plan_make(const TaborDrumDef *def, const char *preset, const LibraryShape *shape,
                          LibraryPlan *plan);
void library_plan_free(LibraryPlan *plan);
/** Start of the file names of @p preset: letters, digits and '.', '-', '_'. The caller frees it. */
char *library_stem(const char *preset);

#endif
