/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <math.h>
#include <string.h>

#include "error.h"
#include "state.h"
#include "power.h"

static const double PI = 3.14159265358979323846;

/* What a quality level stands for. */
typedef struct Level {
  double bandwidth; /* two-way [Hz] */
  uint32_t newton_cap, inner_cap, wire_cells;
} Level;

static Level level_of(uint32_t quality) {
  switch (quality) {
  case TABOR_QUALITY_DRAFT: return (Level){3000.0, 2, 4, 32};
  case TABOR_QUALITY_LIVE: return (Level){5000.0, 4, 6, 64};
  case TABOR_QUALITY_REFERENCE: return (Level){12000.0, 16, 64, 256};
  default: return (Level){8000.0, 8, 24, 128};
  }
}

/* Two-way modes stay below this part of the rate, where the gain of the recursion is still near 1. */
static const double TOP_OF_RATE = 0.2;

static Level resolve_level(const TaborDrumDef *def, uint32_t quality, double rate) {
  Level level = level_of(quality);
  if (def->quality.two_way_bandwidth > 0.0) level.bandwidth = def->quality.two_way_bandwidth;
  if (def->quality.newton_cap > 0) level.newton_cap = def->quality.newton_cap;
  if (def->quality.wire_points > 0) level.wire_cells = def->quality.wire_points;
  level.bandwidth = fmin(level.bandwidth, TOP_OF_RATE * rate);
  return level;
}

TbPole tb_pole(double omega, double s, double k) {
  const double square = omega * omega - s * s;
  const double damped = sqrt(fabs(square)) * k;
  const double turn = square >= 0.0 ? cos(damped) : cosh(damped);
  const double shrink = exp(-s * k), slow = tanh(s * k);
  return (TbPole){.a = 2.0 * shrink * turn,
                  .b = shrink * shrink,
                  .g = k * k / (1.0 + slow),
                  .stiffness = 2.0 / (k * k) * (1.0 - turn / cosh(s * k)),
                  .loss = slow / (2.0 * k * k),
                  .re = shrink * turn,
                  .im = square >= 0.0 ? shrink * sin(damped) : 0.0};
}

/* cos(m t), sin(m t) by Chebyshev's recurrence: exact zeros stay exact. */
double tb_angular(uint32_t m, bool sine, double sin_angle, double cos_angle) {
  double c = 1.0, s = 0.0, c_last = cos_angle, s_last = -sin_angle;
  for (uint32_t i = 0; i < m; i++) {
    const double c_next = 2.0 * cos_angle * c - c_last, s_next = 2.0 * cos_angle * s - s_last;
    c_last = c;
    s_last = s;
    c = c_next;
    s = s_next;
  }
  return sine ? s : c;
}

/* cos(m t) and sin(m t) for all orders at once. */
static void angular_factors(uint32_t orders, double sin_angle, double cos_angle, double *c,
                            double *s) {
  c[0] = 1.0;
  s[0] = 0.0;
  if (orders > 1) {
    c[1] = cos_angle;
    s[1] = sin_angle;
  }
  for (uint32_t m = 2; m < orders; m++) {
    c[m] = 2.0 * cos_angle * c[m - 1] - c[m - 2];
    s[m] = 2.0 * cos_angle * s[m - 1] - s[m - 2];
  }
}

static void shape_at(const TaborModel *model, double radius, double sin_angle, double cos_angle,
                     const double *patch, double *radial, double *shape) {
  double c[128], s[128]; /* orders stay below TOP_ZERO + 2 pi of head.c */
  tb_head_radial(&model->head, radius, patch, radial);
  angular_factors(model->head.order_count, sin_angle, cos_angle, c, s);
  const TbModes *modes = &model->modes;
  for (uint32_t i = 0; i < modes->count; i++) {
    const uint32_t row = modes->row[i], m = model->head.modes[row].m;
    shape[i] = radial[row] * (modes->sine[i] ? s[m] : c[m]);
  }
  for (uint32_t i = modes->count; i < modes->padded; i++) shape[i] = 0.0;
}

