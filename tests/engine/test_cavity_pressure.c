/* SPDX-License-Identifier: MIT */
/* The pressure inside the shell, against closed forms and a plain sum over the cavity's modes. */
#include "physics.h"

#include "bodies/drum/cavity_pressure.h"
#include "math/bessel.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;
static const double DENSITY = 1.205, SPEED = 343.0;

/* A drum without losses whose microphones stand inside, all at this radius and angle 0. */
static TaborDrumDef drum_with_mics(double radius, double depth, double mic_radius, uint32_t count,
                                   const double *heights) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.shell.radius = radius;
  def.shell.depth = depth;
  def.quality.losses = 0;
  for (uint32_t i = 0; i < count; i++) {
    def.mic[i] = def.mic[0];
    snprintf(def.mic[i].name, sizeof def.mic[i].name, "m%u", i);
    def.mic[i].radius = mic_radius;
    def.mic[i].height = heights[i];
  }
  def.mic_count = count;
  return def;
}

static void add_second_head(TaborDrumDef *def) {
  def->two_headed = 1;
  def->resonant = def->batter;
}

/* Volume per area that head `which` displaces upward in a mode of order 0. */
static double mean_motion(const TaborModel *model, const TbBodyMode *mode, uint32_t which) {
  const TbBodyOrder *order = &model->body.orders[0];
  const double *v = order->vectors[which] + (size_t)mode->place * order->zero_count;
  double sum = 0.0;
  for (uint32_t i = 0; i < order->zero_count; i++) {
    sum += v[i] * 2.0 * tb_bessel_j(1, order->zeros[i]) / order->zeros[i];
  }
  return sum;
}

/* A tube of twenty radii below the head: plane waves, p = -rho0 c0 omega w cos(k z)/sin(k L). Other
 * waves fall by e^-3.8 in every radius. */
static void a_long_tube_has_plane_waves(void **state) {
  (void)state;
  static const double HEIGHTS[] = {-0.25, -0.5, -0.77, -0.999};
  TaborDrumDef def = drum_with_mics(0.05, 1.0, 0.02, 4, HEIGHTS);
  def.shell.boundary = TABOR_BOUNDARY_CLOSED;
  def.quality.two_way_bandwidth = 3000.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  uint32_t checked = 0;
  double worst = 0.0;
  for (uint32_t row = 0; row < model->body.row_count; row++) {
    const TbBodyMode *mode = &model->body.modes[row];
    if (mode->m != 0) continue;
    const double k = mode->omega / def.air.sound_speed;
    const double scale = mean_motion(model, mode, 0) / (k * def.shell.radius);
    for (uint32_t p = 0; p < 4; p++) {
      const double z = def.shell.depth + HEIGHTS[p];
      const double error = mode->fields[2 * p] * sin(k * def.shell.depth) - scale * cos(k * z);
      worst = fmax(worst, fabs(error / scale));
      assert_true(fabs(mode->fields[2 * p + 1]) < 1e-3 * fabs(scale));
    }
    checked++;
  }
  print_message("%u modes to %g Hz: within %.2g\n", checked, model->body.bandwidth, worst);
  assert_true(checked >= 10);
  /* Modes' shapes are right to first order in what their own frequencies change of the air outside.
   */
  assert_true(worst < 0.03);
  tabor_model_release(model);
}

/* Waves much longer than the drum: the same pressure everywhere, p = -rho0 c0^2 dV/V. */
static void slow_motion_presses_as_a_spring(void **state) {
  (void)state;
  static const double HEIGHTS[] = {-0.02, -0.05, -0.09};
  TaborDrumDef def = drum_with_mics(0.1, 0.12, 0.05, 3, HEIGHTS);
  add_second_head(&def);
  def.resonant.tension *= 0.5;
  def.air.sound_speed = 2000.0;
  def.air.density = 0.02;
  def.quality.two_way_bandwidth = 2500.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  uint32_t checked = 0;
  for (uint32_t row = 0; row < model->body.row_count && checked < 2; row++) {
    const TbBodyMode *mode = &model->body.modes[row];
    if (mode->m != 0) continue;
    const double k = mode->omega / def.air.sound_speed;
    const double swept = mean_motion(model, mode, 0) - mean_motion(model, mode, 1);
    const double wanted = swept / (def.shell.depth * def.shell.radius * k * k);
    for (uint32_t p = 0; p < 3; p++) {
      print_message("%.0f Hz, mic %u: %.4f of the spring\n", mode->omega / 2.0 / PI, p,
                    mode->fields[2 * p] / wanted);
      assert_true(fabs(mode->fields[2 * p] / wanted - 1.0) < 0.02);
    }
    checked++;
  }
  assert_int_equal(checked, 2);
  tabor_model_release(model);
}

