/* SPDX-License-Identifier: MIT */
/**
 * @file line_editor.h
 * One line of text that is typed, with a cursor and the lines before it.
 *
 * Left, right, Home and End (Ctrl-A, Ctrl-E) move; Backspace, Delete, Ctrl-K, Ctrl-U and Ctrl-W erase a character,
 * the rest, the beginning, a word; up and down fetch earlier lines; Enter is done, Escape gives up.
 */
#ifndef TABOR_HOST_LINE_EDITOR_H
#define TABOR_HOST_LINE_EDITOR_H

#include "ui/keys.h"

#define LINE_SIZE 200   /**< bytes of a line with its terminator */
#define LINE_HISTORY 50 /**< lines that are kept */

/** Begins as {0}. */
typedef struct LineEditor {
  char text[LINE_SIZE];                  /**< UTF-8 */
  size_t length;                         /**< bytes */
  size_t cursor;                         /**< byte before which is typed */
  char history[LINE_HISTORY][LINE_SIZE]; /**< the newest last */
  size_t history_count;
  size_t recalled;       /**< how many lines back the text is; 0: what is being typed */
  char typed[LINE_SIZE]; /**< the same while another is recalled */
} LineEditor;

typedef enum LineOutcome {
  LINE_EDITING, /**< goes on */
  LINE_DONE,    /**< text is to be carried out, and is part of the history now */
  LINE_GIVEN_UP /**< nothing is */
} LineOutcome;

/** Begins an empty line. */
void line_editor_begin(LineEditor *editor);
LineOutcome line_editor_take(LineEditor *editor, Key key);
/** Replaces the bytes from @p start to the cursor, as far as there is room. */
void line_editor_replace(LineEditor *editor, size_t start, const char *text);

#endif
