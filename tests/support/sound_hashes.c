/* SPDX-License-Identifier: MIT */
/**
 * @file sound_hashes.c
 * Prints hashes of the library's results, for tools/same-sound and test_system_sound_hashes. It
 * uses only the public interface, so it can be linked to the library of another commit.
 *
 *     sound_hashes list                                      the built-in presets and kits
 *     sound_hashes hash PRESET|KIT QUALITY [SECONDS [FOLDER]]    a line for each case
 *     sound_hashes summary QUALITY [baseline|avx2|avx512]    one hash of the drums, one of the cymbals
 *     sound_hashes difference FILE FILE                      largest difference [dB re peak]
 *
 * A line is "PRESET QUALITY CASE BLOCKS SOUND LEDGER STATE". SOUND covers the samples of all
 * microphones, LEDGER the ledger, the statistics and the probe, STATE the bytes that
 * tabor_drum_state_save() writes. A case plays in blocks of 64 frames. Cheap cases play also in
 * blocks of 1 and of 1000, and "everything" also with the baseline instructions ("64-baseline");
 * the hashes of one case must be the same for all of these. The case "model" hashes the facts and
 * modes of the model instead of a sound.
 *
 * Of a kit (kit_hashes.c) SOUND covers the mix, each drum's part of it and all microphones, LEDGER
 * those of all drums.
 *
 * FOLDER receives the samples of each case as native floats, in the file PRESET-QUALITY-CASE.
 * SECONDS is 0.05 by default or if 0; then studio and reference play a quarter of it, snare drums
 * at reference a twentieth.
 */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hashes.h"
#include "kit_hashes.h"

static const double SAMPLE_RATE = 48000.0; /* [Hz] */
static const double SECONDS = 0.05;        /* of every case */
/* What plays only a part of a case: studio and reference take up to a hundred times real time, and
 * at reference a model with so many contact points takes hundreds of times. */
static const uint32_t FINE_PART = 4, COSTLY_PART = 20;
static const uint32_t COSTLY_POINTS = 500;

enum { MAX_EVENTS = 64, MAX_FRAMES = 480000 };

/* Of models that a case does not build with others. */
static TaborInstructions usual_instructions = TABOR_INSTRUCTIONS_AUTO;

static _Noreturn void fail(const char *what, const char *which) {
  (void)fprintf(stderr, "sound_hashes: %s%s%s\n", what, *which ? ": " : "", which);
  exit(2);
}

static Hash hash_probe(Hash hash, const TaborDrum *drum) {
  TaborProbe p;
  tabor_drum_probe(drum, &p);
  const double numbers[] = {p.head, p.wire, p.striker, p.striker_force, p.wire_force};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
    hash = isnan(numbers[i]) ? hash_count(hash, 0) : hash_number(hash, numbers[i]);
  }
  return hash;
}

static Hash hash_model(const TaborModel *model) {
  TaborModelInfo info;
  TaborModeInfo mode;
  tabor_model_info(model, &info);
  Hash hash = hash_number(HASH_START, info.two_way_bandwidth);
  hash = hash_number(hash, info.bandwidth);
  const uint32_t counts[] = {info.mode_count, info.mode_rows,  info.high_mode_count,
                             info.newton_cap, info.wire_count, info.contact_points,
                             info.mic_count};
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) hash = hash_count(hash, counts[i]);
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    hash = hash_number(hash, mode.frequency);
    hash = hash_number(hash, mode.decay_rate);
    hash = hash_number(hash, mode.radiation_rate);
    hash = hash_count(hash, (uint64_t)mode.m << 32 | mode.n);
    hash = hash_count(hash, (uint64_t)mode.multiplicity << 32 | (uint64_t)mode.part << 8 |
                              (uint64_t)(mode.phase + 1));
  }
  return hash;
}

/* ---- models --------------------------------------------------------------------------------- */