void tb_model_shape(const TaborModel *model, double radius, double angle, const double *patch,
                    double *radial, double *shape) {
  double sine, cosine;
  tb_sin_cos_degrees(angle - model->def.wires.angle, &sine, &cosine);
  shape_at(model, radius, sine, cosine, patch, radial, shape);
}

/* ---- modes ---------------------------------------------------------------------------------- */

/* Lists the modes, cosine and sine apart, in order of frequency. */
static TaborStatus list_modes(TaborModel *model) {
  TbModes *modes = &model->modes;
  const TbHead *head = &model->head;
  modes->row = tb_arena_take(&model->arena, TB_MAX_MODES, sizeof *modes->row);
  modes->sine = tb_arena_take(&model->arena, TB_MAX_MODES, sizeof *modes->sine);
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t row = 0; row < head->row_count; row++) {
    const uint32_t copies = head->modes[row].m ? 2 : 1;
    if (modes->count + copies > TB_MAX_MODES) break;
    for (uint32_t copy = 0; copy < copies; copy++) {
      modes->row[modes->count] = row;
      modes->sine[modes->count++] = (uint8_t)copy;
    }
  }
  modes->padded = tb_pad(modes->count);
  return TABOR_OK;
}

/* Shapes of the listed modes at every contact point: points[row][padded]. */
static bool point_shapes(TaborModel *model, TbArena *scratch, double *points) {
  const TbWires *wires = &model->wires;
  double *radial = tb_arena_doubles(scratch, model->head.row_count);
  if (!radial) return false;
  for (uint32_t a = 0; a < wires->row_count; a++) {
    const double x = wires->row_x[a], y = wires->row_y[a], r = sqrt(x * x + y * y);
    shape_at(model, r, r > 0.0 ? y / r : 0.0, r > 0.0 ? x / r : 1.0, NULL, radial,
             points + (size_t)a * model->modes.padded);
  }
  return true;
}

/* Moves the modes that some contact point feels to the front, keeping their order. */
static bool couple_modes(TaborModel *model, TbArena *scratch, double *points) {
  TbModes *modes = &model->modes;
  uint32_t *row = tb_arena_take(scratch, modes->count, sizeof *row);
  uint8_t *sine = tb_arena_take(scratch, modes->count, sizeof *sine);
  uint32_t *from = tb_arena_take(scratch, modes->count, sizeof *from);
  uint8_t *felt = tb_arena_take(scratch, modes->count, sizeof *felt);
  if (scratch->failed) return false;
  uint32_t count = 0;
  for (uint32_t i = 0; i < modes->count; i++) {
    for (uint32_t a = 0; a < model->wires.row_count && !felt[i]; a++) {
      felt[i] = points[(size_t)a * modes->padded + i] != 0.0;
    }
    if (felt[i]) from[count++] = i;
  }
  const uint32_t coupled = count;
  for (uint32_t i = 0; i < modes->count; i++) {
    if (!felt[i]) from[count++] = i;
  }
  for (uint32_t i = 0; i < modes->count; i++) {
    row[i] = modes->row[from[i]];
    sine[i] = modes->sine[from[i]];
  }
  memcpy(modes->row, row, modes->count * sizeof *row);
  memcpy(modes->sine, sine, modes->count * sizeof *sine);
  modes->coupled = tb_pad(coupled);
  if (modes->coupled > modes->padded) modes->coupled = modes->padded;

  const uint32_t stride = model->wires.stride;
  model->projection = tb_arena_doubles(&model->arena, (size_t)modes->coupled * stride);
  if (model->arena.failed) return false;
  for (uint32_t i = 0; i < coupled; i++) {
    for (uint32_t a = 0; a < model->wires.row_count; a++) {
      model->projection[(size_t)i * stride + a] = points[(size_t)a * modes->padded + from[i]];
    }
  }
  return true;
}

