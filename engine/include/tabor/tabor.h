/* SPDX-License-Identifier: MIT */
/**
 * @file tabor.h
 * Tabor, a snare drum computed from physics: the one public header of libtabor.
 *
 * There are four kinds of object:
 *
 * - A *definition* (TaborDrumDef) is a plain struct of physical parameters in SI units.
 * - A *model* (TaborModel) holds everything that is computed once from a definition and a sample
 *   rate. It is immutable; any number of drums share it.
 * - A *drum* (TaborDrum) is the state of one sounding drum. The audio thread computes its samples.
 * - A *room* (TaborRoom) adds to a drum's microphones what walls send back.
 *
 * Functions are grouped by the thread that may call them:
 *
 * - SET-UP: any thread but the audio thread. They may allocate and take milliseconds. Two threads
 *   may call them at the same time on different objects.
 * - AUDIO: real-time safe. They allocate nothing, lock nothing, make no system call, do a bounded
 *   amount of work and cannot fail. For one drum, one thread at a time may call them.
 * - ANY: real-time safe. Any thread may call them while the audio thread runs.
 *
 * All units are SI. Angles are in degrees, counter-clockwise from +x seen from above. Heights are
 * measured upwards from the plane of the undeflected batter head.
 *
 * The library never prints, never exits, installs no handlers, does not change the locale, does not
 * read the environment, and has no mutable global state.
 *
 * Keys in brackets, as [Torin2014], are entries of REFERENCES.md.
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
 * Marks what the library exports. A program that uses the library as a DLL on Windows defines
 * TABOR_SHARED; the CMake package and pkg-config do this. */
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

#define TABOR_VERSION_MAJOR 0 /**< while it is 0, a new minor version may change the interface */
#define TABOR_VERSION_MINOR 2 /**< of this header; tabor_version() returns the library's */
#define TABOR_VERSION_PATCH 0 /**< a new patch version changes nothing in this header */
#define TABOR_VERSION_SUFFIX "-dev" /**< "-dev" on the way to this version, "" in its release */

#define TABOR_MAX_WIRES 40   /**< wires of one drum */
#define TABOR_MAX_LUGS 16    /**< tension rods of one head */
#define TABOR_MAX_STRIKERS 8 /**< kinds of striker in one definition */
#define TABOR_MAX_MICS 8     /**< microphones in one definition */
#define TABOR_MAX_ACTIVE 8   /**< strikers and damping hands in play at once */
#define TABOR_BURST 16       /**< strokes, presses and damping hands that act at once at most */
#define TABOR_BURST_FRAMES 8 /**< frames after which one more acts */
#define TABOR_NAME_SIZE 64   /**< bytes of a name, with its terminator */
#define TABOR_NAME_LENGTH 40 /**< bytes of a striker's or microphone's name at most */
#define TABOR_TEXT_SIZE 256  /**< bytes of a comment or a message, with its terminator */

/* ------------------------------------------------------------------------------------------------
 * Errors
 * --------------------------------------------------------------------------------------------- */

/** Outcome of a set-up function. */
typedef enum TaborStatus {
  TABOR_OK = 0,
  TABOR_ERROR_ARGUMENT, /**< a NULL pointer, a struct of an unknown size, too small a buffer, or two
                             models with different allocators */
  TABOR_ERROR_KEY,      /**< no parameter or section has this key */
  TABOR_ERROR_NAME,     /**< no preset, striker or microphone has this name; or the drum has no
                             resonant head */
  TABOR_ERROR_VALUE,    /**< the text is not a value of the parameter's type */
  TABOR_ERROR_RANGE,    /**< the value is outside the allowed range */
  TABOR_ERROR_FULL,     /**< a ninth striker or microphone */
  TABOR_ERROR_MEMORY,   /**< the allocator returned NULL */
  TABOR_ERROR_NUMERICS, /**< a set-up computation did not converge */
  TABOR_ERROR_STATE,    /**< the saved bytes are damaged or belong to another model */
  TABOR_ERROR_LIMIT,    /**< the model would take more time or memory than the options allow */
  TABOR_ERROR_CANCELLED /**< the caller's progress function ended the build */
} TaborStatus;

/** Describes the first error that was found. Every set-up function accepts NULL in its place. */
typedef struct TaborError {
  TaborStatus status;            /**< what the function returned */
  char key[TABOR_NAME_SIZE * 2]; /**< the offending key, "" if there is none */
  char value[TABOR_NAME_SIZE];   /**< its value as text, "" if there is none */
  double minimum;                /**< least allowed value; NaN where no range applies */
  double maximum;                /**< greatest allowed value; NaN where no range applies */
  char message[TABOR_TEXT_SIZE]; /**< one line for a person, without a line feed */
  uint32_t
    line; /**< of the text that was read, from 1; 0: no text was, or it is wrong as a whole */
  uint32_t column; /**< byte of that line at which the error begins, from 1; 0 without a line */
} TaborError;

/* ------------------------------------------------------------------------------------------------
 * Definition
 * --------------------------------------------------------------------------------------------- */

/** Surroundings of a single head. */
typedef enum TaborBoundary {
  TABOR_BOUNDARY_OPEN,    /**< air free on both sides, no baffle */
  TABOR_BOUNDARY_BAFFLED, /**< each side in an infinite baffle */
  TABOR_BOUNDARY_CLOSED   /**< over a rigid cavity as deep as the shell */
} TaborBoundary;

/** A head of the drum. */
typedef enum TaborHead { TABOR_HEAD_BATTER, TABOR_HEAD_RESONANT } TaborHead;

/** The face of the head on which the wires lie. */
typedef enum TaborSide { TABOR_SIDE_ABOVE, TABOR_SIDE_BELOW } TaborSide;

/**
 * Accuracy against cost. `studio` and `reference` compute in double precision throughout. `draft`
 * and `live` compute contacts, their effect on heads and wires, and the high band in single
 * precision; the states of heads and wires stay double.
 *
 * Below 88.2 kHz `studio` and `reference` step twice per sample, and a low-pass makes one sample of
 * the two: flat to 0.4535 of the sample rate, 104 dB down where sound would fold onto that. Its
 * delay of 1.84 samples counts as travel to the microphones; one closer to a head than 14 mm at
 * 48 kHz, or inside the drum, is so much later. Events act at samples.
 */
typedef enum TaborQuality {
  TABOR_QUALITY_DEFAULT, /**< in model options: the level of the definition */
  TABOR_QUALITY_DRAFT,
  TABOR_QUALITY_LIVE,
  TABOR_QUALITY_STUDIO,
  TABOR_QUALITY_REFERENCE
} TaborQuality;

/**
 * Kinds of striker. All are a lumped tip mass with a power-law contact; a brush has several, see
 * TaborStrikerDef.
 */
typedef enum TaborStrikerKind {
  TABOR_STRIKER_STICK,
  TABOR_STRIKER_MALLET,
  TABOR_STRIKER_FINGER,
  TABOR_STRIKER_BRUSH /**< many light bristles */
} TaborStrikerKind;

/** How a stroke is made. */
typedef enum TaborTechnique {
  /** The stick is free and rebounds. */
  TABOR_TECHNIQUE_NORMAL,
  /** A hand keeps pressing the stick, which bounces until it is released. */
  TABOR_TECHNIQUE_BUZZ,
  /** The stick comes down flat: its tip meets the head and, within a millisecond, its shaft meets
   * the hoop at the stroke's angle. */
  TABOR_TECHNIQUE_RIMSHOT,
  /** The tip rests on the head under the palm, and the shaft strikes the hoop on the opposite side
   * with the stroke's speed. The hand presses it there, and takes it away after 0.3 s, at a
   * release, or with the next cross-stick. */
  TABOR_TECHNIQUE_CROSS_STICK,
  /** The stick strikes only the hoop, at the stroke's angle. */
  TABOR_TECHNIQUE_RIM,
  /** A hand draws a brush over the head until it is released. */
  TABOR_TECHNIQUE_SWEEP,
  /** The foot stamps on the pedal of a hi-hat: it lifts the rod to hihat.lift if that is higher,
   * then brings it down to hihat.closed with the stroke's speed, at most hihat.speed, and keeps it
   * there. */
  TABOR_TECHNIQUE_PEDAL,
  /** A finger pulls a wire away from the head and lets go. */
  TABOR_TECHNIQUE_PLUCK
} TaborTechnique;

/** The kinds of body. */
typedef enum TaborBodyKind {
  TABOR_BODY_DRUM,  /**< a head or two on a shell, as [shell], [batter] and [resonant] say */
  TABOR_BODY_PLATE, /**< a round plate with a free edge, held in its middle: a disc, a cymbal */
  TABOR_BODY_HIHAT  /**< two plates, edge to edge, with a pedal */
} TaborBodyKind;

/** The body. */
typedef struct TaborBodyDef {
  uint32_t kind; /**< a TaborBodyKind, default drum */
} TaborBodyDef;

/**
 * A plate, flat or with the profile of a cymbal; its radius is R of [shell]. The damper and the
 * ring of [batter] lie on it. It has no wires, no resonant head and no hoop: strokes on the hoop
 * meet the plate. A thin plate, linear; flat, it is that of [Leissa1969]:
 * D lap^2 w + rho h w_tt + losses = forces, D = E h^3/(12 (1 - nu^2)),
 * and with a profile a shallow shell of revolution, stiff in its middle surface too
 * [ThomasTouzeChaigne2005]. Its thickness goes linearly from the middle to the edge; it rises by
 * bow (1 - r^2/R^2) + bell_height (1 - r^2/bell_radius^2)^2, the bell within its radius, and its
 * slope grows by flange_slope over the outer flange_width.
 * The amplitude of a mode at omega decays by (damping_0 + loss omega)/2 [1/s], the second in so far
 * as the plate is what is stiff, and by what it radiates. Air is on both sides.
 */
