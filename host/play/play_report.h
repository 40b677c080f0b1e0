/* SPDX-License-Identifier: MIT */
/**
 * @file play_report.h
 * The report at the end of a live session.
 */
#ifndef TABOR_HOST_PLAY_REPORT_H
#define TABOR_HOST_PLAY_REPORT_H

#include "play/live_session.h"

/** Prints warnings about problems, then a summary line, or with --json the facts. */
Outcome play_report(LiveSession *session);

#endif
