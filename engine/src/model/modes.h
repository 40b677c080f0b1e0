/* SPDX-License-Identifier: MIT */
/* The head's modes in the step: one two-step recursion per mode, with exact poles and unit modal
 * mass [NSS ch. 3],
 *   q+ = a q - b q- + g F, a = 2 e^{-sk} cos(w_d k), b = e^{-2sk}, g = k^2/(1 + tanh(sk)),
 * s the decay rate, w_d = sqrt(w^2 - s^2) (cosh in place of cos if w_d is imaginary). The recursion
 * equals
 *   (q+ - 2q + q-)/k^2 + (tanh(sk)/k^2)(q+ - q-) + K' q = F, K' = (2/k^2)(1 - cos(w_d k)/cosh(sk)),
 * so it stores ((q+ - q)/k)^2/2 + K' q+ q/2 and loses (tanh(sk)/(2k^2))(q+ - q-)^2 per step. */
#ifndef TB_MODES_H
#define TB_MODES_H

#include "bodies/body.h"
#include "kernels/kernels.h"
#include "model/wires.h"

#define TB_NO_MODE UINT32_MAX

enum { TB_MODE_RUNS = 3, TB_MODE_SECTIONS = 3 * TB_MODE_RUNS };

/* Modes that some wire feels come first, in groups of one symmetry each. Shapes even under the
 * mirror x -> -x across the wires' middles precede the odd ones; in each half, shapes even under y
 * -> -y precede the odd ones. Silent modes pad each group to a multiple of 8. The modes that no
 * wire feels follow. Wires that lack a symmetry have half the groups. The edges of a hi-hat have
 * one group, in which the modes of each wave around them (rim_waves.h) stand together.
 *
 * The modes that no wire feels stand in three runs: the lowest and all that move both heads, the
 * batter head alone, the resonant head alone. A run has three sections: the lowest and those that
 * other drums' sound moves, then the other cosines, then the other sines; with wires, all of these.
 * Angles count from that of the drum's own stroke (TaborModel.axis), which moves no sine. Each
 * section is sorted by frequency, and padded like groups. */
typedef struct TbModes {
  uint32_t count, padded;         /* modes, sine copies counted; the same with padding */
  uint32_t halves, quarters;      /* groups under x -> -x, and under y -> -y: 1 or 2 each */
  uint32_t groups;                /* halves * quarters */
  uint32_t group[5];              /* first mode of each group; coupled modes end at group[groups] */
  uint32_t run[TB_MODE_RUNS + 1]; /* first mode of each run; the first run has the lowest modes */
  uint32_t section[TB_MODE_SECTIONS + 1]; /* first mode of each section */
  TbParts low; /* by which drums hear each other: the first of each group, the first section of each
                  run */
  uint32_t *row;                 /* [padded]: index in head.modes, or TB_NO_MODE for padding */
  uint8_t *sine;                 /* [padded]: 1 for sin(m theta) */
  double *a, *b, *g;             /* [padded], as are all arrays below */
  double *stiffness;             /* K' */
  double *loss_head;             /* tanh(sk)/(2k^2): the part of the heads */
  double *loss_air, *loss_shell; /* the parts of sound and of the cavity's walls */
  bool walls;                    /* some loss_shell is not 0 */
  double *pull;                  /* -side g: a mode's response to a wire's contact force */
} TbModes;

/* A range of modes from the first one on, and another one behind it that may be empty. */
typedef struct TbModeRanges {
  uint32_t first, from,
    size; /* modes 0 .. first - 1, and `size` modes from `from` on: multiples of 8 */
} TbModeRanges;

/* All modes. */
static inline TbModeRanges tb_modes_all(const TbModes *modes) {
  return (TbModeRanges){modes->padded, modes->padded, 0};
}
/* Modes that move head `which`. The run of the other head alone is left out: its slopes here are 1
 * % of its own at most. A hard stroke on bass drum, toms and snare then changes by 0.2 dB in no
 * third octave up to 16 kHz. */
static inline TbModeRanges tb_modes_of_head(const TbModes *modes, uint32_t which) {
  const uint32_t *run = modes->run;
  if (which == 0) return (TbModeRanges){run[2], modes->padded, 0};
  return (TbModeRanges){run[1], run[2], run[3] - run[2]};
}

static inline bool tb_modes_have(TbModeRanges ranges, uint32_t mode) {
  return mode < ranges.first || mode - ranges.from < ranges.size;
}

/* Coefficients of one mode with undamped frequency omega and decay rate s, both [rad/s]. */
typedef struct TbPole {
  double a, b, g, stiffness, loss;
  double re, im; /* lambda = e^{(-s + i w_d) k}; im = 0 if overdamped */
} TbPole;
TbPole tb_pole(double omega, double decay_rate, double time_step);

/* Twice the energy between two instants. */
static inline double tb_pole_energy(double rate, double stiffness, double next, double now) {
  const double velocity = (next - now) * rate;
  return velocity * velocity + stiffness * next * now;
}

/* Converts the two instants of a motion from the recursion a0, b0 to a1, b1, whose steps are
 * `ratio` times as long, keeping phase and action (drum/swap.c). If either b is 0, there is no such
 * mode, and the motion ends. If either mode does not swing, place and velocity are kept.
 * Audio-safe. */
void tb_pole_carry(double a0, double b0, double a1, double b1, double ratio, double *now,
                   double *last);
/* Place one step ago, if steps are `ratio` times as long as between `now` and `last`.
 */
static inline double tb_step_ago(double now, double last, double ratio) {
  return ratio == 1.0 ? last : now - ratio * (now - last);
}

/* As many steps as take the same time, at least one if there were any. */
static inline uint32_t tb_steps_left(uint32_t left, double ratio) {
  const uint32_t steps = (uint32_t)(left / ratio);
  return left > 0 && steps == 0 ? 1 : steps;
}

/* cos(m t) or sin(m t) from sin t, cos t. Audio-safe; exact zeros stay exact. */
double tb_angular(uint32_t m, bool sine, double sin_angle, double cos_angle);

/* tb_angular() for orders 0 .. orders - 1 at once: c[orders], s[orders]. */
void tb_angular_factors(uint32_t orders, double sin_angle, double cos_angle, double *c, double *s);

/* Lists and orders the modes and computes their coefficients. Each group ends with spare[group]
 * modes that have neither, a multiple of 8; NULL: none. low[2 row + sine]: whether other drums'
 * sound moves it. */
TaborStatus tb_modes_prepare(TbModes *modes, TbArena *arena, const TbBody *body,
                             const TbWires *wires, const uint8_t *low, const uint32_t *spare,
                             double time_step);

/* Computes shape[padded], the shape of every mode on head `which`, relative to the lifted edge, at
 * radius [m] and angle from the axis (sine, cosine). `patch` as in tb_body_radial();
 * radial is scratch of head.row_count. Audio-safe. */
void tb_modes_shape(const TbModes *modes, const TbBody *body, uint32_t which, double radius,
                    double sin_angle, double cos_angle, const double *patch, double *radial,
                    double *shape);

/* Computes the shape of every mode at a contact point of the wires; of a hi-hat's edges, how far it
 * closes them. */
void tb_modes_shape_at(const TbModes *modes, const TbBody *body, const TbWires *wires, uint32_t row,
                       double *radial, double *shape);

/* Computes the same from given radial shapes, radial[head.row_count]. */
void tb_modes_turn(const TbModes *modes, const TbBody *body, const double *radial, double sin_angle,
                   double cos_angle, double *shape);

#endif
