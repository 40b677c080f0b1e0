/* SPDX-License-Identifier: MIT */
/**
 * @file painting.h
 * What the pictures of all windows are made of: boxes, colours, texts, buttons and meters, at
 * scale 1.
 */
#ifndef TABOR_WINDOW_PAINTING_H
#define TABOR_WINDOW_PAINTING_H

#include <cairo.h>
#include <stdbool.h>
#include <stdint.h>

#define WINDOW_WIDTH 720 /**< [pixels] at scale 1 */
#define WINDOW_HEIGHT 440
#define WINDOW_TEXT 64 /**< bytes of a text, its end included */

typedef struct Box {
  double x, y, width, height;
} Box;

typedef enum Align { AT_LEFT, AT_MIDDLE, AT_RIGHT } Align;

/** Buttons, at the same places in all windows. */
typedef enum Button {
  BUTTON_BEFORE,
  BUTTON_NEXT,
  BUTTON_COMPARE,
  BUTTON_UNDO,
  BUTTON_PAGE,
  BUTTON_SOUNDS, /**< the title: the list of sounds */
  BUTTON_COUNT
} Button;

bool box_has(const Box *box, double x, double y);
/** Scale at which the picture fills a window of this size [pixels]. */
double painting_scale(uint32_t width, uint32_t height);

void paper(cairo_t *cairo);
void field(cairo_t *cairo);
void ink(cairo_t *cairo);
void pale(cairo_t *cairo);
void accent(cairo_t *cairo);

/** Empties the window, and sets scale and font. */
void paint_paper(cairo_t *cairo, double scale);
void paint_text(cairo_t *cairo, double x, double y, Align align, const char *text);
void paint_box(cairo_t *cairo, const Box *box);
/** The part of a control's way up to @p position. */
void paint_way(cairo_t *cairo, const Box *way, double position);
void paint_button(cairo_t *cairo, Button button, const char *text, bool lit);
/** The button at a place, or BUTTON_COUNT. */
Button button_at(double x, double y);
/** Title, the buttons of all windows and the meters of two sides, whose peaks are 1 at full scale.
 */
void paint_frame(cairo_t *cairo, const char *title, bool is_second, bool can_undo,
                 const double peaks[2]);

#endif
