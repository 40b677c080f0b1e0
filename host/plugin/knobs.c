/* SPDX-License-Identifier: MIT */
#include "plugin/knobs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drums/preset_place.h"
#include "drums/stereo_pair.h"
#include "plugin/stick_choice.h"

#define LOWEST_LEVEL (-60) /* [dB]: off */
#define LOWEST_PITCH 20    /* [Hz] and the highest: between them are those of the presets' heads */
#define HIGHEST_PITCH 900

#define ENGINE_RANGE .minimum = NAN, .maximum = NAN
#define RANGE(low, high) .minimum = (low), .maximum = (high)
#define FROM_PRESET .fallback = NAN, .off = NAN
#define OFF_AT_0(word) .fallback = NAN, .off = 0, .off_word = (word)
/* [Hz], six digits: DEFAULT_PRESET's, which the engine computes too slowly for a host that opens an
   instance. A test compares them with knob_shown(). */
#define BATTER_PITCH 270.296
#define RESONANT_PITCH 304.944
#define LEVEL(value)                                                                               \
  .kind = KNOB_SETTING, RANGE(LOWEST_LEVEL, 12), .fallback = (value), .unit = "dB",                \
  .off = LOWEST_LEVEL, .is_level = true, .group = "mics"

const Knob knobs[KNOB_COUNT] = {
  [KNOB_BATTER_TENSION] = {.symbol = "batter_tension",
                           .name = "Batter head tension",
                           .key = "batter.tension",
                           .group = "physics",
                           .kind = KNOB_REBUILD,
                           ENGINE_RANGE,
                           FROM_PRESET,
                           .comment = "How tight the struck head is, unless its pitch says."},
  [KNOB_RESONANT_TENSION] =
    {.symbol = "resonant_tension",
     .name = "Resonant head tension",
     .key = "resonant.tension",
     .group = "physics",
     .kind = KNOB_REBUILD,
     ENGINE_RANGE,
     FROM_PRESET,
     .comment =
       "How tight the lower head is, unless its pitch says. No effect on drums with one head."},
  [KNOB_BATTER_MUFFLING] = {.symbol = "batter_muffle_strength",
                            .name = "Batter head muffling",
                            .key = "batter.muffle_strength",
                            .group = "heads",
                            .kind = KNOB_LIVE,
                            ENGINE_RANGE,
                            OFF_AT_0("Open"),
                            .scale = KNOB_IN_ROOTS,
                            .comment = "How hard a damper brakes the struck head; 0 is none."},
  [KNOB_RESONANT_MUFFLING] = {.symbol = "resonant_muffle_strength",
                              .name = "Resonant head muffling",
                              .key = "resonant.muffle_strength",
                              .group = "heads",
                              .kind = KNOB_LIVE,
                              ENGINE_RANGE,
                              OFF_AT_0("Open"),
                              .scale = KNOB_IN_ROOTS,
                              .comment = "How hard a damper brakes the lower head; 0 is none."},
  [KNOB_STRAINER] = {.symbol = "wires_strainer",
                     .name = "Strainer",
                     .key = "wires.strainer",
                     .group = "snares",
                     .kind = KNOB_LIVE,
                     ENGINE_RANGE,
                     OFF_AT_0("Off"),
                     .top_word = "On",
                     .scale = KNOB_IN_PER_CENT,
                     .comment = "1: the snares lie on the head; 0: they are thrown off."},
  [KNOB_WIRE_TENSION] = {.symbol = "wires_tension",
                         .name = "Wire tension",
                         .key = "wires.tension",
                         .group = "physics",
                         .kind = KNOB_LIVE,
                         ENGINE_RANGE,
                         FROM_PRESET,
                         .comment = "How tight each snare wire is."},
  [KNOB_STICK_HARDNESS] = {.symbol = "striker_contact_stiffness",
                           .name = "Stick hardness",
                           .key = "striker.stick.contact_stiffness",
                           .group = "stick",
                           .kind = KNOB_REBUILD,
                           RANGE(1e5, 1e12),
                           FROM_PRESET,
                           .scale = KNOB_IN_PER_CENT,
                           .comment = "How hard the tip of the drum's usual stick or mallet is."},
  [KNOB_STRIKE_RADIUS] = {.symbol = "strike_radius",
                          .name = "Strike place",
                          .key = "strike.radius",
                          .group = "stick",
                          .kind = KNOB_STROKE,
                          ENGINE_RANGE,
                          FROM_PRESET,
                          .comment = "How far from the centre of the head strokes fall, until "
                                     "MIDI controller 16 says. Beyond the rim it is the rim."},
  [KNOB_STRIKE_ANGLE] = {.symbol = "strike_angle",
                         .name = "Strike direction",
                         .key = "strike.angle",
                         .group = "stick",
                         .kind = KNOB_STROKE,
                         RANGE(-180, 180),
                         FROM_PRESET,
                         .comment = "In which direction from the centre strokes fall, until MIDI "
                                    "controller 17 says."},
  [KNOB_BATTER_PITCH] =
    {.symbol = "batter_pitch",
     .name = "Batter head pitch",
     .key = "batter.pitch",
     .group = "heads",
     .kind = KNOB_REBUILD,
     RANGE(0, HIGHEST_PITCH),
     .least = LOWEST_PITCH,
     .fallback = BATTER_PITCH,
     .off = 0,
     .scale = KNOB_IN_NOTES,
     .comment = "What a tuner reads at a lug of the struck head. Turning it moves the tension; the "
                "drum goes on ringing while it is retuned, which takes some tenths of a second. 0: "
                "the tension leads. Of a pitch that the head cannot reach it takes the nearest "
                "that it can."},
  [KNOB_RESONANT_PITCH] = {.symbol = "resonant_pitch",
                           .name = "Resonant head pitch",
                           .key = "resonant.pitch",
                           .group = "heads",
                           .kind = KNOB_REBUILD,
                           RANGE(0, HIGHEST_PITCH),
                           .least = LOWEST_PITCH,
                           .fallback = RESONANT_PITCH,
                           .off = 0,
                           .scale = KNOB_IN_NOTES,
                           .comment =
                             "What a tuner reads at a lug of the lower head. Turning it moves the "
                             "tension. 0: the tension leads. No effect on drums with one head."},
  [KNOB_UNEVENNESS] = {.symbol = "wires_unevenness",
                       .name = "Wire unevenness",
                       .key = "wires.unevenness",
                       .group = "snares",
                       .kind = KNOB_REBUILD,
                       ENGINE_RANGE,
                       OFF_AT_0("Straight"),
                       .scale = KNOB_IN_PER_CENT,
                       .comment =
                         "How unevenly the snares lie and how far they are bent, times what "
                         "the drum says; 0: straight wires side by side."},
  [KNOB_DRUM] = {.symbol = "drum",
                 .name = "Drum",
                 .group = "drum",
                 .kind = KNOB_REBUILD,
                 RANGE(0, 48),
                 .fallback = 5, /* DEFAULT_PRESET */
                 .unit = "",
                 .choices =
                   "tabor|frame-drum|bodhran-piano-string|bodhran-d-string|"
                   "bodhran-d-string-tensioned|snare-14x5.5|snare-14x5.5-off|snare-14x6.5-loose|"
                   "piccolo-13x3.5|marching-14x12|tom-12|floor-tom-16|bass-drum-22|timpani-26|"
                   "snare-14x8|snare-14x5-steel|tom-10|bass-drum-18|crash-16|ride-20|"
                   "crash-18|ride-22|splash-10|china-18|hihat-14|snare-funk-tight|"
                   "snare-ballad-deep|snare-seventies-dead|snare-jazz-open|snare-rock-fat|"
                   "snare-metal-crack|snare-reggae-high|snare-soul-dry|snare-studio-medium|"
                   "snare-garage-trash|snare-orchestral|snare-disco-thud|snare-marching-indoor|"
                   "tom-10-fusion|tom-12-jazz-high|tom-12-rock-low|floor-tom-16-jazz|"
                   "floor-tom-16-dead|bass-drum-18-bop|bass-drum-22-rock-punch|"
                   "bass-drum-22-vintage|frame-drum-low|tom-8|snare-14x5-maple",
                 .off = NAN,
                 .comment = "Turning it takes another drum, as a program change of MIDI does. A "
                            "drum that was changed or loaded stays until then."},
  [KNOB_VELOCITY_CURVE] = {.symbol = "velocity_curve",
                           .name = "Velocity curve",
                           .group = "stick",
                           .is_of_player = true,
                           .kind = KNOB_SETTING,
                           RANGE(0, 2),
                           .fallback = 1,
                           .unit = "",
                           .choices = "Soft|Linear|Hard",
                           .off = NAN,
                           .comment = "Soft: a light touch is already loud."},
  [KNOB_HUMANIZE] = KNOB_OF_HUMANIZE("stick"),
  [KNOB_QUALITY] = {.symbol = "quality_level",
                    .name = "Quality",
                    .group = "output",
                    .is_of_player = true,
                    .kind = KNOB_SETTING,
                    RANGE(0, 3),
                    .fallback = 1,
                    .unit = "",
                    .choices = "Draft|Live|Studio|Reference",
                    .off = NAN,
                    .is_costly = true,
                    .comment =
                      "Accuracy against the load of the processor. Studio and Reference are "
                      "for export."},
  [KNOB_GAIN] = {.symbol = "gain",
                 .name = "Gain",
                 .group = "output",
                 .is_gain = true,
                 .kind = KNOB_SETTING,
                 RANGE(LOWEST_LEVEL, 20),
                 .fallback = 0,
                 .unit = "dB",
                 .off = LOWEST_LEVEL,
                 .comment = "Of all outputs; MIDI volume and expression are beside it."},
  [KNOB_LEVEL_PAIR] = {.symbol = "level_pair",
                       .name = "Stereo pair",
                       LEVEL(STEREO_GAIN_DB),
                       .comment = "Level of the microphones left and right, in front of the drum. "
                                  "Drums without them are heard by their first one."},
  [KNOB_LEVEL_TOP] = {.symbol = "level_top",
                      .name = "Top microphone",
                      LEVEL(LOWEST_LEVEL),
                      .mic = "top",
                      .comment = "Level of the microphone close above the struck head."},
  [KNOB_LEVEL_BOTTOM] = {.symbol = "level_bottom",
                         .name = "Bottom microphone",
                         LEVEL(LOWEST_LEVEL),
                         .mic = "bottom",
                         .comment = "Level of the microphone close below the drum."},
  [KNOB_LEVEL_NEAR] = {.symbol = "level_near",
                       .name = "Near microphone",
                       LEVEL(LOWEST_LEVEL),
                       .mic = "near",
                       .comment = "Level of the microphone at the player's side."},
  [KNOB_LEVEL_FAR] = {.symbol = "level_far",
                      .name = "Far microphone",
                      LEVEL(LOWEST_LEVEL),
                      .mic = "far",
                      .comment = "Level of the microphone some way off."},
  [KNOB_VELOCITY_RANGE] = {.symbol = "velocity_range",
                           .name = "Velocity range",
                           .group = "stick",
                           .is_of_player = true,
                           .kind = KNOB_SETTING,
                           RANGE(0, 1),
                           .fallback = 0,
                           .unit = "",
                           .choices = "Normal|Full",
                           .off = NAN,
                           .comment = "Normal: 1 to 10 m/s, and softer ghost notes below velocity "
                                      "20. Full: 0.3 to 12 m/s."},
  [KNOB_STICK] = {.symbol = "stick",
                  .name = "Stick",
                  .group = "stick",
                  .kind = KNOB_SETTING,
                  RANGE(0, STICK_CHOICE_COUNT - 1),
                  .fallback = 0,
                  .unit = "",
                  .choices = STICK_CHOICES,
                  .is_costly = true,
                  .off = NAN,
                  .comment = "Which stick strikes, by its size and the material of its tip. No "
                             "effect on drums that are struck by something else."},
  [KNOB_LEVEL_INSIDE] = {.symbol = "level_inside",
                         .name = "Inside microphone",
                         LEVEL(LOWEST_LEVEL),
                         .mic = "inside",
                         .comment = "Level of the microphone inside the shell of snares and bass "
                                    "drums."},
  [KNOB_ROOM] = {.symbol = "room",
                 .name = "Room",
                 .group = "mics",
                 .kind = KNOB_SETTING,
                 RANGE(TABOR_ROOM_NONE, TABOR_ROOM_HALL),
                 .fallback = TABOR_ROOM_STUDIO,
                 .unit = "",
                 .choices = "None|Booth|Studio|Hall",
                 .off = NAN,
                 .comment = "The room around the drum, which all its microphones hear. Size, "
                            "decay and level are those of the drum's definition."},
  [KNOB_SOUND] = {.symbol = "sound_level",
                  .name = "Loudspeaker",
                  .group = "input",
                  .kind = KNOB_SETTING,
                  RANGE(60, 150),
                  .fallback = 120,
                  .unit = "dB SPL",
                  .off = 60,
                  .comment = "Pressure at the drum when the sound that comes in is at full scale."},
  [KNOB_MIX] = {.symbol = "mix",
                .name = "Mix",
                .group = "input",
                .kind = KNOB_SETTING,
                RANGE(0, 1),
                .fallback = 0.5,
                .unit = "",
                .scale = KNOB_IN_PER_CENT,
                .off = NAN,
                .comment = "0: the sound that comes in alone; 1: the drum alone."},
  [KNOB_ENABLED] = {.symbol = "enabled",
                    .name = "Enabled",
                    .group = "input",
                    .is_bypass = true,
                    .kind = KNOB_SETTING,
                    RANGE(0, 1),
                    .fallback = 1,
                    .unit = "",
                    .choices = "Bypassed|Enabled",
                    .off = NAN,
                    .comment = "0: the sound that comes in passes through, whatever the mix is."},
};

