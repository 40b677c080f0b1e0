/* SPDX-License-Identifier: MIT */
#include "model/model.h"

#include <math.h>
#include <string.h>

#include "definition/def_text.h"
#include "definition/error.h"
#include "math/portable_math.h"
#include "math/thread_time.h"
#include "model/body_kind.h"
#include "model/build_estimate.h"
#include "model/lug_modes.h"
#include "model/mics.h"
#include "model/quality_level.h"
#include "model/resting.h"
#include "model/state_layout.h"
#include "model/stretch_gain.h"
#include "model/wire_gridf.h"
#include "model/wire_reach.h"
#include "model/wire_yield.h"

void tb_model_shape(const TaborModel *model, uint32_t which, double radius, double angle,
                    const double *patch, double *radial, double *shape) {
  double sine, cosine;
  tb_sin_cos_degrees(angle - model->axis, &sine, &cosine);
  tb_body_radial(&model->body, which, radius, patch, radial);
  tb_body_add_lift(&model->body, which, radius, radial);
  tb_modes_turn(&model->modes, &model->body, radial, sine, cosine, shape);
}

void tb_model_hoop_shape(const TaborModel *model, double angle, double *radial, double *shape) {
  double sine, cosine;
  tb_sin_cos_degrees(angle - model->axis, &sine, &cosine);
  tb_body_hoop(&model->body, radial);
  tb_modes_turn(&model->modes, &model->body, radial, sine, cosine, shape);
}

void tb_model_high_drive(const TaborModel *model, uint32_t striker, double radius, double angle,
                         double *drive) {
  double sine, cosine;
  tb_sin_cos_degrees(angle - model->axis, &sine, &cosine);
  tb_high_band_drive(&model->high, TABOR_HEAD_BATTER, radius, sine, cosine,
                     model->high_patches[striker], drive);
}

/* ---- contacts ------------------------------------------------------------------------------- */

/* Displacement of the head one step after a force. */
static TaborStatus prepare_compliance(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  return tb_compliance_prepare(&model->compliance, &model->arena, &model->projection,
                               model->modes.g);
}

/* The quality's, where there are wires and all their laws have a formula for the kernels. */
static TbPrecision contact_precision(const TaborModel *model) {
  if (model->wires.count == 0) return TB_IN_DOUBLE;
  for (uint32_t w = 0; w < model->wires.count; w++) {
    if (!tb_contact_law_power(&model->wires.laws[w])) return TB_IN_DOUBLE;
  }
  return model->precision;
}

static bool prepare_in_double(TaborModel *model) {
  (void)model;
  return true;
}

static bool prepare_in_float(TaborModel *model) {
  return tb_wire_gridf_prepare(&model->wire_gridf, &model->arena, &model->projection.wire_grid) &&
         tb_compliancef_prepare(&model->compliancef, &model->arena, &model->compliance);
}

/* After the laws. */
static TaborStatus prepare_contacts(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  static bool (*const PREPARE[])(TaborModel *) = {
    [TB_IN_DOUBLE] = prepare_in_double, [TB_IN_FLOAT] = prepare_in_float};
  model->contacts = contact_precision(model);
  return PREPARE[model->contacts](model) ? TABOR_OK : TABOR_ERROR_MEMORY;
}

static TaborStatus prepare_stretch(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  TaborStatus status = tb_plate_coupling_prepare(model);
  if (status == TABOR_OK) status = tb_stretch_prepare(model);
  return status == TABOR_OK ? tb_cascade_prepare(model) : status;
}

static TaborStatus prepare_center(TaborModel *model, TbArena *scratch) {
  double *radial = tb_arena_doubles(scratch, model->body.row_count);
  model->center = tb_arena_doubles(&model->arena, model->modes.padded);
  if (model->arena.failed || scratch->failed) return TABOR_ERROR_MEMORY;
  tb_modes_shape(&model->modes, &model->body, model->wires.head, 0.0, 0.0, 1.0, NULL, radial,
                 model->center);
  return TABOR_OK;
}

static TaborStatus prepare_hihat(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  const TaborStatus status =
    tb_rod_prepare(&model->rod, &model->arena, &model->modes, &model->body);
  if (status != TABOR_OK) return status;
  return tb_hihat_air_prepare(&model->hihat_air, &model->arena, &model->def, &model->modes,
                              &model->body);
}

