/* SPDX-License-Identifier: MIT */
/* What drums, kits and definitions for JavaScript (glue.c, kit_glue.c, definition_glue.c) have in common. */
#ifndef TABOR_WEB_GLUE_H
#define TABOR_WEB_GLUE_H

#include "tabor/tabor.h"

enum { BLOCK = 128, MOST_EVENTS = 64 };

#define EXPORT(name) __attribute__((export_name(name)))
#define IMPORT(name) __attribute__((import_module("tabor"), import_name(name)))

/* Hears how far a model is, 0 to 1. */
IMPORT("progress") void report_progress(double done);

/* Index of the striker with which a drum is struck unless another one is named. */
uint32_t web_definition_own_striker(const TaborDrumDef *def);

#endif
