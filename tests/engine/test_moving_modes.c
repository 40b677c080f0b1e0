/* SPDX-License-Identifier: MIT */
/* Modes that rest: nobody hears it, the ledger has it, and they move again when something pushes
 * them. */
#include "physics.h"

#include "drum/drum.h"

enum { LENGTH = 72000, BLOCK = 96 };

static const double UNHEARD = 1e-6; /* -120 dBFS */

typedef struct Take {
  float sound[LENGTH];
  uint32_t moving[LENGTH / BLOCK]; /* at the end of each block */
  TaborLedger ledger;
} Take;

static uint32_t moving_of(const TaborDrum *drum) {
  uint32_t sum = 0;
  for (uint32_t part = 0; part < TB_MODE_PARTS; part++) sum += drum->state->moving[part];
  return sum;
}

/* What a microphone hears of strokes at these samples, of a drum whose modes rest, or never do. */
static void play(TaborModel *model, const TaborEvent *stroke, const uint32_t *at, uint32_t count,
                 bool rests, Take *take) {
  const uint32_t padded = model->modes.padded;
  double *const usual = model->resting.most;
  double *const never = calloc(padded / 8u, sizeof *never);
  for (uint32_t i = 0; i < padded / 8u; i++) never[i] = -1.0;
  if (!rests) model->resting.most = never;
  TaborDrum *drum = physics_drum(model);
  for (uint32_t frame = 0; frame < LENGTH; frame += BLOCK) {
    float *outputs[TABOR_MAX_MICS] = {take->sound + frame};
    bool struck = false;
    for (uint32_t i = 0; i < count; i++) struck = struck || at[i] == frame;
    tabor_drum_process(drum, stroke, struck, outputs, BLOCK);
    take->moving[frame / BLOCK] = moving_of(drum);
  }
  tabor_drum_ledger(drum, &take->ledger);
  tabor_drum_destroy(drum);
  model->resting.most = usual;
  free(never);
}

/* Two strokes, the second one on a drum of which most rests. */
static void check_rest(const char *preset, uint32_t quality) {
  static const uint32_t at[] = {0, 480 * BLOCK};
  static Take rested, moved;
  const TaborDrumDef def = physics_preset(preset);
  TaborModel *model = physics_model(&def, 48000.0, quality);
  const TaborEvent stroke = physics_strike(&def);
  play(model, &stroke, at, 2, true, &rested);
  play(model, &stroke, at, 2, false, &moved);
  double away = 0.0, peak = 0.0;
  for (uint32_t i = 0; i < LENGTH; i++) {
    away = fmax(away, fabs((double)rested.sound[i] - (double)moved.sound[i]));
    peak = fmax(peak, fabs((double)moved.sound[i]));
  }
  const uint32_t least = rested.moving[479], struck = rested.moving[481];
  print_message(
    "%s: %u modes of %u move before the second stroke, %u after it; sound %.1f dBFS away, "
    "residual %.2g J of %.2g J\n",
    preset, least, model->modes.padded, struck, 20.0 * log10(away), rested.ledger.residual,
    rested.ledger.injected);
  assert_true(3u * least < 2u * model->modes.padded && struck > least);
  assert_true(peak > 0.01 && away < UNHEARD);
  assert_true(fabs(rested.ledger.residual) <= physics_residual(quality) * rested.ledger.injected);
  tabor_model_release(model);
}

static void nobody_hears_that_modes_rest(void **state) {
  (void)state;
  check_rest("tom-12", TABOR_QUALITY_LIVE);
  check_rest("tom-12", TABOR_QUALITY_DRAFT);
}

/* A muffler on a head of which a part rests pushes, and yields by, the modes that move. */
static void a_muffled_head_keeps_its_account(void **state) {
  (void)state;
  check_rest("bass-drum-22", TABOR_QUALITY_LIVE);
}

