/* SPDX-License-Identifier: MIT */
/**
 * @file events_file.h
 * `--events`: strokes as comma-separated values.
 *
 * The first line names the columns: any of stroke.h's fields, each once, in any order. Every
 * further line is a stroke or, with `press`, `release` or `move` in the column `event`, a change to
 * a stroke in play. An empty field means the preset's value, an empty time 0. Lines that are blank,
 * hold only commas, or start with '#' are skipped. Blanks around fields are ignored. A field may be
 * in double quotes, as spreadsheets write it. Line ends are LF or CR LF.
 */
#ifndef TABOR_HOST_EVENTS_FILE_H
#define TABOR_HOST_EVENTS_FILE_H

#include "strokes/strokes.h"

#define EVENTS_FILE_LIMIT (8 * 1024 * 1024) /**< bytes */

/** Adds the strokes of file @p name, "-" for standard input, to @p strokes, of a kit to those of
 * each drum; refuses a file without strokes. */
Outcome events_file_read(const char *name, const StrokeTarget *target, Strokes *strokes);

#endif
