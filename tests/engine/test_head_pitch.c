/* SPDX-License-Identifier: MIT */
/* Heads tuned by what a tuner reads at a lug: the pitch of a head at a tension, the tension for a
 * pitch, and both as keys of a definition. */
#include "physics.h"

#include "bodies/drum/closed_drum_modes.h"
#include "bodies/drum/head_pitch.h"
#include "definition/note.h"
#include "math/bessel.h"

static const double PI = 3.14159265358979323846;
static const double FIRST_ZERO = 3.83170597020751232; /* of J_1 */

static double cents(double a, double b) { return 1200.0 * log2(a / b); }

static double pitch_of(const TaborDrumDef *def, TaborHead head) {
  double pitch = NAN;
  TaborError error = {0};
  if (tabor_drum_def_pitch(def, head, &pitch, &error) != TABOR_OK) fail_msg("%s", error.message);
  return pitch;
}

static void set(TaborDrumDef *def, const char *key, const char *value) {
  TaborError error = {0};
  if (tabor_drum_def_set(def, key, value, &error) != TABOR_OK) fail_msg("%s", error.message);
}

static TaborDrumDef tuned(TaborDrumDef def) {
  TaborError error = {0};
  if (tabor_drum_def_tune(&def, &error) != TABOR_OK) fail_msg("%s", error.message);
  return def;
}

/* ---- the pitch ------------------------------------------------------------------------------- */

static void a_thin_head_in_vacuo_has_the_pitch_of_a_membrane(void **state) {
  (void)state;
  const double rounding = 1e-9;
  TaborDrumDef def = physics_membrane();
  def.resonant = def.batter;
  def.resonant.surface_density = 0.1;
  for (int kind = 0; kind < 4; kind++) { /* each boundary, then two heads */
    def.two_headed = kind == 3;
    def.shell.boundary = kind == 3 ? TABOR_BOUNDARY_OPEN : (uint32_t)kind;
    for (uint32_t head = 0; head < 1 + def.two_headed; head++) {
      const TaborHeadDef *own = head ? &def.resonant : &def.batter;
      const double expected =
        FIRST_ZERO / (2.0 * PI * def.shell.radius) * sqrt(own->tension / own->surface_density);
      assert_true(fabs(pitch_of(&def, (TaborHead)head) / expected - 1.0) < rounding);
    }
  }
}

/* The lowest frequency of order 1 in a drum with two heads of which the other one is this heavy. */
static double beside_heavy_head(TaborDrumDef def, TaborHead which, double density) {
  const TaborHeadDef own = which == TABOR_HEAD_RESONANT ? def.resonant : def.batter;
  def.resonant = own;
  def.batter = own;
  def.resonant.surface_density = density;
  def.mic_count = 0;
  TbArena arena;
  const TaborAllocator allocator = tb_allocator_resolve(&(TaborAllocator){.context = NULL});
  tb_arena_prepare(&arena, &allocator);
  double zeros[32];
  const uint32_t count = tb_bessel_zeros(1, 50.0, zeros, 32);
  TbAirOrder air;
  TbShellMesh shell;
  TbBodyOrder order = {.m = 1};
  TbBodyMode modes[128];
  const TbRim rim = {.count = 0};
  const TbModeLimits limit = {2.0 * PI * 5000.0, 2.0 * PI * 5000.0};
  assert_true(tb_air_order_prepare(&air, &arena, 1, zeros, count));
  assert_true(tb_closed_drum_shell(&def, &arena, &shell));
  assert_int_equal(
    tb_closed_drum_order(&def, &arena, &arena, &air, &rim, &shell, limit, &order, modes, 128),
    TABOR_OK);
  tb_arena_release(&arena);
  for (uint32_t k = 0; k < order.mode_count; k++) {
    if (modes[k].part != TABOR_PART_RESONANT) return modes[k].omega / (2.0 * PI);
  }
  return NAN;
}

/* The heavy head's own modes lie below 1 Hz. */
static void a_head_beside_one_of_enormous_mass_has_its_pitch(void **state) {
  (void)state;
  static const char *const presets[] = {"snare-14x5.5", "marching-14x12", "tom-12", "bass-drum-22"};
  const double heavy = 1e7;  /* [kg/m2] */
  const double within = 0.1; /* cents: what the sizes of both computations leave */
  for (size_t i = 0; i < sizeof presets / sizeof *presets; i++) {
    const TaborDrumDef def = physics_preset(presets[i]);
    for (int head = 0; head < 2; head++) {
      const double pitch = pitch_of(&def, (TaborHead)head);
      const double coupled = beside_heavy_head(def, (TaborHead)head, heavy);
      print_message("%s, head %d: %.3f Hz, %+.3f cents\n", presets[i], head, pitch,
                    cents(coupled, pitch));
      assert_true(fabs(cents(coupled, pitch)) < within);
    }
  }
}

