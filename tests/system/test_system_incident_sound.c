/* SPDX-License-Identifier: MIT */
/* Sound from outside: a source at a microphone's place pushes the heads as that microphone hears
 * them. */
#include "drum/drum.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;
enum { RATE = 48000, BLOCK = 64 };

static bool brief; /* under sanitizers: a drum of few modes, and nothing that is physics alone */

static TaborDrum *drum_of(const TaborDrumDef *def, uint32_t quality) {
  TaborModel *model = physics_model(def, RATE, quality);
  TaborDrum *drum = physics_drum(model);
  tabor_model_release(model);
  return drum;
}

/* Plays `frames` frames of what `pressure` gives [Pa], from `from` on, into sound[] of the first
 * microphone. */
static void play(TaborDrum *drum, uint32_t mic, double (*pressure)(uint32_t), uint32_t from,
                 uint32_t frames, float *sound) {
  for (uint32_t at = 0; at < frames; at += BLOCK) {
    float in[BLOCK];
    float *outputs[TABOR_MAX_MICS] = {sound ? sound + at : NULL};
    for (uint32_t i = 0; i < BLOCK; i++) in[i] = (float)pressure(from + at + i);
    const TaborSound outside = {.mic = mic, .pressure = in};
    tabor_drum_process_sound(drum, NULL, 0, &outside, outputs, BLOCK);
  }
}

/* ---- the static limit ------------------------------------------------------------------------ */

static double one_pascal(uint32_t frame) {
  const double rise = 0.2 * RATE; /* slowly: the modes must not ring */
  return frame < rise ? 0.5 - 0.5 * cos(PI * frame / rise) : 1.0;
}

/* A membrane in a baffle under a far source: the baffle doubles the pressure, and a uniform
 * pressure p pushes the centre by p a^2/(4 T). What is missing are the modes above the bandwidth,
 * and the far source's own curvature. */
static const double STATIC_TOLERANCE = 0.01;

static void slow_sound_pushes_a_membrane_like_a_uniform_pressure(void **state) {
  (void)state;
  TaborDrumDef def = physics_membrane();
  def.shell.boundary = TABOR_BOUNDARY_BAFFLED;
  def.air.density = 1.2;
  def.air.gravity = 0.0;
  def.batter.damping_0 = 40.0;
  def.mic[0].radius = 0.0;
  def.mic[0].height = 10.0;
  TaborDrum *drum = drum_of(&def, TABOR_QUALITY_STUDIO);
  play(drum, 0, one_pascal, 0, RATE, NULL);
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  const double radius = def.shell.radius;
  const double expected = -2.0 * radius * radius / (4.0 * def.batter.tension);
  print_message("centre %.4g m, uniform pressure %.4g m\n", probe.head, expected);
  assert_true(fabs(probe.head / expected - 1.0) < STATIC_TOLERANCE);
  tabor_drum_destroy(drum);
}

/* ---- resonance and energy -------------------------------------------------------------------- */

static double frequency, level; /* of the tone */

static double tone(uint32_t frame) { return level * sin(2.0 * PI * frequency * frame / RATE); }

/* Root mean square of the pressure at the microphone in the last tenth of half a second. */
static double answer(const TaborDrumDef *def, TaborModel *model, double hertz) {
  static float sound[RATE / 2];
  TaborDrum *drum = physics_drum(model);
  frequency = hertz;
  level = 0.1;
  play(drum, (uint32_t)tabor_drum_def_find_mic(def, "far"), tone, 0, RATE / 2, sound);
  double sum = 0.0;
  for (uint32_t i = RATE * 4 / 10; i < RATE / 2; i++) sum += (double)sound[i] * (double)sound[i];
  tabor_drum_destroy(drum);
  return sqrt(sum);
}

/* The lowest mode in which both heads move together is a peak of the answer to tones. */
static void a_tone_finds_the_mode(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("tom-12");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborModeInfo mode = {0};
  for (uint32_t row = 0; mode.part == TABOR_PART_RIM || row == 0; row++) {
    assert_true(tabor_model_mode(model, row, &mode));
  }
  const double at = answer(&def, model, mode.frequency);
  print_message("%.1f Hz: %.3g, 10 %% below and above: %.3g, %.3g\n", mode.frequency, at,
                answer(&def, model, 0.9 * mode.frequency),
                answer(&def, model, 1.1 * mode.frequency));
  assert_true(at > 3.0 * answer(&def, model, 0.9 * mode.frequency));
  assert_true(at > 3.0 * answer(&def, model, 1.1 * mode.frequency));
  tabor_model_release(model);
}

