/* SPDX-License-Identifier: MIT */
#include "model/rims.h"

#include <math.h>

#include "math/draw.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

/* A wire whose nodes are the places, and stay. */
static TbWire edge_of(const TaborDrumDef *def) {
  const TaborHihatDef *hihat = &def->hihat;
  const double around = 2.0 * PI * def->shell.radius;
  return (TbWire){.still = true,
                  .cells = hihat->points + 1u,
                  .first_node = TB_WIRE_FRONT - 1u,
                  .row_count = hihat->points,
                  .row_node = 1u,
                  .length = around,
                  .spacing = around / hihat->points,
                  .mass_per_length = 1.0, /* of no effect, as nothing of it moves */
                  .contact_stiffness = hihat->contact_stiffness,
                  .contact_exponent = hihat->contact_exponent,
                  .contact_loss = def->quality.losses ? hihat->contact_loss : 0.0,
                  .own_tension = true,
                  .own_damping_0 = true,
                  .own_damping_1 = true};
}

static void place(TbWires *wires, const TaborDrumDef *def, uint32_t row) {
  const TaborHihatDef *hihat = &def->hihat;
  double sine, cosine;
  tb_sin_cos_degrees(360.0 * row / hihat->points, &sine, &cosine);
  wires->real[row] = 1.0;
  wires->row_x[row] = def->shell.radius * cosine;
  wires->row_y[row] = def->shell.radius * sine;
  wires->shape[row] = 0.5 * hihat->tilt * (1.0 - cosine) +
                      0.5 * hihat->unevenness * (1.0 + tb_draw(hihat->seed, row));
}

static TaborStatus rims_prepare(TbWires *wires, TbArena *arena, const TaborDrumDef *def) {
  const uint32_t points = def->hihat.points;
  *wires = (TbWires){.rims = true,
                     .count = 1u,
                     .lanes = tb_pad(points),
                     .contact_points = points,
                     .middle = points / 2u,
                     .side = 1.0};
  wires->wires = tb_arena_take(arena, 1u, sizeof *wires->wires);
  wires->laws = tb_arena_take(arena, 1u, sizeof *wires->laws);
  const TaborStatus status = tb_wire_rows_prepare(wires, arena);
  if (status != TABOR_OK) return status;
  wires->wires[0] = edge_of(def);
  for (uint32_t row = 0; row < points; row++) place(wires, def, row);
  return TABOR_OK;
}

TaborStatus tb_rims_or_wires_prepare(TbWires *wires, TbArena *arena, const TaborDrumDef *def,
                                     double time_step, uint32_t most_cells, TaborError *error) {
  if (def->body.kind == TABOR_BODY_HIHAT) return rims_prepare(wires, arena, def);
  return tb_wires_prepare(wires, arena, def, time_step, most_cells, error);
}

TaborStatus tb_rod_prepare(TbRod *rod, TbArena *arena, const TbModes *modes, const TbBody *body) {
  const uint32_t felt = modes->group[modes->groups];
  *rod = (TbRod){0};
  rod->mode = tb_arena_take(arena, felt, sizeof *rod->mode);
  rod->push = tb_arena_doubles(arena, modes->padded);
  if (arena->failed) return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < felt; i++) {
    if (modes->row[i] == TB_NO_MODE || body->modes[modes->row[i]].rod == 0.0) continue;
    rod->mode[rod->count++] = i;
    rod->push[i] = body->modes[modes->row[i]].rod;
  }
  return TABOR_OK;
}
