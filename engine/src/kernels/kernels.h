/* SPDX-License-Identifier: MIT */
/* The time-consuming loops, compiled once per instruction set and per precision from one source
 * (kernels_tmpl.c): TbKernels in double, TbKernelsF in single precision.
 *
 * Every instruction set computes the same bits. A sum either runs in 8 fixed SIMD lanes that one
 * fixed tree joins, or term by term in ascending order into independent results. Nothing is
 * contracted into fused operations. Lengths are multiples of 8 (only `gemv` takes any n);
 * arrays are aligned to 64 bytes. Audio-safe. */
#ifndef TB_KERNELS_H
#define TB_KERNELS_H

#include <stdbool.h>
#include <stdint.h>

#include "kernels/contact_law.h"
#include "kernels/von_karman.h"
#include "kernels/wire_grid.h"

/* A penetration in single precision above -TB_NEAR may be a contact: rounding shifts gaps of
 * millimetres by less than TB_NEAR. [m] */
#define TB_NEAR 1e-9f

typedef struct TbPair {
  double first, second;
} TbPair;

enum { TB_MODE_PARTS = 13 };

/* Parts of the modes' arrays: part i has size[i] modes from from[i] on, which stretch the heads
 * whose bits are set in heads[i], 0 to 3. The first mixed[i] of them, a multiple of 8, may mix with
 * others: of parts of the same kin, and of those of kin 0. The modes behind them, up to end[i],
 * stretch none. */
typedef struct TbParts {
  uint32_t count, from[TB_MODE_PARTS], size[TB_MODE_PARTS], mixed[TB_MODE_PARTS],
    end[TB_MODE_PARTS], heads[TB_MODE_PARTS], kin[TB_MODE_PARTS];
} TbParts;

/* Modes of one order and copy that mix on the heads that stretch (model/stretch_mixing.h). Rows
 * stand 8 side by side, those of the second head right behind those of the first. */
typedef struct TbMixingBlock {
  uint32_t count;
  const uint32_t *mode; /* [count] */
  const uint8_t *part;  /* [count]: where it stands */
  const double *matrix; /* [heads count/8 rounded up][count][8], the diagonals 0 */
  const float *rounded; /* the same for the kernels in single precision; one of both is NULL */
} TbMixingBlock;

/* Most modes of a block. */
enum { TB_MIXING_MOST = 256 };

typedef struct TbMixing {
  uint32_t heads, count; /* of blocks */
  TbMixingBlock *block;
} TbMixing;

/* Scalars that are quadratic in the modes and so couple them, at most: the stretch of each head
 * (heads/stretch.h). Their forces take part in the solve as a matrix of this rank, which is
 * inverted in closed form. */
#define TB_COUPLINGS 2u

/* Heads that stretch, one or two (stretch.h). A part whose modes stretch one head leaves the
 * other's pull alone. */
typedef struct TbStretching {
  const double *a, *b; /* [modes], as all arrays: of the two-step recursion */
  const double *gain[TB_COUPLINGS], *g, *q, *last; /* q at the present instant */
  const double *mixed[TB_COUPLINGS];               /* G q off G's diagonal */
  double *next;                                    /* read, or written: see the kernels */
  double *pull[TB_COUPLINGS];                      /* out */
  double along[TB_COUPLINGS], own[TB_COUPLINGS][TB_COUPLINGS]; /* out */
} TbStretching;

/* The end of a step of the modes: what heads' stretching adds, what the modes have lost then, by
 * origin, and what one microphone hears of them. */
typedef struct TbModesEnd {
  bool stretched;
  uint32_t origins;                                                   /* 2 or 3 */
  const double *pull[TB_COUPLINGS], *last, *loss[3], *ahead, *behind; /* [modes] */
  double stretch[TB_COUPLINGS], *next; /* next is changed by stretch[h] pull[h] */
  double lost[3];                      /* out */
  TbPair heard;                        /* out */
} TbModesEnd;

/* Consecutive modes of the high band, up to `end`. */
typedef struct TbRingPart {
  uint32_t end;
  bool pushed, held;
} TbRingPart;

/* Sums over the wires' contacts: Sum f, Sum f^2, Sum f s^2. */
typedef struct TbWireContacts {
  double force, square, motion;
} TbWireContacts;

typedef struct TbRingParts {
  uint32_t count;
  TbRingPart part[4];
} TbRingParts;

/* A wire's coefficients for its live values (wires.h). */
typedef struct TbWireCoefficients {
  double tension, damping_0, damping_1; /* in force now */
  double stretch, bend, diffuse;        /* T k^2/(mu h^2), EI k^2/(mu h^4), sigma1 k/h^2 */
  double keep, gain;                    /* 1 - sigma0 k/2, 1/(1 + sigma0 k/2) */
  double compliance;                    /* k^2/(mu h) gain [m/N] */
  double loss_0, loss_1;                /* mu sigma0 h/(4k), mu sigma1/(4kh) [J/m2] */
} TbWireCoefficients;

#define TB_TEMPLATE "kernels/kernels_tmpl.h"
#include "kernels/both.h"

extern const TbKernels tb_kernels_baseline;
extern const TbKernelsF tb_kernels_baselinef;
#ifdef TB_HAVE_AVX2
extern const TbKernels tb_kernels_avx2;
extern const TbKernelsF tb_kernels_avx2f;
#endif
#ifdef TB_HAVE_AVX512
extern const TbKernels tb_kernels_avx512; /* eight floats are one register of AVX2 already */
#endif

#endif
