/* SPDX-License-Identifier: MIT */
#include "model/hoop.h"

#include <math.h>

#include "acoustics/cavity_pressure.h"
#include "acoustics/closed_drum_modes.h"
#include "definition/definition.h"
#include "math/bessel.h"
#include "math/portable_math.h"
#include "math/quadrature.h"
#include "model/mics.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;

/* Modes above this part of the rate are left out, as the heads' are. */
static const double TOP_OF_RATE = 0.2;

/* ---- sound ---------------------------------------------------------------------------------- */

/* Most points around half the wall: at 10 kHz and half a metre from the axis still five a wavelength. */
enum { AROUND = 256, PANELS = 3, LEVELS = PANELS * TB_PANEL };

/* Points around half the wall. Of the sources' n waves and the k r of the path's length the sum is exact with
 * as many points; what the distance adds falls by e^-eta from one to the next,
 * cosh eta = (r^2 + R^2)/(2 r R) at the level of the microphone. */
static uint32_t points_around(uint32_t n, double wavenumber, double radius, double r) {
  const double nearer = fmin(r, radius), ratio = fmax(r, radius) / fmax(nearer, 1e-6 * radius);
  const double waves = n + wavenumber * nearer, eta = tb_log(ratio);
  return (uint32_t)fmin(AROUND, 16.0 + 0.75 * waves + 8.0 / fmax(eta, 1e-3));
}

/* Panels of levels: 16 nodes see a quarter of their panel's length, and 20 radians, to 1e-7. */
static uint32_t panels_along(double wavenumber, double radius, double depth, double r) {
  const double near = 0.25 * depth / fmax(fabs(r - radius), 1e-3 * depth);
  return (uint32_t)fmin(PANELS, 1.0 + fmax(near, wavenumber * depth / 20.0));
}

void tb_hoop_field(uint32_t n, double wavenumber, double radius, double depth, double r, double z,
                   double field[2]) {
  double levels[LEVELS], weights[LEVELS];
  const uint32_t around = points_around(n, wavenumber, radius, r);
  const uint32_t panels = panels_along(wavenumber, radius, depth, r);
  tb_quadrature(-depth, 0.0, panels, levels, weights);
  field[0] = field[1] = 0.0;
  for (uint32_t i = 0; i < around; i++) {
    const double angle = PI * (i + 0.5) / around;
    const double across = r * r + radius * radius - 2.0 * r * radius * tb_cos(angle);
    const double part = tb_cos(n * angle) * 2.0 * PI / around / (4.0 * PI);
    for (uint32_t l = 0; l < panels * TB_PANEL; l++) {
      const double up = z - levels[l], distance = sqrt(across + up * up);
      const double size = part * weights[l] / distance;
      double sine, cosine;
      tb_sin_cos(wavenumber * distance, &sine, &cosine);
      field[0] += size * cosine;
      field[1] -= size * sine;
    }
  }
}

double tb_hoop_radiation(uint32_t n, double omega, const TaborAirDef *air, double radius,
                         double depth) {
  enum { NODES = 8 * TB_PANEL };
  double angles[NODES], weights[NODES], sum = 0.0;
  const double k = omega / air->sound_speed;
  tb_quadrature(0.0, PI, NODES / TB_PANEL, angles, weights);
  for (uint32_t i = 0; i < NODES; i++) {
    double sine, cosine;
    tb_sin_cos(angles[i], &sine, &cosine);
    const double half = 0.5 * k * depth * cosine;
    const double sinc = fabs(half) > 1e-8 ? tb_sin(half) / half : 1.0;
    const double part = tb_bessel_j(n, k * radius * sine) * sinc;
    sum += weights[i] * part * part * sine;
  }
  return omega * omega * air->density * radius * radius * depth * depth * PI * sum /
         (8.0 * air->sound_speed);
}

/* ---- set-up --------------------------------------------------------------------------------- */

