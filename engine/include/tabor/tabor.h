/* SPDX-License-Identifier: MIT */
/**
 * @file tabor.h
 * Tabor, a snare drum computed from physics: the one public header of libtabor.
 *
 * Three kinds of object, from slow to fast:
 *
 * - a *definition* (TaborDrumDef), a plain value struct of physical parameters in SI units;
 * - a *model* (TaborModel), everything computed once from a definition and a sample rate, immutable,
 *   shared by any number of drums;
 * - a *drum* (TaborDrum), the state of one sounding drum, stepped on the audio thread.
 *
 * Functions are grouped by the thread that may call them:
 *
 * - SET-UP: any thread but the audio thread. They may allocate and take milliseconds. Two threads may
 *   call them at once on different objects.
 * - AUDIO: real-time safe. They allocate nothing, lock nothing, make no system call, do a bounded
 *   amount of work and cannot fail. One thread at a time for one drum.
 * - ANY: real-time safe, and may run beside the audio thread.
 *
 * Units are SI throughout; angles are in degrees, counter-clockwise from +x seen from above; heights
 * count upwards from the plane of the undeflected batter head.
 *
 * The library never prints, exits, installs handlers, changes the locale or reads the environment,
 * and has no mutable global state.
 */
#ifndef TABOR_TABOR_H
#define TABOR_TABOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @def TABOR_API
 * Marks what the library exports. Programs that use it as a DLL on Windows define TABOR_SHARED, which
 * the CMake package and pkg-config do. */
#if defined(_WIN32) && defined(TABOR_SHARED)
#  ifdef TABOR_BUILDING
#    define TABOR_API __declspec(dllexport)
#  else
#    define TABOR_API __declspec(dllimport)
#  endif
#elif defined(__GNUC__)
#  define TABOR_API __attribute__((visibility("default")))
#else
#  define TABOR_API
#endif

#define TABOR_VERSION_MAJOR 0 /**< until it is 1, a new minor version may change the interface */
#define TABOR_VERSION_MINOR 1 /**< of this header; the library's own says tabor_version() */
#define TABOR_VERSION_PATCH 0 /**< changes nothing in this header */

#define TABOR_MAX_WIRES 40   /**< wires of one drum */
#define TABOR_MAX_LUGS 16    /**< tension rods of one head */
#define TABOR_HOOP_MODES 8   /**< modes of the hoop */
#define TABOR_MAX_STRIKERS 8 /**< kinds of striker in one definition */
#define TABOR_MAX_MICS 8     /**< microphones in one definition */
#define TABOR_MAX_ACTIVE 8   /**< strikers and damping hands in play at once */
#define TABOR_NAME_SIZE 64   /**< bytes of a name, with its terminator */
#define TABOR_NAME_LENGTH 40 /**< bytes of a striker's or microphone's name at most */
#define TABOR_TEXT_SIZE 256  /**< bytes of a comment or a message, with its terminator */

/* ------------------------------------------------------------------------------------------------
 * Errors
 * --------------------------------------------------------------------------------------------- */

/** What a set-up function says of its outcome. */
typedef enum TaborStatus {
  TABOR_OK = 0,
  TABOR_ERROR_ARGUMENT, /**< a NULL pointer, or a struct of an unknown size */
  TABOR_ERROR_KEY,      /**< no parameter has this key */
  TABOR_ERROR_NAME,     /**< no preset, striker or microphone has this name; or the drum has no
                             resonant head */
  TABOR_ERROR_VALUE,    /**< the text is not a value of the parameter's type */
  TABOR_ERROR_RANGE,    /**< the value lies outside what is allowed */
  TABOR_ERROR_FULL,     /**< a ninth striker or microphone */
  TABOR_ERROR_MEMORY,   /**< the allocator returned NULL */
  TABOR_ERROR_NUMERICS, /**< a set-up computation did not converge */
  TABOR_ERROR_STATE     /**< saved bytes that do not belong to this drum's model */
} TaborStatus;

/** The first thing that was wrong, in full. Every set-up function accepts NULL instead. */
typedef struct TaborError {
  TaborStatus status;            /**< what the function returned */
  char key[TABOR_NAME_SIZE * 2]; /**< the offending key, "" if there is none */
  char value[TABOR_NAME_SIZE];   /**< its value as text, "" if there is none */
  double minimum;                /**< the least that is allowed; NaN where no range applies */
  double maximum;                /**< the most, likewise */
  char message[TABOR_TEXT_SIZE]; /**< one line for a person, without a line feed */
} TaborError;

/* ------------------------------------------------------------------------------------------------
 * Definition
 * --------------------------------------------------------------------------------------------- */

/** What the head's surroundings are. */
typedef enum TaborBoundary {
  TABOR_BOUNDARY_OPEN,    /**< single head, air free on both sides, no baffle */
  TABOR_BOUNDARY_BAFFLED, /**< single head, each side in an infinite baffle */
  TABOR_BOUNDARY_CLOSED   /**< single head over a rigid cavity as deep as the shell */
} TaborBoundary;