/* Between equal heads every mode is even or odd; in the middle an odd one has no pressure. */
static void equal_heads_press_evenly_or_oddly(void **state) {
  (void)state;
  static const double HEIGHTS[] = {-0.03, -0.07, -0.11};
  TaborDrumDef def = drum_with_mics(0.15, 0.14, 0.06, 3, HEIGHTS);
  add_second_head(&def);
  def.quality.two_way_bandwidth = 3000.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  uint32_t even = 0, odd = 0;
  for (uint32_t row = 0; row < model->body.row_count; row++) {
    const TbBodyMode *mode = &model->body.modes[row];
    const double *f = mode->fields;
    const double size = fabs(f[0]) + fabs(f[2]) + fabs(f[4]), tiny = 1e-4 * size;
    if (size < 1e-9) continue; /* a high order, which does not come here */
    const bool is_odd = fabs(f[0] + f[4]) < tiny && fabs(f[2]) < tiny;
    if (!is_odd && fabs(f[0] - f[4]) > tiny) {
      fail_msg("(%u,%u): %g %g %g", mode->m, mode->n, f[0], f[2], f[4]);
    }
    if (is_odd) {
      odd++;
    } else {
      even++;
    }
  }
  print_message("%u even, %u odd\n", even, odd);
  assert_true(even > 20 && odd > 20);
  tabor_model_release(model);
}

/* On the axis all orders but m = 0 are silent. */
static void the_axis_hears_round_modes_alone(void **state) {
  (void)state;
  static const double HEIGHTS[] = {-0.05};
  TaborDrumDef def = drum_with_mics(0.15, 0.14, 0.0, 1, HEIGHTS);
  add_second_head(&def);
  def.resonant.tension = 2000.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  for (uint32_t row = 0; row < model->body.row_count; row++) {
    const TbBodyMode *mode = &model->body.modes[row];
    assert_true((mode->fields[0] != 0.0) == (mode->m == 0));
  }
  tabor_model_release(model);
}

/* ---- one order by itself -------------------------------------------------------------------- */

enum { FUNCTIONS = 12 };

typedef struct Order {
  TbArena arena;
  TbCavity cavity;
  TbAirOrder air;
  TbCavityOrder order;
  TbCavityMics mics;
  double zeros[FUNCTIONS];
} Order;

/* The air between two heads, its coordinates up to `top` [Hz]; microphones as in `def`. */
static void prepare(Order *o, const TaborDrumDef *def, uint32_t m, double radial_top, double top) {
  TaborAllocator allocator = tb_allocator_resolve(&(TaborAllocator){0});
  tb_arena_prepare(&o->arena, &allocator);
  o->cavity = (TbCavity){.radius = def->shell.radius,
                         .depth = def->shell.depth,
                         .density = DENSITY,
                         .sound_speed = SPEED,
                         .heads = 2};
  double zeros[64];
  assert_true(tb_bessel_zeros(m, PI * (FUNCTIONS + 0.5 * m + 1.0), zeros, 64) >= FUNCTIONS);
  memcpy(o->zeros, zeros, sizeof o->zeros);
  assert_true(tb_air_order_prepare(&o->air, &o->arena, m, o->zeros, FUNCTIONS));
  assert_true(
    tb_cavity_order_prepare(&o->order, &o->arena, &o->cavity, m, radial_top, 2.0 * PI * top));
  assert_true(tb_cavity_mics_prepare(&o->mics, &o->arena, def, &o->order));
}

