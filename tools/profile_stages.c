/* SPDX-License-Identifier: MIT */
/* Where the time of a sample goes: plays a preset as `tabor bench` does and prints, as one JSON
 * object, the time and the memory of every stage, the times of blocks, of building the model, and
 * of several drums on one model. Part of a profiling build alone (profile.h); the timers run for
 * the stages only. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drum/drum.h"
#include "inspect/workload.h"
#include "kernels/profile.h"
#include "platform/clock.h"

_Static_assert(TB_STAGE_COUNT == 11, "stage_names has a name for each stage");
static const char *const stage_names[TB_STAGE_COUNT] = {
  "other", "modes",    "projection", "wires",     "strikers", "stretch",
  "laws",  "products", "ledger",     "high_band", "mics"};

#define BLOCK 64u
#define MOST_REPEATS 100u
#define MOST_DRUMS 64u
#define MOST_ARRAYS 256u

typedef struct Request {
  const char *preset;
  TaborDrumDef def;
  TaborModelOptions options;
  double seconds;
  uint32_t repeats;
  uint32_t instances[16], instance_count;
} Request;

typedef struct Series {
  double values[MOST_REPEATS];
  uint32_t count;
} Series;

static _Noreturn void stop(const char *message) {
  fprintf(stderr, "profile-stages: %s\n", message);
  exit(2);
}

static void check(TaborStatus status, const TaborError *error) {
  if (status != TABOR_OK) stop(error->message);
}

static void *memory(size_t count, size_t size) {
  void *const bytes = calloc(count, size);
  if (!bytes) stop("out of memory");
  return bytes;
}

static double processor_time(void) { return stopwatch_seconds(CLOCK_THREAD_CPUTIME_ID); }

static int compare_numbers(const void *left, const void *right) {
  const double a = *(const double *)left, b = *(const double *)right;
  return a < b ? -1 : a > b;
}

static void print_series(const char *name, Series *series) {
  qsort(series->values, series->count, sizeof *series->values, compare_numbers);
  printf("  \"%s\": {\"smallest\": %.9g, \"median\": %.9g},\n", name, series->values[0],
         series->values[series->count / 2]);
}

/* ---- playing -------------------------------------------------------------------------------- */

static uint32_t frames_of(const Request *request) {
  return (uint32_t)lround(request->seconds * request->options.sample_rate) / BLOCK * BLOCK;
}

/* The first stroke from frame `start` on; a block has one at most. */
static TaborEvent next_stroke(const Request *request, uint32_t start) {
  const double rate = request->options.sample_rate;
  uint32_t index = (uint32_t)(start / (WORKLOAD_INTERVAL * rate));
  TaborEvent stroke = workload_stroke(&request->def, rate, index);
  while (stroke.frame < start) stroke = workload_stroke(&request->def, rate, ++index);
  return stroke;
}

/* One block of every drum in turn from frame `start` on. */
static void play_block(const Request *request, TaborDrum *const *drums, uint32_t count,
                       uint32_t start) {
  static float sound[BLOCK];
  float *outputs[TABOR_MAX_MICS] = {sound};
  TaborEvent event = next_stroke(request, start);
  const bool struck = event.frame < start + BLOCK;
  event.frame -= start;
  for (uint32_t i = 0; i < count; i++) {
    tabor_drum_process(drums[i], struck ? &event : NULL, struck, outputs, BLOCK);
  }
}

/* Processor time of a whole play [s]; blocks[] keeps the smallest time of each block, if it is not
 * NULL. */
static double play(const Request *request, TaborDrum *const *drums, uint32_t count,
                   double *blocks) {
  const uint32_t frames = frames_of(request);
  for (uint32_t i = 0; i < count; i++) tabor_drum_reset(drums[i]);
  const double before = processor_time();
  double last = before;
  for (uint32_t start = 0; start < frames; start += BLOCK) {
    play_block(request, drums, count, start);
    if (!blocks) continue;
    const double now = processor_time();
    blocks[start / BLOCK] = fmin(blocks[start / BLOCK], now - last);
    last = now;
  }
  return processor_time() - before;
}

