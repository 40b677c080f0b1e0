/* SPDX-License-Identifier: MIT */
#include "plugin/kit_knobs.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "plugin/choice_text.h"

#define LEVEL(n)                                                                                   \
  {                                                                                                \
    .symbol = "level_" #n, .name = "Drum " #n " level", .group = "Levels", .minimum = -60,         \
    .maximum = 24, .fallback = 0, .unit = "dB", .off = true                                        \
  }
#define TUNE(n)                                                                                    \
  {                                                                                                \
    .symbol = "tune_" #n, .name = "Drum " #n " tuning", .group = "Tuning", .minimum = -12,         \
    .maximum = 12, .fallback = 0, .unit = "semitones", .rebuilds = true, .follows = true           \
  }

const KitKnob kit_knobs[KIT_KNOB_COUNT] = {
  [KIT_KNOB_KIT] = {.symbol = "kit",
                    .name = "Kit",
                    .group = "Kit",
                    .minimum = 0,
                    .maximum = 4,
                    .fallback = 0,
                    .unit = "",
                    .choices = "standard|jazz|marching|frame-drums|Own kit",
                    .rebuilds = true},
  [KIT_KNOB_QUALITY] = {.symbol = "quality",
                        .name = "Quality",
                        .group = "Kit",
                        .minimum = 0,
                        .maximum = 2,
                        .fallback = 1,
                        .unit = "",
                        .choices = "Draft|Live|Studio",
                        .rebuilds = true,
                        .follows = true},
  [KIT_KNOB_ROOM] = {.symbol = "room",
                     .name = "Room",
                     .group = "Kit",
                     .minimum = 0,
                     .maximum = 4,
                     .fallback = 0,
                     .unit = "",
                     .choices = "The kit's|None|Booth|Studio|Hall",
                     .rebuilds = true,
                     .follows = true},
  [KIT_KNOB_COUPLING] = {.symbol = "coupling",
                         .name = "Drums hear each other",
                         .group = "Kit",
                         .minimum = -60,
                         .maximum = 24,
                         .fallback = 0,
                         .unit = "dB",
                         .off = true},
  [KIT_KNOB_OVERHEADS] = {.symbol = "overheads",
                          .name = "Overheads",
                          .group = "Levels",
                          .minimum = -60,
                          .maximum = 24,
                          .fallback = 0,
                          .unit = "dB",
                          .off = true},
  [KIT_KNOB_VELOCITY_CURVE] = {.symbol = "velocity_curve",
                               .name = "Velocity curve",
                               .group = "Kit",
                               .minimum = 0,
                               .maximum = 2,
                               .fallback = 1,
                               .unit = "",
                               .choices = "Soft|Linear|Hard"},
  [KIT_KNOB_VELOCITY_RANGE] = {.symbol = "velocity_range",
                               .name = "Velocity range",
                               .group = "Kit",
                               .minimum = 0,
                               .maximum = 1,
                               .fallback = 0,
                               .unit = "",
                               .choices = "Normal|Full"},
  [KIT_KNOB_NOTES] = {.symbol = "notes",
                      .name = "Notes of",
                      .group = "Kit",
                      .minimum = 0,
                      .maximum = 5,
                      .fallback = 0,
                      .unit = "",
                      .choices = "General MIDI|roland|yamaha|alesis|superior|addictive",
                      .rebuilds = true},
  [KIT_KNOB_GAIN] = {.symbol = "gain",
                     .name = "Gain",
                     .group = "Levels",
                     .minimum = -60,
                     .maximum = 24,
                     .fallback = 0,
                     .unit = "dB",
                     .off = true},
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
};

float kit_knob_clamp(KitKnobId id, double value) {
  const KitKnob *const knob = &kit_knobs[id];
  if (isnan(value)) return knob->fallback;
  const double within = fmin(fmax(value, (double)knob->minimum), (double)knob->maximum);
  return (float)(knob->choices ? trunc(within) : within);
}

double kit_knob_factor(KitKnobId id, float value) {
  return value <= kit_knobs[id].minimum ? 0 : pow(10, (double)value / 20);
}

double kit_knob_beside(KitKnobId id, float value, double own, double least) {
  if (value <= kit_knobs[id].minimum) return KIT_KNOB_NONE;
  return fmin(fmax(own + (double)value, least), 24);
}

int kit_knob_text(KitKnobId id, float value, char *text, size_t size) {
  const KitKnob *const knob = &kit_knobs[id];
  if (knob->choices) return choice_text(knob->choices, (int)value, text, (uint32_t)size);
  if (knob->off && value <= knob->minimum) return snprintf(text, size, "Off");
  return snprintf(text, size, "%.6g %s", (double)value, knob->unit);
}

/* ---- the kit -------------------------------------------------------------------------------- */

/* A string's and a membrane's pitch grows with the square root of the tension; a pitch that is set leads it. */
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

bool kit_knob_is_own(float kit) { return kit >= kit_knobs[KIT_KNOB_KIT].maximum; }

TaborStatus kit_knob_kit(float kit, OwnKit *own, TaborKitDef *def, TaborError *error) {
  const bool is_own = kit_knob_is_own(kit);
  if (is_own && own_kit_copy(own, def)) return TABOR_OK;
  const float built_in = is_own ? kit_knobs[KIT_KNOB_KIT].fallback : kit;
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
