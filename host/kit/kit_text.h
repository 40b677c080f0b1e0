/* SPDX-License-Identifier: MIT */
/**
 * @file kit_text.h
 * A kit's definition as the text of a kit file, which reads back to the same kit.
 */
#ifndef TABOR_HOST_KIT_TEXT_H
#define TABOR_HOST_KIT_TEXT_H

#include <tabor/kit.h>

#include "drums/preset_text.h"
#include "kit/kit_sample_files.h"

/**
 * Gives the text to @p sink, line by line: of each drum its preset and what differs from it. A drum whose name is that of
 * no built-in preset has all its parameters. @p by says in the first line who wrote it, such as "'tabor show'".
 */
Outcome kit_text_write(const TaborKitDef *def, const KitSamples *samples, const char *by,
                       PresetSink *sink, void *context);

#endif