static TaborDrum *create_drum(TaborModel *model) {
  TaborDrum *drum = NULL;
  TaborError error;
  check(tabor_drum_create(model, &drum, &error), &error);
  return drum;
}

/* ---- memory --------------------------------------------------------------------------------- */

typedef struct Touched {
  TbStage stage;
  const void *array;
  size_t bytes;
} Touched;

/* Arrays that a sample reads or writes while all wires touch, with one striker and one microphone.
 */
typedef struct Memory {
  Touched touched[MOST_ARRAYS];
  uint32_t count;
  const TaborModel *model;
  TbView view;
} Memory;

static void touch(Memory *memory, TbStage stage, const void *array, size_t bytes) {
  if (!array || bytes == 0) return;
  if (memory->count == MOST_ARRAYS) stop("too many arrays");
  memory->touched[memory->count++] = (Touched){stage, array, bytes};
}

/* The arrays up to a NULL, each of `count` doubles. */
static void touch_all(Memory *memory, TbStage stage, size_t count, const double *const *arrays) {
  for (; *arrays; arrays++) touch(memory, stage, *arrays, count * sizeof(double));
}

#define TOUCH(memory, stage, count, ...)                                                           \
  touch_all(memory, stage, count, (const double *const[]){__VA_ARGS__, NULL})

static void touch_modes(Memory *memory) {
  const TbModes *m = &memory->model->modes;
  const TbView *v = &memory->view;
  TOUCH(memory, TB_STAGE_MODES, m->padded, v->next.q, v->now.q, v->last.q, m->a, m->b);
  TOUCH(memory, TB_STAGE_LEDGER, m->padded, v->next.q, v->last.q, m->loss_head, m->loss_air);
  if (m->walls) TOUCH(memory, TB_STAGE_LEDGER, m->padded, m->loss_shell);
  const TbMic *mic = &memory->model->mics[0];
  TOUCH(memory, TB_STAGE_MICS, m->padded, mic->ahead, mic->behind, v->next.q);
}

static void touch_wires(Memory *memory) {
  const TaborModel *model = memory->model;
  const TbWires *w = &model->wires;
  const TbView *v = &memory->view;
  if (w->count == 0) return;
  TOUCH(memory, TB_STAGE_MODES, model->modes.group[model->modes.groups], model->modes.pull,
        v->modal);
  TOUCH(memory, TB_STAGE_WIRES, w->node_count, v->next.v, v->now.v, v->last.v, v->bend);
  TOUCH(memory, TB_STAGE_WIRES, w->stride, w->inner, v->head, model->rest.eta, v->last.eta,
        v->rest_load, v->b, v->contact_compliance, v->solve.warm.force, model->rest.force, v->s,
        v->next.eta);
  touch(memory, TB_STAGE_WIRES, v->state->wires.coefficients,
        w->count * sizeof *v->state->wires.coefficients);
  TOUCH(memory, TB_STAGE_LEDGER, w->node_count, v->next.v, v->last.v);
}

static void touch_bed(Memory *memory, TbStage stage, bool there, bool back) {
  const TbWireGrid *wire_grid = &memory->model->projection.wire_grid;
  TOUCH(memory, stage, (size_t)wire_grid->wires * wire_grid->lines, wire_grid->across);
  TOUCH(memory, stage, tb_wire_grid_scratch(wire_grid), memory->view.solve.work.scratch);
  for (uint32_t along = 0; along < wire_grid->halves && wire_grid->thinned; along++) {
    const size_t size = (size_t)wire_grid->half * wire_grid->columns[along];
    if (there)
      TOUCH(memory, stage, (size_t)wire_grid->half * wire_grid->padded[along],
            wire_grid->contract[along]);
    if (back) TOUCH(memory, stage, size, wire_grid->expand[along]);
  }
}