typedef struct TaborPlateDef {
  double thickness;       /**< h in the middle [m], 1e-4 to 0.02, default 0.001 */
  double youngs_modulus;  /**< E [Pa], 1e8 to 1e12, default 1.05e11 (bronze) */
  double poisson_ratio;   /**< nu, 0 to 0.49, default 0.34 */
  double density;         /**< rho [kg/m3], 100 to 30000, default 8650 */
  double damping_0;       /**< [1/s], 0 to 1000, default 0.5 */
  double loss;            /**< loss factor of its bending, 0 to 1, default 1e-4 */
  double heave_frequency; /**< at which it bounces on its mount [Hz], 5 to 200, default 50 */
  double tilt_frequency;  /**< at which it swings on its mount [Hz], 0.5 to 50, default 1.6 */
  double mount_damping; /**< of both motions, as a part of critical damping, 0 to 2, default 0.15 */
  double taper;         /**< thickness at the edge over that in the middle, 0.2 to 2, default 1 */
  double bow;           /**< rise of the middle without the bell [m], 0 to 0.05, default 0 */
  double bell_radius;   /**< [m], 0.01 to 0.6, default 0.055 */
  double bell_height;   /**< over the bow [m], 0 to 0.05, default 0: no bell */
  double flange_width;  /**< [m], 0.005 to 0.6 and at most R, default 0.04 */
  double flange_slope;  /**< at the edge, 0 to 1, default 0: no flange */
  double splitting;     /**< part by which modes of a pair differ, 0 to 0.05, default 0: none */
  double cascade;       /**< how fast energy goes up the spectrum beyond the modes that are coupled
                               one by one, 0 to 20, default 2 */
  double large_deflections; /**< part of the coupling of modes by stress in the middle surface, 0
                               to 1, default 1 as physics has it */
} TaborPlateDef;

/**
 * A hi-hat: the plate of [plate] above that of [bottom], both of the radius R, on one rod. Strokes
 * meet the upper one. The foot of the spring on which it bounces (heave_frequency) moves with the
 * pedal, so that at rest the edges would be `opening` apart where the gap is least, or pressed
 * together. Each length ds of edges that meet bears K eta^alpha (1 + lambda eta_t) ds, eta
 * the penetration.
 */
typedef struct TaborHihatDef {
  /** Openings [m], all of -0.01 to 0.03: between the edges, default -0.0015; live. */
  double opening;
  double closed; /**< what the foot's stroke and notes for a closed hi-hat set, default -0.0015 */
  double open;   /**< what notes for an open hi-hat set, default 0.008 */
  double lift;   /**< from where the foot stamps, default 0.005 */
  double speed;  /**< of the pedal's rod at most [m/s], 0.01 to 10, default 1.5 */
  double tilt;   /**< the widest gap less the least [m], 0 to 0.02, default 0.0016 */
  double unevenness;        /**< of the edges, at most [m], 0 to 0.005, default 1e-4 */
  uint32_t seed;            /**< draws the unevenness, default 1 */
  uint32_t points;          /**< around the edges, where they may meet, 4 to 64, default 16 */
  double contact_stiffness; /**< K [N/m^(1 + alpha)], 1e4 to 1e12, default 4e8 */
  double contact_exponent;  /**< alpha, 1 to 3, default 1.5 */
  double contact_loss;      /**< lambda [s/m], 0 to 50, default 5 */
  /** By which rate all motion decays faster for each newton that presses the edges together, while
   * neither striker nor hand touches [1/(N s)], 0 to 10, default 0.5 */
  double friction;
} TaborHihatDef;

/** The shell, which holds the heads. */
typedef struct TaborShellDef {
  double radius; /**< radius of every head [m], 0.05 to 0.60, default 0.1651 (13 inch) */
  /** Depth of the air below the batter head, down to the resonant head or to the bottom of a closed
   * drum [m], 0.01 to 1.5, default 0.14; of a single open or baffled head, the height of a shell
   * that moves. */
  double depth;
  uint32_t boundary; /**< a TaborBoundary, default open; a two-headed drum needs open */
  /** Part of the enclosed sound that a porous lining of the wall between two heads absorbs where
   * the lining is thicker than a quarter of a wavelength; half of it at 400 Hz: bare wood 0.05, a
   * pillow 0.25. 0 to 1, default 0. */
  double absorption;
  /** Mass of the wall between two heads per area [kg/m2], 0.1 to 1000, default 4.2 (6 mm of
   * plywood). The lighter the wall, the more of the enclosed sound it lets through. */
  double surface_density;
  /** Mass of the shell with lugs and the lower hoop [kg], 0.05 to 100, or 0: it does not move, nor
   * does the heads' edge. Default 0. */
  double mass;
  /** D = E h^3/(12 (1 - nu^2)) of its wall [N m], 1e-3 to 1e7, default 270 (7 mm of plywood). */
  double bending_stiffness;
  double loss; /**< loss factor of its bending, 0 to 1, default 0.03 */
  /** Frequency at which the drum would bounce on its stand [Hz], 5 to 200, default 20. */
  double stand_frequency;
  double stand_damping; /**< of that motion, as a part of critical damping, 0 to 2, default 0.3 */
} TaborShellDef;

/**
 * A head, [Torin2014] eq. (1)-(2): displacement w [m], rho w_tt = (T + dT) lap w - D lap^2 w -
 * sigma0 rho w_t - sigma_k rho sqrt(-lap) w_t + sigma1 rho lap w_t + forces. In vacuo the amplitude
 * of the mode of wavenumber K [1/m] decays by (sigma0 + sigma_k K + sigma1 K^2)/2 [1/s]. Without
 * bending stiffness the mode has omega = c K, c = sqrt(T/rho), so sigma_k alone gives all modes the
 * loss factor 1/Q = sigma_k/c. Large deflections raise the tension: dT = S/(2 A) Int |grad w|^2 dA,
 * A the head's area [Berger1955]. A damper, which exerts the force -c w_t on a small patch, may lie
 * on the head, and so may a ring of felt, which exerts -c w_t/A per area on what it covers, of area
 * A. If two defaults are given, the first is for the batter head, the second for the resonant head.
 *
 * Lugs tension the head around its rim. Lug j of n is at (j - 1/2) 360/n degrees. If their
 * tensions differ, pairs of the lower modes split into two frequencies and beat.
 */
typedef struct TaborHeadDef {
  double tension; /**< T [N/m], 100 to 20,000, default 3000 and 2600 */
  /** The pitch that a tuner reads at a lug [Hz]: the frequency of this head's lowest mode with one
   * nodal diameter, (1,1), in air, with even lugs and the other head held still; 1 to 20,000. It
   * takes precedence over `tension`, and tabor_drum_def_tune() turns it into one. 0, the default:
   * as `tension` says. */
  double pitch;
  double surface_density;   /**< rho [kg/m2], 0.02 to 5, default 0.262 and 0.105 */
  double bending_stiffness; /**< D [N m], 0 to 1, default 0.0023 and 1.5e-4 */
  double damping_0;         /**< sigma0 [1/s], 0 to 1000, default 12 */
  double damping_k;         /**< sigma_k [m/s], 0 to 5, default 0 */
  double damping_1;         /**< sigma1 [m2/s], 0 to 0.1, default 0.0016 */
  double stretch_stiffness; /**< S = E h/(1 - nu^2) of the sheet [N/m], 0 to 1e7, default 0 */
  /** The damper's distance from the centre [m], 0 to 0.6 and less than the shell's radius, default
   * 0. */
  double muffle_radius;
  double muffle_angle;    /**< the damper's direction [deg], -360 to 360, default 0 */
  double muffle_strength; /**< the damper's c [N s/m], 0 (none) to 30, default 0 */
  double ring_radius;     /**< of the middle of the felt ring [m], 0 to 0.6, default 0.1 */
  /** The felt ring's width [m], 0.001 to 1.2, default 0.03. Its outer edge lies on the head; one
   * that would reach beyond the centre is a disc. */
  double ring_width;
  double ring_strength; /**< the whole ring's c [N s/m], 0 (none) to 30, default 0 */
  /** Relative deviation of the mass per area from place to place, root mean square over patches of
   * some 3 cm, 0 to 0.3, default 0.12. It scatters waves above the two-way bandwidth, so that the
   * treble is noise instead of lines; 0: none. `lug_seed` draws it, too. */
  double unevenness;
  uint32_t lug_count; /**< 3 to 16, default 10 */
  /** Largest relative deviation of the tension at a lug, 0 to 0.5, default 0. The deviations are
   * drawn at random, with a mean of 0. */
  double lug_spread;
  uint32_t lug_seed; /**< seed of the draw, 0 to 4294967295, default 1 */
  /** lug[j - 1] replaces the relative deviation drawn for lug j, -0.5 to 0.5; NaN, the default,
   * keeps the drawn one. */
  double lug[TABOR_MAX_LUGS];
} TaborHeadDef;

/**
 * Snare wires or gut strings: stiff lossy strings, [Torin2014] eq. (3)-(4). Their contact
 * with the head is f = K eta^exponent max(0, 1 + lambda eta_t) per length, eta the penetration
 * [HuntCrossley1975]. These are the values that all wires share.
 */
