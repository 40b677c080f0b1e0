/* SPDX-License-Identifier: MIT */
/**
 * @file drum_args.h
 * The drum of a command: a preset, by name or from a file, changed by --set.
 */
#ifndef TABOR_HOST_DRUM_ARGS_H
#define TABOR_HOST_DRUM_ARGS_H

#include <tabor/kit.h>

#include "base/options.h"
#include "drums/default_preset.h"
#include "drums/preset_place.h"
#include "drums/shared_models.h"
#include "drums/user_presets.h"

/** Help text of commands for PRESET. */
#define PRESET_NOTES                                                                               \
  "PRESET is a name that 'tabor presets' lists, one that ':save NAME' of 'tabor play' gave, or "   \
  "a\n"                                                                                            \
  "file: with a '/' in it, or ending in .ini.\n"                                                   \
  "Without one it is " DEFAULT_PRESET ".\n"

/** Rows of the option tables for the options that drum_load() and model_options_read() read. */
#define OPTION_SET                                                                                 \
  { "set", 0, "KEY=VALUE", "change a parameter of the drum (repeatable)" }
#define OPTION_RATE                                                                                \
  { "rate", 0, "HZ", "sample rate, 22050 to 192000 (default 48000)" }
#define OPTION_QUALITY                                                                             \
  { "quality", 0, "LEVEL", "draft, live, studio or reference (default live)" }

/** Returns PRESET of the command line, or the default. */
const char *preset_argument(const Arguments *arguments);
/**
 * Returns the file of @p preset: itself, or the user's of that name (user_presets.h), written to @p
 * room. NULL if no file has it: the built-in presets come first.
 */
const char *preset_file(const char *preset, char room[USER_PRESET_PATH]);
/** Names of a TaborDrumDef's microphones and strikers, for suggest(). */
const char *drum_mic_name(const void *def, size_t index);
const char *drum_striker_name(const void *def, size_t index);
/** Names of a TaborKitDef's drums, likewise. */
const char *kit_drum_name(const void *kit, size_t index);
/** Lets the outputs after @p swap be the microphones of @p model that correspond to those of @p
 * first, in their order: by name, else by index, else the first. */
void drum_keep_mics(const TaborDrumDef *first, const TaborModel *model, TaborSwap *swap);
/** Reads the preset, applies every --set in order, validates the result, and turns pitches into
 * tensions.
 * --set adds no microphone or striker: a new name adds one in a file, but is taken for a mistake on
 * the command line. */
Outcome drum_load(const Arguments *arguments, TaborDrumDef *def);
/** Index of the preset that drum_load() reads; -1 for a file or if --set may have changed it. */
int drum_listed_preset(const Arguments *arguments);
/** The same for a preset without any --set. */
Outcome drum_load_preset(const char *preset, TaborDrumDef *def);
/** Sets one parameter, validates the result, and turns a pitch into a tension; leaves @p def
 * unchanged on an error. Messages that do not name the key start with @p what, such as "--set".
 * Adds no microphone or striker. */
Outcome drum_set(TaborDrumDef *def, const char *what, const char *key, const char *value);
/** Reads --rate and --quality. Without --quality the level is that of --set quality.level, else
 * live. A level in the preset itself is only for programs that use the library. */
Outcome model_options_read(const Arguments *arguments, const TaborDrumDef *def,
                           TaborModelOptions *options);
/** Name of a TaborQuality, such as "live"; not for the default. */
const char *quality_name(uint32_t quality);
/** Builds a model, which is announced if it takes long, or takes one of @p shared, which may be
 * NULL, and creates a drum of it. On an error *drum is NULL. */
Outcome drum_create(const TaborDrumDef *def, const TaborModelOptions *options, SharedModels *shared,
                    TaborDrum **drum);

#endif
