/* SPDX-License-Identifier: MIT */
/* The edges of a hi-hat's two plates, which meet, and the rod that holds the upper one.
 *
 * Edges meet at `points` places evenly spaced around them. Each bears the contact law of hihat.*
 * for its length 2 pi R/points of the edge. Its penetration is
 *   eta_j = w_bottom(R, theta_j) - w_top(R, theta_j) - gap_j,
 *   gap_j = tilt (1 - cos theta_j)/2 + unevenness (draw_j + 1)/2,
 * w upward from where both plates' edges would just meet if all were even. The places take the
 * part of wires' contact points in the solve (model/wires.h): a wire that does not move, bent as
 * the gap is. So they have a grid, laws, a rest state, energies and a clearance as wires do.
 *
 * The upper plate bounces on the spring of its mount. When the spring's foot rises by z, the force
 * on mode i is rod_i z (TbBodyMode.rod), which is M omega_heave^2 z on the rigid motion. At rest z
 * is hihat.opening; what the pedal adds later is a force whose work the ledger books
 * (heads/pedal.h).
 *
 * Limit: two rigid plates on soft mounts whose edges touch all around carry the rod's force, in
 * equal parts. */
#ifndef TB_RIMS_H
#define TB_RIMS_H

#include "model/modes.h"
#include "model/wires.h"

/* A force F that acts on some modes by F along_i. */
typedef struct TbModeForce {
  uint32_t count;
  uint32_t *mode; /* [count] */
  double *along;  /* [modes padded] */
} TbModeForce;

/* The air between the plates (heads/hihat_air.h). Its volume changes by Sum_i along_i q_i, which is
 * Int (w_top - w_bottom) dA; the pressure is a force along it. */
typedef struct TbHihatAir {
  TbModeForce volume; /* along_i [m^2/kg^1/2] */
  double stiffness;   /* rho c^2/V, V the volume between closed plates [Pa/m^3]; 0: no air */
  double response;    /* Sum_i g_i along_i^2: by which a pressure changes the volume in a step */
  double width;       /* 2 pi R/points: what each place has of the edges [m] */
} TbHihatAir;

/* Prepares what the body touches: a hi-hat's edges in the room of a wire, or a drum's wires.
 * Returns what tb_wires_prepare() returns. */
TaborStatus tb_rims_or_wires_prepare(TbWires *wires, TbArena *arena, const TaborDrumDef *def,
                                     double time_step, uint32_t most_cells, TaborError *error);

/* Prepares the rod, whose force is along TbBodyMode.rod, for modes that the edges feel; without a
 * hi-hat, an empty one. */
TaborStatus tb_rod_prepare(TbModeForce *rod, TbArena *arena, const TbModes *modes,
                           const TbBody *body);

/* Prepares the air between a hi-hat's plates; an empty one without a hi-hat, or without air. */
TaborStatus tb_hihat_air_prepare(TbHihatAir *air, TbArena *arena, const TaborDrumDef *def,
                                 const TbModes *modes, const TbBody *body);

#endif
