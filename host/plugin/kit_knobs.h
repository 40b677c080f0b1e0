/* SPDX-License-Identifier: MIT */
/**
 * @file kit_knobs.h
 * The controls of the plugin Tabor Kit: one table for the formats of plugins and the documentation. Symbols and the order
 * of knobs never change; new knobs come at the end.
 */
#ifndef TABOR_PLUGIN_KIT_KNOBS_H
#define TABOR_PLUGIN_KIT_KNOBS_H

#include <tabor/kit.h>

#include "base/realtime.h"
#include "plugin/own_kit.h"

/** Drums with an output, a level and a tuning of their own, in the order of the kit; later ones are in the mix alone. */
#define KIT_KNOB_DRUMS 8

typedef enum KitKnobId {
  KIT_KNOB_KIT,
  KIT_KNOB_QUALITY,
  KIT_KNOB_ROOM,
  KIT_KNOB_COUPLING,
  KIT_KNOB_OVERHEADS,
  KIT_KNOB_VELOCITY_CURVE,
  KIT_KNOB_VELOCITY_RANGE,
  KIT_KNOB_NOTES,
  KIT_KNOB_GAIN,
  KIT_KNOB_LEVEL,                                  /**< of the first drum; the others follow */
  KIT_KNOB_TUNE = KIT_KNOB_LEVEL + KIT_KNOB_DRUMS, /**< likewise */
  KIT_KNOB_COUNT = KIT_KNOB_TUNE + KIT_KNOB_DRUMS
} KitKnobId;

typedef struct KitKnob {
  const char *symbol, *name; /**< for files; displayed */
  const char *group;         /**< displayed */
  float minimum, maximum, fallback;
  const char *unit;    /**< "dB", "semitones", "" */
  const char *choices; /**< words separated by '|', for 0, 1, ...; or NULL */
  bool off;            /**< the minimum is "Off" */
  bool rebuilds;       /**< takes effect by building another kit */
  bool follows;        /**< which goes on with the drums that ring */
} KitKnob;

extern const KitKnob kit_knobs[KIT_KNOB_COUNT];

/** @p value within the range of a knob, of a choice a whole number; what is no number is the default. */
float kit_knob_clamp(KitKnobId id, double value) REALTIME;
/** Converts a level or gain [dB] to a factor: the lowest gives 0. */
double kit_knob_factor(KitKnobId id, float value) REALTIME;
#define KIT_KNOB_NONE (-120.0) /**< [dB] of a kit's own value: nothing at all */
/** What becomes of a kit's own value @p own [dB], at least @p least, beside a knob. */
double kit_knob_beside(KitKnobId id, float value, double own, double least) REALTIME;
/** Writes a value with its unit as a text; its length, or a negative number. */
int kit_knob_text(KitKnobId id, float value, char *text, size_t size);
/** True for the value of KIT_KNOB_KIT, its last, that stands for the user's own kit. */
bool kit_knob_is_own(float kit) REALTIME;
/** SET-UP. The kit that a value of KIT_KNOB_KIT stands for; the usual one in place of the user's own while there is none. */
TaborStatus kit_knob_kit(float kit, OwnKit *own, TaborKitDef *def, TaborError *error);
/** SET-UP. The kit that the knobs describe. A drum that cannot be tuned so far stays as its preset has it. */
TaborStatus kit_knobs_define(const float values[KIT_KNOB_COUNT], OwnKit *own, TaborKitDef *def,
                             TaborError *error);

#endif
