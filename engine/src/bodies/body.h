/* SPDX-License-Identifier: MIT */
/* A resonating thing of revolution, as a list of modes.
 *
 * A body has one or two surfaces that strikers, wires and air touch. In the angular order m, mode k
 * moves surface s upward as
 *   w = (Sum_i v_i J_m(z_i r/R) + e (r/R)^m) {cos, sin}(m theta),  J_m(z_i) = 0,
 * v_i = vectors[s][k][i], e = edge[s][k] the motion of the edge. The sum vanishes at the edge, and
 * its coefficients fall as z_i^-3 where w is smooth, so that both together hold any edge. Normal
 * modes are scaled to unit modal mass [1 kg]; a shape value has unit 1.
 *
 * Everything after the set-up of a body sees this list alone. A kind of body (TbBodyKind) makes the
 * list; one folder below this one is one kind. Set-up only, where nothing else is said. */
#ifndef TB_BODY_H
#define TB_BODY_H

#include "air_model/far_field.h"
#include "bodies/membrane.h"

/* Surfaces of a body, at most: of a drum its two heads, of a hi-hat its two plates. */
#define TB_HEADS 2u
/* Bessel functions of one angular order. Their zeros stay below 248. */
#define TB_MAX_ZEROS 96u
/* Angular orders stay below the largest Bessel zero of the basis. */
#define TB_MAX_ORDERS 256u

/* Modes of one angular order. */
typedef struct TbBodyOrder {
  uint32_t m, zero_count, mode_count;
  uint32_t first_zero; /* index of zeros[0] among all zeros of the body */
  double *zeros, *vectors[TB_HEADS];
  double *edge[TB_HEADS]; /* motion of the edge; NULL: at rest, as for the next */
  double *hoop;           /* of a hoop around it */
  uint32_t *rows; /* row of each mode in TbBody.modes, sorted by frequency over all orders */
} TbBodyOrder;

/* A normal mode. Its sine copy for m > 0 has the same row of the list. */
typedef struct TbBodyMode {
  uint32_t m, n;     /* n: Bessel function that moves most, from 1 */
  uint32_t index;    /* among the modes of its order, kept or not, from 0 */
  uint32_t place;    /* among the kept modes of its order */
  uint32_t part;     /* a TaborModePart: the moving part */
  int32_t phase;     /* +1: both surfaces move the same way, -1: against each other, 0: neither */
  double omega;      /* undamped [rad/s] */
  double split;      /* by which part its copies lie apart: see tb_body_omega() */
  double decay_rate; /* of the amplitude [1/s]; includes the next two */
  double radiation_rate, shell_rate; /* to the air outside; at the walls of a cavity and in a rim */
  double rod; /* force on it by the foot of a plate's mount that rises [N/(m kg^1/2)] */
  double fields[2 * TABOR_MAX_MICS]; /* (re, im) of the air's I at each microphone */
  bool has_far;                      /* far_field.h: */
  double far[2 * TB_FAR_NODES];      /* (re, im) of F */
} TbBodyMode;

/* How large a model may get. About z^2/4 - z/2 modes of one head lie below its Bessel zero z, sine
 * copies counted. */
typedef struct TbBodyLimits {
  uint32_t modes; /* sine copies counted */
  double zero;    /* the largest Bessel zero of a mode, at most TB_TOP_ZERO */
  double rim; /* modes that move mostly the rim are kept up to here, if above the bandwidth [Hz] */
  double coupled; /* modes of a plate with fewer waves than lambda = this in a radius are coupled by
                     large deflections */
} TbBodyLimits;

/* Above this zero and its margin, orders would exceed TB_MAX_ORDERS. */
#define TB_TOP_ZERO 240.0

typedef struct TbBody {
  uint32_t surfaces;   /* 1 or 2 */
  uint32_t most_modes; /* TbBodyLimits.modes */
  uint32_t order_count, row_count, zero_count;
  TbBodyOrder *orders;
  TbBodyMode *modes;
  double radius;    /* [m] */
  double bandwidth; /* of the modes kept [Hz] */
  bool free_edge;   /* the edge is the surface's own, without a hoop; else what lies on a surface
                       moves with the edge */
  TaborHeadDef sheet[TB_HEADS]; /* of each surface: its mass, stiffness, losses, unevenness */
  TbMembrane membrane;          /* of a plate */
} TbBody;

/* ---- a kind of body -------------------------------------------------------------------------- */

/* Cost of the set-up of a body. */
typedef struct TbBodyCost {
  double modes;   /* sine copies counted */
  double resolve; /* processor time of resolve() [s] */
  double prepare; /* of prepare() [s] */
} TbBodyCost;

