/* SPDX-License-Identifier: MIT */
/**
 * @file replay.c
 * Runs a fuzz target without libFuzzer, for a short test in every build:
 *
 *     fuzz_NAME RUNS SEED FILE...
 *
 * tries every file, then RUNS mutations of files drawn at random. The same seed gives the same
 * mutations. The last input stays in the file fuzz-input of the working folder until the run has
 * ended well, so that a crash can be repeated: fuzz_NAME 0 0 fuzz-input.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

enum { LARGEST = 1 << 20 };

typedef struct Input {
  uint8_t *bytes;
  size_t size;
} Input;

/* SplitMix64. */
static uint64_t draw(uint64_t *state) {
  uint64_t z = (*state += UINT64_C(0x9E3779B97F4A7C15));
  z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
  return z ^ (z >> 31);
}

static Input read_input(const char *path) {
  Input input = {malloc(LARGEST), 0};
  FILE *const file = fopen(path, "rb");
  fuzz_require(file != NULL && input.bytes != NULL, path);
  input.size = fread(input.bytes, 1, LARGEST, file);
  (void)fclose(file);
  return input;
}

static void keep(const Input *input) {
  FILE *const file = fopen("fuzz-input", "wb");
  fuzz_require(file != NULL, "writing fuzz-input");
  (void)fwrite(input->bytes, 1, input->size, file);
  (void)fclose(file);
}

/* Of exact size, so that a sanitizer sees a byte read past the end. */
static void try_input(const Input *input) {
  uint8_t *const exact = malloc(input->size ? input->size : 1);
  fuzz_require(exact != NULL, "memory");
  memcpy(exact, input->bytes, input->size);
  keep(input);
  (void)LLVMFuzzerTestOneInput(exact, input->size);
  free(exact);
}

static size_t place_in(const Input *input, uint64_t *state) {
  return input->size ? (size_t)(draw(state) % input->size) : 0;
}

static void insert(Input *input, size_t at, const uint8_t *bytes, size_t count) {
  if (count > LARGEST - input->size) count = LARGEST - input->size;
  memmove(input->bytes + at + count, input->bytes + at, input->size - at);
  memcpy(input->bytes + at, bytes, count);
  input->size += count;
}

static void mutate(Input *input, const Input *other, uint64_t *state) {
  static const uint8_t EDGES[] = {0x00, 0x01, 0x7f, 0x80, 0xff, '\n', '"',
                                  ',',  '=',  '[',  '-',  '.',  '9'};
  uint8_t few[8];
  const size_t at = place_in(input, state), from = place_in(other, state);
  const size_t count = (size_t)(draw(state) % 32) + 1;
  switch (draw(state) % 7) {
  case 0:
    if (input->size > 0) input->bytes[at] ^= (uint8_t)(1u << draw(state) % 8);
    break;
  case 1:
    if (input->size > 0) input->bytes[at] = EDGES[draw(state) % sizeof EDGES];
    break;
  case 2:
    if (input->size > 0) input->bytes[at] = (uint8_t)draw(state);
    break;
  case 3: /* cut out */
    if (at + count <= input->size) {
      memmove(input->bytes + at, input->bytes + at + count, input->size - at - count);
      input->size -= count;
    }
    break;
  case 4: /* cut off */
    if (draw(state) % 4 == 0) input->size = at;
    break;
  case 5: /* a piece of another input */
    if (from + count <= other->size) insert(input, at, other->bytes + from, count);
    break;
  default:
    for (size_t i = 0; i < sizeof few; i++) few[i] = (uint8_t)draw(state);
    insert(input, at, few, (size_t)(draw(state) % sizeof few) + 1);
  }
}

int main(int argc, char **argv) {
  if (argc < 4) {
    (void)fprintf(stderr, "usage: %s RUNS SEED FILE...\n", argv[0]);
    return 2;
  }
  const unsigned long runs = strtoul(argv[1], NULL, 10);
  uint64_t state = strtoull(argv[2], NULL, 0);
  const size_t count = (size_t)argc - 3;
  Input *const inputs = calloc(count, sizeof *inputs), now = {malloc(LARGEST), 0};
  fuzz_require(inputs != NULL && now.bytes != NULL, "memory");
  for (size_t i = 0; i < count; i++) {
    inputs[i] = read_input(argv[3 + i]);
    try_input(&inputs[i]);
  }
  Input changed = now;
  for (unsigned long run = 0; run < runs; run++) {
    const Input *const base = &inputs[draw(&state) % count];
    memcpy(changed.bytes, base->bytes, base->size);
    changed.size = base->size;
    for (uint64_t left = draw(&state) % 5 + 1; left > 0; left--) {
      mutate(&changed, &inputs[draw(&state) % count], &state);
    }
    try_input(&changed);
  }
  (void)remove("fuzz-input");
  printf("%zu inputs and %lu mutations of them\n", count, runs);
  for (size_t i = 0; i < count; i++) free(inputs[i].bytes);
  free(inputs);
  free(now.bytes);
  return 0;
}
