/* SPDX-License-Identifier: MIT */
#include "bodies/drum/closed_drum_modes.h"

#include <math.h>
#include <string.h>

#include "bodies/drum/cavity_pressure.h"
#include "bodies/drum/rim_radiation.h"
#include "bodies/felt_ring.h"
#include "bodies/sheet_waves.h"
#include "definition/definition.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

/* Cavity modes are kept as coordinates up to this many times the frequency of the slower head's
 * first mode in vacuo: those of its modes that feel the cavity are then right to 0.2 %. */
static const double COORDINATES = 24.0;
/* Between two heads they are kept at least to this many times the highest frequency of all modes:
 * air that rings up to somewhere below would end there with an edge that is seen and heard. A
 * kettle is a bowl, not the cylinder that stands for it here, and its higher modes are not those of
 * one. */
static const double MARGIN = 1.1;
/* Bessel functions of the cavity beyond this many times the heads' last one carry no mass. */
static const double CAVITY_BASIS = 2.0;
/* A mode of which less than this part of the energy moves a head or the rim is not heard or felt.
 */
static const double LEAST_MOVED = 1e-4;
/* One head's mode: the other has less than this part of the heads' energy. */
static const double ONE_HEAD = 0.1;

/* From this part of the shell's largest x on, its loads pass into those of air.h. */
static const double BLEND_FROM = 0.9;
/* A mode's frequency and the load at it agree when a pass changes the frequency by less than this.
 */
static const double SETTLED = 2e-3;
/* Another mode that comes in with less than this of the mass changes nothing that matters. */
static const double LEAST_MIXED = 1e-6;
enum { MOST_PASSES = 3 };

typedef struct Enclosed {
  const TaborDrumDef *def;
  TbCavityEigen drum;
  const TbAirOrder *air;
  TbShellOrder outside; /* without a shell: of a high order */
  TbCavityOrder cavity;
  TbCavityMics inside;
  double azimuth;                /* a_m */
  const double *rings[TB_HEADS]; /* loss of felt rings: see felt_ring.h */
} Enclosed;

/* Speed of sound along a shell's wall [m/s], sqrt(E/rho): 8.5 GPa and 700 kg/m3 of plywood. Metal
 * has 5000. */
static const double WALL_SPEED = 3500.0;

/* Specific admittance beta_m (cavity.h) of the shell's wall, of surface density mu, to the enclosed
 * air. A limp wall has the impedance i omega mu, and behind it rho0 c0 of the air outside; the
 * admittance is the real part of the inverse, rho0 c0 in units of it: beta_m = 1/(1 + (omega
 * mu/(rho0 c0))^2), the mass law [Kinsler]. 6 mm of plywood, 4.2 kg/m2, has 3.9e-3 at 250 Hz
 * and 2.4e-4 at 1 kHz. (A panel that absorbs 0.05 of the sound in a room has 6.3e-3.) A pressure
 * that is the same all round, m = 0, stretches the wall, which withstands it like a hoop: below the
 * ring frequency omega_r = WALL_SPEED/R the impedance is (omega_r/omega)^2 - 1 times as large. A
 * kettle, which is curved both ways, is rigid here. */
static double wall_admittance(const TaborDrumDef *def, uint32_t m, double omega) {
  if (!tb_is_two_headed(def) || def->air.density == 0.0) return 0.0;
  const double ring = WALL_SPEED / (def->shell.radius * omega);
  const double stiffer = m == 0 ? fmax(1.0, ring * ring - 1.0) : 1.0;
  const double ratio =
    stiffer * omega * def->shell.surface_density / (def->air.density * def->air.sound_speed);
  return 1.0 / (1.0 + ratio * ratio);
}

/* A lining's absorption has fallen to a half here [rad/s]: a porous layer absorbs little while it
 * is thinner than a quarter of a wavelength, 10 cm at 860 Hz [Kuttruff ch. 2]. */
