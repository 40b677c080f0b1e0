/* SPDX-License-Identifier: MIT */
#include "bodies/drum/rim.h"

#include <math.h>

#include "bodies/body.h"

static const double PI = 3.14159265358979323846;
static const double POISSON = 0.3; /* of wood along and across, of metal and of film, roughly */

static double azimuth_of(uint32_t n) { return n ? PI : 2.0 * PI; }

static double square(double x) { return x * x; }

/* ---- hoop and edge --------------------------------------------------------------------------- */

static void prepare_hoop(TbRim *rim, const TaborDrumDef *def, uint32_t n) {
  const TaborHoopDef *hoop = &def->hoop;
  const double radius = def->shell.radius, n2 = (double)n * n, azimuth = azimuth_of(n);
  rim->hoop_mass = hoop->mass * azimuth / (2.0 * PI);
  rim->hoop_stiffness = hoop->bending_stiffness / (radius * radius * radius) * azimuth * n2 *
                        square(n2 - 1.0) * hoop->torsion / (1.0 + hoop->torsion * n2);
  rim->tie = rim->hoop_mass * square(2.0 * PI * hoop->tie_frequency);
  rim->hoop_loss = hoop->loss;
  rim->tie_loss = hoop->tie_loss;
}

/* Stiffness of one end's circumference, per W^2. */
static double sheet_stiffness(const TaborHeadDef *head, uint32_t n) {
  const double kappa = (3.0 - POISSON) / (1.0 + POISSON);
  const double a = 0.5 * (1.0 - 1.0 / n), b = 0.5 * (1.0 + 1.0 / n);
  return 2.0 * PI * (1.0 - POISSON) * head->stretch_stiffness *
         ((n + 1.0) * a * a / kappa + (n - 1.0) * b * b);
}

static double shell_stiffness(const TaborDrumDef *def, uint32_t n) {
  if (n < 2) return 0.0;
  const double radius = def->shell.radius, half = 0.5 * def->shell.depth, n2 = (double)n * n;
  const double wall = 2.0 * PI * def->shell.bending_stiffness * half * half * half /
                      (3.0 * radius * square(radius * radius)) * n2 * n2 * square(n2 - 1.0) *
                      (1.0 + 6.0 * (1.0 - POISSON) * square(radius / half) / n2);
  double sheets = sheet_stiffness(&def->batter, n);
  if (def->two_headed) sheets += sheet_stiffness(&def->resonant, n);
  return wall + sheets * square(n2 * half / radius);
}

static void prepare_edge(TbRim *rim, const TaborDrumDef *def, uint32_t n) {
  const TaborShellDef *shell = &def->shell;
  const double n2 = (double)n * n, share = azimuth_of(n) / (2.0 * PI);
  const double tall = square(0.5 * shell->depth / shell->radius) / 3.0;
  rim->edge_mass = shell->mass * share * (1.0 + (n2 * n2 + n2) * tall);
  if (!rim->hoop) rim->edge_mass += def->hoop.mass * share;
  rim->edge_stiffness = shell_stiffness(def, n);
  rim->edge_loss = shell->loss;
  rim->pull = def->batter.tension + (def->two_headed ? def->resonant.tension : 0.0);
  rim->pull *= azimuth_of(n) * n;
  if (n > 1) return;
  const double carried = rim->edge_mass + rim->hoop_mass;
  const double omega = 2.0 * PI * shell->stand_frequency;
  rim->stand = carried * omega * omega;
  rim->resistance = 2.0 * shell->stand_damping * omega * carried;
}

void tb_rim_prepare(TbRim *rim, const TaborDrumDef *def, uint32_t n) {
  *rim = (TbRim){.count = 0};
  if (n >= TB_RIM_ORDERS) return;
  rim->hoop = def->hoop.bending_stiffness > 0.0;
  rim->edge = def->shell.mass > 0.0;
  rim->enclosed = def->two_headed || def->shell.boundary == TABOR_BOUNDARY_CLOSED;
  rim->count = (rim->hoop ? 1u : 0u) + (rim->edge ? 1u : 0u);
  if (rim->hoop) prepare_hoop(rim, def, n);
  if (rim->edge) prepare_edge(rim, def, n);
  const double area = azimuth_of(n) * def->shell.radius * def->shell.radius;
  rim->head_mass[0] = area * def->batter.surface_density;
  rim->head_mass[1] = def->two_headed ? area * def->resonant.surface_density : 0.0;
}

/* ---- matrices -------------------------------------------------------------------------------- */

double tb_rim_lift(const TbAirOrder *air, uint32_t h, uint32_t i) {
  const double lift = tb_body_lift(air, i);
  return h ? -lift : lift;
}

/* Row, column and diagonal of u in a matrix that acts on y: P^T matrix P, P's last column being the
 * lift. */
