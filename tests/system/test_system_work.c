/* SPDX-License-Identifier: MIT */
/* How much work a sample is, counted: elements that the kernels (kernels.h) pass through, whatever
 * the machine. It has a bound that no playing can exceed, and playing stays far below it. */
#include "drum/drum.h"
#include "kernels/contact_law.h"
#include "kernels/kernels.h"
#include "physics.h"

static const double RATE = 48000.0;
static uint64_t work;     /* multiplications, or passes through an element */
static uint64_t products; /* with the heads' compliance: one expands the bed each */
static uint64_t laws;     /* elements whose contact law was evaluated */

/* ---- kernels that count ---------------------------------------------------------------------- */

static uint64_t modes_of(const TbParts *parts) {
  uint64_t sum = 0;
  for (uint32_t part = 0; part < parts->count; part++) sum += parts->end[part] - parts->from[part];
  return sum;
}

static uint64_t terms_of(const TbMixing *mixing) {
  uint64_t sum = 0;
  for (uint32_t b = 0; b < mixing->count; b++) {
    sum += (uint64_t)mixing->block[b].count * mixing->block[b].count;
  }
  return mixing->heads * sum;
}

#define TB_TEMPLATE "counted_singles.h"
#include "kernels/both.h"

/* A table of functions without gaps. */
static void assert_whole(const void *table, size_t size) {
  for (size_t at = 0; at < size; at += sizeof(void (*)(void))) {
    void (*kernel)(void);
    memcpy(&kernel, (const char *)table + at, sizeof kernel);
    assert_true(kernel != NULL);
  }
}

static void every_kernel_is_counted(void **state) {
  (void)state;
  assert_whole(&counting, sizeof counting);
  assert_whole(&counting_floats, sizeof counting_floats);
}

/* ---- playing --------------------------------------------------------------------------------- */

typedef struct Counts {
  uint64_t work, products, laws;
} Counts;

static Counts sample_of(TaborDrum *drum, const TaborEvent *events, uint32_t count) {
  float sample, *outputs[TABOR_MAX_MICS] = {&sample};
  work = products = laws = 0;
  tabor_drum_process(drum, events, count, outputs, 1);
  return (Counts){work, products, laws};
}

static void raise_counts(Counts *most, Counts counts) {
  if (counts.work > most->work) most->work = counts.work;
  if (counts.products > most->products) most->products = counts.products;
  if (counts.laws > most->laws) most->laws = counts.laws;
}

static TaborModel *counting_model(const TaborDrumDef *def) {
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_LIVE);
  model->kernels = &counting;
  model->kernelsf = &counting_floats;
  return model;
}

/* Every product expands the bed once. A Newton step takes as many as its conjugate gradients and
 * one for the residual, in single precision and, where that came to nothing, in double; there one
 * more is for the forces to begin with, and one more ends the steps at the cap. Two majorants take
 * 32 each, one for the residual and one for the forces; the free motion and the stretch expand it
 * once each. */
static uint64_t most_products(const TaborModel *model) {
  const uint64_t newton = (uint64_t)model->newton_cap * (model->inner_cap + 1u);
  return newton + 1u + newton + 2u + 2u * (32u + 2u) + 2u;
}

/* Before each step, at its end and after a balance that came to nothing; a balance takes 8, or 4 in
 * single precision. */
static uint64_t most_laws(const TaborModel *model) {
  const uint64_t steps = model->newton_cap + 1u;
  return model->wires.stride * (1u + steps * (2u + 4u) + steps * (2u + 8u) + 1u + 8u);
}

/* All the strikers that a drum holds land at once, where one sees the head everywhere, and hands
 * press. */
static uint32_t everything_at_once(const TaborDrumDef *def, double velocity, TaborEvent *events) {
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    events[i] = physics_strike(def);
    events[i].id = i + 1;
    events[i].velocity = velocity;
    events[i].radius = 0.9 * def->shell.radius * (double)i / TB_SLOTS;
    events[i].angle = 40.0 * i;
    if (i % 4 == 3) {
      events[i].type = TABOR_EVENT_DAMP;
      events[i].value = 20.0;
    }
  }
  return TB_SLOTS;
}

