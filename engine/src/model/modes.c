/* SPDX-License-Identifier: MIT */
#include "model/modes.h"

#include <math.h>

#include "math/portable_math.h"
#include "model/rim_waves.h"

TbPole tb_pole(double omega, double s, double k) {
  const double square = omega * omega - s * s;
  const double damped = sqrt(fabs(square)) * k;
  const double turn = square >= 0.0 ? tb_cos(damped) : tb_cosh(damped);
  const double shrink = tb_exp(-s * k), slow = tb_tanh(s * k);
  return (TbPole){.a = 2.0 * shrink * turn,
                  .b = shrink * shrink,
                  .g = k * k / (1.0 + slow),
                  .stiffness = 2.0 / (k * k) * (1.0 - turn / tb_cosh(s * k)),
                  .loss = slow / (2.0 * k * k),
                  .re = shrink * turn,
                  .im = square >= 0.0 ? shrink * tb_sin(damped) : 0.0};
}

/* cos and sin of w_d k, from a = 2 e^{-sk} cos(w_d k), b = e^{-2sk}. Returns false
 * if it does not swing. */
static bool turn_of(double a, double b, double *c, double *s) {
  *c = 0.5 * a / sqrt(b);
  const double square = 1.0 - *c * *c;
  *s = square > 0.0 ? sqrt(square) : 0.0;
  return square > 0.0;
}

void tb_pole_carry(double a0, double b0, double a1, double b1, double ratio, double *now,
                   double *last) {
  double c0, s0, c1, s1;
  if (a0 == a1 && b0 == b1) return;
  if (b0 == 0.0 || b1 == 0.0) {
    *now = *last = 0.0;
    return;
  }
  if (!turn_of(a0, b0, &c0, &s0) || !turn_of(a1, b1, &c1, &s1)) {
    *last = tb_step_ago(*now, *last, ratio);
    return;
  }
  const double scale = sqrt(ratio * s0 / s1), im = (*last - *now * c0) / s0;
  *last = scale * (*now * c1 + im * s1);
  *now *= scale;
}

/* cos(m t) and sin(m t) for all orders at once, by Chebyshev's recurrence. */
void tb_angular_factors(uint32_t orders, double sin_angle, double cos_angle, double *c, double *s) {
  c[0] = 1.0;
  s[0] = 0.0;
  if (orders > 1) {
    c[1] = cos_angle;
    s[1] = sin_angle;
  }
  for (uint32_t m = 2; m < orders; m++) {
    c[m] = 2.0 * cos_angle * c[m - 1] - c[m - 2];
    s[m] = 2.0 * cos_angle * s[m - 1] - s[m - 2];
  }
}

double tb_angular(uint32_t m, bool sine, double sin_angle, double cos_angle) {
  double c[TB_MAX_ORDERS], s[TB_MAX_ORDERS];
  tb_angular_factors(m + 1, sin_angle, cos_angle, c, s);
  return sine ? s[m] : c[m];
}

void tb_modes_shape(const TbModes *modes, const TbBody *body, uint32_t which, double radius,
                    double sin_angle, double cos_angle, const double *patch, double *radial,
                    double *shape) {
  tb_body_radial(body, which, radius, patch, radial);
  tb_modes_turn(modes, body, radial, sin_angle, cos_angle, shape);
}

void tb_modes_turn(const TbModes *modes, const TbBody *body, const double *radial, double sin_angle,
                   double cos_angle, double *shape) {
  double c[TB_MAX_ORDERS], s[TB_MAX_ORDERS];
  tb_angular_factors(body->order_count, sin_angle, cos_angle, c, s);
  for (uint32_t i = 0; i < modes->padded; i++) {
    const uint32_t row = modes->row[i];
    if (row == TB_NO_MODE) {
      shape[i] = 0.0;
      continue;
    }
    const uint32_t m = body->modes[row].m;
    shape[i] = radial[row] * (modes->sine[i] ? s[m] : c[m]);
  }
}

/* How far each mode closes the gap between the edges of two plates. */
static void closing(const TbBody *body, double *radial) {
  for (uint32_t m = 0; m < body->order_count; m++) {
    const TbBodyOrder *order = &body->orders[m];
    for (uint32_t k = 0; k < order->mode_count; k++) {
      radial[order->rows[k]] = order->edge[1][k] - order->edge[0][k];
    }
  }
}

