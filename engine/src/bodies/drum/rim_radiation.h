/* SPDX-License-Identifier: MIT */
/* Sound of the rim (rim.h) in free space: of the shell's wall, and of the hoop. The drum's body
 * is no obstacle to it.
 *
 * Wall: while the bearing edge moves upward by u cos(n theta), the wall, radius R, moves outward by
 *   W = -(n^2 x/R) u cos(n theta), x from -l to l above its middle:
 * not at all at mid-height, and oppositely at the two ends. It radiates as a layer of sources of
 * strength W_tt per area:
 *   p = -omega^2 rho0 R I cos(n theta) u,
 *     I = -Int_-l^l Int_0^2pi (n^2 x/R) cos(n t) e^{-i k s}/(4 pi s) dt dx, s the distance,
 * [MorseIngard] chapter 7. The far field takes from the motion the power
 *   P = omega^4 rho0 n^4 pi |u|^2/(8 c0)
 *     Int_0^pi [J_n(k R sin t) Int_-l^l x sin(k x cos t) dx]^2 sin t dt.
 * The wall of an open drum has air on both sides and shifts air from one side to the other; it is
 * taken as silent.
 *
 * Hoop: its section is 2b wide, seen from above, and h high. A strip of width w that moves across
 * its plane drags along air of the mass rho0 pi w^2/4 per length, less where it is not small
 * against the wavelength: at last both sides radiate plane waves, so
 *   m' = rho0 (pi w^2/4)/sqrt(1 + (pi k w/8)^2),
 * and it pushes the air like a ring of dipoles of that mass times its acceleration. While the hoop
 * moves upward by a cos(n theta), its width does so, too, and its wall leans: with the ratio g of
 * torsional to bending stiffness a ring's section turns by n^2 (1 + g)/(1 + n^2 g) a/R, since what
 * turns need bend less. So a thin open section (g -> 0) moves like the edge of a cylinder, n^2, and
 * a closed one (g = 1) hardly at all. Its foot stands on the head's hoop, so the middle of the wall
 * moves outward by
 *   A = -(h/2R) n^2 (1 + g)/(1 + n^2 g) a.
 * Upward, and outward:
 *   I = (m'/rho0) Int_0^2pi cos(n t) (z/s^3) (1 + i k s) e^{-i k s}/(4 pi) dt, z above the ring,
 *   P = (pi/(2 rho0 c0)) (omega^2 m' k R |a|/2)^2 Int_0^pi [cos t J_n(k R sin t)]^2 sin t dt;
 *   I: the same with r cos t - R instead of z, P: with sin t J_n'(k R sin t) in place of cos t J_n,
 * twice these P for n = 0. Their product has no power: one is even in cos t, the other odd.
 *
 * Limits: for k -> 0, P vanishes with k^(2n+6) for the wall, with k^(2n+6) for the hoop's width,
 * k^(2n+2) for its wall; far away the fields are the square roots of what P integrates. Set-up
 * only. */
#ifndef TB_RIM_RADIATION_H
#define TB_RIM_RADIATION_H

#include "bodies/body.h"
#include "bodies/drum/rim.h"

/* The factor I [1] of a wall of `radius` and `depth` = 2l [m], at r, z [m] from the axis and from
 * the upper edge's plane. Wavenumber in [1/m]. */
void tb_wall_field(uint32_t n, double wavenumber, double radius, double depth, double r, double z,
                   double field[2]);

/* r in P = r |omega u|^2/2 [kg/s]. */
double tb_wall_resistance(uint32_t n, double omega, const TaborAirDef *air, double radius,
                          double depth);

typedef enum TbStripMotion { TB_STRIP_UP, TB_STRIP_OUT } TbStripMotion;

/* The same of a strip of this `width` along a circle, which moves upward or outward; z from the
 * circle's plane. */
void tb_strip_field(TbStripMotion motion, uint32_t n, double wavenumber, double radius,
                    double width, double r, double z, double field[2]);
double tb_strip_resistance(TbStripMotion motion, uint32_t n, double omega, const TaborAirDef *air,
                           double radius, double width);

/* A/a: how far the middle of the hoop's wall moves outward while the hoop moves upward. */
double tb_hoop_lean(const TaborDrumDef *def, uint32_t n);

/* Adds the rim's sound to fields and radiation of a mode of unit mass. If the mode has a far field
 * (far_field.h), the radiation is that of the heads' and the rim's sound together; elsewhere as if
 * they radiated apart. */
void tb_rim_radiate(const TbRim *rim, const TaborDrumDef *def, TbRimMotion motion,
                    TbBodyMode *mode);

#endif
