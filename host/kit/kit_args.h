/* SPDX-License-Identifier: MIT */
/**
 * @file kit_args.h
 * The kit of a command: built in or from a file, changed by --set.
 */
#ifndef TABOR_HOST_KIT_ARGS_H
#define TABOR_HOST_KIT_ARGS_H

#include <tabor/kit.h>

#include "base/options.h"

/** Row of an option table for the option that kit_load() reads. */
#define OPTION_KIT                                                                                 \
  { "kit", 0, "KIT", "several drums, by name or from a file (docs/kit.md)" }

/** Refuses an option of @p excluded, @p count long-option names, with @p reason why a kit does not
 * go with it, and a drum: the kit has its own. */
Outcome kit_refuse_options(const Arguments *arguments, const char *const *excluded, size_t count,
                           const char *reason);

/** True for the name of a built-in kit. */
bool kit_is_builtin(const char *name);

/** Reads --kit: a name that 'tabor presets --kits' lists, or a file: with a '/' in it, or ending in
 * .ini. Applies every
 * --set in order, and validates the result. */
Outcome kit_load(const Arguments *arguments, TaborKitDef *def);

#endif
