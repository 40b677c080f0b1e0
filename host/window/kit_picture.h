/* SPDX-License-Identifier: MIT */
/**
 * @file kit_picture.h
 * What a kit's window shows, drawn by cairo, and what lies at a place of it.
 */
#ifndef TABOR_WINDOW_KIT_PICTURE_H
#define TABOR_WINDOW_KIT_PICTURE_H

#include "window/kit_window.h"

typedef enum KitPart { KIT_PART_NONE, KIT_PART_DRUM, KIT_PART_BUTTON, KIT_PART_CONTROL } KitPart;

/** What lies at a place. */
typedef struct KitPlace {
  KitPart part;
  Button button;
  KitKnobId knob;
  uint32_t drum;
  double radius,
    angle; /**< on a drum: a part of the head's, or negative where no head is seen; [deg] */
} KitPlace;

typedef struct KitPicture {
  KitWindowScene scene;
  char value[KIT_KNOB_COUNT][WINDOW_TEXT]; /**< of each control */
  double position[KIT_KNOB_COUNT];
  double meters[2];
  double speed;                 /**< of strokes [m/s] */
  double glow[TABOR_KIT_DRUMS]; /**< 1 when a fast stroke falls, then less */
} KitPicture;

/** The controls that the picture shows, one after another; KIT_KNOB_COUNT: there is no such number. */
KitKnobId kit_picture_knob(const KitPicture *picture, uint32_t number);
void kit_picture_draw(const KitPicture *picture, cairo_t *cairo, double scale);
/** What lies at a pixel. */
KitPlace kit_picture_place(const KitPicture *picture, double scale, double x, double y);
/** The position of a control that is held at this pixel. */
double kit_picture_position(KitKnobId knob, double scale, double x);

#endif
