/* SPDX-License-Identifier: MIT */
#include "model/wires.h"

#include <math.h>
#include <stdio.h>

#include "definition/definition.h"
#include "definition/error.h"
#include "math/portable_math.h"
#include "model/wire_shape.h"

static double smallest_spacing(double tension, double mu, double stiffness, double damping_1,
                               double k) {
  const double a = tension * k * k / mu + 2.0 * damping_1 * k;
  return sqrt(0.5 * (a + sqrt(a * a + 16.0 * stiffness / mu * k * k)));
}

/* Even, so that one node is the midpoint. 0 if the wire is too stiff for two cells. */
static uint32_t cells_of(double length, double spacing, uint32_t most) {
  const double fit = length / (spacing * (1.0 + 1e-9));
  const uint32_t cells = fit > (double)most ? most : (uint32_t)fit;
  return cells & ~1u;
}

static void place(TbWire *wire, const TaborDrumDef *def, const TaborWireDef *own) {
  double sine, cosine;
  tb_sin_cos_degrees(own->angle - def->wires.angle, &sine, &cosine);
  wire->dx = cosine * wire->spacing;
  wire->dy = sine * wire->spacing;
  wire->x = -own->offset * sine;
  wire->y = own->offset * cosine;
}

static bool node_place(const TbWire *wire, uint32_t node, double radius, double *x, double *y) {
  /* Counted from the middle, so that mirror-symmetric nodes get mirror-symmetric places. */
  const double steps = (double)node - 0.5 * (double)wire->cells;
  *x = wire->x + steps * wire->dx;
  *y = wire->y + steps * wire->dy;
  return *x * *x + *y * *y < radius * radius * (1.0 - 1e-9);
}

static TaborStatus wire_prepare(TbWire *wire, const TaborDrumDef *def, uint32_t index, double k,
                                uint32_t most_cells, TaborError *error) {
  TaborWireDef own;
  tb_wire_resolve(def, index, &own);
  const TaborWireDef *set = &def->wire[index];
  const bool lossless = def->quality.losses == 0;
  *wire = (TbWire){.length = own.length,
                   .mass_per_length = own.mass_per_length,
                   .tension = own.tension,
                   .tension_limit = TB_WIRE_TENSION_HEADROOM * own.tension,
                   .bending_stiffness = own.bending_stiffness,
                   .damping_0 = lossless ? 0.0 : own.damping_0,
                   .damping_1 = lossless ? 0.0 : own.damping_1,
                   .damping_1_limit = lossless ? 0.0 : 2.0 * own.damping_1,
                   .rest_offset = own.rest_offset,
                   .contact_stiffness = own.contact_stiffness,
                   .contact_exponent = own.contact_exponent,
                   .contact_loss = lossless ? 0.0 : own.contact_loss,
                   .own_tension = !isnan(set->tension),
                   .own_damping_0 = !isnan(set->damping_0),
                   .own_damping_1 = !isnan(set->damping_1)};
  const double spacing = smallest_spacing(wire->tension_limit, wire->mass_per_length,
                                          wire->bending_stiffness, wire->damping_1_limit, k);
  wire->cells = cells_of(wire->length, spacing, most_cells);
  if (wire->cells < 4) {
    char key[TABOR_NAME_SIZE];
    snprintf(key, sizeof key, "wire.%u", (unsigned)(index + 1));
    return tb_error_set(error, TABOR_ERROR_RANGE, key, NULL, NAN, NAN,
                        "wire %u is too short, light, stiff or tense for the sample rate: its "
                        "length of %g m is below four steps of %g m",
                        (unsigned)(index + 1), own.length, spacing);
  }
  return TABOR_OK;
}

/* Wires of one length get the grid that suits all of them, so that their nodes lie side by side. */
static void align(TbWires *wires) {
  uint32_t fewest[TABOR_MAX_WIRES];
  for (uint32_t w = 0; w < wires->count; w++) {
    fewest[w] = wires->wires[w].cells;
    for (uint32_t other = 0; other < wires->count; other++) {
      const TbWire *o = &wires->wires[other];
      if (o->length == wires->wires[w].length && o->cells < fewest[w]) fewest[w] = o->cells;
    }
  }
  for (uint32_t w = 0; w < wires->count; w++) wires->wires[w].cells = fewest[w];
}

