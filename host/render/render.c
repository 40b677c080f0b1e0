/* SPDX-License-Identifier: MIT */
/**
 * @file render.c
 * `tabor render`: renders drums as sound files.
 */
#include "base/command.h"
#include "base/json_output.h"
#include "drums/drum_args.h"
#include "render/render_jobs.h"
#include "render/render_options.h"

/* The file that -o names. */
static Outcome render_single(RenderBatch *batch) {
  RenderJob *const job = &batch->jobs[0];
  const Outcome outcome = render_jobs_do(batch);
  if (outcome != OUTCOME_OK || !job->report) return outcome;
  json_t *const report = job->report;
  job->report = NULL;
  return json_print(report);
}

static Outcome run(const Arguments *arguments) {
  RenderBatch batch;
  Outcome outcome = render_batch_read(arguments, &batch);
  if (outcome == OUTCOME_OK) {
    outcome = batch.folder ? render_jobs_run(&batch) : render_single(&batch);
  }
  render_batch_free(&batch);
  return outcome;
}

static const char notes[] =
  "A stroke is written --strike time=0,velocity=2.5,radius=0.05,angle=30,striker=stick:\n"
  "  time       when [s], 0 to 3600\n"
  "  drum       of --kit alone, which needs it: one of its drums, by name\n"
  "  velocity   how fast [m/s], 0.01 to 30, or midi=1..127 as --velocity-range has it\n"
  "  radius     how far from the centre [m], or in per cent of the head, as 80%\n"
  "  angle      in which direction [degrees], counter-clockwise from +x\n"
  "  striker    one of the preset's, by name\n"
  "  technique  normal; rimshot: head and hoop at once; cross-stick: the shaft on the hoop, the\n"
  "             tip resting on the head; rim: the hoop alone; buzz: a hand goes on pressing the\n"
  "             stick, which bounces; sweep: a hand draws a brush around the centre, at this "
  "radius\n"
  "             and velocity, or the brush's sweep_speed\n"
  "  pressure   how hard it presses, 0 to 1 for 0.3 to 8 N; the preset's [hand] does the rest\n"
  "  hold       after which time it lifts the stick or brush [s], 0.001 to 60, otherwise 0.5\n"
  "  wire, place, displacement, pull   of technique pluck, where a finger pulls a wire and lets "
  "go:\n"
  "             the wire's number from 1, where along it (0 to 1, otherwise 0.3), how far it "
  "would\n"
  "             go if it touched nothing [m] (0.003) and in which time [s] (0.01)\n"
  "  id         a number for the hand: its next stroke lifts the stick that it presses\n"
  "  event      strike; press changes the pressure on the sticks in play, release takes them\n"
  "             away, move says where a sweeping brush is at that time, between such times it\n"
  "             goes straight on in radius and angle: those with this id, or all\n"
  "Fields left out are the preset's; a time left out is 0.\n"
  "\n"
  "--events reads a stroke a line, as comma-separated values; the first line names the columns:\n"
  "  time,velocity,radius,striker\n"
  "  0,2.5,30%,stick\n"
  "  0.5,1,,\n"
  "Any of the fields above, midi too, in any order; empty fields are the preset's. Lines may come\n"
  "in any order of time; those that begin with '#' are comments. Further --events and --strike\n"
  "add to them.\n"
  "\n"
  "--humanize moves every stroke by up to 15 mm and changes its speed by up to 6 %, times its\n"
  "amount; the same --seed does it in the same way, for every sound alike.\n"
  "\n"
  "--replay plays a log of 'tabor play --log' again, which has drum, strokes, rate, quality and "
  "gain of\n"
  "the performance. --mic and --split give other microphones of it, --duration another length.\n"
  "The log of a performance that was killed, take.part.log, is played as far as it goes.\n"
  "\n"
  "--input lets a loudspeaker play a sound to the drum: the first channel of FILE, whose rate is "
  "--rate. It stands\n"
  "where microphone --input-mic is, turned up to --input-level at the drum; no stroke is played "
  "unless asked\n"
  "for. The sound that is written is that of the drum alone.\n"
  "\n"
  "--kit plays --midi-file and strokes on a kit, into its stereo mix, kit.wav unless -o names it; "
  "--split "
  "gives\n"
  "a stereo file for each drum. --set KEY=VALUE changes the kit, as drum.snare.batter.pitch=G3.\n"
  "\n"
  "With -o FOLDER/ every PRESET becomes FOLDER/PRESET.wav; with --each, every PRESET plays every\n"
  "--events file by itself, which becomes FOLDER/PRESET-EVENTS.wav. The folder is created if its\n"
  "name ends in '/'. All other options go for every sound.\n"
  "\n"
  "--vary draws a value for each of --count sounds, FOLDER/PRESET-01.wav and so on: "
  "batter.pitch=A3..D4,\n"
  "strike.velocity=1..8, or from a list, strike.striker=stick,mallet; of a kit, "
  "drum.snare.batter.pitch=A3..D4.\n"
  "Values cover each range evenly; --seed draws others. FOLDER/variations.csv says what each sound "
  "has.\n"
  "\n" PRESET_NOTES "'tabor show' lists the keys for --set.\n";

const Command render_command = {
  .name = "render",
  .operand = "[PRESET]...",
  .summary = "Play drums into sound files",
  .notes = notes,
  .options = render_options,
  .run = run,
};
