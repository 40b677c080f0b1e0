/* SPDX-License-Identifier: MIT */
/* The sound that a drum books as radiated is the sound that its microphones hear.
 *
 * The power through a sphere around the drum is Int p^2/(rho0 c0) dS. Eight microphones stand on a
 * meridian of the sphere, at the nodes of Gauss's rule in the cosine of the polar angle. The rule
 * is exact for waves of degree 7 and less, which have nearly all of the power: k R = 3 hardly
 * exceeds them. The sphere is as large as microphones may be distant: k s is 8.5 for the lowest
 * mode of the bass drum, and at least 13 for those of other drums. There p^2/(rho0 c0) exceeds the
 * intensity by 1/(k s)^2 for a dipole and 3/(k s)^2 for a quadrupole: 1.4 % for that mode, less for
 * all others. */
#include "model/model.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;
static const double SPHERE = 9.4; /* its radius [m]; heights and radii of microphones end at 10 m */

enum { RING = 8 };
static const double HALF_NODES[RING / 2] = {0.1834346424956498, 0.5255324099163290,
                                            0.7966664774136267, 0.9602898564975363};
static const double HALF_WEIGHTS[RING / 2] = {0.3626837833783620, 0.3137066458778873,
                                              0.2223810344533745, 0.1012285362903763};

static double weight(int i) { return HALF_WEIGHTS[i < RING / 2 ? i : RING - 1 - i]; }
static double cosine(int i) { return i < RING / 2 ? HALF_NODES[i] : -HALF_NODES[RING - 1 - i]; }

/* Puts the microphones onto one meridian of a sphere around the drum's middle. */
static void surround(TaborDrumDef *def, double angle) {
  const bool deep = def->two_headed || def->shell.boundary == TABOR_BOUNDARY_CLOSED;
  def->mic_count = RING;
  for (int i = 0; i < RING; i++) {
    def->mic[i] = (TaborMicDef){.radius = SPHERE * sqrt(1.0 - cosine(i) * cosine(i)),
                                .angle = angle,
                                .height = SPHERE * cosine(i) - (deep ? 0.5 * def->shell.depth : 0),
                                .gain = 1.0};
    snprintf(def->mic[i].name, sizeof def->mic[i].name, "%d", i);
  }
}

/* ---- one mode -------------------------------------------------------------------------------- */

/* What is left is the excess of p^2/(rho0 c0), see above. */
static const double ONE_MODE = 0.03;
enum { MODES = 6 };

/* Decay rate of a mode of unit mass that would feed its own field: half the power through the
 * sphere per kinetic energy. p = -omega^2 rho0 R I cos(m theta) per unit amplitude. */
static double rate_of_field(const TaborModel *model, const TbBodyMode *mode) {
  const TaborAirDef *air = &model->def.air;
  const double around = mode->m ? PI : 2.0 * PI, radius = model->body.radius;
  double sum = 0.0;
  for (int i = 0; i < RING; i++) {
    const double *field = mode->fields + 2 * i;
    sum += weight(i) * (field[0] * field[0] + field[1] * field[1]);
  }
  return 0.5 * mode->omega * mode->omega * air->density / air->sound_speed * radius * radius *
         SPHERE * SPHERE * around * sum;
}

typedef struct Range {
  double lowest, highest;
} Range;

static void check_mode(const char *preset, const TaborModel *model, const TbBodyMode *mode,
                       Range *range) {
  const double ratio = mode->radiation_rate / rate_of_field(model, mode);
  if (!(fabs(ratio - 1.0) < ONE_MODE)) {
    fail_msg("%s (%u,%u), %.1f Hz: books %.3f of the power in its field", preset, mode->m, mode->n,
             mode->omega / (2.0 * PI), ratio);
  }
  range->lowest = fmin(range->lowest, ratio);
  range->highest = fmax(range->highest, ratio);
}

/* Of the shell on its stand, which sways at 20 Hz, microphones hear the near field. */
static const double LEAST_FAR = 8.0; /* least k s */

static bool is_rim(const TbBodyMode *mode, const TaborModel *model) {
  return mode->part == TABOR_PART_RIM && mode->has_far &&
         mode->omega * SPHERE / model->def.air.sound_speed > LEAST_FAR;
}

