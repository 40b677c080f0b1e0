/* SPDX-License-Identifier: MIT */
/**
 * @file params.h
 * The one parameter table: every key of a definition with its place in TaborDrumDef.
 *
 * The table drives defaults, setting from text, printing, enumeration, validation, live changes and
 * documentation. A later key is one more row and one more field.
 */
#ifndef TABOR_SRC_PARAMS_H
#define TABOR_SRC_PARAMS_H

#include "math/arithmetic.h"
#include "tabor/tabor.h"

/** Numbers of a head's parameters, from that of the head on. */
typedef enum TbHeadParamId {
  TB_HEAD_TENSION,
  TB_HEAD_SURFACE_DENSITY,
  TB_HEAD_BENDING_STIFFNESS,
  TB_HEAD_DAMPING_0,
  TB_HEAD_DAMPING_1,
  TB_HEAD_STRETCH_STIFFNESS,
  TB_HEAD_MUFFLE_RADIUS,
  TB_HEAD_MUFFLE_ANGLE,
  TB_HEAD_MUFFLE_STRENGTH, /**< live */
  TB_HEAD_LUG_COUNT,
  TB_HEAD_LUG_SPREAD,
  TB_HEAD_LUG_SEED,
  TB_HEAD_PITCH,
  TB_HEAD_DAMPING_K,
  TB_HEAD_RING_RADIUS,
  TB_HEAD_RING_WIDTH,
  TB_HEAD_RING_STRENGTH,
  TB_HEAD_UNEVENNESS,
  TB_HEAD_LUG = 20 /**< of the first lug; the other lugs follow, to 35 */
} TbHeadParamId;

/** Numbers of a plate's parameters, from that of the plate on. */
typedef enum TbPlateParamId {
  TB_PLATE_THICKNESS = 1,
  TB_PLATE_YOUNGS_MODULUS = 2,
  TB_PLATE_POISSON_RATIO = 3,
  TB_PLATE_DENSITY = 4,
  TB_PLATE_DAMPING_0 = 5,
  TB_PLATE_LOSS = 6,
  TB_PLATE_HEAVE_FREQUENCY = 7,
  TB_PLATE_TILT_FREQUENCY = 8,
  TB_PLATE_MOUNT_DAMPING = 9,
  TB_PLATE_TAPER = 10,
  TB_PLATE_BOW = 11,
  TB_PLATE_BELL_RADIUS = 12,
  TB_PLATE_BELL_HEIGHT = 13,
  TB_PLATE_FLANGE_WIDTH = 14,
  TB_PLATE_FLANGE_SLOPE = 15,
  TB_PLATE_SPLITTING = 16,
  TB_PLATE_CASCADE = 17,
  TB_PLATE_LARGE_DEFLECTIONS = 18
} TbPlateParamId;

/**
 * Stable ids: hosts and saved automation refer to them, so a number is never changed or used again.
 * A section owns a hundred numbers; keys reserved for later fit into the gaps.
 */