/* Nodes and contact points of a wire with its number of cells. */
static void lay(TbWire *wire, const TaborDrumDef *def, uint32_t index) {
  TaborWireDef own;
  tb_wire_resolve(def, index, &own);
  wire->spacing = wire->length / (double)wire->cells;
  place(wire, def, &own);
  double x, y;
  for (uint32_t node = 1; node < wire->cells; node++) {
    if (!node_place(wire, node, def->shell.radius, &x, &y)) continue;
    if (wire->row_count == 0) wire->row_node = node;
    wire->row_count++; /* a chord crosses the disc once: consecutive nodes */
  }
}

/* Lane of a wire's node 1. */
static uint32_t first_lane(const TbWires *wires, const TbWire *wire) {
  return wires->middle + 1u - wire->cells / 2;
}

static void wire_rows(TbWires *wires, uint32_t w, double radius) {
  TbWire *wire = &wires->wires[w];
  const uint32_t first = w * wires->lanes + first_lane(wires, wire);
  wire->first_node = first + TB_WIRE_FRONT - 1u;
  wire->first_row = first + wire->row_node - 1u;
  for (uint32_t lane = 0; lane < wires->lanes; lane++) {
    const uint32_t row = w * wires->lanes + lane, node = row - first + 1u; /* wraps below node 0 */
    wires->row_wire[row] = (uint8_t)w;
    const double steps = (double)lane - (double)wires->middle;
    wires->row_x[row] = wire->x + steps * wire->dx;
    wires->row_y[row] = wire->y + steps * wire->dy;
    if (node == 0 || node >= wire->cells) continue;
    double x, y;
    wires->inner[row] = 1.0;
    wires->real[row] = node_place(wire, node, radius, &x, &y) ? 1.0 : 0.0;
  }
}

static void bend(TbWires *wires, const TaborWiresDef *def, uint32_t w) {
  const TbWire *wire = &wires->wires[w];
  TbWireShape shape;
  tb_wire_shape_draw(&shape, def, w);
  for (uint32_t row = wire->first_row; row < wire->first_row + wire->row_count; row++) {
    const double steps = (double)(row - w * wires->lanes) - (double)wires->middle;
    wires->shape[row] = tb_wire_shape_height(&shape, steps * wire->spacing);
  }
}

/* How far the lowest point of uneven wires lies below even ones [m]. A wire's own rest offset is no
 * unevenness. */
static double deepest(const TbWires *wires, const TaborDrumDef *def) {
  double depth = 0.0;
  for (uint32_t w = 0; w < wires->count; w++) {
    const TbWire *wire = &wires->wires[w];
    const bool own = !isnan(def->wire[w].rest_offset);
    const double lifted = own ? 0.0 : wire->rest_offset - def->wires.rest_offset;
    for (uint32_t row = wire->first_row; row < wire->first_row + wire->row_count; row++) {
      depth = fmax(depth, -(lifted + wires->shape[row]));
    }
  }
  return depth;
}

TaborStatus tb_wire_rows_prepare(TbWires *wires, TbArena *arena) {
  wires->stride = wires->count * wires->lanes;
  wires->node_count = wires->stride + 2u * TB_WIRE_FRONT;
  wires->row_wire = tb_arena_take(arena, wires->stride, sizeof *wires->row_wire);
  double **arrays[] = {&wires->inner, &wires->real, &wires->row_x, &wires->row_y, &wires->shape};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(arena, wires->stride);
  }
  return arena->failed ? TABOR_ERROR_MEMORY : TABOR_OK;
}

static void find_symmetries(TbWires *wires) {
  wires->mirrored = wires->aligned = wires->balanced = true;
  const TbWire *first = wires->wires;
  for (uint32_t w = 0; w < wires->count; w++) {
    const TbWire *wire = &wires->wires[w], *image = &wires->wires[wires->count - 1 - w];
    wires->mirrored = wires->mirrored && wire->dy == 0.0 && wire->x == 0.0;
    wires->aligned = wires->aligned && wire->cells == first->cells && wire->dx == first->dx;
    wires->balanced = wires->balanced && fabs(wire->y + image->y) <= 1e-12;
  }
  wires->aligned = wires->aligned && wires->mirrored;
  wires->balanced = wires->balanced && wires->aligned && wires->count > 1;
}