void tb_modes_shape_at(const TbModes *modes, const TbBody *body, const TbWires *wires, uint32_t row,
                       double *radial, double *shape) {
  const double x = wires->row_x[row], y = wires->row_y[row], r = sqrt(x * x + y * y);
  const double sine = r > 0.0 ? y / r : 0.0, cosine = r > 0.0 ? x / r : 1.0;
  if (!wires->rims) {
    tb_modes_shape(modes, body, wires->head, r, sine, cosine, NULL, radial, shape);
    return;
  }
  closing(body, radial);
  tb_modes_turn(modes, body, radial, sine, cosine, shape);
}

/* All modes with their copies, by frequency, as long as they fit. */
static bool list_modes(TbModes *list, TbArena *scratch, const TbBody *body) {
  *list = (TbModes){0};
  list->row = tb_arena_take(scratch, body->most_modes, sizeof *list->row);
  list->sine = tb_arena_take(scratch, body->most_modes, sizeof *list->sine);
  if (scratch->failed) return false;
  for (uint32_t row = 0; row < body->row_count; row++) {
    const uint32_t copies = body->modes[row].m ? 2 : 1;
    if (list->count + copies > body->most_modes) break;
    for (uint32_t copy = 0; copy < copies; copy++) {
      list->row[list->count] = row;
      list->sine[list->count++] = (uint8_t)copy;
    }
  }
  list->padded = list->count;
  return true;
}

/* A mode is felt if it moves some contact point by more than this part of what the most felt one
 * does: its compliance is then 1e-4 of that one's. */
static const double FELT = 1e-2;

/* most[i]: largest shape of listed mode i over the contact points. */
static bool largest_shapes(const TbModes *list, TbArena *scratch, const TbBody *body,
                           const TbWires *wires, double *most) {
  double *radial = tb_arena_doubles(scratch, body->row_count);
  double *shape = tb_arena_doubles(scratch, list->padded);
  if (scratch->failed) return false;
  for (uint32_t row = 0; row < wires->stride; row++) {
    const bool image = (wires->mirrored && row % wires->lanes > wires->middle) ||
                       (wires->balanced && row / wires->lanes > wires->count / 2);
    if (image || wires->real[row] == 0.0) continue;
    if (!tb_arena_go_on(scratch)) return false;
    tb_modes_shape_at(list, body, wires, row, radial, shape);
    for (uint32_t i = 0; i < list->count; i++) most[i] = fmax(most[i], fabs(shape[i]));
  }
  return true;
}

static bool find_felt(const TbModes *list, TbArena *scratch, const TbBody *body,
                      const TbWires *wires, uint8_t *felt) {
  double *most = tb_arena_doubles(scratch, list->padded);
  if (scratch->failed || !largest_shapes(list, scratch, body, wires, most)) return false;
  double largest = 0.0;
  for (uint32_t i = 0; i < list->count; i++) largest = fmax(largest, most[i]);
  for (uint32_t i = 0; i < list->count; i++) felt[i] = most[i] > FELT * largest;
  return true;
}

/* Under x -> -x, theta -> pi - theta: cos(m theta) is even for even m, sin(m theta) for odd m. */
static bool is_odd_along(const TbBody *body, uint32_t row, bool sine) {
  return (body->modes[row].m % 2 == 0) == sine;
}

/* Which group a listed mode belongs to; `groups` stands for the uncoupled rest. Under y -> -y,
 * theta -> -theta, the cosines are even. */
static uint32_t group_of(const TbModes *modes, const TbModes *list, const TbBody *body, uint32_t i,
                         bool felt) {
  if (!felt) return modes->groups;
  const bool along = modes->halves == 2 && is_odd_along(body, list->row[i], list->sine[i]);
  const bool across = modes->quarters == 2 && list->sine[i];
  return (along ? modes->quarters : 0u) + (across ? 1u : 0u);
}

/* A mode moves one head alone if it stretches the other by less than this part. */
static const double ONE_HEAD = 1e-4;

/* So many modes stand by frequency: uneven lugs couple the lowest (model.h). */
enum { LOWEST = 128 };

