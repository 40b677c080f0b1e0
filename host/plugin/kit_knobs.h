/* SPDX-License-Identifier: MIT */
/**
 * @file kit_knobs.h
 * The controls of Tabor Kit. The order of knobs is that of ports and never changes; new knobs come
 * at the end.
 */
#ifndef TABOR_PLUGIN_KIT_KNOBS_H
#define TABOR_PLUGIN_KIT_KNOBS_H

#include <tabor/kit.h>

#include "plugin/knob.h"
#include "plugin/own_kit.h"

/** Drums with an output, a level and a tuning of their own, in the order of the kit; later ones are
 * in the mix alone. */
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
  KIT_KNOB_HUMANIZE = KIT_KNOB_TUNE + KIT_KNOB_DRUMS,
  KIT_KNOB_COUNT
} KitKnobId;

enum { KIT_KNOB_GROUPS = 3, KIT_KNOB_PAGES = 4 };

extern const Knob kit_knobs[KIT_KNOB_COUNT];
extern const KnobGroup kit_knob_groups[KIT_KNOB_GROUPS];
extern const KnobPage kit_knob_pages[KIT_KNOB_PAGES];

KnobRange kit_knob_range(KitKnobId id);
#define KIT_KNOB_NONE (-120.0) /**< [dB] of a kit's own value: nothing at all */
/** What becomes of a kit's own value @p own [dB], at least @p least, beside a knob. */
double kit_knob_beside(KitKnobId id, float value, double own, double least) REALTIME;
/** True for the value of KIT_KNOB_KIT, its last, that stands for the user's own kit. */
bool kit_knob_is_own(float kit) REALTIME;
/** SET-UP. The kit that a value of KIT_KNOB_KIT stands for; the usual one in place of the user's
 * own while there is none. */
TaborStatus kit_knob_kit(float kit, OwnKit *own, TaborKitDef *def, TaborError *error);
/** SET-UP. The kit that the knobs describe. A drum that cannot be tuned so far stays as its preset
 * has it. */
TaborStatus kit_knobs_define(const float values[KIT_KNOB_COUNT], OwnKit *own, TaborKitDef *def,
                             TaborError *error);

#endif