static TaborStatus mode_coefficients(TaborModel *model) {
  TbModes *modes = &model->modes;
  double **arrays[] = {&modes->a,         &modes->b,         &modes->g,
                       &modes->stiffness, &modes->loss_head, &modes->loss_air,
                       &modes->pull};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(&model->arena, modes->padded);
  }
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < modes->count; i++) {
    const TbHeadMode *mode = &model->head.modes[modes->row[i]];
    const TbPole pole = tb_pole(mode->omega, mode->decay_rate, model->time_step);
    const double radiated =
        mode->decay_rate > 0.0 ? mode->radiation_rate / mode->decay_rate : 0.0;
    modes->a[i] = pole.a;
    modes->b[i] = pole.b;
    modes->g[i] = pole.g;
    modes->pull[i] = -model->wires.side * pole.g;
    modes->stiffness[i] = pole.stiffness;
    modes->loss_air[i] = pole.loss * radiated;
    modes->loss_head[i] = pole.loss * (1.0 - radiated);
  }
  return TABOR_OK;
}

static TaborStatus prepare_modes(TaborModel *model, TbArena *scratch) {
  TaborStatus status = list_modes(model);
  if (status != TABOR_OK) return status;
  double *points = tb_arena_doubles(
      scratch, (size_t)model->wires.row_count * model->modes.padded);
  double *radial = tb_arena_doubles(scratch, model->head.row_count);
  if (scratch->failed || !point_shapes(model, scratch, points) ||
      !couple_modes(model, scratch, points)) {
    return TABOR_ERROR_MEMORY;
  }
  status = mode_coefficients(model);
  if (status != TABOR_OK) return status;
  model->center = tb_arena_doubles(&model->arena, model->modes.padded);
  if (!model->center) return TABOR_ERROR_MEMORY;
  tb_model_shape(model, 0.0, 0.0, NULL, radial, model->center);
  return TABOR_OK;
}

/* ---- contacts ------------------------------------------------------------------------------- */

static TaborStatus prepare_compliance(TaborModel *model) {
  const TbWires *wires = &model->wires;
  const uint32_t n = wires->row_count, stride = wires->stride;
  model->compliance = tb_arena_doubles(&model->arena, (size_t)n * stride);
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < model->modes.coupled; i++) {
    const double *phi = model->projection + (size_t)i * stride;
    for (uint32_t a = 0; a < n; a++) {
      model->kernels->add_scaled(stride, model->compliance + (size_t)a * stride,
                                 model->modes.g[i] * phi[a], phi);
    }
  }
  for (uint32_t a = 0; a < n; a++) { /* symmetric to the bit */
    for (uint32_t b = 0; b < a; b++) {
      model->compliance[(size_t)a * stride + b] = model->compliance[(size_t)b * stride + a];
    }
  }
  return TABOR_OK;
}

/* Wire contacts are per length: a node carries K h. */
static void prepare_laws(TaborModel *model) {
  const TbWires *wires = &model->wires;
  for (uint32_t w = 0; w < wires->count; w++) {
    const TbWire *wire = &wires->wires[w];
    TbWireCoefficients c;
    tb_wire_coefficients(wire, model->time_step, wire->tension, wire->damping_0, wire->damping_1,
                         &c);
    double head = 0.0;
    for (uint32_t i = 0; i < wire->row_count; i++) {
      const uint32_t row = wire->first_row + i;
      head = fmax(head, model->compliance[(size_t)row * wires->stride + row]);
    }
    const double limit = TB_SLOPE_LIMIT / (c.compliance + head);
    tb_law_prepare(&wires->laws[w], wire->contact_stiffness * wire->spacing,
                   wire->contact_exponent, wire->contact_loss, model->time_step, limit);
  }
}

/* ---- microphones ---------------------------------------------------------------------------- */

/* Travel time to the nearest point of the head, in whole samples. */
static uint32_t travel_delay(const TaborModel *model, const TaborMicDef *mic) {
  const double aside = fmax(0.0, mic->radius - model->head.radius);
  const double distance = sqrt(mic->height * mic->height + aside * aside);
  return (uint32_t)(distance / model->def.air.sound_speed * model->sample_rate);
}