static TaborModel *build(const TaborDrumDef *def, TaborQuality quality,
                         TaborInstructions instructions) {
  TaborModelOptions options;
  TaborModel *model = NULL;
  TaborError error;
  tabor_model_options_default(&options);
  options.sample_rate = SAMPLE_RATE;
  options.quality = quality;
  options.instructions = instructions;
  if (tabor_model_create(def, &options, &model, &error) != TABOR_OK) fail(def->name, error.message);
  return model;
}

/* The same drum with a tenser head, and another drum; both with a narrow band, so that they are
 * built soon. */
static TaborDrumDef tenser(const TaborDrumDef *def) {
  TaborDrumDef other = *def;
  other.batter.tension = fmin(1.05 * def->batter.tension, 20000.0);
  other.quality.two_way_bandwidth = 2000.0;
  other.quality.bandwidth = 4000.0;
  other.quality.wire_points = 20;
  return other;
}

static TaborDrumDef smaller(const TaborDrumDef *def) {
  TaborDrumDef other = tenser(def);
  other.shell.radius *= 0.95;
  other.strike.radius = fmin(other.strike.radius, other.shell.radius);
  other.wires.length *= 0.95;
  return other;
}

/* ---- performances: a frame is counted in thousandths of the whole ---------------------------- */

typedef struct Performance {
  const TaborDrumDef *def;
  TaborModel *model, *tenser, *smaller; /* the last two for "swap" alone */
  TaborSwap *swaps[2];
  TaborEvent events[MAX_EVENTS];
  uint32_t count, frames;
  bool restored; /* half of it is played by a drum that continues from the saved state */
} Performance;

static TaborEvent *add(Performance *p, uint32_t thousandth, TaborEventType type, uint32_t id) {
  if (p->count == MAX_EVENTS) fail("too many events", "");
  if (p->count > 0 && p->frames * thousandth / 1000 < p->events[p->count - 1].frame) {
    fail("events are not in order", "");
  }
  TaborEvent *event = &p->events[p->count++];
  *event = (TaborEvent){.frame = p->frames * thousandth / 1000, .type = type, .id = id};
  return event;
}

static TaborEvent *strike(Performance *p, uint32_t thousandth, TaborTechnique technique,
                          double velocity) {
  TaborEvent *event = add(p, thousandth, TABOR_EVENT_STRIKE, 0);
  event->technique = technique;
  event->velocity = velocity;
  event->radius = 0.31 * p->def->shell.radius;
  event->angle = 17.0;
  return event;
}

static void press(Performance *p, uint32_t thousandth, uint32_t id, double pressure) {
  add(p, thousandth, TABOR_EVENT_PRESS, id)->value = pressure;
}

static void damp(Performance *p, uint32_t thousandth, uint32_t id, double strength) {
  TaborEvent *event = add(p, thousandth, TABOR_EVENT_DAMP, id);
  event->radius = 0.6 * p->def->shell.radius;
  event->angle = 80.0;
  event->value = strength;
}

static void move(Performance *p, uint32_t thousandth, double angle, double seconds) {
  TaborEvent *event = add(p, thousandth, TABOR_EVENT_MOVE, 0);
  event->radius = 0.5 * p->def->shell.radius;
  event->angle = angle;
  event->value = seconds;
}

static void parameter(Performance *p, uint32_t thousandth, const TaborParameter *row,
                      uint32_t index, double value) {
  TaborEvent *event = add(p, thousandth, TABOR_EVENT_PARAMETER, 0);
  event->parameter = row->id;
  event->index = index;
  event->value = value;
}

/* The brush, or else the last striker. */
static uint32_t brush_of(const TaborDrumDef *def) {
  for (uint32_t i = 0; i < def->striker_count; i++) {
    if (def->striker[i].kind == TABOR_STRIKER_BRUSH) return i;
  }
  return def->striker_count - 1;
}

static void play_strokes(Performance *p) {
  (void)strike(p, 2, TABOR_TECHNIQUE_NORMAL, 3.0);
  (void)strike(p, 200, TABOR_TECHNIQUE_NORMAL, 0.3);
  strike(p, 400, TABOR_TECHNIQUE_NORMAL, 8.0)->radius = 0.0;
  strike(p, 600, TABOR_TECHNIQUE_NORMAL, 5.0)->radius = 0.9 * p->def->shell.radius;
  (void)add(p, 800, TABOR_EVENT_RELEASE, 0);
}

