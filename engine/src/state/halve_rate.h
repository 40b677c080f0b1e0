/* SPDX-License-Identifier: MIT */
/* From two samples of a drum's steps to one of its output, where a model steps twice per frame.
 *
 * An elliptic low-pass whose pass band and stop band mirror each other about a quarter of the rate
 * has its poles on the imaginary axis. It is the mean of two chains of all-passes in z^2,
 *   H(z) = (A(z^2) + B(z^2)/z)/2, A, B = Prod_j (a_j + 1/z^2)/(1 + a_j/z^2),
 * so each chain runs once per frame: A on the second sample, B on the first. With q the nome of the
 * modulus k = tan^2(pi (1/4 - t)) (t is the width of the transition in parts of the rate, 2n + 1 =
 * 17 the order, c = 1 .. n),
 *   w_c = q^(1/4) Sum_i (-1)^i q^(i (i + 1)) sin((2 i + 1) c pi/17)
 *         / (1/2 + Sum_(i > 0) (-1)^i q^(i^2) cos(2 i c pi/17)),
 *   x_c = sqrt((1 - k w_c^2)(1 - w_c^2/k))/(1 + w_c^2), a_c = (1 - x_c)/(1 + x_c),
 * in turn to A and B. t = 0.0465 lets pass 20 kHz at 44.1 kHz, and at every rate 0.4535 of the
 * output's: down by less than 1e-6 dB; what would fold onto that is down by 104 dB. The delay at
 * low frequencies is 1.84 frames, which microphones take off a sound's travel time (TB_HALVE_STEPS
 * of model/mics.h); it is 2.5 frames at a quarter of the output's rate, 5.8 at 20 kHz and 48 kHz,
 * 8.8 at 20 kHz and 44.1 kHz. Audio-safe. */
#ifndef TB_HALVE_RATE_H
#define TB_HALVE_RATE_H

enum { TB_HALVE_STAGES = 4, TB_HALVE_MEMORY = 2 * (TB_HALVE_STAGES + 1) };

/* `memory`: the last input of each stage, then the last output. */
static inline double tb_halve_chain(double *memory, const double a[TB_HALVE_STAGES], double x) {
  for (int j = 0; j < TB_HALVE_STAGES; j++) {
    const double y = a[j] * (x - memory[j + 1]) + memory[j];
    memory[j] = x;
    x = y;
  }
  memory[TB_HALVE_STAGES] = x;
  return x;
}

static inline double tb_halve_rate(double memory[TB_HALVE_MEMORY], double first, double second) {
  static const double EVEN[TB_HALVE_STAGES] = {0.03735837606231, 0.281305365438652,
                                               0.584407547588238, 0.834550108176893},
                      ODD[TB_HALVE_STAGES] = {0.1393387011966, 0.436209950905589, 0.717019088378488,
                                              0.944292118423108};
  const double a = tb_halve_chain(memory, EVEN, second);
  const double b = tb_halve_chain(memory + TB_HALVE_STAGES + 1, ODD, first);
  return 0.5 * (a + b);
}

#endif