/* Real u, v with u (l - 2 + 1/l) + v (l - 1/l) = gain for the pole l: the weights that turn a mode's
 * acceleration and velocity into a pressure of this size and phase. */
static void realise(const TbPole *pole, double gain_re, double gain_im, double omega_k, double *u,
                    double *v) {
  *v = 0.0;
  if (pole->im == 0.0) { /* overdamped: no phase to match */
    *u = -gain_re / (omega_k * omega_k);
    return;
  }
  const double square = pole->re * pole->re + pole->im * pole->im;
  const double inverse_re = pole->re / square, inverse_im = -pole->im / square;
  const double bend_re = pole->re - 2.0 + inverse_re, bend_im = pole->im + inverse_im;
  const double step_re = pole->re - inverse_re, step_im = pole->im - inverse_im;
  const double determinant = bend_re * step_im - bend_im * step_re;
  *u = (gain_re * step_im - gain_im * step_re) / determinant;
  *v = (bend_re * gain_im - bend_im * gain_re) / determinant;
}

/* p = -omega^2 rho0 R I per unit amplitude, advanced by the delay that is taken out, and times
 * sin(omega k)/(omega k), by which the recursion's answer to a force is too large. */
static void mic_weights(const TaborModel *model, uint32_t index, TbMic *mic) {
  const TaborMicDef *place = &model->def.mic[index];
  const double k = model->time_step;
  double sine, cosine;
  tb_sin_cos_degrees(place->angle - model->def.wires.angle, &sine, &cosine);
  for (uint32_t i = 0; i < model->modes.count; i++) {
    const TbHeadMode *mode = &model->head.modes[model->modes.row[i]];
    const double size = -mode->omega * mode->omega * model->def.air.density * model->head.radius *
                        tb_angular(mode->m, model->modes.sine[i], sine, cosine) *
                        sin(mode->omega * k) / (mode->omega * k);
    const double re = mode->fields[2 * index], im = mode->fields[2 * index + 1];
    const double phase = mode->omega * (double)mic->delay * k;
    const TbPole pole = tb_pole(mode->omega, mode->decay_rate, k);
    realise(&pole, size * (re * cos(phase) - im * sin(phase)),
            size * (re * sin(phase) + im * cos(phase)), mode->omega * k, &mic->u[i], &mic->v[i]);
  }
}

static TaborStatus prepare_mics(TaborModel *model) {
  for (uint32_t index = 0; index < model->def.mic_count; index++) {
    TbMic *mic = &model->mics[index];
    mic->delay = travel_delay(model, &model->def.mic[index]);
    mic->u = tb_arena_doubles(&model->arena, model->modes.padded);
    mic->v = tb_arena_doubles(&model->arena, model->modes.padded);
    if (model->arena.failed) return TABOR_ERROR_MEMORY;
    mic_weights(model, index, mic);
  }
  return TABOR_OK;
}

/* ---- strikers and rest ---------------------------------------------------------------------- */

static TaborStatus prepare_patches(TaborModel *model) {
  for (uint32_t i = 0; i <= model->def.striker_count; i++) {
    const bool hand = i == model->def.striker_count;
    double *patch = tb_arena_doubles(&model->arena, model->head.zero_count);
    if (!patch) return TABOR_ERROR_MEMORY;
    tb_head_patch(&model->head, hand ? TB_HAND_RADIUS : model->def.striker[i].contact_radius,
                  patch);
    model->patches[hand ? TABOR_MAX_STRIKERS : i] = patch;
  }
  return TABOR_OK;
}

