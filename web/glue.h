/* SPDX-License-Identifier: MIT */
/* What drums and kits for JavaScript (glue.c, kit_glue.c) have in common. */
#ifndef TABOR_WEB_GLUE_H
#define TABOR_WEB_GLUE_H

#include "tabor/tabor.h"

enum { BLOCK = 128, MOST_EVENTS = 64 };

#define EXPORT(name) __attribute__((export_name(name)))
#define IMPORT(name) __attribute__((import_module("tabor"), import_name(name)))

/* Hears how far a model is, 0 to 1. */
IMPORT("progress") void report_progress(double done);

#endif
