/* SPDX-License-Identifier: MIT */
/* What builds of drums take, beside their estimates, their limits and the time to load a saved
 * model, in processor time.
 *
 * build_times presets: builds each built-in preset at live, saves the model and loads it; says what
 * part of the build's time loading takes. Fails if it is 5 % or more of one.
 *
 * build_times [COUNT [SEED]]: draws definitions, from presets of which some parameters are drawn
 * anew, until COUNT (200) of them were legal, and builds them at live. Says how far estimates are
 * from the builds, how long an estimate takes, and how far a build that is given half of its time
 * goes beyond that limit; names each that is more than 3 times off, 20 ms or 20 % over. Fails if
 * there is any. For a quiet machine: no test, since times are not the same twice. */
#define _XOPEN_SOURCE 700
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <tabor/tabor.h>

static const double MOST_OFF = 3.0, MOST_ESTIMATING = 0.02, MOST_BEYOND = 1.2;
static const double MOST_LOADING = 0.05; /* of the build */
static const double LEAST_LIMIT = 0.1;   /* [s]: the clock is looked at every 50 ms at least */

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void fail(const TaborError *error) {
  fprintf(stderr, "build_times: %s\n", error->message);
  exit(1);
}

/* ---- random definitions ---------------------------------------------------------------------- */

static uint64_t seed;

static uint64_t draw(void) { /* SplitMix64 */
  uint64_t z = seed += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

static double uniform(double low, double high) {
  return low + (high - low) * ((double)(draw() >> 11) * 0x1p-53);
}

/* The word of a choice. */
static void draw_word(const TaborParameter *parameter, char *text, size_t size) {
  const char *word = parameter->choices;
  uint64_t count = 1;
  for (const char *c = word; *c; c++) count += *c == '|';
  for (uint64_t skip = draw() % count; skip > 0; skip--) word = strchr(word, '|') + 1;
  snprintf(text, size, "%.*s", (int)strcspn(word, "|"), word);
}

/* One quarter of all numbers stand at either end of the range. */
static void draw_value(const TaborParameter *parameter, char *text, size_t size) {
  const double low = parameter->minimum, high = parameter->maximum;
  const uint64_t end = draw() % 8;
  double value =
    parameter->logarithmic && low > 0.0 ? exp(uniform(log(low), log(high))) : uniform(low, high);
  if (end < 2) value = end ? high : low;
  snprintf(text, size, parameter->type == TABOR_TYPE_NUMBER ? "%.9g" : "%.0f", value);
}

/* Draws each parameter anew with this probability; a value that the others do not allow is left
 * out. */
static void vary(TaborDrumDef *def, double probability) {
  char key[2 * TABOR_NAME_SIZE], value[TABOR_TEXT_SIZE];
  for (uint32_t i = 0; tabor_drum_def_key(def, i, key, sizeof key); i++) {
    const TaborParameter *const parameter = tabor_parameter_find(key);
    if (uniform(0.0, 1.0) > probability || !parameter || parameter->type == TABOR_TYPE_TEXT) {
      continue;
    }
    TaborDrumDef changed = *def;
    if (parameter->choices) {
      draw_word(parameter, value, sizeof value);
    } else {
      draw_value(parameter, value, sizeof value);
    }
    if (tabor_drum_def_set(&changed, key, value, NULL) != TABOR_OK) continue;
    if (tabor_drum_def_validate(&changed, NULL) == TABOR_OK) *def = changed;
  }
}

static void draw_definition(TaborDrumDef *def) {
  TaborError error;
  const TaborPresetInfo *const preset = tabor_preset((uint32_t)(draw() % tabor_preset_count()));
  if (tabor_drum_def_preset(def, preset->name, &error) != TABOR_OK) fail(&error);
  vary(def, uniform(0.02, 0.4));
}

/* ---- saved models ---------------------------------------------------------------------------- */

static double load_time(const void *bytes, size_t size) {
  TaborModel *model;
  TaborError error;
  const double began = now();
  if (tabor_model_load(bytes, size, NULL, &model, &error) != TABOR_OK) fail(&error);
  const double time = now() - began;
  tabor_model_release(model);
  return time;
}

/* Returns the part of the build's time that loading takes. */
static double try_saved(const TaborPresetInfo *preset) {
  TaborDrumDef def;
  TaborModel *model;
  TaborModelOptions options;
  TaborError error;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  const double began = now();
  if (tabor_drum_def_preset(&def, preset->name, &error) != TABOR_OK ||
      tabor_model_create(&def, &options, &model, &error) != TABOR_OK)
    fail(&error);
  const double building = now() - began;
  const size_t size = tabor_model_saved_size(model);
  void *const bytes = malloc(size);
  if (!bytes) exit(1);
  tabor_model_save(model, bytes);
  const double loading = load_time(bytes, size);
  printf("%s: built in %.3f s, saved as %.1f MB, loaded in %.2f ms: %.2f %%\n", preset->name,
         building, 1e-6 * (double)size, 1e3 * loading, 1e2 * loading / building);
  free(bytes);
  tabor_model_release(model);
  return loading / building;
}

static int try_presets(void) {
  double most = 0.0;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) most = fmax(most, try_saved(tabor_preset(i)));
  printf("loading takes %.2f %% of building at most\n", 1e2 * most);
  return most >= MOST_LOADING;
}

