/* SPDX-License-Identifier: MIT */
/* A drum as a body: its head, or both heads and the air between them, with the rim.
 *
 *   rho w_tt = T lap w - D lap^2 w - sigma0 rho w_t
 *            - sigma_k rho sqrt(-lap) w_t + sigma1 rho lap w_t + air + contacts,
 *   w = 0 at R,
 * [Torin2014] eq. (1)-(2) with the bending stiffness D of Mylar and the loss sigma_k added.
 *
 * In vacuo the modes are J_m(z r/R) {cos, sin}(m theta), omega^2 = (T K^2 + D K^4)/rho, K = z/R,
 * with Int phi^2 dA = a_m R^2 J_{m+1}(z)^2/2 and amplitude decay rate s = (sigma0 + sigma_k K +
 * sigma1 K^2)/2; the term D K^4 takes the edge as simply supported. The operator sqrt(-lap)
 * multiplies the mode of wavenumber K by K. If sigma_k is the only loss and D = 0, omega = c K, and
 * every mode has the loss factor 2 s/omega = sigma_k/c, c = sqrt(T/rho). That heads lose so is an
 * assumption, made after the decay times of recorded toms (docs/recordings.md), which need a part
 * of the loss that grows in proportion to frequency. It does not follow from a loss factor eta of
 * the sheet's material: tension stores energy without loss, and bending alone would give 2 s = eta
 * D K^4/(rho omega). Air couples the modes of one order m. First,
 *   K v = omega^2 M v
 * is solved with the full same-order added-mass matrix at low frequency. Then each normal mode gets
 * the mass at its own frequency (a Rayleigh quotient, right to second order) and the radiation
 * resistance there. The edge moves by e (r/R)^m (rim.h). Set-up only. */
#ifndef TB_DRUM_MODES_H
#define TB_DRUM_MODES_H

#include "bodies/body.h"

extern const TbBodyKind tb_body_drum;

/* The basis of a drum, see TbBodyKind: of both heads the slower needs more functions, and with the
 * air between them there must be room for all modes. */
double tb_drum_basis(const TaborDrumDef *def, double bandwidth, TbBodyLimits limits,
                     double *reached);

#endif