/* Room for a unit force's way through the head. */
typedef struct Probe {
  double *force, *grid, *answer, *fold;
} Probe;

/* Displacement of the head at a contact point one step after a unit force there. */
static double head_compliance(const TaborModel *model, const Probe *probe, uint32_t row) {
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  probe->force[row] = 1.0;
  model->kernels->rows_to_grid(wire_grid, probe->force, probe->fold, probe->grid);
  probe->force[row] = 0.0;
  model->kernels->apply_compliance(&model->compliance, probe->grid, probe->answer);
  return model->kernels->dot(wire_grid->size, probe->grid, probe->answer);
}

/* Wire contacts are per length: a node carries K h. */
static void prepare_law(TaborModel *model, const Probe *probe, uint32_t w) {
  const TbWires *wires = &model->wires;
  const TbWire *wire = &wires->wires[w];
  TbWireCoefficients c;
  tb_wire_coefficients(wire, model->time_step, wire->tension, wire->damping_0, wire->damping_1, &c);
  double head = 0.0;
  for (uint32_t i = 0; i < wire->row_count && tb_arena_go_on(&model->arena); i++) {
    const double here = head_compliance(model, probe, wire->first_row + i);
    model->yield[wire->first_row + i] = (float)here;
    head = fmax(head, here);
  }
  tb_contact_law_prepare(&wires->laws[w], wire->contact_stiffness * wire->spacing,
                         wire->contact_exponent, wire->contact_loss, model->time_step,
                         TB_SLOPE_LIMIT / (c.compliance + head));
}

static TaborStatus prepare_laws(TaborModel *model, TbArena *scratch) {
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  const Probe probe = {.force = tb_arena_doubles(scratch, model->wires.stride),
                       .grid = tb_arena_doubles(scratch, wire_grid->size),
                       .answer = tb_arena_doubles(scratch, wire_grid->size),
                       .fold = tb_arena_doubles(scratch, tb_wire_grid_scratch(wire_grid))};
  model->yield = tb_arena_take(&model->arena, tb_row_count(&model->rows), sizeof *model->yield);
  if (scratch->failed || model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t w = 0; w < model->wires.count; w++) prepare_law(model, &probe, w);
  return model->arena.failed ? TABOR_ERROR_MEMORY : TABOR_OK;
}

/* Modes and their projection, with `spare` modes at the end of each group. */
static TaborStatus list_modes(TaborModel *model, TbArena *arena, const uint8_t *low,
                              const uint32_t *spare, TbModes *modes, TbProjection *projection) {
  const TaborStatus status =
    tb_modes_prepare(modes, arena, &model->body, &model->wires, low, spare, model->time_step);
  if (status != TABOR_OK) return status;
  return tb_projection_prepare(projection, arena, modes, &model->body, &model->wires,
                               model->grid_tolerance);
}

/* The modes that stand for those left out depend on the grid, which depends on the others. */
static TaborStatus prepare_yield(TaborModel *model, TbArena *scratch, const uint8_t *low,
                                 TbWireYield *yield) {
  TbModes modes;
  TbProjection projection = model->projection;
  if (!tb_wire_yields(model)) return TABOR_OK;
  const TaborStatus status = list_modes(model, scratch, low, NULL, &modes, &projection);
  if (status != TABOR_OK) return status;
  return tb_wire_yield_prepare(yield, scratch, model, &projection);
}

static TaborStatus prepare_modes(TaborModel *model, TbArena *scratch) {
  TbWireYield yield = {.count = {0}};
  uint8_t *low = tb_arena_take(scratch, 2u * model->body.row_count, sizeof *low);
  if (!low) return TABOR_ERROR_MEMORY;
  TaborStatus status = tb_mics_find_low(model, scratch, low);
  if (status == TABOR_OK) status = prepare_yield(model, scratch, low, &yield);
  if (status != TABOR_OK) return status;
  status = list_modes(model, &model->arena, low, yield.count, &model->modes, &model->projection);
  if (status != TABOR_OK) return status;
  tb_wire_yield_apply(&yield, &model->modes, &model->projection, model->wires.side,
                      model->time_step);
  return tb_projection_round(&model->projection, &model->arena) ? TABOR_OK : TABOR_ERROR_MEMORY;
}