/* ---- builds ---------------------------------------------------------------------------------- */

typedef struct Tally {
  int built, refused, off, slow, late;
  double least, most, estimating, beyond; /* estimate over time; [s]; time over limit */
} Tally;

/* Returns the build's time [s]; below 0 if the definition was refused. */
static double build(const TaborDrumDef *def, double most_seconds, TaborStatus *status) {
  TaborModelOptions options;
  TaborModel *model;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  options.most_seconds = most_seconds;
  const double began = now();
  *status = tabor_model_create(def, &options, &model, NULL);
  const double time = now() - began;
  if (*status == TABOR_OK) tabor_model_release(model);
  return time;
}

static void try_estimate(const TaborDrumDef *def, int number, double time, Tally *tally) {
  TaborModelOptions options;
  TaborModelEstimate estimate;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  const double began = now();
  (void)tabor_model_estimate(def, &options, &estimate, NULL);
  const double took = now() - began, off = estimate.seconds / time;
  tally->least = fmin(tally->least, off);
  tally->most = fmax(tally->most, off);
  tally->estimating = fmax(tally->estimating, took);
  if (took > MOST_ESTIMATING) {
    tally->slow++;
    printf("%d, %s: the estimate took %.1f ms\n", number, def->name, 1e3 * took);
  }
  if (off <= MOST_OFF && off >= 1.0 / MOST_OFF) return;
  tally->off++;
  printf("%d, %s: built in %.3f s, estimated at %.3f s\n", number, def->name, time,
         estimate.seconds);
}

static void try_limit(const TaborDrumDef *def, int number, double limit, Tally *tally) {
  TaborStatus status;
  if (limit < LEAST_LIMIT) return;
  const double beyond = build(def, limit, &status) / limit;
  tally->beyond = fmax(tally->beyond, beyond);
  if (beyond <= MOST_BEYOND) return;
  tally->late++;
  printf("%d, %s: %.3f s for a limit of %.3f s\n", number, def->name, beyond * limit, limit);
}

static void try_one(int number, Tally *tally) {
  TaborDrumDef def;
  TaborStatus status;
  draw_definition(&def);
  const double time = build(&def, 0.0, &status);
  if (status != TABOR_OK) {
    tally->refused++;
    return;
  }
  tally->built++;
  try_estimate(&def, number, time, tally);
  try_limit(&def, number, 0.5 * time, tally);
}

int main(int argc, char **argv) {
  if (argc > 1 && strcmp(argv[1], "presets") == 0) return try_presets();
  if (argc > 1 && atoi(argv[1]) < 1) {
    fprintf(stderr, "usage: build_times presets | [COUNT [SEED]]\n");
    return 2;
  }
  const int count = argc > 1 ? atoi(argv[1]) : 200;
  Tally tally = {.least = INFINITY};
  seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
  printf("seed %llu\n", (unsigned long long)seed);
  for (int i = 0; tally.built < count; i++) try_one(i, &tally);
  printf(
    "%d built, %d refused by their rules; estimates %.2f to %.2f of the time, %d more than "
    "%g times off; %.1f ms at most for one, %d too slow; %.2f of a limit at most, %d too late\n",
    tally.built, tally.refused, tally.least, tally.most, tally.off, MOST_OFF,
    1e3 * tally.estimating, tally.slow, tally.beyond, tally.late);
  return tally.off + tally.slow + tally.late > 0;
}
