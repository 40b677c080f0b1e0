/* SPDX-License-Identifier: MIT */
/**
 * @file knobs.h
 * The controls of the plugins: one table for the plugin, its description in Turtle, and the documentation.
 *
 * A knob for a key of the drum's definition takes its unit, its scale (linear or logarithmic) and its range
 * from the engine's parameter; the table may narrow the range. Its default comes from the preset
 * DEFAULT_PRESET: of a pitch, the one that the preset's tension gives. The drum keeps its tension, to the bit, until
 * the pitch is turned. Its symbol is the key with '_' for '.'. Symbols never change, nor do the numbers of ports:
 * new knobs go to the end of knob_ports.
 */
#ifndef TABOR_PLUGIN_KNOBS_H
#define TABOR_PLUGIN_KNOBS_H

#include <tabor/tabor.h>

#include "base/realtime.h"
#include "drums/default_preset.h"

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

/** How a knob takes effect. */
typedef enum KnobKind {
  KNOB_LIVE,    /**< by a parameter event */
  KNOB_REBUILD, /**< by building another model */
  KNOB_STROKE,  /**< on later strokes */
  KNOB_SETTING  /**< in the plugin, outside the drum */
} KnobKind;

/** How a knob's value is shown, see knob_text.h. */
typedef enum KnobScale {
  KNOB_IN_UNITS,    /**< the number and its unit */
  KNOB_IN_NOTES,    /**< a frequency as a note and cents */
  KNOB_IN_PER_CENT, /**< of the value 1 or, on a logarithmic scale, of the way */
  KNOB_IN_ROOTS     /**< per cent of the way, with a quarter of the range in the lower half */
} KnobScale;

typedef struct Knob {
  const char *symbol; /**< symbol of the port */
  const char *name;   /**< displayed name */
  const char *key;    /**< key of the definition, "batter.tension"; or NULL */
  const char *group;  /**< symbol of its group */
  KnobKind kind;
  double minimum, maximum; /**< range; NaN: the engine's */
  double fallback;         /**< default; NaN: the preset's */
  const char *unit;        /**< unit; NULL: the engine's */
  const char *mic;         /**< the microphone whose level it is, or NULL */
  const char *choices;     /**< words separated by '|', for 0, 1, ...; or NULL */
  double least;            /**< KnobRange.least, or 0 */
  double off;              /**< value that switches the knob off, or NaN */
  const char *off_word;    /**< its name; NULL: "Off" */
  const char *top_word;    /**< name of the maximum, or NULL */
  KnobScale scale;
  const char *comment;
} Knob;

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

/** Range, default and unit of a knob's port. */
typedef struct KnobRange {
  float minimum, maximum, fallback;
  bool logarithmic;
  /** Not 0: below it there is only the minimum, which is off. From it on the way is in equal ratios, though the port's range
   * is not logarithmic, since that begins at 0. */
  float least;
  const char *unit; /**< "" for a pure number */
} KnobRange;

/** A group of knobs, in the order in which hosts show them. */
typedef struct KnobGroup {
  const char *symbol, *name; /**< displayed name */
} KnobGroup;

enum { KNOB_GROUPS = 8 };

enum { KNOB_PAGE = 8, KNOB_PAGES = 5 };

/** A page of controls, in the window and of a host's remote control. Its id never changes. */
typedef struct KnobPage {
  uint32_t id;
  const char *section, *name;
  uint32_t count;
  KnobId knobs[KNOB_PAGE];
} KnobPage;

extern const Knob knobs[KNOB_COUNT];
extern const KnobGroup knob_groups[KNOB_GROUPS];
/** In the order in which they are turned over: the first has what players turn most. */
extern const KnobPage knob_pages[KNOB_PAGES];
/** All knobs, in the order of the ports. */
extern const KnobId knob_ports[KNOB_COUNT];