static TaborStatus prepare_mics(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  TaborStatus status = tb_mics_prepare(model);
  if (status == TABOR_OK) status = tb_radiated_power_prepare(model);
  if (status != TABOR_OK) return status;
  return tb_high_band_prepare(&model->high, &model->arena, model, model->top);
}

/* ---- strikers and rest ---------------------------------------------------------------------- */

static TaborStatus prepare_patches(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  model->palm_patch = tb_arena_doubles(&model->arena, model->body.zero_count);
  if (!model->palm_patch) return TABOR_ERROR_MEMORY;
  tb_body_patch(&model->body, TB_PALM_RADIUS, model->palm_patch);
  for (uint32_t i = 0; i <= model->def.striker_count; i++) {
    const bool hand = i == model->def.striker_count;
    double *patch = tb_arena_doubles(&model->arena, model->body.zero_count);
    if (!patch) return TABOR_ERROR_MEMORY;
    tb_body_patch(&model->body, hand ? TB_HAND_RADIUS : model->def.striker[i].contact_radius,
                  patch);
    model->patches[hand ? TABOR_MAX_STRIKERS : i] = patch;
    if (hand) break;
    model->high_patches[i] = tb_arena_doubles(&model->arena, model->high.padded);
    if (!model->high_patches[i]) return TABOR_ERROR_MEMORY;
    tb_high_band_patch(&model->high, model->def.striker[i].contact_radius, model->high_patches[i]);
  }
  return TABOR_OK;
}

static TaborStatus prepare_sticks(TaborModel *model, TbArena *scratch) {
  return tb_sticks_prepare(model->stick, scratch, &model->def, model->time_step)
           ? TABOR_OK
           : TABOR_ERROR_MEMORY;
}

static TaborStatus prepare_places(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  return tb_brush_shapes_prepare(model);
}

/* A head whose modes are all heard and felt has no others: a bandwidth that ends there says so. */
static TaborStatus prepare_truncated(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  const double bandwidth = model->def.quality.bandwidth;
  if (bandwidth > 0.0 && bandwidth <= model->body.bandwidth) return TABOR_OK;
  const TbSheetInAir struck = {.sheet = &model->body.sheet[TABOR_HEAD_BATTER],
                               .air = &model->def.air,
                               .losses = model->def.quality.losses != 0};
  for (uint32_t i = 0; i < model->def.striker_count; i++) {
    tb_truncated_modes_prepare(&model->truncated[i], &struck, model->body.bandwidth,
                               model->def.striker[i].contact_radius, model->time_step);
  }
  return TABOR_OK;
}

static TaborStatus allocate_rest(TaborModel *model, TbArena *scratch) {
  (void)scratch;
  TbRest *rest = &model->rest;
  rest->q = tb_arena_doubles(&model->arena, model->modes.padded);
  rest->v = tb_arena_doubles(&model->arena, model->wires.node_count);
  rest->bend = tb_arena_doubles(&model->arena, model->wires.node_count);
  rest->eta = tb_arena_doubles(&model->arena, model->wires.stride);
  rest->force = tb_arena_doubles(&model->arena, tb_row_count(&model->rows));
  rest->grid = tb_arena_doubles(&model->arena, model->projection.wire_grid.size);
  rest->offset = tb_arena_doubles(&model->arena, model->wires.count);
  return model->arena.failed ? TABOR_ERROR_MEMORY : TABOR_OK;
}

/* FNV-1a over what a saved state depends on. */
static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size) {
  const unsigned char *p = bytes;
  for (size_t i = 0; i < size; i++) hash = (hash ^ p[i]) * 1099511628211u;
  return hash;
}

