/* SPDX-License-Identifier: MIT */
#include "heads/von_karman.h"

#include <math.h>

#include "heads/stretch_law.h"

static const uint64_t LOOK = 256;       /* steps from one look at the energy to the next */
static const double FADE = 0.02;        /* [s] */
static const double LEAST_SHIFT = 1e-3; /* of the quiet energy */
static const double MOST_RELAXED = 0.2; /* of the modes' energy */

/* x, but not beyond -most and most. */
static double within(double x, double most) { return x > most ? most : (x < -most ? -most : x); }

/* ---- the potential --------------------------------------------------------------------------- */

static float *displacements(const TbView *view) {
  return view->stretch.scratch + tb_von_karman_scratch(&view->model->plate.tables);
}

static float *gradient_of(const TbView *view) {
  return displacements(view) + tb_pad(2u * view->model->plate.tables.pairs);
}

/* V at q, and its gradient in gradient_of(), but for the part that acts. */
static double potential(const TbView *view, const double *q) {
  const TbPlateCoupling *plate = &view->model->plate;
  float *x = displacements(view);
  for (uint32_t i = 0; i < 2u * plate->tables.pairs; i++) {
    x[i] = plate->mode[i] == TB_NO_MODE ? 0.0f : (float)q[plate->mode[i]];
  }
  return view->model->kernelsf->von_karman(&plate->tables, x, gradient_of(view),
                                           view->stretch.scratch);
}

/* The part of V that acts. */
static double coupled_energy(const TbView *view, const double *q) {
  return view->state->plate.part * view->model->def.plate.large_deflections * potential(view, q);
}

/* ---- energy ---------------------------------------------------------------------------------- */

static double energy(const TbView *view, const TbPhase *next, const TbPhase *now) {
  (void)now;
  const double psi = *next->psi;
  return 0.5 * (psi * psi - view->state->plate.shift);
}

static double modes_energy(const TbView *view) {
  const TbPlateCoupling *plate = &view->model->plate;
  double sum = 0.0;
  for (uint32_t i = 0; i < 2u * plate->tables.pairs; i++) {
    if (plate->mode[i] != TB_NO_MODE) sum += tb_mode_energy(view, plate->mode[i]);
  }
  return sum;
}

/* The modes' energy. A pedal may keep a hi-hat bent; of one it is twice their kinetic energy, as
 * much in the mean over their periods. */
static double lively_energy(const TbView *view) {
  const TbPlateCoupling *plate = &view->model->plate;
  const double rate = view->model->step_rate;
  double sum = 0.0;
  if (!view->model->wires.rims) return modes_energy(view);
  for (uint32_t i = 0; i < 2u * plate->tables.pairs; i++) {
    if (plate->mode[i] == TB_NO_MODE) continue;
    const double velocity = (view->now.q[plate->mode[i]] - view->last.q[plate->mode[i]]) * rate;
    sum += velocity * velocity;
  }
  return sum;
}

static double sticks_energy(const TbView *view) {
  const double rate = view->model->step_rate;
  double sum = 0.0;
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    const double velocity = (view->now.z[i] - view->last.z[i]) * rate;
    if (tb_slot_strikes(tb_slot(view, i)))
      sum += tb_slot(view, i)->striker.mass * velocity * velocity;
  }
  return 0.5 * sum;
}

/* psi^2 - C stays. */
static void set_shift(TbView *view, double shift) {
  TbPlateState *plate = &view->state->plate;
  const double more = *view->now.psi * *view->now.psi - plate->shift;
  plate->shift = shift > -2.0 * more ? shift : -2.0 * more;
  *view->now.psi = sqrt(more + plate->shift);
}

static void raise_shift(TbView *view, bool looks) {
  const TbPlateState *plate = &view->state->plate;
  const double least = LEAST_SHIFT * view->model->plate.quiet;
  const double shift = 2.0 * (plate->energy + sticks_energy(view)) + least;
  if (looks || shift > plate->shift) set_shift(view, shift);
}