static TaborStatus allocate_rest(TaborModel *model) {
  TbRest *rest = &model->rest;
  rest->q = tb_arena_doubles(&model->arena, model->modes.padded);
  rest->v = tb_arena_doubles(&model->arena, model->wires.node_count);
  rest->bend = tb_arena_doubles(&model->arena, model->wires.node_count);
  rest->eta = tb_arena_doubles(&model->arena, model->wires.stride);
  rest->force = tb_arena_doubles(&model->arena, model->wires.stride + TB_SLOTS);
  rest->offset = tb_arena_doubles(&model->arena, model->wires.count);
  return model->arena.failed ? TABOR_ERROR_MEMORY : TABOR_OK;
}

/* FNV-1a over what a saved state depends on. */
static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size) {
  const unsigned char *p = bytes;
  for (size_t i = 0; i < size; i++) hash = (hash ^ p[i]) * 1099511628211u;
  return hash;
}

static uint64_t fingerprint(const TaborModel *model) {
  uint64_t hash = 14695981039346656037u;
  hash = hash_bytes(hash, &model->sample_rate, sizeof model->sample_rate);
  hash = hash_bytes(hash, &model->modes.count, sizeof model->modes.count);
  hash = hash_bytes(hash, &model->wires.row_count, sizeof model->wires.row_count);
  hash = hash_bytes(hash, &model->layout, sizeof model->layout);
  hash = hash_bytes(hash, model->modes.a, model->modes.count * sizeof *model->modes.a);
  hash = hash_bytes(hash, model->rest.force, model->wires.row_count * sizeof *model->rest.force);
  return hash;
}

/* ---- public --------------------------------------------------------------------------------- */

static const TbKernels *choose_kernels(uint32_t instructions) {
#ifdef TB_HAVE_AVX2
  if (instructions != TABOR_INSTRUCTIONS_BASELINE && __builtin_cpu_supports("avx2")) {
    return &tb_kernels_avx2;
  }
#endif
  (void)instructions;
  return &tb_kernels_baseline;
}

static TaborStatus build(TaborModel *model, TbArena *scratch, const Level *level,
                         TaborError *error) {
  typedef TaborStatus Stage(TaborModel *);
  TaborStatus status =
      tb_head_prepare(&model->head, &model->arena, &model->def, level->bandwidth);
  if (status == TABOR_OK && model->head.row_count == 0) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "quality.two_way_bandwidth", NULL, NAN, NAN,
                        "no mode of this head lies below the two-way bandwidth of %g Hz: it is too "
                        "small, light or tense",
                        model->head.bandwidth);
  }
  if (status == TABOR_OK) {
    status = tb_wires_prepare(&model->wires, &model->arena, &model->def, model->time_step,
                              level->wire_cells, error);
  }
  if (status == TABOR_OK) status = prepare_modes(model, scratch);
  Stage *const stages[] = {prepare_compliance, prepare_mics, prepare_patches, allocate_rest};
  for (size_t i = 0; status == TABOR_OK && i < sizeof stages / sizeof *stages; i++) {
    status = stages[i](model);
    if (stages[i] == prepare_compliance && status == TABOR_OK) prepare_laws(model);
  }
  if (status == TABOR_OK) status = tb_rest_prepare(model, scratch);
  if (status == TABOR_OK) {
    tb_layout_prepare(&model->layout, model);
    model->fingerprint = fingerprint(model);
  }
  return status;
}

void tabor_model_options_default(TaborModelOptions *options) {
  *options = (TaborModelOptions){.struct_size = sizeof *options, .sample_rate = 48000.0};
}

static TaborStatus check_options(const TaborModelOptions *options, TaborError *error) {
  if (options->struct_size != sizeof *options) {
    return tb_error_set(error, TABOR_ERROR_ARGUMENT, NULL, NULL, NAN, NAN,
                        "model options were not set by tabor_model_options_default()");
  }
  if (!(options->sample_rate >= 22050.0 && options->sample_rate <= 192000.0)) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "sample_rate", NULL, 22050.0, 192000.0,
                        "sample rate %g Hz is outside 22050 to 192000 Hz", options->sample_rate);
  }
  if (options->quality > TABOR_QUALITY_REFERENCE) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "quality", NULL, 0.0, TABOR_QUALITY_REFERENCE,
                        "unknown quality %u", (unsigned)options->quality);
  }
  if (options->instructions > TABOR_INSTRUCTIONS_AVX2) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "instructions", NULL, 0.0,
                        TABOR_INSTRUCTIONS_AVX2, "unknown instruction set %u",
                        (unsigned)options->instructions);
  }
  return TABOR_OK;
}