static void play_strikers(Performance *p) {
  for (uint32_t i = 0; i < p->def->striker_count; i++) {
    strike(p, 2 + 900 * i / p->def->striker_count, TABOR_TECHNIQUE_NORMAL, 2.0)->striker = i;
  }
}

static void play_buzz(Performance *p) {
  TaborEvent *buzz = strike(p, 2, TABOR_TECHNIQUE_BUZZ, 2.0);
  buzz->id = 1;
  buzz->value = 0.5;
  (void)add(p, 700, TABOR_EVENT_RELEASE, 1);
}

static void play_press(Performance *p) {
  strike(p, 2, TABOR_TECHNIQUE_NORMAL, 1.5)->id = 1;
  press(p, 50, 1, 0.7);
  press(p, 500, 0, 0.2);
  (void)add(p, 800, TABOR_EVENT_RELEASE, 1);
}

static void play_rimshot(Performance *p) {
  (void)strike(p, 2, TABOR_TECHNIQUE_RIMSHOT, 4.0);
  strike(p, 500, TABOR_TECHNIQUE_RIMSHOT, 1.0)->angle = 200.0;
}

static void play_cross_stick(Performance *p) {
  (void)strike(p, 2, TABOR_TECHNIQUE_CROSS_STICK, 2.0);
  strike(p, 500, TABOR_TECHNIQUE_CROSS_STICK, 0.5)->angle = 300.0;
}

static void play_rim(Performance *p) {
  (void)strike(p, 2, TABOR_TECHNIQUE_RIM, 3.0);
  strike(p, 500, TABOR_TECHNIQUE_RIM, 1.0)->angle = -60.0;
}

static void play_brush(Performance *p) {
  strike(p, 2, TABOR_TECHNIQUE_NORMAL, 2.0)->striker = brush_of(p->def);
  TaborEvent *sweep = strike(p, 100, TABOR_TECHNIQUE_SWEEP, 1.0);
  sweep->striker = brush_of(p->def);
  sweep->id = 2;
  sweep->value = 0.4;
  move(p, 400, 90.0, 0.01);
  move(p, 600, 120.0, 0.0);
  (void)add(p, 800, TABOR_EVENT_RELEASE, 2);
}

static void play_muffle(Performance *p) {
  (void)strike(p, 2, TABOR_TECHNIQUE_NORMAL, 3.0);
  damp(p, 200, 3, 6.0);
  damp(p, 400, 4, 30.0);
  (void)add(p, 600, TABOR_EVENT_RELEASE, 3);
  (void)strike(p, 700, TABOR_TECHNIQUE_NORMAL, 3.0);
}

/* Every live parameter goes a tenth of the way from its default to its greatest value, or back; two
 * frames apart, in a very costly model at once. */
static void move_parameters(Performance *p, uint32_t thousandth, double part) {
  for (uint32_t i = 0; i < tabor_parameter_count(); i++) {
    const TaborParameter *row = tabor_parameter(i);
    const bool pedal = strcmp(row->section, "hihat") == 0;
    if (pedal && p->def->body.kind != TABOR_BODY_HIHAT) continue;
    if (!row->live) continue;
    const double value = row->fallback + part * (row->maximum - row->fallback);
    parameter(p, thousandth++, row, p->def->mic_count - 1, value);
  }
}

static void play_live(Performance *p) {
  (void)strike(p, 2, TABOR_TECHNIQUE_NORMAL, 3.0);
  move_parameters(p, 100, 0.1);
  move_parameters(p, 500, 0.0);
  (void)strike(p, 700, TABOR_TECHNIQUE_NORMAL, 3.0);
}

static TaborSwap *swap_between(TaborModel *from, TaborModel *to) {
  TaborSwap *swap = NULL;
  TaborError error;
  if (tabor_swap_create(from, to, &swap, &error) != TABOR_OK) fail("swap", error.message);
  return swap;
}