/** A head of the drum. */
typedef enum TaborHead { TABOR_HEAD_BATTER, TABOR_HEAD_RESONANT } TaborHead;

/** The face of the head on which the wires lie. */
typedef enum TaborSide { TABOR_SIDE_ABOVE, TABOR_SIDE_BELOW } TaborSide;

/**
 * Accuracy against cost. `studio` and `reference` compute in double precision throughout. `draft` and `live` compute
 * contacts, what they do to heads and wires, and the high band in single precision: states stay double.
 */
typedef enum TaborQuality {
  TABOR_QUALITY_DEFAULT, /**< in model options: what the definition says */
  TABOR_QUALITY_DRAFT,
  TABOR_QUALITY_LIVE,
  TABOR_QUALITY_STUDIO,
  TABOR_QUALITY_REFERENCE
} TaborQuality;

/** What strikes. All kinds are a lumped tip mass with a power-law contact; the numbers differ. */
typedef enum TaborStrikerKind {
  TABOR_STRIKER_STICK,
  TABOR_STRIKER_MALLET,
  TABOR_STRIKER_FINGER,
  TABOR_STRIKER_BRUSH /**< many light bristles: see TaborStrikerDef */
} TaborStrikerKind;

/** How a stroke is made. */
typedef enum TaborTechnique {
  TABOR_TECHNIQUE_NORMAL, /**< the stick is free and rebounds */
  TABOR_TECHNIQUE_BUZZ, /**< a hand goes on pressing the stick, which bounces until it is released */
  TABOR_TECHNIQUE_RIMSHOT, /**< the stick comes down flat: its tip on the head and, within a millisecond,
                                its shaft on the hoop at the stroke's angle */
  TABOR_TECHNIQUE_CROSS_STICK, /**< the tip rests on the head under the palm, and the shaft strikes the
                                    hoop across, with the stroke's speed */
  TABOR_TECHNIQUE_RIM,         /**< the stick strikes the hoop alone, at the stroke's angle */
  TABOR_TECHNIQUE_SWEEP        /**< a hand draws a brush over the head until it is released */
} TaborTechnique;

/** What holds the heads. */
typedef struct TaborShellDef {
  double radius; /**< radius of every head [m], 0.05 to 0.60, default 0.1651 (13 inch) */
  double depth;  /**< of the air below the batter head, down to the resonant head or the bottom of
                          a closed drum [m], 0.01 to 1.5, default 0.14; otherwise without effect */
  uint32_t boundary; /**< a TaborBoundary, default open, which it has to be on a two-headed drum */
} TaborShellDef;

/**
 * A head: rho w_tt = (T + dT) lap w - D lap^2 w - sigma0 rho w_t + sigma1 rho lap w_t + forces.
 * Large deflections stretch it: dT = S/(2 A) Int |grad w|^2 dA, A its area (Berger). A damper, a
 * force -c w_t on a small patch, may rest on it. Two defaults: of the batter and the resonant head.
 *
 * Lugs stretch it around its rim, number j of n at (j - 1/2) 360/n degrees. Where their tensions differ,
 * the head's lower modes come apart in pairs, which beat.
 */
typedef struct TaborHeadDef {
  double tension;           /**< T [N/m], 100 to 20,000, default 3000 and 2600 */
  double surface_density;   /**< rho [kg/m2], 0.02 to 5, default 0.262 and 0.105 */
  double bending_stiffness; /**< D [N m], 0 to 1, default 0.0023 and 1.5e-4 */
  double damping_0;         /**< sigma0 [1/s], 0 to 1000, default 12 */
  double damping_1;         /**< sigma1 [m2/s], 0 to 0.1, default 0.0016 */
  double stretch_stiffness; /**< S = E h/(1 - nu^2) of the sheet [N/m], 0 to 1e7, default 0 */
  double muffle_radius;     /**< the damper's distance from the centre [m], 0 to 0.6 and inside the
                                 head, default 0 */
  double muffle_angle;      /**< its direction [deg], -360 to 360, default 0 */
  double muffle_strength;   /**< its c [N s/m], 0 (none) to 30, default 0 */
  uint32_t lug_count;       /**< 3 to 16, default 10 */
  double lug_spread; /**< largest relative deviation of the tension at a lug, 0 to 0.5, default
                                 0; deviations are drawn with a mean of 0 */
  uint32_t lug_seed; /**< of the draw, 0 to 4294967295, default 1 */
  double
    lug[TABOR_MAX_LUGS]; /**< a lug's own relative deviation, -0.5 to 0.5, default NaN: as drawn */
} TaborHeadDef;

