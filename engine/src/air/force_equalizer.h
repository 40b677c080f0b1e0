/* SPDX-License-Identifier: MIT */
/* Equalizer at the microphones that restores the treble that the wires' contact forces lose to the
 * sample rate.
 *
 * A wire's force is the discrete gradient of its potential over two steps. It is the mean of the
 * true force over 2k, whose spectrum is sin(omega k)/(omega k) times the true one (-7.4 dB at 16
 * kHz and 48 kHz). Such forces drive every audible motion, so one filter per microphone undoes the
 * loss:
 *   y = g (x + b1 x-) - a1 y- - a2 y--,  g = (1 + a1 + a2)/(1 + b1), gain 1 at 0 Hz.
 * It is fitted to omega k/sin(omega k), within 0.07 dB up to 16 kHz at 44.1 kHz (omega k = 2.28),
 * and hence at every higher rate. Poles at 0.70 and 0.37 keep its gain at half the rate to 19 dB.
 *
 * A striker's force is a mean over k (contact_law.h) and is heard as it is: toms, bass drum and
 * timpano at `live` and 44.1 or 48 kHz are then within 3 dB of 96 kHz up to 12.5 kHz, within 3.5 dB
 * at 16 kHz, toms brighter (test_system_rates), the others duller. A filter for that mean would add
 * 1.7 dB there.
 *
 * Unless wires are thrown off, their filter lifts what strikers excite, too. So strikers' forces
 * then act on the high band as means of two samples, cos(omega k/2), which leaves 1.7 dB too much
 * at 16 kHz and 48 kHz. At the two-way modes of `live` the filter lifts by 0.4 dB or less.
 * Audio-safe. */
#ifndef TB_FORCE_EQUALIZER_H
#define TB_FORCE_EQUALIZER_H

/* `memory` holds x-, y-, y--. */
static inline double tb_force_equalizer(double memory[3], double x) {
  const double b1 = 0.15032, a1 = 1.06685, a2 = 0.25679;
  const double g = (1.0 + a1 + a2) / (1.0 + b1);
  const double y = g * (x + b1 * memory[0]) - a1 * memory[1] - a2 * memory[2];
  memory[0] = x;
  memory[2] = memory[1];
  memory[1] = y;
  return y;
}

/* Passes x on; the filter can take over at any sample. */
static inline double tb_force_equalizer_rest(double memory[3], double x) {
  memory[0] = memory[1] = memory[2] = x;
  return x;
}

#endif
