/* SPDX-License-Identifier: MIT */
/**
 * @file render_report.h
 * The report on a finished rendering.
 */
#ifndef TABOR_HOST_RENDER_REPORT_H
#define TABOR_HOST_RENDER_REPORT_H

#include <jansson.h>

#include "render/offline_player.h"

/** Prints warnings, then gives the facts: with --json in *report, otherwise in lines on standard
 * error. */
Outcome render_report(const OfflinePlayer *player, json_t **report);

#endif
