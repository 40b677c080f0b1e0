/* SPDX-License-Identifier: MIT */
/**
 * @file play_report.h
 * The report at the end of a live session.
 */
#ifndef TABOR_HOST_PLAY_REPORT_H
#define TABOR_HOST_PLAY_REPORT_H

#include "play/live_session.h"

/** Warns if the output had gaps because a block took longer than it lasts: @p worst is the largest
 * share of its time. */
void play_report_gaps(uint64_t gaps, double worst);
/** Prints warnings about problems, then a summary line, or with --json the facts. */
Outcome play_report(LiveSession *session);

#endif
