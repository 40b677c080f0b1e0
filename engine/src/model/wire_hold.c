/* SPDX-License-Identifier: MIT */
#include "model/wire_hold.h"

#include <math.h>
#include <string.h>

#include "bodies/sheet_waves.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

static const double ROOT_3 = 1.7320508075688772;

enum { LOWEST_OCTAVE = -10, ANGLES = 48, SAMPLED_WIRES = 4 };

/* A wave on the head. */
typedef struct Wave {
  double omega, wavenumber, slope; /* slope: T_h + 2 D k^2 [N/m] */
  double group_speed;
} Wave;

static Wave wave_at(const TaborHeadDef *head, const TaborAirDef *air, double omega) {
  const double k = tb_sheet_wave_number(head, air, omega), step = 1e-4;
  double mass;
  const double above = tb_sheet_wave_frequency(head, air, k * (1.0 + step), &mass);
  const double below = tb_sheet_wave_frequency(head, air, k * (1.0 - step), &mass);
  return (Wave){.omega = omega,
                .wavenumber = k,
                .slope = head->tension + 2.0 * head->bending_stiffness * k * k,
                .group_speed = (above - below) / (2.0 * step * k)};
}

/* The contact's spring and damper, which follow from the force per length. */
typedef struct Contact {
  double stiffness, damping;
} Contact;

static Contact contact_at(const TbWire *wire, double force) {
  const double a = wire->contact_exponent;
  return (Contact){a * tb_power(wire->contact_stiffness, 1.0 / a) * tb_power(force, 1.0 - 1.0 / a),
                   wire->contact_loss * force};
}

/* Re Z/|1 + Y Z|^2 for a wave at this angle to the wire. With the admittance A = 1/Z it is
 * Re A/|A + Y|^2. */
static double taken(const TbWire *wire, Contact contact, Wave wave, double angle) {
  double sine, cosine;
  tb_sin_cos(angle, &sine, &cosine);
  const double kx = wave.wavenumber * cosine, ky = wave.wavenumber * sine, square = kx * kx;
  const double mu = wire->mass_per_length, omega = wave.omega;
  const double hold = (wire->tension + wire->bending_stiffness * square) * square;
  const double re_c = contact.damping, im_c = -contact.stiffness / omega;
  const double re_w = mu * (wire->damping_0 + wire->damping_1 * square);
  const double im_w = omega * mu - hold / omega;
  const double c = re_c * re_c + im_c * im_c, w = re_w * re_w + im_w * im_w;
  if (!(c > 0.0) || !(w > 0.0)) return 0.0;
  const double re = re_c / c + re_w / w, im = -im_c / c - im_w / w;
  const double with = re + omega / (2.0 * ky * wave.slope);
  return re / (with * with + im * im);
}

static double mean_taken(const TbWire *wire, Contact contact, Wave wave) {
  double sum = 0.0;
  for (int i = 0; i < ANGLES; i++) sum += taken(wire, contact, wave, 0.5 * PI * (i + 0.5) / ANGLES);
  return sum / ANGLES;
}

/* Sides of the rectangle, along the bed, around all contact points. */
static double perimeter(const TbWires *wires) {
  double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    const double place[2] = {wires->row_x[row], wires->row_y[row]};
    for (int i = 0; i < 2; i++) {
      least[i] = fmin(least[i], place[i]);
      most[i] = fmax(most[i], place[i]);
    }
  }
  return 2.0 * ((most[0] - least[0]) + (most[1] - least[1]));
}

static double step_of(const TbWireHold *hold) {
  return tb_log(hold->top / hold->bottom) / (TB_HOLD_BANDS - 1u);
}

/* S. At x = 1 it is (pi/4)^2. */
static double share_of(double x) {
  const double away = 1.0 - x * x;
  const double root = fabs(away) < 1e-6 ? 0.25 * PI : tb_cos(0.5 * PI * x) / away;
  return root * root;
}

