/* SPDX-License-Identifier: MIT */
#include "air_model/far_field.h"

#include <math.h>

#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* Distance in radii: 1/(k s)^2, by which a dipole's p^2 exceeds what goes on, is below 1e-3 from k
 * R = 0.16 on. */
static const double DISTANCE = 200.0;

void tb_far_points(double depth, TbAirPoint *points) {
  double cosines[TB_FAR_NODES], weights[TB_FAR_NODES];
  tb_gauss_rule(TB_FAR_NODES, cosines, weights);
  for (uint32_t i = 0; i < TB_FAR_NODES; i++) {
    points[i] = (TbAirPoint){DISTANCE * sqrt(1.0 - cosines[i] * cosines[i]),
                             DISTANCE * cosines[i] - 0.5 * depth};
  }
}

void tb_far_shares(const TaborAirDef *air, uint32_t m, double *shares) {
  double cosines[TB_FAR_NODES];
  tb_gauss_rule(TB_FAR_NODES, cosines, shares);
  for (uint32_t i = 0; i < TB_FAR_NODES; i++) {
    shares[i] *= (m ? PI : 2.0 * PI) / (air->density * air->sound_speed);
  }
}

/* From the nearest point of a head, as a microphone's delay. */
static double way_to(const TbAirPoint *point, double depth) {
  const double up = fmin(fabs(point->height), fabs(point->height + depth));
  return tb_hypot(up, fmax(0.0, point->radius - 1.0));
}

void tb_far_from_fields(double depth, double x, const double *fields, double *far) {
  TbAirPoint points[TB_FAR_NODES];
  tb_far_points(depth, points);
  for (uint32_t i = 0; i < TB_FAR_NODES; i++) {
    double sine, cosine;
    tb_sin_cos(x * way_to(&points[i], depth), &sine, &cosine);
    const double re = fields[2 * i], im = fields[2 * i + 1];
    far[2 * i] = DISTANCE * (re * cosine - im * sine);
    far[2 * i + 1] = DISTANCE * (re * sine + im * cosine);
  }
}

double tb_far_decay_rate(const TaborAirDef *air, double radius, uint32_t m, double omega,
                         const double *far) {
  const double size = omega * air->density * radius * radius;
  double shares[TB_FAR_NODES], sum = 0.0;
  tb_far_shares(air, m, shares);
  for (uint32_t i = 0; i < TB_FAR_NODES; i++) {
    sum += shares[i] * (far[2 * i] * far[2 * i] + far[2 * i + 1] * far[2 * i + 1]);
  }
  return 0.5 * size * size * sum;
}