/** What all wires share. */
typedef struct TaborWiresDef {
  uint32_t head;            /**< a TaborHead, default batter */
  uint32_t count;           /**< 0 to 40, default 0 */
  uint32_t side;            /**< a TaborSide, default above */
  double length;            /**< between the ends [m], 0.02 to 1.5, default 0.30 */
  double spacing;           /**< between neighbours [m], 0 to 0.1, default 0.002 */
  double angle;             /**< of their direction [deg], -360 to 360, default 0 */
  double offset;            /**< of the bed's middle from the centre, across [m], -0.6 to 0.6, 0 */
  double mass_per_length;   /**< mu [kg/m], 1e-4 to 0.1, default 1.6e-3 */
  double tension;           /**< T [N], 0.01 to 200, default 5 */
  double tension_spread;    /**< relative spread between wires, 0 to 0.9, default 0 */
  uint32_t seed;            /**< of the spread, 0 to 4294967295, default 1 */
  double bending_stiffness; /**< EI [N m2], 0 to 0.1, default 1e-6 */
  double damping_0;         /**< sigma0 [1/s], 0 to 1000, default 2 */
  double damping_1;         /**< sigma1 [m2/s], 0 to 0.1, default 0.001 */
  double strainer;          /**< 0 off to 1 on, default 1 */
  double strainer_travel;   /**< lift of the ends with the strainer off [m], 0 to 0.02, 0.004 */
  double rest_offset;       /**< ends from the undeflected head, positive = away [m],
                                  -0.01 to 0.02, default 0 */
  double contact_stiffness; /**< K [N/m^(exponent+1) per length], 1e4 to 1e13, default 1e8 */
  double contact_exponent;  /**< 1 to 3, default 1.5 */
  double contact_loss;      /**< Hunt-Crossley lambda [s/m], 0 to 100, default 0.3 */
} TaborWiresDef;

/** One wire's own values, units and ranges as in TaborWiresDef. NaN means: as [wires] says. */
typedef struct TaborWireDef {
  double length;            /**< [m] */
  double mass_per_length;   /**< [kg/m] */
  double tension;           /**< [N] */
  double bending_stiffness; /**< [N m2] */
  double damping_0;         /**< [1/s] */
  double damping_1;         /**< [m2/s] */
  double rest_offset;       /**< [m] */
  double contact_stiffness; /**< [N/m^(exponent+1) per length] */
  double contact_exponent;  /**< a pure number */
  double contact_loss;      /**< [s/m] */
  double angle;             /**< its own direction [deg] */
  double offset; /**< its own distance across from the centre [m], instead of the bed's layout */
} TaborWireDef;

/**
 * What a drum is struck with: a tip mass with a power-law contact on a patch of the head. A brush shares its
 * mass and its contact among three groups of bristles, each on a patch of its own, which lie in a fan of
 * radius spread. A stroke of its is a slap; in a sweep a hand draws it over the head.
 */
typedef struct TaborStrikerDef {
  char name[TABOR_NAME_SIZE]; /**< 1 to TABOR_NAME_LENGTH bytes */
  uint32_t kind;              /**< a TaborStrikerKind */
  double mass;                /**< effective tip mass [kg], 1e-4 to 1, default 0.012 */
  double contact_stiffness;   /**< K [N/m^exponent], 1e3 to 1e13, default 3e6 */
  double contact_exponent;    /**< 1 to 3, default 1.5 */
  double contact_loss;        /**< Hunt-Crossley lambda [s/m], 0 to 100, default 0.05 */
  double contact_radius; /**< of the patch over which the force spreads [m], 0 to 0.05, 0.006 */
  uint32_t bristles;     /**< of a brush, 3 to 1000, default 200 */
  double spread;         /**< radius of its fan [m], 0.005 to 0.15, default 0.04 */
  double sweep_speed;    /**< along the head in a sweep [m/s], 0.01 to 5, default 0.8 */
} TaborStrikerDef;

/**
 * The hand that presses a stick onto the head: M z_tt = f - 2 g (F0 + kh (z - z0) + ch z_t), g its grip,
 * F0 the pressure, z0 where it took hold.
 */
typedef struct TaborHandDef {
  double stiffness; /**< kh at the tip, at a grip of 0.5 [N/m], 0 to 1000, default 20 */
  double damping;   /**< ch, likewise [N s/m], 0 to 10, default 0.2 */
  double pivot; /**< from the stick's butt to where the hand holds it [m], 0 to 0.3, default 0.12. A
                         stick of 0.4 m weighs its striker's mass at the tip when held at 0.12 m; held
                         elsewhere a buzz stroke's weighs more or less */
  double grip;  /**< g, 0 (open: a free rebound) to 1, default 0.5 */
} TaborHandDef;

/**
 * The hoop around the batter head, with what moves along of the shell: a mode for each frequency that is not
 * 0, the first with two nodal diameters. Sticks strike it in rimshots, cross-sticks and strokes on the rim.
 * Without frequencies it does not yield, and such strokes on it make no sound of their own.
 */