/* First to a drum that goes on ringing, then to one beside which the old one rings out. */
static void play_swap(Performance *p) {
  p->swaps[0] = swap_between(p->model, p->tenser);
  p->swaps[1] = swap_between(p->tenser, p->smaller);
  (void)strike(p, 2, TABOR_TECHNIQUE_NORMAL, 3.0);
  add(p, 250, TABOR_EVENT_SWAP, 0)->swap = p->swaps[0];
  (void)strike(p, 350, TABOR_TECHNIQUE_NORMAL, 3.0);
  add(p, 600, TABOR_EVENT_SWAP, 0)->swap = p->swaps[1];
  (void)strike(p, 700, TABOR_TECHNIQUE_NORMAL, 3.0);
}

static void play_everything(Performance *p) {
  const TaborParameter *strainer = tabor_parameter_find("wires.strainer");
  (void)strike(p, 2, TABOR_TECHNIQUE_NORMAL, 4.0);
  TaborEvent *sweep = strike(p, 100, TABOR_TECHNIQUE_SWEEP, 0.8);
  sweep->striker = brush_of(p->def);
  sweep->id = 2;
  sweep->value = 0.5;
  (void)strike(p, 200, TABOR_TECHNIQUE_RIMSHOT, 3.0);
  parameter(p, 250, strainer, 0, 0.5);
  TaborEvent *buzz = strike(p, 300, TABOR_TECHNIQUE_BUZZ, 2.0);
  buzz->id = 1;
  buzz->value = 0.4;
  move(p, 400, 60.0, 0.005);
  damp(p, 450, 3, 5.0);
  press(p, 550, 1, 0.8);
  (void)strike(p, 600, TABOR_TECHNIQUE_CROSS_STICK, 1.5);
  parameter(p, 650, strainer, 0, 1.0);
  (void)add(p, 700, TABOR_EVENT_RELEASE, 3);
  (void)strike(p, 750, TABOR_TECHNIQUE_RIM, 2.0);
  (void)add(p, 850, TABOR_EVENT_RELEASE, 0);
  (void)strike(p, 900, TABOR_TECHNIQUE_NORMAL, 1.0);
  p->restored = true;
}

typedef struct Case {
  const char *name;
  void (*play)(Performance *performance);
} Case;

static const Case cases[] = {
  {"strokes", play_strokes}, {"strikers", play_strikers}, {"buzz", play_buzz},
  {"press", play_press},     {"rimshot", play_rimshot},   {"cross-stick", play_cross_stick},
  {"rim", play_rim},         {"brush", play_brush},       {"muffle", play_muffle},
  {"live", play_live},       {"swap", play_swap},         {"everything", play_everything}};

enum {
  CASES = sizeof cases / sizeof *cases,
  SUMMED_CASES = 3 /* live, swap, everything: enough for a summary */
};

/* ---- playing a case ------------------------------------------------------------------------- */

typedef struct Hashes {
  Hash sound, ledger, state;
} Hashes;

typedef struct Sound {
  float *samples; /* [mic][frame] */
  uint32_t mics, frames;
} Sound;

static TaborDrum *drum_of(TaborModel *model) {
  TaborDrum *drum = NULL;
  TaborError error;
  if (tabor_drum_create(model, &drum, &error) != TABOR_OK) fail("drum", error.message);
  return drum;
}

static void *saved_state(const TaborDrum *drum) {
  void *bytes = malloc(tabor_drum_state_size(drum));
  if (!bytes) fail("not enough memory", "");
  tabor_drum_state_save(drum, bytes);
  return bytes;
}

/* Another drum in the place of @p drum, which goes on from its state. */
static TaborDrum *restored(TaborDrum *drum, TaborModel *model) {
  TaborDrum *other = drum_of(model);
  void *bytes = saved_state(drum);
  if (tabor_drum_state_load(other, bytes, tabor_drum_state_size(drum)) != TABOR_OK) {
    fail("a saved state is not taken", "");
  }
  free(bytes);
  tabor_drum_destroy(drum);
  return other;
}