const KnobGroup knob_groups[KNOB_GROUPS] = {
  {"drum", "Drum"},     {"heads", "Heads"},      {"snares", "Snares"},  {"stick", "Stick"},
  {"output", "Output"}, {"mics", "Microphones"}, {"input", "Sound in"}, {"physics", "Physics"}};

const KnobPage knob_pages[KNOB_PAGES] = {
  {0,
   "Drum",
   "Tuning",
   8,
   {KNOB_BATTER_PITCH, KNOB_RESONANT_PITCH, KNOB_BATTER_MUFFLING, KNOB_RESONANT_MUFFLING,
    KNOB_STRAINER, KNOB_STRIKE_RADIUS, KNOB_ROOM, KNOB_GAIN}},
  {2,
   "Drum",
   "Physics",
   6,
   {KNOB_BATTER_TENSION, KNOB_RESONANT_TENSION, KNOB_WIRE_TENSION, KNOB_UNEVENNESS,
    KNOB_STICK_HARDNESS, KNOB_QUALITY}},
  {1,
   "Drum",
   "Stick",
   7,
   {KNOB_STICK_HARDNESS, KNOB_STRIKE_RADIUS, KNOB_STRIKE_ANGLE, KNOB_VELOCITY_CURVE,
    KNOB_VELOCITY_RANGE, KNOB_HUMANIZE, KNOB_STICK}},
  {3,
   "Microphones",
   "Levels",
   8,
   {KNOB_LEVEL_PAIR, KNOB_LEVEL_TOP, KNOB_LEVEL_BOTTOM, KNOB_LEVEL_NEAR, KNOB_LEVEL_FAR,
    KNOB_LEVEL_INSIDE, KNOB_ROOM, KNOB_GAIN}},
  {4, "Sound in", "Sound in", 3, {KNOB_SOUND, KNOB_MIX, KNOB_ENABLED}},
};