static Counts play_at_once(const TaborDrumDef *def, double velocity, uint32_t samples,
                           TaborStatistics *statistics) {
  TaborModel *model = counting_model(def);
  TaborDrum *drum = physics_drum(model);
  TaborEvent events[TB_SLOTS];
  const uint32_t count = everything_at_once(def, velocity, events);
  Counts most = {0};
  for (uint32_t i = 0; i < samples; i++) {
    const Counts counts = sample_of(drum, events, i % 480 == 0 ? count : 0);
    assert_true(counts.products <= most_products(model));
    assert_true(counts.laws <= most_laws(model));
    raise_counts(&most, counts);
  }
  tabor_drum_statistics(drum, statistics);
  print_message(
    "%s, %g m/s: at most %llu products (bound %llu), %llu law points (bound %llu), %llu elements; "
    "%llu points in contact, %llu samples at the cap, %llu fallbacks\n",
    def->name, velocity, (unsigned long long)most.products,
    (unsigned long long)most_products(model), (unsigned long long)most.laws,
    (unsigned long long)most_laws(model), (unsigned long long)most.work,
    (unsigned long long)statistics->contact_max, (unsigned long long)statistics->newton_capped,
    (unsigned long long)statistics->fallbacks);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return most;
}

static void everything_in_contact_keeps_the_bound(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("snare-14x5.5");
  physics_lay_even(&def);
  def.wires.contact_stiffness = 3e7; /* so soft that they lie on the head all along */
  TaborStatistics statistics;
  play_at_once(&def, 0.3, 1440, &statistics);
  assert_true(statistics.contact_max >= 450); /* nearly all of the 460 points, and the strikers */
  play_at_once(&def, 12.0, 1440, &statistics);
}

/* Two steps are too few for the stiffest contacts there are: the solve comes to its remedies. */
static void remedies_keep_the_bound(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.wires.contact_stiffness = 1e13;
  def.quality.newton_cap = 2;
  TaborStatistics statistics;
  play_at_once(&def, 30.0, 960, &statistics);
  assert_true(statistics.newton_capped > 0);
}

/* ---- evenness -------------------------------------------------------------------------------- */

#define BLOCKS 375u

static int compare_counts(const void *left, const void *right) {
  const uint64_t a = *(const uint64_t *)left, b = *(const uint64_t *)right;
  return (a > b) - (a < b);
}

/* The work of blocks of 64 samples, sorted, of a roll of a stroke each eighth of a second, every
 * second one soft. */
