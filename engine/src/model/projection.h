/* SPDX-License-Identifier: MIT */
/* Transfer between modes and the grid under the wires, both ways through the same table:
 *   c_p = Sum_i table_pi q_i, F_i = Sum_p table_pi C_p,
 * class by class (wire_grid.h). */
#ifndef TB_PROJECTION_H
#define TB_PROJECTION_H

#include "kernels/kernels.h"
#include "kernels/precision.h"
#include "model/modes.h"

/* Modes that move one point alone. */
typedef struct TbProjectionRun {
  uint32_t first, modes, point; /* in the group: multiples of 8; of its points */
} TbProjectionRun;

/* One symmetry class: the modes of one group, on the grid points of the same symmetry. */
typedef struct TbProjectionGroup {
  uint32_t first, modes;        /* in the order of TbModes; a multiple of 8 */
  uint32_t first_point, points; /* in a grid vector; a multiple of 8 */
  uint32_t used;                /* points without the padding */
  double *gather;               /* [points/8][modes][8]: to points */
  double *scatter;              /* [modes/8][points][8]: to modes */
  float *gather_rounded;        /* in single precision, or NULL */
  float *scatter_rounded;       /* likewise: see tb_projection_round() */
  uint32_t runs;        /* not 0: each mode moves one point alone, and stands among its like */
  TbProjectionRun *run; /* [runs] */
  double *along;        /* [modes]: how far */
  float *along_rounded; /* in single precision, or NULL */
} TbProjectionGroup;

typedef struct TbProjection {
  TbWireGrid wire_grid;
  TbPrecision precision; /* of the tables */
  uint32_t groups;
  TbProjectionGroup group[4];
} TbProjection;

/* Chooses a grid on which the error of every mode's shape at every contact point is within
 * `tolerance` of the largest shape, and fills the tables. Set `precision` first. */
TaborStatus tb_projection_prepare(TbProjection *projection, TbArena *arena, const TbModes *modes,
                                  const TbBody *body, const TbWires *wires, double tolerance);

/* Rounds both tables alike if `precision` is single, so that forces still do the work that the
 * ledger books. This halves the memory read in every sample; shapes are right to 6e-8. */
bool tb_projection_round(TbProjection *projection, TbArena *arena);

/* Computes grid[size] from modal displacements q[padded]. Audio-safe. */
void tb_project(const TbProjection *projection, const TbKernels *kernels, const double *q,
                double *grid);

/* Computes the same from the modes of `parts` alone, for one or two vectors. Audio-safe. */
void tb_project_parts(const TbProjection *projection, const TbKernels *kernels,
                      const TbParts *parts, uint32_t vectors, double *const q[TB_COUPLINGS],
                      double *const grid[TB_COUPLINGS]);

/* The same of one group with runs, from the first `part` modes alone, in either precision: q and
 * grid begin with the group. Audio-safe. */
void tb_project_runs(const TbProjectionGroup *group, const TbKernels *kernels, uint32_t part,
                     const double *q, double *grid);
void tb_project_runsf(const TbProjectionGroup *group, const TbKernelsF *kernels, uint32_t part,
                      const float *q, double *grid);
/* And back: modal[modes] from the group's part of the grid. Audio-safe. */
void tb_project_run_forces(const TbProjectionGroup *group, const TbKernels *kernels,
                           const double *grid, double *modal);

/* Computes modal forces of the coupled modes, modal[group[groups]], from grid[size]. Audio-safe. */
void tb_project_forces(const TbProjection *projection, const TbKernels *kernels, const double *grid,
                       double *modal);

#endif