static void pitch_follows_the_air_and_not_the_other_head(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("tom-12");
  const double pitch = pitch_of(&def, TABOR_HEAD_BATTER);
  def.resonant.tension *= 2.0;
  def.resonant.surface_density *= 2.0;
  assert_true(pitch_of(&def, TABOR_HEAD_BATTER) == pitch);
  def.air.density = 0.6;
  assert_true(cents(pitch_of(&def, TABOR_HEAD_BATTER), pitch) > 50.0);
}

/* ---- from pitch to tension and back
 * ---------------------------------------------------------------- */

/* The (1,1) of the model of the drum in which the other head is rigid. */
static double heard(const TaborDrumDef *def, TaborHead which) {
  TaborDrumDef held = *def;
  if (which == TABOR_HEAD_RESONANT) held.batter = def->resonant;
  if (def->two_headed) held.shell.boundary = TABOR_BOUNDARY_CLOSED;
  held.two_headed = held.wires.count = held.wires.head = 0;
  held.shell.mass = held.hoop.bending_stiffness = 0.0; /* a rim at rest */
  held.mic_count = 1;
  held.mic[0].height = 0.3;
  TaborModel *model = physics_model(&held, 48000.0, TABOR_QUALITY_LIVE);
  TaborModeInfo mode = {.m = 0};
  for (uint32_t row = 0; mode.m != 1 && tabor_model_mode(model, row, &mode); row++) continue;
  assert_int_equal(mode.n, 1);
  tabor_model_release(model);
  return mode.frequency;
}

static void a_tuned_drum_has_the_pitch_as_a_mode(void **state) {
  (void)state;
  static const struct {
    const char *preset, *batter, *resonant; /* pitches as drummers choose them */
  } drums[] = {{"snare-14x5.5", "A3", "G4-30"}, {"marching-14x12", "A4", "440"},
               {"tom-12", "Eb3", "F#3"},        {"floor-tom-16", "98", "B2"},
               {"bass-drum-22", "E2", "e2+20"}, {"timpani-26", "C3", NULL},
               {"frame-drum", "D3", NULL}};
  const double within = 0.3; /* cents: models at live have more Bessel functions or fewer */
  for (size_t i = 0; i < sizeof drums / sizeof *drums; i++) {
    TaborDrumDef def = physics_preset(drums[i].preset);
    set(&def, "batter.pitch", drums[i].batter);
    if (drums[i].resonant) set(&def, "resonant.pitch", drums[i].resonant);
    const double wanted[] = {def.batter.pitch, def.resonant.pitch};
    def = tuned(def);
    assert_true(def.batter.pitch == 0.0 && def.resonant.pitch == 0.0);
    for (uint32_t head = 0; head < 1 + def.two_headed; head++) {
      const double pitch = heard(&def, (TaborHead)head);
      print_message("%s, head %u: %.3f Hz wanted, %+.3f cents\n", drums[i].preset, head,
                    wanted[head], cents(pitch, wanted[head]));
      assert_true(fabs(cents(pitch, wanted[head])) < within);
      assert_true(fabs(cents(pitch_of(&def, (TaborHead)head), wanted[head])) < within);
    }
  }
}

static void tensions_are_found_over_their_whole_range(void **state) {
  (void)state;
  const double within = 0.05; /* cents: a tension is rounded to 0.01 N/m */
  TaborDrumDef def = physics_preset("snare-14x5.5");
  for (double tension = 100.0; tension <= 20000.0; tension *= 1.9) {
    def.batter.tension = tension;
    def.batter.pitch = 0.0;
    const double pitch = pitch_of(&def, TABOR_HEAD_BATTER);
    def.batter.pitch = pitch < 49.0 ? pitch * (1.0 + 1e-6) : pitch; /* not below what is allowed */
    assert_true(pitch_of(&def, TABOR_HEAD_BATTER) == def.batter.pitch); /* as it is set */
    const TaborDrumDef found = tuned(def);
    assert_true(fabs(found.batter.tension / tension - 1.0) < 1e-4);
    assert_true(fabs(cents(pitch_of(&found, TABOR_HEAD_BATTER), pitch)) < within);
  }
}

static void a_model_has_the_tension_that_tuning_gives(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("frame-drum");
  set(&def, "batter.pitch", "D3");
  const TaborDrumDef expected = tuned(def);
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  assert_memory_equal(tabor_model_definition(model), &expected, sizeof expected);
  tabor_model_release(model);
}

