/* SPDX-License-Identifier: MIT */
/**
 * @file live_headroom.h
 * How far live keys of the wires may go above what a model was built with: its grid is made for values not
 * far above. Beyond, another model is needed.
 */
#ifndef TABOR_HOST_LIVE_HEADROOM_H
#define TABOR_HOST_LIVE_HEADROOM_H

#define LIVE_HEADROOM 2.0 /**< factor */

#endif
