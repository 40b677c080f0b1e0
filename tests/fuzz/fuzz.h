/* SPDX-License-Identifier: MIT */
/**
 * @file fuzz.h
 * What the fuzz targets (fuzz_*.c) share. Each target has the entry of libFuzzer; replay.c or
 * libFuzzer calls it with the bytes of an input. A target stops the program, by abort() or a
 * sanitizer, if a promise is broken.
 */
#ifndef TEST_FUZZ_H
#define TEST_FUZZ_H

#include <stddef.h>
#include <stdint.h>

#include "tabor/tabor.h"

/** Tries one input; returns 0. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/** Stops the program with a line that names @p what, unless @p holds. */
void fuzz_require(bool holds, const char *what);

/** Makes a file of these bytes, in memory, that lasts until the next call; returns its path. */
const char *fuzz_file(const uint8_t *data, size_t size);

/** Input that is taken piece by piece; past its end all bytes are 0. */
typedef struct FuzzInput {
  const uint8_t *at;
  size_t left;
} FuzzInput;

uint8_t fuzz_byte(FuzzInput *input);
uint32_t fuzz_word(FuzzInput *input);
/** A number: usual, extreme, or any bits, not finite ones included. */
double fuzz_number(FuzzInput *input);

/** A drum with few modes and wires, so that a model is built at once: 0 snare, 1 tom, 2 single
 * head. */
TaborModel *fuzz_model(uint32_t which);

#endif