typedef enum TbParamId {
  TB_PARAM_NONE = 0,

  TB_PARAM_DRUM_NAME = 100,
  TB_PARAM_DRUM_COMMENT = 101,
  TB_PARAM_DRUM_LICENSE = 102,
  TB_PARAM_DRUM_CATEGORY = 103,

  TB_PARAM_BODY_KIND = 150,
  TB_PARAM_PLATE = 150, /**< from 151, by TbPlateParamId */

  TB_PARAM_SHELL_RADIUS = 200,
  TB_PARAM_SHELL_DEPTH = 201,
  TB_PARAM_SHELL_BOUNDARY = 202,
  TB_PARAM_SHELL_SURFACE_DENSITY = 203,
  TB_PARAM_SHELL_MASS = 204,
  TB_PARAM_SHELL_BENDING_STIFFNESS = 205,
  TB_PARAM_SHELL_LOSS = 206,
  TB_PARAM_SHELL_STAND_FREQUENCY = 207,
  TB_PARAM_SHELL_STAND_DAMPING = 208,
  TB_PARAM_SHELL_ABSORPTION = 220,

  TB_PARAM_BATTER = 300,   /**< to 399, by TbHeadParamId */
  TB_PARAM_RESONANT = 400, /**< to 499, likewise */

  TB_PARAM_WIRES_HEAD = 500,
  TB_PARAM_WIRES_COUNT = 501,
  TB_PARAM_WIRES_SIDE = 502,
  TB_PARAM_WIRES_LENGTH = 503,
  TB_PARAM_WIRES_SPACING = 504,
  TB_PARAM_WIRES_ANGLE = 505,
  TB_PARAM_WIRES_OFFSET = 506,
  TB_PARAM_WIRES_MASS_PER_LENGTH = 507,
  TB_PARAM_WIRES_TENSION = 508, /**< live */
  TB_PARAM_WIRES_TENSION_SPREAD = 509,
  TB_PARAM_WIRES_SEED = 510,
  TB_PARAM_WIRES_BENDING_STIFFNESS = 511,
  TB_PARAM_WIRES_DAMPING_0 = 512, /**< live */
  TB_PARAM_WIRES_DAMPING_1 = 513, /**< live */
  TB_PARAM_WIRES_STRAINER = 514,  /**< live */
  TB_PARAM_WIRES_STRAINER_TRAVEL = 515,
  TB_PARAM_WIRES_REST_OFFSET = 516,
  TB_PARAM_WIRES_CONTACT_STIFFNESS = 517,
  TB_PARAM_WIRES_CONTACT_EXPONENT = 518,
  TB_PARAM_WIRES_CONTACT_LOSS = 519,
  TB_PARAM_WIRES_REST_SPREAD = 520,
  TB_PARAM_WIRES_BEND_HEIGHT = 521,
  TB_PARAM_WIRES_BEND_LENGTH = 522,
  TB_PARAM_WIRES_UNEVENNESS = 523,
  TB_PARAM_WIRES_HEAD_TENSION = 524,

  TB_PARAM_WIRE_LENGTH = 603,
  TB_PARAM_WIRE_ANGLE = 605,
  TB_PARAM_WIRE_OFFSET = 606,
  TB_PARAM_WIRE_MASS_PER_LENGTH = 607,
  TB_PARAM_WIRE_TENSION = 608,
  TB_PARAM_WIRE_BENDING_STIFFNESS = 611,
  TB_PARAM_WIRE_DAMPING_0 = 612,
  TB_PARAM_WIRE_DAMPING_1 = 613,
  TB_PARAM_WIRE_REST_OFFSET = 616,
  TB_PARAM_WIRE_CONTACT_STIFFNESS = 617,
  TB_PARAM_WIRE_CONTACT_EXPONENT = 618,
  TB_PARAM_WIRE_CONTACT_LOSS = 619,

  TB_PARAM_STRIKER_KIND = 700,
  TB_PARAM_STRIKER_MASS = 701,
  TB_PARAM_STRIKER_CONTACT_STIFFNESS = 702,
  TB_PARAM_STRIKER_CONTACT_EXPONENT = 703,
  TB_PARAM_STRIKER_CONTACT_LOSS = 704,
  TB_PARAM_STRIKER_CONTACT_RADIUS = 705,
  TB_PARAM_STRIKER_BRISTLES = 706,
  TB_PARAM_STRIKER_SPREAD = 707,
  TB_PARAM_STRIKER_SWEEP_SPEED = 708,
  TB_PARAM_STRIKER_BENDING_FREQUENCY = 709,

  TB_PARAM_HAND_STIFFNESS = 800,
  TB_PARAM_HAND_DAMPING = 801,
  TB_PARAM_HAND_PIVOT = 802,
  TB_PARAM_HAND_GRIP = 803, /**< live */

  TB_PARAM_HOOP_HEIGHT = 900,
  TB_PARAM_HOOP_MASS = 901,
  TB_PARAM_HOOP_CONTACT_STIFFNESS = 902,
  TB_PARAM_HOOP_CONTACT_LOSS = 903,
  TB_PARAM_HOOP_BENDING_STIFFNESS = 904,
  TB_PARAM_HOOP_LOSS = 905,
  TB_PARAM_HOOP_TIE_FREQUENCY = 906,
  TB_PARAM_HOOP_TIE_LOSS = 907,
  TB_PARAM_HOOP_WIDTH = 908,
  TB_PARAM_HOOP_WALL = 909,
  TB_PARAM_HOOP_TORSION = 910,
  /* 910 to 917 and 920 to 927 were frequencies and decays of the hoop in 0.1. */

  TB_PARAM_STRIKE_VELOCITY = 1000,
  TB_PARAM_STRIKE_RADIUS = 1001,
  TB_PARAM_STRIKE_ANGLE = 1002,
  TB_PARAM_STRIKE_STRIKER = 1003,
  TB_PARAM_STRIKE_TECHNIQUE = 1004,

  TB_PARAM_MIC_RADIUS = 1100,
  TB_PARAM_MIC_ANGLE = 1101,
  TB_PARAM_MIC_HEIGHT = 1102,
  TB_PARAM_MIC_GAIN = 1103, /**< live */
  TB_PARAM_MIC_RESPONSE = 1104,

  TB_PARAM_AIR_DENSITY = 1200,
  TB_PARAM_AIR_SOUND_SPEED = 1201,
  TB_PARAM_AIR_GRAVITY = 1202,

  TB_PARAM_QUALITY_LEVEL = 1300,
  TB_PARAM_QUALITY_TWO_WAY_BANDWIDTH = 1301,
  TB_PARAM_QUALITY_BANDWIDTH = 1302,
  TB_PARAM_QUALITY_NEWTON_CAP = 1303,
  TB_PARAM_QUALITY_WIRE_POINTS = 1304,
  TB_PARAM_QUALITY_LOSSES = 1305,

  TB_PARAM_OUTPUT_FULL_SCALE = 1400, /**< live */

  TB_PARAM_ROOM_KIND = 1500,
  TB_PARAM_ROOM_SIZE = 1501,
  TB_PARAM_ROOM_DECAY = 1502,
  TB_PARAM_ROOM_TILT = 1503,
  TB_PARAM_ROOM_LEVEL = 1504,

  TB_PARAM_BOTTOM = 1600, /**< from 1601, by TbPlateParamId */

  TB_PARAM_HIHAT_OPENING = 1700, /**< live */
  TB_PARAM_HIHAT_SPEED = 1701,
  TB_PARAM_HIHAT_TILT = 1702,
  TB_PARAM_HIHAT_UNEVENNESS = 1703,
  TB_PARAM_HIHAT_SEED = 1704,
  TB_PARAM_HIHAT_POINTS = 1705,
  TB_PARAM_HIHAT_CONTACT_STIFFNESS = 1706,
  TB_PARAM_HIHAT_CONTACT_EXPONENT = 1707,
  TB_PARAM_HIHAT_CONTACT_LOSS = 1708,
  TB_PARAM_HIHAT_CLOSED = 1709,
  TB_PARAM_HIHAT_OPEN = 1710,
  TB_PARAM_HIHAT_LIFT = 1711,
  TB_PARAM_HIHAT_FRICTION = 1712
} TbParamId;

