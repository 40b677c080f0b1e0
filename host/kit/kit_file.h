/* SPDX-License-Identifier: MIT */
/**
 * @file kit_file.h
 * Reads kit files: the sections `kit`, `room` and `drum.NAME` are a kit's definition; what stands in sections `note.N` is
 * somebody else's (kit_samples.h).
 */
#ifndef TABOR_HOST_KIT_FILE_H
#define TABOR_HOST_KIT_FILE_H

#include <tabor/kit.h>

#include "drums/preset_file.h"

/** Who reads a kit file. */
typedef struct KitFileReader {
  TaborKitDef *def;
  PresetPairFn *note; /**< takes sections "note.N" and their pairs; NULL: they are passed over */
  void *context;      /**< of `note` */
} KitFileReader;

/** Reads a file to reader->def, as preset_file_read(). Ranges and rules are left to tabor_kit_def_validate(). */
PresetFileStatus kit_file_read(const char *path, const KitFileReader *reader, char *message,
                               size_t size);
/** The same of a text, which messages call @p name. */
PresetFileStatus kit_file_parse(const char *name, const char *text, size_t length,
                                const KitFileReader *reader, char *message, size_t size);
/** tabor_kit_def_set(), where the preset of a drum may be the user's own, too: a name, or a file. */
TaborStatus kit_file_set(TaborKitDef *def, const char *key, const char *value, TaborError *error);
/** Names a kit as its file is called, without folder and extension. */
void kit_name_after(TaborKitDef *def, const char *path);
/** True if the definition can play: it has a drum, each can stand in its place, and passes tabor_kit_def_validate(). Otherwise @p message says why. */
bool kit_file_check(const char *name, const TaborKitDef *def, char *message, size_t size);
/** True for a section "note.N". */
bool kit_file_is_note(const char *section);

#endif