typedef struct TaborHoopDef {
  double height; /**< of its edge above the head [m], 0 to 0.05, default 0.012 */
  double mass;   /**< of what swings [kg], 0.05 to 20, default 1.2 */
  double
    contact_stiffness; /**< K of a stick on it, f = K eta^1.5 [N/m^1.5], 1e5 to 1e11, default 1e8; a
                                 mallet or a finger has its own */
  double contact_loss; /**< Hunt-Crossley lambda of a stick on it [s/m], 0 to 100, default 0.1 */
  double frequency[TABOR_HOOP_MODES]; /**< of its modes [Hz], 0 (none) or 20 to 20,000, default 0 */
  double decay
    [TABOR_HOOP_MODES]; /**< of their amplitude, without what leaves as sound [1/s], 0 to 10,000,
                                       default 50 */
} TaborHoopDef;

/** The stroke that is made when none is given. */
typedef struct TaborStrikeDef {
  double velocity; /**< [m/s], 0.01 to 30, default 2.5 */
  double radius;   /**< distance from the centre [m], 0 to 0.6 and inside the head, default 0.05 */
  double angle;    /**< [deg], -360 to 360, default 0 */
  char striker[TABOR_NAME_SIZE]; /**< its name; "" is the first */
  uint32_t technique;            /**< a TaborTechnique, default normal */
} TaborStrikeDef;

/** A microphone: it hears the pressure at its place. */
typedef struct TaborMicDef {
  char name[TABOR_NAME_SIZE]; /**< 1 to TABOR_NAME_LENGTH bytes */
  double radius;              /**< distance from the axis [m], 0 to 10, default 0.05 */
  double angle;               /**< [deg], -360 to 360, default 90 */
  double height; /**< above the batter head, negative below [m], 0.01 to 10 in size, default 0.10;
                      not inside a closed or two-headed shell, nor within 0.01 of a resonant head's
                      plane */
  double gain;   /**< [1], 0 to 100, default 1 */
} TaborMicDef;

/** What the drum stands in. */
typedef struct TaborAirDef {
  double density;     /**< rho0 [kg/m3], 0 (vacuum) to 5, default 1.205 */
  double sound_speed; /**< c0 [m/s], 100 to 2000, default 343 */
  double gravity;     /**< [m/s2], 0 to 30, default 9.81 */
} TaborAirDef;

/** Accuracy against cost, in parts. */
typedef struct TaborQualityDef {
  uint32_t level;           /**< a TaborQuality but the default, default studio */
  double two_way_bandwidth; /**< modes up to here feel the contacts [Hz], 0 = by level, to 40,000 */
  double bandwidth;         /**< modes up to here are heard [Hz], 0 = by level, to 40,000 */
  uint32_t newton_cap;      /**< iterations a sample, 0 = by level, 1 to 16 */
  uint32_t wire_points;     /**< cells of a wire at most, 0 = by level, 8 to 400 */
  uint32_t losses;          /**< 1, or 0 to switch off every loss and radiation */
} TaborQualityDef;

/** A whole drum. Plain data: copy it by assignment. */
typedef struct TaborDrumDef {
  uint32_t struct_size;          /**< set by tabor_drum_def_default() */
  char name[TABOR_NAME_SIZE];    /**< what the drum is called */
  char comment[TABOR_TEXT_SIZE]; /**< what it is, one line */
  char license[TABOR_NAME_SIZE]; /**< of the definition */
  TaborShellDef shell;           /**< [shell] of a preset */
  TaborHeadDef batter;           /**< [batter], the struck head */
  uint32_t two_headed;           /**< 1 with a resonant head, 0 without, default 0 */
  TaborHeadDef resonant;         /**< [resonant]: no effect and no keys unless two_headed is 1 */
  TaborWiresDef wires;           /**< [wires] */
  TaborWireDef wire[TABOR_MAX_WIRES];          /**< [wire.1] is wire[0] */
  uint32_t striker_count;                      /**< strikers defined, 1 to 8 */
  TaborStrikerDef striker[TABOR_MAX_STRIKERS]; /**< [striker.NAME], the usual one first */
  TaborHandDef hand;                           /**< [hand] */
  TaborStrikeDef strike;                       /**< [strike] */
  uint32_t mic_count;                          /**< microphones defined, 1 to 8 */
  TaborMicDef mic[TABOR_MAX_MICS];             /**< [mic.NAME], the usual one first */
  TaborAirDef air;                             /**< [air] */
  TaborQualityDef quality;                     /**< [quality] */
  double full_scale; /**< sound pressure at 1.0 [Pa], 1e-3 to 1e5, default 20 */
  TaborHoopDef hoop; /**< [hoop] */
} TaborDrumDef;

/** How a parameter's value is written. */
typedef enum TaborParameterType {
  TABOR_TYPE_NUMBER, /**< a double */
  TABOR_TYPE_WHOLE,  /**< a uint32_t */
  TABOR_TYPE_CHOICE, /**< one word of a list, stored as its enumerator */
  TABOR_TYPE_TEXT    /**< characters */
} TaborParameterType;

