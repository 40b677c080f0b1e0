/* SPDX-License-Identifier: MIT */
/* Microphones: the pressure of each mode's radiation, with phase and delay. */
#include "model/mics.h"

#include <math.h>

#include "math/portable_math.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;

/* ---- microphones ---------------------------------------------------------------------------- */

/* Travel time to the nearest point of a head, in whole steps. */
static uint32_t travel_steps(const TaborModel *model, const TaborMicDef *mic) {
  const double aside = fmax(0.0, mic->radius - model->body.radius);
  double height = fabs(mic->height);
  if (model->def.two_headed) height = fmin(height, fabs(mic->height + model->def.shell.depth));
  const double distance = sqrt(height * height + aside * aside);
  return (uint32_t)(distance / model->def.air.sound_speed * model->step_rate);
}

/* Real u, v with u (l - 2 + 1/l) + v (l - 1/l) = gain for the pole l: the weights that turn a
 * mode's acceleration and velocity into a pressure of this size and phase. */
static void realise(const TbPole *pole, double gain_re, double gain_im, double omega_k, double *u,
                    double *v) {
  *v = 0.0;
  if (pole->im == 0.0) { /* overdamped: no phase to match */
    *u = -gain_re / (omega_k * omega_k);
    return;
  }
  const double square = pole->re * pole->re + pole->im * pole->im;
  const double inverse_re = pole->re / square, inverse_im = -pole->im / square;
  const double bend_re = pole->re - 2.0 + inverse_re, bend_im = pole->im + inverse_im;
  const double step_re = pole->re - inverse_re, step_im = pole->im - inverse_im;
  const double determinant = bend_re * step_im - bend_im * step_re;
  *u = (gain_re * step_im - gain_im * step_re) / determinant;
  *v = (bend_re * gain_im - bend_im * gain_re) / determinant;
}

void tb_pressure_weights(double turn, const TbPole *pole, double size, const double *field,
                         double phase, double *ahead, double *behind) {
  const double scaled = size * tb_sin(turn) / turn;
  double sine, cosine, u, v;
  tb_sin_cos(phase, &sine, &cosine);
  realise(pole, scaled * (field[0] * cosine - field[1] * sine),
          scaled * (field[0] * sine + field[1] * cosine), turn, &u, &v);
  *ahead = u + v;
  *behind = u - v;
}

void tb_mic_weights(const TaborModel *model, uint32_t index, double omega, const TbPole *pole,
                    uint32_t m, bool sine_copy, const double *field, double *ahead,
                    double *behind) {
  double sine, cosine;
  tb_sin_cos_degrees(model->def.mic[index].angle - model->axis, &sine, &cosine);
  const double turn = omega * model->time_step;
  const double size = -omega * omega * model->def.air.density * model->body.radius *
                      tb_angular(m, sine_copy, sine, cosine);
  const double phase = turn * (double)model->mics[index].travel;
  tb_pressure_weights(turn, pole, size, field, phase, ahead, behind);
}

/* The weights of a source at the microphone's place, from those of the microphone. These give the
 * pressure per unit of displacement, -w^2 W, and a factor sin(w k)/(w k) that makes up for what the
 * recursion does to a force; who hears the drum makes up for it already. */
static void push_weights(const TaborModel *model, const TaborMicDef *def, double omega,
                         double ahead, double behind, double *now, double *before) {
  const double distance = sqrt(def->radius * def->radius + def->height * def->height);
  const double turn = omega * model->time_step, u = 0.5 * (ahead + behind),
               v = 0.5 * (ahead - behind);
  double sine, cosine;
  *now = *before = 0.0;
  if (model->def.air.density == 0.0) return;
  tb_sin_cos(turn, &sine, &cosine);
  const double size = 4.0 * PI * distance / model->def.air.density * turn / (omega * omega * sine);
  *now = size * (2.0 * u * (cosine - 1.0) + 2.0 * v * cosine);
  *before = -size * 2.0 * v;
}

typedef struct Weights {
  double ahead, behind, push_now, push_before;
} Weights;

static TbPole pole_of(const TaborModel *model, const TbBodyMode *mode, bool sine) {
  return tb_pole(tb_body_omega(mode, sine), mode->decay_rate, model->time_step);
}