const uint32_t knob_ports[KNOB_COUNT] = {
  KNOB_BATTER_TENSION,
  KNOB_RESONANT_TENSION,
  KNOB_BATTER_MUFFLING,
  KNOB_RESONANT_MUFFLING,
  KNOB_STRAINER,
  KNOB_WIRE_TENSION,
  KNOB_STICK_HARDNESS,
  KNOB_STRIKE_RADIUS,
  KNOB_STRIKE_ANGLE,
  KNOB_VELOCITY_CURVE,
  KNOB_HUMANIZE,
  KNOB_QUALITY,
  KNOB_GAIN,
  KNOB_LEVEL_PAIR,
  KNOB_LEVEL_TOP,
  KNOB_LEVEL_BOTTOM,
  KNOB_LEVEL_NEAR,
  KNOB_LEVEL_FAR,
  KNOB_VELOCITY_RANGE,
  KNOB_LEVEL_INSIDE,
  KNOB_BATTER_PITCH,
  KNOB_RESONANT_PITCH,
  KNOB_ROOM,
  KNOB_UNEVENNESS,
  KNOB_SOUND,
  KNOB_MIX,
  KNOB_STICK,
  KNOB_ENABLED,
  KNOB_DRUM,
};

TaborStrikerDef *knob_usual_striker(TaborDrumDef *def) {
  const int named = tabor_drum_def_find_striker(def, def->strike.striker);
  return &def->striker[named > 0 ? named : 0];
}

