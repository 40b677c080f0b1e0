/* SPDX-License-Identifier: MIT */
/**
 * @file command.h
 * The commands of the program, each in a file of its own.
 */
#ifndef TABOR_HOST_COMMAND_H
#define TABOR_HOST_COMMAND_H

#include "base/options.h"

extern const Command render_command;  /* render.c */
extern const Command library_command; /* library.c */
extern const Command play_command;    /* play.c */
extern const Command presets_command; /* presets_command.c */
extern const Command show_command;    /* show.c */
extern const Command modes_command;   /* modes.c */
extern const Command bench_command;   /* bench.c */
extern const Command analyze_command; /* analyze.c */
extern const Command devices_command; /* devices.c */
extern const Command fit_command;     /* fit_command.c */

#endif