static const double LINING_CORNER = 2513.0; /* 400 Hz */

/* Specific admittance of a lining that absorbs the part alpha of sound from all directions, alpha =
 * 8 beta_m. */
static double lining_admittance(const TaborDrumDef *def, double omega) {
  if (!tb_is_two_headed(def) || def->air.density == 0.0) return 0.0;
  const double ratio = LINING_CORNER / omega;
  return 0.125 * def->shell.absorption / (1.0 + ratio * ratio);
}

TbCavity tb_closed_drum_cavity(const TaborDrumDef *def, uint32_t m, double omega) {
  const bool two = tb_is_two_headed(def);
  return (TbCavity){
    .radius = def->shell.radius,
    .depth = def->shell.depth,
    .density = def->air.density,
    .sound_speed = def->air.sound_speed,
    .heads = two ? 2 : 1,
    .admittance = wall_admittance(def, m, omega) + lining_admittance(def, omega),
    .head_density = {def->batter.surface_density, two ? def->resonant.surface_density : 0.0}};
}

static TbCavityEigen coupled_of(const TaborDrumDef *def) {
  const bool two = tb_is_two_headed(def);
  return (TbCavityEigen){.cavity = {.radius = def->shell.radius,
                                    .depth = def->shell.depth,
                                    .density = def->air.density,
                                    .sound_speed = def->air.sound_speed,
                                    .heads = two ? 2 : 1},
                         .heads = {&def->batter, two ? &def->resonant : NULL},
                         .outside = def->air.density};
}

static double first_frequency(const TbCavityEigen *drum) {
  const double wavenumber = 2.4048 / drum->cavity.radius;
  double slowest = INFINITY;
  for (uint32_t h = 0; h < drum->cavity.heads; h++) {
    const double square =
      tb_sheet_stiffness(drum->heads[h], wavenumber) / drum->heads[h]->surface_density;
    slowest = fmin(slowest, sqrt(square));
  }
  return slowest;
}

static double highest_coordinate(const TbCavityEigen *drum, double limit) {
  const double near = COORDINATES * first_frequency(drum);
  return drum->cavity.heads == 2 ? fmax(near, MARGIN * limit) : near;
}

/* ---- how many modes there are ---------------------------------------------------------------- */

/* Modes of a head by itself with the air's mass rho0/K on each side: about z^2/4 - z/2 lie
 * below the zero z. */
static double head_modes_below(const TbCavityEigen *drum, const TaborHeadDef *head, double omega) {
  double lo = 0.0, hi = 1000.0;
  for (int i = 0; i < 50; i++) {
    const double z = 0.5 * (lo + hi), wavenumber = z / drum->cavity.radius;
    const double mass = head->surface_density + 2.0 * drum->outside / wavenumber;
    if (tb_sheet_stiffness(head, wavenumber) < omega * omega * mass) {
      lo = z;
    } else {
      hi = z;
    }
  }
  return fmax(0.0, 0.25 * lo * lo - 0.5 * lo);
}

/* Weyl's count for rigid walls, V k^3/(6 pi^2) + S k^2/(16 pi) [Kuttruff]. */
static double cavity_modes_below(const TbCavity *cavity, double omega) {
  const double k = omega / cavity->sound_speed, area = PI * cavity->radius * cavity->radius;
  const double surface = 2.0 * area + 2.0 * PI * cavity->radius * cavity->depth;
  return k * k * (area * cavity->depth * k / (6.0 * PI * PI) + surface / (16.0 * PI));
}

/* The numbers are right to 1 %: this part of the room can be used. */
static const double FITTING = 0.99;

static double modes_below(const TbCavityEigen *drum, double omega) {
  return head_modes_below(drum, drum->heads[0], omega) +
         head_modes_below(drum, drum->heads[1], omega) + cavity_modes_below(&drum->cavity, omega);
}