typedef struct TaborWiresDef {
  uint32_t head;  /**< a TaborHead, default batter */
  uint32_t count; /**< 0 to 40, default 0 */
  uint32_t side;  /**< a TaborSide, default above */
  double length;  /**< between the ends [m], 0.02 to 1.5, default 0.30 */
  double spacing; /**< between neighbours [m], 0 to 0.1, default 0.002 */
  double angle;   /**< direction in which they run [deg], -360 to 360, default 0 */
  double offset;  /**< of their middle from the centre, across [m], -0.6 to 0.6, default 0 */
  double mass_per_length; /**< mu [kg/m], 1e-4 to 0.1, default 1.6e-3 */
  double tension;         /**< T [N], 0.01 to 200, default 5 */
  /** The tension of the head that carries the wires at which `tension` holds [N/m], 0 to 20000,
   * default 0. If that head is tighter or slacker, the wires are so, too, in proportion, within the
   * range of `tension`, so that their pitch keeps its distance from the head's. 0: their tension
   * does not follow. */
  double head_tension;
  double tension_spread; /**< largest relative deviation between wires, 0 to 0.9, default 0 */
  /** Seed of these deviations, and of how uneven wires lie, 0 to 4294967295, default 1. */
  uint32_t seed;
  double bending_stiffness; /**< EI [N m2], 0 to 0.1, default 1e-6 */
  double damping_0;         /**< sigma0 [1/s], 0 to 1000, default 2 */
  double damping_1;         /**< sigma1 [m2/s], 0 to 0.1, default 0.001 */
  double strainer;          /**< 0 (off) to 1 (on), default 1 */
  double strainer_travel;   /**< lift of the ends when it is off [m], 0 to 0.02, default 0.004 */
  /** Distance of the ends from the undeflected head, positive away from it [m], -0.01 to 0.02,
   * default 0. */
  double rest_offset;
  /** How unevenly the wires lie [m], 0 to 0.001, default 0. Offsets that are evenly spaced from
   * -rest_spread to rest_spread, times the unevenness, are added to `rest_offset`, to each wire
   * another one, in an order drawn from the seed. A single wire gets 0. */
  double rest_spread;
  /** How far the wires are bent along their length: root mean square of the height over a straight
   * wire [m], 0 to 0.001, times the unevenness, default 0. The bends are drawn from the seed. */
  double bend_height;
  /** Length L of these bends [m], 0.005 to 1, default 0.02: the heights at two places a distance d
   * apart have the correlation exp(-d^2/(2 L^2)). */
  double bend_length;
  /** Factor of `rest_spread` and `bend_height`, 0 (even and straight) to 3, default 1. The strainer
   * lifts uneven wires further, so that the lowest point of all comes as far off as if they were
   * even. */
  double unevenness;
  double contact_stiffness; /**< K [N/m^(exponent+1) per length], 1e4 to 1e13, default 1e8 */
  double contact_exponent;  /**< 1 to 3, default 1.5 */
  double contact_loss;      /**< lambda [s/m], 0 to 100, default 0.3 */
} TaborWiresDef;

/** One wire's own values, units and ranges as in TaborWiresDef. NaN means the value of [wires]. */
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
  double angle;             /**< direction in which it runs [deg] */
  double offset; /**< distance from the centre, across, in place of the even spacing [m] */
} TaborWireDef;

/**
 * A striker: a tip mass, [Torin2014] eq. (5), with the contact
 * f = K eta^exponent max(0, 1 + lambda eta_t) on a patch of the head. A brush divides its mass and
 * its contact among three groups of bristles, each on a patch of its own in a fan of radius
 * `spread`. A brush stroke is a slap; in a sweep a hand draws the brush over the head.
 */
typedef struct TaborStrikerDef {
  char name[TABOR_NAME_SIZE]; /**< 1 to TABOR_NAME_LENGTH letters, digits, '-' and '_' */
  uint32_t kind;              /**< a TaborStrikerKind */
  double mass;                /**< effective tip mass [kg], 1e-4 to 1, default 0.012 */
  /** Lowest frequency at which the free stick rings [Hz], 50 to 20,000, or 0: it does not bend;
   * default 400. Every stroke bends a stick. Rimshots and cross-sticks bend the shafts of other
   * strikers, too. */
  double bending_frequency;
  double contact_stiffness; /**< K [N/m^exponent], 1e3 to 1e13, default 3e6 */
  double contact_exponent;  /**< 1 to 3, default 1.5 */
  double contact_loss;      /**< lambda [s/m], 0 to 100, default 0.05 */
  double contact_radius;    /**< radius of the patch [m], 0 to 0.05, default 0.006 */
  uint32_t bristles;        /**< of a brush, 3 to 1000, default 200 */
  double spread;            /**< radius of a brush's fan [m], 0.005 to 0.15, default 0.04 */
  double sweep_speed;       /**< along the head in a sweep [m/s], 0.01 to 5, default 0.8 */
} TaborStrikerDef;

/**
 * The hand that presses a stick onto the head: M z_tt = f - 2 g (F0 + kh (z - z0) + ch z_t), M the
 * mass and z the height of the tip, f the contact force, g the grip, F0 the pressure, z0 the
 * height at which the hand took hold.
 */
typedef struct TaborHandDef {
  double stiffness; /**< kh at the tip at a grip of 0.5 [N/m], 0 to 1000, default 20 */
  double damping;   /**< ch at the tip at a grip of 0.5 [N s/m], 0 to 10, default 0.2 */
  /** Distance from the stick's butt to the hand [m], 0 to 0.3, default 0.12. The tip of a stick of
   * 0.4 m has its striker's mass if the hand holds it at 0.12 m; elsewhere a buzz stroke has more
   * or less. */
  double pivot;
  double grip; /**< g, 0 (open: a free rebound) to 1, default 0.5 */
} TaborHandDef;

/**
 * The hoop around the batter head. Rimshots, cross-sticks and strokes on the rim strike it. It
 * bends as a ring, and rods, lugs and the head's collar tie it to the shell. It is heard by what it
 * does to shell and heads: on a shell that does not move, strokes on it make no sound of their own.
 */
typedef struct TaborHoopDef {
  double height; /**< of its edge above the head [m], 0 to 0.05, default 0.012 */
  double mass;   /**< [kg], 0.05 to 20, default 1.2 */
  /** K of a stick's contact, f = K eta^1.5 [N/m^1.5], 1e5 to 1e11, default 1e8. A mallet or a
   * finger keeps its own contact. */
  double contact_stiffness;
  double contact_loss; /**< Hunt-Crossley lambda of a stick on it [s/m], 0 to 100, default 0.1 */
  /** EI of its section [N m2], 0.1 to 1e6, or 0: it moves with the shell. Default 0. */
  double bending_stiffness;
  double loss; /**< loss factor of its bending, 0 to 1, default 0.01 */
  /** Frequency at which the hoop moves on rods, lugs and the head's collar against a shell at rest
   * [Hz], 50 to 20,000, default 1600. */
  double tie_frequency;
  double tie_loss; /**< loss factor of rods and collar, 0 to 1, default 0.06 */
  double width; /**< seen from above, which its own sound depends on [m], 0 to 0.05, default 0.01 */
  /** Height of its section, which leans outwards and inwards as the hoop bends, and so sounds [m],
   * 0 to 0.1, default 0.028. */
  double wall;
  /** Torsional over bending stiffness of its section, 0.001 to 10, default 1, that of a rod. The
   * easier a section turns, the more its wall leans. */
  double torsion;
} TaborHoopDef;

/** The default stroke. */
typedef struct TaborStrikeDef {
  double velocity; /**< [m/s], 0.01 to 30, default 2.5 */
  double radius; /**< distance from the centre [m], 0 to 0.6 and up to the shell's, default 0.05 */
  double angle;  /**< [deg], -360 to 360, default 0 */
  char striker[TABOR_NAME_SIZE]; /**< its striker's name; "" means the first */
  uint32_t technique; /**< a TaborTechnique, default normal; sweep needs a brush, pedal a hi-hat */
} TaborStrikeDef;

/** Frequency response of a microphone, without latency and 0 dB at 1 kHz. Each but flat is typical
 * of its kind (engine/src/model/mic_response.c has the curves). */
typedef enum TaborMicResponse {
  TABOR_RESPONSE_FLAT,    /**< the sound pressure itself */
  TABOR_RESPONSE_DYNAMIC, /**< a cardioid dynamic microphone, as is put close to a snare drum */
  TABOR_RESPONSE_LARGE_DYNAMIC, /**< a dynamic microphone for bass drums */
  TABOR_RESPONSE_CONDENSER,     /**< a condenser microphone with a small diaphragm */
  TABOR_RESPONSE_EVEN_DYNAMIC   /**< a dynamic microphone without a rise in the treble */
} TaborMicResponse;

/** A microphone. It records the sound pressure at its place. */
typedef struct TaborMicDef {
  char name[TABOR_NAME_SIZE]; /**< 1 to TABOR_NAME_LENGTH letters, digits, '-' and '_' */
  double radius;              /**< distance from the axis [m], 0 to 10, default 0.05 */
  double angle;               /**< [deg], -360 to 360, default 90 */
  /** Height above the batter head, negative below [m]; 0.01 to 10 in magnitude, default 0.10. Not
   * within 0.01 m of a resonant head's plane. In a closed or two-headed shell, a microphone between
   * its ends hears the air inside; below the head of an open one it hears the air outside. */
  double height;
  double gain;       /**< a pure number, 0 to 100, default 1 */
  uint32_t response; /**< a TaborMicResponse, default flat */
} TaborMicDef;

/** The air, and gravity. */
typedef struct TaborAirDef {
  double density;     /**< rho0 [kg/m3], 0 (vacuum) to 5, default 1.205 */
  double sound_speed; /**< c0 [m/s], 100 to 2000, default 343 */
  double gravity;     /**< [m/s2], 0 to 30, default 9.81 */
} TaborAirDef;

/** Accuracy against cost, in parts. "0 = by level", the default, leaves it to the level. */
typedef struct TaborQualityDef {
  uint32_t level;           /**< a TaborQuality other than the default, default studio */
  double two_way_bandwidth; /**< modes up to here feel the contacts [Hz], 0 = by level, to 40,000 */
  double bandwidth;         /**< modes up to here are heard [Hz], 0 = by level, to 40,000 */
  uint32_t newton_cap;      /**< iterations per step at most, 0 = by level, to 16 */
  uint32_t wire_points;     /**< cells of a wire at most, 0 = by level, or 8 to 400 */
  uint32_t losses;          /**< 1, or 0 to switch off every loss and radiation; default 1 */
} TaborQualityDef;

/** A room with four walls, floor and ceiling. */
typedef enum TaborRoomKind {
  TABOR_ROOM_NONE,   /**< free air: adds nothing */
  TABOR_ROOM_BOOTH,  /**< 2.4 by 2.2 by 2.3 m; sound falls by 60 dB in 0.30 s, at 8 kHz in 0.20 s */
  TABOR_ROOM_STUDIO, /**< 6 by 5 by 3 m, 0.60 s and 0.45 s */
  TABOR_ROOM_HALL    /**< 20 by 15 by 9 m, 1.5 s and 0.9 s */
} TaborRoomKind;