/* What no stick on the batter head reaches never moves. */
static void the_other_head_alone_is_left_out(void **state) {
  (void)state;
  static Take take;
  static const uint32_t at[] = {0};
  const TaborDrumDef def = physics_preset("tom-12");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const TaborEvent stroke = physics_strike(&def);
  play(model, &stroke, at, 1, true, &take);
  const uint32_t alone = model->modes.run[3] - model->modes.run[2];
  print_message("%u modes move the resonant head alone; %u of %u move under a stick\n", alone,
                take.moving[0], model->modes.padded);
  assert_true(alone > 100 && take.moving[0] + alone / 2 < model->modes.padded);
  tabor_model_release(model);
}

/* Of each pair the drum's own stroke moves one copy, wherever that stroke is; one beside it moves
 * both. */
static void the_own_stroke_moves_one_copy(void **state) {
  (void)state;
  static Take take, beside;
  static const uint32_t at[] = {0};
  TaborDrumDef def = physics_preset("tom-12");
  for (int turn = 0; turn < 2; turn++) {
    def.strike.angle += 37.0 * turn;
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    TaborEvent stroke = physics_strike(&def);
    play(model, &stroke, at, 1, true, &take);
    stroke.angle += 10.0;
    play(model, &stroke, at, 1, true, &beside);
    print_message("%u modes move, beside it %u of %u\n", take.moving[0], beside.moving[0],
                  model->modes.padded);
    assert_true(take.moving[0] < 0.7 * beside.moving[0]);
    tabor_model_release(model);
  }
}

/* A drum that is turned with its microphones, mufflers and strokes sounds as before, by whichever
 * copies. */
static void a_turned_drum_sounds_the_same(void **state) {
  (void)state;
  static Take take, turned;
  static const uint32_t at[] = {0, 96 * BLOCK};
  TaborDrumDef def = physics_preset("bass-drum-22");
  def.batter.unevenness = def.resonant.unevenness = 0.0; /* which scatters each copy by itself */
  TaborDrumDef other = def;
  TaborEvent stroke = physics_strike(&def);
  stroke.angle += 30.0; /* not the own one */
  TaborEvent same = stroke;
  same.angle += 41.0;
  for (uint32_t i = 0; i < def.mic_count; i++)
    other.mic[i].angle -= other.mic[i].angle > 300.0 ? 319.0 : -41.0;
  other.batter.muffle_angle += 41.0;
  other.resonant.muffle_angle += 41.0;
  other.strike.angle += 13.0; /* another axis than the turned one */
  TaborModel *models[2] = {physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO),
                           physics_model(&other, 48000.0, TABOR_QUALITY_STUDIO)};
  play(models[0], &stroke, at, 1, true, &take);
  play(models[1], &same, at, 1, true, &turned);
  double away = 0.0, peak = 0.0;
  for (uint32_t i = 0; i < LENGTH; i++) {
    away = fmax(away, fabs((double)take.sound[i] - (double)turned.sound[i]));
    peak = fmax(peak, fabs((double)take.sound[i]));
  }
  print_message("%.1f dB below the peak\n", 20.0 * log10(away / peak));
  assert_true(peak > 0.01 && away < UNHEARD * peak);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* Sound from outside pushes all modes: those that rested move with the others. */
static void sound_wakes_all(void **state) {
  (void)state;
  static float air[BLOCK], sound[BLOCK];
  const TaborDrumDef def = physics_preset("tom-12");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = physics_strike(&def);
  tabor_drum_process(drum, &stroke, 1, NULL, 48000);
  const uint32_t before = moving_of(drum);
  float *outputs[TABOR_MAX_MICS] = {sound};
  const TaborSound outside = {.mic = 0, .pressure = air};
  air[10] = 1.0f;
  tabor_drum_process_sound(drum, NULL, 0, &outside, outputs, BLOCK / 2);
  assert_true(before < model->modes.padded);
  assert_int_equal(moving_of(drum), model->modes.padded);
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(fabs(ledger.residual) <= physics_residual(TABOR_QUALITY_LIVE) * ledger.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(nobody_hears_that_modes_rest),
                                     cmocka_unit_test(a_muffled_head_keeps_its_account),
                                     cmocka_unit_test(the_other_head_alone_is_left_out),
                                     cmocka_unit_test(the_own_stroke_moves_one_copy),
                                     cmocka_unit_test(a_turned_drum_sounds_the_same),
                                     cmocka_unit_test(sound_wakes_all)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
