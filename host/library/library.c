/* SPDX-License-Identifier: MIT */
/**
 * @file library.c
 * `tabor library`: renders a drum as a sample library for samplers.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/command.h"
#include "base/folder.h"
#include "base/interrupt.h"
#include "base/json_output.h"
#include "drums/drum_args.h"
#include "library/library_batch.h"
#include "library/library_kit.h"
#include "library/library_manifest.h"
#include "library/library_sfz.h"
#include "render/render_jobs.h"

/* ---- what came of it ---- */

static json_t *keys_json(const LibrarySound *sound) {
  json_t *keys = json_array();
  for (uint32_t i = 0; i < sound->key_count; i++) {
    keys = json_with_item(keys, json_integer(sound->keys[i]));
  }
  return keys;
}

/* The first key, as of single drums; of a kit all of them, too. */
static json_t *sound_json(const LibraryRequest *request, const LibrarySound *sound) {
  const TaborEvent *const event = &sound->event;
  json_t *const json = json_pack(
    "{s:o, s:s, s:I, s:I, s:I, s:I, s:I, s:o, s:o, s:o}", "file", json_text(sound->file),
    "technique", sound->technique, "key", (json_int_t)sound->keys[0], "low", (json_int_t)sound->low,
    "high", (json_int_t)sound->high, "midi", (json_int_t)sound->midi, "take",
    (json_int_t)sound->take, "velocity", json_number(event->velocity), "radius",
    json_number(event->radius), "angle", json_number(event->angle));
  if (!request->kit) return json;
  const char *const drum = request->kit->def.drum[sound->drum].name;
  return json_with_field(json_with_field(json, "drum", json_text(drum)), "keys", keys_json(sound));
}

static size_t count_failed(const RenderBatch *batch) {
  size_t failed = 0;
  for (size_t i = 0; i < batch->count; i++) failed += batch->jobs[i].outcome != OUTCOME_OK;
  return failed;
}

static Outcome print_report(const LibraryRequest *request, const RenderBatch *batch) {
  const size_t failed = count_failed(batch);
  json_t *sounds = json_array();
  for (size_t i = 0; i < request->plan.count; i++) {
    sounds = json_with_item(sounds, sound_json(request, &request->plan.sounds[i]));
  }
  return json_print(json_pack(
    "{s:o, s:o, s:o, s:I, s:I, s:I, s:o}", request->kit ? "kit" : "preset",
    json_text(request->preset), "folder", json_text(request->folder), "instrument",
    failed ? json_null() : json_text(request->instrument), "rendered",
    (json_int_t)(batch->count - failed), "kept", (json_int_t)(request->plan.count - batch->count),
    "failed", (json_int_t)failed, "sounds", sounds));
}

static void note_summary(const LibraryRequest *request, const RenderBatch *batch) {
  const size_t kept = request->plan.count - batch->count;
  char before[48] = "";
  if (kept > 0) (void)snprintf(before, sizeof before, ", %zu of them from before", kept);
  note("%s: %zu sounds%s", request->instrument, request->plan.count, before);
}

static Outcome report(const Arguments *arguments, const LibraryRequest *request,
                      const RenderBatch *batch) {
  if (arguments_has(arguments, "json")) return print_report(request, batch);
  if (count_failed(batch) == 0 && !request->render.quiet) note_summary(request, batch);
  return OUTCOME_OK;
}

/* ---- doing it ---- */

/* On a terminal a line of progress stands before it. */
static bool on_terminal;

/* For interrupt_at_end(). */
static void say_stopped(void) {
  static const char line[] = "\ntabor: stopped; the same command renders what is missing\n";
  const size_t from = on_terminal ? 0 : 1;
  (void)!write(STDERR_FILENO, line + from, sizeof line - 1 - from);
}

/* The instrument comes last: where it is, all its sounds are. */
static Outcome make_missing(const Arguments *arguments, LibrarySums *sums) {
  const LibraryRequest *const request = sums->request;
  RenderBatch batch;
  Outcome outcome = library_batch_make(arguments, sums, &batch);
  if (outcome == OUTCOME_OK && batch.count > 0) outcome = library_sums_begin(sums);
  if (outcome == OUTCOME_OK && batch.count > 0 && request->kit)
    outcome = library_kit_build(request);
  if (outcome == OUTCOME_OK) {
    on_terminal = isatty(STDERR_FILENO) != 0;
    if (!request->render.quiet) interrupt_at_end(say_stopped);
    outcome = render_jobs_do(&batch);
    interrupt_at_end(NULL);
    if (outcome == OUTCOME_OK) outcome = library_sums_end(sums);
    if (outcome == OUTCOME_OK) outcome = library_sfz_write(request, request->instrument);
    const Outcome reported = report(arguments, request, &batch);
    if (outcome == OUTCOME_OK) outcome = reported;
  }
  render_batch_free(&batch);
  return outcome;
}

static Outcome make(const Arguments *arguments, const LibraryRequest *request) {
  LibrarySums sums;
  Outcome outcome = library_sums_read(request, &sums);
  if (outcome == OUTCOME_OK) outcome = make_missing(arguments, &sums);
  library_sums_free(&sums);
  return outcome;
}

static Outcome run(const Arguments *arguments) {
  LibraryRequest request;
  int hold = -1;
  Outcome outcome = library_request_read(arguments, &request);
  if (outcome == OUTCOME_OK) outcome = library_manifest_claim(&request, &hold);
  if (outcome == OUTCOME_OK) outcome = make(arguments, &request);
  if (hold >= 0) (void)close(hold);
  library_request_free(&request);
  return outcome;
}

static const char notes[] =
  "Writes FOLDER/PRESET.sfz, which samplers load, and a sound for each of its strokes, as\n"
  "FOLDER/PRESET-normal-r40-v073-t2.wav: a stroke at 40 % of the head's radius, with MIDI\n"
  "velocity 73, the second take. One gain is for all of them, so they are as loud as the drum is.\n"
  "\n"
  "Places have keys of their own: from the centre to 80 % of the radius 36, 38, 41, 43, 45, 47,\n"
  "48 and 50, as in 'tabor play'. One place is the preset's, on 38. Buzzes, of half a second, lie\n"
  "two octaves above: 60, 62, 65 and so on.\n"
  "\n"
  "--kit makes one instrument of a kit, FOLDER/KIT.sfz, on the kit's own notes: a stereo sound of\n"
  "its mix for every kind of stroke on every drum, as FOLDER/KIT-snare-rimshot-v073-t2.wav, with\n"
  "what the other drums answer. --set changes the kit, as drum.snare.batter.pitch=G3.\n"
  "\n"
  "A run that was ended goes on where it was: the same command keeps the sounds that are there.\n"
  "FOLDER/" LIBRARY_MANIFEST " says what they were made from; a folder takes one library only.\n"
  "A sound whose bytes have changed, by FOLDER/" LIBRARY_SUMS ", is rendered again.\n"
  "\n" PRESET_NOTES "'tabor show' lists the keys for --set.\n";

const Command library_command = {
  .name = "library",
  .operand = "[PRESET]",
  .summary = "Play a drum or a kit into a sample library for samplers",
  .notes = notes,
  .options = library_options,
  .run = run,
};