/* C and S of one band, means over some of the wires. */
static void fill_band(TbWireHold *hold, const TbWires *wires, uint32_t band, Wave wave) {
  const uint32_t every = (wires->count + SAMPLED_WIRES - 1u) / SAMPLED_WIRES;
  const double part = 1.0 / ((wires->count - every / 2u + every - 1u) / every);
  double force = tb_exp(LOWEST_OCTAVE * tb_log(2.0));
  for (uint32_t octave = 0; octave < TB_HOLD_FORCES; octave++, force *= 2.0) {
    for (uint32_t w = every / 2u; w < wires->count; w += every) {
      const TbWire *wire = &wires->wires[w];
      const Contact contact = contact_at(wire, force);
      const double resonance = sqrt(contact.stiffness / wire->mass_per_length);
      hold->resistance[octave][band] += part * mean_taken(wire, contact, wave);
      hold->share[octave][band] += part * share_of(wave.omega / resonance);
    }
  }
}

/* Mean of sin over a quarter of a turn. */
static const double MEAN_ACROSS = 2.0 / 3.14159265358979323846;

void tb_wire_hold_prepare(TbWireHold *hold, const TaborHeadDef *head, const TaborAirDef *air,
                          const TbWires *wires, double radius, double bottom, double top) {
  *hold = (TbWireHold){.bottom = bottom, .top = top, .points = wires->contact_points};
  if (wires->count == 0) return;
  for (uint32_t w = 0; w < wires->count; w++) {
    hold->spacing += wires->wires[w].spacing / wires->count;
  }
  const double into = perimeter(wires) / (2.0 * PI * PI * radius * radius);
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) {
    const Wave wave = wave_at(head, air, bottom * tb_exp(band * step_of(hold)));
    fill_band(hold, wires, band, wave);
    hold->mobility[band] = wave.omega / (2.0 * MEAN_ACROSS * wave.wavenumber * wave.slope);
    hold->most[band] = into * wave.group_speed;
  }
}

uint32_t tb_wire_hold_band(const TbWireHold *hold, double omega) {
  const double place = tb_log(omega / hold->bottom) / step_of(hold) + 0.5;
  return (uint32_t)fmin(TB_HOLD_BANDS - 1u, fmax(0.0, place));
}

/* The octave of a positive number and where it lies between 2^octave, 0, and the next one, 1. */
static int octave_of(double x, double *part) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  const int octave = (int)(bits >> 52 & 0x7ffu) - 1023;
  bits = (bits & 0xfffffffffffffu) | (uint64_t)1023 << 52;
  memcpy(part, &bits, sizeof bits);
  *part -= 1.0;
  return octave;
}

/* C + D per length. */
static double taken_in(const TbWireHold *hold, uint32_t octave, double part, uint32_t band,
                       double knock, double bouncing) {
  const double *c = &hold->resistance[octave][band], *s = &hold->share[octave][band];
  const double touched = c[0] + part * (c[TB_HOLD_BANDS] - c[0]);
  const double hit = knock * (s[0] + part * (s[TB_HOLD_BANDS] - s[0]));
  const double with = 1.0 + hold->mobility[band] * hit;
  return touched + bouncing * hit / (with * with);
}

void tb_wire_hold_resistance(const TbWireHold *hold, TbWireTouch touch, double *resistance) {
  const double length = touch.touching * hold->spacing;
  double part = 0.0;
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) resistance[band] = 0.0;
  if (!(touch.force > 0.0) || !(length > 0.0)) return;
  const double force = touch.force / length; /* per length */
  int octave = octave_of(force, &part) - LOWEST_OCTAVE;
  if (octave < 0) octave = 0, part = 0.0;
  if (octave > (int)TB_HOLD_FORCES - 2) octave = (int)TB_HOLD_FORCES - 2, part = 1.0;
  const double away = 1.0 - touch.touching / hold->points, bouncing = away > 0.0 ? away : 0.0;
  const double knock = touch.speed > 0.0 ? force / (ROOT_3 * touch.speed) : 0.0;
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) {
    resistance[band] = length * taken_in(hold, (uint32_t)octave, part, band, knock, bouncing);
  }
}