/* ---- as keys of a definition
 * ----------------------------------------------------------------------- */

static void what_is_set_later_counts(void **state) {
  (void)state;
  static const char *const heads[] = {"batter", "resonant"};
  for (int head = 0; head < 2; head++) {
    TaborDrumDef def = physics_preset("tom-12");
    const TaborHeadDef *own = head ? &def.resonant : &def.batter;
    char tension[32], pitch[32];
    (void)snprintf(tension, sizeof tension, "%s.tension", heads[head]);
    (void)snprintf(pitch, sizeof pitch, "%s.pitch", heads[head]);
    set(&def, pitch, "E3");
    set(&def, tension, "1234");
    assert_true(own->pitch == 0.0 && own->tension == 1234.0);
    set(&def, pitch, "E3");
    set(&def, head ? "batter.tension" : "resonant.tension", "1000"); /* another head */
    def = tuned(def);
    assert_true(fabs(cents(pitch_of(&def, (TaborHead)head), 164.8137784564)) < 0.05);
    set(&def, tension, "1234");
    set(&def, pitch, "E3");
    set(&def, pitch, "0");
    def = tuned(def);
    assert_true(own->tension == 1234.0);
  }
}

static void pitches_wait_for_the_whole_definition(void **state) {
  (void)state;
  TaborDrumDef before = physics_preset("tom-12"), after = before;
  static const char *const others[][2] = {{"shell.radius", "0.127"},
                                          {"shell.depth", "0.2"},
                                          {"air.density", "1"},
                                          {"batter.surface_density", "0.3"}};
  set(&before, "batter.pitch", "200");
  for (size_t i = 0; i < 4; i++) {
    set(&before, others[i][0], others[i][1]);
    set(&after, others[i][0], others[i][1]);
  }
  set(&after, "batter.pitch", "200");
  before = tuned(before);
  after = tuned(after);
  assert_memory_equal(&before, &after, sizeof before);
}

/* A definition that is written as text with a pitch in it reads back as it was. */
static void a_pitch_survives_writing_key_by_key(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("tom-12"), read;
  set(&def, "batter.pitch", "Eb3");
  set(&def, "resonant.pitch", "F3");
  char key[2 * TABOR_NAME_SIZE], value[TABOR_TEXT_SIZE];
  tabor_drum_def_clear(&read);
  for (uint32_t i = 0; tabor_drum_def_key(&def, i, key, sizeof key); i++) {
    assert_int_equal(tabor_drum_def_get(&def, key, value, sizeof value, NULL), TABOR_OK);
    set(&read, key, value);
  }
  assert_memory_equal(&read, &def, sizeof def);
}

/* ---- notes
 * ----------------------------------------------------------------------------------------- */

/* The frequencies are those of the equally tempered scale as tables print them. */
static void notes_are_those_of_the_tempered_scale(void **state) {
  (void)state;
  static const struct {
    const char *text;
    double frequency;
  } notes[] = {{"A4", 440.0},        {"A3", 220.0},      {"a3", 220.0},     {"C4", 261.6256},
               {"c4", 261.6256},     {"F#3", 184.9972},  {"Gb3", 184.9972}, {"Eb2", 77.78175},
               {"D#2", 77.78175},    {"B3", 246.9417},   {"b3", 246.9417},  {"bb3", 233.0819},
               {"Cb4", 246.9417},    {"B#3", 261.6256},  {"C0", 16.35160},  {"B9", 15804.27},
               {"A4+100", 466.1638}, {"Bb4-100", 440.0}, {"A4-0", 440.0},   {"A4+50", 452.8930},
               {"A4-12.5", 436.8345}};
  for (size_t i = 0; i < sizeof notes / sizeof *notes; i++) {
    double frequency = 0.0;
    assert_true(tb_note_parse(notes[i].text, &frequency));
    if (fabs(frequency / notes[i].frequency - 1.0) > 5e-7) {
      fail_msg("%s is %.6f Hz, not %.6f", notes[i].text, frequency, notes[i].frequency);
    }
  }
}

