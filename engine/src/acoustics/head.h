/* SPDX-License-Identifier: MIT */
/* The head, or both heads and the air between them, as a list of modes.
 *
 *   rho w_tt = T lap w - D lap^2 w - sigma0 rho w_t
 *            - sigma_k rho sqrt(-lap) w_t + sigma1 rho lap w_t + air + contacts,
 *   w = 0 at R,
 * [Torin2014] eq. (1)-(2) with the bending stiffness D of Mylar and the loss sigma_k added.
 *
 * In vacuo the modes are J_m(z r/R) {cos, sin}(m theta), omega^2 = (T K^2 + D K^4)/rho, K = z/R,
 * with Int phi^2 dA = a_m R^2 J_{m+1}(z)^2/2 and amplitude decay rate
 * s = (sigma0 + sigma_k K + sigma1 K^2)/2; the term D K^4 takes the edge as simply supported. The
 * operator sqrt(-lap) multiplies the mode of wavenumber K by K. Where sigma_k is the only loss and
 * D = 0, omega = c K, and every mode has the loss factor 2 s/omega = sigma_k/c, c = sqrt(T/rho).
 * That heads lose so is an assumption, made after the decay times of recorded toms
 * (docs/recordings.md), which need a part of the loss that grows in proportion to frequency. It
 * does not follow from a loss factor eta of the sheet's material: tension stores energy without
 * loss, and bending alone would give 2 s = eta D K^4/(rho omega).
 * Air couples the modes of one order m. First,
 *   K v = omega^2 M v
 * is solved with the full same-order added-mass matrix at low frequency. Then each normal mode gets
 * the mass at its own frequency (a Rayleigh quotient, right to second order) and the radiation
 * resistance there. Normal modes are scaled to unit modal mass [1 kg]; a shape value has unit 1. */
#ifndef TB_HEAD_H
#define TB_HEAD_H

#include "acoustics/far_field.h"

#define TB_HEADS 2u
/* Bessel functions of one angular order. Their zeros stay below 248. */
#define TB_MAX_ZEROS 96u
/* Angular orders stay below the largest Bessel zero of the basis. */
#define TB_MAX_ORDERS 256u

/* Modes of one angular order: mode k moves head h upward as
 *   Sum_i vectors[h][k][i] J_m(zeros[i] r/R) + edge[k] (r/R)^m,
 * the bearing edge by edge[k] and the batter's hoop by hoop[k] (rim.h). */
typedef struct TbHeadOrder {
  uint32_t m, zero_count, mode_count;
  uint32_t first_zero; /* index of zeros[0] among all zeros of the head */
  double *zeros, *vectors[TB_HEADS];
  double *edge, *hoop; /* NULL: at rest */
  uint32_t *rows;      /* row of each mode in TbHead.modes, sorted by frequency over all orders */
} TbHeadOrder;

/* A normal mode. Its sine copy for m > 0 has the same row of the list. */
typedef struct TbHeadMode {
  uint32_t m, n;     /* n: Bessel function that moves most, from 1 */
  uint32_t index;    /* among the modes of its order, kept or not, from 0 */
  uint32_t place;    /* among the kept modes of its order */
  uint32_t part;     /* a TaborModePart: the moving part */
  int32_t phase;     /* +1: both heads move the same way, -1: against each other, 0: neither */
  double omega;      /* undamped [rad/s] */
  double decay_rate; /* of the amplitude [1/s]; includes the next two */
  double radiation_rate,
    shell_rate; /* to the air outside; at the walls of the cavity and in the rim */
  double fields[2 * TABOR_MAX_MICS]; /* (re, im) of the air's I at each microphone */
  bool has_far;                      /* far_field.h: */
  double far[2 * TB_FAR_NODES];      /* (re, im) of F */
} TbHeadMode;

/* How large a model may get. About z^2/4 - z/2 modes of one head lie below its Bessel zero z, sine
 * copies counted. */
typedef struct TbHeadLimits {
  uint32_t modes; /* sine copies counted */
  double zero;    /* the largest Bessel zero of a mode, at most TB_TOP_ZERO */
  double rim; /* modes that move mostly the rim are kept up to here, if above the bandwidth [Hz] */
} TbHeadLimits;

/* Above this zero and its margin, orders would exceed TB_MAX_ORDERS. */
#define TB_TOP_ZERO 240.0

typedef struct TbHead {
  uint32_t heads;      /* 1 or 2: batter, resonant */
  uint32_t most_modes; /* TbHeadLimits.modes */
  uint32_t order_count, row_count, zero_count;
  TbHeadOrder *orders;
  TbHeadMode *modes;
  double radius;    /* [m] */
  double bandwidth; /* of the modes kept [Hz] */
} TbHead;

/* The highest Bessel zero of the basis for modes up to `bandwidth` [Hz], and the bandwidth that it holds: of both
 * heads the slower needs more functions, and with the air between them there must be room for all modes. */
double tb_head_basis(const TaborDrumDef *def, double bandwidth, TbHeadLimits limits,
                     double *reached);
/* Prepares the modes up to `bandwidth` [Hz]: fewer if they are too many, none if the lowest lies
 * above `bandwidth`. Returns TABOR_ERROR_MEMORY or TABOR_ERROR_NUMERICS on failure. */
TaborStatus tb_head_prepare(TbHead *head, TbArena *arena, const TaborDrumDef *def, double bandwidth,
                            TbHeadLimits limits);

/* Int |grad w|^2 dA of one mode on head `which`, of its cosine as of its sine copy:
 * Sum_i v_i^2 K_i^2 a_m R^2 J_{m+1}(z_i)^2/2, and a_m m u^2 of the edge (rim.h). */
double tb_head_slope_square(const TbHead *head, uint32_t which, const TbHeadMode *mode);
/* The lowest frequency of a mode that moves more than the rim [rad/s]. */
double tb_head_lowest(const TbHead *head);

/* The public information about a mode. */
TaborModeInfo tb_head_mode_info(const TbHeadMode *mode);

/* Factors 2 J_1(K a)/(K a) for a force spread over a disc of radius a, one per Bessel function:
 * patch[zero_count]. a = 0 gives 1. */
void tb_head_patch(const TbHead *head, double patch_radius, double *patch);

/* Radial shape of every row of modes at distance r [m] on head `which`, relative to the lifted edge
 * and what it lifts: radial[row_count]. `patch` may be NULL. Audio-safe. */
void tb_head_radial(const TbHead *head, uint32_t which, double r, const double *patch,
                    double *radial);

/* Adds the lift: radial[] is then the head's whole motion. A mean over a disc is its value in the
 * middle. Audio-safe. */
void tb_head_add_lift(const TbHead *head, double r, double *radial);

/* Motion of the batter's hoop, radial[row_count]. Audio-safe. */
void tb_head_hoop(const TbHead *head, double *radial);

/* The same as tb_head_radial() from a table of all orders and zeros, within its 3e-11; `patch` is not NULL. Set-up only. */
void tb_head_radial_tabled(const TbHead *head, const TbBesselTable *table, uint32_t which, double r,
                           const double *patch, double *radial);

#endif