static void process(TaborDrum *drum, const Performance *p, uint32_t start, uint32_t frames,
                    Sound *sound) {
  TaborEvent events[MAX_EVENTS];
  float *outputs[TABOR_MAX_MICS] = {NULL};
  uint32_t count = 0;
  for (uint32_t i = 0; i < p->count; i++) {
    if (p->events[i].frame < start || p->events[i].frame >= start + frames) continue;
    events[count] = p->events[i];
    events[count++].frame -= start;
  }
  for (uint32_t mic = 0; mic < sound->mics; mic++) {
    outputs[mic] = sound->samples + (size_t)mic * sound->frames + start;
  }
  tabor_drum_process(drum, events, count, outputs, frames);
}

/* Plays frames start to end in blocks of up to @p block. */
static void play_part(TaborDrum *drum, const Performance *p, uint32_t start, uint32_t end,
                      uint32_t block, Sound *sound) {
  while (start < end) {
    const uint32_t frames = end - start < block ? end - start : block;
    process(drum, p, start, frames, sound);
    start += frames;
  }
}

static Hashes hashes_of(const TaborDrum *drum, const Sound *sound) {
  Hashes hashes = {.sound = HASH_START, .ledger = HASH_START};
  for (size_t i = 0; i < (size_t)sound->mics * sound->frames; i++) {
    if (!isfinite(sound->samples[i])) fail("a sample is not finite", "");
  }
  hashes.sound =
    hash_bytes(HASH_START, sound->samples, (size_t)sound->mics * sound->frames * sizeof(float));
  hashes.ledger = hash_probe(hash_statistics(hash_ledger(HASH_START, drum), drum), drum);
  void *bytes = saved_state(drum);
  hashes.state = hash_bytes(HASH_START, bytes, tabor_drum_state_size(drum));
  free(bytes);
  return hashes;
}

/* Plays all of it; the samples stay in @p sound. */
static Hashes play(const Performance *p, uint32_t block, Sound *sound) {
  const uint32_t half = p->frames / 2;
  TaborDrum *drum = drum_of(p->model);
  play_part(drum, p, 0, half, block, sound);
  if (p->restored) drum = restored(drum, p->model);
  play_part(drum, p, half, p->frames, block, sound);
  const Hashes hashes = hashes_of(drum, sound);
  tabor_drum_destroy(drum);
  return hashes;
}

/* ---- one preset at one quality -------------------------------------------------------------- */

typedef struct Subject {
  const char *preset, *quality_name;
  TaborQuality quality;
  TaborDrumDef def;
  TaborModel *model, *tenser, *smaller;
  TaborModelInfo info;
  double seconds;     /* 0: as long as is bearable */
  const char *folder; /* for samples, or NULL */
} Subject;

static TaborQuality quality_of(const char *name) {
  static const char *const names[] = {"draft", "live", "studio", "reference"};
  for (uint32_t i = 0; i < 4; i++) {
    if (strcmp(name, names[i]) == 0) return (TaborQuality)(TABOR_QUALITY_DRAFT + i);
  }
  fail("no such quality", name);
}

static TaborInstructions instructions_of(const char *name) {
  static const char *const names[] = {"baseline", "avx2", "avx512"};
  for (uint32_t i = 0; i < 3; i++) {
    if (strcmp(name, names[i]) == 0) return (TaborInstructions)(TABOR_INSTRUCTIONS_BASELINE + i);
  }
  fail("no such instructions", name);
}

static void define(Subject *s) {
  TaborError error;
  s->quality = quality_of(s->quality_name);
  if (tabor_drum_def_preset(&s->def, s->preset, &error) != TABOR_OK) fail(s->preset, error.message);
}

static void prepare(Subject *s) {
  s->model = build(&s->def, s->quality, usual_instructions);
  const TaborDrumDef second = tenser(&s->def), third = smaller(&s->def);
  s->tenser = build(&second, s->quality, usual_instructions);
  s->smaller = build(&third, s->quality, usual_instructions);
  tabor_model_info(s->model, &s->info);
}