uint64_t tb_model_fingerprint(const TaborModel *model) {
  uint64_t hash = 14695981039346656037u;
  hash = hash_bytes(hash, &model->sample_rate, sizeof model->sample_rate);
  hash = hash_bytes(hash, &model->modes.count, sizeof model->modes.count);
  hash = hash_bytes(hash, &model->wires.stride, sizeof model->wires.stride);
  hash = hash_bytes(hash, &model->layout, sizeof model->layout);
  hash = hash_bytes(hash, model->modes.a, model->modes.padded * sizeof *model->modes.a);
  hash = hash_bytes(hash, model->modes.sine, model->modes.padded * sizeof *model->modes.sine);
  hash = hash_bytes(hash, &model->axis, sizeof model->axis);
  hash = hash_bytes(hash, model->truncated, sizeof model->truncated);
  for (uint32_t i = 0; i < model->def.striker_count; i++) {
    for (uint32_t grip = 0; grip < TB_GRIPS;
         grip++) { /* the shapes follow from what precedes them */
      hash = hash_bytes(hash, &model->stick[i].grip[grip], offsetof(TbStickBody, shape));
    }
  }
  hash = hash_bytes(hash, model->rest.eta, model->wires.stride * sizeof *model->rest.eta);
  hash = hash_bytes(hash, model->rest.force, model->wires.stride * sizeof *model->rest.force);
  const size_t coupled = (size_t)model->lugs.count * model->lugs.count;
  hash = hash_bytes(hash, model->lugs.pull, coupled * sizeof *model->lugs.pull);
  return hash;
}

/* ---- public --------------------------------------------------------------------------------- */

#ifdef TB_HAVE_AVX512
static bool has_avx512(void) {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl");
}
#endif

static const TbKernels *choose_kernels(uint32_t instructions) {
  const uint32_t most = instructions ? instructions : TABOR_INSTRUCTIONS_AVX512;
  (void)most;
#ifdef TB_HAVE_AVX512
  if (most >= TABOR_INSTRUCTIONS_AVX512 && has_avx512()) return &tb_kernels_avx512;
#endif
#ifdef TB_HAVE_AVX2
  if (most >= TABOR_INSTRUCTIONS_AVX2 && __builtin_cpu_supports("avx2")) return &tb_kernels_avx2;
#endif
  return &tb_kernels_baseline;
}

/* No set is wider than AVX2's where eight numbers are one register. */
static const TbKernelsF *kernelsf_of(const TbKernels *kernels) {
#ifdef TB_HAVE_AVX2
  if (kernels != &tb_kernels_baseline) return &tb_kernels_avx2f;
#endif
  (void)kernels;
  return &tb_kernels_baselinef;
}

void tb_model_choose_kernels(TaborModel *model, uint32_t instructions) {
  model->kernels = choose_kernels(instructions);
  model->kernelsf = kernelsf_of(model->kernels);
}

static void set_accuracy(TaborModel *model, const TbLevel *level) {
  model->tolerance = level->tolerance;
  model->inner_tolerance = level->inner_tolerance;
  model->grid_tolerance = level->grid_tolerance;
  model->precision = level->precision;
  model->projection.precision = level->tables;
}

/* Modes, with the sine copies. */
static uint32_t mode_count(const TbBody *body) {
  uint32_t count = 0;
  for (uint32_t row = 0; row < body->row_count; row++) count += body->modes[row].m ? 2 : 1;
  return count;
}

/* A model with more than TB_FEW_MODES does not solve its contacts to rounding noise, which would
 * take four times as long: to 1e-6, balanced in energy as at studio, with shapes under the wires
 * right to 1e-4 and tables between modes and contact points in single precision. That is far below
 * what a stroke 0.1 % faster changes. */
static void relax_large(TaborModel *model, const TbLevel *level) {
  TbLevel relaxed = *level;
  if (mode_count(&model->body) <= TB_FEW_MODES) return;
  relaxed.tolerance = fmax(level->tolerance, 1e-6);
  relaxed.inner_tolerance = fmax(level->inner_tolerance, 1e-2);
  relaxed.grid_tolerance = fmax(level->grid_tolerance, 1e-4);
  relaxed.tables = TB_IN_FLOAT;
  set_accuracy(model, &relaxed);
}

/* The build is at this stage, which takes `seconds` of its time. */
static void begin_stage(TbWatch *watch, double seconds) {
  watch->done += watch->stage;
  watch->stage = seconds;
  watch->part = 0.0;
}

/* The axis of an uneven plate's pairs, from its own stroke: a stroke moves both copies of each, as
 * it does on a plate whose pairs have axes of their own [deg]. */
