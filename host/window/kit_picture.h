/* SPDX-License-Identifier: MIT */
/**
 * @file kit_picture.h
 * The drums of a kit where they stand, from above. Places are at scale 1.
 */
#ifndef TABOR_WINDOW_KIT_PICTURE_H
#define TABOR_WINDOW_KIT_PICTURE_H

#include "window/window_scene.h"

void kit_picture_draw(const WindowScene *scene, cairo_t *cairo);
/** Finds the drum at a place. */
void kit_picture_find(const WindowScene *scene, double x, double y, WindowPlace *place);

#endif
