/* SPDX-License-Identifier: MIT */
/**
 * @file play_report.h
 * What there is to say once a live session is over.
 */
#ifndef TABOR_HOST_PLAY_REPORT_H
#define TABOR_HOST_PLAY_REPORT_H

#include "play/live_session.h"

/** Warns of what went wrong, and prints a line, or with --json the facts. */
Outcome play_report(LiveSession *session);

#endif