/* The run of a mode that no wire feels. */
static uint32_t run_of(const TbBody *body, const TbBodyMode *mode) {
  if (body->surfaces < 2) return 0;
  const double batter = tb_body_slope_square(body, 0, mode);
  const double resonant = tb_body_slope_square(body, 1, mode);
  return resonant < ONE_HEAD * batter ? 1 : (batter < ONE_HEAD * resonant ? 2 : 0);
}

static uint32_t pad_with_silence(TbModes *modes, uint32_t next) {
  while (next % 8 != 0) modes->row[next++] = TB_NO_MODE;
  return next;
}

/* Keys by which the list of modes is ordered. */
typedef struct Listing {
  const TbModes *list;
  const TbBody *body;
  const uint8_t *felt, *low;
  uint8_t *section; /* of each listed mode that no wire feels */
  uint32_t waves;   /* around a hi-hat's edges (rim_waves.h); 0 without */
  bool parts_copies;
} Listing;

static void list_mode(TbModes *modes, const TbModes *list, uint32_t i, uint32_t *next) {
  modes->row[*next] = list->row[i];
  modes->sine[(*next)++] = list->sine[i];
}

/* The section of a listed mode, of this number among those that no wire feels. */
static uint32_t section_of(const Listing *l, uint32_t i, uint32_t number) {
  const uint32_t row = l->list->row[i];
  const bool sine = l->list->sine[i] != 0, low = l->low[2u * row + sine] != 0;
  if (number < LOWEST) return 0;
  return 3u * run_of(l->body, &l->body->modes[row]) + (low ? 0u : 1u + (l->parts_copies && sine));
}

/* The modes that no wire feels, in sections. */
static uint32_t order_unfelt(TbModes *modes, const Listing *l, uint32_t next) {
  const TbModes *list = l->list;
  uint32_t number = 0;
  for (uint32_t i = 0; i < list->count; i++) {
    if (!l->felt[i]) l->section[i] = (uint8_t)section_of(l, i, number++);
  }
  for (uint32_t section = 0; section < TB_MODE_SECTIONS; section++) {
    modes->section[section] = next;
    for (uint32_t i = 0; i < list->count; i++) {
      if (!l->felt[i] && l->section[i] == section) list_mode(modes, list, i, &next);
    }
    next = pad_with_silence(modes, next);
  }
  modes->section[TB_MODE_SECTIONS] = next;
  for (uint32_t r = 0; r <= TB_MODE_RUNS; r++) modes->run[r] = modes->section[3u * r];
  return next;
}

static void add_low(TbParts *low, uint32_t from, uint32_t end) {
  low->from[low->count] = from;
  low->end[low->count++] = end;
}

/* The low part of a group ends with its last low mode: most of them are. */
static void find_low(TbModes *modes, const Listing *l) {
  modes->low.count = 0;
  for (uint32_t group = 0; group < modes->groups; group++) {
    uint32_t end = modes->group[group];
    for (uint32_t i = end; i < modes->group[group + 1]; i++) {
      const bool is_real = modes->row[i] != TB_NO_MODE;
      if (is_real && l->low[2u * modes->row[i] + modes->sine[i]]) end = i + 1u;
    }
    add_low(&modes->low, modes->group[group], tb_pad(end));
  }
  for (uint32_t r = 0; r < TB_MODE_RUNS; r++) {
    add_low(&modes->low, modes->section[3u * r], modes->section[3u * r + 1u]);
  }
}

/* Whether a listed mode moves the edges by this wave, and is one of those that large deflections
 * may couple, or none of them. */
static bool is_of_wave(const Listing *l, uint32_t i, bool coupled, uint32_t wave) {
  const TbBodyMode *mode = &l->body->modes[l->list->row[i]];
  return l->felt[i] && (mode->omega < l->body->membrane.top) == coupled &&
         tb_rim_wave(l->waves, mode->m, l->list->sine[i] != 0) == wave;
}

/* The modes that the edges feel, wave by wave, and padded: those that may be coupled come first. */
static uint32_t order_waves(TbModes *modes, const Listing *l, uint32_t next) {
  for (uint32_t high = 0; high < 2; high++) {
    for (uint32_t wave = 0; wave < l->waves; wave++) {
      for (uint32_t i = 0; i < l->list->count; i++) {
        if (is_of_wave(l, i, high == 0, wave)) list_mode(modes, l->list, i, &next);
      }
      next = pad_with_silence(modes, next);
    }
  }
  return next;
}

