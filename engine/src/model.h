/* SPDX-License-Identifier: MIT */
/* Everything computed once from a definition and a sample rate; immutable afterwards.
 *
 * Each mode is a two-step recursion with exact poles, unit modal mass [design of NSS ch. 3]:
 *   q+ = a q - b q- + g F, a = 2 e^{-sk} cos(w_d k), b = e^{-2sk}, g = k^2/(1 + tanh(sk)),
 * s the decay rate, w_d = sqrt(w^2 - s^2) (cosh in place of cos where that is imaginary). It is
 *   (q+ - 2q + q-)/k^2 + (tanh(sk)/k^2)(q+ - q-) + K' q = F, K' = (2/k^2)(1 - cos(w_d k)/cosh(sk)),
 * so it stores ((q+ - q)/k)^2/2 + K' q+ q/2 and loses (tanh(sk)/(2k^2))(q+ - q-)^2 per step.
 *
 * All state counts from the static equilibrium (rest): strainer, gravity, contact. Then a drum at
 * rest is exactly zero, and stays so. */
#ifndef TB_MODEL_H
#define TB_MODEL_H

#include <stdatomic.h>

#include "head.h"
#include "kernels.h"
#include "solve.h"
#include "wires.h"

/* Patch over which a damping hand spreads its force [m]. */
#define TB_HAND_RADIUS 0.018
/* Contact curvature times compliance: the stiffest contact that one sample resolves. */
#define TB_SLOPE_LIMIT 10.0

/* Modes in the order in which they are stepped: those that any wire feels come first. */
typedef struct TbModes {
  uint32_t count, padded; /* sine copies counted; padded with silent modes to 8 lanes */
  uint32_t coupled;       /* the first ones, padded, are projected onto the wires */
  uint32_t *row;          /* [count]: of head.modes */
  uint8_t *sine;          /* [count]: 1 for sin(m theta) */
  double *a, *b, *g;      /* [padded] */
  double *stiffness;      /* K' */
  double *loss_head, *loss_air; /* tanh(sk)/(2k^2), divided between material and radiation */
  double *pull;           /* -side g: what a wire's contact force does to a coupled mode */
} TbModes;

/* Pressure at a microphone [Pa] = Sum u (q+ - 2q + q-) + v (q+ - q-), `delay` samples later. */
typedef struct TbMic {
  double *u, *v;
  uint32_t delay;
} TbMic;

typedef struct TbRest {
  double *q;       /* [padded] modal displacement at rest [m kg^1/2] */
  double *v;       /* [node_count] wires [m] */
  double *bend;    /* [node_count] their second differences [m] */
  double *eta;     /* [stride] penetration [m] */
  double *force;   /* [stride + TB_SLOTS] contact force [N]; zero for the slots */
  double *offset;  /* [wires] of the ends [m] */
  double head;     /* height of the head's centre [m] */
} TbRest;

/* Where the arrays of a drum's state lie, in bytes from its start. */
typedef struct TbLayout {
  size_t q[3], v[3], eta[3], qf, vf, bend, bend_last;
  size_t eta_free, rest_load, own, force, b, s;
  size_t previous, product, slope, residual, direction, scaled, weight, work;
  size_t coupling, shape, drive, radial, delay[TABOR_MAX_MICS];
  size_t total;
} TbLayout;

struct TaborModel {
  atomic_uint references;
  TbArena arena;
  TaborDrumDef def;
  uint32_t quality;
  double sample_rate, time_step; /* [Hz], k [s] */
  uint32_t newton_cap, inner_cap;
  const TbKernels *kernels;
  TbHead head;
  TbWires wires;
  TbModes modes;
  TbMic mics[TABOR_MAX_MICS];
  TbRest rest;
  double *projection;  /* [coupled][stride]: shape of each coupled mode at each contact point */
  double *compliance;  /* [row_count][stride]: of the head over one step, between contact points */
  double *patches[TABOR_MAX_STRIKERS + 1]; /* of each striker, then of a hand */
  double *center;      /* [padded]: shape at the head's centre */
  TbLayout layout;
  uint64_t fingerprint; /* of everything that a saved state depends on */
};

/* Coefficients of one mode with undamped frequency omega and decay rate s, both [rad/s]. */
typedef struct TbPole {
  double a, b, g, stiffness, loss;
  double re, im; /* lambda = e^{(-s + i w_d) k}; im = 0 if overdamped */
} TbPole;
TbPole tb_pole(double omega, double decay_rate, double time_step);

/* Static equilibrium into model->rest (equilibrium.c). */
TaborStatus tb_rest_prepare(TaborModel *model, TbArena *scratch);

/* Angular factor of mode row `row` at an angle given by its sine and cosine. Audio-safe. */
double tb_angular(uint32_t m, bool sine, double sin_angle, double cos_angle);

/* Shape of every mode at radius [m] and angle [deg, absolute], `patch` as in tb_head_radial();
 * radial is scratch of head.row_count. shape[padded]. Audio-safe. */
void tb_model_shape(const TaborModel *model, double radius, double angle, const double *patch,
                    double *radial, double *shape);

#endif
