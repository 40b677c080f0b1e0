/* SPDX-License-Identifier: MIT */
/* Every live parameter at both ends of its range, reached by a step and by a ramp, at every
 * quality: the sound stays bounded, every joule is accounted for, and the drum falls asleep
 * afterwards.
 *
 * usage: test_system_live_params [long]: the snare drum at studio and reference, too. */
#include "physics.h"

static const double RATE = 44100.0;
/* Of a stroke of 12 m/s: what a live parameter may do to the pressure at most. */
static const double LOUDEST = 4.0;
/* Seconds after which the drum is asleep: all but wires without sigma0 ring for two or three. */
static const double LONGEST = 20.0;

static uint32_t finest_quality = TABOR_QUALITY_LIVE; /* of the snare drum */

enum { BLOCK = 64, RAMP = 200 }; /* blocks of the ramp, a third of a second */

typedef struct Play {
  TaborModel *model;
  TaborDrum *drum;
  double full_scale, gain; /* as set so far: they only scale the sound */
  double peak;             /* pressure [Pa] */
} Play;

/* The worst of all plays at a quality. */
typedef struct Worst {
  double asleep, peak; /* [s], and as a part of the loudest stroke's */
} Worst;

/* A snare drum with fewer modes and wires, so that it is computed sooner. */
static TaborDrumDef small_snare(const char *preset) {
  TaborDrumDef def = physics_preset(preset);
  def.quality.two_way_bandwidth = 1500.0;
  def.quality.bandwidth = 3000.0;
  def.quality.wire_points = 12;
  def.wires.damping_1 = 0.01; /* without sigma0 wires of the preset ring for 22 s */
  if (def.wires.count > 2) def.wires.count = 2;
  if (def.wires.count > 1) physics_lay_even(&def); /* a wire that hangs clear rings for longer */
  def.mic_count = 1;
  return def;
}

static Play begin(TaborModel *model) {
  const TaborDrumDef *def = tabor_model_definition(model);
  return (Play){.model = model,
                .drum = physics_drum(model),
                .full_scale = def->full_scale,
                .gain = def->mic[0].gain};
}

/* Plays a block. While gain or full scale move, the least scaling of either counts, so that a peak
 * is never missed. */
static void play(Play *p, const TaborEvent *events, uint32_t count, double scale) {
  float samples[BLOCK], *outputs[TABOR_MAX_MICS] = {samples};
  tabor_drum_process(p->drum, events, count, outputs, BLOCK);
  for (int i = 0; i < BLOCK; i++) {
    assert_true(isfinite(samples[i]));
    p->peak = fmax(p->peak, fabs((double)samples[i]) * scale);
  }
}

static double scale_of(const Play *p) { return p->gain > 0.0 ? p->full_scale / p->gain : 0.0; }

static double loudest_stroke(TaborModel *model) {
  Play p = begin(model);
  TaborEvent stroke = physics_strike(tabor_model_definition(model));
  stroke.velocity = 12.0;
  for (uint32_t i = 0; i < 300; i++) play(&p, &stroke, i == 0, scale_of(&p));
  tabor_drum_destroy(p.drum);
  return p.peak;
}

static bool only_scales(const TaborParameter *parameter) {
  return parameter->id == tabor_parameter_find("output.full_scale")->id ||
         parameter->id == tabor_parameter_find("mic.top.gain")->id;
}

static double present_value(const TaborDrumDef *def, const TaborParameter *parameter) {
  char key[2 * TABOR_NAME_SIZE], text[TABOR_TEXT_SIZE];
  const bool mic = strcmp(parameter->section, "mic.") == 0;
  snprintf(key, sizeof key, "%s%s.%s", parameter->section, mic ? def->mic[0].name : "",
           parameter->key);
  assert_int_equal(tabor_drum_def_get(def, key, text, sizeof text, NULL), TABOR_OK);
  return strtod(text, NULL);
}

/* The residual counts against all energy that was ever put in or taken by the parameter: `control`
 * is a sum. */