/* Of the wall that is heard. */
static double depth_of(const TaborDrumDef *def) {
  const bool enclosed = def->two_headed || def->shell.boundary == TABOR_BOUNDARY_CLOSED;
  return enclosed ? def->shell.depth : def->hoop.height;
}

static void field_at(const TaborDrumDef *def, uint32_t n, double omega, const TaborMicDef *mic,
                     double field[2]) {
  if (tb_mic_is_inside(def, mic)) {
    const TbCavity cavity = tb_closed_drum_cavity(def, n, omega);
    tb_cavity_wall_field(&cavity, n, omega, mic->radius, field);
    return;
  }
  tb_hoop_field(n, omega / def->air.sound_speed, def->shell.radius, depth_of(def), mic->radius,
                mic->height, field);
}

static void listen(TaborModel *model, uint32_t n, double omega, const TbPole *pole, uint32_t at) {
  const TaborDrumDef *def = &model->def;
  for (uint32_t mic = 0; mic < def->mic_count; mic++) {
    double field[2];
    field_at(def, n, omega, &def->mic[mic], field);
    for (uint32_t copy = 0; copy < 2; copy++) {
      tb_mic_weights(model, mic, omega, pole, n, copy == 1, field,
                     &model->hoop.ahead[mic][at + copy], &model->hoop.behind[mic][at + copy]);
      model->hoop.ahead[mic][at + copy] *= model->hoop.scale[at];
      model->hoop.behind[mic][at + copy] *= model->hoop.scale[at];
    }
  }
}

static void prepare_mode(TaborModel *model, uint32_t index, double omega) {
  const TaborDrumDef *def = &model->def;
  TbHoop *hoop = &model->hoop;
  const uint32_t n = index + 2, at = hoop->count;
  const double mass = 0.5 * def->hoop.mass * (1.0 + 1.0 / (double)(n * n));
  const double air =
    tb_hoop_radiation(n, omega, &def->air, def->shell.radius, depth_of(def)) / mass;
  const double own = def->hoop.decay[index];
  const double decay = def->quality.losses ? own + air : 0.0;
  const TbPole pole = tb_pole(omega, decay, model->time_step);
  for (uint32_t i = at; i < at + 2; i++) {
    hoop->order[i] = n;
    hoop->a[i] = pole.a;
    hoop->b[i] = pole.b;
    hoop->g[i] = pole.g;
    hoop->stiffness[i] = pole.stiffness;
    hoop->loss_air[i] = decay > 0.0 ? pole.loss * (air / decay) : 0.0;
    hoop->loss_shell[i] = pole.loss - hoop->loss_air[i];
    hoop->scale[i] = 1.0 / sqrt(mass);
  }
  hoop->count += 2;
  listen(model, n, omega, &pole, at);
}

void tb_hoop_prepare(TaborModel *model) {
  model->hoop = (TbHoop){0};
  for (uint32_t i = 0; i < TABOR_HOOP_MODES; i++) {
    const double frequency = model->def.hoop.frequency[i];
    if (frequency == 0.0 || frequency > TOP_OF_RATE * model->sample_rate) continue;
    prepare_mode(model, i, 2.0 * PI * frequency);
  }
}

/* ---- on the audio thread -------------------------------------------------------------------- */

void tb_hoop_shape(const TbHoop *hoop, double sin_angle, double cos_angle, double *shape) {
  for (uint32_t i = 0; i < TB_HOOP_MODES; i++) {
    shape[i] = i < hoop->count
                 ? hoop->scale[i] * tb_angular(hoop->order[i], i % 2 == 1, sin_angle, cos_angle)
                 : 0.0;
  }
}

double tb_hoop_compliance(const TbHoop *hoop, const double *shape, const double *other) {
  double sum = 0.0;
  for (uint32_t i = 0; i < hoop->count; i++) sum += shape[i] * (hoop->g[i] * other[i]);
  return sum;
}