/* u_c of a cavity that heads with these amplitudes drive: (omega_c^2 - omega^2) u = omega_c
 * (rho0 c0^2/N_c)^(1/2) S.w. */
static void drive(const Order *o, const double *heads, double omega, double *u) {
  const double area = tb_cavity_azimuth(o->order.m) * o->cavity.radius * o->cavity.radius;
  for (uint32_t c = 0; c < o->order.mode_count; c++) {
    const TbCavityMode *mode = &o->order.modes[c];
    double s[TB_CAVITY_OPENINGS], sum = 0.0;
    tb_cavity_openings(&o->order, &o->air, mode->radial, s);
    for (uint32_t i = 0; i < FUNCTIONS; i++) {
      sum += s[i] * ((mode->axial % 2 ? -1.0 : 1.0) * heads[i] + heads[FUNCTIONS + i]);
    }
    const double norm = tb_cavity_mode_norm(&o->order, &o->cavity, mode->radial, mode->axial);
    u[c] = mode->omega * sqrt(DENSITY * SPEED * SPEED / norm) * area * sum /
           (mode->omega * mode->omega - omega * omega);
  }
}

/* The same pressure as a plain sum over modes, p = omega^2 rho0 c0^2/N_c S.w/(omega_c^2 - omega^2),
 * with S by quadrature of the heads' shape. */
static double plain_sum(const Order *o, const double *heads, double omega, double r, double z) {
  enum { AXIAL = 4000, STEPS = 2000 };
  const double radius = o->cavity.radius, depth = o->cavity.depth;
  double pressure = 0.0;
  for (uint32_t p = 0; p < o->order.radial_count; p++) {
    const double zero = o->order.zeros[p];
    double up = 0.0, down = 0.0, square = 0.0;
    for (uint32_t i = 0; i < STEPS; i++) {
      const double x = (i + 0.5) / STEPS, shape = tb_bessel_j(o->order.m, zero * x);
      double w[2] = {0.0, 0.0};
      for (uint32_t n = 0; n < FUNCTIONS; n++) {
        const double j = tb_bessel_j(o->order.m, o->zeros[n] * x);
        w[0] += heads[n] * j;
        w[1] += heads[FUNCTIONS + n] * j;
      }
      up += w[0] * shape * x / STEPS;
      down += w[1] * shape * x / STEPS;
      square += shape * shape * x / STEPS;
    }
    for (uint32_t l = 0; l < AXIAL; l++) {
      const double kappa = zero / radius, axial = l * PI / depth, k = omega / SPEED;
      const double push = (l % 2 ? -up : up) + down;
      pressure += omega * omega * DENSITY * push / (square * depth * (l ? 0.5 : 1.0)) *
                  tb_bessel_j(o->order.m, zero * r / radius) * cos(axial * z) /
                  (kappa * kappa + axial * axial - k * k);
    }
  }
  return pressure;
}

/* Small: the coupling, which limits how far a mode without a coordinate rises, plays no part. */
static const double HEADS[2 * FUNCTIONS] = {
  0.001,  0.0003,  -0.0005, 0.0002, 0.0, 0.0001, 0.0,    0.0, 5e-05, 0.0, 0.0, 2e-05,
  0.0004, -0.0002, 0.0001,  0.0003, 0.0, 0.0,    0.0001, 0.0, 0.0,   0.0, 0.0, 1e-05};

