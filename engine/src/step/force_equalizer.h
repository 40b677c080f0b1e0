/* SPDX-License-Identifier: MIT */
/* Equalizers at the microphones that restore the treble that contact forces lose to the sample
 * rate.
 *
 * A wire's force is the discrete gradient of its potential over two steps. It is the mean of the
 * true force over 2k, whose spectrum is sin(omega k)/(omega k) times the true one (-7.4 dB at 16
 * kHz and 48 kHz). A striker's force is a mean over k, between means of two instants (contact_law.h):
 * sin(omega k/2)/(omega k/2), -1.7 dB there. Such forces drive every audible motion, so one filter per
 * microphone undoes the loss:
 *   y = g (x + b1 x-) - a1 y- - a2 y--,  g = (1 + a1 + a2)/(1 + b1), gain 1 at 0 Hz.
 * That of wires is fitted to omega k/sin(omega k), within 0.07 dB up to 16 kHz at 44.1 kHz (omega k = 2.28),
 * and hence at every higher rate; poles at 0.70 and 0.37 keep its gain at half the rate to 19 dB. That of strikers
 * is within 0.013 dB.
 *
 * Unless the wires are thrown off, the filter is theirs. It lifts what strikers excite by 1/cos(omega k/2) too much, so
 * their forces act on the high band as means of two samples; at the two-way modes of `live` this is 0.3 dB or less.
 * Audio-safe. */
#ifndef TB_FORCE_EQUALIZER_H
#define TB_FORCE_EQUALIZER_H

typedef struct TbForceEqualizer {
  double g, b1, a1, a2;
} TbForceEqualizer;

#define TB_FORCE_EQUALIZER(b1, a1, a2)                                                             \
  { (1.0 + (a1) + (a2)) / (1.0 + (b1)), b1, a1, a2 }
static const TbForceEqualizer TB_EQUALIZER_OF_WIRES = TB_FORCE_EQUALIZER(0.15032, 1.06685, 0.25679);
static const TbForceEqualizer TB_EQUALIZER_OF_STRIKERS =
  TB_FORCE_EQUALIZER(0.10823819, 0.26615854, 0.0);

/* `memory` holds x-, y-, y--. */
static inline double tb_force_equalizer(const TbForceEqualizer *e, double memory[3], double x) {
  const double y = e->g * (x + e->b1 * memory[0]) - e->a1 * memory[1] - e->a2 * memory[2];
  memory[0] = x;
  memory[2] = memory[1];
  memory[1] = y;
  return y;
}

#endif