TaborStatus tb_wires_prepare(TbWires *wires, TbArena *arena, const TaborDrumDef *def,
                             double time_step, uint32_t most_cells, TaborError *error) {
  const bool above = def->wires.side == TABOR_SIDE_ABOVE;
  *wires = (TbWires){.head = def->wires.head,
                     .count = def->wires.count,
                     .side = above ? 1.0 : -1.0,
                     .gravity = above ? -def->air.gravity : def->air.gravity,
                     .strainer_travel = def->wires.strainer_travel};
  wires->wires = tb_arena_take(arena, wires->count, sizeof *wires->wires);
  wires->laws = tb_arena_take(arena, wires->count, sizeof *wires->laws);
  if (arena->failed) return TABOR_ERROR_MEMORY;
  uint32_t cells = 0;
  for (uint32_t w = 0; w < wires->count; w++) {
    TbWire *wire = &wires->wires[w];
    const TaborStatus status = wire_prepare(wire, def, w, time_step, most_cells, error);
    if (status != TABOR_OK) return status;
    if (wire->cells > cells) cells = wire->cells;
  }
  align(wires);
  for (uint32_t w = 0; w < wires->count; w++) {
    lay(&wires->wires[w], def, w);
    wires->contact_points += wires->wires[w].row_count;
  }
  wires->lanes = tb_pad(cells);
  wires->middle = cells ? cells / 2 - 1u : 0;
  find_symmetries(wires);
  const TaborStatus status = tb_wire_rows_prepare(wires, arena);
  if (status != TABOR_OK) return status;
  for (uint32_t w = 0; w < wires->count; w++) wire_rows(wires, w, def->shell.radius);
  for (uint32_t w = 0; w < wires->count; w++) bend(wires, &def->wires, w);
  wires->strainer_travel += deepest(wires, def);
  return TABOR_OK;
}

void tb_wire_coefficients(const TbWire *wire, double k, double tension, double damping_0,
                          double damping_1, TbWireCoefficients *c) {
  const double mu = wire->mass_per_length, h = wire->spacing;
  const double gain = 1.0 / (1.0 + 0.5 * damping_0 * k);
  *c = (TbWireCoefficients){
    .tension = tension,
    .damping_0 = damping_0,
    .damping_1 = damping_1,
    .stretch = tension * k * k / (mu * h * h),
    .bend = wire->bending_stiffness * k * k / (mu * h * h * h * h),
    .diffuse = damping_1 * k / (h * h),
    .keep = 1.0 - 0.5 * damping_0 * k,
    .gain = gain,
    .compliance = wire->still ? 0.0 : k * k / (mu * h) * gain,
    .loss_0 = mu / (4.0 * k) * damping_0 * h,
    .loss_1 = mu / (4.0 * k) * damping_1 / h,
  };
}

double tb_wire_energy(const TbWire *wire, const TbWireCoefficients *c, double k, const double *next,
                      const double *now) {
  const double mu = wire->mass_per_length, h = wire->spacing;
  const uint32_t cells = wire->cells;
  double kinetic = 0.0, stretch = 0.0, bend = 0.0, diffuse = 0.0;
  for (uint32_t i = 0; i < cells; i++) {
    const double velocity = (next[i] - now[i]) / k;
    const double slope_next = next[i + 1] - next[i], slope_now = now[i + 1] - now[i];
    const double slope_velocity = (slope_next - slope_now) / k;
    kinetic += velocity * velocity;
    stretch += slope_next * slope_now;
    diffuse += slope_velocity * slope_velocity;
    if (i == 0) continue;
    bend += ((next[i - 1] - next[i]) + (next[i + 1] - next[i])) *
            ((now[i - 1] - now[i]) + (now[i + 1] - now[i]));
  }
  return 0.5 * mu * h * kinetic + 0.5 * c->tension / h * stretch +
         0.5 * wire->bending_stiffness / (h * h * h) * bend -
         0.25 * c->damping_1 * mu * k / h * diffuse;
}
