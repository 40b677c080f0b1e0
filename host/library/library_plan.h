/* SPDX-License-Identifier: MIT */
/**
 * @file library_plan.h
 * Which sounds a sample library has: every velocity at every place, in several takes.
 *
 * Places have keys of their own, the notes that play the head of a drum here (docs/midi.md), from the
 * centre outwards: any place can follow any other at once, from pads, keyboards and patterns alike,
 * where a key switch would have to be thrown between two strokes and be remembered in every pattern.
 */
#ifndef TABOR_HOST_LIBRARY_PLAN_H
#define TABOR_HOST_LIBRARY_PLAN_H

#include <stdbool.h>

#include "base/message.h"
#include "midi/midi_speed.h"
#include "strokes/humanize.h"

#define LIBRARY_MOST_POSITIONS 8
#define LIBRARY_MOST_TAKES 32
#define LIBRARY_MOST_SOUNDS 4096
#define LIBRARY_TECHNIQUES 2

/** A technique that libraries have: the keys of its places. */
typedef struct LibraryTechnique {
  const char *name;
  TaborTechnique technique;
  uint32_t up; /**< its keys are so many semitones above those of the head */
} LibraryTechnique;

extern const LibraryTechnique library_techniques[LIBRARY_TECHNIQUES];

/** What a library is asked to have. */
typedef struct LibraryShape {
  uint32_t velocities; /**< 1 to 127, the first 1 and the last 127 of MIDI's */
  uint32_t
    positions;    /**< from the centre to 80 % of the head's radius; of one, the preset's place */
  uint32_t takes; /**< of each */
  bool techniques[LIBRARY_TECHNIQUES]; /**< which of library_techniques */
  MidiResponse response;
  Humanizer humanizer; /**< of the takes, in the order of the sounds */
} LibraryShape;

/** One sound: a stroke and a file. */
typedef struct LibrarySound {
  char *file; /**< its name in the library's folder */
  const LibraryTechnique *technique;
  uint32_t key;       /**< MIDI note */
  uint32_t low, high; /**< MIDI velocities that it stands for */
  uint32_t midi;      /**< the one that it was played with */
  uint32_t take;      /**< from 1 */
  uint32_t
    radius_share;   /**< of the place, in per cent of the head's radius, before it is scattered */
  TaborEvent event; /**< the stroke, scattered */
} LibrarySound;

/** By technique, then place, velocity, take. Begins as {0}. */
typedef struct LibraryPlan {
  LibraryShape shape;
  LibrarySound *sounds;
  size_t count;
} LibraryPlan;

/** How many sounds that makes. */
uint32_t library_count(const LibraryShape *shape);
/**
 * Plans the sounds of @p def; their files' names begin with @p preset's. Free with library_plan_free(),
 * whatever the outcome.
 */
Outcome library_plan_make(const TaborDrumDef *def, const char *preset, const LibraryShape *shape,
                          LibraryPlan *plan);
void library_plan_free(LibraryPlan *plan);
/** What files of @p preset begin with: letters, digits and '.', '-', '_'; to be freed. */
char *library_stem(const char *preset);

#endif