/** One row of the table that drives defaults, validation, presets, live changes and documentation. */
typedef struct TaborParameter {
  uint32_t id;         /**< stable, never reused */
  const char *section; /**< "batter"; "striker.", "mic.", "wire." for those with a name or number */
  const char *key;     /**< "tension" */
  const char *unit;    /**< "N/m"; "" for a pure number */
  TaborParameterType type; /**< how its value is written */
  double minimum;          /**< of numbers and whole numbers; NaN otherwise */
  double maximum;          /**< likewise */
  double fallback;         /**< the default, of a choice its index in @p choices; NaN for text, and
                                where a wire follows [wires], or a lug the draw */
  const char *choices;     /**< words separated by '|' for a choice, NULL otherwise */
  bool logarithmic;        /**< a control should move it in ratios */
  bool live;               /**< a parameter event may change it while the drum rings */
  const char *text;        /**< what it is, one line */
} TaborParameter;

/** A built-in preset. */
typedef struct TaborPresetInfo {
  const char *name;    /**< for tabor_drum_def_preset() */
  const char *comment; /**< what it is, one line */
  const char *file;    /**< the name of its text file in presets/ */
} TaborPresetInfo;

/** @name Set-up: definitions
 * SET-UP: any thread but the audio thread. */
/** @{ */

/** "0.1.0". Static storage. */
TABOR_API const char *tabor_version(void);

/** Number of rows of the parameter table. */
TABOR_API uint32_t tabor_parameter_count(void);
/** Row @p index of the parameter table, or NULL past its end. Static storage. */
TABOR_API const TaborParameter *tabor_parameter(uint32_t index);
/** The row that a full key such as "batter.tension" or "mic.top.gain" names, or NULL. */
TABOR_API const TaborParameter *tabor_parameter_find(const char *key);

/** Number of built-in presets. */
TABOR_API uint32_t tabor_preset_count(void);
/** Built-in preset @p index in listed order, or NULL past the end. Static storage. */
TABOR_API const TaborPresetInfo *tabor_preset(uint32_t index);

/** Sets every field to its default: one head, no wires, one striker "stick", one microphone "top". */
TABOR_API void tabor_drum_def_default(TaborDrumDef *def);
/** Sets @p def to the defaults without any striker or microphone: the start of reading a preset. */
TABOR_API void tabor_drum_def_clear(TaborDrumDef *def);
/** Loads a built-in preset. TABOR_ERROR_NAME, with a near name in the message, if unknown. */
TABOR_API TaborStatus tabor_drum_def_preset(TaborDrumDef *def, const char *name, TaborError *error);
/**
 * Sets one parameter from text: key "batter.tension", value "3000". Numbers parse independently of
 * the locale. A new NAME in "striker.NAME.mass" or "mic.NAME.gain" adds that striker or microphone;
 * any "resonant." key makes a one-headed drum two-headed. What is added has defaults otherwise.
 * On an error @p def is unchanged: TABOR_ERROR_KEY (with a near key if there is one), _VALUE,
 * _RANGE, _FULL.
 */
TABOR_API TaborStatus tabor_drum_def_set(TaborDrumDef *def, const char *key, const char *value,
                                         TaborError *error);
/**
 * Begins a section of a preset, as "resonant", "striker.stick" or "air": adds the resonant head,
 * striker or microphone with its defaults if @p def has not got it, and changes nothing otherwise.
 * On an error @p def is unchanged: TABOR_ERROR_KEY (with a near section if there is one), _FULL.
 */
TABOR_API TaborStatus tabor_drum_def_section(TaborDrumDef *def, const char *section,
                                             TaborError *error);
/**
 * Writes the value of @p key as text that tabor_drum_def_set() reads back to the same bits; at most
 * @p size bytes with the terminator. A wire's value that follows [wires] is written as "".
 * TABOR_ERROR_NAME for a striker, microphone or resonant head that the drum has not got.
 */
TABOR_API TaborStatus tabor_drum_def_get(const TaborDrumDef *def, const char *key, char *text,
                                         size_t size, TaborError *error);
/** Full key @p index of @p def in preset order, or false past the last. Wires' unset values and the
 * resonant keys of a one-headed drum are skipped. */
TABOR_API bool tabor_drum_def_key(const TaborDrumDef *def, uint32_t index, char *key, size_t size);
/** Checks every field and what must hold between fields. */
TABOR_API TaborStatus tabor_drum_def_validate(const TaborDrumDef *def, TaborError *error);
/** Index of the striker called @p name, or -1. */
TABOR_API int tabor_drum_def_find_striker(const TaborDrumDef *def, const char *name);
/** Index of the microphone called @p name, or -1. */
TABOR_API int tabor_drum_def_find_mic(const TaborDrumDef *def, const char *name);
/** @} */

