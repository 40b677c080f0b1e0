/* SPDX-License-Identifier: MIT */
/* Presets are as loud as one another, and no stroke passes full scale. Loudness is K-weighted
 * [BS1770], by libebur128, at live. Peaks are also looked at at studio, where they come within 0.05
 * s of a stroke, too. All in the preset's first microphone.
 *
 * usage: test_system_levels [brief|tunings]: drums with less than two wires alone, at live alone,
 * for slow builds; tunings instead of drums, at live alone, which otherwise play for 50 ms. */
#include <ebur128.h>

#include "physics.h"

static const double RATE = 48000.0;
static const double FIRM = 4.5, HARDEST = 12.0; /* [m/s] */
enum { FRAMES = 72000, BLOCK = 480 };           /* 1.5 s; loudness is looked at every 10 ms */
enum { LATEST_PEAK = 12000 };                   /* 0.25 s: heads only lose after a stroke */
enum { PEAK_FRAMES = 2400 };                    /* 0.05 s */

typedef struct Level {
  double peak;       /* [dBFS] */
  double momentary;  /* loudest 0.4 s [LUFS] */
  double integrated; /* of the whole [LUFS] */
} Level;

static Level level_of(TaborModel *model, const TaborDrumDef *def, double velocity,
                      uint32_t frames) {
  TaborDrum *drum = physics_drum(model);
  ebur128_state *meter = ebur128_init(1, (unsigned long)RATE, EBUR128_MODE_M | EBUR128_MODE_I);
  assert_non_null(meter);
  TaborEvent stroke = physics_strike(def);
  stroke.velocity = velocity;
  Level level = {.peak = 0.0, .momentary = -HUGE_VAL};
  for (uint32_t n = 0; n < frames; n += BLOCK) {
    float sound[BLOCK];
    float *outputs[TABOR_MAX_MICS] = {sound};
    tabor_drum_process(drum, &stroke, n == 0 ? 1 : 0, outputs, BLOCK);
    for (uint32_t i = 0; i < BLOCK; i++) level.peak = fmax(level.peak, fabs((double)sound[i]));
    double loudness;
    assert_int_equal(ebur128_add_frames_float(meter, sound, BLOCK), EBUR128_SUCCESS);
    assert_int_equal(ebur128_loudness_momentary(meter, &loudness), EBUR128_SUCCESS);
    level.momentary = fmax(level.momentary, loudness);
  }
  assert_int_equal(ebur128_loudness_global(meter, &level.integrated), EBUR128_SUCCESS);
  ebur128_destroy(&meter);
  tabor_drum_destroy(drum);
  level.peak = 20.0 * log10(level.peak);
  return level;
}

typedef struct Levels {
  TaborDrumDef def;
  Level firm, hardest;  /* at live */
  Level studio_hardest; /* its peak alone */
} Levels;

static bool brief, of_tunings;
static Levels levels[64];
static uint32_t presets;

static void measure_preset(Levels *preset) {
  const TaborDrumDef *def = &preset->def;
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_LIVE);
  preset->firm = level_of(model, def, FIRM, FRAMES);
  preset->hardest = level_of(model, def, HARDEST, LATEST_PEAK);
  tabor_model_release(model);
  print_message(
    "%-27s 4.5 m/s: peak %6.2f dBFS, %6.1f LUFS in 0.4 s, %6.1f in all; 12 m/s: %5.2f dBFS\n",
    def->name, preset->firm.peak, preset->firm.momentary, preset->firm.integrated,
    preset->hardest.peak);
  if (brief || of_tunings) return;
  model = physics_model(def, RATE, TABOR_QUALITY_STUDIO);
  preset->studio_hardest = level_of(model, def, HARDEST, PEAK_FRAMES);
  tabor_model_release(model);
  print_message("%-27s 12 m/s: %5.2f dBFS\n", "  at studio", preset->studio_hardest.peak);
}

