/* SPDX-License-Identifier: MIT */
#include "definition/params.h"

#include <math.h>

/* Type, range and default of a row's value. */
#define NUMBER(low, high, value)                                                                   \
  .type = TABOR_TYPE_NUMBER, .minimum = (low), .maximum = (high), .fallback = (value)
#define WHOLE(low, high, value)                                                                    \
  .type = TABOR_TYPE_WHOLE, .minimum = (low), .maximum = (high), .fallback = (value)
#define CHOICE(words, value)                                                                       \
  .type = TABOR_TYPE_CHOICE, .minimum = NAN, .maximum = NAN, .fallback = (value), .choices = (words)
#define TEXT .type = TABOR_TYPE_TEXT, .minimum = NAN, .maximum = NAN, .fallback = NAN
#define LOGARITHMIC .logarithmic = true
#define LIVE .live = true
#define FOLLOWS                                                                                    \
  NAN /* the fallback of a wire's value, what [wires] says, and of a lug's, as drawn */

/* Place of a row's field. */
#define AT(member) .group = TB_GROUP_SINGLE, .offset = offsetof(TaborDrumDef, member)
#define SIZED(member) AT(member), .size = sizeof(((TaborDrumDef *)0)->member)
#define IN_ARRAY(array, type, member)                                                              \
  .offset = offsetof(TaborDrumDef, array) + offsetof(type, member), .stride = sizeof(type)
#define IN_RESONANT(member)                                                                        \
  .group = TB_GROUP_RESONANT,                                                                      \
  .offset = offsetof(TaborDrumDef, resonant) + offsetof(TaborHeadDef, member)
#define IN_PLATE(member) .group = TB_GROUP_PLATE, .offset = offsetof(TaborDrumDef, plate.member)
#define IN_BOTTOM(member) .group = TB_GROUP_HIHAT, .offset = offsetof(TaborDrumDef, bottom.member)
#define IN_HIHAT(member) .group = TB_GROUP_HIHAT, .offset = offsetof(TaborDrumDef, hihat.member)
#define IN_BATTER(member) AT(batter.member)
#define IN_WIRE(member) .group = TB_GROUP_WIRE, IN_ARRAY(wire, TaborWireDef, member)
#define IN_STRIKER(member) .group = TB_GROUP_STRIKER, IN_ARRAY(striker, TaborStrikerDef, member)
#define IN_MIC(member) .group = TB_GROUP_MIC, IN_ARRAY(mic, TaborMicDef, member)

#define ROW(id_, section_, key_, unit_, text_, ...)                                                \
  .info = {.id = (id_),                                                                            \
           .section = (section_),                                                                  \
           .key = (key_),                                                                          \
           .unit = (unit_),                                                                        \
           .text = (text_),                                                                        \
           __VA_ARGS__}