/* The lowest modes, and those that move mostly hoop and shell and have a far field (far_field.h).
 * Of these the sounds of wall, hoop and heads add up or cancel. */
static void a_mode_loses_what_its_field_carries(void **state) {
  (void)state;
  for (uint32_t p = 0; p < physics_drum_count(); p++) {
    const char *name = tabor_preset(p)->name;
    TaborDrumDef def = physics_preset(name);
    surround(&def, 0.0);
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    Range low = {INFINITY, 0.0}, rim = {INFINITY, 0.0};
    uint32_t lows = 0, rims = 0;
    for (uint32_t row = 0; row < model->body.row_count; row++) {
      const TbBodyMode *mode = &model->body.modes[row];
      if (is_rim(mode, model)) {
        check_mode(name, model, mode, &rim);
        rims++;
      } else if (mode->part != TABOR_PART_RIM && lows < MODES) {
        check_mode(name, model, mode, &low);
        lows++;
      }
    }
    print_message("%-28s lowest %u modes: %.4f to %.4f of the field's power", name, lows,
                  low.lowest, low.highest);
    if (rims > 0) print_message(", %u of the rim: %.4f to %.4f", rims, rim.lowest, rim.highest);
    print_message("\n");
    assert_int_equal(lows, MODES);
    tabor_model_release(model);
  }
}

/* ---- a stroke -------------------------------------------------------------------------------- */

/* Meridians: the squares of waves of order 2 and less are summed exactly. */
enum { MERIDIANS = 5, BLOCK = 64 };
/* Microphones make up for what finite steps take from the treble of contact forces
 * (force_equalizer.h), and the ledger does not: 7 % of the power of the drum with the brightest
 * wires at 48 kHz, 2 % here. */
static const double RATE = 96000.0, DURATION = 0.5;
/* Up to the two-way limit of `live`. What the high band radiates is heard, but stands outside the
 * ledger. */
static const double BANDWIDTH = 4000.0;
static const double STROKE = 0.03;

/* Adds the energy that passes one meridian's share of the sphere; returns what the drum books until
 * `DURATION`. */
static double heard_on(const TaborDrumDef *def, double *field) {
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(def);
  const uint32_t blocks = (uint32_t)(DURATION * RATE) / BLOCK;
  const uint32_t travel = (uint32_t)(SPHERE / def->air.sound_speed * RATE) / BLOCK;
  const double share =
    2.0 * PI / MERIDIANS * SPHERE * SPHERE / (def->air.density * def->air.sound_speed * RATE);
  float sound[RING][BLOCK], *outputs[RING];
  for (int i = 0; i < RING; i++) outputs[i] = sound[i];
  TaborLedger ledger = {0};
  for (uint32_t block = 0; block < blocks + travel; block++) {
    tabor_drum_process(drum, &strike, block == 0 ? 1 : 0, outputs, BLOCK);
    if (block + 1 == blocks) tabor_drum_ledger(drum, &ledger);
    for (int i = 0; i < RING; i++) {
      for (int n = 0; n < BLOCK; n++) {
        *field += weight(i) * share * pow(def->full_scale * sound[i][n], 2.0);
      }
    }
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return ledger.radiated;
}

static void a_stroke_books_what_is_heard(void **state) {
  (void)state;
  for (uint32_t p = 0; p < physics_drum_count(); p++) {
    const char *name = tabor_preset(p)->name;
    TaborDrumDef def = physics_preset(name);
    def.quality.two_way_bandwidth = def.quality.bandwidth = BANDWIDTH;
    double field = 0.0, booked = 0.0;
    for (int i = 0; i < MERIDIANS; i++) {
      surround(&def, 360.0 / MERIDIANS * i);
      booked = heard_on(&def, &field);
    }
    print_message("%-28s books %.4f of %.3g J through the sphere\n", name, booked / field, field);
    assert_true(fabs(booked / field - 1.0) < STROKE);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_mode_loses_what_its_field_carries),
    cmocka_unit_test(a_stroke_books_what_is_heard),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