/**
 * The room around a drum, for tabor_room_create(); the drum itself is computed in free air. "0 = by
 * kind", the default, takes the kind's own value.
 */
typedef struct TaborRoomDef {
  uint32_t kind; /**< a TaborRoomKind, default none */
  /** Length [m], 0 = by kind, or 1 to 100; width and height are in proportion as the kind has them.
   */
  double size;
  double decay; /**< 60 dB decay time of low notes [s], 0 = by kind, or 0.05 to 20 */
  /** 60 dB decay time at 8 kHz as a part of `decay`, 0 = by kind, or 0.25 to 1. The loss that comes
   * on top rises with the square of the frequency. */
  double tilt;
  double
    level; /**< factor on what the room adds, 0 to 10, default 1: as loud as in a diffuse field */
} TaborRoomDef;

/** A whole drum. Plain data: copy it by assignment. */
typedef struct TaborDrumDef {
  uint32_t struct_size;           /**< set by tabor_drum_def_default() */
  char name[TABOR_NAME_SIZE];     /**< name of the drum */
  char comment[TABOR_TEXT_SIZE];  /**< description, one line */
  char license[TABOR_NAME_SIZE];  /**< licence of the definition */
  char category[TABOR_NAME_SIZE]; /**< kind of drum, for lists: letters, digits, '-' and '_', or
                                     empty */
  TaborShellDef shell;            /**< [shell] of a preset */
  TaborHeadDef batter;            /**< [batter], the struck head */
  uint32_t two_headed;            /**< 1 with a resonant head, 0 without, default 0 */
  TaborHeadDef resonant;          /**< [resonant]; without effect and keys unless two_headed is 1 */
  TaborWiresDef wires;            /**< [wires] */
  TaborWireDef wire[TABOR_MAX_WIRES];          /**< wire[n - 1] is [wire.n] */
  uint32_t striker_count;                      /**< strikers defined, 1 to 8 */
  TaborStrikerDef striker[TABOR_MAX_STRIKERS]; /**< [striker.NAME]; the first is the default */
  TaborHandDef hand;                           /**< [hand] */
  TaborStrikeDef strike;                       /**< [strike] */
  uint32_t mic_count;                          /**< microphones defined, 1 to 8 */
  TaborMicDef mic[TABOR_MAX_MICS];             /**< [mic.NAME]; the first is the default */
  TaborAirDef air;                             /**< [air] */
  TaborQualityDef quality;                     /**< [quality] */
  double full_scale; /**< sound pressure that gives the sample 1.0 [Pa], 1e-3 to 1e5, default 20 */
  TaborHoopDef hoop; /**< [hoop] */
  TaborRoomDef room; /**< [room] */
  TaborBodyDef body; /**< [body] */
  TaborPlateDef plate;  /**< [plate]; without effect and keys if body.kind is drum */
  TaborPlateDef bottom; /**< [bottom]: the lower plate of a hi-hat, which is linear */
  TaborHihatDef hihat;  /**< [hihat]; both without effect and keys unless body.kind is hihat */
} TaborDrumDef;

/** Type of a parameter's value. */
typedef enum TaborParameterType {
  TABOR_TYPE_NUMBER, /**< a double */
  TABOR_TYPE_WHOLE,  /**< a uint32_t */
  TABOR_TYPE_CHOICE, /**< one word of a list, stored as its enumerator */
  TABOR_TYPE_TEXT    /**< characters */
} TaborParameterType;

/**
 * One row of the parameter table, from which defaults, validation, presets, live changes and
 * documentation are made.
 */
typedef struct TaborParameter {
  uint32_t id;             /**< never changes, never reused */
  const char *section;     /**< "batter"; "striker.", "mic.", "wire." if a name or number follows */
  const char *key;         /**< "tension" */
  const char *unit;        /**< "N/m"; "" for a pure number */
  TaborParameterType type; /**< type of its value */
  double minimum;          /**< of numbers and whole numbers; NaN otherwise */
  double maximum;          /**< of numbers and whole numbers; NaN otherwise */
  /** Default; for a choice the index in @p choices. NaN for text, for the values of single wires,
   * which follow [wires], and for the deviations of single lugs, which are drawn. */
  double fallback;
  const char *choices; /**< of a choice: the words, separated by '|'; NULL otherwise */
  bool logarithmic;    /**< a control should move in equal ratios */
  bool live;           /**< TABOR_EVENT_PARAMETER may change it while the drum rings */
  const char *text;    /**< description, one line */
} TaborParameter;

/** A built-in preset. */
typedef struct TaborPresetInfo {
  const char *name;     /**< for tabor_drum_def_preset() */
  const char *comment;  /**< description, one line */
  const char *file;     /**< name of its text file in presets/ */
  const char *category; /**< for lists, such as "snare"; "kit" of a kit */
  const char
    *base; /**< of a tuning: the preset that it changes; NULL of a drum of its own and of a kit */
} TaborPresetInfo;

/** @name Set-up: definitions
 * SET-UP: any thread but the audio thread. */
/** @{ */

/** The library's version, such as "0.2.0", or "0.2.0-dev" before its release. Static storage. */
TABOR_API const char *tabor_version(void);

/** Number of rows of the parameter table. */
TABOR_API uint32_t tabor_parameter_count(void);
/** Row @p index of the parameter table, from 0; NULL past its end. Static storage. */
TABOR_API const TaborParameter *tabor_parameter(uint32_t index);
/** The row of a full key such as "batter.tension" or "mic.top.gain"; NULL if there is none. */
TABOR_API const TaborParameter *tabor_parameter_find(const char *key);

/** Number of built-in presets. */
TABOR_API uint32_t tabor_preset_count(void);
/** Built-in preset @p index in listed order, from 0; NULL past the end. Static storage. */
TABOR_API const TaborPresetInfo *tabor_preset(uint32_t index);

/** Sets every field to its default: one head, no wires, striker "stick", microphone "top". */
TABOR_API void tabor_drum_def_default(TaborDrumDef *def);
/**
 * Sets @p def to the defaults, without any striker or microphone. This is where reading a preset
 * starts.
 */
TABOR_API void tabor_drum_def_clear(TaborDrumDef *def);
/**
 * Loads the built-in preset @p name. TABOR_ERROR_NAME if there is none; the message suggests a
 * similar name.
 */
TABOR_API TaborStatus tabor_drum_def_preset(TaborDrumDef *def, const char *name, TaborError *error);
/**
 * Sets one parameter from text, for example the key "batter.tension" to "3000". Numbers are read
 * independently of the locale. A pitch may be a note, as "A3", "F#3" or "Eb2+30" (30 cents sharp),
 * A4 = 440 Hz; of tension and pitch of a head the one that is set later counts. A new NAME in
 * "striker.NAME.mass" or "mic.NAME.gain" adds that striker or microphone, and any "resonant." key
 * makes a one-headed drum two-headed; the other fields of what is added get their defaults. On an
 * error @p def is unchanged: TABOR_ERROR_KEY (the message suggests a similar key if there is one),
 * TABOR_ERROR_VALUE, TABOR_ERROR_RANGE, TABOR_ERROR_FULL. Rules that involve several fields are
 * checked by tabor_drum_def_validate().
 */
TABOR_API TaborStatus tabor_drum_def_set(TaborDrumDef *def, const char *key, const char *value,
                                         TaborError *error);
/**
 * Begins a section of a preset, such as "resonant", "striker.stick" or "air". If @p def lacks this
 * resonant head, striker or microphone, adds it with its defaults; otherwise changes nothing. On
 * an error @p def is unchanged: TABOR_ERROR_KEY (the message suggests a similar section if there
 * is one), TABOR_ERROR_FULL.
 */
TABOR_API TaborStatus tabor_drum_def_section(TaborDrumDef *def, const char *section,
                                             TaborError *error);
/**
 * Writes the value of @p key to @p text, in at most @p size bytes with the terminator.
 * tabor_drum_def_set() reads the text back to the same bits. A wire's value that follows [wires]
 * is written as "". TABOR_ERROR_NAME if the drum lacks the striker, microphone or resonant head;
 * TABOR_ERROR_KEY if the key is unknown; TABOR_ERROR_ARGUMENT if the text does not fit.
 */
TABOR_API TaborStatus tabor_drum_def_get(const TaborDrumDef *def, const char *key, char *text,
                                         size_t size, TaborError *error);
/**
 * Writes full key @p index of @p def, from 0 in preset order, to @p key, which has @p size bytes.
 * False past the last key, or if the key does not fit; 2 * TABOR_NAME_SIZE bytes are enough.
 * Values of single wires that are not set, and the resonant keys of a one-headed drum, are
 * skipped.
 */
TABOR_API bool tabor_drum_def_key(const TaborDrumDef *def, uint32_t index, char *key, size_t size);
/**
 * Checks the range of every field and the rules between fields. On an error it returns
 * TABOR_ERROR_ARGUMENT, TABOR_ERROR_VALUE, TABOR_ERROR_RANGE or TABOR_ERROR_NAME, and @p error
 * names the first offending key.
 */
TABOR_API TaborStatus tabor_drum_def_validate(const TaborDrumDef *def, TaborError *error);
/**
 * Checks @p def like tabor_drum_def_validate() and replaces pitches by tensions: each head with a
 * pitch gets the tension that gives it, rounded to 0.01 N/m, and the pitch 0. A pitch depends on
 * radius, depth, boundary and air, and on the head's other values, so call this when all of them
 * are set; tabor_model_create() does. On an error @p def is unchanged: those of
 * tabor_drum_def_validate(), TABOR_ERROR_RANGE if no tension of the allowed range gives the pitch
 * (minimum and maximum of @p error are then those of the pitches that the head can have),
 * TABOR_ERROR_MEMORY, TABOR_ERROR_NUMERICS. Takes some hundredths of a second if there is a pitch.
 * A plate has no heads, and stays as it is.
 */
