/* SPDX-License-Identifier: MIT */
/**
 * @file own_kit.h
 * A kit of the user's, from a kit file (docs/kit.md): its text, which sessions save, and what it
 * says. Sound files have their names from the root in it.
 *
 * Threads: any but the audio thread, several at once, where nothing else is said.
 */
#ifndef TABOR_PLUGIN_OWN_KIT_H
#define TABOR_PLUGIN_OWN_KIT_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <tabor/kit.h>

#include "base/realtime.h"

typedef struct OwnKit {
  pthread_mutex_t lock; /**< of text and def */
  char *text;           /**< of the file; NULL: there is no kit */
  size_t length;
  TaborKitDef *def;
  atomic_uint version;
} OwnKit;

/** SET-UP. False if the system has no more locks. */
bool own_kit_begin(OwnKit *own);
void own_kit_end(OwnKit *own);
/** Takes the kit of a file. False, with one line in @p message, if it is none; the kit before
 * stays. */
bool own_kit_load(OwnKit *own, const char *path, char *message, size_t size);
/** The same of a text. */
bool own_kit_set(OwnKit *own, const char *text, size_t length, char *message, size_t size);
/** The text, terminated, which the caller frees; NULL if there is no kit, or memory is short. */
char *own_kit_text(OwnKit *own);
/** Copies the definition. False if there is none. */
bool own_kit_copy(OwnKit *own, TaborKitDef *def);
/** ANY. Changes with every kit that is taken; 0: there is none. */
unsigned own_kit_version(const OwnKit *own) REALTIME;

#endif
