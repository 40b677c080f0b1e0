/* SPDX-License-Identifier: MIT */
/**
 * @file render_report.h
 * What there is to say about a finished rendering.
 */
#ifndef TABOR_HOST_RENDER_REPORT_H
#define TABOR_HOST_RENDER_REPORT_H

#include <jansson.h>

#include "render/offline_player.h"

/** Warnings, then the facts: with --json to *report, otherwise as a line or more on standard error. */
Outcome render_report(const OfflinePlayer *player, json_t **report);

#endif
