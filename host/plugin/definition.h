/* SPDX-License-Identifier: MIT */
/**
 * @file definition.h
 * The definition of a drum or a kit, whatever it is, by its keys: what a window edits and saves.
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_PLUGIN_DEFINITION_H
#define TABOR_PLUGIN_DEFINITION_H

#include <tabor/kit.h>

#define DEFINITION_KEY (4 * TABOR_NAME_SIZE)   /**< bytes of a key */
#define DEFINITION_VALUE (2 * TABOR_TEXT_SIZE) /**< bytes of a value */

typedef struct Definition {
  bool is_kit;
  TaborDrumDef drum; /**< unless it is a kit */
  TaborKitDef kit;
} Definition;

/** Tells @p visit of each full key, in the order of files. False: memory is short. */
bool definition_visit(const Definition *definition, void (*visit)(void *context, const char *key),
                      void *context);
/** Value of a key as the engine writes it; false if there is no such key. */
bool definition_get(const Definition *definition, const char *key, char value[DEFINITION_VALUE]);
/** Sets a key, and checks the whole. False with the reason in @p error, and nothing is changed. */
bool definition_set(Definition *definition, const char *key, const char *value, TaborError *error);
/** Fills @p definition with the built-in drum or kit that has its name. False: there is none. */
bool definition_find_built_in(const Definition *named, Definition *definition);
/** What it calls itself. */
const char *definition_name(const Definition *definition);
void definition_rename(Definition *definition, const char *name);
/** Its text for people, which the caller frees; NULL with the reason in @p error. */
char *definition_text(Definition *definition, TaborError *error);

#endif
