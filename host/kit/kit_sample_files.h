/* SPDX-License-Identifier: MIT */
/**
 * @file kit_sample_files.h
 * The program reads a kit's sound files.
 */
#ifndef TABOR_HOST_KIT_SAMPLE_FILES_H
#define TABOR_HOST_KIT_SAMPLE_FILES_H

#include "base/message.h"
#include "kit/kit_sounds.h"

/** Gives the kit, which does not play yet, the sounds of its definition. */
Outcome kit_sample_files_read(TaborKit *kit);

#endif
