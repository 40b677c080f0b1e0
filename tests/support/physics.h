/* SPDX-License-Identifier: MIT */
/* Small helpers of the physics tests: drums from definitions, seeds, energy balances. */
#ifndef TEST_PHYSICS_H
#define TEST_PHYSICS_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tabor/tabor.h"

static inline TaborDrumDef physics_preset(const char *name) {
  TaborDrumDef def;
  TaborError error = {0};
  if (tabor_drum_def_preset(&def, name, &error) != TABOR_OK) fail_msg("%s", error.message);
  return def;
}

/* Built-in drums come first, then cymbals, then their tunings (`base`): how many of the first. */
static inline uint32_t physics_drum_count(void) {
  uint32_t count = 0;
  while (strcmp(tabor_preset(count)->category, "cymbal") != 0) count++;
  return count;
}

/* An ideal membrane in a vacuum: without stiffness, stretching and internal losses. */
static inline TaborDrumDef physics_membrane(void) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.shell.radius = 0.2;
  def.batter.tension = 3000.0;
  def.batter.surface_density = 0.26;
  def.batter.bending_stiffness = 0.0;
  def.batter.stretch_stiffness = 0.0;
  def.batter.damping_0 = def.batter.damping_1 = 0.0;
  def.air.density = 0.0;
  return def;
}

/* Two flat, stiff plates as a hi-hat, even all around, without gravity. */
static inline TaborDrumDef physics_stiff_hihat(void) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.body.kind = TABOR_BODY_HIHAT;
  def.shell.radius = 0.15;
  def.strike.radius = 0.1;
  def.plate.thickness = def.bottom.thickness = 0.004;
  def.plate.youngs_modulus = def.bottom.youngs_modulus = 1e12;
  def.plate.large_deflections = 0.0;
  def.hihat.tilt = def.hihat.unevenness = 0.0;
  def.air.gravity = 0.0;
  return def;
}

static inline TaborModel *physics_model(const TaborDrumDef *def, double rate, uint32_t quality) {
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.sample_rate = rate;
  options.quality = quality;
  TaborError error = {0};
  TaborModel *model;
  if (tabor_model_create(def, &options, &model, &error) != TABOR_OK) fail_msg("%s", error.message);
  return model;
}

/* Largest residual of the ledger, as a fraction of the injected energy. Contacts are solved in
 * single precision at `draft` and `live` (contact_solve.h), in double precision at `studio` and
 * `reference`. */
static inline double physics_residual(uint32_t quality) {
  return quality <= TABOR_QUALITY_LIVE ? 1e-6 : 1e-9;
}

/* A drum with the size of `live` and contacts in double precision: works like studio, but is
 * faster. */
/* Wires that lie even and drawn past the head: all of them touch, and their head stops them. */
static inline void physics_lay_even(TaborDrumDef *def) {
  def->wires.unevenness = 0.0;
  def->wires.rest_offset = -5e-5;
}

static inline TaborDrumDef physics_small(const TaborDrumDef *def) {
  TaborDrumDef small = *def;
  if (small.quality.two_way_bandwidth == 0.0) small.quality.two_way_bandwidth = 2500.0;
  if (small.quality.newton_cap == 0) small.quality.newton_cap = 8;
  if (small.quality.wire_points == 0) small.quality.wire_points = def->wires.count > 8 ? 24 : 64;
  return small;
}

static inline TaborDrum *physics_drum(TaborModel *model) {
  TaborDrum *drum;
  TaborError error = {0};
  if (tabor_drum_create(model, &drum, &error) != TABOR_OK) fail_msg("%s", error.message);
  return drum;
}

static inline TaborEvent physics_strike(const TaborDrumDef *def) {
  const int striker =
    def->strike.striker[0] ? tabor_drum_def_find_striker(def, def->strike.striker) : 0;
  return (TaborEvent){.type = TABOR_EVENT_STRIKE,
                      .striker = (uint32_t)striker,
                      .velocity = def->strike.velocity,
                      .radius = def->strike.radius,
                      .angle = def->strike.angle};
}

/* SplitMix64: the next random number; the sequence of a seed is the same on every machine. */
static inline uint64_t physics_random(uint64_t *state) {
  uint64_t z = (*state += UINT64_C(0x9E3779B97F4A7C15));
  z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
  return z ^ (z >> 31);
}

static inline double physics_uniform(uint64_t *state, double lo, double hi) {
  return lo + (hi - lo) * ((double)(physics_random(state) >> 11) * 0x1p-53);
}

/* Reads the seed from the environment variable TABOR_TEST_SEED, default 1, and prints it, so that a
 * failure can be repeated. */
static inline uint64_t physics_seed(void) {
  const char *text = getenv("TABOR_TEST_SEED");
  const uint64_t seed = text ? strtoull(text, NULL, 0) : 1;
  print_message("TABOR_TEST_SEED=%llu\n", (unsigned long long)seed);
  return seed;
}

#endif
