/* SPDX-License-Identifier: MIT */
/**
 * @file window_size.h
 * The sizes of all windows: from half to four times WINDOW_WIDTH by WINDOW_HEIGHT, in these
 * proportions.
 */
#ifndef TABOR_WINDOW_WINDOW_SIZE_H
#define TABOR_WINDOW_WINDOW_SIZE_H

#include <stdint.h>

#define WINDOW_PERIOD 33 /**< how often a window is to be updated [ms] */

/** The size at @p scale, limited. */
void window_size(double scale, uint32_t *width, uint32_t *height);
/** The largest size within @p width by @p height pixels. */
void window_fit(uint32_t *width, uint32_t *height);

#endif
