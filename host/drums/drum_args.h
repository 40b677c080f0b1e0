/* SPDX-License-Identifier: MIT */
/**
 * @file drum_args.h
 * The drum that a command is about: a preset, by name or from a file, changed by --set.
 */
#ifndef TABOR_HOST_DRUM_ARGS_H
#define TABOR_HOST_DRUM_ARGS_H

#include "base/options.h"
#include "drums/default_preset.h"

/** What the help of a command says of its PRESET. */
#define PRESET_NOTES                                                                               \
  "PRESET is a name that 'tabor presets' lists, or a file: with a '/' in it, or ending in .ini.\n" \
  "Without one it is " DEFAULT_PRESET ".\n"

/** Rows of the option tables for what drum_load() and model_options_read() read. */
#define OPTION_SET                                                                                 \
  { "set", 0, "KEY=VALUE", "change a parameter of the drum (repeatable)" }
#define OPTION_RATE                                                                                \
  { "rate", 0, "HZ", "sample rate, 22050 to 192000 (default 48000)" }
#define OPTION_QUALITY                                                                             \
  { "quality", 0, "LEVEL", "draft, live, studio or reference (default live)" }

/** PRESET of the command line, or the default. */
const char *preset_argument(const Arguments *arguments);
/** True if @p preset is a file: it has a '/' or ends in ".ini". */
bool preset_is_file(const char *preset);
/** The name of a file without its folder. */
const char *preset_base_name(const char *path);
/** What names of files are made of. */
typedef struct PresetStem {
  const char *text;
  int length;
} PresetStem;
/** "snare-14x5.5" both of that and of "drums/snare-14x5.5.ini". */
PresetStem preset_stem(const char *preset);
/** Names of a TaborDrumDef's microphones and strikers, for suggest(). */
const char *drum_mic_name(const void *def, size_t index);
const char *drum_striker_name(const void *def, size_t index);
/** What microphone @p mic of @p from is on the drum @p to: that of its name, else of its place, else the first. */
uint32_t drum_same_mic(const TaborDrumDef *from, uint32_t mic, const TaborDrumDef *to);
/** Reads the preset, applies every --set in order, and validates the result. A --set adds no
 * microphone or striker: in a file a new name makes one, on a command line it is a slip. */
Outcome drum_load(const Arguments *arguments, TaborDrumDef *def);
/** Place of a preset in the list of those that are built in; -1 for a file. */
int preset_place(const char *preset);
/** The same of the preset that drum_load() reads; -1 if --set may have changed it, too. */
int drum_listed_preset(const Arguments *arguments);
/** Reads a preset by itself, and validates it. */
Outcome drum_load_preset(const char *preset, TaborDrumDef *def);
/** Sets one parameter and validates the result, or leaves @p def alone; @p what, as "--set", begins messages
 * that would not name the key otherwise. Adds no microphone or striker. */
Outcome drum_set(TaborDrumDef *def, const char *what, const char *key, const char *value);
/** Reads --rate and --quality. Without --quality the level is that of --set quality.level, else live: a level
 * in the preset itself is for programs that use the library. */
Outcome model_options_read(const Arguments *arguments, const TaborDrumDef *def,
                           TaborModelOptions *options);
/** "live" and the like for a TaborQuality that is not the default. */
const char *quality_name(uint32_t quality);
/** Builds a model, with one reference that is the caller's. On an error *model is NULL. */
Outcome model_create(const TaborDrumDef *def, const TaborModelOptions *options, TaborModel **model);
/** Builds a model and a drum of it. On an error *drum is NULL. */
Outcome drum_create(const TaborDrumDef *def, const TaborModelOptions *options, TaborDrum **drum);

#endif