static const double OFF_STROKE = 40.0;

static double axis_of(const TaborDrumDef *def) {
  if (def->wires.count > 0) return def->wires.angle;
  const bool uneven = def->body.kind != TABOR_BODY_DRUM && def->plate.splitting > 0.0;
  return def->strike.angle + (uneven ? OFF_STROKE : 0.0);
}

static TaborStatus build(TaborModel *model, TbArena *scratch, const TbLevel *level,
                         const TbBuildCost *cost, TaborError *error) {
  TbWatch *watch = model->arena.watch;
  const double whole = tb_build_seconds(cost);
  begin_stage(watch, cost->heads / whole);
  TaborStatus status =
    tb_body_kind(&model->def)
      ->prepare(&model->body, &model->arena, &model->def, level->bandwidth,
                tb_level_limits(model->quality, model->def.wires.count * level->wire_cells,
                                model->step_rate));
  if (status != TABOR_OK) return status;
  if (model->body.row_count == 0) {
    return tb_error_set(
      error, TABOR_ERROR_RANGE, "quality.two_way_bandwidth", NULL, NAN, NAN,
      "no mode of this head or plate lies below the two-way bandwidth of %g Hz: it is too "
      "small, light or tense",
      model->body.bandwidth);
  }
  if (tb_body_kind(&model->def)->all_two_way) model->top = model->body.bandwidth; /* no high band */
  relax_large(model, level);
  model->axis = axis_of(&model->def);
  status = tb_rims_or_wires_prepare(&model->wires, &model->arena, &model->def, model->time_step,
                                    level->wire_cells, error);
  if (status != TABOR_OK) return status;
  model->rows = tb_rows(model->wires.stride);

  typedef struct Stage {
    TaborStatus (*prepare)(TaborModel *, TbArena *);
    double seconds;
  } Stage;
  const Stage stages[] = {{prepare_modes, cost->grid},
                          {prepare_compliance, 0.25 * cost->contacts},
                          {prepare_laws, 0.25 * cost->contacts},
                          {prepare_contacts, 0.0},
                          {prepare_stretch, 0.0},
                          {tb_wire_reach_prepare, 0.1 * cost->contacts},
                          {prepare_center, 0.0},
                          {prepare_hihat, 0.0},
                          {prepare_mics, cost->high_band},
                          {prepare_sticks, 0.0},
                          {prepare_patches, 0.0},
                          {prepare_places, 0.0},
                          {prepare_truncated, 0.0},
                          {allocate_rest, 0.0},
                          {tb_rest_prepare, 0.4 * cost->contacts}};
  for (size_t i = 0; status == TABOR_OK && i < sizeof stages / sizeof *stages; i++) {
    begin_stage(watch, stages[i].seconds / whole);
    status = stages[i].prepare(model, scratch);
  }
  if (status == TABOR_OK) status = tb_lug_modes_prepare(model, error);
  if (status == TABOR_OK) status = tb_resting_prepare(model);
  if (status == TABOR_OK) {
    tb_layout_prepare(&model->layout, model);
    model->fingerprint = tb_model_fingerprint(model);
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
  if (!options->allocator.allocate != !options->allocator.release) {
    return tb_error_set(error, TABOR_ERROR_ARGUMENT, "allocator", NULL, NAN, NAN,
                        "the allocator has only one of its two functions");
  }
  char value[TB_NUMBER_SIZE];
  if (!(options->sample_rate >= 22050.0 && options->sample_rate <= 192000.0)) {
    tb_number_print(options->sample_rate, value);
    return tb_error_set(error, TABOR_ERROR_RANGE, "sample_rate", value, 22050.0, 192000.0,
                        "sample rate %g Hz is outside 22050 to 192000 Hz", options->sample_rate);
  }
  if (options->quality > TABOR_QUALITY_REFERENCE) {
    tb_number_print(options->quality, value);
    return tb_error_set(error, TABOR_ERROR_RANGE, "quality", value, 0.0, TABOR_QUALITY_REFERENCE,
                        "unknown quality %u", (unsigned)options->quality);
  }
  if (options->instructions > TABOR_INSTRUCTIONS_AVX512) {
    tb_number_print(options->instructions, value);
    return tb_error_set(error, TABOR_ERROR_RANGE, "instructions", value, 0.0,
                        TABOR_INSTRUCTIONS_AVX512, "unknown instruction set %u",
                        (unsigned)options->instructions);
  }
  return TABOR_OK;
}

TaborStatus tb_model_memory_error(TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_MEMORY, NULL, NULL, NAN, NAN,
                      "out of memory while building a model");
}