static TaborStatus memory_error(TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_MEMORY, NULL, NULL, NAN, NAN,
                      "out of memory while building a model");
}

TaborStatus tabor_model_create(const TaborDrumDef *def, const TaborModelOptions *options,
                               TaborModel **out, TaborError *error) {
  if (!out) return TABOR_ERROR_ARGUMENT;
  *out = NULL;
  TaborModelOptions defaults;
  tabor_model_options_default(&defaults);
  if (!options) options = &defaults;
  TaborStatus status = tabor_drum_def_validate(def, error);
  if (status == TABOR_OK) status = check_options(options, error);
  if (status != TABOR_OK) return status;

  const TaborAllocator allocator = tb_allocator_resolve(&options->allocator);
  TaborModel *model = allocator.allocate(sizeof *model, allocator.context);
  if (!model) return memory_error(error);
  memset(model, 0, sizeof *model);
  atomic_init(&model->references, 1u);
  tb_arena_prepare(&model->arena, &allocator);
  model->def = *def;
  model->quality = options->quality ? options->quality : def->quality.level;
  model->sample_rate = options->sample_rate;
  model->time_step = 1.0 / options->sample_rate;
  model->kernels = choose_kernels(options->instructions);
  const Level level = resolve_level(def, model->quality, model->sample_rate);
  model->newton_cap = level.newton_cap;
  model->inner_cap = level.inner_cap;

  TbArena scratch;
  tb_arena_prepare(&scratch, &allocator);
  if (error) error->status = TABOR_OK;
  status = build(model, &scratch, &level, error);
  tb_arena_release(&scratch);
  if (status != TABOR_OK) {
    tabor_model_release(model);
    if (status == TABOR_ERROR_MEMORY) return memory_error(error);
    if (status == TABOR_ERROR_RANGE) return status; /* whoever found it has named it */
    return tb_error_set(error, status, NULL, NULL, NAN, NAN,
                        "the modes or the rest state of this drum could not be computed");
  }
  *out = model;
  return TABOR_OK;
}

TaborModel *tabor_model_retain(TaborModel *model) {
  atomic_fetch_add(&model->references, 1u);
  return model;
}

void tabor_model_release(TaborModel *model) {
  if (!model || atomic_fetch_sub(&model->references, 1u) != 1u) return;
  const TaborAllocator allocator = model->arena.allocator;
  tb_arena_release(&model->arena);
  allocator.release(model, allocator.context);
}

const TaborDrumDef *tabor_model_definition(const TaborModel *model) { return &model->def; }

void tabor_model_info(const TaborModel *model, TaborModelInfo *info) {
  *info = (TaborModelInfo){
      .sample_rate = model->sample_rate,
      .quality = model->quality,
      .mode_count = model->modes.count,
      .mode_rows = model->head.row_count,
      .two_way_bandwidth = model->head.bandwidth,
      .newton_cap = model->newton_cap,
      .wire_count = model->wires.count,
      .contact_points = model->wires.row_count,
      .mic_count = model->def.mic_count,
      .model_bytes = model->arena.bytes + sizeof *model,
      .drum_bytes = tb_state_bytes(model),
  };
}

bool tabor_model_mode(const TaborModel *model, uint32_t row, TaborModeInfo *info) {
  if (row >= model->head.row_count) return false;
  const TbHeadMode *mode = &model->head.modes[row];
  *info = (TaborModeInfo){.m = mode->m,
                          .n = mode->n,
                          .frequency = mode->omega / (2.0 * PI),
                          .decay_rate = mode->decay_rate,
                          .radiation_rate = mode->radiation_rate,
                          .multiplicity = mode->m ? 2 : 1};
  return true;
}
