/* SPDX-License-Identifier: MIT */
/* How fast the modes of the high band lose their phase on a head that is not the same everywhere.
 *
 * A head's mass per area deviates by the fraction e(x), of root mean square sigma (the head's
 * unevenness) and correlation <e(x) e(x + r)> = sigma^2 exp(-(r/l)^2), l = 3 cm. On a heavier place
 * of the head a wave of frequency omega is shorter, by dk = omega e/(2 c_g), c_g its group
 * velocity. Over many patches these phases add up as a random walk, whose variance grows by
 * sqrt(pi) l (omega sigma/(2 c_g))^2 per length, and with time at the rate
 *   G = sqrt(pi) l omega^2 sigma^2/(4 c_g)   [rad2/s].
 * So the wave that a stroke has made falls apart as exp(-G t/2). Its energy stays on the head: what
 * one mode loses, others of its frequency give back, since they have as much. A mode therefore
 * keeps its amplitude and walks in phase (air/high_band_step.h).
 *
 * Few of the head's modes, omega_d = 2 pi c_g/(A k) apart (A its area, k the wavenumber), are kept.
 * Once waves are scattered before they could tell these modes apart, G >> omega_d, a mode that is
 * kept stands for all those around it, up to the next one that is kept. Their frequencies spread
 * over W = 2 B/N, of N modes in a band of width B, counted by their loudness: N = (Sum E)^2/Sum
 * E^2. So the rate of the walk is
 *   D = G + W G/(G + omega_d).
 * Air modes walk with the batter head's waves of their frequency.
 *
 * Limits: sigma = 0: no walk. sigma -> infinity: noise in bands as loud as the modes. W <= B/4
 * keeps the bands apart. Not in the model: what scatters at low frequency (lugs do: lug_modes.h),
 * and energy that scattering brings from modes that radiate little to those that radiate more.
 * Set-up only. */
#ifndef TB_SCATTERING_H
#define TB_SCATTERING_H

#include "high_band/high_band_modes.h"

/* G of waves on a head at omega [rad/s]. */
double tb_scattering_rate(const TaborHeadDef *head, const TaborAirDef *air, double omega);

/* Computes D of each mode, sorted by bands as tb_high_modes_thin() returns them. */
void tb_scattering_prepare(const TbHighDrum *drum, TbHighModes *modes);

#endif
