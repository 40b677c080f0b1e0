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

/** Whether a drum is its preset and what differs from it, or all its parameters, which then are the same in every version. */
typedef enum KitTextKind { KIT_TEXT_SHORT, KIT_TEXT_WHOLE } KitTextKind;

/**
 * Gives the text to @p sink, line by line. A drum whose name is that of
 * no built-in preset always has all its parameters. @p by says in the first line who wrote it, such as "'tabor show'".
 */
Outcome kit_text_write(const TaborKitDef *def, const KitSamples *samples, KitTextKind kind,
                       const char *by, PresetSink *sink, void *context);

#endif
