/* SPDX-License-Identifier: MIT */
#include "model/rims.h"

#include <math.h>

#include "bodies/plate/plate_profile.h"
#include "math/draw.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

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

/* ---- forces on the plates ------------------------------------------------------------------- */

typedef double ModeAlong(const TbBody *body, uint32_t row);

static TaborStatus mode_force_prepare(TbModeForce *force, TbArena *arena, const TbModes *modes,
                                      const TbBody *body, ModeAlong *along_mode) {
  const uint32_t felt = modes->group[modes->groups];
  *force = (TbModeForce){0};
  force->mode = tb_arena_take(arena, felt, sizeof *force->mode);
  force->along = tb_arena_doubles(arena, modes->padded);
  if (arena->failed) return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < felt; i++) {
    const double along = modes->row[i] == TB_NO_MODE ? 0.0 : along_mode(body, modes->row[i]);
    if (along == 0.0) continue;
    force->mode[force->count++] = i;
    force->along[i] = along;
  }
  return TABOR_OK;
}

static double rod_along(const TbBody *body, uint32_t row) { return body->modes[row].rod; }

TaborStatus tb_rod_prepare(TbModeForce *rod, TbArena *arena, const TbModes *modes,
                           const TbBody *body) {
  return mode_force_prepare(rod, arena, modes, body, rod_along);
}

static double volume_along(const TbBody *body, uint32_t row) {
  const TbBodyMode *mode = &body->modes[row];
  return tb_body_volume(body, 0, mode) - tb_body_volume(body, 1, mode);
}

/* Between a plate at rest and the plane of its edge: -pi Int r^2 w0'(r) dr. */
static double dome(const TaborPlateDef *plate, double radius) {
  enum { PANELS = 8, NODES = PANELS * TB_PANEL };
  double nodes[NODES], weights[NODES], sum = 0.0;
  tb_quadrature(0.0, radius, PANELS, nodes, weights);
  for (uint32_t i = 0; i < NODES; i++) {
    sum -= weights[i] * nodes[i] * nodes[i] * tb_plate_profile(plate, radius, nodes[i]).slope;
  }
  return PI * sum;
}

/* Between closed plates: their domes, and the mean gap of edges that meet where it is least. */
static double closed_volume(const TaborDrumDef *def) {
  const double radius = def->shell.radius;
  const double gap = 0.5 * (def->hihat.tilt + def->hihat.unevenness);
  return dome(&def->plate, radius) + dome(&def->bottom, radius) + PI * radius * radius * gap;
}

TaborStatus tb_hihat_air_prepare(TbHihatAir *air, TbArena *arena, const TaborDrumDef *def,
                                 const TbModes *modes, const TbBody *body) {
  *air = (TbHihatAir){0};
  if (def->body.kind != TABOR_BODY_HIHAT || !(def->air.density > 0.0)) return TABOR_OK;
  const double volume = closed_volume(def);
  if (!(volume > 0.0)) return TABOR_OK;
  air->stiffness = def->air.density * def->air.sound_speed * def->air.sound_speed / volume;
  air->width = 2.0 * PI * def->shell.radius / def->hihat.points;
  const TaborStatus status = mode_force_prepare(&air->volume, arena, modes, body, volume_along);
  if (status != TABOR_OK) return status;
  for (uint32_t i = 0; i < air->volume.count; i++) {
    const uint32_t mode = air->volume.mode[i];
    air->response += modes->g[mode] * air->volume.along[mode] * air->volume.along[mode];
  }
  return TABOR_OK;
}
