/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE
#include "fuzz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

void fuzz_require(bool holds, const char *what) {
  if (holds) return;
  (void)fprintf(stderr, "BROKEN: %s\n", what);
  abort();
}

const char *fuzz_file(const uint8_t *data, size_t size) {
  static int file = -1;
  static char path[40];
  if (file < 0) {
    file = memfd_create("input", 0);
    fuzz_require(file >= 0, "a file in memory");
    (void)snprintf(path, sizeof path, "/proc/self/fd/%d", file);
  }
  fuzz_require(ftruncate(file, 0) == 0 && pwrite(file, data, size, 0) == (ssize_t)size,
               "writing the input");
  return path;
}

uint8_t fuzz_byte(FuzzInput *input) {
  if (input->left == 0) return 0;
  input->left--;
  return *input->at++;
}

uint32_t fuzz_word(FuzzInput *input) {
  uint32_t word = 0;
  for (int i = 0; i < 4; i++) word = word << 8 | fuzz_byte(input);
  return word;
}

double fuzz_number(FuzzInput *input) {
  static const double SPECIAL[] = {0.0,  -0.0, 1.0,      -1.0,      1e-308, 5e-324,
                                   30.0, 1e9,  INFINITY, -INFINITY, NAN,    -1e300};
  const uint8_t kind = fuzz_byte(input);
  if (kind < 128) return (double)kind / 64.0;
  if (kind < 200) return SPECIAL[kind % (sizeof SPECIAL / sizeof *SPECIAL)];
  const uint64_t bits = (uint64_t)fuzz_word(input) << 32 | fuzz_word(input);
  double number;
  memcpy(&number, &bits, sizeof number);
  return number;
}

TaborModel *fuzz_model(uint32_t which) {
  static const char *const NAMES[] = {"snare-14x5.5", "tom-12", "tabor", "hihat-14"};
  static const uint32_t QUALITIES[] = {TABOR_QUALITY_DRAFT, TABOR_QUALITY_STUDIO,
                                       TABOR_QUALITY_LIVE, TABOR_QUALITY_DRAFT};
  TaborDrumDef def;
  TaborModelOptions options;
  TaborModel *model = NULL;
  fuzz_require(tabor_drum_def_preset(&def, NAMES[which], NULL) == TABOR_OK, "a preset");
  tabor_model_options_default(&options);
  options.sample_rate = 22050.0;
  options.quality = QUALITIES[which];
  def.quality.two_way_bandwidth = 700.0;
  def.quality.bandwidth = 1400.0;
  def.quality.wire_points = 8;
  if (def.wires.count > 3) def.wires.count = 3;
  fuzz_require(tabor_model_create(&def, &options, &model, NULL) == TABOR_OK, "a model");
  return model;
}