/** Name of the value that switches a knob off. */
static inline const char *knob_off_word(const Knob *knob) {
  return knob->off_word ? knob->off_word : "Off";
}

/** True for the level of a microphone. */
static inline bool knob_is_level(KnobId id) REALTIME {
  return id >= KNOB_LEVEL_PAIR && id <= KNOB_LEVEL_INSIDE;
}

/** True for a knob that a plugin has. */
static inline bool knob_is_in(KnobSet set, KnobId id) REALTIME {
  if (id >= KNOB_SOUND && id <= KNOB_ENABLED) return set == KNOBS_EFFECT;
  return set != KNOBS_MULTI || !(knob_is_level(id) || id == KNOB_ROOM);
}

/** Knob number @p place of a plugin; KNOB_COUNT past the last. */
static inline KnobId knob_at(KnobSet set, uint32_t place) REALTIME {
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    if (!knob_is_in(set, knob_ports[i])) continue;
    if (place-- == 0) return knob_ports[i];
  }
  return KNOB_COUNT;
}

/** Page number @p place of those that a plugin has; NULL past the last. A plugin has all knobs of a page or none, but for a
 * knob that other pages have as well. */
const KnobPage *knob_page(KnobSet set, uint32_t place);
/** Knob number @p place of a page, of those that a plugin has; KNOB_COUNT past the last. */
KnobId knob_on_page(KnobSet set, const KnobPage *page, uint32_t place);

/** True for a knob that hosts may modulate: it is live, and a gain or a level. */
static inline bool knob_is_modulated(KnobId id) REALTIME {
  return knob_is_level(id) || id == KNOB_GAIN || (id < KNOB_KEYS && knobs[id].kind == KNOB_LIVE);
}

/** Number of knobs of a plugin. */
static inline uint32_t knob_number(KnobSet set) REALTIME {
  uint32_t number = 0;
  while (knob_at(set, number) != KNOB_COUNT) number++;
  return number;
}

/** SET-UP. Range of a knob. @p usual is the definition of DEFAULT_PRESET. */
KnobRange knob_range(KnobId id, const TaborDrumDef *usual);
/** SET-UP. The same in a plugin: the effect is heard under the snares unless told otherwise. */
KnobRange knob_range_in(KnobSet set, KnobId id, const TaborDrumDef *usual);
/** Where @p value stands on the knob's way, 0 to 1 within its range; and the value there. */
double knob_position(const KnobRange *range, double value) REALTIME;
double knob_at_position(const KnobRange *range, double position) REALTIME;
/** True if the knob's way is not in proportion to its value. */
static inline bool knob_is_bent(const KnobRange *range) REALTIME {
  return range->logarithmic || range->least > 0;
}
/** The knob of the pitch that @p error refuses since the head cannot have it; KNOB_COUNT if it is about something else. */
KnobId knob_of_refused_pitch(const TaborError *error);
/** The striker of the drum's default stroke. */
TaborStrikerDef *knob_usual_striker(TaborDrumDef *def);
/** True if the drum has the part that the knob turns. */
bool knob_has_part(TaborDrumDef *def, KnobId id);
/** The field of @p def for a knob with a key; NULL if the drum has no such part. */
double *knob_field(TaborDrumDef *def, KnobId id);
/**
 * SET-UP. The value at which a knob below KNOB_SEEN shows the drum @p def; NaN if the drum has no such part, or is not
 * named like a built-in one. It is the field's, but a head without a pitch shows the one that its tension gives. This
 * takes some hundredths of a second.
 */
double knob_shown(const TaborDrumDef *def, KnobId id);
/** Converts a value of a LEVEL or GAIN knob [dB] to a factor; the lowest level gives 0. */
double knob_factor(KnobId id, float value) REALTIME;
/**
 * Rounds a port's value to six decimal digits: 0.05f becomes 0.05. So a definition gets exactly the number
 * that a preset has. What is not finite stays so.
 */
double knob_decimal(float value) REALTIME;

#endif