TABOR_API TaborStatus tabor_drum_def_tune(TaborDrumDef *def, TaborError *error);
/**
 * Computes the pitch [Hz] of @p head, a TaborHead, from its tension, or returns the one that is
 * set. Errors as for tabor_drum_def_tune(), and TABOR_ERROR_NAME if @p def has no such head.
 */
TABOR_API TaborStatus tabor_drum_def_pitch(const TaborDrumDef *def, uint32_t head, double *pitch,
                                           TaborError *error);
/** Index of the striker @p name, or -1. */
TABOR_API int tabor_drum_def_find_striker(const TaborDrumDef *def, const char *name);
/** Index of the microphone @p name, or -1. */
TABOR_API int tabor_drum_def_find_mic(const TaborDrumDef *def, const char *name);
/** @} */

/* ------------------------------------------------------------------------------------------------
 * Text
 * --------------------------------------------------------------------------------------------- */

#define TABOR_TEXT_LIMIT 1048576 /**< longest text [bytes] */
#define TABOR_TEXT_LINE 511      /**< longest line of a text, without its end [bytes] */
#define TABOR_TEXT_WORD 127      /**< longest name of a section, and longest key [bytes] */

/** A line of a text: a section begins, or a key has a value. Pointers are good until the call
 * returns. */
typedef struct TaborTextLine {
  const char *section; /**< in which it stands, or which begins; "" before the first */
  const char *key;     /**< NULL where a section begins */
  const char *full;    /**< the key with its section, "batter.tension"; of a section its name */
  const char *value;   /**< "" if nothing follows the '='; NULL where a section begins */
  uint32_t number;     /**< of the line, from 1 */
} TaborTextLine;

/** Takes a line for tabor_text_read(). Anything but TABOR_OK, with a message in @p error, ends the
 * reading. */
typedef TaborStatus TaborTextTake(void *context, const TaborTextLine *line, TaborError *error);

/** The purpose of a text. */
typedef enum TaborTextForm {
  TABOR_TEXT_EDIT, /**< for people: units and descriptions as comments; of a kit's drum what its
                      preset has otherwise */
  TABOR_TEXT_KEEP  /**< for sessions and logs: every value and no comment, the same in every version
                    */
} TaborTextForm;

/** @name Set-up: definitions as text
 * SET-UP: any thread but the audio thread.
 *
 * Files of presets and kits, and all else of this form, are UTF-8:
 *
 *     ; a comment
 *     [batter]
 *     tension = 3000   ; N/m: why
 *
 * A comment begins with ';', after a value with a blank and ';', and a line of it with '#', too. A
 * value that could be a mistake is refused: control characters but tabs and line ends; invalid
 * UTF-8; lines, names of sections and keys that are too long; indented lines; text behind a
 * section's ']'; a line without '='; sections, and keys of a section, that occur twice; and a last
 * line without a line end, since a text that was cut off there would give another number. A key
 * that stands before the first section has to be a full one, as `batter.tension`. */
/** @{ */

/**
 * Gives each section and each key of a text to @p take, in order; none if the text as a whole is
 * malformed.
 *
 * @param text    @p size bytes, which need no terminator.
 * @param size    0 to TABOR_TEXT_LIMIT.
 * @param take    takes them.
 * @param context goes to @p take.
 * @param error   says what is wrong and in which line and column; its message does not repeat them.
 * May be NULL.
 *
 * Errors: TABOR_ERROR_VALUE for a malformed text, TABOR_ERROR_MEMORY, and what @p take returns.
 */
TABOR_API TaborStatus tabor_text_read(const char *text, size_t size, TaborTextTake *take,
                                      void *context, TaborError *error);
/**
 * Reads a definition from the text of a preset file: what tabor_drum_def_set() makes of each key,
 * after tabor_drum_def_clear(), or after tabor_drum_def_preset() if the first key is `base` of
 * [drum], a built-in preset's name. On an error @p def is unchanged: those of tabor_text_read(),
 * tabor_drum_def_set() and tabor_drum_def_section(). Rules that involve several fields are left to
 * tabor_drum_def_validate().
 */
TABOR_API TaborStatus tabor_drum_def_read(TaborDrumDef *def, const char *text, size_t size,
                                          TaborError *error);
/**
 * Writes a definition as the text of a preset file, which tabor_drum_def_read() reads back to the
 * same bits.
 *
 * @param def    the definition.
 * @param form   a TaborTextForm.
 * @param text   receives the text with its terminator; NULL: its length alone is asked for.
 * @param size   bytes of @p text; 0 if that is NULL.
 * @param length receives the bytes without the terminator, unless it is NULL.
 * @param error  may be NULL.
 *
 * Errors: TABOR_ERROR_VALUE for a text parameter that would read back otherwise, as there are no
 * quotes (it begins or ends with a blank, begins with ';', or has " ;" in it); those of
 * tabor_drum_def_get(); TABOR_ERROR_ARGUMENT if the text does not fit: @p text is then "".
 */
TABOR_API TaborStatus tabor_drum_def_write(const TaborDrumDef *def, uint32_t form, char *text,
                                           size_t size, size_t *length, TaborError *error);
/** @} */

/* ------------------------------------------------------------------------------------------------
 * Model
 * --------------------------------------------------------------------------------------------- */

/**
 * Everything that is computed once from a definition and a sample rate. Immutable, shared by
 * drums, and counted by references.
 */
typedef struct TaborModel TaborModel;

/** Instruction sets for the kernels. All compute the same bits. */
typedef enum TaborInstructions {
  TABOR_INSTRUCTIONS_AUTO,     /**< the widest that the processor has */
  TABOR_INSTRUCTIONS_BASELINE, /**< the set that the library was compiled for */
  TABOR_INSTRUCTIONS_AVX2,     /**< the baseline if the processor lacks AVX2 */
  TABOR_INSTRUCTIONS_AVX512    /**< the next narrower set if the processor lacks AVX-512 */
} TaborInstructions;

/** Source of memory. */
typedef struct TaborAllocator {
  void *(*allocate)(size_t size, void *context); /**< memory aligned to 64 bytes, or NULL */
  void (*release)(void *memory, void *context);  /**< takes it back; ignores NULL */
  void *context;                                 /**< passed to both functions */
} TaborAllocator;

/**
 * Hears how far the build of a model is: @p done from 0 to 1, which grows unevenly. It is called on
 * the building thread, every 5 to 50 ms on a processor of today. If it returns false, the build
 * ends with TABOR_ERROR_CANCELLED. To cancel from another thread, let it read an atomic flag.
 */
typedef bool (*TaborBuildProgress)(double done, void *context);

/** Options of a model. Fill them with tabor_model_options_default() first. */
typedef struct TaborModelOptions {
  uint32_t struct_size;  /**< set by tabor_model_options_default() */
  double sample_rate;    /**< [Hz], 22,050 to 192,000, default 48,000 */
  uint32_t quality;      /**< a TaborQuality, default TABOR_QUALITY_DEFAULT */
  uint32_t instructions; /**< a TaborInstructions, default TABOR_INSTRUCTIONS_AUTO */
  TaborAllocator
    allocator; /**< if both functions are NULL, the C library's, which is the default */
  TaborBuildProgress progress; /**< may be NULL, the default */
  void *progress_context;      /**< passed to progress */
  /** Most seconds of processor time that the build may take, with the search for a pitch; 0, the
   * default, is no limit. A model that takes more by tabor_model_estimate() is refused at once, and
   * a build that takes more is ended, 50 ms later at most on a processor of today, with
   * TABOR_ERROR_LIMIT, whose key is that of the parameter to lower. (On Windows and in WebAssembly,
   * which have no such clock, the time of day counts.) */
  double most_seconds;
  size_t most_bytes; /**< most memory by tabor_model_estimate() */
} TaborModelOptions;

/** The cost of building a model. */
typedef struct TaborModelEstimate {
  double seconds; /**< of processor time on one core of a server of 2024; for most definitions right
                     within a factor of 3 */
  size_t bytes;   /**< memory while it is built; right within a factor of 3 */
  char
    key[TABOR_NAME_SIZE]; /**< of the parameter that costs most of it, as `quality.wire_points` */
} TaborModelEstimate;

/** Facts of a model. */
typedef struct TaborModelInfo {
  double sample_rate; /**< [Hz] */
  /** Steps per second: twice the sample rate at `studio` and `reference` below 88.2 kHz, otherwise
   * the sample rate. */
  double step_rate;
  uint32_t quality;    /**< a TaborQuality, never the default */
  uint32_t mode_count; /**< modes; cosine and sine copies count as two */
  uint32_t mode_rows;  /**< rows of tabor_model_mode(); the two copies count as one */
  /** [Hz]; less than requested if more modes were needed than 4096, at `studio` 8192, at
   * `reference` 16,384. */
  double two_way_bandwidth;
  double bandwidth;         /**< [Hz], with the one-way high band */
  uint32_t high_mode_count; /**< modes of the high band */
  uint32_t newton_cap;      /**< iterations per step at most */
  uint32_t wire_count;      /**< wires */
  uint32_t contact_points;  /**< contact points of all wires together */
  uint32_t mic_count;       /**< microphones, the channels of tabor_drum_process() */
  size_t model_bytes;       /**< memory of the model */
  size_t drum_bytes;        /**< memory of each drum on it: its state, and another for silences */
} TaborModelInfo;

/** The part of the drum that a mode moves most. */
typedef enum TaborModePart {
  TABOR_PART_BATTER,   /**< the batter head, with over 90 % of the heads' energy */
  TABOR_PART_RESONANT, /**< the resonant head, with over 90 % of the heads' energy */
  TABOR_PART_BOTH,     /**< both heads */
  TABOR_PART_CAVITY,   /**< the air between them, with over half of all kinetic energy */
  TABOR_PART_RIM,      /**< hoop and shell, with over half of all kinetic energy */
  TABOR_PART_PLATE,    /**< a plate; of a hi-hat, the upper one */
  TABOR_PART_BOTTOM    /**< the lower plate of a hi-hat */
} TaborModePart;

