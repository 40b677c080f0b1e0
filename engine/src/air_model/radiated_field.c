/* SPDX-License-Identifier: MIT */
#include "air_model/radiated_field.h"

#include <math.h>

#include "air_model/multipoles.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;
static const double FAR = 2.0;            /* radii from the centre */
static const double DECADE = 2.302585093; /* ln 10 */

static double outward_height(const TbAirSource *source, TbAirPoint point) {
  return source->up * (point.height - source->plane);
}

/* The wavenumber at which W has faded. */
static double smooth_top(const TbAirPlan *plan) {
  const double beyond = fmax(plan->x, plan->zero);
  return plan->precision.digits > 8.0 ? fmax(60.0, 4.0 * beyond) : 1.5 * beyond + 10.0;
}

static bool is_far(double radius, double height) { return tb_hypot(radius, height) >= FAR; }

double tb_air_heard_to(double reach, double digits) {
  return reach + 0.25 * digits * (2.5 * tb_cbrt(reach) + 5.0);
}

/* A near point hears the wavenumbers that reach it, J_m(k) J_m(k r) of them; a far one what
 * radiates, and what has not fallen like s^-m yet. */
static bool is_heard(const TbAirPlan *plan, double radius, double height) {
  const double m = (double)plan->order->m, digits = plan->precision.digits;
  if (is_far(radius, height)) {
    return m * tb_log(tb_hypot(radius, height)) < DECADE * digits ||
           m < tb_air_heard_to(plan->x, digits);
  }
  const double top = fmin(smooth_top(plan), DECADE * digits / height);
  return m < tb_air_heard_to(tb_hypot(plan->x, top) * fmin(1.0, radius), digits);
}

/* Beyond both x and m the terms fall at least like s^-n, and as J_n does past its turning point. */
static uint32_t degrees_for(const TbAirPlan *plan, double nearest) {
  const double lead = fmax(plan->x, (double)plan->order->m);
  const double fall = fmax(DECADE / tb_log(nearest), tb_cbrt(plan->x));
  return (uint32_t)(lead + plan->precision.digits * fall) + 2u;
}

void tb_air_plan_fields(TbAirPlan *plan, const TbAirSource *sources, uint32_t source_count) {
  double lowest = INFINITY, nearest = INFINITY;
  plan->stretch = 0.0;
  for (uint32_t p = 0; p < plan->point_count; p++) {
    for (uint32_t s = 0; s < source_count; s++) {
      const double radius = plan->points[p].radius;
      const double height = fabs(outward_height(&sources[s], plan->points[p]));
      if (!is_heard(plan, radius, height)) continue;
      if (is_far(radius, height)) {
        nearest = fmin(nearest, tb_hypot(radius, height));
      } else {
        plan->stretch = fmax(plan->stretch, 1.0 + radius + height);
        lowest = fmin(lowest, height);
      }
    }
  }
  plan->top =
    plan->stretch > 0.0 ? fmin(smooth_top(plan), plan->precision.digits * DECADE / lowest) : 0.0;
  plan->degrees = isfinite(nearest) ? degrees_for(plan, nearest) : 0;
}

/* Along t, kappa = x sin t, phases advance most quickly at t = 0: the panels are even, and as short
 * as that asks. */
double tb_air_plan_turns(const TbAirPlan *plan) {
  const double own = 0.5 * PI * plan->x * fmax(2.0, plan->stretch);
  if (plan->degrees == 0 || !tb_multipoles_project(plan)) return own;
  return fmax(own, 1.3 * (plan->x + 0.5 * PI * plan->degrees)); /* rounding alone may be left */
}

/* One head's integrand without J_m(k r) and e^{-gamma h}; measures as in wavenumber_quadrature.h.
 */
static void integrand(const TbWavenumberNodes *nodes, const TbAirSource *source, double baffled,
                      double open, uint32_t q, double *re, double *im) {
  const double weight = nodes->weights[q], kappa = nodes->kappa[q], root = nodes->root[q];
  const bool below = q < nodes->below;
  *re = *im = 0.0;
  if (baffled != 0.0 && below) { /* k dk/gamma = -i k dt; weights hold x dt */
    *im = -baffled * weight * source->w[q] * kappa / nodes->x;
  } else if (baffled != 0.0) { /* k dk/gamma = dt */
    *re = baffled * weight * source->w[q];
  }
  if (open == 0.0) return;
  const double measure = open * weight * root * (below ? kappa / nodes->x : 1.0); /* k dk */
  *re += measure * source->p[2 * q];
  *im += measure * source->p[2 * q + 1];
}

