/* SPDX-License-Identifier: MIT */
/**
 * @file preset_text.h
 * A drum's definition as the text of a preset file, which reads back to the same drum.
 */
#ifndef TABOR_HOST_PRESET_TEXT_H
#define TABOR_HOST_PRESET_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <tabor/tabor.h>

#include "base/message.h"

/** One parameter of a definition. */
typedef struct PresetEntry {
  char key[2 * TABOR_NAME_SIZE]; /**< "striker.stick.mass" */
  char value[TABOR_TEXT_SIZE];
  const TaborParameter *parameter;
} PresetEntry;

/** Reads entry @p index; false past the last, and on an error, which goes to *outcome. */
bool preset_entry_read(const TaborDrumDef *def, uint32_t index, PresetEntry *entry,
                       Outcome *outcome);

/** True if a preset file, which cannot quote, gives the text @p value back as it is; a kit file likewise. */
bool preset_text_survives(const char *value);

/** Takes a piece of the text. */
typedef Outcome PresetSink(void *context, const char *text, size_t size);

/**
 * Gives the text to @p sink, line by line. Refuses a text parameter that a preset file cannot hold before the first
 * line is given. @p by says in the first line who wrote it, such as "'tabor show'".
 */
Outcome preset_text_write(const TaborDrumDef *def, const char *by, PresetSink *sink, void *context);

/** Gives the text of @p what to @p sink. */
typedef Outcome PresetWriterFn(const void *what, PresetSink *sink, void *context);
/** Writes the file @p path, complete or not at all; an older file of that name is replaced. */
Outcome preset_text_save(const char *path, PresetWriterFn *write, const void *what);

#endif