/* ------------------------------------------------------------------------------------------------
 * Model
 * --------------------------------------------------------------------------------------------- */

/** Everything computed once from a definition and a sample rate: immutable, counted, shared. */
typedef struct TaborModel TaborModel;

/** Kernels to run. Every choice computes the same bits. */
typedef enum TaborInstructions {
  TABOR_INSTRUCTIONS_AUTO,     /**< the widest that the processor has */
  TABOR_INSTRUCTIONS_BASELINE, /**< what the library was compiled for */
  TABOR_INSTRUCTIONS_AVX2,     /**< or the baseline, where the processor lacks it */
  TABOR_INSTRUCTIONS_AVX512    /**< or the next narrower that the processor has */
} TaborInstructions;

/** Where memory comes from. */
typedef struct TaborAllocator {
  void *(*allocate)(size_t size, void *context); /**< memory aligned to 64 bytes, or NULL */
  void (*release)(void *memory, void *context);  /**< takes it back; NULL does nothing */
  void *context;                                 /**< handed to both */
} TaborAllocator;

/** How a model is computed. */
typedef struct TaborModelOptions {
  uint32_t struct_size;     /**< set by tabor_model_options_default() */
  double sample_rate;       /**< [Hz], 22,050 to 192,000, default 48,000 */
  uint32_t quality;         /**< a TaborQuality */
  uint32_t instructions;    /**< a TaborInstructions */
  TaborAllocator allocator; /**< both functions NULL: the C library's */
} TaborModelOptions;

/** Facts of a model. */
typedef struct TaborModelInfo {
  double sample_rate;       /**< [Hz] */
  uint32_t quality;         /**< a TaborQuality, never the default */
  uint32_t mode_count;      /**< modes, cosine and sine copies counted apart */
  uint32_t mode_rows;       /**< rows of tabor_model_mode(), copies counted once */
  double two_way_bandwidth; /**< [Hz], may be below the wish: there are 4096 modes at most */
  double bandwidth;         /**< [Hz], with the one-way high band */
  uint32_t high_mode_count; /**< modes of the high band */
  uint32_t newton_cap;      /**< iterations a sample */
  uint32_t wire_count;      /**< wires */
  uint32_t contact_points;  /**< of all wires together */
  uint32_t mic_count;       /**< microphones, the channels of tabor_drum_process() */
  size_t model_bytes;       /**< memory of the model */
  size_t drum_bytes;        /**< memory of the state of each drum on it */
} TaborModelInfo;

/** What a mode moves most. */
typedef enum TaborModePart {
  TABOR_PART_BATTER,   /**< the batter head, with over 90 % of the heads' energy */
  TABOR_PART_RESONANT, /**< the resonant head, likewise */
  TABOR_PART_BOTH,     /**< both heads */
  TABOR_PART_CAVITY    /**< the air between them, with over half of all kinetic energy */
} TaborModePart;

/** One mode of the heads with their air. */
typedef struct TaborModeInfo {
  uint32_t m;            /**< nodal diameters of the Bessel function that moves most */
  uint32_t n;            /**< its nodal circles counting the rim, from 1 */
  double frequency;      /**< [Hz] */
  double decay_rate;     /**< of the amplitude [1/s] */
  double radiation_rate; /**< the part of it that leaves as sound [1/s] */
  uint32_t multiplicity; /**< 1, or 2 with a sine copy */
  TaborModePart part;    /**< what moves most */
  int32_t phase; /**< of two heads: 1 if they move up together, -1 if against each other; else 0 */
} TaborModeInfo;

/** @name Set-up: models
 * SET-UP: any thread but the audio thread. */
/** @{ */

/** Fills in the defaults. */
TABOR_API void tabor_model_options_default(TaborModelOptions *options);
/**
 * Computes a model, with one reference that the caller owns. @p options may be NULL for the defaults.
 * On an error *model is NULL. On a desktop processor the built-in presets take a quarter of a second
 * at live and under one at studio; at reference, or with heads of twice their size, some seconds.
 */
TABOR_API TaborStatus tabor_model_create(const TaborDrumDef *def, const TaborModelOptions *options,
                                         TaborModel **model, TaborError *error);
/** Takes one more reference. Set-up threads only; the count is atomic. */
TABOR_API TaborModel *tabor_model_retain(TaborModel *model);
/** Gives a reference back; the last frees the model. NULL is allowed. */
TABOR_API void tabor_model_release(TaborModel *model);
/** The definition that the model was built from. */
TABOR_API const TaborDrumDef *tabor_model_definition(const TaborModel *model);
/** Fills in the facts of @p model. */
TABOR_API void tabor_model_info(const TaborModel *model, TaborModelInfo *info);
/** Mode @p row of the head, sorted by frequency; false past the last. */
TABOR_API bool tabor_model_mode(const TaborModel *model, uint32_t row, TaborModeInfo *mode);
/** @} */

