/* SPDX-License-Identifier: MIT */
/**
 * @file window_checks.h
 * What the tests of the plugins' window share: where things are in it, pictures for a person, and
 * files that are open.
 */
#ifndef TABOR_TESTS_WINDOW_CHECKS_H
#define TABOR_TESTS_WINDOW_CHECKS_H

#include <xcb/xcb.h>

enum { WIDTH = 720, HEIGHT = 440 };               /* of the window at scale 1 */
enum { MIDDLE_X = 205, MIDDLE_Y = 215, R = 175 }; /* of the head in it */
enum { CONTROL_X = 420, CONTROL_Y = 66, CONTROL_WIDTH = 276, CONTROL_ROW = 40 };
enum { STRAINER_Y = CONTROL_Y + 4 * CONTROL_ROW + 26, GAIN_Y = CONTROL_Y + 7 * CONTROL_ROW + 26 };

enum { COMPARE_X = 450, UNDO_X = 498, REDO_X = 530, PAGE_X = 592, BUTTON_Y = 409 };
enum { TITLE_X = 550, TITLE_Y = 34, LIST_X = 500, LIST_Y = 60, LIST_LINE = 36, LIST_LINES = 9 };

/** For a person: the window as it is, in the folder $PICTURES. */
void keep_picture(xcb_window_t window, const char *name);
/** Number of files that this process has open; a connection to the server is one. */
long open_files(void);

#endif
