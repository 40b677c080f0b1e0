/* SPDX-License-Identifier: MIT */
#include "plugin/kit_knobs.h"

#include <math.h>

#define LEVEL(n)                                                                                   \
  {                                                                                                \
    .symbol = "level_" #n, .name = "Drum " #n " level", .group = "levels", .kind = KNOB_SETTING,   \
    .minimum = -60, .maximum = 24, .fallback = 0, .unit = "dB", .off = -60, .is_level = true,      \
    .comment = "Level of the drum in the mix and at its output."                                   \
  }
#define TUNE(n)                                                                                    \
  {                                                                                                \
    .symbol = "tune_" #n, .name = "Drum " #n " tuning", .group = "tuning", .kind = KNOB_REBUILD,   \
    .minimum = -12, .maximum = 12, .fallback = 0, .unit = "semitones", .off = NAN, .step = 0.1,    \
    .comment = "Tunes both heads of the drum. It goes on ringing while it is retuned."             \
  }

#define CHOICES(most, usual, words)                                                                \
  .minimum = 0, .maximum = (most), .fallback = (usual), .unit = "", .choices = (words), .off = NAN
#define DECIBEL .minimum = -60, .maximum = 24, .fallback = 0, .unit = "dB", .off = -60

const Knob kit_knobs[KIT_KNOB_COUNT] = {
  [KIT_KNOB_KIT] = {.symbol = "kit",
                    .name = "Kit",
                    .group = "kit",
                    .kind = KNOB_REPLACE,
                    CHOICES(4, 0, "standard|jazz|marching|frame-drums|Own kit"),
                    .comment = "Which kit plays; the last one is that of a kit file."},
  [KIT_KNOB_QUALITY] = {.symbol = "quality",
                        .name = "Quality",
                        .group = "kit",
                        .is_of_player = true,
                        .kind = KNOB_REBUILD,
                        CHOICES(2, 1, "Draft|Live|Studio"),
                        .comment = "Accuracy against the load of the processor. Studio is for "
                                   "export."},
  [KIT_KNOB_ROOM] = {.symbol = "room",
                     .name = "Room",
                     .group = "kit",
                     .kind = KNOB_REBUILD,
                     CHOICES(4, 0, "The kit's|None|Booth|Studio|Hall"),
                     .comment = "The room in which the kit stands."},
  [KIT_KNOB_COUPLING] = {.symbol = "coupling",
                         .name = "Drums hear each other",
                         .group = "kit",
                         .kind = KNOB_SETTING,
                         DECIBEL,
                         .comment = "How loud drums are at each other's heads and snares, beside "
                                    "what the kit says."},
  [KIT_KNOB_OVERHEADS] = {.symbol = "overheads",
                          .name = "Overheads",
                          .group = "levels",
                          .kind = KNOB_SETTING,
                          .is_level = true,
                          DECIBEL,
                          .comment = "Level of the pair above the kit, beside what the kit says."},
  [KIT_KNOB_VELOCITY_CURVE] = {.symbol = "velocity_curve",
                               .name = "Velocity curve",
                               .group = "kit",
                               .is_of_player = true,
                               .kind = KNOB_SETTING,
                               CHOICES(2, 1, "Soft|Linear|Hard"),
                               .comment = "Soft: a light touch is already loud."},
  [KIT_KNOB_VELOCITY_RANGE] = {.symbol = "velocity_range",
                               .name = "Velocity range",
                               .group = "kit",
                               .is_of_player = true,
                               .kind = KNOB_SETTING,
                               CHOICES(1, 0, "Normal|Full"),
                               .comment = "Normal: 1 to 10 m/s, and softer ghost notes below "
                                          "velocity 20. Full: 0.3 to 12 m/s."},
  [KIT_KNOB_NOTES] = {.symbol = "notes",
                      .name = "Notes of",
                      .group = "kit",
                      .is_of_player = true,
                      .kind = KNOB_REPLACE,
                      CHOICES(5, 0, "General MIDI|roland|yamaha|alesis|superior|addictive"),
                      .comment = "Which notes play which drums: those of General MIDI, or of a "
                                 "drum module or sampler."},
  [KIT_KNOB_GAIN] = {.symbol = "gain",
                     .name = "Gain",
                     .group = "levels",
                     .kind = KNOB_SETTING,
                     .is_gain = true,
                     DECIBEL,
                     .comment = "Level of all outputs."},
  [KIT_KNOB_LEVEL] = LEVEL(1),
  LEVEL(2),
  LEVEL(3),
  LEVEL(4),
  LEVEL(5),
  LEVEL(6),
  LEVEL(7),
  LEVEL(8),
  [KIT_KNOB_TUNE] = TUNE(1),
  TUNE(2),
  TUNE(3),
  TUNE(4),
  TUNE(5),
  TUNE(6),
  TUNE(7),
  TUNE(8),
  [KIT_KNOB_HUMANIZE] = KNOB_OF_HUMANIZE("kit"),
};

