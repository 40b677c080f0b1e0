/* SPDX-License-Identifier: MIT */
/**
 * @file window_checks.h
 * What the tests of the plugins' window share: where things are in it.
 */
#ifndef TABOR_TESTS_WINDOW_CHECKS_H
#define TABOR_TESTS_WINDOW_CHECKS_H

enum { WIDTH = 720, HEIGHT = 440 };               /* of the window at scale 1 */
enum { MIDDLE_X = 205, MIDDLE_Y = 215, R = 175 }; /* of the head in it */
enum { CONTROL_X = 420, CONTROL_Y = 66, CONTROL_WIDTH = 276, CONTROL_ROW = 40 };
enum { STRAINER_Y = CONTROL_Y + 4 * CONTROL_ROW + 26, GAIN_Y = CONTROL_Y + 7 * CONTROL_ROW + 26 };

enum { COMPARE_X = 450, UNDO_X = 498, REDO_X = 530, PAGE_X = 592, BUTTON_Y = 409 };
enum { TITLE_X = 550, TITLE_Y = 34, LIST_X = 500, LIST_Y = 60, LIST_LINE = 36, LIST_LINES = 9 };

#endif