static Weights weights_of(const TaborModel *model, uint32_t index, const TbBodyMode *mode,
                          const TbPole *pole, bool sine) {
  Weights w;
  const double omega = tb_body_omega(mode, sine);
  tb_mic_weights(model, index, omega, pole, mode->m, sine, mode->fields + 2 * index, &w.ahead,
                 &w.behind);
  push_weights(model, &model->def.mic[index], omega, w.ahead, w.behind, &w.push_now,
               &w.push_before);
  return w;
}

/* Weights of one mode at all microphones. */
static void mode_weights(TaborModel *model, uint32_t i) {
  if (model->modes.row[i] == TB_NO_MODE) return;
  const TbBodyMode *mode = &model->body.modes[model->modes.row[i]];
  const TbPole pole = pole_of(model, mode, model->modes.sine[i] != 0);
  for (uint32_t index = 0; index < model->def.mic_count; index++) {
    const Weights w = weights_of(model, index, mode, &pole, model->modes.sine[i]);
    TbMic *mic = &model->mics[index];
    mic->ahead[i] = w.ahead;
    mic->behind[i] = w.behind;
    mic->push_now[i] = w.push_now;
    mic->push_before[i] = w.push_before;
  }
}

/* ---- low modes ------------------------------------------------------------------------------ */

static const double LOW = 2000.0;        /* [Hz] */
static const double LEAST_WEIGHT = 1e-3; /* of the largest: -60 dB */

/* push[2 row + sine]: how much sound from the place of each microphone pushes a mode's copies. */
static void find_pushes(const TaborModel *model, uint32_t row, double *const push[TABOR_MAX_MICS]) {
  const TbBodyMode *mode = &model->body.modes[row];
  if (mode->omega >= 2.0 * PI * LOW) return;
  const TbPole pole = pole_of(model, mode, false); /* its sine copy is nearly the same */
  for (uint32_t index = 0; index < model->def.mic_count; index++) {
    for (uint32_t sine = 0; sine < (mode->m ? 2u : 1u); sine++) {
      const Weights w = weights_of(model, index, mode, &pole, sine);
      push[index][2u * row + sine] = fabs(w.push_now) + fabs(w.push_before);
    }
  }
}

static void mark_low(uint32_t count, const double *push, uint8_t *low) {
  double largest = 0.0;
  for (uint32_t i = 0; i < count; i++) largest = fmax(largest, push[i]);
  for (uint32_t i = 0; i < count; i++) low[i] |= push[i] > LEAST_WEIGHT * largest;
}

TaborStatus tb_mics_find_low(TaborModel *model, TbArena *scratch, uint8_t *low) {
  const uint32_t count = 2u * model->body.row_count;
  double *push[TABOR_MAX_MICS] = {NULL};
  for (uint32_t index = 0; index < model->def.mic_count; index++) {
    model->mics[index].travel = travel_steps(model, &model->def.mic[index]);
    push[index] = tb_arena_doubles(scratch, count);
  }
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  for (uint32_t row = 0; row < model->body.row_count; row++) find_pushes(model, row, push);
  for (uint32_t index = 0; index < model->def.mic_count; index++) mark_low(count, push[index], low);
  return TABOR_OK;
}

TaborStatus tb_mics_prepare(TaborModel *model) {
  for (uint32_t index = 0; index < model->def.mic_count; index++) {
    TbMic *mic = &model->mics[index];
    mic->delay = mic->travel - (uint32_t)fmin(mic->travel, model->steps > 1 ? TB_HALVE_STEPS : 0);
    tb_mic_response_prepare(&mic->response, model->def.mic[index].response, model->sample_rate);
    mic->ahead = tb_arena_doubles(&model->arena, model->modes.padded);
    mic->behind = tb_arena_doubles(&model->arena, model->modes.padded);
    mic->push_now = tb_arena_doubles(&model->arena, model->modes.padded);
    mic->push_before = tb_arena_doubles(&model->arena, model->modes.padded);
  }
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < model->modes.padded; i++) mode_weights(model, i);
  return TABOR_OK;
}