/* Factors of the integrands at one point and the nodes. */
typedef struct Near {
  double *j;                     /* J_m(kappa r) */
  double *phase, *sine, *cosine; /* below x: root |h| */
} Near;

/* Adds the integrals at one point. */
static void add_near(const TbAirPlan *plan, const TbWavenumberNodes *nodes,
                     const TbAirSource *source, double height, const Near *near, double *field) {
  const double sign = height < 0.0 ? -1.0 : 1.0, h = fabs(height);
  const double baffled = source->mirrored ? sign * source->baffled : source->baffled;
  const double cut = plan->precision.digits * DECADE;
  const double *j = near->j, *s = near->sine, *c = near->cosine; /* e^{-i root h} */
  double sum_re = 0.0, sum_im = 0.0, re, im;
  for (uint32_t q = 0; q < nodes->below; q++) near->phase[q] = nodes->root[q] * h;
  tb_sin_cos_array(nodes->below, near->phase, near->sine, near->cosine);
  for (uint32_t q = 0; q < nodes->below; q++) {
    integrand(nodes, source, baffled, sign * source->open, q, &re, &im);
    sum_re += j[q] * (re * c[q] + im * s[q]);
    sum_im += j[q] * (im * c[q] - re * s[q]);
  }
  for (uint32_t q = nodes->below; q < nodes->count; q++) {
    const double decay = nodes->root[q] * h;
    if (decay >= cut) break;
    integrand(nodes, source, baffled, sign * source->open, q, &re, &im);
    const double size = j[q] * tb_exp(-decay);
    sum_re += size * re;
    sum_im += size * im;
  }
  field[0] += sum_re;
  field[1] += sum_im;
}

static bool add_near_points(const TbAirPlan *plan, TbArena *scratch, const TbWavenumberNodes *nodes,
                            const TbAirSource *sources, uint32_t source_count, double *fields) {
  const Near near = {.j = tb_arena_doubles(scratch, nodes->count),
                     .phase = tb_arena_doubles(scratch, nodes->below),
                     .sine = tb_arena_doubles(scratch, nodes->below),
                     .cosine = tb_arena_doubles(scratch, nodes->below)};
  if (scratch->failed) return false;
  for (uint32_t p = 0; p < plan->point_count; p++) {
    const double radius = plan->points[p].radius;
    bool known = false;
    for (uint32_t s = 0; s < source_count; s++) {
      const double height = outward_height(&sources[s], plan->points[p]);
      if (is_far(radius, height) || !is_heard(plan, radius, fabs(height))) continue;
      if (!known) {
        tb_bessel_table_values(plan->order->table, plan->order->m, nodes->count, radius,
                               nodes->kappa, near.j);
      }
      known = true;
      add_near(plan, nodes, &sources[s], height, &near, fields + 2 * p);
    }
  }
  return true;
}

static bool add_far_points(const TbAirPlan *plan, TbArena *scratch, const TbWavenumberNodes *nodes,
                           const TbAirSource *source, double *fields) {
  TbMultipoles waves;
  if (!tb_multipoles_prepare(&waves, plan, scratch, nodes, source)) return false;
  for (uint32_t p = 0; p < plan->point_count; p++) {
    const double radius = plan->points[p].radius;
    const double height = outward_height(source, plan->points[p]);
    if (!is_far(radius, height) || !is_heard(plan, radius, fabs(height))) continue;
    double field[2];
    tb_multipoles_at(&waves, radius, height, field);
    const double sign = source->mirrored && height < 0.0 ? -1.0 : 1.0;
    fields[2 * p] += sign * field[0];
    fields[2 * p + 1] += sign * field[1];
  }
  return true;
}

bool tb_air_fields(const TbAirPlan *plan, TbArena *scratch, const TbWavenumberNodes *nodes,
                   const TbAirSource *sources, uint32_t source_count, double *fields) {
  for (uint32_t i = 0; i < 2 * plan->point_count; i++) fields[i] = 0.0;
  if (plan->stretch > 0.0 &&
      !add_near_points(plan, scratch, nodes, sources, source_count, fields)) {
    return false;
  }
  for (uint32_t s = 0; s < source_count && plan->degrees; s++) {
    if (!add_far_points(plan, scratch, nodes, &sources[s], fields)) return false;
  }
  return true;
}