static void finish(Subject *s) {
  tabor_model_release(s->model);
  tabor_model_release(s->tenser);
  tabor_model_release(s->smaller);
}

static bool is_costly(const Subject *s) { return s->info.contact_points >= COSTLY_POINTS; }

static bool is_very_costly(const Subject *s) {
  return is_costly(s) && s->quality == TABOR_QUALITY_REFERENCE;
}

static uint32_t frames_of(const Subject *s) {
  if (s->seconds > 0.0) return (uint32_t)(s->seconds * SAMPLE_RATE);
  const uint32_t frames = (uint32_t)(SECONDS * SAMPLE_RATE);
  if (is_very_costly(s)) return frames / COSTLY_PART;
  return s->quality >= TABOR_QUALITY_STUDIO ? frames / FINE_PART : frames;
}

static Hashes play_case(const Subject *s, const Case *c, TaborModel *model, uint32_t block,
                        Sound *sound) {
  Performance p = {.def = &s->def, .model = model, .tenser = s->tenser, .smaller = s->smaller};
  p.frames = sound->frames;
  c->play(&p);
  const Hashes hashes = play(&p, block, sound);
  for (int i = 0; i < 2; i++) tabor_swap_destroy(p.swaps[i]);
  return hashes;
}

static void print_line(const Subject *s, const char *name, const char *blocks, const Hashes *h) {
  printf("%s %s %s %s %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", s->preset, s->quality_name,
         name, blocks, h->sound, h->ledger, h->state);
}

static void write_samples(const Subject *s, const char *name, const Sound *sound) {
  char path[4096];
  (void)snprintf(path, sizeof path, "%s/%s-%s-%s", s->folder, s->preset, s->quality_name, name);
  FILE *file = fopen(path, "wb");
  const size_t count = (size_t)sound->mics * sound->frames;
  if (!file || fwrite(sound->samples, sizeof(float), count, file) != count || fclose(file) != 0) {
    fail("cannot write", path);
  }
}

static Sound sound_of(const Subject *s) {
  Sound sound = {.mics = s->info.mic_count, .frames = frames_of(s)};
  sound.samples = calloc((size_t)sound.mics * sound.frames, sizeof *sound.samples);
  if (!sound.samples) fail("not enough memory", "");
  return sound;
}

static void print_case(const Subject *s, const Case *c, Sound *sound) {
  const bool thorough = !is_costly(s) || c->play == play_everything;
  Hashes hashes = play_case(s, c, s->model, 64, sound);
  print_line(s, c->name, "64", &hashes);
  if (s->folder) write_samples(s, c->name, sound);
  if (!thorough) return;
  hashes = play_case(s, c, s->model, 1, sound);
  print_line(s, c->name, "1", &hashes);
  hashes = play_case(s, c, s->model, 1000, sound);
  print_line(s, c->name, "1000", &hashes);
}

static void print_baseline(const Subject *s, const Case *c, Sound *sound) {
  if (is_very_costly(s)) return;
  TaborModel *model = build(&s->def, s->quality, TABOR_INSTRUCTIONS_BASELINE);
  const Hashes hashes = play_case(s, c, model, 64, sound);
  print_line(s, c->name, "64-baseline", &hashes);
  tabor_model_release(model);
}

static void print_all(Subject *s) {
  define(s);
  prepare(s);
  Sound sound = sound_of(s);
  const Hashes model = {.sound = hash_model(s->model)};
  print_line(s, "model", "0", &model);
  for (uint32_t i = 0; i < CASES; i++) print_case(s, &cases[i], &sound);
  print_baseline(s, &cases[CASES - 1], &sound);
  free(sound.samples);
  finish(s);
}

/* ---- one hash of a quality ------------------------------------------------------------------ */

/* Of models, sounds and ledgers; without states, whose layout may change. */
static Hash add_preset(Hash hash, const Subject *s) {
  Sound sound = sound_of(s);
  hash = hash_count(hash, hash_model(s->model));
  for (uint32_t i = CASES - SUMMED_CASES; i < CASES; i++) {
    const Hashes hashes = play_case(s, &cases[i], s->model, 64, &sound);
    hash = hash_count(hash_count(hash, hashes.sound), hashes.ledger);
  }
  free(sound.samples);
  return hash;
}

