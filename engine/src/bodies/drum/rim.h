/* SPDX-License-Identifier: MIT */
/* The rim of a drum in one angular order n: bearing edge and hoop, which move with the heads.
 *
 * Two coordinates, upward as cos(n theta): u of the bearing edge, which both heads share, and a of
 * the batter's hoop. A head that outward is up (s = +1, the lower head: s = -1) moves outward by
 *   w = Sum_i v_i J_n(z_i r/R) + s u (r/R)^n,
 * v_i on a fixed edge, (r/R)^n the static shape under a lifted edge. The lift is harmonic, so its
 * stiffness T a_n n u^2 has no cross term with v, a_0 = 2 pi, a_n = pi. Its Bessel series is
 *   (r/R)^n = Sum_i c_i J_n(z_i r/R), c_i = 2/(z_i J_{n+1}(z_i)),
 * so the heads' mass and all air act on y_i = v_i + s c_i u, and to the mass of u comes what the
 * truncated series misses, rho a_n R^2 (1/(2n + 2) - Sum_i 2/z_i^2).
 *
 * Hoop: mass m a_n/(2 pi), m the hoop's, and as a ring of the bending stiffness EI and the
 * torsional stiffness g EI, whose section turns as it costs least (rim_radiation.h), the stiffness
 *   (EI/R^3) a_n n^2 (n^2-1)^2 g/(1 + g n^2),
 * g = 1: [Rayleigh1877].
 * Rods, lugs and the head's collar tie it to the edge with the stiffness (mass of the hoop)
 * (2 pi f_t)^2. A hoop without stiffness of its own (EI = 0) moves with the edge: a = u.
 *
 * Edge: a cylinder of height 2l, mass M and bending stiffness D = E h^3/(12 (1 - nu^2)) that bends
 * without stretching [Rayleigh1877]. With x the height above its middle it moves
 *   upward by u cos, along its circumference by (n x/R) u sin, outward by W = -(n^2 x/R) u cos,
 * which for n = 0 and 1 are a rigid body's shift and tilt. Hence
 *   mass (M a_n/(2 pi)) (1 + (n^4 + n^2) l^2/(3 R^2)),
 *   stiffness (2 pi D l^3/(3 R^5)) n^4 (n^2-1)^2 (1 + 6 (1 - nu) R^2/(n^2 l^2)), nu = 0.3.
 * The heads' sheets hold the ends' circumference in shape: a plane disc of Young's modulus E' and
 * thickness h' that is deformed along its edge by W cos, -(W/n) sin has, S = E' h'/(1 - nu^2) being
 * the head's stretch stiffness, the stiffness
 *   2 pi (1 - nu) S [(n+1) A^2/kappa + (n-1) B^2], A = (1 - 1/n)/2, B = (1 + 1/n)/2,
 *   kappa = (3 - nu)/(1 + nu), per W^2.
 * A stand holds shift and tilt with a spring and a damper.
 *
 * Losses: a mode of unit mass at omega decays by
 *   (1/(2 omega)) (eta_h K_h a^2 + eta_s K_s u^2 + eta_t K_t (a - u)^2) + C u^2/2,
 * C the stand's damper.
 *
 * Limits: a rim of infinite mass is a fixed edge; the bare hoop and the bare shell have Rayleigh's
 * frequencies; n = 1 has no stiffness of its own. Set-up only. */
#ifndef TB_RIM_H
#define TB_RIM_H

#include "air_model/air.h"

/* Orders from here on have a rim at rest. */
#define TB_RIM_ORDERS 10u

typedef struct TbRim {
  uint32_t count; /* coordinates: a if the hoop moves by itself, then u if the shell moves */
  bool hoop, edge;
  bool enclosed;                                           /* the shell has air of its own inside */
  double hoop_mass, edge_mass;                             /* [kg] */
  double hoop_stiffness, edge_stiffness, tie, stand, pull; /* K_h, K_s, K_t; T a_n n [N/m] */
  double hoop_loss, edge_loss, tie_loss, resistance;       /* eta; C [kg/s] */
  double head_mass[2];                                     /* rho a_n R^2 of each head [kg] */
} TbRim;

/* Modes are kept up to `heads` [rad/s], and up to `rim`, which is no lower, if the rim has over
 * half of their kinetic energy. */
typedef struct TbModeLimits {
  double heads, rim;
} TbModeLimits;

/* True for a mode at omega, of unit mass, of which the rim has the part `rim_mass`. */
static inline bool tb_rim_keeps(TbModeLimits limit, double omega, double rim_mass) {
  return omega <= limit.heads || (omega <= limit.rim && rim_mass > 0.5);
}

/* The rim of order n of the drum; without coordinates if neither hoop nor shell moves. */
void tb_rim_prepare(TbRim *rim, const TaborDrumDef *def, uint32_t n);

/* Part of y_i on head `h` that is due to u = 1: s c_i. */
double tb_rim_lift(const TbAirOrder *air, uint32_t h, uint32_t i);

/* Fills the last rim->count rows and columns of the matrices [size][size] of one order, whose
 * coordinates are the outward amplitudes of `heads` heads and others. `own`[heads * count] is the
 * heads' own stiffness, which acts on v. The eigenvectors are then (v, others, a, u). */
void tb_rim_assemble(const TbRim *rim, const TbAirOrder *air, uint32_t heads, uint32_t size,
                     const double *own, double *mass, double *stiffness);

/* Turns v of an eigenvector into y. */
void tb_rim_add_lift(const TbRim *rim, const TbAirOrder *air, uint32_t heads, uint32_t size,
                     double *vector);

/* Amplitudes of hoop and edge in the last rim->count coordinates; 0 for a rim at rest. */
typedef struct TbRimMotion {
  double hoop, edge;
} TbRimMotion;
TbRimMotion tb_rim_motion(const TbRim *rim, const double *coordinates);

/* Kinetic mass, without the heads', and stiffness of a motion. */
double tb_rim_mass(const TbRim *rim, TbRimMotion motion);
double tb_rim_stiffness(const TbRim *rim, TbRimMotion motion);

/* Mass that the truncated lift misses. */
double tb_rim_missing_mass(const TbRim *rim, const TbAirOrder *air, TbRimMotion motion);

/* Decay rate of a mode of unit mass. */
double tb_rim_decay_rate(const TbRim *rim, TbRimMotion motion, double omega);

#endif