/** One mode of the heads with their air, hoop and shell, or of a plate with its air. */
typedef struct TaborModeInfo {
  uint32_t m; /**< nodal diameters of the Bessel function that moves most */
  uint32_t
    n; /**< its nodal circles counting the rim, from 1; a plate has none at its edge: from 0 */
  double frequency;      /**< [Hz] */
  double decay_rate;     /**< of the amplitude [1/s] */
  double radiation_rate; /**< the part of decay_rate that is due to radiated sound [1/s] */
  uint32_t multiplicity; /**< 1, or 2 with a sine copy */
  TaborModePart part;    /**< the part that moves most */
  int32_t phase;         /**< of two heads: 1 if they move together, -1 if in opposition; else 0 */
} TaborModeInfo;

/** @name Set-up: models
 * SET-UP: any thread but the audio thread. */
/** @{ */

/** Fills in the defaults. */
TABOR_API void tabor_model_options_default(TaborModelOptions *options);
/**
 * Says what tabor_model_create() would take, in some milliseconds. A pitch is not looked for, and
 * one that the head cannot have is not refused here. On an error, those of
 * tabor_drum_def_validate(), or TABOR_ERROR_ARGUMENT or TABOR_ERROR_RANGE for
 * @p options, *estimate is 0.
 */
TABOR_API TaborStatus tabor_model_estimate(const TaborDrumDef *def,
                                           const TaborModelOptions *options,
                                           TaborModelEstimate *estimate, TaborError *error);
/**
 * Computes a model. The caller owns one reference to it. @p options may be NULL for the defaults.
 * On an error *model is NULL: the errors of tabor_drum_def_tune(), TABOR_ERROR_ARGUMENT or
 * TABOR_ERROR_RANGE for @p options, TABOR_ERROR_RANGE for a drum that cannot be computed,
 * TABOR_ERROR_LIMIT, TABOR_ERROR_CANCELLED, TABOR_ERROR_MEMORY, TABOR_ERROR_NUMERICS. On a desktop
 * processor the built-in presets take a quarter of a second at live and about a second at studio.
 * With heads of twice their size, or at reference, a model takes some seconds; at reference at 88.2
 * kHz and more, half a minute.
 */
TABOR_API TaborStatus tabor_model_create(const TaborDrumDef *def, const TaborModelOptions *options,
                                         TaborModel **model, TaborError *error);
/** Adds a reference, atomically, and returns @p model. */
TABOR_API TaborModel *tabor_model_retain(TaborModel *model);
/** Removes a reference, atomically; removing the last one frees the model. Ignores NULL. */
TABOR_API void tabor_model_release(TaborModel *model);
/** The definition that the model was built from, with tensions for pitches; valid as long as the
 * model. */
TABOR_API const TaborDrumDef *tabor_model_definition(const TaborModel *model);
/** Number of bytes that tabor_model_save() writes: 1 to 4 MB for the built-in presets at live. */
TABOR_API size_t tabor_model_saved_size(const TaborModel *model);
/**
 * Writes @p model to @p bytes, tabor_model_saved_size() of them, so that a program or a game starts
 * without building it. They are for the same version of this library on processors of the same
 * kind, whatever instructions these have and whatever the operating system.
 */
TABOR_API void tabor_model_save(const TaborModel *model, void *bytes);
/**
 * Makes a model of saved bytes, in a fraction of the time that building it takes. It plays the same
 * bits, and states saved on one load on the other. Only `instructions` and `allocator` of
 * @p options, which may be NULL, count. @p bytes may go afterwards. On an error *model is NULL:
 * TABOR_ERROR_STATE for bytes that are damaged, cut off, or of another version or machine;
 * TABOR_ERROR_ARGUMENT or TABOR_ERROR_RANGE for @p options; TABOR_ERROR_MEMORY. A checksum tells
 * damage, not malice: load what you saved yourself, as you would run a program.
 */
TABOR_API TaborStatus tabor_model_load(const void *bytes, size_t size,
                                       const TaborModelOptions *options, TaborModel **model,
                                       TaborError *error);
/** Fills in the facts of @p model. */
TABOR_API void tabor_model_info(const TaborModel *model, TaborModelInfo *info);
/** Fills in mode @p row, from 0 in order of frequency; false past the last. */
TABOR_API bool tabor_model_mode(const TaborModel *model, uint32_t row, TaborModeInfo *mode);
/**
 * The shape of mode @p row on a surface, 0 (batter head, upper plate) or 1, at the distance
 * @p radius from the centre [m]: the displacement there is *shape times the mode's amplitude times
 * cos(m angle), or sin(m angle) of its copy. Modal masses are 1 kg, so a unit is kg^-1/2. A circle
 * where it is 0 is a node. False without such a row or surface, beyond the edge, or of a drum whose
 * lugs have tensions of their own, whose modes have no single m; *shape is then 0.
 */
TABOR_API bool tabor_model_mode_shape(const TaborModel *model, uint32_t row, uint32_t surface,
                                      double radius, double *shape);
/** @} */

/* ------------------------------------------------------------------------------------------------
 * Drum
 * --------------------------------------------------------------------------------------------- */

/** The state of one sounding drum. */
typedef struct TaborDrum TaborDrum;
/** A prepared change of a drum's model. */
typedef struct TaborSwap TaborSwap;

/** Types of event. Each names the fields of TaborEvent that it uses besides frame and type. */
typedef enum TaborEventType {
  /** A stroke: id, striker, velocity, radius, angle, technique; value is the pressure of a buzz or
   * a sweep, 0 to 1. A sweep circles the centre at this radius, counter-clockwise, at this
   * velocity (up to 5 m/s) until it is moved. A pressed striker with the same id, unless that is
   * 0, is taken away: one hand holds one stick. A pluck has other fields: striker is the index of
   * the wire, radius the place along it as a part of its length, 0 to 1, value the displacement to
   * which the finger would pull it if it touched nothing [m], 0 to 0.05, and velocity the mean
   * speed of the pull [m/s]: it lets go after value/velocity, 0.1 ms to 10 s. Its work is booked as
   * injected. A swap lets go. A pedal's stroke has the velocity alone. */
  TABOR_EVENT_STRIKE = 1,
  /** Presses strikers in play onto the head, or changes their pressure: id (0 for all), value. The
   * values 0 to 1 are 0.3 to 8 N in equal ratios at a grip of 0.5. Pressed strikers bounce (a
   * buzz) and stay until they are released or 0.2 m away. */
  TABOR_EVENT_PRESS = 2,
  /** A damping hand on the head: id, radius, angle, value [N s/m]. At more than 0.9 of the radius
   * of a plate it grips the edge, and all motion decays alike: 30 N s/m choke a crash cymbal in a
   * quarter of a second. There is one such hand at most. */
  TABOR_EVENT_DAMP = 3,
  /** Lifts damping hands and brushes and takes strikers away: id (0 for all). */
  TABOR_EVENT_RELEASE = 4,
  /** Changes a live parameter: parameter, index, value. */
  TABOR_EVENT_PARAMETER = 5,
  /** Changes the model of the drum, which rings on: swap. */
  TABOR_EVENT_SWAP = 6,
  /** Brings the drum to rest; ledger and statistics start again from 0. */
  TABOR_EVENT_RESET = 7,
  /** Moves sweeping brushes to radius and angle, the shorter way round, in value seconds, 0 to
   * 60: id (0 for all), radius, angle, value. The value 0 is for a stream of moves: the move then
   * takes the time since the last one, limited to 5 to 100 ms. */
  TABOR_EVENT_MOVE = 8,
  /** Fades out what sounds over 15 ms: strikers, hands and older sounds, too. Events from this
   * frame on act at once, on a drum at rest. Live values, ledger and counters go on. Does nothing
   * if nothing sounds. Another silence during the fade cuts the older sound short. */
  TABOR_EVENT_SILENCE = 9,
  /** Changes the gain of all outputs: value, a factor from 0 to 1e6, reached over 5 ms, or at once
   * while the drum is silent; 1 at first and after a reset. It outlives swaps, replacements and
   * silences. */
  TABOR_EVENT_GAIN = 10,
  /** Replaces the drum by another one, at rest and with the live values of its definition: swap. */
  TABOR_EVENT_REPLACE = 11
} TaborEventType;

/** Something that happens at a frame of a block. Set unused fields to 0; they are ignored. */
typedef struct TaborEvent {
  uint32_t frame;     /**< offset into the block; events are sorted by it */
  uint32_t type;      /**< a TaborEventType */
  uint32_t id;        /**< the caller's number for a stroke or hand; 0 means anonymous */
  uint32_t striker;   /**< index into the definition's strikers */
  uint32_t parameter; /**< id of a live parameter */
  uint32_t index;     /**< of the microphone, for mic.*.gain */
  uint32_t technique; /**< a TaborTechnique */
  double velocity;    /**< [m/s], clamped to 0.01 to 30 */
  double radius;      /**< [m] from the centre, clamped to the head */
  double angle;       /**< [deg] */
  double value;       /**< of a parameter, clamped to its range; strength of a damping hand [N s/m],
                           0 to 100; pressure, 0 to 1; duration of a move [s] */
  TaborSwap *swap;    /**< for TABOR_EVENT_SWAP and TABOR_EVENT_REPLACE */
} TaborEvent;

/** Sound from outside that drives a drum. */
typedef struct TaborSound {
  uint32_t mic; /**< microphone of the definition at whose place the source is; of no matter past
                   the last */
  /** [frames] [Pa]: the pressure that the source would cause at the centre of the batter head if
   * the drum were not there, ahead by the sound's way to the drum; NULL: silence. Samples must be
   * finite. */
  const float *pressure;
} TaborSound;

/** Counters since creation or reset, which go on through silences, swaps and replacements, and the
 * strikers and hands in play. */
