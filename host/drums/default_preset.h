/* SPDX-License-Identifier: MIT */
/**
 * @file default_preset.h
 * The preset that is used if none is named.
 */
#ifndef TABOR_HOST_DEFAULT_PRESET_H
#define TABOR_HOST_DEFAULT_PRESET_H

#define DEFAULT_PRESET "snare-14x5.5"

#endif