static int measure(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    const TaborDrumDef def = physics_preset(tabor_preset(i)->name);
    if (brief && def.wires.count > 1) continue;
    if (of_tunings != (tabor_preset(i)->base != NULL)) continue;
    assert_true(presets < sizeof levels / sizeof *levels);
    levels[presets].def = def;
    measure_preset(&levels[presets++]);
  }
  return 0;
}

/* What NEWS.md says of the default stroke [dBFS]. On the soft head of a bass drum, which stretches,
 * and on the edge of a thin cymbal, strokes grow by more than their speed, and the hardest ones
 * leave less room. */
static double least_peak(const char *name) {
  static const char *const CYMBALS[] = {"crash-", "ride-", "splash-", "china-", "hihat-"};
  for (uint32_t i = 0; i < sizeof CYMBALS / sizeof *CYMBALS; i++) {
    if (strncmp(name, CYMBALS[i], strlen(CYMBALS[i])) == 0) return -17.7;
  }
  if (strcmp(name, "bass-drum-22") == 0) return -16.1;
  if (strncmp(name, "bass-drum-22", 12) == 0) return -16.2;
  if (strcmp(name, "tom-12-rock-low") == 0) return -13.2; /* likewise */
  if (strcmp(name, "bass-drum-18") == 0) return -13.2;
  return -12.1;
}

static void the_default_stroke_is_a_firm_one(void **state) {
  (void)state;
  for (uint32_t i = 0; i < presets; i++) {
    assert_true(fabs(levels[i].def.strike.velocity - FIRM) < 1e-9);
    assert_true(levels[i].firm.peak <= -8.0);
    assert_true(levels[i].firm.peak >= least_peak(levels[i].def.name));
  }
}

static void nothing_passes_full_scale(void **state) {
  (void)state;
  for (uint32_t i = 0; i < presets; i++) {
    assert_true(levels[i].hardest.peak < 0.0);
    if (!brief && !of_tunings) assert_true(levels[i].studio_hardest.peak < 0.0);
  }
}

/* Of a drum set: a bass drum's low note weighs little in K-weighting, and its peak leaves no room.
 */
static bool is_snare_or_tom(const char *name) {
  return strncmp(name, "snare-", 6) == 0 || strncmp(name, "piccolo-", 8) == 0 ||
         strncmp(name, "marching-", 9) == 0 || strstr(name, "tom-") != NULL;
}

static void snares_and_toms_are_as_loud_as_one_another(void **state) {
  (void)state;
  double least = HUGE_VAL, most = -HUGE_VAL;
  if (of_tunings) return; /* a dead drum is as loud at its peak, and gone sooner */
  for (uint32_t i = 0; i < presets; i++) {
    if (!is_snare_or_tom(levels[i].def.name)) continue;
    least = fmin(least, levels[i].firm.integrated);
    most = fmax(most, levels[i].firm.integrated);
  }
  print_message("snares and toms: within %.1f dB\n", most - least);
  assert_true(most - least <= 3.0);
}

static void tunings_play(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    if (!tabor_preset(i)->base || of_tunings) continue;
    const TaborDrumDef def = physics_preset(tabor_preset(i)->name);
    if (brief && def.wires.count > 1) continue;
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
    const double peak = level_of(model, &def, FIRM, PEAK_FRAMES).peak;
    tabor_model_release(model);
    if (!(peak >= least_peak(def.name) - 1.0 && peak <= -8.0))
      fail_msg("%s: %.1f dBFS", def.name, peak);
  }
}

int main(int count, char **words) {
  brief = count > 1 && strcmp(words[1], "brief") == 0;
  of_tunings = count > 1 && strcmp(words[1], "tunings") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_default_stroke_is_a_firm_one),
    cmocka_unit_test(nothing_passes_full_scale),
    cmocka_unit_test(snares_and_toms_are_as_loud_as_one_another),
    cmocka_unit_test(tunings_play),
  };
  return cmocka_run_group_tests(tests, measure, NULL);
}