/* Of drums: tunings are made of the same code. At reference without snare drums: they take seconds
 * to build. */
static Hash sum_presets(const char *quality, bool cymbals) {
  Hash hash = HASH_START;
  for (uint32_t i = 0; i < tabor_preset_count() && !tabor_preset(i)->base; i++) {
    if ((strcmp(tabor_preset(i)->category, "cymbal") == 0) != cymbals) continue;
    Subject s = {.preset = tabor_preset(i)->name, .quality_name = quality};
    define(&s);
    if (s.quality == TABOR_QUALITY_REFERENCE && s.def.two_headed && s.def.wires.count > 0) continue;
    prepare(&s);
    hash = add_preset(hash, &s);
    finish(&s);
  }
  return hash;
}

/* Cymbals have a line of their own: nothing of theirs changes a drum. */
static void print_summary(const char *quality) {
  printf("%s %016" PRIx64 "\n", quality, sum_presets(quality, false));
  printf("%s-cymbals %016" PRIx64 "\n", quality, sum_presets(quality, true));
}

/* ---- differences ---------------------------------------------------------------------------- */

static Sound read_samples(const char *path) {
  Sound sound = {.mics = 1, .samples = malloc(TABOR_MAX_MICS * MAX_FRAMES * sizeof(float))};
  FILE *file = fopen(path, "rb");
  if (!sound.samples || !file) fail("cannot read", path);
  sound.frames =
    (uint32_t)fread(sound.samples, sizeof(float), (size_t)TABOR_MAX_MICS * MAX_FRAMES, file);
  (void)fclose(file);
  return sound;
}

static void print_difference(const char *path, const char *other) {
  const Sound a = read_samples(path), b = read_samples(other);
  double peak = 0.0, most = 0.0;
  if (a.frames != b.frames) fail("not as long as the other", path);
  for (uint32_t i = 0; i < a.frames; i++) {
    peak = fmax(peak, fabs((double)a.samples[i]));
    most = fmax(most, fabs((double)a.samples[i] - (double)b.samples[i]));
  }
  printf("%.1f\n", 20.0 * log10(most / peak));
  free(a.samples);
  free(b.samples);
}

static void print_presets(void) {
  for (uint32_t i = 0; i < tabor_preset_count() && !tabor_preset(i)->base; i++)
    printf("%s\n", tabor_preset(i)->name);
  kit_hashes_list();
}

int main(int argc, char **argv) {
  const char *verb = argc > 1 ? argv[1] : "";
  if (strcmp(verb, "list") == 0 && argc == 2) {
    print_presets();
  } else if (strcmp(verb, "hash") == 0 && argc >= 4 && argc <= 6) {
    Subject s = {.preset = argv[2], .quality_name = argv[3], .folder = argc > 5 ? argv[5] : NULL};
    s.seconds = argc > 4 ? strtod(argv[4], NULL) : 0.0;
    if (!(s.seconds >= 0.0 && s.seconds * SAMPLE_RATE <= MAX_FRAMES))
      fail("not a duration", argv[4]);
    if (kit_hashes_is_kit(s.preset)) {
      kit_hashes_print(s.preset, s.quality_name, quality_of(s.quality_name), s.seconds, s.folder);
    } else {
      print_all(&s);
    }
  } else if (strcmp(verb, "summary") == 0 && (argc == 3 || argc == 4)) {
    if (argc == 4) usual_instructions = instructions_of(argv[3]);
    print_summary(argv[2]);
  } else if (strcmp(verb, "difference") == 0 && argc == 4) {
    print_difference(argv[2], argv[3]);
  } else {
    fail("usage: sound_hashes list | hash PRESET|KIT QUALITY [SECONDS [FOLDER]] | "
         "summary QUALITY [INSTRUCTIONS] | difference FILE FILE",
         "");
  }
  return 0;
}