/* All lugs of one head; `place` says where its fields are. */
#define LUG(number, id_, section_, place)                                                          \
  {                                                                                                \
    ROW((id_) + (number)-1, section_, "lug_" #number, "",                                          \
        "own relative deviation of the tension at lug " #number, NUMBER(-0.5, 0.5, FOLLOWS)),      \
      place(lug[(number)-1])                                                                       \
  }
#define LUGS(id, section, place)                                                                   \
  LUG(1, id, section, place), LUG(2, id, section, place), LUG(3, id, section, place),              \
    LUG(4, id, section, place), LUG(5, id, section, place), LUG(6, id, section, place),            \
    LUG(7, id, section, place), LUG(8, id, section, place), LUG(9, id, section, place),            \
    LUG(10, id, section, place), LUG(11, id, section, place), LUG(12, id, section, place),         \
    LUG(13, id, section, place), LUG(14, id, section, place), LUG(15, id, section, place),         \
    LUG(16, id, section, place)

/* A head, whose parameters are numbered from `first` on. The heads differ in their usual sheets
 * [N/m, kg/m2, N m]. */
#define HEAD(first, section, place, tension_text, usual_tension, usual_density, usual_stiffness)   \
  {ROW((first) + TB_HEAD_TENSION, section, "tension", "N/m", tension_text,                         \
       NUMBER(100, 20000, usual_tension), LOGARITHMIC),                                            \
   place(tension)},                                                                                \
    {ROW((first) + TB_HEAD_PITCH, section, "pitch", "Hz",                                          \
         "what a tuner reads at a lug, or a note such as Eb2+30; 0: as tension says",              \
         NUMBER(0, 20000, 0)),                                                                     \
     place(pitch), .least = 1, .zero = true, .note = true},                                        \
    {ROW((first) + TB_HEAD_SURFACE_DENSITY, section, "surface_density", "kg/m2",                   \
         "mass of the head per area", NUMBER(0.02, 5, usual_density), LOGARITHMIC),                \
     place(surface_density)},                                                                      \
    {ROW((first) + TB_HEAD_BENDING_STIFFNESS, section, "bending_stiffness", "N m",                 \
         "bending stiffness of the head's sheet", NUMBER(0, 1, usual_stiffness)),                  \
     place(bending_stiffness)},                                                                    \
    {ROW((first) + TB_HEAD_DAMPING_0, section, "damping_0", "1/s",                                 \
         "loss of the head, the same at all frequencies", NUMBER(0, 1000, 12)),                    \
     place(damping_0)},                                                                            \
    {ROW((first) + TB_HEAD_DAMPING_K, section, "damping_k", "m/s",                                 \
         "loss of the head that grows with the wave number, and so with frequency",                \
         NUMBER(0, 5, 0)),                                                                         \
     place(damping_k)},                                                                            \
    {ROW((first) + TB_HEAD_DAMPING_1, section, "damping_1", "m2/s",                                \
         "loss of the head that grows with the square of the wave number",                         \
         NUMBER(0, 0.1, 0.0016)),                                                                  \
     place(damping_1)},                                                                            \
    {ROW((first) + TB_HEAD_STRETCH_STIFFNESS, section, "stretch_stiffness", "N/m",                 \
         "how the head tightens as it stretches, E h/(1 - nu^2) of its sheet", NUMBER(0, 1e7, 0)), \
     place(stretch_stiffness)},                                                                    \
    {ROW((first) + TB_HEAD_MUFFLE_RADIUS, section, "muffle_radius", "m",                           \
         "distance of the damper on the head from its centre", NUMBER(0, 0.6, 0)),                 \
     place(muffle_radius)},                                                                        \
    {ROW((first) + TB_HEAD_MUFFLE_ANGLE, section, "muffle_angle", "deg",                           \
         "direction of the damper from the head's centre", NUMBER(-360, 360, 0)),                  \
     place(muffle_angle)},                                                                         \
    {ROW((first) + TB_HEAD_MUFFLE_STRENGTH, section, "muffle_strength", "N s/m",                   \
         "how hard the damper brakes the head, 0: none", NUMBER(0, 30, 0), LIVE),                  \
     place(muffle_strength)},                                                                      \
    {ROW((first) + TB_HEAD_RING_RADIUS, section, "ring_radius", "m",                               \
         "distance of the middle of the felt ring from the centre of the head",                    \
         NUMBER(0, 0.6, 0.1)),                                                                     \
     place(ring_radius)},                                                                          \
    {ROW((first) + TB_HEAD_RING_WIDTH, section, "ring_width", "m", "width of the felt ring",       \
         NUMBER(0.001, 1.2, 0.03)),                                                                \
     place(ring_width)},                                                                           \
    {ROW((first) + TB_HEAD_RING_STRENGTH, section, "ring_strength", "N s/m",                       \
         "how hard the felt ring brakes the head, 0: none", NUMBER(0, 30, 0)),                     \
     place(ring_strength)},                                                                        \
    {ROW((first) + TB_HEAD_UNEVENNESS, section, "unevenness", "",                                  \
         "relative deviation of the head's mass from place to place, which scatters the treble",   \
         NUMBER(0, 0.3, 0.12)),                                                                    \
     place(unevenness)},                                                                           \
    {ROW((first) + TB_HEAD_LUG_COUNT, section, "lug_count", "", "number of lugs around the head",  \
         WHOLE(3, TABOR_MAX_LUGS, 10)),                                                            \
     place(lug_count)},                                                                            \
    {ROW((first) + TB_HEAD_LUG_SPREAD, section, "lug_spread", "",                                  \
         "largest relative deviation of the tension at a lug", NUMBER(0, 0.5, 0)),                 \
     place(lug_spread)},                                                                           \
    {ROW((first) + TB_HEAD_LUG_SEED, section, "lug_seed", "", "number that draws the deviations",  \
         WHOLE(0, 4294967295.0, 1)),                                                               \
     place(lug_seed)},                                                                             \
    LUGS((first) + TB_HEAD_LUG, section, place)

/* A plate, whose parameters are numbered from `first` on. */
#define PLATE(first, section, place)                                                               \
  {ROW((first) + TB_PLATE_THICKNESS, section, "thickness", "m",                                    \
       "thickness of a plate in its middle", NUMBER(1e-4, 0.02, 1e-3), LOGARITHMIC),               \
   place(thickness)},                                                                              \
    {ROW((first) + TB_PLATE_YOUNGS_MODULUS, section, "youngs_modulus", "Pa",                       \
         "Young's modulus of a plate: bronze 1.05e11, steel 2e11", NUMBER(1e8, 1e12, 1.05e11),     \
         LOGARITHMIC),                                                                             \
     place(youngs_modulus)},                                                                       \
    {ROW((first) + TB_PLATE_POISSON_RATIO, section, "poisson_ratio", "",                           \
         "Poisson's ratio of a plate", NUMBER(0, 0.49, 0.34)),                                     \
     place(poisson_ratio)},                                                                        \
    {ROW((first) + TB_PLATE_DENSITY, section, "density", "kg/m3", "density of a plate",            \
         NUMBER(100, 30000, 8650), LOGARITHMIC),                                                   \
     place(density)},                                                                              \
    {ROW((first) + TB_PLATE_DAMPING_0, section, "damping_0", "1/s",                                \
         "loss of a plate, the same at all frequencies", NUMBER(0, 1000, 0.5)),                    \
     place(damping_0)},                                                                            \
    {ROW((first) + TB_PLATE_LOSS, section, "loss", "", "loss factor of a plate's bending",         \
         NUMBER(0, 1, 1e-4)),                                                                      \
     place(loss)},                                                                                 \
    {ROW((first) + TB_PLATE_HEAVE_FREQUENCY, section, "heave_frequency", "Hz",                     \
         "frequency at which a plate bounces on its mount", NUMBER(5, 200, 50), LOGARITHMIC),      \
     place(heave_frequency)},                                                                      \
    {ROW((first) + TB_PLATE_TILT_FREQUENCY, section, "tilt_frequency", "Hz",                       \
         "frequency at which a plate swings on its mount", NUMBER(0.5, 50, 1.6), LOGARITHMIC),     \
     place(tilt_frequency)},                                                                       \
    {ROW((first) + TB_PLATE_MOUNT_DAMPING, section, "mount_damping", "",                           \
         "of both motions, as a part of critical damping", NUMBER(0, 2, 0.15)),                    \
     place(mount_damping)},                                                                        \
    {ROW((first) + TB_PLATE_TAPER, section, "taper", "",                                           \
         "thickness of a plate at its edge, in units of its middle's", NUMBER(0.2, 2, 1)),         \
     place(taper)},                                                                                \
    {ROW((first) + TB_PLATE_BOW, section, "bow", "m",                                              \
         "how far a plate's middle rises over its edge, without the bell", NUMBER(0, 0.05, 0)),    \
     place(bow)},                                                                                  \
    {ROW((first) + TB_PLATE_BELL_RADIUS, section, "bell_radius", "m", "radius of a plate's bell",  \
         NUMBER(0.01, 0.6, 0.055), LOGARITHMIC),                                                   \
     place(bell_radius)},                                                                          \
    {ROW((first) + TB_PLATE_BELL_HEIGHT, section, "bell_height", "m",                              \
         "how far the bell rises over the bow; 0: there is none", NUMBER(0, 0.05, 0)),             \
     place(bell_height)},                                                                          \
    {ROW((first) + TB_PLATE_FLANGE_WIDTH, section, "flange_width", "m",                            \
         "width of the ring at the edge that is turned up, as of a china cymbal",                  \
         NUMBER(0.005, 0.6, 0.04), LOGARITHMIC),                                                   \
     place(flange_width)},                                                                         \
    {ROW((first) + TB_PLATE_FLANGE_SLOPE, section, "flange_slope", "",                             \
         "slope at the edge that the flange adds; 0: there is none", NUMBER(0, 1, 0)),             \
     place(flange_slope)},                                                                         \
  {                                                                                                \
    ROW((first) + TB_PLATE_SPLITTING, section, "splitting", "",                                    \
        "part by which the two modes of a pair differ in frequency, at most: an uneven plate",     \
        NUMBER(0, 0.05, 0)),                                                                       \
      place(splitting)                                                                             \
  }

const TbParam tb_params[] = {
  {ROW(TB_PARAM_DRUM_NAME, "drum", "name", "", "what the drum is called", TEXT), SIZED(name)},
  {ROW(TB_PARAM_DRUM_COMMENT, "drum", "comment", "", "what it is, one line", TEXT), SIZED(comment)},
  {ROW(TB_PARAM_DRUM_LICENSE, "drum", "license", "", "licence of the preset", TEXT),
   SIZED(license)},
  {ROW(TB_PARAM_DRUM_CATEGORY, "drum", "category", "", "kind of drum, for lists, such as snare",
       TEXT),
   SIZED(category), .identifier = true},

  {ROW(TB_PARAM_BODY_KIND, "body", "kind", "",
       "what sounds; plate: a disc with a free edge, flat or a cymbal; hihat: two of them",
       CHOICE("drum|plate|hihat", TABOR_BODY_DRUM)),
   AT(body.kind)},
  PLATE(TB_PARAM_PLATE, "plate", IN_PLATE),
  {ROW(TB_PARAM_PLATE + TB_PLATE_CASCADE, "plate", "cascade", "",
       "how fast energy goes up the spectrum beyond the modes that are coupled one by one",
       NUMBER(0, 20, 2)),
   IN_PLATE(cascade)},
  {ROW(TB_PARAM_PLATE + TB_PLATE_LARGE_DEFLECTIONS, "plate", "large_deflections", "",
       "how much large deflections couple modes; 1: as physics has it, 0: not at all",
       NUMBER(0, 1, 1)),
   IN_PLATE(large_deflections)},

  PLATE(TB_PARAM_BOTTOM, "bottom", IN_BOTTOM),

  {ROW(TB_PARAM_HIHAT_OPENING, "hihat", "opening", "m",
       "how far the pedal holds the edges apart; negative: it presses them together",
       NUMBER(-0.01, 0.03, -0.0015), LIVE),
   IN_HIHAT(opening)},
  {ROW(TB_PARAM_HIHAT_CLOSED, "hihat", "closed", "m",
       "opening to which the foot's stroke and notes for a closed hi-hat bring it",
       NUMBER(-0.01, 0.03, -0.0015)),
   IN_HIHAT(closed)},
  {ROW(TB_PARAM_HIHAT_OPEN, "hihat", "open", "m", "opening to which notes for an open one bring it",
       NUMBER(-0.01, 0.03, 0.008)),
   IN_HIHAT(open)},
  {ROW(TB_PARAM_HIHAT_LIFT, "hihat", "lift", "m", "opening from which the foot stamps",
       NUMBER(-0.01, 0.03, 0.005)),
   IN_HIHAT(lift)},
  {ROW(TB_PARAM_HIHAT_SPEED, "hihat", "speed", "m/s", "of the pedal's rod, at most",
       NUMBER(0.01, 10, 1.5), LOGARITHMIC),
   IN_HIHAT(speed)},
  {ROW(TB_PARAM_HIHAT_TILT, "hihat", "tilt", "m",
       "by how much the gap between the edges is wider on one side: the lower cymbal leans",
       NUMBER(0, 0.02, 0.0016)),
   IN_HIHAT(tilt)},
  {ROW(TB_PARAM_HIHAT_UNEVENNESS, "hihat", "unevenness", "m",
       "how far the edges deviate from a plane, at most", NUMBER(0, 0.005, 1e-4)),
   IN_HIHAT(unevenness)},
  {ROW(TB_PARAM_HIHAT_SEED, "hihat", "seed", "", "number that draws the deviations",
       WHOLE(0, 4294967295.0, 1)),
   IN_HIHAT(seed)},
  {ROW(TB_PARAM_HIHAT_POINTS, "hihat", "points", "", "places around the edges where they meet",
       WHOLE(4, 64, 16)),
   IN_HIHAT(points)},
  {ROW(TB_PARAM_HIHAT_CONTACT_STIFFNESS, "hihat", "contact_stiffness", "N/m^(1+exponent)",
       "stiffness of the edges' contact per length", NUMBER(1e4, 1e12, 4e8), LOGARITHMIC),
   IN_HIHAT(contact_stiffness)},
  {ROW(TB_PARAM_HIHAT_CONTACT_EXPONENT, "hihat", "contact_exponent", "",
       "exponent of the edges' contact law", NUMBER(1, 3, 1.5)),
   IN_HIHAT(contact_exponent)},
  {ROW(TB_PARAM_HIHAT_CONTACT_LOSS, "hihat", "contact_loss", "s/m", "loss in the edges' contact",
       NUMBER(0, 50, 5)),
   IN_HIHAT(contact_loss)},
  {ROW(TB_PARAM_HIHAT_FRICTION, "hihat", "friction", "1/(N s)",
       "how much faster all motion decays for each newton that presses the edges together",
       NUMBER(0, 10, 0.5)),
   IN_HIHAT(friction)},

  {ROW(TB_PARAM_SHELL_RADIUS, "shell", "radius", "m", "radius of the heads, or of a plate",
       NUMBER(0.05, 0.60, 0.1651), LOGARITHMIC),
   AT(shell.radius)},
  {ROW(TB_PARAM_SHELL_DEPTH, "shell", "depth", "m",
       "depth of the air below the batter head, with a resonant head or closed",
       NUMBER(0.01, 1.5, 0.14), LOGARITHMIC),
   AT(shell.depth)},
  {ROW(TB_PARAM_SHELL_BOUNDARY, "shell", "boundary", "",
       "of a single head; open: free air; baffled: each side in a baffle; closed: over a cavity",
       CHOICE("open|baffled|closed", TABOR_BOUNDARY_OPEN)),
   AT(shell.boundary)},
  {ROW(TB_PARAM_SHELL_ABSORPTION, "shell", "absorption", "",
       "part of the enclosed treble that the shell absorbs: bare wood 0.05, a pillow 0.25",
       NUMBER(0, 1, 0)),
   AT(shell.absorption)},
  {ROW(TB_PARAM_SHELL_SURFACE_DENSITY, "shell", "surface_density", "kg/m2",
       "mass of the wall between two heads per area; a light one lets more sound through",
       NUMBER(0.1, 1000, 4.2), LOGARITHMIC),
   AT(shell.surface_density)},
  {ROW(TB_PARAM_SHELL_MASS, "shell", "mass", "kg",
       "mass of the shell with lugs and the lower hoop, 0: it does not move", NUMBER(0, 100, 0)),
   AT(shell.mass), .least = 0.05, .zero = true},
  {ROW(TB_PARAM_SHELL_BENDING_STIFFNESS, "shell", "bending_stiffness", "N m",
       "bending stiffness of the wall, E h^3/(12 (1 - nu^2))", NUMBER(1e-3, 1e7, 270), LOGARITHMIC),
   AT(shell.bending_stiffness)},
  {ROW(TB_PARAM_SHELL_LOSS, "shell", "loss", "", "loss factor of the wall's bending",
       NUMBER(0, 1, 0.03)),
   AT(shell.loss)},
  {ROW(TB_PARAM_SHELL_STAND_FREQUENCY, "shell", "stand_frequency", "Hz",
       "frequency at which the drum bounces on its stand", NUMBER(5, 200, 20), LOGARITHMIC),
   AT(shell.stand_frequency)},
  {ROW(TB_PARAM_SHELL_STAND_DAMPING, "shell", "stand_damping", "",
       "damping of that motion as a part of critical damping", NUMBER(0, 2, 0.3)),
   AT(shell.stand_damping)},

  HEAD(TB_PARAM_BATTER, "batter", IN_BATTER, "tension of the head", 3000, 0.262, 0.0023),
  /* The usual snare-side head: 3 mil (76 um) of Mylar, 1390 kg/m3, E = 3.8 GPa, nu = 0.3, so that
   * E h^3/(12 (1 - nu^2)) = 1.5e-4 N m; about as tight as the batter, and of the same material,
   * hence its losses. */
  HEAD(TB_PARAM_RESONANT, "resonant", IN_RESONANT, "tension of the lower head", 2600, 0.105,
       1.5e-4),

  {ROW(TB_PARAM_WIRES_HEAD, "wires", "head", "", "head on which the wires lie",
       CHOICE("batter|resonant", TABOR_HEAD_BATTER)),
   AT(wires.head)},
  {ROW(TB_PARAM_WIRES_COUNT, "wires", "count", "", "number of wires", WHOLE(0, TABOR_MAX_WIRES, 0)),
   AT(wires.count)},
  {ROW(TB_PARAM_WIRES_SIDE, "wires", "side", "", "face of the head on which the wires lie",
       CHOICE("above|below", TABOR_SIDE_ABOVE)),
   AT(wires.side)},
  {ROW(TB_PARAM_WIRES_LENGTH, "wires", "length", "m", "length between the ends",
       NUMBER(0.02, 1.5, 0.30), LOGARITHMIC),
   AT(wires.length)},
  {ROW(TB_PARAM_WIRES_SPACING, "wires", "spacing", "m", "distance between neighbours",
       NUMBER(0, 0.1, 0.002)),
   AT(wires.spacing)},
  {ROW(TB_PARAM_WIRES_ANGLE, "wires", "angle", "deg", "direction in which the wires run",
       NUMBER(-360, 360, 0)),
   AT(wires.angle)},
  {ROW(TB_PARAM_WIRES_OFFSET, "wires", "offset", "m",
       "distance of the bed's middle from the head's centre, across the wires",
       NUMBER(-0.6, 0.6, 0)),
   AT(wires.offset)},
  {ROW(TB_PARAM_WIRES_MASS_PER_LENGTH, "wires", "mass_per_length", "kg/m", "mass of a wire",
       NUMBER(1e-4, 0.1, 1.6e-3), LOGARITHMIC),
   AT(wires.mass_per_length)},
  {ROW(TB_PARAM_WIRES_TENSION, "wires", "tension", "N", "tension of a wire", NUMBER(0.01, 200, 5),
       LOGARITHMIC, LIVE),
   AT(wires.tension)},
  {ROW(TB_PARAM_WIRES_HEAD_TENSION, "wires", "head_tension", "N/m",
       "tension of their head at which wires.tension holds; they follow it, unless this is 0",
       NUMBER(0, 20000, 0)),
   AT(wires.head_tension)},
  {ROW(TB_PARAM_WIRES_TENSION_SPREAD, "wires", "tension_spread", "",
       "largest relative deviation of a wire's tension", NUMBER(0, 0.9, 0)),
   AT(wires.tension_spread)},
  {ROW(TB_PARAM_WIRES_SEED, "wires", "seed", "", "number that draws the deviations",
       WHOLE(0, 4294967295.0, 1)),
   AT(wires.seed)},
  {ROW(TB_PARAM_WIRES_BENDING_STIFFNESS, "wires", "bending_stiffness", "N m2",
       "bending stiffness of a wire", NUMBER(0, 0.1, 1e-6)),
   AT(wires.bending_stiffness)},
  {ROW(TB_PARAM_WIRES_DAMPING_0, "wires", "damping_0", "1/s",
       "loss of a wire, the same at all frequencies", NUMBER(0, 1000, 2), LIVE),
   AT(wires.damping_0)},
  {ROW(TB_PARAM_WIRES_DAMPING_1, "wires", "damping_1", "m2/s",
       "loss of a wire that grows with the square of the wave number", NUMBER(0, 0.1, 0.001), LIVE),
   AT(wires.damping_1)},
  {ROW(TB_PARAM_WIRES_STRAINER, "wires", "strainer", "", "0: thrown off, 1: on", NUMBER(0, 1, 1),
       LIVE),
   AT(wires.strainer)},
  {ROW(TB_PARAM_WIRES_STRAINER_TRAVEL, "wires", "strainer_travel", "m",
       "how far the ends lift when the strainer is thrown off", NUMBER(0, 0.02, 0.004)),
   AT(wires.strainer_travel)},
  {ROW(TB_PARAM_WIRES_REST_OFFSET, "wires", "rest_offset", "m",
       "ends of the wires from the undeflected head, positive is away", NUMBER(-0.01, 0.02, 0)),
   AT(wires.rest_offset)},
  {ROW(TB_PARAM_WIRES_REST_SPREAD, "wires", "rest_spread", "m",
       "how far the highest and the lowest wire lie from rest_offset", NUMBER(0, 0.001, 0)),
   AT(wires.rest_spread)},
  {ROW(TB_PARAM_WIRES_BEND_HEIGHT, "wires", "bend_height", "m",
       "how far wires are bent away from straight, root mean square", NUMBER(0, 0.001, 0)),
   AT(wires.bend_height)},
  {ROW(TB_PARAM_WIRES_BEND_LENGTH, "wires", "bend_length", "m",
       "distance along a wire over which its bends change", NUMBER(0.005, 1, 0.02), LOGARITHMIC),
   AT(wires.bend_length)},
  {ROW(TB_PARAM_WIRES_UNEVENNESS, "wires", "unevenness", "",
       "factor of rest_spread and bend_height, 0: straight wires side by side", NUMBER(0, 3, 1)),
   AT(wires.unevenness)},
  {ROW(TB_PARAM_WIRES_CONTACT_STIFFNESS, "wires", "contact_stiffness", "N/m^(exponent+1)",
       "stiffness of the contact per length of wire", NUMBER(1e4, 1e13, 1e8), LOGARITHMIC),
   AT(wires.contact_stiffness)},
  {ROW(TB_PARAM_WIRES_CONTACT_EXPONENT, "wires", "contact_exponent", "",
       "power of the penetration in the contact force", NUMBER(1, 3, 1.5)),
   AT(wires.contact_exponent)},
  {ROW(TB_PARAM_WIRES_CONTACT_LOSS, "wires", "contact_loss", "s/m",
       "Hunt-Crossley loss of the contact", NUMBER(0, 100, 0.3)),
   AT(wires.contact_loss)},

  {ROW(TB_PARAM_WIRE_LENGTH, "wire.", "length", "m", "its own length", NUMBER(0.02, 1.5, FOLLOWS),
       LOGARITHMIC),
   IN_WIRE(length)},
  {ROW(TB_PARAM_WIRE_ANGLE, "wire.", "angle", "deg", "its own direction",
       NUMBER(-360, 360, FOLLOWS)),
   IN_WIRE(angle)},
  {ROW(TB_PARAM_WIRE_OFFSET, "wire.", "offset", "m",
       "its own distance from the head's centre, across", NUMBER(-0.6, 0.6, FOLLOWS)),
   IN_WIRE(offset)},
  {ROW(TB_PARAM_WIRE_MASS_PER_LENGTH, "wire.", "mass_per_length", "kg/m", "its own mass",
       NUMBER(1e-4, 0.1, FOLLOWS), LOGARITHMIC),
   IN_WIRE(mass_per_length)},
  {ROW(TB_PARAM_WIRE_TENSION, "wire.", "tension", "N", "its own tension, without the spread",
       NUMBER(0.01, 200, FOLLOWS), LOGARITHMIC),
   IN_WIRE(tension)},
  {ROW(TB_PARAM_WIRE_BENDING_STIFFNESS, "wire.", "bending_stiffness", "N m2",
       "its own bending stiffness", NUMBER(0, 0.1, FOLLOWS)),
   IN_WIRE(bending_stiffness)},
  {ROW(TB_PARAM_WIRE_DAMPING_0, "wire.", "damping_0", "1/s",
       "its own loss, the same at all frequencies", NUMBER(0, 1000, FOLLOWS)),
   IN_WIRE(damping_0)},
  {ROW(TB_PARAM_WIRE_DAMPING_1, "wire.", "damping_1", "m2/s",
       "its own loss that grows with the square of the wave number", NUMBER(0, 0.1, FOLLOWS)),
   IN_WIRE(damping_1)},
  {ROW(TB_PARAM_WIRE_REST_OFFSET, "wire.", "rest_offset", "m",
       "its own ends from the undeflected head, positive is away", NUMBER(-0.01, 0.02, FOLLOWS)),
   IN_WIRE(rest_offset)},
  {ROW(TB_PARAM_WIRE_CONTACT_STIFFNESS, "wire.", "contact_stiffness", "N/m^(exponent+1)",
       "its own stiffness of the contact per length", NUMBER(1e4, 1e13, FOLLOWS), LOGARITHMIC),
   IN_WIRE(contact_stiffness)},
  {ROW(TB_PARAM_WIRE_CONTACT_EXPONENT, "wire.", "contact_exponent", "",
       "its own power of the penetration", NUMBER(1, 3, FOLLOWS)),
   IN_WIRE(contact_exponent)},
  {ROW(TB_PARAM_WIRE_CONTACT_LOSS, "wire.", "contact_loss", "s/m", "its own Hunt-Crossley loss",
       NUMBER(0, 100, FOLLOWS)),
   IN_WIRE(contact_loss)},

  {ROW(TB_PARAM_STRIKER_KIND, "striker.", "kind", "", "what it is",
       CHOICE("stick|mallet|finger|brush", TABOR_STRIKER_STICK)),
   IN_STRIKER(kind)},
  {ROW(TB_PARAM_STRIKER_MASS, "striker.", "mass", "kg", "effective mass of the tip",
       NUMBER(1e-4, 1, 0.012), LOGARITHMIC),
   IN_STRIKER(mass)},
  {ROW(TB_PARAM_STRIKER_BENDING_FREQUENCY, "striker.", "bending_frequency", "Hz",
       "lowest frequency of the stick as it bends, 0: stiff", NUMBER(0, 20000, 400)),
   IN_STRIKER(bending_frequency), .least = 50, .zero = true},
  {ROW(TB_PARAM_STRIKER_CONTACT_STIFFNESS, "striker.", "contact_stiffness", "N/m^exponent",
       "stiffness of the contact", NUMBER(1e3, 1e13, 3e6), LOGARITHMIC),
   IN_STRIKER(contact_stiffness)},
  {ROW(TB_PARAM_STRIKER_CONTACT_EXPONENT, "striker.", "contact_exponent", "",
       "power of the penetration in the contact force", NUMBER(1, 3, 1.5)),
   IN_STRIKER(contact_exponent)},
  {ROW(TB_PARAM_STRIKER_CONTACT_LOSS, "striker.", "contact_loss", "s/m",
       "Hunt-Crossley loss of the contact", NUMBER(0, 100, 0.05)),
   IN_STRIKER(contact_loss)},
  {ROW(TB_PARAM_STRIKER_CONTACT_RADIUS, "striker.", "contact_radius", "m",
       "radius of the patch over which the force spreads", NUMBER(0, 0.05, 0.006)),
   IN_STRIKER(contact_radius)},
  {ROW(TB_PARAM_STRIKER_BRISTLES, "striker.", "bristles", "", "wires of a brush",
       WHOLE(3, 1000, 200), LOGARITHMIC),
   IN_STRIKER(bristles)},
  {ROW(TB_PARAM_STRIKER_SPREAD, "striker.", "spread", "m", "radius of a brush's fan",
       NUMBER(0.005, 0.15, 0.04), LOGARITHMIC),
   IN_STRIKER(spread)},
  {ROW(TB_PARAM_STRIKER_SWEEP_SPEED, "striker.", "sweep_speed", "m/s",
       "speed of a brush along the head in a sweep", NUMBER(0.01, 5, 0.8), LOGARITHMIC),
   IN_STRIKER(sweep_speed)},

  {ROW(TB_PARAM_HAND_STIFFNESS, "hand", "stiffness", "N/m", "spring of a hand that presses a stick",
       NUMBER(0, 1000, 20)),
   AT(hand.stiffness)},
  {ROW(TB_PARAM_HAND_DAMPING, "hand", "damping", "N s/m", "damping of a hand that presses a stick",
       NUMBER(0, 10, 0.2)),
   AT(hand.damping)},
  {ROW(TB_PARAM_HAND_PIVOT, "hand", "pivot", "m",
       "from the stick's butt to where the hand holds it", NUMBER(0, 0.3, 0.12)),
   AT(hand.pivot)},
  {ROW(TB_PARAM_HAND_GRIP, "hand", "grip", "", "how firmly the hand holds the stick, 0: not at all",
       NUMBER(0, 1, 0.5), LIVE),
   AT(hand.grip)},

  {ROW(TB_PARAM_HOOP_HEIGHT, "hoop", "height", "m", "height of the hoop's edge above the head",
       NUMBER(0, 0.05, 0.012)),
   AT(hoop.height)},
  {ROW(TB_PARAM_HOOP_MASS, "hoop", "mass", "kg", "mass of the batter's hoop", NUMBER(0.05, 20, 1.2),
       LOGARITHMIC),
   AT(hoop.mass)},
  {ROW(TB_PARAM_HOOP_CONTACT_STIFFNESS, "hoop", "contact_stiffness", "N/m^1.5",
       "stiffness of the contact of a stick with the hoop", NUMBER(1e5, 1e11, 1e8), LOGARITHMIC),
   AT(hoop.contact_stiffness)},
  {ROW(TB_PARAM_HOOP_CONTACT_LOSS, "hoop", "contact_loss", "s/m",
       "Hunt-Crossley loss of the contact of a stick with the hoop", NUMBER(0, 100, 0.1)),
   AT(hoop.contact_loss)},
  {ROW(TB_PARAM_HOOP_BENDING_STIFFNESS, "hoop", "bending_stiffness", "N m2",
       "bending stiffness EI of the hoop's section, 0: it moves with the shell", NUMBER(0, 1e6, 0)),
   AT(hoop.bending_stiffness), .least = 0.1, .zero = true},
  {ROW(TB_PARAM_HOOP_LOSS, "hoop", "loss", "", "loss factor of the hoop's bending",
       NUMBER(0, 1, 0.01)),
   AT(hoop.loss)},
  {ROW(TB_PARAM_HOOP_TIE_FREQUENCY, "hoop", "tie_frequency", "Hz",
       "frequency of the hoop on rods, lugs and collar over a shell at rest",
       NUMBER(50, 20000, 1600), LOGARITHMIC),
   AT(hoop.tie_frequency)},
  {ROW(TB_PARAM_HOOP_TIE_LOSS, "hoop", "tie_loss", "", "loss factor of rods, lugs and collar",
       NUMBER(0, 1, 0.06)),
   AT(hoop.tie_loss)},
  {ROW(TB_PARAM_HOOP_WIDTH, "hoop", "width", "m",
       "width of the hoop seen from above, which its sound depends on", NUMBER(0, 0.05, 0.01)),
   AT(hoop.width)},
  {ROW(TB_PARAM_HOOP_WALL, "hoop", "wall", "m",
       "height of the hoop's section, which leans as the hoop bends and so sounds",
       NUMBER(0, 0.1, 0.028)),
   AT(hoop.wall)},
  {ROW(TB_PARAM_HOOP_TORSION, "hoop", "torsion", "",
       "torsional over bending stiffness of the hoop's section", NUMBER(0.001, 10, 1), LOGARITHMIC),
   AT(hoop.torsion)},

  {ROW(TB_PARAM_STRIKE_VELOCITY, "strike", "velocity", "m/s", "speed of the usual stroke",
       NUMBER(0.01, 30, 2.5), LOGARITHMIC),
   AT(strike.velocity)},
  {ROW(TB_PARAM_STRIKE_RADIUS, "strike", "radius", "m", "its distance from the head's centre",
       NUMBER(0, 0.6, 0.05)),
   AT(strike.radius)},
  {ROW(TB_PARAM_STRIKE_ANGLE, "strike", "angle", "deg", "its direction from the head's centre",
       NUMBER(-360, 360, 0)),
   AT(strike.angle)},
  {ROW(TB_PARAM_STRIKE_STRIKER, "strike", "striker", "", "name of its striker; empty: the first",
       TEXT),
   SIZED(strike.striker), .identifier = true},
  {ROW(TB_PARAM_STRIKE_TECHNIQUE, "strike", "technique", "", "how it is made",
       CHOICE("normal|buzz|rimshot|cross-stick|rim|sweep|pedal", TABOR_TECHNIQUE_NORMAL)),
   AT(strike.technique)},

  {ROW(TB_PARAM_MIC_RADIUS, "mic.", "radius", "m", "distance from the drum's axis",
       NUMBER(0, 10, 0.05)),
   IN_MIC(radius)},
  {ROW(TB_PARAM_MIC_ANGLE, "mic.", "angle", "deg", "direction from the drum's axis",
       NUMBER(-360, 360, 90)),
   IN_MIC(angle)},
  {ROW(TB_PARAM_MIC_HEIGHT, "mic.", "height", "m",
       "height above the batter head, negative below, at least 0.01 either way",
       NUMBER(-10, 10, 0.10)),
   IN_MIC(height), .least = 0.01},
  {ROW(TB_PARAM_MIC_GAIN, "mic.", "gain", "", "factor on its signal", NUMBER(0, 100, 1), LIVE),
   IN_MIC(gain)},
  {ROW(TB_PARAM_MIC_RESPONSE, "mic.", "response", "",
       "frequency response; dynamic: close to a snare; even-dynamic: below it; large-dynamic: for "
       "bass drums",
       CHOICE("flat|dynamic|large-dynamic|condenser|even-dynamic", TABOR_RESPONSE_FLAT)),
   IN_MIC(response)},

  {ROW(TB_PARAM_AIR_DENSITY, "air", "density", "kg/m3", "density of the air, 0 is vacuum",
       NUMBER(0, 5, 1.205)),
   AT(air.density)},
  {ROW(TB_PARAM_AIR_SOUND_SPEED, "air", "sound_speed", "m/s", "speed of sound",
       NUMBER(100, 2000, 343), LOGARITHMIC),
   AT(air.sound_speed)},
  {ROW(TB_PARAM_AIR_GRAVITY, "air", "gravity", "m/s2", "gravity", NUMBER(0, 30, 9.81)),
   AT(air.gravity)},

  {ROW(TB_PARAM_ROOM_KIND, "room", "kind", "", "the room around the drum; none: free air",
       CHOICE("none|booth|studio|hall", TABOR_ROOM_NONE)),
   AT(room.kind)},
  {ROW(TB_PARAM_ROOM_SIZE, "room", "size", "m",
       "length, width and height in proportion, 0: by kind", NUMBER(0, 100, 0)),
   AT(room.size), .least = 1, .zero = true},
  {ROW(TB_PARAM_ROOM_DECAY, "room", "decay", "s",
       "time in which low notes fall by 60 dB, 0: by kind", NUMBER(0, 20, 0)),
   AT(room.decay), .least = 0.05, .zero = true},
  {ROW(TB_PARAM_ROOM_TILT, "room", "tilt", "",
       "decay time at 8 kHz over that of low notes, 0: by kind", NUMBER(0, 1, 0)),
   AT(room.tilt), .least = 0.25, .zero = true},
  {ROW(TB_PARAM_ROOM_LEVEL, "room", "level", "",
       "factor on what the room adds, 1: as in a diffuse field", NUMBER(0, 10, 1)),
   AT(room.level)},

  {ROW(TB_PARAM_QUALITY_LEVEL, "quality", "level", "",
       "accuracy against cost, of the library; tabor takes --quality",
       CHOICE("draft|live|studio|reference", TABOR_QUALITY_STUDIO - TABOR_QUALITY_DRAFT)),
   AT(quality.level), .base = TABOR_QUALITY_DRAFT},
  {ROW(TB_PARAM_QUALITY_TWO_WAY_BANDWIDTH, "quality", "two_way_bandwidth", "Hz",
       "modes up to here feel the contacts, 0: by level", NUMBER(0, 40000, 0)),
   AT(quality.two_way_bandwidth)},
  {ROW(TB_PARAM_QUALITY_BANDWIDTH, "quality", "bandwidth", "Hz",
       "modes up to here are heard, 0: by level", NUMBER(0, 40000, 0)),
   AT(quality.bandwidth)},
  {ROW(TB_PARAM_QUALITY_NEWTON_CAP, "quality", "newton_cap", "",
       "iterations of the contact solver a sample at most, 0: by level", WHOLE(0, 16, 0)),
   AT(quality.newton_cap)},
  {ROW(TB_PARAM_QUALITY_WIRE_POINTS, "quality", "wire_points", "",
       "cells of a wire at most, 0: by level, otherwise from 8", WHOLE(0, 400, 0)),
   AT(quality.wire_points), .least = 8, .zero = true},
  {ROW(TB_PARAM_QUALITY_LOSSES, "quality", "losses", "",
       "1, or 0 to switch off every loss and radiation", WHOLE(0, 1, 1)),
   AT(quality.losses)},

  {ROW(TB_PARAM_OUTPUT_FULL_SCALE, "output", "full_scale", "Pa", "sound pressure at 0 dBFS",
       NUMBER(1e-3, 1e5, 20), LOGARITHMIC, LIVE),
   AT(full_scale)},
};

const uint32_t tb_param_count = (uint32_t)(sizeof tb_params / sizeof tb_params[0]);

uint32_t tabor_parameter_count(void) { return tb_param_count; }

const TaborParameter *tabor_parameter(uint32_t index) {
  return index < tb_param_count ? &tb_params[index].info : NULL;
}

const TbParam *tb_param_by_id(uint32_t id) {
  for (uint32_t i = 0; i < tb_param_count; i++) {
    if (tb_params[i].info.id == id) return &tb_params[i];
  }
  return NULL;
}

uint32_t tb_group_capacity(TbGroup group) {
  switch (group) {
  case TB_GROUP_WIRE: return TABOR_MAX_WIRES;
  case TB_GROUP_STRIKER: return TABOR_MAX_STRIKERS;
  case TB_GROUP_MIC: return TABOR_MAX_MICS;
  case TB_GROUP_SINGLE:
  case TB_GROUP_RESONANT:
  case TB_GROUP_PLATE:
  case TB_GROUP_HIHAT: break;
  }
  return 1;
}

bool tb_group_is_array(TbGroup group) { return tb_group_capacity(group) > 1; }

void *tb_param_field(const TbParam *param, TaborDrumDef *def, uint32_t element) {
  return (unsigned char *)def + param->offset + element * param->stride;
}

const void *tb_param_field_const(const TbParam *param, const TaborDrumDef *def, uint32_t element) {
  return (const unsigned char *)def + param->offset + element * param->stride;
}