static void check_ledger(const Play *p, double *put_in, uint32_t quality, const char *what) {
  TaborLedger ledger;
  TaborStatistics statistics;
  tabor_drum_ledger(p->drum, &ledger);
  tabor_drum_statistics(p->drum, &statistics);
  *put_in = fmax(*put_in, ledger.injected + fabs(ledger.control));
  assert_int_equal(statistics.recovered, 0);
  if (statistics.newton_capped > 0) return;
  if (!(fabs(ledger.residual) <= physics_residual(quality) * *put_in)) {
    fail_msg("%s: residual %g J of %g J", what, ledger.residual, *put_in);
  }
}

static void try_end(TaborModel *model, const TaborParameter *parameter, double end, bool ramp,
                    uint32_t quality, double loudest, Worst *worst) {
  char what[160];
  snprintf(what, sizeof what, "%s, quality %u: %s%s %s to %g", tabor_model_definition(model)->name,
           quality, parameter->section, parameter->key, ramp ? "by a ramp" : "by a step", end);
  Play p = begin(model);
  const double from = present_value(tabor_model_definition(model), parameter);
  const TaborEvent stroke = physics_strike(tabor_model_definition(model));
  double put_in = 0.0;
  const bool scaled = only_scales(parameter);
  for (uint32_t i = 0; i < 20; i++) play(&p, &stroke, i == 0, scale_of(&p));
  for (uint32_t i = 1; i <= RAMP; i++) {
    const double value = ramp ? from + (end - from) * i / RAMP : end;
    const TaborEvent move = {
      .type = TABOR_EVENT_PARAMETER, .parameter = parameter->id, .value = value};
    play(&p, &move, ramp || i == 1, scaled ? 0.0 : scale_of(&p));
    check_ledger(&p, &put_in, quality, what);
  }
  const uint32_t most = (uint32_t)(LONGEST * RATE / BLOCK);
  uint32_t block = 0;
  for (; block < most && !tabor_drum_is_silent(p.drum); block++) {
    play(&p, &stroke, block == 0, scaled ? 0.0 : scale_of(&p));
  }
  check_ledger(&p, &put_in, quality, what);
  worst->asleep = fmax(worst->asleep, block * BLOCK / RATE);
  worst->peak = fmax(worst->peak, p.peak / loudest);
  if (!tabor_drum_is_silent(p.drum)) fail_msg("%s: awake after %g s", what, LONGEST);
  if (!(p.peak <= LOUDEST * loudest)) fail_msg("%s: %g Pa", what, p.peak);
  tabor_drum_destroy(p.drum);
}

/* Drums have no pedal, and not all have a resonant head. */
static bool is_of(const TaborDrumDef *def, const TaborParameter *parameter) {
  if (strcmp(parameter->section, "resonant") == 0) return def->two_headed;
  return strcmp(parameter->section, "hihat") != 0;
}

static void try_drum(const char *preset, uint32_t quality) {
  const TaborDrumDef def = small_snare(preset);
  TaborModel *model = physics_model(&def, RATE, quality);
  const double loudest = loudest_stroke(model);
  Worst worst = {0.0, 0.0};
  for (uint32_t i = 0; i < tabor_parameter_count(); i++) {
    const TaborParameter *parameter = tabor_parameter(i);
    if (!parameter->live || !is_of(&def, parameter)) continue;
    for (int end = 0; end < 2; end++) {
      for (int ramp = 0; ramp < 2; ramp++) {
        try_end(model, parameter, end ? parameter->maximum : parameter->minimum, ramp != 0, quality,
                loudest, &worst);
      }
    }
  }
  print_message(
    "%s, quality %u: asleep after %.2f s at most, peak at most %.2f of a loud stroke's\n", preset,
    quality, worst.asleep, worst.peak);
  tabor_model_release(model);
}

static void a_snare_drum_at_every_quality(void **state) {
  (void)state;
  for (uint32_t quality = TABOR_QUALITY_DRAFT; quality <= finest_quality; quality++) {
    try_drum("snare-14x5.5", quality);
  }
}

static void a_drum_with_a_gut_snare(void **state) {
  (void)state;
  try_drum("tabor", TABOR_QUALITY_LIVE);
  try_drum("tabor", TABOR_QUALITY_STUDIO);
}

int main(int count, char **words) {
  if (count > 1 && strcmp(words[1], "long") == 0) finest_quality = TABOR_QUALITY_REFERENCE;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_snare_drum_at_every_quality),
    cmocka_unit_test(a_drum_with_a_gut_snare),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