double *knob_field(TaborDrumDef *def, KnobId id) {
  switch (id) {
  case KNOB_BATTER_TENSION: return &def->batter.tension;
  case KNOB_RESONANT_TENSION: return def->two_headed ? &def->resonant.tension : NULL;
  case KNOB_BATTER_MUFFLING: return &def->batter.muffle_strength;
  case KNOB_RESONANT_MUFFLING: return def->two_headed ? &def->resonant.muffle_strength : NULL;
  case KNOB_STRAINER: return def->wires.count > 0 ? &def->wires.strainer : NULL;
  case KNOB_WIRE_TENSION: return def->wires.count > 0 ? &def->wires.tension : NULL;
  case KNOB_STICK_HARDNESS: return &knob_usual_striker(def)->contact_stiffness;
  case KNOB_STRIKE_RADIUS: return &def->strike.radius;
  case KNOB_STRIKE_ANGLE: return &def->strike.angle;
  case KNOB_BATTER_PITCH: return &def->batter.pitch;
  case KNOB_RESONANT_PITCH: return def->two_headed ? &def->resonant.pitch : NULL;
  case KNOB_UNEVENNESS: return def->wires.count > 0 ? &def->wires.unevenness : NULL;
  default: return NULL;
  }
}

void knob_give(TaborDrumDef *def, KnobId id, double value) {
  double *const field = knob_field(def, id);
  if (!field) return;
  const double before = *field;
  *field = id == KNOB_STRIKE_RADIUS ? fmin(value, def->shell.radius) : value;
  if (tabor_drum_def_validate(def, NULL) != TABOR_OK) *field = before;
}

