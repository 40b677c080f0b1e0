/* SPDX-License-Identifier: MIT */
/**
 * @file knobs.h
 * The controls of the plugins of one drum: one table for all formats and the documentation.
 *
 * A knob for a key of the drum's definition takes its unit, its scale (linear or logarithmic) and
 * its range from the engine's parameter; the table may narrow the range. Its default comes from the
 * preset DEFAULT_PRESET: of a pitch, the one that the preset's tension gives. The drum keeps its
 * tension, to the bit, until the pitch is turned. Its symbol is the key with '_' for '.'. Symbols
 * never change, nor do the numbers of ports: new knobs go to the end of knob_ports.
 */
#ifndef TABOR_PLUGIN_KNOBS_H
#define TABOR_PLUGIN_KNOBS_H

#include <tabor/tabor.h>

#include "drums/default_preset.h"
#include "plugin/knob.h"

/** Knobs, those for keys first. */
typedef enum KnobId {
  KNOB_BATTER_TENSION,
  KNOB_RESONANT_TENSION,
  KNOB_BATTER_MUFFLING,
  KNOB_RESONANT_MUFFLING,
  KNOB_STRAINER,
  KNOB_WIRE_TENSION,
  KNOB_STICK_HARDNESS,
  KNOB_STRIKE_RADIUS,
  KNOB_STRIKE_ANGLE,
  KNOB_BATTER_PITCH,
  KNOB_RESONANT_PITCH,
  KNOB_UNEVENNESS,
  KNOB_DRUM, /**< a built-in preset, by its place in tabor_preset() */
  KNOB_VELOCITY_CURVE,
  KNOB_HUMANIZE,
  KNOB_QUALITY,
  KNOB_GAIN,
  KNOB_LEVEL_PAIR, /**< the levels, to KNOB_LEVEL_INSIDE: stereo plugin only */
  KNOB_LEVEL_TOP,
  KNOB_LEVEL_BOTTOM,
  KNOB_LEVEL_NEAR,
  KNOB_LEVEL_FAR,
  KNOB_LEVEL_INSIDE,
  KNOB_VELOCITY_RANGE,
  KNOB_STICK, /**< stick_choice.h */
  KNOB_ROOM,  /**< stereo plugin only, as the levels */
  KNOB_SOUND, /**< of the effect only, as those behind it */
  KNOB_MIX,
  KNOB_ENABLED, /**< 0: what comes in passes through */
  KNOB_COUNT
} KnobId;

#define KNOB_KEYS (KNOB_UNEVENNESS + 1) /**< number of knobs for keys */
/** Number of knobs of which a saved drum says where they stood: those for keys, and KNOB_DRUM. */
#define KNOB_SEEN (KNOB_DRUM + 1)

/** Knobs of a plugin. */
typedef enum KnobSet {
  KNOBS_MULTI,  /**< an output per microphone */
  KNOBS_STEREO, /**< also levels and a room */
  KNOBS_EFFECT  /**< also sound in, and a mix with it */
} KnobSet;

/** A value that a hand or MIDI has given; before that, the drum's own counts. */
typedef struct KnobTurn {
  bool is_turned;
  double value;
} KnobTurn;

static inline KnobTurn knob_turned(double value) REALTIME {
  return (KnobTurn){.is_turned = true, .value = value};
}
static inline double knob_turned_or(KnobTurn turn, double otherwise) REALTIME {
  return turn.is_turned ? turn.value : otherwise;
}

enum { KNOB_GROUPS = 8, KNOB_PAGES = 5 };

extern const Knob knobs[KNOB_COUNT];
extern const KnobGroup knob_groups[KNOB_GROUPS];
/** In the order in which they are turned over: the first has what players turn most. */
extern const KnobPage knob_pages[KNOB_PAGES];
/** All knobs, in the order of the ports. */
extern const uint32_t knob_ports[KNOB_COUNT];

/** True for the level of a microphone. */
static inline bool knob_is_level(KnobId id) REALTIME {
  return id >= KNOB_LEVEL_PAIR && id <= KNOB_LEVEL_INSIDE;
}

/** True for a knob that a plugin has. */
static inline bool knob_is_in(KnobSet set, KnobId id) REALTIME {
  if (id >= KNOB_SOUND && id <= KNOB_ENABLED) return set == KNOBS_EFFECT;
  return set != KNOBS_MULTI || !(knob_is_level(id) || id == KNOB_ROOM);
}

/** True for a knob that hosts may modulate: it is live, and a gain or a level. */
static inline bool knob_is_modulated(KnobId id) REALTIME {
  return knob_is_level(id) || id == KNOB_GAIN || (id < KNOB_KEYS && knobs[id].kind == KNOB_LIVE);
}

/** SET-UP. Range of a knob. @p usual is the definition of DEFAULT_PRESET. */
KnobRange knob_range(KnobId id, const TaborDrumDef *usual);
/** SET-UP. The same in a plugin: the effect is heard under the snares unless told otherwise. */
KnobRange knob_range_in(KnobSet set, KnobId id, const TaborDrumDef *usual);
/** The knob of the pitch that @p error refuses since the head cannot have it; KNOB_COUNT if it is
 * about something else. */
KnobId knob_of_refused_pitch(const TaborError *error);
/** The striker of the drum's default stroke. */
TaborStrikerDef *knob_usual_striker(TaborDrumDef *def);
/** True if the drum has the part that the knob turns. */
bool knob_has_part(TaborDrumDef *def, KnobId id);
/** The field of @p def for a knob with a key; NULL if the drum has no such part. */
double *knob_field(TaborDrumDef *def, KnobId id);
/** SET-UP. Turns a knob with a key in @p def. A value that this drum does not allow is passed over:
 * it was meant for another one. */
void knob_give(TaborDrumDef *def, KnobId id, double value);
/**
 * SET-UP. The value at which a knob below KNOB_SEEN shows the drum @p def; NaN if the drum has no
 * such part, or is not named like a built-in one. It is the field's, but a head without a pitch
 * shows the one that its tension gives. This takes some hundredths of a second.
 */
double knob_shown(const TaborDrumDef *def, KnobId id);

#endif