typedef struct TaborStatistics {
  uint64_t frames;            /**< frames processed, sleeping ones included */
  uint64_t slept_frames;      /**< frames processed asleep */
  uint64_t strikes;           /**< strokes begun */
  uint64_t late_events;       /**< offset past the block; carried out at its last frame */
  uint64_t misordered_events; /**< out of order; carried out at the previous event's frame */
  /** Events that were not carried out: unknown, not finite, too many (see tabor_drum_process()), or
   * nothing was free to carry them out; and strokes that another stroke of the same hand replaced
   * before they touched. */
  uint64_t dropped_events;
  uint64_t solves;            /**< steps with a contact to solve */
  uint64_t newton_iterations; /**< sum over the solves */
  uint32_t newton_max;        /**< most in one step */
  uint64_t newton_capped;     /**< solves that reached the cap before convergence */
  uint64_t work_corrected;    /**< capped solves whose forces were scaled to create no energy */
  uint64_t fallbacks;         /**< capped solves that were replaced by majorant steps */
  uint64_t guarded;           /**< steps shortened by the energy guard */
  uint64_t recovered;         /**< resets after a state that was not finite */
  uint64_t contact_sum;       /**< touching points, summed over the solves */
  uint32_t contact_max;       /**< most touching points in one step */
  uint32_t in_play;           /**< strikers and damping hands in play now */
} TaborStatistics;

/**
 * The energy account, in joules since creation or reset:
 * injected + control = stored + head_loss + wire_loss + contact_loss + damper_loss + shell_loss
 *                      + radiated + removed + residual.
 * The magnitude of the residual is at most 1e-9 of injected + |control| at `studio` and
 * `reference`; at `draft` and `live` it is at most 1e-6 of that, and 2e-12 J on top of it for each
 * second that wires rest on a head. (Contacts in single precision know the work of the wires' own
 * rest forces to 1.5e-6, so that this part falls with the motion, and not with its square; see
 * docs/limits.md.) The exception is a contact solver stopped at its cap (newton_capped), where a
 * drum may lose more energy, but never gains any.
 */
typedef struct TaborLedger {
  /** Kinetic energy of launched strikers, and the work of pressing hands, their springs and sound
   * from outside. */
  double injected;
  /** Work of parameter changes, silences, swaps and replacements, positive or negative. */
  double control;
  double stored; /**< above the rest state, strikers in flight included */
  /** In the heads' material, or in a plate and its mount; and what the low modes of a closed drum
   * lose to the air beyond what `radiated` has of them, a few per cent of that, or what they lose
   * less. */
  double head_loss;
  double wire_loss;    /**< in the wires' material */
  double contact_loss; /**< Hunt-Crossley loss of wires and strikers */
  /** In damping hands, in the dampers of pressing hands, and in hands whose sticks bend. */
  double damper_loss;
  /** In hoop and shell; and in the enclosed air, by friction, heat conduction and absorption at its
   * walls. */
  double shell_loss;
  /** As sound, by heads, hoop and shell, or a plate: of the low modes of a closed drum what their
   * field carries far away, of others, and while sound from outside drives the drum, what modes
   * lose to the air. */
  double radiated;
  double removed;   /**< energy of strikers that were taken away */
  double high_band; /**< stored in the one-way high band; not part of the balance */
  double residual;  /**< energy that the numerics lost (positive) or created (negative) */
} TaborLedger;

/** Positions and forces in the newest state. All heights [m] are above the undeflected head. */
typedef struct TaborProbe {
  double head;          /**< of the centre of the head with the wires */
  double wire;          /**< of the first wire's midpoint; NaN without wires */
  double striker;       /**< of the newest striker in play; NaN without one */
  double striker_force; /**< between all strikers and head or hoop [N]; NaN without a striker */
  double wire_force;    /**< between all wires and the head, or a hi-hat's edges [N]; NaN without */
} TaborProbe;

#define TABOR_VIEW_RADII 32        /**< radii of a view's grid at most */
#define TABOR_VIEW_ANGLES 96       /**< angles of a view's grid at most */
#define TABOR_VIEW_WIRE_POINTS 200 /**< points of each wire in a view at most */
#define TABOR_VIEW_STICKS 16       /**< sticks in a view at most */

/** The extent of a view. A field that is 0 takes its default. */
typedef struct TaborViewGrid {
  uint32_t radii;  /**< circles of the heads, from the centre to the edge, 2 to 32, default 16 */
  uint32_t angles; /**< points of each circle, 1 to 96, default 48 */
  uint32_t wire_points; /**< points of each wire, 2 to 200, default 33 */
  /** The heads' motion is that of the two-way modes up to here [Hz], default 1500, which is enough
   * for the eye; infinity: all of them. The one-way high band is never part of it. The work of
   * tabor_drum_view() grows with the number of these modes. */
  double bandwidth;
} TaborViewGrid;

/** The place where a striker touches, or will. A stick that meets head and hoop has two, a brush
 * has one for each group of bristles. */
typedef struct TaborViewStick {
  uint32_t id;      /**< the caller's, of its stroke */
  uint32_t striker; /**< index into the definition's strikers */
  uint32_t on_hoop; /**< 1: it meets the hoop, 0: the head */
  double radius;    /**< of its place, from the centre [m] */
  double angle;     /**< of its place [deg] */
  /** Height of this point above the undeflected batter head [m], as if it did not yield: one that
   * touches is lower than the head by what the contact is compressed, a finger by millimetres. */
  double height;
  double force; /**< between it and head or hoop [N] */
} TaborViewStick;

/**
 * The shape of a drum at one instant. At place (i, j) of a head, i counts the circles and j the
 * angles: the radius is i/(radii - 1) of the shell's, so that the first circle is the centre and
 * the last one the edge, and the angle is j 360/angles degrees. Points of a wire are evenly spaced
 * from end to end, both ends included. Heights of heads and wires count from the plane of the
 * bearing edge, wherever the shell moves; those of sticks from this plane at rest. The caller reads
 * the fields and changes none.
 */
typedef struct TaborView {
  uint32_t heads;       /**< 1, or 2 with a resonant head */
  uint32_t radii;       /**< circles of the grid */
  uint32_t angles;      /**< points of each circle */
  uint32_t wire_count;  /**< wires */
  uint32_t wire_points; /**< points of each wire; 0 without wires */
  uint32_t mode_count;  /**< modes that the heads' motion is a sum of; copies count as two */
  double radius;        /**< of the heads [m] */
  double bandwidth;     /**< of these modes [Hz] */
  /** displacement[head][i * angles + j], in the order of TaborHead: height of the head above its
   * own undeflected plane [m]. Wires deflect their head also at rest. NULL for a head that the drum
   * does not have. */
  const double *displacement[2];
  /** wire_place[w * 4]: x and y of the first end, x and y of the last end of wire w, seen from
   * above, +x at 0 degrees [m]. */
  const double *wire_place;
  /** wires[w * wire_points + p]: height of wire w above the undeflected plane of the head that
   * carries it [m]. */
  const double *wires;
  /** wire_force[w * wire_points + p]: between wire and head, 0 or more [N]; each contact counts at
   * the point that is nearest to it, so that the sum is the whole force. */
  const double *wire_force;
  uint32_t stick_count;                     /**< strikers' contacts in play */
  TaborViewStick sticks[TABOR_VIEW_STICKS]; /**< the first stick_count of them */
  TaborLedger ledger;                       /**< as tabor_drum_ledger() gives it */
} TaborView;

/** @name Set-up: drums and swaps
 * SET-UP: any thread but the audio thread. */
/** @{ */

/**
 * Creates a drum at rest, which keeps a reference to @p model. On an error *drum is NULL:
 * TABOR_ERROR_ARGUMENT, TABOR_ERROR_MEMORY.
 */
TABOR_API TaborStatus tabor_drum_create(TaborModel *model, TaborDrum **drum, TaborError *error);
/**
 * Frees a drum. Ignores NULL. A swap that is not done must be destroyed after the drum.
 */
TABOR_API void tabor_drum_destroy(TaborDrum *drum);
/**
 * Prepares the change of a drum from @p old_model to @p new_model, and allocates all memory for
 * it. The sample rates and allocators of the models must be the same. On an error *swap is NULL:
 * TABOR_ERROR_ARGUMENT, TABOR_ERROR_RANGE, TABOR_ERROR_MEMORY.
 *
 * @p old_model must be the drum's model when the swap event acts. Otherwise the event is dropped,
 * and the swap is done.
 *
 * The event decides what becomes of a drum that rings:
 *
 * - After TABOR_EVENT_SWAP it continues on the new model if body, size, boundary and wires stay
 *   the same. For 16 ms the old model plays, too: events act on both, and the outputs change over
 *   from the old one to the new one in the second half of this time. Live values go on if they were
 *   moved. A drum of another body, size, boundary or set of wires is replaced.
 * - After TABOR_EVENT_REPLACE a drum at rest takes its place. The old drum rings out beside it
 *   under a fade of 30 ms. Live values begin anew.
 *
 * Ledger and counters go on. Outputs then stand for the microphones of the new model, and former
 * sounds go to those of the same names; two without a namesake in the other drum, in the same
 * place, are taken for the same. tabor_swap_route() chooses outputs instead. At most four former
 * sounds are heard at once, those of silences included; a further one cuts the oldest short.
 */
TABOR_API TaborStatus tabor_swap_create(TaborModel *old_model, TaborModel *new_model,
                                        TaborSwap **swap, TaborError *error);
/**
 * Chooses the microphone of each output, @p count of them, at most TABOR_MAX_MICS: mics[output] is
 * an index into the definition's microphones, or larger for an output that is silent. At first
 * output i has microphone i. Call before the drum is played; tabor_drum_process() then takes @p
 * count outputs.
 */
TABOR_API void tabor_drum_route(TaborDrum *drum, const uint8_t *mics, uint32_t count);
/**
 * The same for the drum after the swap; former sounds stay at the outputs that they had. Without it
 * the drum has an output for each of the new model's microphones. Call before the event is sent.
 */