static void lift_matrix(const TbAirOrder *air, uint32_t heads, uint32_t size, uint32_t edge,
                        double *matrix) {
  double *row = matrix + (size_t)edge * size;
  for (uint32_t h = 0; h < heads; h++) {
    for (uint32_t i = 0; i < air->count; i++) {
      const double lift = tb_rim_lift(air, h, i);
      const double *from = matrix + (size_t)(h * air->count + i) * size;
      for (uint32_t k = 0; k < edge; k++) row[k] += lift * from[k];
    }
  }
  for (uint32_t h = 0; h < heads; h++) {
    for (uint32_t i = 0; i < air->count; i++) {
      row[edge] += tb_rim_lift(air, h, i) * row[h * air->count + i];
    }
  }
}

/* The heads' own stiffness does not act on the lift. */
static void release_lift(const TbAirOrder *air, uint32_t heads, const double *own, double *row,
                         double *diagonal) {
  for (uint32_t h = 0; h < heads; h++) {
    for (uint32_t i = 0; i < air->count; i++) {
      const uint32_t at = h * air->count + i;
      const double lift = tb_rim_lift(air, h, i);
      row[at] -= lift * own[at];
      *diagonal -= lift * lift * own[at];
    }
  }
}

double tb_rim_missing_mass(const TbRim *rim, const TbAirOrder *air, TbRimMotion motion) {
  double part = 1.0 / (2.0 * air->m + 2.0);
  for (uint32_t i = 0; i < air->count; i++) part -= 2.0 / square(air->zeros[i]);
  return (rim->head_mass[0] + rim->head_mass[1]) * part * square(motion.edge);
}

static void assemble_edge(const TbRim *rim, const TbAirOrder *air, uint32_t heads, uint32_t size,
                          const double *own, double *mass, double *stiffness) {
  const uint32_t edge = size - 1u;
  const size_t diagonal = (size_t)edge * size + edge;
  lift_matrix(air, heads, size, edge, mass);
  lift_matrix(air, heads, size, edge, stiffness);
  release_lift(air, heads, own, stiffness + (size_t)edge * size, &stiffness[diagonal]);
  mass[diagonal] += rim->edge_mass + tb_rim_missing_mass(rim, air, (TbRimMotion){.edge = 1.0});
  stiffness[diagonal] += rim->edge_stiffness + rim->stand + rim->pull;
  for (uint32_t k = 0; k < edge; k++) {
    mass[(size_t)k * size + edge] = mass[(size_t)edge * size + k];
    stiffness[(size_t)k * size + edge] = stiffness[(size_t)edge * size + k];
  }
}

void tb_rim_assemble(const TbRim *rim, const TbAirOrder *air, uint32_t heads, uint32_t size,
                     const double *own, double *mass, double *stiffness) {
  const uint32_t edge = size - 1u, hoop = size - rim->count;
  if (rim->edge) assemble_edge(rim, air, heads, size, own, mass, stiffness);
  if (!rim->hoop) return;
  mass[(size_t)hoop * size + hoop] = rim->hoop_mass;
  stiffness[(size_t)hoop * size + hoop] = rim->hoop_stiffness + rim->tie;
  if (!rim->edge) return;
  stiffness[(size_t)edge * size + edge] += rim->tie;
  stiffness[(size_t)hoop * size + edge] = stiffness[(size_t)edge * size + hoop] = -rim->tie;
}

void tb_rim_add_lift(const TbRim *rim, const TbAirOrder *air, uint32_t heads, uint32_t size,
                     double *vector) {
  if (!rim->edge) return;
  for (uint32_t h = 0; h < heads; h++) {
    for (uint32_t i = 0; i < air->count; i++) {
      vector[h * air->count + i] += tb_rim_lift(air, h, i) * vector[size - 1u];
    }
  }
}

/* ---- one mode -------------------------------------------------------------------------------- */

TbRimMotion tb_rim_motion(const TbRim *rim, const double *coordinates) {
  const double edge = rim->edge ? coordinates[rim->count - 1u] : 0.0;
  return (TbRimMotion){rim->hoop ? coordinates[0] : edge, edge};
}

double tb_rim_mass(const TbRim *rim, TbRimMotion motion) {
  return rim->hoop_mass * square(motion.hoop) + rim->edge_mass * square(motion.edge);
}

double tb_rim_stiffness(const TbRim *rim, TbRimMotion motion) {
  return rim->hoop_stiffness * square(motion.hoop) + rim->tie * square(motion.hoop - motion.edge) +
         (rim->edge_stiffness + rim->stand + rim->pull) * square(motion.edge);
}

double tb_rim_decay_rate(const TbRim *rim, TbRimMotion motion, double omega) {
  const double lost = rim->hoop_loss * rim->hoop_stiffness * square(motion.hoop) +
                      rim->edge_loss * rim->edge_stiffness * square(motion.edge) +
                      rim->tie_loss * rim->tie * square(motion.hoop - motion.edge);
  return 0.5 * lost / omega + 0.5 * rim->resistance * square(motion.edge);
}
