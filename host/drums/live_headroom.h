/* SPDX-License-Identifier: MIT */
/**
 * @file live_headroom.h
 * The largest factor by which live parameters of the wires may exceed the values that a model was
 * built with. The model's grid does not suit larger values; they need another model.
 */
#ifndef TABOR_HOST_LIVE_HEADROOM_H
#define TABOR_HOST_LIVE_HEADROOM_H

#define LIVE_HEADROOM 2.0 /**< factor */

#endif
