/* SPDX-License-Identifier: MIT */
/**
 * @file list_view.h
 * A list that scrolls in the place of the controls: lines under categories, each with a name and
 * what it is about. A line is chosen by the mouse, or by a cursor that keys move.
 */
#ifndef TABOR_WINDOW_LIST_VIEW_H
#define TABOR_WINDOW_LIST_VIEW_H

#include <cairo.h>
#include <stdbool.h>
#include <stdint.h>
#include <tabor/tabor.h>

#define LIST_MOST 600             /**< lines; further ones are not listed */
#define LIST_NO_CURSOR UINT32_MAX /**< keys have not been used */

/** A line: a category, or an entry below it. */
typedef struct ListLine {
  bool is_category, is_file, is_favourite;
  bool is_action;  /**< no sound: it has no star */
  uint32_t number; /**< what the list's owner knows it by */
  char name[TABOR_NAME_SIZE], text[TABOR_TEXT_SIZE];
} ListLine;

typedef struct ListView {
  bool has_stars;        /**< entries can be favourites */
  uint32_t count, first; /**< of the lines that are seen, the first */
  uint32_t cursor;       /**< or LIST_NO_CURSOR */
  ListLine lines[LIST_MOST];
} ListView;

/** MAIN. Empties it. */
void list_view_clear(ListView *list);
/** MAIN. A new line at the end; NULL if there are too many. */
ListLine *list_view_add(ListView *list, const char *name, const char *text);
void list_view_add_category(ListView *list, const char *name);
/** MAIN. Shows the first line of the name, if there is one. */
void list_view_show(ListView *list, const char *name);
/** By so many notches of the wheel, up with positive @p steps. */
void list_view_scroll(ListView *list, int steps);
/** Moves the cursor over so many entries, down with positive @p steps; at first it stands at the
 * entry @p name. */
void list_view_move(ListView *list, int steps, const char *name);
/** The entry of the cursor; NULL without one. */
const ListLine *list_view_chosen(const ListView *list);
/** The entry at a place at scale 1, or NULL. */
const ListLine *list_view_at(const ListView *list, double x, double y);
/** True if a place of an entry is that of its star. */
bool list_view_is_star(const ListView *list, double x);
/** True if the list stands at the place. */
bool list_view_has(double x, double y);
/** Draws it; entries of the name @p marked are marked. */
void list_view_draw(const ListView *list, cairo_t *cairo, const char *marked);

#endif