double tb_closed_drum_bandwidth(const TaborDrumDef *def, double bandwidth, uint32_t most) {
  const TbCavityEigen drum = coupled_of(def);
  const double fitting = FITTING * most;
  if (modes_below(&drum, 2.0 * PI * bandwidth) <= fitting) return bandwidth;
  double lo = 0.0, hi = bandwidth;
  for (int i = 0; i < 50; i++) {
    const double middle = 0.5 * (lo + hi);
    if (modes_below(&drum, 2.0 * PI * middle) <= fitting) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return lo;
}

double tb_closed_drum_mode_count(const TaborDrumDef *def, double bandwidth) {
  const TbCavityEigen drum = coupled_of(def);
  return modes_below(&drum, 2.0 * PI * bandwidth);
}

/* About so many zeros of J_m or J_m' lie below z [DLMF, 10.20]: its phase in the WKB approximation,
 * over pi. */
static double zeros_below(double m, double z) {
  if (!(z > m)) return 0.0;
  const double side = sqrt(z * z - m * m);
  return side / PI - m * tb_arc_degrees(side, m) / 180.0 + 0.25;
}

double tb_closed_drum_order_size(const TaborDrumDef *def, double m, double basis_top,
                                 double limit) {
  const TbCavityEigen drum = coupled_of(def);
  const double heads = drum.cavity.heads * zeros_below(m, basis_top);
  double air = 0.0;
  if (!tb_has_cavity(def)) return heads;
  const double k = highest_coordinate(&drum, limit) / drum.cavity.sound_speed;
  const double axial = PI / drum.cavity.depth; /* step of the wavenumber along the axis */
  for (uint32_t l = 0; l * axial < k; l++) {
    const double across = drum.cavity.radius * sqrt(k * k - l * axial * l * axial);
    air += zeros_below(m, fmin(CAVITY_BASIS * basis_top, across));
  }
  return heads + fmin(air, TB_CAVITY_COORDINATES);
}

double tb_closed_drum_air_top(const TaborDrumDef *def, double limit) {
  const TbCavityEigen drum = coupled_of(def);
  return fmin(limit, highest_coordinate(&drum, limit));
}

double tb_closed_drum_air_modes(const TaborDrumDef *def, double omega) {
  const TbCavityEigen drum = coupled_of(def);
  return cavity_modes_below(&drum.cavity, omega);
}

/* ---- one mode -------------------------------------------------------------------------------- */

/* Parts of a mode: masses of the heads themselves and of the rim, the heads' loss, v^T C
 * v, and the rim's motion. */
typedef struct Parts {
  double head_mass[TB_HEADS], cavity_mass, rim_mass;
  double head_loss;
  TbRimMotion rim;
  uint32_t strongest;       /* Bessel function that moves most, of either head */
  double largest[TB_HEADS]; /* outward amplitude of each head's strongest function, mass-weighted */
} Parts;

static void add_head_parts(const Enclosed *e, uint32_t h, const double *v, Parts *parts) {
  const TaborHeadDef *head = e->drum.heads[h];
  const double radius = e->drum.cavity.radius;
  for (uint32_t i = 0; i < e->air->count; i++) {
    const double wavenumber = e->air->zeros[i] / radius;
    const double norm = e->azimuth * radius * radius * 0.5 * e->air->slopes[i] * e->air->slopes[i];
    const double mass = norm * head->surface_density * v[i] * v[i];
    const double bent = v[i] - parts->rim.edge * tb_rim_lift(e->air, h, i);
    const double lifted = norm * head->surface_density * (v[i] * v[i] - bent * bent);
    const double film = tb_sheet_film_loss(head, wavenumber);
    parts->head_mass[h] += mass;
    parts->head_loss += mass * (head->damping_0 + film) - lifted * film;
    const double size = sqrt(mass);
    if (size <= fabs(parts->largest[h])) continue;
    parts->largest[h] = v[i] < 0.0 ? -size : size;
    if (size >= fmax(fabs(parts->largest[0]), fabs(parts->largest[1]))) parts->strongest = i;
  }
  parts->head_loss += tb_felt_ring_loss(e->rings[h], e->air->count, v);
}

/* v: outward amplitudes of the heads, cavity coordinates, then those of the rim. */
static Parts parts_of(const Enclosed *e, const double *v) {
  const uint32_t heads = e->drum.cavity.heads, n = e->air->count;
  Parts parts = {.rim = tb_rim_motion(e->drum.rim, v + heads * n + e->cavity.mode_count)};
  parts.rim_mass = tb_rim_mass(e->drum.rim, parts.rim);
  for (uint32_t h = 0; h < heads; h++) add_head_parts(e, h, v + h * n, &parts);
  for (uint32_t c = 0; c < e->cavity.mode_count; c++) {
    const double u = v[heads * n + c];
    parts.cavity_mass += u * u;
  }
  return parts;
}

static uint32_t part_name(const Parts *parts) {
  const double heads = parts->head_mass[0] + parts->head_mass[1];
  if (parts->cavity_mass > 0.5) return TABOR_PART_CAVITY;
  if (parts->rim_mass > 0.5) return TABOR_PART_RIM;
  if (parts->head_mass[1] < ONE_HEAD * heads) return TABOR_PART_BATTER;
  if (parts->head_mass[0] < ONE_HEAD * heads) return TABOR_PART_RESONANT;
  return TABOR_PART_BOTH;
}

/* ---- the air outside ------------------------------------------------------------------------- */

/* Places of the microphones outside, whose indices go to `mics`. Returns their number. */
static uint32_t mic_points(const TaborDrumDef *def, uint32_t *mics, TbAirPoint *points) {
  const double radius = def->shell.radius;
  const uint32_t count = tb_mics_outside(def, mics);
  for (uint32_t p = 0; p < count; p++) {
    const TaborMicDef *mic = &def->mic[mics[p]];
    points[p] = (TbAirPoint){mic->radius / radius, mic->height / radius};
  }
  return count;
}

/* The microphones, then the places far away. */
static uint32_t outside_points(const TaborDrumDef *def, TbAirPoint *points) {
  uint32_t mics[TABOR_MAX_MICS];
  const uint32_t count = mic_points(def, mics, points);
  tb_far_points(def->shell.depth / def->shell.radius, points + count);
  return count;
}

bool tb_closed_drum_shell(const TaborDrumDef *def, TbArena *arena, TbShellMesh *shell) {
  TbAirPoint points[TB_SHELL_POINTS];
  const uint32_t count = outside_points(def, points) + TB_FAR_NODES;
  return tb_shell_prepare(shell, arena, def->shell.depth / def->shell.radius, points, count);
}

/* Load of the air outside on a mode at one frequency. */
typedef struct Outside {
  double x;
  double part;          /* 1: the shell's load alone, 0: that of air.h alone */
  TbShellMotion motion; /* of the shell, if part > 0 */
  double *inertia;      /* [heads][count] what x adds to (low-frequency mass) * amplitudes */
  double resistance;    /* of both, with their weights */
  bool has_far;
  double fields[2 * TB_SHELL_POINTS]; /* at the microphones outside, then far away if has_far */
} Outside;

/* Orders above 3 + 1.5 x do not radiate, and their mass is that at low frequency. */
static double shell_part(const Enclosed *e, double x) {
  if (!e->outside.mesh || (double)e->air->m > 3.0 + 1.5 * x) return 0.0;
  const double top = e->outside.mesh->top;
  return fmin(1.0, fmax(0.0, (top - x) / ((1.0 - BLEND_FROM) * top)));
}

static void scale(double *v, uint32_t count, double factor) {
  for (uint32_t i = 0; i < count; i++) v[i] *= factor;
}

static const double *lower_head(const Enclosed *e, const double *upper) {
  return e->drum.cavity.heads > 1 ? upper + e->air->count : NULL;
}

/* The part of the load that the shell gives. */
static bool load_shell(const Enclosed *e, TbArena *scratch, const double *upper, double x,
                       Outside *outside) {
  const uint32_t size = e->drum.cavity.heads * e->air->count;
  *outside =
    (Outside){.x = x, .part = shell_part(e, x), .inertia = tb_arena_doubles(scratch, size)};
  if (scratch->failed) return false;
  if (outside->part == 0.0) return true;
  if (!tb_shell_solve(&outside->motion, scratch, &e->outside, upper, lower_head(e, upper), x)) {
    return false;
  }
  for (uint32_t i = 0; i < size; i++)
    outside->inertia[i] = outside->part * outside->motion.inertia[i];
  outside->resistance = outside->part * outside->motion.resistance;
  return true;
}

/* The mesh for the pitch of a head alone has no places outside. */
static bool reaches_far(const Enclosed *e, uint32_t mic_count) {
  const TbShellMesh *const mesh = e->outside.mesh;
  return !mesh || mesh->targets - mesh->solved >= mic_count + TB_FAR_NODES;
}

/* Fields of the shell, and the part of load and fields that air.h gives. */
static bool finish_outside(const Enclosed *e, TbArena *scratch, const double *upper, double x,
                           Outside *outside) {
  TbAirPoint points[TB_SHELL_POINTS];
  uint32_t count = outside_points(e->def, points);
  outside->has_far = e->air->m < TB_FAR_ORDERS && x <= TB_FAR_TOP && reaches_far(e, count);
  if (outside->has_far) count += TB_FAR_NODES;
  const double part = outside->part, depth = e->def->shell.depth / e->def->shell.radius;
  if (part > 0.0 && !tb_shell_fields(&outside->motion, scratch, points, count, outside->fields)) {
    return false;
  }
  if (part == 1.0) return true;
  double resistance, fields[2 * TB_SHELL_POINTS];
  if (!tb_air_drum_load(e->air, scratch, upper, lower_head(e, upper), depth, x, points, count,
                        &resistance, fields)) {
    return false;
  }
  outside->resistance += (1.0 - part) * resistance;
  for (uint32_t i = 0; i < 2 * count; i++) {
    outside->fields[i] = part * outside->fields[i] + (1.0 - part) * fields[i];
  }
  return true;
}

/* The modes of one order at low frequency, by rows: what corrections of a mode are made of. */
typedef struct Spectrum {
  const double *eigenvalues, *vectors;
  uint32_t size;
} Spectrum;

static double product(const double *a, const double *b, uint32_t count) {
  double sum = 0.0;
  for (uint32_t i = 0; i < count; i++) sum += a[i] * b[i];
  return sum;
}

/* A mode while its frequency, its load and its shape v are made to agree. */
typedef struct Refined {
  double mass, stiffness; /* of the low-frequency problem, in this shape */
  double *v;
} Refined;

/* Adds what the inertia D = `unit` * inertia mixes into mode k of the other modes j, to first
 * order: omega^2 v_j.D/(lambda_j - omega^2), less from neighbours that are nearer than the coupling
 * is wide. Returns true if that is enough to matter. */
static bool mix(const Spectrum *spectrum, uint32_t k, double omega, double unit,
                const double *inertia, uint32_t heads, Refined *refined) {
  const uint32_t size = spectrum->size;
  const double square = omega * omega, before = refined->mass;
  for (uint32_t j = 0; j < size; j++) {
    const double *other = spectrum->vectors + (size_t)j * size;
    const double coupling = square * unit * product(other, inertia, heads);
    const double gap = spectrum->eigenvalues[j] - square;
    const double amount = coupling * gap / (gap * gap + 4.0 * coupling * coupling);
    if (j == k || !(amount * amount > LEAST_MIXED)) continue;
    refined->mass += amount * amount;
    refined->stiffness += amount * amount * spectrum->eigenvalues[j];
    for (uint32_t i = 0; i < size; i++) refined->v[i] += amount * other[i];
  }
  return refined->mass > before;
}

/* Takes over what a motion of this mass meets outside. */
static void set_radiation(const Enclosed *e, const Outside *outside, double mass,
                          TbBodyMode *mode) {
  const double radius = e->def->shell.radius, sound_speed = e->def->air.sound_speed;
  const double unit = e->azimuth * e->def->air.density * sound_speed * radius * radius;
  mode->radiation_rate = 0.5 * unit * fmax(0.0, outside->resistance) / mass;
  uint32_t mics[TABOR_MAX_MICS];
  const uint32_t count = tb_mics_outside(e->def, mics);
  for (uint32_t p = 0; p < count; p++) {
    mode->fields[2 * mics[p]] = outside->fields[2 * p] / sqrt(mass);
    mode->fields[2 * mics[p] + 1] = outside->fields[2 * p + 1] / sqrt(mass);
  }
  mode->has_far = outside->has_far;
  if (mode->has_far) {
    tb_far_from_fields(e->def->shell.depth / radius, outside->x, outside->fields + 2 * count,
                       mode->far);
    scale(mode->far, 2 * TB_FAR_NODES, 1.0 / sqrt(mass));
  }
}

/* One pass: the load at the mode's frequency, and the frequency that follows. The first pass mixes
 * in other modes. The last one sets radiation and sound, and scales v to unit mass. */
static bool refine(const Enclosed *e, TbArena *scratch, const Spectrum *spectrum, uint32_t k,
                   int pass, Refined *refined, TbBodyMode *mode, bool *settled) {
  const uint32_t heads = e->drum.cavity.heads * e->air->count;
  const double radius = e->def->shell.radius, before = mode->omega;
  const double unit = e->azimuth * e->def->air.density * radius * radius * radius;
  const double x = before * radius / e->def->air.sound_speed;
  Outside outside;
  if (!load_shell(e, scratch, refined->v, x, &outside)) return false;
  const double mass = refined->mass + unit * product(refined->v, outside.inertia, heads);
  mode->omega = sqrt(refined->stiffness / mass);
  *settled = fabs(mode->omega / before - 1.0) < SETTLED;
  if (pass == 0 && mix(spectrum, k, mode->omega, unit, outside.inertia, heads, refined)) {
    *settled = false;
  }
  if (pass + 1 == MOST_PASSES) *settled = true;
  if (!*settled) return true;
  if (!finish_outside(e, scratch, refined->v, x, &outside)) return false;
  set_radiation(e, &outside, mass, mode);
  scale(refined->v, spectrum->size, 1.0 / sqrt(mass));
  return true;
}

/* Sets frequency, radiation and sound of mode k, and makes its vector v one of unit mass at its own
 * frequency. */
static bool radiate(const Enclosed *e, TbArena *arena, const Spectrum *spectrum, uint32_t k,
                    double *v, TbBodyMode *mode) {
  if (e->def->air.density == 0.0) return true;
  Refined refined = {.mass = 1.0, .stiffness = spectrum->eigenvalues[k], .v = v};
  bool settled = false, done = true;
  for (int pass = 0; done && !settled; pass++) {
    TbArena scratch;
    tb_arena_beside(&scratch, arena);
    done = refine(e, &scratch, spectrum, k, pass, &refined, mode, &settled);
    tb_arena_release(&scratch);
  }
  return done;
}

/* ---- all modes of an order ------------------------------------------------------------------- */

/* Losses of a mode whose radiation is known. */
static void add_losses(const Enclosed *e, const Parts *parts, const TbCavity *cavity,
                       const double *outward, const double *coordinates, TbBodyMode *mode) {
  if (e->def->quality.losses == 0) {
    mode->radiation_rate = 0.0;
    mode->has_far = false;
    return;
  }
  mode->shell_rate =
    tb_cavity_wall_power(&e->cavity, cavity, e->air, outward, coordinates, mode->omega) /
      (mode->omega * mode->omega) + /* P/(2E), E = omega^2/2 */
    tb_rim_decay_rate(e->drum.rim, parts->rim, mode->omega);
  mode->decay_rate = 0.5 * parts->head_loss + mode->shell_rate + mode->radiation_rate;
}

/* v: see parts_of(). */
static void finish_mode(const Enclosed *e, const Parts *parts, const double *v, TbBodyMode *mode) {
  mode->n = parts->strongest + 1;
  mode->part = part_name(parts);
  const double both = parts->largest[0] * parts->largest[1];
  mode->phase = both < 0.0 ? 1 : (both > 0.0 ? -1 : 0);
  const double *coordinates = v + e->drum.cavity.heads * e->air->count;
  const TbCavity cavity = tb_closed_drum_cavity(e->def, mode->m, mode->omega);
  add_losses(e, parts, &cavity, v, coordinates, mode);
  if (e->inside.count > 0) {
    tb_cavity_fields(&e->inside, &e->cavity, &cavity, e->air, v, coordinates, mode->omega,
                     mode->decay_rate, mode->fields);
  }
}

/* Keeps the upward amplitudes of both heads, relative to the lifted edge, and those of the rim. */
static void keep_vectors(const Enclosed *e, const Parts *parts, const double *v,
                         TbBodyOrder *order) {
  const uint32_t n = e->air->count;
  for (uint32_t h = 0; h < e->drum.cavity.heads; h++) {
    double *kept = order->vectors[h] + (size_t)order->mode_count * n;
    for (uint32_t i = 0; i < n; i++) {
      const double own = v[h * n + i] - parts->rim.edge * tb_rim_lift(e->air, h, i);
      kept[i] = h ? -own : own;
    }
  }
  if (!order->edge[0]) return;
  order->edge[0][order->mode_count] = parts->rim.edge;
  order->hoop[order->mode_count] = parts->rim.hoop;
}

/* Modes that lose less to the air than this part of what the loudest of their order does are not
 * heard beside it: they book their own resistance. */
static const double LEAST_FAR = 1e-3;

static void drop_faint_fields(TbBodyMode *modes, uint32_t count) {
  double largest = 0.0;
  for (uint32_t i = 0; i < count; i++) largest = fmax(largest, modes[i].radiation_rate);
  for (uint32_t i = 0; i < count; i++) {
    if (modes[i].radiation_rate < LEAST_FAR * largest) modes[i].has_far = false;
  }
}

/* Keeps what moves a head or the rim, up to `limit`. Vectors: see parts_of(). */
static TaborStatus keep_modes(const Enclosed *e, TbArena *arena, const double *eigenvalues,
                              const double *vectors, TbModeLimits limit, TbBodyOrder *order,
                              TbBodyMode *modes, uint32_t room) {
  const uint32_t size = tb_cavity_eigen_size(&e->cavity, &e->drum, e->air);
  const Spectrum spectrum = {eigenvalues, vectors, size};
  double v[2048];
  for (uint32_t k = 0; k < size && order->mode_count < room; k++) {
    if (!(eigenvalues[k] <= limit.rim * limit.rim)) break;
    memcpy(v, vectors + (size_t)k * size, size * sizeof *v);
    Parts parts = parts_of(e, v);
    if (parts.head_mass[0] + parts.head_mass[1] + parts.rim_mass < LEAST_MOVED) continue;
    if (!tb_rim_keeps(limit, sqrt(eigenvalues[k]), parts.rim_mass)) continue;
    TbBodyMode *mode = &modes[order->mode_count];
    *mode = (TbBodyMode){.m = order->m, .index = k, .omega = sqrt(eigenvalues[k])};
    mode->place = order->mode_count;
    if (!radiate(e, arena, &spectrum, k, v, mode)) return TABOR_ERROR_MEMORY;
    parts = parts_of(e, v);
    if (!tb_rim_keeps(limit, mode->omega, parts.rim_mass)) continue;
    tb_rim_radiate(e->drum.rim, e->def, parts.rim, mode);
    finish_mode(e, &parts, v, mode);
    keep_vectors(e, &parts, v, order);
    order->mode_count++;
  }
  drop_faint_fields(modes, order->mode_count);
  return TABOR_OK;
}

/* The mass of the air outside: of the shell, or for an order that it does not have half of an open
 * head's, a value between a head without a baffle and a head in a baffle. */
static bool prepare_outside(Enclosed *e, TbArena *scratch, const TbShellMesh *shell) {
  const uint32_t count = e->air->count;
  if (!shell) return true;
  double *own = tb_arena_doubles(scratch, (size_t)count * count);
  double *mutual = tb_arena_doubles(scratch, (size_t)count * count);
  if (scratch->failed) return false;
  e->drum.own = own;
  e->drum.mutual = mutual;
  if (e->air->m < shell->orders) {
    if (!tb_shell_order_prepare(&e->outside, scratch, shell, e->air)) return false;
    return tb_shell_order_mass(&e->outside, scratch, own, mutual);
  }
  tb_air_mass_open(e->air, own);
  scale(own, count * count, 0.5);
  return true;
}

static bool prepare_rings(Enclosed *e, TbArena *scratch) {
  for (uint32_t h = 0; h < e->drum.cavity.heads; h++) {
    const double radius = e->drum.cavity.radius;
    if (!tb_felt_ring_matrix(e->drum.heads[h], radius, scratch, e->air, &e->rings[h])) return false;
  }
  return true;
}

TaborStatus tb_closed_drum_order(const TaborDrumDef *def, TbArena *arena, TbArena *scratch,
                                 const TbAirOrder *air, const TbRim *rim, const TbShellMesh *shell,
                                 TbModeLimits limit, TbBodyOrder *order, TbBodyMode *modes,
                                 uint32_t room) {
  Enclosed e = {.def = def, .drum = coupled_of(def), .air = air};
  e.drum.rim = rim;
  e.azimuth = air->m ? PI : 2.0 * PI;
  const double top_zero = CAVITY_BASIS * air->zeros[air->count - 1];
  if (!tb_cavity_order_prepare(&e.cavity, scratch, &e.drum.cavity, air->m, top_zero,
                               highest_coordinate(&e.drum, limit.heads)) ||
      !prepare_outside(&e, scratch, shell) || !prepare_rings(&e, scratch) ||
      (def->air.density > 0.0 && !tb_cavity_mics_prepare(&e.inside, scratch, def, &e.cavity))) {
    return TABOR_ERROR_MEMORY;
  }
  const uint32_t size = tb_cavity_eigen_size(&e.cavity, &e.drum, air);
  double *eigenvalues = tb_arena_doubles(scratch, size);
  double *vectors = tb_arena_doubles(scratch, (size_t)size * size);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  const TaborStatus status =
    tb_cavity_eigen_solve(&e.drum, scratch, air, &e.cavity, eigenvalues, vectors);
  if (status != TABOR_OK) return status;
  uint32_t below = 0;
  while (below < size && eigenvalues[below] <= limit.rim * limit.rim) below++;
  for (uint32_t h = 0; h < e.drum.cavity.heads; h++) {
    order->vectors[h] = tb_arena_doubles(arena, (size_t)below * air->count);
  }
  if (rim->count > 0) {
    order->edge[0] = order->edge[1] = tb_arena_doubles(arena, below);
    order->hoop = tb_arena_doubles(arena, below);
  }
  if (arena->failed) return TABOR_ERROR_MEMORY;
  return keep_modes(&e, arena, eigenvalues, vectors, limit, order, modes, room);
}