static void touch_tables(Memory *memory, TbStage stage, const TbProjection *projection) {
  for (uint32_t g = 0; g < projection->groups; g++) {
    const TbProjectionGroup *group = &projection->group[g];
    const size_t size = (size_t)group->points * group->modes;
    const bool rounded = projection->precision == TB_IN_FLOAT;
    touch(memory, stage, rounded ? (const void *)group->gather_rounded : group->gather,
          size * (rounded ? sizeof(float) : sizeof(double)));
    touch(memory, stage, rounded ? (const void *)group->scatter_rounded : group->scatter,
          size * (rounded ? sizeof(float) : sizeof(double)));
  }
}

static void touch_projection(Memory *memory) {
  const TaborModel *model = memory->model;
  const TbView *v = &memory->view;
  if (model->wires.count == 0) return;
  const size_t coupled = model->modes.group[model->modes.groups];
  touch_tables(memory, TB_STAGE_PROJECTION, &model->projection);
  touch_bed(memory, TB_STAGE_PROJECTION, false, true);
  TOUCH(memory, TB_STAGE_PROJECTION, coupled, v->next.q, v->modal);
  TOUCH(memory, TB_STAGE_PROJECTION, model->projection.wire_grid.size, v->change,
        v->solve.warm.grid, model->rest.grid);
  TOUCH(memory, TB_STAGE_PROJECTION, model->wires.stride, v->head);
}

static void touch_solve(Memory *memory) {
  const TaborModel *model = memory->model;
  const TbSolve *s = &memory->view.solve;
  const size_t rows = model->wires.stride + TB_SLOTS, size = model->projection.wire_grid.size;
  const TbSolveWork *w = &s->work;
  TOUCH(memory, TB_STAGE_LAWS, rows, s->in.b, s->in.y, w->s, w->force, w->product, w->force_last,
        w->product_last, w->law, w->slope, w->mean, w->residual, w->direction, w->turned, w->moved,
        w->weight, w->solution);
  TOUCH(memory, TB_STAGE_PRODUCT, rows, s->in.contact_compliance, w->law, w->product, w->turned,
        w->moved);
  if (model->wires.count == 0) return;
  TOUCH(memory, TB_STAGE_LAWS, size, w->grid, w->grid_last, w->pushed);
  touch(memory, TB_STAGE_LAWS, s->in.wire_laws, model->wires.count * sizeof *s->in.wire_laws);
  touch_bed(memory, TB_STAGE_PRODUCT, true, true);
  TOUCH(memory, TB_STAGE_PRODUCT, size, w->grid, w->pushed, w->answer);
  for (uint32_t g = 0; g < model->compliance.classes; g++) {
    const size_t points = model->compliance.first[g + 1] - model->compliance.first[g];
    TOUCH(memory, TB_STAGE_PRODUCT, points * points, model->compliance.matrix[g]);
  }
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    TOUCH(memory, TB_STAGE_PRODUCT, size, s->in.stretch_grid[h]);
  }
}

static void touch_stretch(Memory *memory) {
  const TbStretch *stretch = &memory->model->stretch;
  const TbView *v = &memory->view;
  if (stretch->count == 0) return;
  size_t modes = 0;
  for (uint32_t g = 0; g <= memory->model->modes.groups; g++) modes += stretch->parts.size[g];
  const size_t size = memory->model->projection.wire_grid.size;
  TOUCH(memory, TB_STAGE_STRETCH, modes, v->next.q, v->now.q, v->last.q, memory->model->modes.g);
  for (uint32_t h = 0; h < stretch->count; h++) {
    TOUCH(memory, TB_STAGE_STRETCH, modes, stretch->gain[h], v->stretch.pull[h]);
    TOUCH(memory, TB_STAGE_STRETCH, size, v->solve.in.stretch_grid[h]);
  }
  TOUCH(memory, TB_STAGE_STRETCH, size, v->stretch.carry, v->solve.warm.grid, v->solve.work.answer);
  if (memory->model->wires.count) touch_bed(memory, TB_STAGE_STRETCH, false, true);
}