static double sweep(uint32_t frame) {
  const double t = (double)frame / RATE;
  return level * sin(2.0 * PI * (40.0 * t + 0.5 * 2000.0 * t * t));
}

static void the_ledger_closes(void **state) {
  (void)state;
  static const uint32_t QUALITIES[] = {TABOR_QUALITY_LIVE, TABOR_QUALITY_STUDIO};
  for (size_t i = 0; i < 2; i++) {
    TaborDrumDef def = physics_preset("snare-14x5.5");
    if (brief || QUALITIES[i] == TABOR_QUALITY_STUDIO) def = physics_small(&def);
    TaborDrum *drum = drum_of(&def, QUALITIES[i]);
    level = 20.0; /* loud enough for the wires to leave their head */
    play(drum, 0, sweep, 0, RATE / 4 / BLOCK * BLOCK, NULL);
    TaborLedger ledger;
    TaborStatistics statistics;
    tabor_drum_ledger(drum, &ledger);
    tabor_drum_statistics(drum, &statistics);
    print_message("injected %.4g J, stored %.4g J, lost in contacts %.4g J, residual %.2g J\n",
                  ledger.injected, ledger.stored, ledger.contact_loss, ledger.residual);
    assert_true(statistics.newton_capped == 0);
    assert_true(ledger.injected > 0.0 && ledger.contact_loss > 0.0);
    assert_true(fabs(ledger.residual) < physics_residual(QUALITIES[i]) * ledger.injected);
    tabor_drum_destroy(drum);
  }
}

/* The ledger's promise in noise of half a second at one level [Pa]; tabor.h has its two parts. */
static void play_noise(TaborModel *model, double pascals, uint64_t *random) {
  static const double FLOOR = 2e-12; /* [W] */
  static const uint32_t LENGTH = RATE / 2 / BLOCK * BLOCK;
  TaborDrum *drum = physics_drum(model);
  TaborModelInfo info;
  TaborLedger ledger;
  TaborStatistics statistics;
  for (uint32_t at = 0; at < LENGTH; at += BLOCK) {
    float in[BLOCK];
    for (int i = 0; i < BLOCK; i++) in[i] = (float)(pascals * physics_uniform(random, -1.0, 1.0));
    const TaborSound outside = {.mic = 0, .pressure = in};
    tabor_drum_process_sound(drum, NULL, 0, &outside, NULL, BLOCK);
  }
  tabor_drum_ledger(drum, &ledger);
  tabor_drum_statistics(drum, &statistics);
  tabor_model_info(model, &info);
  const double time = (double)LENGTH / RATE, put_in = ledger.injected + fabs(ledger.control);
  const double bound = physics_residual(info.quality) * put_in + FLOOR * time;
  print_message("%g Pa: injected %.3g J, residual %.2g J, bound %.2g J\n", pascals, ledger.injected,
                ledger.residual, bound);
  assert_true(ledger.injected > 0.0 && isfinite(ledger.stored));
  assert_true(ledger.residual >= -bound);
  if (statistics.newton_capped == 0) assert_true(ledger.residual <= bound);
  tabor_drum_destroy(drum);
}

static void no_level_of_noise_creates_energy(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"marching-14x12", "tom-12"};
  static const double LEVELS[] = {1e-4, 1e-2, 0.1, 1.0, 1e2, 1e5, 1e9, 3e38};
  uint64_t random = physics_seed();
  for (size_t i = 0; i < 2; i++) {
    TaborDrumDef def = physics_preset(PRESETS[i]);
    if (brief) def = physics_small(&def);
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
    for (size_t k = 0; k < sizeof LEVELS / sizeof *LEVELS; k++)
      play_noise(model, LEVELS[k], &random);
    tabor_model_release(model);
  }
}

/* Sound beyond the air's own pressure sounds like sound of that pressure; what is no number is
 * silence. */
static void sound_is_limited_to_the_pressure_of_the_air(void **state) {
  (void)state;
  static const float LOUD[3][4] = {
    {1e5f, -1e5f, 0.0f, 1e5f}, {3e38f, -2e7f, NAN, INFINITY}, {2e5f, -INFINITY, -NAN, 1e5f}};
  const TaborDrumDef preset = physics_preset("tom-12"), def = physics_small(&preset);
  float heard[3][BLOCK];
  for (int i = 0; i < 3; i++) {
    float in[BLOCK] = {0.0f}, *outputs[TABOR_MAX_MICS] = {heard[i]};
    TaborDrum *drum = drum_of(&def, TABOR_QUALITY_LIVE);
    memcpy(in, LOUD[i], sizeof LOUD[i]);
    const TaborSound outside = {.mic = 0, .pressure = in};
    tabor_drum_process_sound(drum, NULL, 0, &outside, outputs, BLOCK);
    assert_memory_equal(heard[i], heard[0], sizeof heard[0]);
    tabor_drum_destroy(drum);
  }
  assert_true(heard[0][BLOCK - 1] != 0.0f);
}