static uint32_t order_group(TbModes *modes, const Listing *l, uint32_t group, uint32_t next) {
  const TbModes *list = l->list;
  if (l->waves > 0) return order_waves(modes, l, next);
  for (uint32_t i = 0; i < list->count; i++) {
    if (group_of(modes, list, l->body, i, l->felt[i]) == group) list_mode(modes, list, i, &next);
  }
  return pad_with_silence(modes, next);
}

static bool order_modes(TbModes *modes, TbArena *arena, const Listing *l, const uint32_t *spare) {
  const TbModes *list = l->list;
  uint32_t room = tb_pad(list->count) + 8u * (modes->groups + TB_MODE_SECTIONS + 2u * l->waves);
  for (uint32_t group = 0; spare && group < modes->groups; group++) room += spare[group];
  modes->count = list->count;
  modes->row = tb_arena_take(arena, room, sizeof *modes->row);
  modes->sine = tb_arena_take(arena, room, sizeof *modes->sine);
  if (arena->failed) return false;
  uint32_t next = 0;
  for (uint32_t group = 0; group < modes->groups; group++) {
    modes->group[group] = next;
    next = order_group(modes, l, group, next);
    for (uint32_t i = 0; spare && i < spare[group]; i++) modes->row[next++] = TB_NO_MODE;
  }
  modes->group[modes->groups] = next;
  modes->padded = order_unfelt(modes, l, next);
  find_low(modes, l);
  return true;
}

static bool mode_coefficients(TbModes *modes, TbArena *arena, const TbBody *body, double side,
                              double k) {
  double **arrays[] = {&modes->a,         &modes->b,        &modes->g,          &modes->stiffness,
                       &modes->loss_head, &modes->loss_air, &modes->loss_shell, &modes->pull};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(arena, modes->padded);
  }
  if (arena->failed) return false;
  for (uint32_t i = 0; i < modes->padded; i++) {
    if (modes->row[i] == TB_NO_MODE) continue;
    const TbBodyMode *mode = &body->modes[modes->row[i]];
    const TbPole pole = tb_pole(tb_body_omega(mode, modes->sine[i]), mode->decay_rate, k);
    const double each = mode->decay_rate > 0.0 ? pole.loss / mode->decay_rate : 0.0;
    modes->a[i] = pole.a;
    modes->b[i] = pole.b;
    modes->g[i] = pole.g;
    modes->pull[i] = -side * pole.g;
    modes->stiffness[i] = pole.stiffness;
    modes->loss_air[i] = each * mode->radiation_rate;
    modes->loss_shell[i] = each * mode->shell_rate;
    modes->loss_head[i] = pole.loss - modes->loss_air[i] - modes->loss_shell[i];
    modes->walls = modes->walls || mode->shell_rate > 0.0;
  }
  return true;
}

TaborStatus tb_modes_prepare(TbModes *modes, TbArena *arena, const TbBody *body,
                             const TbWires *wires, const uint8_t *low, const uint32_t *spare,
                             double time_step) {
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  *modes = (TbModes){.halves = wires->mirrored ? 2 : 1, .quarters = wires->balanced ? 2 : 1};
  modes->groups = modes->halves * modes->quarters;
  TbModes list;
  uint8_t *felt = tb_arena_take(&scratch, body->most_modes, sizeof *felt);
  const Listing listing = {.list = &list,
                           .body = body,
                           .felt = felt,
                           .low = low,
                           .section = tb_arena_take(&scratch, body->most_modes, 1),
                           .waves = wires->rims ? wires->contact_points : 0u,
                           .parts_copies = wires->count == 0};
  const bool done = felt && listing.section && list_modes(&list, &scratch, body) &&
                    find_felt(&list, &scratch, body, wires, felt) &&
                    order_modes(modes, arena, &listing, spare) &&
                    mode_coefficients(modes, arena, body, wires->side, time_step);
  tb_arena_release(&scratch);
  return done ? TABOR_OK : TABOR_ERROR_MEMORY;
}
