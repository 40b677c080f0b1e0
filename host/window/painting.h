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
#define WINDOW_TEXT 64  /**< bytes of a text, its end included */
#define USUAL_TEXT 13.0 /**< size of letters [pixels] */
#define SMALL_TEXT 10.5 /**< of what explains */

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
  BUTTON_REDO,
  BUTTON_PAGE,   /**< the list of pages */
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
void alarm(cairo_t *cairo);

/** Empties the window, and sets scale and font. */
void paint_paper(cairo_t *cairo, double scale);
void paint_text(cairo_t *cairo, double x, double y, Align align, const char *text);
/** From @p x on; what is longer than @p room ends in dots. */
void paint_text_in(cairo_t *cairo, double x, double y, double room, const char *text);
/** In lines around @p x, at most @p room wide, the first at @p y; what is too long is cut. */
void paint_lines(cairo_t *cairo, double x, double y, double room, uint32_t most, const char *text);
void paint_box(cairo_t *cairo, const Box *box);
/** A frame around what the keys act on. */
void paint_focus(cairo_t *cairo, const Box *box);
/** A small square with a letter, as of a mixer's row; lit while it acts. */
void paint_switch(cairo_t *cairo, const Box *box, const char *letter, bool is_lit);
/** The part of a control's way up to @p position, lit or grey. */
void paint_way(cairo_t *cairo, const Box *way, double position, bool is_lit);
void paint_button(cairo_t *cairo, Button button, const char *text, bool lit);
/** The button at a place, or BUTTON_COUNT. */
Button button_at(double x, double y);
/** What stands in the frame of all windows. */
typedef struct Frame {
  const char *title, *page; /**< of the sound, and of the controls */
  bool is_second;           /**< the second of two settings plays */
  bool can_undo, can_redo;
  double peaks[2]; /**< of two sides, 1 at full scale */
} Frame;

/** Title, buttons and meters. */
void paint_frame(cairo_t *cairo, const Frame *frame);

#endif