/** Structure of a row's section: one struct; structs that may be absent (resonant, plate, hihat);
 * or an array of elements with a number or a name. */
typedef enum TbGroup {
  TB_GROUP_SINGLE,
  TB_GROUP_RESONANT,
  TB_GROUP_PLATE,
  TB_GROUP_HIHAT, /**< with the lower cymbal, [bottom] */
  TB_GROUP_WIRE,
  TB_GROUP_STRIKER,
  TB_GROUP_MIC
} TbGroup;

typedef struct TbParam {
  TaborParameter info; /**< public part; first, so that its address is also the row's */
  TbGroup group;
  size_t offset;   /**< of the field in TaborDrumDef, of element 0 in an array */
  size_t stride;   /**< to the next element's field, 0 in single sections */
  size_t size;     /**< bytes of a text field with its terminator, 0 otherwise */
  uint32_t base;   /**< of a choice: the stored value of its first word */
  double least;    /**< a value closer to zero than this is refused */
  bool zero;       /**< zero itself is allowed in spite of `least` */
  bool identifier; /**< a text that must be a name or empty */
  bool note;       /**< a number that may be written as a note */
} TbParam;

/** The table in preset order; rows of one section are neighbours. */
extern const TbParam tb_params[];
extern const uint32_t tb_param_count;

/* The functions below are all audio-safe: nothing in params.c calls another function. */

/** The row with this id, or NULL. */
const TbParam *tb_param_by_id(uint32_t id);

/** Elements that the group's array can hold; 1 for a single section and for the resonant head. */
uint32_t tb_group_capacity(TbGroup group);

/** True if keys of the group name their element: "wire.3.length", "mic.top.gain". */
bool tb_group_is_array(TbGroup group);

/** The row's field in element @p element, which must be below the group's capacity. */
void *tb_param_field(const TbParam *param, TaborDrumDef *def, uint32_t element);
const void *tb_param_field_const(const TbParam *param, const TaborDrumDef *def, uint32_t element);

#endif /* TABOR_SRC_PARAMS_H */