TaborStatus tb_model_resolve_options(const TaborModelOptions *options, TaborModelOptions *chosen,
                                     TaborError *error) {
  tabor_model_options_default(chosen);
  if (options) *chosen = *options;
  const TaborStatus status = check_options(chosen, error);
  if (status == TABOR_OK) chosen->allocator = tb_allocator_resolve(&chosen->allocator);
  return status;
}

TaborModel *tb_model_allocate(const TaborModelOptions *options, TaborError *error) {
  const TaborAllocator *allocator = &options->allocator;
  TaborModel *model = allocator->allocate(sizeof *model, allocator->context);
  if (!model) {
    (void)tb_model_memory_error(error);
    return NULL;
  }
  memset(model, 0, sizeof *model);
  atomic_init(&model->references, 1u);
  tb_arena_prepare(&model->arena, allocator);
  return model;
}

/* Checks both, and puts options or defaults into `chosen`. */
static TaborStatus resolve(const TaborDrumDef *def, const TaborModelOptions *options,
                           TaborModelOptions *chosen, TaborError *error) {
  TaborStatus status = tabor_drum_def_validate(def, error);
  if (status == TABOR_OK) status = tb_model_resolve_options(options, chosen, error);
  if (status != TABOR_OK) return status;
  if (chosen->quality == TABOR_QUALITY_DEFAULT) chosen->quality = def->quality.level;
  return TABOR_OK;
}

/* To two digits, as an estimate is right within a factor. */
static double two_digits(double value) {
  double scale = 1.0;
  while (value / scale >= 100.0) scale *= 10.0;
  if (scale > 1.0 || value >= 10.0) return floor(value / scale + 0.5) * scale;
  while (value * scale < 10.0 && scale < 1e6) scale *= 10.0;
  return floor(value * scale + 0.5) / scale;
}

static TaborStatus limit_error(const TaborModelEstimate *estimate, bool slow, double limit,
                               TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_LIMIT, estimate->key, NULL, NAN, NAN,
                      "this model would take some %g s and %g MB to build, more than the limit of "
                      "%g %s: lower %s",
                      two_digits(estimate->seconds), two_digits(1e-6 * (double)estimate->bytes),
                      limit, slow ? "s" : "MB", estimate->key);
}

static TaborStatus check_limits(const TaborDrumDef *def, const TaborModelOptions *options,
                                TaborError *error) {
  TaborModelEstimate estimate;
  if (options->most_seconds <= 0.0 && options->most_bytes == 0) return TABOR_OK;
  const TaborStatus status = tb_build_estimate(def, options->quality, options->sample_rate,
                                               &options->allocator, &estimate, error);
  if (status != TABOR_OK) return status;
  if (options->most_seconds > 0.0 && estimate.seconds > options->most_seconds) {
    return limit_error(&estimate, true, options->most_seconds, error);
  }
  if (options->most_bytes > 0 && estimate.bytes > options->most_bytes) {
    return limit_error(&estimate, false, 1e-6 * (double)options->most_bytes, error);
  }
  return TABOR_OK;
}

TaborStatus tabor_model_estimate(const TaborDrumDef *def, const TaborModelOptions *options,
                                 TaborModelEstimate *estimate, TaborError *error) {
  TaborModelOptions chosen;
  if (!estimate) return tb_error_null(error, "place for the estimate");
  *estimate = (TaborModelEstimate){0};
  const TaborStatus status = resolve(def, options, &chosen, error);
  if (status != TABOR_OK) return status;
  return tb_build_estimate(def, chosen.quality, chosen.sample_rate, &chosen.allocator, estimate,
                           error);
}