/* Of a double: a band of single precision touches its rounded arrays in place of those named below.
 */
static size_t high_part(const TbHighBand *high) { return high->precision == TB_IN_FLOAT ? 2 : 1; }

static void touch_strikers(Memory *memory) {
  const TaborModel *model = memory->model;
  const TbView *v = &memory->view;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    if (tb_slot(v, i)->kind == TB_SLOT_FREE) continue;
    TOUCH(memory, TB_STAGE_STRIKERS, model->modes.padded, tb_slot_shape(v, i), tb_slot_drive(v, i),
          v->next.q);
    TOUCH(memory, TB_STAGE_PRODUCT, model->projection.wire_grid.size, tb_slot_coupling(v, i));
    if (tb_slot_strikes(tb_slot(v, i))) {
      TOUCH(memory, TB_STAGE_HIGH, model->high.begin[1] / high_part(&model->high), v->high.drive);
    }
  }
}

static void touch_high(Memory *memory) {
  const TbHighBand *h = &memory->model->high;
  const TbWires *w = &memory->model->wires;
  const TbView *v = &memory->view;
  if (h->count == 0) return;
  const size_t part = high_part(h);
  TOUCH(memory, TB_STAGE_HIGH, h->padded / part, h->ringing.a, h->ringing.b, v->next.high,
        v->now.high, v->last.high, h->ringing.ahead[0], h->ringing.behind[0]);
  if (w->count == 0) return;
  for (int p = 0; p < 2; p++) {
    touch(memory, TB_STAGE_HIGH, h->push[p].table,
          (size_t)h->push[p].rows * h->push[p].size * sizeof *h->push[p].table);
  }
  touch(memory, TB_STAGE_HIGH, h->row_group, w->stride * sizeof *h->row_group);
  touch(memory, TB_STAGE_HIGH, v->high.force, h->driven * sizeof *v->high.force);
  TOUCH(memory, TB_STAGE_HIGH, w->stride, v->solve.warm.force, memory->model->rest.force,
        v->solve.work.turned);
  TOUCH(memory, TB_STAGE_HIGH, (h->begin[w->head + 1] - h->begin[w->head]) / part, v->high.taken);
}

/* Bytes by stage, and in bytes[TB_STAGE_COUNT] those of all: an array counts once, at its largest.
 */
static void count_bytes(const Request *request, TaborDrum *drum, size_t *bytes) {
  const TaborEvent event = workload_stroke(&request->def, request->options.sample_rate, 0);
  tabor_drum_reset(drum);
  tabor_drum_process(drum, &event, 1, NULL, 1);
  Memory memory = {.model = drum->model, .view = tb_view(drum->state, drum->model)};
  touch_modes(&memory);
  touch_wires(&memory);
  touch_projection(&memory);
  touch_solve(&memory);
  touch_stretch(&memory);
  touch_strikers(&memory);
  touch_high(&memory);
  for (uint32_t i = 0; i < memory.count; i++) {
    const Touched *one = &memory.touched[i];
    bytes[one->stage] += one->bytes;
    size_t before = 0;
    for (uint32_t j = 0; j < i; j++) {
      const Touched *other = &memory.touched[j];
      if (other->array == one->array && other->bytes > before) before = other->bytes;
    }
    if (one->bytes > before) bytes[TB_STAGE_COUNT] += one->bytes - before;
  }
}

/* ---- stages --------------------------------------------------------------------------------- */

typedef struct Ticks {
  uint64_t of[TB_STAGE_COUNT];
} Ticks;

/* The least that each stage took in each block: the counter also runs while others have the
 * processor, but hardly in the same stage of the same block in every repeat. */
typedef struct Stages {
  Ticks *blocks;
  uint32_t count;
  uint64_t entries[TB_STAGE_COUNT]; /* of a play; the same in all */
  double timer_ticks;               /* the least that one reading of the counter takes */
  double tick;                      /* [s] */
} Stages;