typedef struct TbBodyKind {
  /* Turns what a definition asks for into what a body is built of: pitches into tensions. Explains
   * what it refuses. */
  TaborStatus (*resolve)(TaborDrumDef *def, const TbArena *beside, TaborError *error);
  /* The same by a formula, right to some per cent. */
  void (*resolve_roughly)(TaborDrumDef *def);
  /* The sheets of a resolved definition's surfaces. */
  void (*sheets)(const TaborDrumDef *def, TaborHeadDef sheet[TB_HEADS]);
  /* The cost of `def`, which is `resolved` roughly, for the basis and the bandwidth of basis(). */
  TbBodyCost (*cost)(const TaborDrumDef *def, const TaborDrumDef *resolved, double basis_top,
                     double bandwidth, uint32_t most_modes);
  /* The highest Bessel zero of the basis for modes up to `bandwidth` [Hz], and the bandwidth that
   * it holds. */
  double (*basis)(const TaborDrumDef *def, double bandwidth, TbBodyLimits limits, double *reached);
  /* Prepares the modes up to `bandwidth` [Hz]: fewer if they are too many, none if the lowest lies
   * above it. Returns TABOR_ERROR_MEMORY or TABOR_ERROR_NUMERICS on failure. */
  TaborStatus (*prepare)(TbBody *body, TbArena *arena, const TaborDrumDef *def, double bandwidth,
                         TbBodyLimits limits);
  bool all_two_way; /* every mode that is heard acts back on contacts; there is no high band */
} TbBodyKind;

/* Appends the modes of `order`, at most `room`, to `modes`; the basis and the table are those of
 * tb_body_build_orders(). Returns TABOR_ERROR_MEMORY or TABOR_ERROR_NUMERICS on failure. */
typedef TaborStatus TbBuildOrder(const void *context, TbArena *arena, TbArena *scratch,
                                 const TbAirOrder *air, TbBodyOrder *order, TbBodyMode *modes,
                                 uint32_t room);

/* Builds the first `orders` orders one by one, as long as they have Bessel functions with zeros up
 * to `basis_top`, and sorts the modes. body->most_modes is set. */
TaborStatus tb_body_build_orders(TbBody *body, TbArena *arena, double basis_top, uint32_t orders,
                                 TbBuildOrder *build, const void *context);

/* The zero of the Bessel function whose waves have this frequency [Hz] on a sheet in air, at most
 * TB_TOP_ZERO. */
double tb_body_wave_zero(const TaborHeadDef *sheet, const TaborAirDef *air, double radius,
                         double frequency);

/* c_i: the Bessel amplitudes of an edge that moves by 1, (r/R)^m = Sum_i c_i J_m(z_i r/R). */
static inline double tb_body_lift(const TbAirOrder *air, uint32_t i) {
  return 2.0 / (air->zeros[i] * air->slopes[i]);
}

/* omega of one copy: an uneven body has two in place of each pair. */
static inline double tb_body_omega(const TbBodyMode *mode, bool sine) {
  return mode->omega * (1.0 + (sine ? 0.5 : -0.5) * mode->split);
}

/* ---- what a model asks of a body ------------------------------------------------------------- */

/* Int |grad w|^2 dA of one mode on surface `which`, of its cosine as of its sine copy:
 * Sum_i v_i^2 K_i^2 a_m R^2 J_{m+1}(z_i)^2/2, and a_m m e^2 of the edge, whose motion is harmonic.
 */
double tb_body_slope_square(const TbBody *body, uint32_t which, const TbBodyMode *mode);
/* w of one mode on surface `which` at distance r from the centre, along cos(m theta). */
double tb_body_shape(const TbBody *body, uint32_t which, const TbBodyMode *mode, double r);
/* Int w dA of one mode on surface `which`: 2 pi R^2 J_1(z_i)/z_i of each Bessel function and pi R^2
 * of the edge for m = 0, else nothing [m^2]. */
double tb_body_volume(const TbBody *body, uint32_t which, const TbBodyMode *mode);
/* The lowest frequency of a mode that moves more than the rim [rad/s]. */
double tb_body_lowest(const TbBody *body);

/* The public information about a mode. */
TaborModeInfo tb_body_mode_info(const TbBodyMode *mode);

/* Factors 2 J_1(K a)/(K a) for a force spread over a disc of radius a, one per Bessel function:
 * patch[zero_count]. a = 0 gives 1. */
void tb_body_patch(const TbBody *body, double patch_radius, double *patch);

/* Radial shape of every row of modes at distance r [m] on surface `which`, relative to the lifted
 * edge and what it lifts: radial[row_count]. `patch` may be NULL. Audio-safe. */
void tb_body_radial(const TbBody *body, uint32_t which, double r, const double *patch,
                    double *radial);

/* Adds the lift: radial[] is then the surface's whole motion. A mean over a disc is its value in
 * the middle. Audio-safe. */
void tb_body_add_lift(const TbBody *body, uint32_t which, double r, double *radial);

/* Motion of the hoop, radial[row_count]. Audio-safe. */
void tb_body_hoop(const TbBody *body, double *radial);

/* The same as tb_body_radial() from a table of all orders and zeros, within its 3e-11; `patch` is
 * not NULL. Set-up only. */
void tb_body_radial_tabled(const TbBody *body, const TbBesselTable *table, uint32_t which, double r,
                           const double *patch, double *radial);

#endif