static void other_texts_are_no_notes(void **state) {
  (void)state;
  static const char *const texts[] = {"",      "A",      "A#",  "H3",     "3A",          "A10",
                                      "A-1",   "A3+",    "A3-", "A3+-1",  "A3 ",         " A3",
                                      "A##3",  "Abb3",   "A3#", "A3+101", "#3",          "A3+5c",
                                      "A3 +5", "A3+nan", "A+5", "A3+1e3", "\xE2\x99\xAD"};
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    double frequency = 7.0;
    if (tb_note_parse(texts[i], &frequency)) fail_msg("'%s' was taken for a note", texts[i]);
    assert_true(frequency == 7.0);
    TaborDrumDef def = physics_preset("tom-12");
    const TaborDrumDef before = def;
    TaborError error;
    assert_int_equal(tabor_drum_def_set(&def, "batter.pitch", texts[i], &error), TABOR_ERROR_VALUE);
    assert_non_null(strstr(error.message, "nor a note such as Eb2+30"));
    assert_int_equal(tabor_drum_def_set(&def, "batter.tension", texts[i], &error),
                     TABOR_ERROR_VALUE);
    assert_null(strstr(error.message, "note"));
    assert_memory_equal(&def, &before, sizeof def);
  }
}

/* ---- errors
 * ---------------------------------------------------------------------------------------- */

static void pitches_out_of_reach_are_refused(void **state) {
  (void)state;
  static const struct {
    const char *key, *value;
  } wrong[] = {{"batter.pitch", "C6"}, {"batter.pitch", "12"}, {"resonant.pitch", "2000"}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    TaborDrumDef def = physics_preset("snare-14x5.5");
    TaborError error;
    set(&def, wrong[i].key, wrong[i].value);
    const TaborDrumDef before = def;
    assert_int_equal(tabor_drum_def_tune(&def, &error), TABOR_ERROR_RANGE);
    assert_memory_equal(&def, &before, sizeof def);
    assert_string_equal(error.key, wrong[i].key);
    assert_non_null(strstr(error.message, wrong[i].key));
    assert_non_null(strstr(error.message, "the pitches of this head at 100 to 20000 N/m"));
    TaborModel *model;
    assert_int_equal(tabor_model_create(&def, NULL, &model, &error), TABOR_ERROR_RANGE);
    assert_null(model);
    for (int end = 0; end < 2; end++) { /* what the message names can be had */
      char text[32];
      (void)snprintf(text, sizeof text, "%.1f", end ? error.maximum : error.minimum);
      set(&def, wrong[i].key, text);
      assert_int_equal(tabor_drum_def_tune(&def, NULL), TABOR_OK);
    }
  }
}

static void values_that_are_no_pitches_are_refused(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("snare-14x5.5");
  TaborError error;
  assert_int_equal(tabor_drum_def_set(&def, "batter.pitch", "0.9", &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.message, "batter.pitch = 0.9 is neither 0 nor in 1 to 20000 Hz");
  assert_int_equal(tabor_drum_def_set(&def, "batter.pitch", "-220", &error), TABOR_ERROR_RANGE);
  assert_int_equal(tabor_drum_def_set(&def, "batter.pitch", "20001", &error), TABOR_ERROR_RANGE);
  def.batter.pitch = NAN;
  assert_int_equal(tabor_drum_def_tune(&def, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, "batter.pitch");
}

static void a_head_that_is_not_there_has_no_pitch(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("frame-drum");
  TaborError error;
  double pitch;
  assert_int_equal(tabor_drum_def_pitch(&def, TABOR_HEAD_RESONANT, &pitch, &error),
                   TABOR_ERROR_NAME);
  assert_int_equal(tabor_drum_def_pitch(&def, 2, &pitch, &error), TABOR_ERROR_NAME);
  assert_int_equal(tabor_drum_def_pitch(&def, 0, NULL, &error), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_pitch(NULL, 0, &pitch, &error), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_tune(NULL, &error), TABOR_ERROR_ARGUMENT);
  def.resonant.pitch = 1.0; /* without effect: there is one head */
  assert_int_equal(tabor_drum_def_tune(&def, &error), TABOR_OK);
  assert_int_equal(error.status, TABOR_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_thin_head_in_vacuo_has_the_pitch_of_a_membrane),
    cmocka_unit_test(a_head_beside_one_of_enormous_mass_has_its_pitch),
    cmocka_unit_test(pitch_follows_the_air_and_not_the_other_head),
    cmocka_unit_test(a_tuned_drum_has_the_pitch_as_a_mode),
    cmocka_unit_test(tensions_are_found_over_their_whole_range),
    cmocka_unit_test(a_model_has_the_tension_that_tuning_gives),
    cmocka_unit_test(what_is_set_later_counts),
    cmocka_unit_test(pitches_wait_for_the_whole_definition),
    cmocka_unit_test(a_pitch_survives_writing_key_by_key),
    cmocka_unit_test(notes_are_those_of_the_tempered_scale),
    cmocka_unit_test(other_texts_are_no_notes),
    cmocka_unit_test(pitches_out_of_reach_are_refused),
    cmocka_unit_test(values_that_are_no_pitches_are_refused),
    cmocka_unit_test(a_head_that_is_not_there_has_no_pitch),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