static void keep_least(Ticks *least, const TbProfile *profile) {
  for (int i = 0; i < TB_STAGE_COUNT; i++) {
    if (profile->ticks[i] < least->of[i]) least->of[i] = profile->ticks[i];
  }
}

static void time_stages(const Request *request, TaborDrum *drum, Stages *stages) {
  TbProfile *const profile = &tb_profile;
  tabor_drum_reset(drum);
  memset(stages->entries, 0, sizeof stages->entries);
  for (uint32_t block = 0; block < stages->count; block++) {
    *profile = (TbProfile){.on = true, .since = tb_profile_ticks()};
    play_block(request, &drum, 1, block * BLOCK);
    TB_STAGE(OTHER);
    profile->on = false;
    keep_least(&stages->blocks[block], profile);
    for (int i = 0; i < TB_STAGE_COUNT; i++) stages->entries[i] += profile->entries[i];
  }
}

/* The least ticks that a stage without any work takes. */
static double timer_ticks(void) {
  TbProfile *const profile = &tb_profile;
  uint64_t least = UINT64_MAX;
  for (int i = 0; i < 100; i++) {
    *profile = (TbProfile){.on = true, .since = tb_profile_ticks()};
    for (int j = 0; j < 1000; j++) TB_STAGE(OTHER);
    if (profile->ticks[TB_STAGE_OTHER] < least) least = profile->ticks[TB_STAGE_OTHER];
  }
  profile->on = false;
  return (double)least / 1000.0;
}

/* How long a tick lasts [s], by the clock on the wall. */
static double tick_length(void) {
  const double from = stopwatch_seconds(CLOCK_MONOTONIC);
  const uint64_t first = tb_profile_ticks();
  double now = from;
  while (now < from + 0.05) now = stopwatch_seconds(CLOCK_MONOTONIC);
  return (now - from) / (double)(tb_profile_ticks() - first);
}

static Stages prepare_stages(uint32_t count) {
  Stages stages = {.blocks = memory(count, sizeof *stages.blocks),
                   .count = count,
                   .timer_ticks = timer_ticks(),
                   .tick = tick_length()};
  memset(stages.blocks, 0xff, count * sizeof *stages.blocks);
  return stages;
}

static void print_stages(const Request *request, const Stages *stages, const size_t *bytes) {
  const double scale = 1e9 * stages->tick / frames_of(request);
  double sum = 0, timers = 0;
  printf("  \"stages\": {");
  for (int i = 0; i < TB_STAGE_COUNT; i++) {
    const double timer = stages->timer_ticks * (double)stages->entries[i];
    double ticks = 0;
    for (uint32_t block = 0; block < stages->count; block++) {
      ticks += (double)stages->blocks[block].of[i];
    }
    const double ns = scale * fmax(0.0, ticks - timer);
    sum += ns;
    timers += scale * timer;
    printf("%s\n    \"%s\": {\"ns\": %.1f, \"bytes\": %zu}", i ? "," : "", stage_names[i], ns,
           bytes[i]);
  }
  printf("\n  },\n  \"sample\": {\"ns\": %.1f, \"bytes\": %zu, \"timers_ns\": %.1f},\n", sum,
         bytes[TB_STAGE_COUNT], timers);
}

/* ---- the measurement ------------------------------------------------------------------------ */

static TaborModel *build_model(const Request *request, Series *times) {
  TaborModel *model = NULL;
  TaborError error;
  for (uint32_t i = 0; i < request->repeats; i++) {
    tabor_model_release(model);
    const double before = processor_time();
    check(tabor_model_create(&request->def, &request->options, &model, &error), &error);
    times->values[times->count++] = processor_time() - before;
  }
  return model;
}

