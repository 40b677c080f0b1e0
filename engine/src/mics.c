/* SPDX-License-Identifier: MIT */
/* Microphones: pressure computed from each mode's radiation, with its phase and its delay. */
#include <math.h>

#include "model.h"
#include "power.h"

/* ---- microphones ---------------------------------------------------------------------------- */

/* Travel time to the nearest point of the head, in whole samples. */
static uint32_t travel_delay(const TaborModel *model, const TaborMicDef *mic) {
  const double aside = fmax(0.0, mic->radius - model->head.radius);
  const double distance = sqrt(mic->height * mic->height + aside * aside);
  return (uint32_t)(distance / model->def.air.sound_speed * model->sample_rate);
}

/* Real u, v with u (l - 2 + 1/l) + v (l - 1/l) = gain for the pole l: the weights that turn a mode's
 * acceleration and velocity into a pressure of this size and phase. */
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

/* p = -omega^2 rho0 R I per unit amplitude, advanced by the delay that is taken out, and times
 * sin(omega k)/(omega k), by which the recursion's answer to a force is too large. */
static void mic_weights(const TaborModel *model, uint32_t index, TbMic *mic) {
  const TaborMicDef *place = &model->def.mic[index];
  const double k = model->time_step;
  double sine, cosine;
  tb_sin_cos_degrees(place->angle - model->def.wires.angle, &sine, &cosine);
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const TbHeadMode *mode = &model->head.modes[model->modes.row[i]];
    const double size = -mode->omega * mode->omega * model->def.air.density * model->head.radius *
                        tb_angular(mode->m, model->modes.sine[i], sine, cosine) *
                        sin(mode->omega * k) / (mode->omega * k);
    const double re = mode->fields[2 * index], im = mode->fields[2 * index + 1];
    const double phase = mode->omega * (double)mic->delay * k;
    const TbPole pole = tb_pole(mode->omega, mode->decay_rate, k);
    realise(&pole, size * (re * cos(phase) - im * sin(phase)),
            size * (re * sin(phase) + im * cos(phase)), mode->omega * k, &mic->u[i], &mic->v[i]);
  }
}

TaborStatus tb_mics_prepare(TaborModel *model) {
  for (uint32_t index = 0; index < model->def.mic_count; index++) {
    TbMic *mic = &model->mics[index];
    mic->delay = travel_delay(model, &model->def.mic[index]);
    mic->u = tb_arena_doubles(&model->arena, model->modes.padded);
    mic->v = tb_arena_doubles(&model->arena, model->modes.padded);
    if (model->arena.failed) return TABOR_ERROR_MEMORY;
    mic_weights(model, index, mic);
  }
  return TABOR_OK;
}
