/* SPDX-License-Identifier: MIT */
/**
 * @file drum_picture.h
 * What a drum's window shows, drawn by cairo, and what lies at a place of it.
 */
#ifndef TABOR_WINDOW_DRUM_PICTURE_H
#define TABOR_WINDOW_DRUM_PICTURE_H

#include <cairo.h>

#include "window/drum_window.h"
#include "window/painting.h"

typedef enum DrumPart {
  DRUM_PART_NONE,
  DRUM_PART_HEAD,
  DRUM_PART_BUTTON,
  DRUM_PART_CONTROL
} DrumPart;

#define DRUM_NO_MIC UINT32_MAX

/** What lies at a place. */
typedef struct DrumPlace {
  DrumPart part;
  Button button;
  uint32_t control;
  double x,
    y; /**< on the head in parts of its radius, y away from the player; x of a control: the position */
} DrumPlace;

typedef struct DrumPicture {
  DrumWindowScene scene;
  uint32_t controls;
  DrumControl control[DRUM_WINDOW_CONTROLS];
  double meters[2];
  double speed;     /**< of strokes [m/s] */
  double struck[2]; /**< place of the newest stroke, as on the head */
  double glow;      /**< 1 when it falls, then less */
  uint32_t mic;     /**< whose place is written, or DRUM_NO_MIC */
} DrumPicture;

void drum_picture_draw(const DrumPicture *picture, cairo_t *cairo, double scale);
/** What lies at a pixel. */
DrumPlace drum_picture_place(double scale, double x, double y);
/** The microphone at a pixel, or DRUM_NO_MIC. */
uint32_t drum_picture_mic(const DrumPicture *picture, double scale, double x, double y);
/** Moves a microphone to a pixel; its height stays. */
void drum_picture_move_mic(const DrumPicture *picture, double scale, double x, double y,
                           DrumMic *mic);
/** The position of a control that is held at this pixel. */
double drum_picture_position(double scale, double x);

#endif
