/* SPDX-License-Identifier: MIT */
/**
 * @file process.h
 * The process and its machine.
 */
#ifndef TABOR_HOST_PROCESS_H
#define TABOR_HOST_PROCESS_H

#include <stdbool.h>
#include <stddef.h>

/**
 * Prepares the standard streams, and on Windows makes the arguments UTF-8. The first call of
 * main(). Keeps the arguments as they are where memory is short.
 */
void process_begin(int *argc, char ***argv);
/** Processors in use; at least 1. */
unsigned process_processors(void);
/** Function @p name of the libraries that this process has loaded; NULL if there is none. Never any
 * on Windows. */
void *process_loaded_function(const char *name);

/**
 * Runs a program that is found in the path and waits for its end. @p words: its name and arguments,
 * then NULL. Returns its exit status, 128 and more after a signal, -1 with errno if it cannot be
 * started.
 */
int process_run(const char *const *words);

/** Memory aligned to @p alignment, a power of two. Free it with process_free_aligned(). */
void *process_allocate_aligned(size_t alignment, size_t size);
void process_free_aligned(void *memory);

#endif
