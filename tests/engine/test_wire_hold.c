/* SPDX-License-Identifier: MIT */
/* What wires in contact take from the high band's modes: in the limits of wire_hold.h. */
#include "physics.h"

#include "bodies/sheet_waves.h"
#include "model/wire_hold.h"

static const double PI = 3.14159265358979323846;
static const double RADIUS = 0.2, BOTTOM = 2.0 * 3.14159265358979323846 * 2500.0,
                    TOP = 2.0 * 3.14159265358979323846 * 16000.0;

enum { ROWS = 8 };

/* One wire with 0.01 m between its points. */
typedef struct Bed {
  TbWire wire;
  TbWires wires;
  double real[ROWS], x[ROWS], y[ROWS];
} Bed;

static void lay(Bed *bed) {
  bed->wire = (TbWire){.spacing = 0.01,
                       .mass_per_length = 0.0015,
                       .tension = 12.0,
                       .bending_stiffness = 3e-5,
                       .damping_0 = 10.0,
                       .damping_1 = 0.002,
                       .contact_stiffness = 2e9,
                       .contact_exponent = 1.5,
                       .contact_loss = 2.0};
  for (int i = 0; i < ROWS; i++) {
    bed->real[i] = 1.0;
    bed->x[i] = 0.01 * (i - 3.5);
    bed->y[i] = 0.0;
  }
  bed->wires = (TbWires){.count = 1,
                         .stride = ROWS,
                         .contact_points = ROWS,
                         .wires = &bed->wire,
                         .real = bed->real,
                         .row_x = bed->x,
                         .row_y = bed->y};
}

static const TaborHeadDef FILM = {
  .tension = 2600.0, .surface_density = 0.1, .bending_stiffness = 1.5e-4};
static const TaborAirDef AIR = {.density = 1.2, .sound_speed = 343.0};

static TbWireHold hold_of(const Bed *bed, const TaborHeadDef *head) {
  TbWireHold hold;
  tb_wire_hold_prepare(&hold, head, &AIR, &bed->wires, RADIUS, BOTTOM, TOP);
  return hold;
}

/* A contact so hard, a wire so heavy and a head so tense that only the damper gives. */
static void immovable_wires_take_what_their_contacts_lose(void **state) {
  (void)state;
  Bed bed;
  lay(&bed);
  bed.wire.mass_per_length = 1e4;
  bed.wire.contact_stiffness = 1.0;
  const TaborHeadDef tense = {.tension = 1e12, .surface_density = 0.1};
  const TbWireHold hold = hold_of(&bed, &tense);
  double resistance[TB_HOLD_BANDS];
  /* S is next to nothing: the contact is soft, so waves are fast against it */
  tb_wire_hold_resistance(&hold, (TbWireTouch){3.0, 4.0, 0.1}, resistance);
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) {
    assert_true(fabs(resistance[band] / (2.0 * 3.0) - 1.0) < 5e-3); /* lambda Sum f */
  }
}

static void wires_without_mass_or_force_take_nothing(void **state) {
  (void)state;
  Bed bed;
  lay(&bed);
  double resistance[TB_HOLD_BANDS];
  TbWireHold hold = hold_of(&bed, &FILM);
  tb_wire_hold_resistance(&hold, (TbWireTouch){0.0, 0.0, 0.0}, resistance);
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) assert_true(resistance[band] == 0.0);
  bed.wire.mass_per_length = 1e-12;
  bed.wire.tension = bed.wire.bending_stiffness = 0.0;
  hold = hold_of(&bed, &FILM);
  tb_wire_hold_resistance(&hold, (TbWireTouch){1.0, 8.0, 0.1}, resistance);
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) assert_true(resistance[band] < 1e-6);
}

/* Slow waves knock a wire that bounces: f/u on a head that does not yield, nothing where all points
 * always touch. */
static void bouncing_wires_resist(void **state) {
  (void)state;
  Bed bed;
  lay(&bed);
  bed.wire.contact_loss = bed.wire.damping_0 = bed.wire.damping_1 = 0.0;
  bed.wire.contact_stiffness = 1e18; /* all waves are slow against its contact */
  const TaborHeadDef tense = {.tension = 1e12, .surface_density = 0.1};
  const TbWireHold hold = hold_of(&bed, &tense);
  const double force = 2.0, speed = 0.1, half = 0.5 * ROWS;
  double resistance[TB_HOLD_BANDS];
  tb_wire_hold_resistance(&hold, (TbWireTouch){force, half, speed}, resistance);
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) {
    const double expected = 0.5 * force / (sqrt(3.0) * speed);
    assert_true(fabs(resistance[band] / expected - 1.0) < 0.02);
  }
  tb_wire_hold_resistance(&hold, (TbWireTouch){force, ROWS, speed}, resistance);
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++)
    assert_true(resistance[band] < 1e-6 * force);
}

/* c_g P/(2 pi A), on a membrane in a vacuum with c_g = sqrt(T/rho). */
static void waves_bring_no_more_than_flows_in(void **state) {
  (void)state;
  Bed bed;
  lay(&bed);
  const TaborAirDef vacuum = {.density = 0.0, .sound_speed = 343.0};
  const TaborHeadDef membrane = {.tension = 2600.0, .surface_density = 0.1};
  TbWireHold hold;
  tb_wire_hold_prepare(&hold, &membrane, &vacuum, &bed.wires, RADIUS, BOTTOM, TOP);
  const double perimeter = 2.0 * 0.07, area = PI * RADIUS * RADIUS;
  const double expected = sqrt(26000.0) * perimeter / (2.0 * PI * area);
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) {
    assert_true(fabs(hold.most[band] / expected - 1.0) < 1e-6);
  }
  assert_int_equal(tb_wire_hold_band(&hold, 0.1 * BOTTOM), 0);
  assert_int_equal(tb_wire_hold_band(&hold, TOP), TB_HOLD_BANDS - 1);
}

/* The waves whose frequency and wavenumber are each other's. */
static void waves_go_both_ways(void **state) {
  (void)state;
  for (double omega = BOTTOM; omega < TOP; omega *= 1.3) {
    double mass;
    const double k = tb_sheet_wave_number(&FILM, &AIR, omega);
    assert_true(fabs(tb_sheet_wave_frequency(&FILM, &AIR, k, &mass) / omega - 1.0) < 1e-9);
    assert_true(mass > 0.1 + 2.0 * 1.2 / k);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(immovable_wires_take_what_their_contacts_lose),
    cmocka_unit_test(wires_without_mass_or_force_take_nothing),
    cmocka_unit_test(bouncing_wires_resist),
    cmocka_unit_test(waves_bring_no_more_than_flows_in),
    cmocka_unit_test(waves_go_both_ways),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