/* ---- whether it acts ------------------------------------------------------------------------- */

/* The rest of the coupling's energy goes with it. */
static void switch_off(TbView *view) {
  TbPlateState *plate = &view->state->plate;
  view->state->ledger.sums.control -= energy(view, &view->now, &view->last);
  plate->shift = *view->now.psi = 0.0;
}

/* The part of the coupling that acts follows what is wanted: at once where a stick finds the plate
 * quiet. */
static void fade(TbView *view, bool driven, bool loud) {
  TbPlateState *plate = &view->state->plate;
  const double step = 1.0 / (FADE * view->model->step_rate);
  if (driven && !loud && plate->part == 0.0) plate->part = 1.0;
  const double wanted = driven || loud ? 1.0 : 0.0, before = plate->part;
  plate->part += within(wanted - plate->part, step);
  if (before > 0.0 && plate->part == 0.0) switch_off(view);
}

/* ---- the law --------------------------------------------------------------------------------- */

static void fill_gradient(TbView *view) {
  const TbPlateCoupling *model = &view->model->plate;
  const TbPlateState *plate = &view->state->plate;
  const double twice = 2.0 * coupled_energy(view, view->now.q);
  if (plate->shift < -2.0 * twice) set_shift(view, -2.0 * twice);
  const double root = sqrt(twice + plate->shift);
  const double part = plate->part * view->model->def.plate.large_deflections;
  const double scale = model->every * part / root;
  const float *gradient = gradient_of(view);
  for (uint32_t i = 0; i < 2u * model->tables.pairs; i++) {
    if (model->mode[i] == TB_NO_MODE) continue;
    view->stretch.mixed[0][model->mode[i]] = scale * (double)gradient[i];
  }
}

static uint32_t begin(TbView *view) {
  TbPlateState *plate = &view->state->plate;
  const bool looks = view->state->clock % LOOK == 0, driven = tb_stretch_is_driven(view);
  if (looks) plate->energy = lively_energy(view);
  fade(view, driven, plate->energy > view->model->plate.quiet);
  if (plate->part == 0.0) return 0;
  raise_shift(view, looks);
  if (view->state->clock % view->model->plate.every > 0) return 0;
  fill_gradient(view);
  return 1;
}

/* 4 psi- - 2 g.q- */
static double shift(const TbView *view) {
  const TbPlateCoupling *plate = &view->model->plate;
  double sum = 0.0;
  for (uint32_t i = 0; i < 2u * plate->tables.pairs; i++) {
    const uint32_t mode = plate->mode[i];
    if (mode != TB_NO_MODE) sum += view->stretch.mixed[0][mode] * view->last.q[mode];
  }
  return 4.0 * *view->now.psi - 2.0 * sum;
}

static void end(TbView *view) {
  const double psi = *view->now.psi;
  *view->next.psi = view->stretch.count > 0 ? -2.0 * view->end.stretch[0] - psi : psi;
}

const TbStretchLaw tb_von_karman = {.begin = begin, .shift = shift, .end = end, .energy = energy};

/* ---- setting psi right ----------------------------------------------------------------------- */

double tb_von_karman_excess(const TbView *view) {
  if (view->state->clock % LOOK != 0) return 0.0;
  const double right = coupled_energy(view, view->now.q), most = MOST_RELAXED * modes_energy(view);
  return within(energy(view, &view->now, &view->last) - right, most);
}

void tb_von_karman_return(TbView *view, double excess) {
  const TbPlateCoupling *plate = &view->model->plate;
  const double factor = sqrt(1.0 + excess / modes_energy(view));
  const double psi = *view->now.psi, square = psi * psi - 2.0 * excess;
  if (!(square > 0.0)) return;
  for (uint32_t i = 0; i < 2u * plate->tables.pairs; i++) {
    const uint32_t mode = plate->mode[i];
    if (mode != TB_NO_MODE) tb_mode_scale(view, mode, factor);
  }
  *view->now.psi = sqrt(square);
}