TABOR_API void tabor_swap_route(TaborSwap *swap, const uint8_t *mics, uint32_t count);
/**
 * Frees a swap that was never sent or is done, or whose drum was destroyed, with the old state and
 * model that it then holds. Ignores NULL.
 */
TABOR_API void tabor_swap_destroy(TaborSwap *swap);
/** @} */

/** @name Set-up: views
 * SET-UP: any thread but the audio thread. */
/** @{ */

/**
 * Creates a view of drums on @p model, to which it keeps a reference, and the tables for
 * tabor_drum_view(). It shows nothing yet: all its values are 0. One view may look at several drums
 * of this model. @p grid may be NULL for the defaults. On an error *view is NULL:
 * TABOR_ERROR_ARGUMENT, TABOR_ERROR_RANGE for @p grid, TABOR_ERROR_MEMORY.
 */
TABOR_API TaborStatus tabor_view_create(TaborModel *model, const TaborViewGrid *grid,
                                        TaborView **view, TaborError *error);
/** Frees a view. Ignores NULL. */
TABOR_API void tabor_view_destroy(TaborView *view);
/** @} */

/** @name Swaps, from any thread
 * ANY: real-time safe, also beside the audio thread. */
/** @{ */

/** True once the audio thread no longer needs @p swap (atomic). */
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
 * @param count   number of events.
 * @param outputs outputs[mic][frame]: one pointer per microphone of the definition, in its order,
 *                unless tabor_drum_route() or tabor_swap_route() has chosen others. Samples
 *                overwrite the array; 1.0 stands for full_scale. A NULL channel is not computed;
 *                when it is connected again it starts silent, and sound still on its way to the
 *                microphone is lost. @p outputs itself may be NULL. After a swap to a model with
 *                fewer microphones, the caller fills the channels that it lacks.
 * @param frames  samples of each channel; may be 0: all events then act at once.
 *
 * The work is bounded. TABOR_BURST strokes, presses and damping hands act at once, and one more
 * each TABOR_BURST_FRAMES frames; further ones are dropped and counted in dropped_events. Silences,
 * resets, swaps and replacements always act, and count among these: a silence, a reset or a swap
 * like seven strokes, a replacement like one. A swap beyond this number acts like
 * TABOR_EVENT_REPLACE. Live changes, gains and moves count a little; of some two thousand at once,
 * further ones are dropped and counted. Releases always act. If several resets come at one frame,
 * the last alone is carried out, and what precedes it at this frame, except swaps, is skipped
 * without being counted.
 *
 * The output does not depend on the division into blocks. The latency is 0; sound reaches a
 * microphone after its travel time. The caller's floating-point mode is saved and restored.
 */
TABOR_API void tabor_drum_process(TaborDrum *drum, const TaborEvent *events, uint32_t count,
                                  float *const *outputs, uint32_t frames);
/**
 * tabor_drum_process() while sound from outside drives the heads, and through them the wires: a
 * loudspeaker in front of a snare drum, or another drum. @p sound may be NULL. Its source stands at
 * the place of a microphone, which is used backwards: the heads are pushed as that microphone would
 * hear them move (engine/src/air/incident_sound.h has the equation). It acts on the modes up to the
 * two-way bandwidth. Sound below 2e-5 Pa counts as silence, and so does what is no number; any
 * other wakes a drum that sleeps. Sound beyond 1e5 Pa, the air's own pressure, is limited to it.
 * The ledger counts its work as injected.
 */
TABOR_API void tabor_drum_process_sound(TaborDrum *drum, const TaborEvent *events, uint32_t count,
                                        const TaborSound *sound, float *const *outputs,
                                        uint32_t frames);
/** True if everything has died away: the output is then exactly 0 until the next event. */
TABOR_API bool tabor_drum_is_silent(const TaborDrum *drum);
/** Makes the drum as a new one of its model: brings it to rest, like TABOR_EVENT_RESET, and forgets
 * what events have cost. */
TABOR_API void tabor_drum_reset(TaborDrum *drum);
/** Copies the counters to @p statistics. */
TABOR_API void tabor_drum_statistics(const TaborDrum *drum, TaborStatistics *statistics);
/** Copies the energy account to @p ledger. */
TABOR_API void tabor_drum_ledger(const TaborDrum *drum, TaborLedger *ledger);
/** Copies positions and forces of the newest state to @p probe. */
TABOR_API void tabor_drum_probe(const TaborDrum *drum, TaborProbe *probe);
/**
 * Copies what the newest state looks like to @p view, at whatever rate the caller wants to see.
 * False if the drum is on another model than the view, as after a swap; the view then keeps what it
 * had. Sound that is left from before a silence, a swap or a replacement is not seen. On the
 * default grid it takes 15 to 40 microseconds on a processor of today, those of a drum with many
 * low modes the most.
 */
TABOR_API bool tabor_drum_view(const TaborDrum *drum, TaborView *view);
/** The model of the drum at this moment. */
TABOR_API const TaborModel *tabor_drum_model(const TaborDrum *drum);

/** Number of bytes that tabor_drum_state_save() writes. */
TABOR_API size_t tabor_drum_state_size(const TaborDrum *drum);
/**
 * Writes the whole state to @p bytes, tabor_drum_state_size() of them. A drum on the same model
 * continues from it with the same bits. Sounds that fade out after a silence, a swap or a
 * replacement are not part of it.
 */
TABOR_API void tabor_drum_state_save(const TaborDrum *drum, void *bytes);
/**
 * Restores a saved state. If the bytes are damaged, forged or belong to another model, it returns
 * TABOR_ERROR_STATE and changes nothing. Every index and count and the size of every number is
 * checked, so bytes from a stranger cannot break the program; what they sound like is up to them.
 */
TABOR_API TaborStatus tabor_drum_state_load(TaborDrum *drum, const void *bytes, size_t size);
/** @} */

/* ------------------------------------------------------------------------------------------------
 * Room
 * --------------------------------------------------------------------------------------------- */

/**
 * The sound that the walls of a shoebox room send back to a drum's microphones: the six first
 * reflections of each microphone, and the late sound, as loud as in a diffuse field
 * (engine/src/room/room.h has the equations). It hears the drum by two of its microphones, the
 * *feeds*: those called `left` and `right`, or else the one that is farthest away, for both. It
 * undoes their frequency responses, and what it sends to a microphone passes that microphone's. The
 * drum does not hear the room.
 */
typedef struct TaborRoom TaborRoom;

/** Facts of a room. */
typedef struct TaborRoomInfo {
  uint32_t kind;    /**< a TaborRoomKind */
  double length;    /**< [m]; 0 for none, as are all below */
  double width;     /**< [m] */
  double height;    /**< [m] */
  double decay;     /**< 60 dB decay time of low notes [s] */
  double decay_8k;  /**< the same at 8 kHz [s] */
  double loudness;  /**< energy of the late sound over that of the direct sound 1 m from the drum */
  uint32_t feed[2]; /**< indices of the microphones that it hears the drum by */
  uint32_t tail; /**< frames after which it is silent, at most, if the feeds stop at full scale */
  size_t bytes;  /**< memory */
} TaborRoomInfo;

/** @name Set-up: rooms
 * SET-UP: any thread but the audio thread. */
/** @{ */

/**
 * Creates the room of @p def, at rest, for all its microphones. A room of the kind none adds
 * nothing. It reads room, air, shell and microphones of @p def, as they are now: gains that change
 * while the drum plays are not heard in the room, but through the feeds. @p allocator may be NULL
 * for the C library's. On an error *room is NULL: those of tabor_drum_def_validate(),
 * TABOR_ERROR_ARGUMENT, TABOR_ERROR_RANGE for @p sample_rate, or TABOR_ERROR_MEMORY.
 */
TABOR_API TaborStatus tabor_room_create(const TaborDrumDef *def, double sample_rate,
                                        const TaborAllocator *allocator, TaborRoom **room,
                                        TaborError *error);
/** Frees a room. Ignores NULL. */
TABOR_API void tabor_room_destroy(TaborRoom *room);
/** Fills in the facts of @p room. */
TABOR_API void tabor_room_info(const TaborRoom *room, TaborRoomInfo *info);
/** @} */

/** @name Rooms on the audio thread
 * AUDIO: real-time safe; one thread at a time for one room. */
/** @{ */

/**
 * Adds what the room sends back to @p outputs.
 *
 * @param room    the room.
 * @param dry     dry[mic][frame]: what tabor_drum_process() gave. Only the feeds are read. A NULL
 *                channel is silence, and so is @p dry if it is NULL.
 * @param outputs outputs[mic][frame]: the room adds to each channel that is not NULL; @p outputs
 *                may be @p dry.
 * @param frames  samples of each channel.
 *
 * The output does not depend on the division into blocks, nor on the instruction set.
 */
TABOR_API void tabor_room_process(TaborRoom *room, const float *const *dry, float *const *outputs,
                                  uint32_t frames);
/** True if everything has died away: the room adds exactly 0 until a feed sounds again. */
TABOR_API bool tabor_room_is_silent(const TaborRoom *room);
/** Energy of what the room holds: mean square of its late sound at a microphone of gain 1, in units
 * of full scale. 0 if it is silent. */
TABOR_API double tabor_room_energy(const TaborRoom *room);
/** Brings the room to rest. */
TABOR_API void tabor_room_reset(TaborRoom *room);
/** Number of bytes that tabor_room_state_save() writes. */
TABOR_API size_t tabor_room_state_size(const TaborRoom *room);
/** Writes the whole state to @p bytes. The same room, and one like it, continues from it with the
 * same bits. */
TABOR_API void tabor_room_state_save(const TaborRoom *room, void *bytes);
/**
 * Restores a saved state. If the bytes are damaged or belong to another room, it returns
 * TABOR_ERROR_STATE and changes nothing.
 */
TABOR_API TaborStatus tabor_room_state_load(TaborRoom *room, const void *bytes, size_t size);
/** @} */

#ifdef __cplusplus
}
#endif

#endif /* TABOR_TABOR_H */