const KnobGroup kit_knob_groups[KIT_KNOB_GROUPS] = {
  {"kit", "Kit"}, {"levels", "Levels"}, {"tuning", "Tuning"}};

#define ROW(first)                                                                                 \
  {                                                                                                \
    (first), (first) + 1, (first) + 2, (first) + 3, (first) + 4, (first) + 5, (first) + 6,         \
      (first) + 7                                                                                  \
  }

const KnobPage kit_knob_pages[KIT_KNOB_PAGES] = {
  {1, "Drums", "Levels", KIT_KNOB_DRUMS, ROW(KIT_KNOB_LEVEL)},
  {2, "Drums", "Tuning", KIT_KNOB_DRUMS, ROW(KIT_KNOB_TUNE)},
  {0,
   "Kit",
   "Kit",
   6,
   {KIT_KNOB_KIT, KIT_KNOB_ROOM, KIT_KNOB_COUPLING, KIT_KNOB_OVERHEADS, KIT_KNOB_GAIN,
    KIT_KNOB_QUALITY}},
  {3,
   "Kit",
   "Notes",
   4,
   {KIT_KNOB_NOTES, KIT_KNOB_VELOCITY_CURVE, KIT_KNOB_VELOCITY_RANGE, KIT_KNOB_HUMANIZE}},
};

KnobRange kit_knob_range(KitKnobId id) {
  const Knob *const knob = &kit_knobs[id];
  return (KnobRange){.minimum = (float)knob->minimum,
                     .maximum = (float)knob->maximum,
                     .fallback = (float)knob->fallback,
                     .unit = knob->unit};
}

double kit_knob_beside(KitKnobId id, float value, double own, double least) {
  if ((double)value <= kit_knobs[id].minimum) return KIT_KNOB_NONE;
  return fmin(fmax(own + (double)value, least), 24);
}

/* ---- the kit -------------------------------------------------------------------------------- */

/* A string's and a membrane's pitch grows with the square root of the tension; a pitch that is set
 * leads it. */
static void tune_head(TaborHeadDef *head, double ratio) {
  head->tension *= ratio * ratio;
  head->pitch *= ratio;
}

static void tune_drum(TaborDrumDef *def, float semitones) {
  if (semitones == 0.0f) return;
  const double ratio = exp2((double)semitones / 12);
  TaborDrumDef tuned = *def;
  tune_head(&tuned.batter, ratio);
  tune_head(&tuned.resonant, ratio);
  if (tabor_drum_def_validate(&tuned, NULL) == TABOR_OK) *def = tuned;
}

bool kit_knob_is_own(float kit) { return (double)kit >= kit_knobs[KIT_KNOB_KIT].maximum; }

TaborStatus kit_knob_kit(float kit, OwnKit *own, TaborKitDef *def, TaborError *error) {
  const bool is_own = kit_knob_is_own(kit);
  if (is_own && own_kit_copy(own, def)) return TABOR_OK;
  const double built_in = is_own ? kit_knobs[KIT_KNOB_KIT].fallback : (double)kit;
  return tabor_kit_def_preset(def, tabor_kit((uint32_t)built_in)->name, error);
}

TaborStatus kit_knobs_define(const float values[KIT_KNOB_COUNT], OwnKit *own, TaborKitDef *def,
                             TaborError *error) {
  const TaborStatus status = kit_knob_kit(values[KIT_KNOB_KIT], own, def, error);
  if (status != TABOR_OK) return status;
  if (values[KIT_KNOB_ROOM] > 0) def->room.kind = (uint32_t)values[KIT_KNOB_ROOM] - 1u;
  for (uint32_t i = 0; i < KIT_KNOB_DRUMS && i < def->drum_count; i++) {
    tune_drum(&def->drum[i].def, values[KIT_KNOB_TUNE + i]);
  }
  return tabor_kit_def_validate(def, error);
}