/* ---- silence --------------------------------------------------------------------------------- */

static double nothing(uint32_t frame) {
  (void)frame;
  return 0.0;
}

static double faint(uint32_t frame) {
  (void)frame;
  return 1.9e-5; /* [Pa], below what counts */
}

static void silence_in_is_silence_out(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  TaborDrum *drum = drum_of(&def, TABOR_QUALITY_LIVE);
  play(drum, 0, nothing, 0, 10 * BLOCK, NULL);
  play(drum, 0, faint, 0, 10 * BLOCK, NULL);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_true(tabor_drum_is_silent(drum));
  assert_true(statistics.slept_frames == 20 * BLOCK);
  tabor_drum_destroy(drum);
}

/* Blocks and a saved state change no bit. */
static void blocks_and_states_change_no_bit(void **state) {
  (void)state;
  enum { LENGTH = 8 * BLOCK };
  const TaborDrumDef def = physics_preset("tom-12");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  float in[LENGTH], whole[LENGTH], parts[LENGTH];
  level = 5.0;
  for (uint32_t i = 0; i < LENGTH; i++) in[i] = (float)sweep(i + 400);
  TaborDrum *first = physics_drum(model), *second = physics_drum(model);
  const TaborSound all = {.mic = 0, .pressure = in};
  float *outputs[TABOR_MAX_MICS] = {whole};
  tabor_drum_process_sound(first, NULL, 0, &all, outputs, LENGTH);
  for (uint32_t at = 0, size = 1; at < LENGTH; at += size) {
    size = LENGTH - at < 37 ? LENGTH - at : 37;
    const TaborSound part = {.mic = 0, .pressure = in + at};
    float *out[TABOR_MAX_MICS] = {parts + at};
    void *bytes = malloc(tabor_drum_state_size(second));
    tabor_drum_state_save(second, bytes);
    tabor_drum_destroy(second);
    second = physics_drum(model);
    assert_int_equal(tabor_drum_state_load(second, bytes, tabor_drum_state_size(second)), TABOR_OK);
    free(bytes);
    tabor_drum_process_sound(second, NULL, 0, &part, out, size);
  }
  assert_memory_equal(whole, parts, sizeof whole);
  assert_true(whole[LENGTH - 1] != 0.0f);
  tabor_drum_destroy(first);
  tabor_drum_destroy(second);
  tabor_model_release(model);
}

/* A drum that was replaced lies at rest, with the former one's counters until it is reset. */
static void a_reset_at_rest_forgets_the_work_of_sound(void **state) {
  (void)state;
  const TaborDrumDef tom = physics_preset("tom-12"), def = physics_small(&tom);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  TaborSwap *swap;
  frequency = 200.0;
  level = 1.0;
  play(drum, 0, tone, 0, 40 * BLOCK, NULL);
  assert_int_equal(tabor_swap_create(model, model, &swap, NULL), TABOR_OK);
  const TaborEvent replace = {.type = TABOR_EVENT_REPLACE, .swap = swap};
  tabor_drum_process(drum, &replace, 1, NULL, 0);
  assert_true(drum->at_rest && drum->state->ledger.sound_work != 0.0);
  tabor_drum_reset(drum);
  assert_true(drum->state->ledger.sound_work == 0.0);
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  tabor_model_release(model);
}

int main(int argc, char **argv) {
  const struct CMUnitTest physics[] = {
    cmocka_unit_test(slow_sound_pushes_a_membrane_like_a_uniform_pressure),
    cmocka_unit_test(a_tone_finds_the_mode),
  };
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_ledger_closes),
    cmocka_unit_test(no_level_of_noise_creates_energy),
    cmocka_unit_test(sound_is_limited_to_the_pressure_of_the_air),
    cmocka_unit_test(silence_in_is_silence_out),
    cmocka_unit_test(a_reset_at_rest_forgets_the_work_of_sound),
    cmocka_unit_test(blocks_and_states_change_no_bit),
  };
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const int failed = brief ? 0 : cmocka_run_group_tests(physics, NULL, NULL);
  return failed + cmocka_run_group_tests(tests, NULL, NULL);
}
