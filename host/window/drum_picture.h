/* SPDX-License-Identifier: MIT */
/**
 * @file drum_picture.h
 * One drum from above, its microphones around it. Places are at scale 1.
 */
#ifndef TABOR_WINDOW_DRUM_PICTURE_H
#define TABOR_WINDOW_DRUM_PICTURE_H

#include "window/window_scene.h"

void drum_picture_draw(const WindowScene *scene, cairo_t *cairo);
/** Finds the microphone or the head at a place. */
void drum_picture_find(const WindowScene *scene, double x, double y, WindowPlace *place);
/** Moves a microphone to a place; its height stays. */
void drum_picture_move_mic(const WindowScene *scene, double x, double y, WindowMic *mic);
/** Says where a microphone stands. */
void drum_picture_say_mic(const WindowMic *mic, char *text, size_t size);

#endif