/* Sets everything that does not depend on the heads. */
static TbLevel start(TaborModel *model, const TaborModelOptions *options) {
  model->quality = options->quality;
  model->sample_rate = options->sample_rate;
  model->steps = tb_level_steps(model->quality, model->sample_rate);
  model->step_rate = model->steps * model->sample_rate;
  model->time_step = 1.0 / model->step_rate;
  tb_model_choose_kernels(model, options->instructions);
  const TbLevel level = tb_level(&model->def, model->quality, model->sample_rate);
  model->newton_cap = level.newton_cap;
  model->inner_cap = level.inner_cap;
  set_accuracy(model, &level);
  model->top = level.top;
  return level;
}

/* A build took longer than its limit, though it was estimated to keep it. */
static TaborStatus late_error(const TaborDrumDef *def, const TaborModelOptions *options,
                              TaborError *error) {
  TaborModelEstimate estimate;
  const TaborStatus status = tb_build_estimate(def, options->quality, options->sample_rate,
                                               &options->allocator, &estimate, error);
  if (status != TABOR_OK) return status;
  return tb_error_set(error, TABOR_ERROR_LIMIT, estimate.key, NULL, NAN, NAN,
                      "this model takes longer to build than the limit of %g s: lower %s",
                      options->most_seconds, estimate.key);
}

static TaborStatus build_error(TaborStatus status, TaborError *error) {
  switch (status) {
  case TABOR_OK:
  case TABOR_ERROR_RANGE: return status; /* whoever found it has named it */
  case TABOR_ERROR_MEMORY: return tb_model_memory_error(error);
  case TABOR_ERROR_CANCELLED:
    return tb_error_set(error, status, NULL, NULL, NAN, NAN,
                        "the build of the model was cancelled");
  default:
    return tb_error_set(error, status, NULL, NULL, NAN, NAN,
                        "the modes or the rest state of this drum could not be computed");
  }
}

/* Tunes the heads of model->def, then computes the rest. */
static TaborStatus tune_and_build(TaborModel *model, const TaborModelOptions *options,
                                  TaborError *error) {
  TbBuildCost cost;
  TbArena scratch;
  TaborStatus status = tb_build_cost(&model->def, options->quality, options->sample_rate,
                                     &options->allocator, &cost, error);
  if (status != TABOR_OK) return status;
  begin_stage(model->arena.watch, cost.tuning / tb_build_seconds(&cost));
  status = tb_body_kind(&model->def)->resolve(&model->def, &model->arena, error);
  if (status != TABOR_OK) return status;
  const TbLevel level = start(model, options);
  tb_arena_beside(&scratch, &model->arena);
  status = build(model, &scratch, &level, &cost, error);
  tb_arena_release(&scratch);
  return status;
}

/* Builds the model of `def`, which is in model->def, and explains what ends it. */
static TaborStatus build_watched(TaborModel *model, const TaborDrumDef *def,
                                 const TaborModelOptions *options, TaborError *error) {
  TbWatch watch = {.go_on = options->progress,
                   .context = options->progress_context,
                   .began = tb_thread_time(),
                   .limit = options->most_seconds};
  model->arena.watch = &watch;
  const TaborStatus status = tune_and_build(model, options, error);
  model->arena.watch = NULL;
  if (watch.cancelled) return build_error(TABOR_ERROR_CANCELLED, error);
  if (watch.late) return late_error(def, options, error);
  if (status == TABOR_OK && options->progress) (void)options->progress(1.0, watch.context);
  return build_error(status, error);
}

TaborStatus tabor_model_create(const TaborDrumDef *def, const TaborModelOptions *options,
                               TaborModel **out, TaborError *error) {
  TaborModelOptions chosen;
  if (!out) return tb_error_null(error, "place for the model");
  *out = NULL;
  TaborStatus status = resolve(def, options, &chosen, error);
  if (status == TABOR_OK) status = check_limits(def, &chosen, error);
  if (status != TABOR_OK) return status;

  TaborModel *model = tb_model_allocate(&chosen, error);
  if (!model) return TABOR_ERROR_MEMORY;
  model->def = *def;
  if (error) error->status = TABOR_OK;
  status = build_watched(model, def, &chosen, error);
  if (status == TABOR_OK) {
    *out = model;
  } else {
    tabor_model_release(model);
  }
  return status;
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
