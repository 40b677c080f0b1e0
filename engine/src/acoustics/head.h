/* SPDX-License-Identifier: MIT */
/* The head, or both heads and the air between them, as a list of modes.
 *
 * rho w_tt = T lap w - D lap^2 w - sigma0 rho w_t + sigma1 rho lap w_t + air + contacts, w = 0 at R,
 * [Torin2014] eq. (1)-(2) with the bending stiffness D of Mylar added.
 *
 * In vacuo the modes are J_m(z r/R) {cos, sin}(m theta), omega^2 = (T K^2 + D K^4)/rho, K = z/R, with
 * Int phi^2 dA = a_m R^2 J_{m+1}(z)^2/2 and amplitude decay rate (sigma0 + sigma1 K^2)/2; D K^4 takes
 * the edge as simply supported. Air couples the modes of one order m: K v = omega^2 M v with the full
 * same-order added-mass matrix at low frequency, then the mass of each normal mode at its own
 * frequency (a Rayleigh quotient, right to second order) and its radiation resistance there.
 * Normal modes are scaled to unit modal mass [1 kg]; a shape value has the unit 1. */
#ifndef TB_HEAD_H
#define TB_HEAD_H

#include "acoustics/air.h"

/* Two-way modes of one head are at most 2048. */
#define TB_MAX_MODES 4096u
#define TB_HEADS 2u
/* Bessel functions of one angular order; their zeros stay below 100. */
#define TB_MAX_ZEROS 64u
/* Angular orders stay below the largest Bessel zero of the basis. */
#define TB_MAX_ORDERS 256u

/* Modes of one angular order: mode k moves head h as Sum_i vectors[h][k][i] J_m(zeros[i] r/R), upward. */
typedef struct TbHeadOrder {
  uint32_t m, zero_count, mode_count;
  uint32_t first_zero; /* index of zeros[0] among all zeros of the head */
  double *zeros, *vectors[TB_HEADS];
  uint32_t *rows; /* row of each mode, sorted by frequency over all orders */
} TbHeadOrder;

/* A normal mode; its sine copy for m > 0 is the same row. */
typedef struct TbHeadMode {
  uint32_t m, n;     /* n: of the Bessel function that moves most, from 1 */
  uint32_t index;    /* among the modes of its order, kept or not, from 0 */
  uint32_t place;    /* among those of its order that were kept */
  uint32_t part;     /* a TaborModePart: what moves */
  int32_t phase;     /* +1: both heads move the same way, -1: against each other, 0 */
  double omega;      /* undamped [rad/s] */
  double decay_rate; /* of the amplitude [1/s]; the next two are parts of it */
  double radiation_rate, shell_rate; /* to the air outside; at the walls of the cavity */
  double fields[2 * TABOR_MAX_MICS]; /* (re, im) of the air's I at each microphone */
} TbHeadMode;

typedef struct TbHead {
  uint32_t heads; /* 1 or 2: batter, resonant */
  uint32_t order_count, row_count, zero_count;
  TbHeadOrder *orders;
  TbHeadMode *modes;
  double radius;    /* [m] */
  double bandwidth; /* of the modes kept [Hz] */
} TbHead;

/* Modes up to `bandwidth` [Hz], fewer if they are too many, none if the lowest lies above it.
 * TABOR_ERROR_MEMORY or _NUMERICS. */
TaborStatus tb_head_prepare(TbHead *head, TbArena *arena, const TaborDrumDef *def,
                            double bandwidth);

/* What a user may know of a mode. */
TaborModeInfo tb_head_mode_info(const TbHeadMode *mode);

/* Factors 2 J_1(K a)/(K a) by which a force spread over a disc of radius a drives each Bessel
 * function: patch[zero_count]. a = 0 gives 1. */
void tb_head_patch(const TbHead *head, double patch_radius, double *patch);

/* Radial shape of every row at distance r [m] on head `which`: radial[row_count]. patch may be NULL.
 * Audio-safe. */
void tb_head_radial(const TbHead *head, uint32_t which, double r, const double *patch,
                    double *radial);

#endif