double tb_hoop_displacement(const double *shape, const double *q) {
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_HOOP_MODES; i++) sum += shape[i] * q[i];
  return sum;
}

void tb_hoop_step(const TbHoop *hoop, double *next, const double *now, const double *last) {
  for (uint32_t i = 0; i < hoop->count; i++) next[i] = hoop->a[i] * now[i] - hoop->b[i] * last[i];
}

void tb_hoop_press(const TbHoop *hoop, const double *shape, double force, double *next) {
  for (uint32_t i = 0; i < hoop->count; i++) next[i] -= force * (hoop->g[i] * shape[i]);
}

double tb_hoop_energy(const TbHoop *hoop, double rate, const double *next, const double *now) {
  double sum = 0.0;
  for (uint32_t i = 0; i < hoop->count; i++) {
    const double velocity = (next[i] - now[i]) * rate;
    sum += velocity * velocity + hoop->stiffness[i] * next[i] * now[i];
  }
  return 0.5 * sum;
}

TbHoopLosses tb_hoop_losses(const TbHoop *hoop, const double *next, const double *last) {
  TbHoopLosses losses = {0.0, 0.0};
  for (uint32_t i = 0; i < hoop->count; i++) {
    const double moved = next[i] - last[i];
    losses.shell += hoop->loss_shell[i] * moved * moved;
    losses.radiated += hoop->loss_air[i] * moved * moved;
  }
  return losses;
}

double tb_hoop_pressure(const TbHoop *hoop, uint32_t mic, const double *next, const double *now,
                        const double *last) {
  const double *ahead = hoop->ahead[mic], *behind = hoop->behind[mic];
  double sum = 0.0;
  for (uint32_t i = 0; i < hoop->count; i++) {
    sum += ahead[i] * (next[i] - now[i]) - behind[i] * (now[i] - last[i]);
  }
  return sum;
}

/* Place of the same copy of the same order, or TB_HOOP_MODES. */
static uint32_t find(const TbHoop *hoop, uint32_t order, uint32_t copy) {
  for (uint32_t i = copy; i < hoop->count; i += 2) {
    if (hoop->order[i] == order) return i;
  }
  return TB_HOOP_MODES;
}

/* cos and sin of w_d k, from a = 2 e^{-sk} cos(w_d k), b = e^{-2sk}; false where it does not swing. */
static bool turn_of(const TbHoop *hoop, uint32_t i, double *c, double *s) {
  *c = 0.5 * hoop->a[i] / sqrt(hoop->b[i]);
  const double square = 1.0 - *c * *c;
  *s = square > 0.0 ? sqrt(square) : 0.0;
  return square > 0.0;
}

static void carry_mode(const TbHoop *from, uint32_t i, const TbHoop *to, uint32_t j, double *now,
                       double *last) {
  double c0, s0, c1, s1;
  if (from->a[i] == to->a[j] && from->b[i] == to->b[j]) return;
  if (!turn_of(from, i, &c0, &s0) || !turn_of(to, j, &c1, &s1)) return;
  const double scale = sqrt(s0 / s1), im = (*last - *now * c0) / s0;
  *last = scale * (*now * c1 + im * s1);
  *now *= scale;
}

void tb_hoop_carry(const TbHoop *from, const TbHoop *to, double *now, double *last) {
  double old_now[TB_HOOP_MODES], old_last[TB_HOOP_MODES];
  for (uint32_t i = 0; i < TB_HOOP_MODES; i++) {
    old_now[i] = now[i];
    old_last[i] = last[i];
    now[i] = last[i] = 0.0;
  }
  for (uint32_t j = 0; j < to->count; j++) {
    const uint32_t i = find(from, to->order[j], j % 2);
    if (i == TB_HOOP_MODES) continue;
    now[j] = old_now[i];
    last[j] = old_last[i];
    carry_mode(from, i, to, j, &now[j], &last[j]);
  }
}