bool knob_has_part(TaborDrumDef *def, KnobId id) {
  if (id < KNOB_KEYS) return knob_field(def, id) != NULL;
  return !knobs[id].mic || tabor_drum_def_find_mic(def, knobs[id].mic) >= 0;
}

/* As a port has it: a host that sets the port to its default does not turn the knob. */
static double pitch_of(const TaborDrumDef *def, TaborHead head) {
  double pitch;
  if (tabor_drum_def_pitch(def, head, &pitch, NULL) != TABOR_OK) return 0;
  return knob_decimal((float)pitch);
}

/* As a knob has it. */
static double number_of(const TaborDrumDef *def) {
  const int place = preset_place(def->name);
  if (place < 0) return NAN;
  return place;
}

double knob_shown(const TaborDrumDef *def, KnobId id) {
  TaborDrumDef copy = *def;
  const double *const field = knob_field(&copy, id);
  if (id == KNOB_DRUM) return number_of(def);
  if (!field) return NAN;
  if (id == KNOB_BATTER_PITCH) return pitch_of(def, TABOR_HEAD_BATTER);
  return id == KNOB_RESONANT_PITCH ? pitch_of(def, TABOR_HEAD_RESONANT) : *field;
}

static double choose(double own, double other) { return isnan(own) ? other : own; }

KnobRange knob_range(KnobId id, const TaborDrumDef *usual) {
  const Knob *const knob = &knobs[id];
  const TaborParameter *const parameter = knob->key ? tabor_parameter_find(knob->key) : NULL;
  TaborDrumDef def = *usual;
  const double *const field = knob->key ? knob_field(&def, id) : NULL;
  return (KnobRange){
    .minimum = (float)choose(knob->minimum, parameter ? parameter->minimum : 0),
    .maximum = (float)choose(knob->maximum, parameter ? parameter->maximum : 0),
    .fallback = (float)choose(knob->fallback, field ? *field : 0),
    .logarithmic = parameter && parameter->logarithmic && knob->least == 0,
    .least = (float)knob->least,
    .unit = knob->unit || !parameter ? knob->unit : parameter->unit,
  };
}

KnobRange knob_range_in(KnobSet set, KnobId id, const TaborDrumDef *usual) {
  KnobRange range = knob_range(id, usual);
  if (set == KNOBS_EFFECT && id == KNOB_LEVEL_PAIR) range.fallback = LOWEST_LEVEL;
  if (set == KNOBS_EFFECT && id == KNOB_LEVEL_BOTTOM) range.fallback = range.maximum;
  return range;
}

KnobId knob_of_refused_pitch(const TaborError *error) {
  if (error->status != TABOR_ERROR_RANGE) return KNOB_COUNT;
  if (strcmp(error->key, knobs[KNOB_BATTER_PITCH].key) == 0) return KNOB_BATTER_PITCH;
  return strcmp(error->key, knobs[KNOB_RESONANT_PITCH].key) == 0 ? KNOB_RESONANT_PITCH : KNOB_COUNT;
}