/* `stroke`: the mean of the blocks in which a stroke begins. */
static void print_blocks(const Request *request, double *blocks, uint32_t count) {
  double sum = 0;
  uint32_t strokes = 0;
  for (uint32_t i = 0; i < count; i++) {
    if (next_stroke(request, i * BLOCK).frame >= (i + 1) * BLOCK) continue;
    sum += blocks[i];
    strokes++;
  }
  qsort(blocks, count, sizeof *blocks, compare_numbers);
  printf(
    "  \"block_time_us\": {\"median\": %.6g, \"p99\": %.6g, \"max\": %.6g, \"stroke\": %.6g},\n",
    1e6 * blocks[count / 2], 1e6 * blocks[(uint32_t)ceil(0.99 * count) - 1],
    1e6 * blocks[count - 1], 1e6 * sum / strokes);
}

static void measure_one(const Request *request, TaborModel *model) {
  TaborDrum *drum = create_drum(model);
  const uint32_t count = frames_of(request) / BLOCK;
  const double duration = frames_of(request) / request->options.sample_rate;
  double *const blocks = memory(count, sizeof *blocks);
  for (uint32_t i = 0; i < count; i++) blocks[i] = INFINITY;
  size_t bytes[TB_STAGE_COUNT + 1] = {0};
  Series factors = {.count = 0};
  Stages stages = prepare_stages(count);
  for (uint32_t i = 0; i < request->repeats; i++) {
    factors.values[factors.count++] = play(request, &drum, 1, blocks) / duration;
    time_stages(request, drum, &stages);
  }
  count_bytes(request, drum, bytes);
  print_series("real_time_factor", &factors);
  print_blocks(request, blocks, count);
  print_stages(request, &stages, bytes);
  free(blocks);
  free(stages.blocks);
  tabor_drum_destroy(drum);
}

static void measure_instances(const Request *request, TaborModel *model) {
  const double duration = frames_of(request) / request->options.sample_rate;
  TaborDrum *drums[MOST_DRUMS];
  Series factors[sizeof request->instances / sizeof request->instances[0]] = {{.count = 0}};
  for (uint32_t i = 0; i < MOST_DRUMS; i++) drums[i] = NULL;
  for (uint32_t r = 0; r < request->repeats; r++) {
    for (uint32_t i = 0; i < request->instance_count; i++) {
      const uint32_t count = request->instances[i];
      for (uint32_t d = 0; d < count; d++) {
        if (!drums[d]) drums[d] = create_drum(model);
      }
      Series *const series = &factors[i];
      series->values[series->count++] = play(request, drums, count, NULL) / duration;
    }
  }
  for (uint32_t i = 0; i < MOST_DRUMS; i++) tabor_drum_destroy(drums[i]);
  printf("  \"instances\": [");
  for (uint32_t i = 0; i < request->instance_count; i++) {
    Series *const s = &factors[i];
    qsort(s->values, s->count, sizeof *s->values, compare_numbers);
    printf("%s\n    {\"count\": %" PRIu32
           ", \"real_time_factor\": {\"smallest\": %.9g, \"median\": %.9g}}",
           i ? "," : "", request->instances[i], s->values[0], s->values[s->count / 2]);
  }
  printf("\n  ],\n");
}

static void print_compiler(void) {
#if defined(__clang__)
  printf("  \"compiler\": \"clang %s\"\n", __clang_version__);
#else
  printf("  \"compiler\": \"gcc %s\"\n", __VERSION__);
#endif
}

static void measure(const Request *request) {
  Series builds = {.count = 0};
  TaborModel *model = build_model(request, &builds);
  TaborModelInfo info;
  tabor_model_info(model, &info);
  printf("{\n  \"preset\": \"%s\", \"rate\": %.0f, \"seconds\": %g, \"repeats\": %" PRIu32 ",\n",
         request->preset, request->options.sample_rate, request->seconds, request->repeats);
  printf("  \"modes\": %" PRIu32 ", \"high_modes\": %" PRIu32 ", \"wires\": %" PRIu32
         ", \"contact_points\": %" PRIu32 ", \"grid\": %" PRIu32 ",\n",
         info.mode_count, info.high_mode_count, info.wire_count, info.contact_points,
         model->wires.count ? model->projection.wire_grid.size : 0u);
  printf("  \"model_bytes\": %zu, \"drum_bytes\": %zu,\n", info.model_bytes, info.drum_bytes);
  print_series("build_s", &builds);
  if (request->instance_count) {
    measure_instances(request, model);
  } else {
    measure_one(request, model);
  }
  print_compiler();
  printf("}\n");
  tabor_model_release(model);
}