/* ------------------------------------------------------------------------------------------------
 * Drum
 * --------------------------------------------------------------------------------------------- */

/** The state of one sounding drum. */
typedef struct TaborDrum TaborDrum;
/** A prepared change of a drum's model. */
typedef struct TaborSwap TaborSwap;

/** What can happen to a drum; which fields of the event count. */
typedef enum TaborEventType {
  TABOR_EVENT_STRIKE =
    1, /**< id, striker, velocity, radius, angle, technique; value, the pressure, for
                                a buzz or a sweep. A sweep goes around the centre at this radius,
                                counter-clockwise at this velocity, up to 5 m/s, until it is moved. Takes away a pressed striker with the same id but 0: a hand
                                holds one stick */
  TABOR_EVENT_PRESS = 2, /**< id, or 0 for all: presses strikers in play onto the head, value 0 to
                                1 for 0.3 to 8 N in equal ratios at a grip of 0.5; they bounce (a buzz)
                                and stay until released or 0.2 m away. Again: changes the pressure */
  TABOR_EVENT_DAMP = 3,  /**< id, radius, angle, value: a hand of @p value [N s/m] on the head */
  TABOR_EVENT_RELEASE =
    4, /**< id, or 0 for all: lifts damping hands and brushes, takes strikers away */
  TABOR_EVENT_PARAMETER = 5, /**< parameter, index, value */
  TABOR_EVENT_SWAP = 6,      /**< swap */
  TABOR_EVENT_RESET = 7,     /**< back to rest; ledger and statistics restart */
  TABOR_EVENT_MOVE = 8 /**< id, or 0 for all, radius, angle, value: sweeping brushes go there, the
                                shorter way round, in so many seconds, up to 60; 0: in as long as since
                                the last move, 5 to 100 ms, for a stream of moves */
} TaborEventType;

/** Something that happens at a frame of a block. Unused fields are ignored: set them to zero. */
typedef struct TaborEvent {
  uint32_t frame;     /**< offset into the block; events are sorted by it */
  uint32_t type;      /**< a TaborEventType */
  uint32_t id;        /**< the caller's name for a stroke or hand; 0 = anonymous */
  uint32_t striker;   /**< index into the definition's strikers */
  uint32_t parameter; /**< id of a live parameter */
  uint32_t index;     /**< of the microphone, for mic.*.gain */
  uint32_t technique; /**< a TaborTechnique */
  double velocity;    /**< [m/s], clamped to 0.01 to 30 */
  double radius;      /**< [m] from the centre, clamped to the head */
  double angle;       /**< [deg] */
  double value;       /**< of the parameter, clamped to its range; strength of a damping hand, 0 to
                         100; pressure, 0 to 1 */
  TaborSwap *swap;    /**< for TABOR_EVENT_SWAP */
} TaborEvent;

/** Counters since creation or reset, and what is in play. */
typedef struct TaborStatistics {
  uint64_t frames;            /**< processed, sleeping frames included */
  uint64_t slept_frames;      /**< of these, passed asleep */
  uint64_t strikes;           /**< strokes begun */
  uint64_t late_events;       /**< offset past the block: acted at its last frame */
  uint64_t misordered_events; /**< acted at the previous event's frame */
  uint64_t dropped_events;    /**< unknown, not finite, or nothing free to carry them out */
  uint64_t solves;            /**< samples on which a contact was solved */
  uint64_t newton_iterations; /**< sum over the solves */
  uint32_t newton_max;        /**< most in one sample */
  uint64_t newton_capped;     /**< solves stopped at the cap before convergence */
  uint64_t work_corrected;    /**< of these, forces scaled so that contacts create no energy */
  uint64_t fallbacks;         /**< of these, majorant steps */
  uint64_t guarded;           /**< steps shortened by the energy guard */
  uint64_t recovered;         /**< resets after a state that was not finite */
  uint64_t contact_sum;       /**< sum over the solves of the points that touched */
  uint32_t contact_max;       /**< most points that touched in one sample */
  uint32_t in_play;           /**< strikers and damping hands in play now */
} TaborStatistics;

/**
 * Where the energy went, in joules since creation or reset:
 * injected + control = stored + head_loss + wire_loss + contact_loss + damper_loss + shell_loss
 *                      + radiated + removed + residual.
 * The residual stays within 1e-9 of injected + |control| at `studio` and `reference`, within 1e-6 at `draft` and `live`,
 * but for what a drum loses, never gains, where the contact solver ends at its cap (newton_capped).
 */
