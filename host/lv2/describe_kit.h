/* SPDX-License-Identifier: MIT */
/**
 * @file describe_kit.h
 * The description of Tabor Kit, from its tables.
 */
#ifndef TABOR_LV2_DESCRIBE_KIT_H
#define TABOR_LV2_DESCRIBE_KIT_H

#include <stdbool.h>

/** The plugin and the groups of its ports. */
void put_kit(bool has_window);

#endif