/* ---- the request ---------------------------------------------------------------------------- */

static const char usage[] =
  "usage: profile-stages PRESET [OPTION=VALUE...]\n"
  "rate=48000 quality=live instructions=auto seconds=1.25 repeats=3, KEY=VALUE of the drum;\n"
  "instances=1,2,4 times so many drums on one model instead of the stages.\n";

static uint32_t choose(const char *const *words, const char *word) {
  for (uint32_t i = 0; words[i]; i++) {
    if (strcmp(words[i], word) == 0) return i;
  }
  stop("unknown word");
}

static void read_instances(Request *request, const char *value) {
  const uint32_t most = sizeof request->instances / sizeof request->instances[0];
  for (const char *at = value; request->instance_count < most;) {
    char *end;
    const unsigned long count = strtoul(at, &end, 10);
    if (end == at || count < 1 || count > MOST_DRUMS) stop("instances: 1 to 64 each");
    request->instances[request->instance_count++] = (uint32_t)count;
    if (*end != ',') break;
    at = end + 1;
  }
}

static bool is(const char *option, const char *name) {
  const size_t length = strlen(name);
  return strncmp(option, name, length) == 0 && option[length] == '=';
}

static void read_key(Request *request, const char *option) {
  char key[128];
  const size_t length = strcspn(option, "=");
  if (!option[length] || length >= sizeof key) stop("not of the form OPTION=VALUE");
  memcpy(key, option, length);
  key[length] = '\0';
  TaborError error;
  check(tabor_drum_def_set(&request->def, key, option + length + 1, &error), &error);
}

static void read_option(Request *request, const char *option) {
  static const char *const qualities[] = {"default", "draft", "live", "studio", "reference", NULL};
  static const char *const sets[] = {"auto", "baseline", "avx2", "avx512", NULL};
  const char *const value = option + strcspn(option, "=") + 1;
  if (is(option, "rate")) {
    request->options.sample_rate = strtod(value, NULL);
  } else if (is(option, "quality")) {
    request->options.quality = choose(qualities, value);
  } else if (is(option, "instructions")) {
    request->options.instructions = choose(sets, value);
  } else if (is(option, "seconds")) {
    request->seconds = strtod(value, NULL);
  } else if (is(option, "repeats")) {
    request->repeats = (uint32_t)strtoul(value, NULL, 10);
  } else if (is(option, "instances")) {
    read_instances(request, value);
  } else {
    read_key(request, option);
  }
}

int main(int argc, char **argv) {
  static Request request = {.seconds = 1.25, .repeats = 3};
  TaborError error;
  if (argc < 2 || argv[1][0] == '-') {
    fputs(usage, argc == 2 && strcmp(argv[1], "--help") == 0 ? stdout : stderr);
    return argc == 2 && strcmp(argv[1], "--help") == 0 ? 0 : 2;
  }
  request.preset = argv[1];
  tabor_model_options_default(&request.options);
  request.options.quality = TABOR_QUALITY_LIVE;
  check(tabor_drum_def_preset(&request.def, argv[1], &error), &error);
  for (int i = 2; i < argc; i++) read_option(&request, argv[i]);
  if (request.repeats < 1 || request.repeats > MOST_REPEATS) stop("repeats: 1 to 100");
  if (!(request.seconds >= 0.01 && request.seconds <= 60)) stop("seconds: 0.01 to 60");
  measure(&request);
  return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 1;
}