static void play_roll(double soft, uint64_t blocks[BLOCKS]) {
  TaborDrumDef def = physics_preset("snare-14x5.5");
  TaborModel *model = counting_model(&def);
  TaborDrum *drum = physics_drum(model);
  float samples[64], *outputs[TABOR_MAX_MICS] = {samples};
  for (uint32_t block = 0; block < BLOCKS; block++) {
    TaborEvent stroke = physics_strike(&def);
    stroke.velocity = block / 94 % 2 ? 4.0 : soft;
    stroke.radius = 0.2 * (block / 94 % 5) * def.shell.radius;
    work = 0;
    tabor_drum_process(drum, &stroke, block % 94 == 0, outputs, 64);
    blocks[block] = work;
  }
  qsort(blocks, BLOCKS, sizeof *blocks, compare_counts);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* No block is 1.6 times the median's work in a loud roll, of a loud roll or of one with soft
 * strokes between, where heads move as linear ones: that saves a third of most blocks, but nothing
 * of the worst. */
static void a_roll_is_even(void **state) {
  (void)state;
  uint64_t loud[BLOCKS], mixed[BLOCKS];
  play_roll(4.0, loud);
  play_roll(1.0, mixed);
  const uint64_t usual = loud[BLOCKS / 2];
  print_message("elements of a block of 64: median %llu, most %llu, with soft strokes %llu\n",
                (unsigned long long)usual, (unsigned long long)loud[BLOCKS - 1],
                (unsigned long long)mixed[BLOCKS - 1]);
  assert_true(5 * loud[BLOCKS - 1] <= 8 * usual && 5 * mixed[BLOCKS - 1] <= 8 * usual);
}

static uint64_t work_of(TaborDrum *drum, const TaborEvent *stroke, uint32_t samples) {
  float sample[480], *outputs[TABOR_MAX_MICS] = {sample};
  work = 0;
  for (uint32_t at = 0; at < samples; at += 480) {
    tabor_drum_process(drum, stroke, stroke != NULL && at == 0, outputs, 480);
  }
  return work;
}

/* A tenth of a second that cannot be heard any more costs less than 1.5 times the stroke's first
 * one. Near a drum's rest its contacts change by rounding alone, which no iteration mends. */
static void dies_away_at_low_cost(const char *preset) {
  const TaborDrumDef def = physics_preset(preset);
  TaborModel *model = counting_model(&def);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = physics_strike(&def);
  const uint64_t first = work_of(drum, &stroke, 4800);
  double most = 0.0, at = 0.0, time = 0.1;
  for (; time < 8.0 && !tabor_drum_is_silent(drum); time += 0.1) {
    const double ratio = (double)work_of(drum, NULL, 4800) / (double)first;
    if (ratio > most) {
      most = ratio;
      at = time;
    }
  }
  print_message("%s: silent after %.1f s; at most %.2f times the work of the stroke, at %.1f s\n",
                preset, time, most, at);
  assert_true(tabor_drum_is_silent(drum) && most < 1.5); /* 2.7 where it was iterated */
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

static void a_tail_costs_about_as_much_as_its_stroke(void **state) {
  (void)state;
  static const char *const presets[] = {"snare-14x5.5", "snare-14x6.5-loose", "marching-14x12"};
  for (size_t i = 0; i < sizeof presets / sizeof *presets; i++) dies_away_at_low_cost(presets[i]);
}

/* What a brush that is drawn along adds to a drum that is played: its own contacts, less those of
 * wires that it calms. */
static void a_sweep_is_half_a_drum_at_most(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  TaborModel *model = counting_model(&def);
  const int brush = tabor_drum_def_find_striker(&def, "brush");
  assert_true(brush >= 0);
  const TaborEvent sweep = {.type = TABOR_EVENT_STRIKE,
                            .id = 1,
                            .striker = (uint32_t)brush,
                            .technique = TABOR_TECHNIQUE_SWEEP,
                            .velocity = 0.8,
                            .radius = 0.09,
                            .value = 0.5};
  uint64_t whole[2];
  for (int sweeps = 0; sweeps < 2; sweeps++) {
    TaborDrum *drum = physics_drum(model);
    float samples[64], *outputs[TABOR_MAX_MICS] = {samples};
    tabor_drum_process(drum, &sweep, (uint32_t)sweeps, outputs, 64);
    work = 0;
    for (uint32_t block = 0; block < 188; block++) {
      const TaborEvent stroke = physics_strike(&def);
      tabor_drum_process(drum, &stroke, block % 94 == 0, outputs, 64);
    }
    whole[sweeps] = work;
    tabor_drum_destroy(drum);
  }
  const double ratio = (double)whole[1] / (double)whole[0];
  print_message("played and swept, a drum is %.4f times the work of one that is played\n", ratio);
  assert_true(whole[0] != whole[1]); /* it is there */
  assert_true(ratio < 1.5);
  tabor_model_release(model);
}

/* A roll's work while a parameter (none: 0) moves all the time, as a host's automation does it. */
static uint64_t automated(TaborModel *model, uint32_t parameter, double least, double most) {
  TaborDrum *drum = physics_drum(model);
  float samples[64], *outputs[TABOR_MAX_MICS] = {samples};
  work = 0;
  for (uint32_t block = 0; block < 188; block++) {
    TaborEvent events[2] = {physics_strike(&model->def)};
    uint32_t count = block % 94 == 0;
    events[count].type = TABOR_EVENT_PARAMETER;
    events[count].frame = 0;
    events[count].parameter = parameter;
    events[count].value = least + (most - least) * (0.5 + 0.5 * sin(0.05 * block));
    count += parameter != 0 && block % 4 == 0;
    tabor_drum_process(drum, events, count, outputs, 64);
  }
  tabor_drum_destroy(drum);
  return work;
}

static void automation_costs_little(void **state) {
  (void)state;
  static const struct {
    const char *key;
    double least, most;
  } moves[] = {{"wires.tension", 8.0, 16.0},
               {"wires.damping_0", 1.0, 5.0},
               {"batter.muffle_strength", 0.1, 1.0}};
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  TaborModel *model = counting_model(&def);
  const uint64_t still = automated(model, 0, 0.0, 0.0);
  for (size_t i = 0; i < sizeof moves / sizeof *moves; i++) {
    const uint32_t parameter = tabor_parameter_find(moves[i].key)->id;
    const uint64_t moved = automated(model, parameter, moves[i].least, moves[i].most);
    const double ratio = (double)moved / (double)still;
    print_message("%s under way: %.2f times the work\n", moves[i].key, ratio);
    assert_true(ratio < 1.25);
  }
  tabor_model_release(model);
}

/* ---- floods ---------------------------------------------------------------------------------- */

enum { FLOOD = 1000, BLOCK = 64 };

/* Work of a block that begins with `count` events, and of the block after it. */
static uint64_t work_of_blocks(TaborModel *model, const TaborEvent *events, uint32_t count,
                               TaborStatistics *statistics) {
  TaborDrum *drum = physics_drum(model);
  float samples[BLOCK], *outputs[TABOR_MAX_MICS] = {samples};
  work = 0;
  tabor_drum_process(drum, events, count, outputs, BLOCK);
  tabor_drum_statistics(drum, statistics);
  tabor_drum_destroy(drum);
  return work;
}

/* Strokes of one kind all over a block, each at another place. */
static void flood_with(const TaborDrumDef *def, uint32_t type, uint32_t technique,
                       TaborEvent *events) {
  for (uint32_t i = 0; i < FLOOD; i++) {
    events[i] = physics_strike(def);
    events[i].type = type;
    events[i].technique = technique;
    events[i].frame = i * BLOCK / FLOOD;
    events[i].id = i + 1;
    events[i].radius = 0.9 * def->shell.radius * (double)i / FLOOD;
    events[i].angle = 3.6 * i;
    events[i].value = 0.5;
  }
}

/* A thousand events in a block of 64 samples are at most eight times the work of one stroke; what
 * was not carried out was counted. */
static void a_flood_of_events_is_bounded(void **state) {
  (void)state;
  static const struct {
    uint32_t type, technique;
    const char *what;
  } floods[] = {{TABOR_EVENT_STRIKE, TABOR_TECHNIQUE_NORMAL, "strokes"},
                {TABOR_EVENT_STRIKE, TABOR_TECHNIQUE_BUZZ, "buzzes"},
                {TABOR_EVENT_STRIKE, TABOR_TECHNIQUE_RIMSHOT, "rimshots"},
                {TABOR_EVENT_STRIKE, TABOR_TECHNIQUE_CROSS_STICK, "cross-sticks"},
                {TABOR_EVENT_DAMP, 0, "hands"},
                {TABOR_EVENT_RESET, 0, "resets"}};
  static const char *const presets[] = {"snare-14x5.5", "bass-drum-22"};
  static TaborEvent events[FLOOD];
  for (size_t p = 0; p < sizeof presets / sizeof *presets; p++) {
    const TaborDrumDef def = physics_preset(presets[p]);
    TaborModel *model = counting_model(&def);
    TaborStatistics statistics;
    const TaborEvent stroke = physics_strike(&def);
    const uint64_t one = work_of_blocks(model, &stroke, 1, &statistics);
    for (size_t i = 0; i < sizeof floods / sizeof *floods; i++) {
      flood_with(&def, floods[i].type, floods[i].technique, events);
      const uint64_t many = work_of_blocks(model, events, FLOOD, &statistics);
      const double ratio = (double)many / (double)one;
      print_message("%s: 1000 %s in a block are %.2f times the work of one stroke; %llu were "
                    "dropped\n",
                    def.name, floods[i].what, ratio, (unsigned long long)statistics.dropped_events);
      assert_true(ratio <= 8.0);
      if (floods[i].type == TABOR_EVENT_STRIKE) {
        assert_true(statistics.strikes + statistics.dropped_events == FLOOD);
        assert_true(statistics.strikes <= TABOR_BURST + BLOCK / TABOR_BURST_FRAMES);
      }
    }
    tabor_model_release(model);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_flood_of_events_is_bounded),
    cmocka_unit_test(every_kernel_is_counted),
    cmocka_unit_test(everything_in_contact_keeps_the_bound),
    cmocka_unit_test(remedies_keep_the_bound),
    cmocka_unit_test(a_roll_is_even),
    cmocka_unit_test(a_tail_costs_about_as_much_as_its_stroke),
    cmocka_unit_test(a_sweep_is_half_a_drum_at_most),
    cmocka_unit_test(automation_costs_little),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