typedef struct TaborLedger {
  double injected;     /**< kinetic energy of launched strikers, and the work of pressing hands with
                            their springs */
  double control;      /**< work of moving parameters and swaps, either sign */
  double stored;       /**< above the rest state, strikers in flight included */
  double head_loss;    /**< in the head's material */
  double wire_loss;    /**< in the wires' material */
  double contact_loss; /**< Hunt-Crossley loss of wires and strikers */
  double
    damper_loss; /**< in damping hands, in the dampers of pressing ones, and in hands whose sticks bend */
  double
    shell_loss; /**< in hoop and shell; friction, heat and absorption at the walls of the enclosed air */
  double radiated;  /**< as sound, by heads, hoop and shell */
  double removed;   /**< of strikers taken away */
  double high_band; /**< stored in the one-way high band; outside the balance */
  double residual;  /**< what the numerics lost (positive) or created (negative) */
} TaborLedger;

/** A look at the newest state. Heights [m] share one datum, the undeflected head. */
typedef struct TaborProbe {
  double head;          /**< of the head's centre */
  double wire;          /**< of the first wire's midpoint; NaN without wires */
  double striker;       /**< of the newest striker in play; NaN without one */
  double striker_force; /**< between all strikers and head or hoop [N]; NaN without one */
  double wire_force;    /**< between all wires and the head [N]; NaN without wires */
} TaborProbe;

/** @name Set-up: drums and swaps
 * SET-UP: any thread but the audio thread. */
/** @{ */

/** Creates a drum at rest; it keeps a reference to @p model. On an error *drum is NULL. */
TABOR_API TaborStatus tabor_drum_create(TaborModel *model, TaborDrum **drum, TaborError *error);
/** Frees a drum. NULL is allowed. A swap still fading inside it must be destroyed after it. */
TABOR_API void tabor_drum_destroy(TaborDrum *drum);
/**
 * Prepares the change of a drum from @p old_model, which must be its model when the swap event acts,
 * to @p new_model, and holds all memory that it takes. An event of another old model is dropped, and the swap
 * is done.
 *
 * A drum of another size, boundary or set of wires is not continued: it rings out under a fade of 30 ms, at the
 * microphones of the same names. Up to four ring out at once; a further one cuts the oldest short.
 */
TABOR_API TaborStatus tabor_swap_create(TaborModel *old_model, TaborModel *new_model,
                                        TaborSwap **swap, TaborError *error);
/** Frees a swap that was never sent or is done, with what the drum left in it. NULL is allowed. */
TABOR_API void tabor_swap_destroy(TaborSwap *swap);
/** @} */

/** @name Swaps, from any thread
 * ANY: real-time safe, also beside the audio thread. */
/** @{ */

/** True once the audio thread needs nothing of @p swap any more (atomic). */
TABOR_API bool tabor_swap_done(const TaborSwap *swap);
/** @} */

/** @name On the audio thread
 * AUDIO: real-time safe; one thread at a time for one drum. */
/** @{ */

/**
 * Computes @p frames samples.
 *
 * @param drum    the drum.
 * @param events  @p count events, sorted by frame; may be NULL when count is 0.
 * @param count   how many.
 * @param outputs outputs[mic][frame], one pointer per microphone of the definition, in its order;
 *                planar, 1.0 = full_scale, overwritten. A NULL channel is not computed: heard again,
 *                it begins with what happens then, without what was under way to the microphone.
 *                @p outputs itself may be NULL. Channels beyond the model's after a swap are the caller's.
 * @param frames  how many samples of each channel; may be 0.
 *
 * Output does not depend on how frames are divided into blocks. Latency is 0: what a microphone
 * hears late is the travel time of sound. The caller's floating-point mode is saved and restored.
 */
TABOR_API void tabor_drum_process(TaborDrum *drum, const TaborEvent *events, uint32_t count,
                                  float *const *outputs, uint32_t frames);
/** True if everything has died away: until the next event the output is exactly zero. */
TABOR_API bool tabor_drum_is_silent(const TaborDrum *drum);
/** Back to rest, as TABOR_EVENT_RESET. */
TABOR_API void tabor_drum_reset(TaborDrum *drum);
/** Copies the counters out. */
TABOR_API void tabor_drum_statistics(const TaborDrum *drum, TaborStatistics *statistics);
/** Copies the energy account out. */
TABOR_API void tabor_drum_ledger(const TaborDrum *drum, TaborLedger *ledger);
/** Copies out where things are now. */
TABOR_API void tabor_drum_probe(const TaborDrum *drum, TaborProbe *probe);
/** The model that the drum runs on now. */
TABOR_API const TaborModel *tabor_drum_model(const TaborDrum *drum);

/** Bytes that tabor_drum_state_save() writes. */
TABOR_API size_t tabor_drum_state_size(const TaborDrum *drum);
/** Writes the whole state to @p bytes; a drum of the same model continues from it to the same bit. */
TABOR_API void tabor_drum_state_save(const TaborDrum *drum, void *bytes);
/** Reads what save wrote. TABOR_ERROR_STATE, and no change, if it is damaged or of another model. */
TABOR_API TaborStatus tabor_drum_state_load(TaborDrum *drum, const void *bytes, size_t size);
/** @} */

#ifdef __cplusplus
}
#endif

#endif /* TABOR_TABOR_H */
