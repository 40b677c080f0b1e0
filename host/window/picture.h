/* SPDX-License-Identifier: MIT */
/**
 * @file picture.h
 * The picture of a window, drawn by cairo: at the left the drums (drum_picture.h, kit_picture.h),
 * at the right the controls.
 */
#ifndef TABOR_WINDOW_PICTURE_H
#define TABOR_WINDOW_PICTURE_H

#include "window/window_scene.h"

void picture_draw(const WindowScene *scene, cairo_t *cairo, double scale);
/** What lies at a pixel. */
WindowPlace picture_place(const WindowScene *scene, double scale, double x, double y);
/** The position of a control that is held at this pixel. */
double picture_position(double scale, double x);

#endif
