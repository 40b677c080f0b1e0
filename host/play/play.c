/* SPDX-License-Identifier: MIT */
/**
 * @file play.c
 * `tabor play`: plays a drum live.
 */
#include "base/command.h"
#include "drums/drum_args.h"
#include "play/console.h"
#include "play/play_report.h"

/* The first thing that went wrong decides. */
static Outcome worse(Outcome first, Outcome then) { return first != OUTCOME_OK ? first : then; }

/* With the user at the keyboard, who has the terminal back before the last is said. */
static Outcome perform(LiveSession *session) {
  Console *console = NULL;
  Outcome outcome = console_open(session, &console);
  const LiveSessionTurn turn = {.take = console_turn, .context = console};
  if (outcome == OUTCOME_OK) outcome = live_session_run(session, &turn);
  console_close(console);
  return outcome;
}

static Outcome play(PlayRequest *request) {
  LiveSession session;
  Outcome outcome = live_session_open(&session, request);
  if (outcome == OUTCOME_OK) {
    outcome = perform(&session);
    outcome = worse(outcome, live_session_finish(&session));
    outcome = worse(outcome, play_report(&session));
  }
  live_session_close(&session, outcome);
  return outcome;
}

static Outcome run(const Arguments *arguments) {
  PlayRequest request;
  Outcome outcome = play_request_read(arguments, &request);
  if (outcome == OUTCOME_OK) outcome = play(&request);
  play_request_free(&request);
  return outcome;
}

static const char notes[] =
  "The drum plays until Ctrl-C, or for --duration. --events plays strokes that are written down, "
  "as\n"
  "'tabor render' does; its help describes the file.\n"
  "--midi-file plays a MIDI file. Live MIDI comes from every hardware input, or from those that\n"
  "--midi-in names, also if they are plugged in later, and from any program that connects to the\n"
  "input 'tabor-midi'. docs/midi.md has the map.\n"
  "--kit plays several drums by live MIDI, --midi-file and keys, in stereo; docs/kit.md has the\n"
  "notes. The keys ',' and '.' choose the drum that the others play.\n"
  "--log writes the drum, and all that is played on it with its time, for 'tabor render "
  "--replay'.\n"
  "While the drum plays, take.wav and take.log are called take.part.wav and take.part.log. If the\n"
  "program is killed they stay, and can be opened and replayed up to their last moments.\n"
  "--backend file computes as fast as it can into --record FILE, and ends when the drum has died\n"
  "away: with --humanize 0 it gives the same sound as 'tabor render'.\n"
  "\n" PRESET_NOTES "'tabor show' lists the keys for --set.\n";

const Command play_command = {
  .name = "play",
  .operand = "[PRESET]",
  .summary = "Play a drum live",
  .notes = notes,
  .options = play_options,
  .run = run,
};
