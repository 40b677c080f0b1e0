/* SPDX-License-Identifier: MIT */
/**
 * @file line_editor.h
 * A line editor with a cursor and a history.
 *
 * Left, right, Home and End (Ctrl-A, Ctrl-E) move the cursor. Backspace and Delete erase a
 * character, Ctrl-K the rest, Ctrl-U the beginning, Ctrl-W a word. Up and down recall earlier
 * lines. Enter accepts, Escape cancels.
 */
#ifndef TABOR_HOST_LINE_EDITOR_H
#define TABOR_HOST_LINE_EDITOR_H

#include "base/keys.h"

#define LINE_SIZE 200   /**< size of a line with its terminator [bytes] */
#define LINE_HISTORY 50 /**< most lines kept */

/** Initialise with {0}. */
typedef struct LineEditor {
  char text[LINE_SIZE];                  /**< UTF-8 */
  size_t length;                         /**< bytes */
  size_t cursor;                         /**< insertion point, a byte of text */
  char history[LINE_HISTORY][LINE_SIZE]; /**< the newest last */
  size_t history_count;
  size_t recalled;       /**< how many lines back text is; 0: the new line */
  char typed[LINE_SIZE]; /**< the new line while an earlier one is recalled */
} LineEditor;

typedef enum LineOutcome {
  LINE_EDITING, /**< the line is not complete */
  LINE_DONE,    /**< text is to be executed and has been added to the history */
  LINE_GIVEN_UP /**< cancelled: nothing is to be executed */
} LineOutcome;

/** Starts an empty line. */
void line_editor_begin(LineEditor *editor);
/** Applies a key. */
LineOutcome line_editor_take(LineEditor *editor, Key key);
/** Replaces the bytes from @p start to the cursor, as far as there is room. */
void line_editor_replace(LineEditor *editor, size_t start, const char *text);

#endif