/* However many coordinates there are, the rest makes up for those that are missing. */
static void few_coordinates_and_the_rest_are_all_modes(void **state) {
  (void)state;
  static const double TOPS[] = {0.0, 1500.0, 4000.0, 12000.0}, HEIGHTS[] = {-0.012, -0.05, -0.1};
  const TaborDrumDef base = drum_with_mics(0.15, 0.14, 0.07, 3, HEIGHTS);
  TaborDrumDef def = base;
  add_second_head(&def);
  const double omega = 2.0 * PI * 1313.0;
  for (uint32_t m = 0; m < 3; m++) {
    double wanted[3];
    for (uint32_t t = 0; t < 4; t++) {
      Order o;
      prepare(&o, &def, m, 120.0, TOPS[t]);
      double u[256], fields[2 * TABOR_MAX_MICS], worst = 0.0;
      drive(&o, HEADS, omega, u);
      tb_cavity_fields(&o.mics, &o.order, &o.cavity, &o.air, HEADS, u, omega, 0.0, fields);
      for (uint32_t p = 0; p < 3; p++) {
        if (t == 0) {
          wanted[p] = plain_sum(&o, HEADS, omega, def.mic[p].radius, def.shell.depth + HEIGHTS[p]);
        }
        const double pressure = -omega * omega * DENSITY * def.shell.radius * fields[2 * p];
        worst = fmax(worst, fabs(pressure / wanted[p] - 1.0));
      }
      print_message("m = %u, %u coordinates: within %.2g\n", m, o.order.mode_count, worst);
      assert_true(worst < 1e-3);
      tb_arena_release(&o.arena);
    }
  }
}

/* A coordinate alone has the nodes of its rigid cavity's mode. */
static void a_coordinate_has_the_nodes_of_its_mode(void **state) {
  (void)state;
  static const double HEIGHTS[] = {-0.07};
  const double node = 2.404825557695773 / 3.831705970207512; /* J_0(3.83 r/R) = 0 */
  TaborDrumDef def = drum_with_mics(0.15, 0.14, 0.15 * node, 1, HEIGHTS);
  add_second_head(&def);
  Order o;
  prepare(&o, &def, 0, 60.0, 6000.0);
  const double still[2 * FUNCTIONS] = {0.0};
  uint32_t silent = 0;
  for (uint32_t c = 0; c < o.order.mode_count; c++) {
    double u[256] = {0.0}, fields[2 * TABOR_MAX_MICS];
    u[c] = 1.0;
    tb_cavity_fields(&o.mics, &o.order, &o.cavity, &o.air, still, u, 5000.0, 0.0, fields);
    const TbCavityMode *mode = &o.order.modes[c];
    const bool on_node = mode->radial == 1 || mode->axial % 2 == 1;
    assert_true(on_node == (fabs(fields[0]) < 1e-12));
    silent += on_node;
  }
  assert_true(silent > 4 && silent < o.order.mode_count);
  tb_arena_release(&o.arena);
}

/* A diffuse field decays as Sabine says: 1/8 of c0 S alpha/V, alpha = 8 beta of the side. */
static void a_diffuse_field_decays_as_sabine_says(void **state) {
  (void)state;
  const double omega = 2.0 * PI * 4000.0;
  const TbCavity hard = {
    .radius = 0.2, .depth = 0.3, .density = DENSITY, .sound_speed = SPEED, .heads = 2};
  TbCavity soft = hard, thin = hard;
  soft.admittance = 0.01;
  thin.head_density[0] = 1e-9; /* an open window: alpha = 1 */
  const double volume = PI * 0.2 * 0.2 * 0.3, layers = tb_cavity_decay_rate(&hard, omega);
  const double side = 2.0 * PI * 0.2 * 0.3, end = PI * 0.2 * 0.2;
  assert_true(fabs((tb_cavity_decay_rate(&soft, omega) - layers) * 8.0 * volume / SPEED / side -
                   0.08) < 1e-9);
  assert_true(
    fabs((tb_cavity_decay_rate(&thin, omega) - layers) * 8.0 * volume / SPEED / end - 1.0) < 1e-9);
  assert_true(layers > 0.0 && layers < 50.0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_long_tube_has_plane_waves),
    cmocka_unit_test(slow_motion_presses_as_a_spring),
    cmocka_unit_test(equal_heads_press_evenly_or_oddly),
    cmocka_unit_test(the_axis_hears_round_modes_alone),
    cmocka_unit_test(few_coordinates_and_the_rest_are_all_modes),
    cmocka_unit_test(a_coordinate_has_the_nodes_of_its_mode),
    cmocka_unit_test(a_diffuse_field_decays_as_sabine_says),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
