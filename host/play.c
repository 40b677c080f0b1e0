/* SPDX-License-Identifier: MIT */
/**
 * @file play.c
 * `tabor play`: a drum to play on.
 */
#include "command.h"
#include "drum_source.h"
#include "performance.h"

static Outcome play(PlayRequest *request) {
  Performance performance;
  Outcome outcome = performance_open(&performance, request);
  if (outcome == OUTCOME_OK) outcome = performance_run(&performance);
  const Outcome closing = performance_close(&performance);
  return outcome == OUTCOME_OK ? closing : outcome;
}

static Outcome run(const Arguments *arguments) {
  PlayRequest request;
  Outcome outcome = play_request_read(arguments, &request);
  if (outcome == OUTCOME_OK) outcome = play(&request);
  play_request_free(&request);
  return outcome;
}

static const char notes[] = PRESET_NOTES;

const Command play_command = {
  .name = "play",
  .operand = "[PRESET]",
  .summary = "Play a drum live",
  .notes = notes,
  .options = play_options,
  .run = run,
};
