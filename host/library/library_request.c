/* SPDX-License-Identifier: MIT */
#include "library/library_request.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/folder.h"
#include "base/suggest.h"
#include "drums/drum_args.h"
#include "kit/kit_args.h"
#include "library/library_kit.h"
#include "midi/midi_options.h"
#include "render/render_batch.h"
#include "render/render_options.h"
#include "strokes/humanize_options.h"

#define MOST_SAMPLER_CHANNELS 2

const Option library_options[] = {
  {"output", 'o', "FOLDER", "where the library goes; created if need be"},
  OPTION_KIT,
  {"velocities", 0, "N", "velocity layers, 1 to 127 (default 8)"},
  {"positions", 0, "N", "places from the centre outwards, 1 to 8 (default 3); see below"},
  {"takes", 0, "N", "round robins, 1 to 32: strokes that differ by --humanize (default 4)"},
  {"techniques", 0, "LIST",
   "of normal, rimshot, cross-stick, rim and buzz, as normal,buzz (default normal)"},
  OPTION_HUMANIZE(HUMANIZE_LIVE_TEXT ", of one take 0"),
  OPTION_SEED,
  OPTION_VELOCITY_CURVE,
  OPTION_VELOCITY_RANGE,
  OPTION_FORMAT,
  OPTION_RATE,
  OPTION_QUALITY,
  OPTION_DURATION,
  OPTION_SET,
  OPTION_MIC,
  OPTION_GAIN,
  OPTION_JOBS,
  {"verbose", 'v', NULL, "print a line or more for every sound"},
  {0},
};

/* ---- the shape ---- */

static Outcome read_count(const Arguments *arguments, const char *name, uint32_t most,
                          uint32_t *count) {
  const NumberField field = {name, 1, most, true};
  double number = *count;
  const Outcome outcome = arguments_number(arguments, &field, &number);
  *count = (uint32_t)number;
  return outcome;
}

static Outcome read_counts(const Arguments *arguments, LibraryShape *shape) {
  *shape =
    (LibraryShape){.velocities = 8, .positions = 3, .takes = 4, .response = midi_response_default};
  Outcome outcome = read_count(arguments, "--velocities", 127, &shape->velocities);
  if (outcome == OUTCOME_OK) {
    outcome = read_count(arguments, "--positions", LIBRARY_MOST_POSITIONS, &shape->positions);
  }
  if (outcome == OUTCOME_OK) {
    outcome = read_count(arguments, "--takes", LIBRARY_MOST_TAKES, &shape->takes);
  }
  return outcome;
}

static Outcome check_count(const LibraryShape *shape) {
  const uint32_t sounds = library_count(shape);
  if (sounds <= LIBRARY_MOST_SOUNDS) return OUTCOME_OK;
  return refuse("--velocities, --positions and --takes make %u sounds; allowed: up to %d",
                (unsigned)sounds, LIBRARY_MOST_SOUNDS);
}

static Outcome read_scatter(const Arguments *arguments, LibraryRequest *request,
                            LibraryShape *shape) {
  const double fallback = shape->takes > 1 ? HUMANIZE_LIVE : 0;
  const Outcome outcome = humanize_read(arguments, fallback, &shape->humanizer);
  request->seed = (uint32_t)shape->humanizer.state;
  if (outcome != OUTCOME_OK || shape->takes == 1 || shape->humanizer.amount > 0) return outcome;
  return refuse("--takes %u: takes are all the same with --humanize 0; allowed: 1, or a --humanize "
                "above 0",
                (unsigned)shape->takes);
}

static bool has_technique(const TaborDrumDef *def, size_t index) {
  const uint32_t striker = stroke_default(def, "").event.striker;
  return striker_can(&def->striker[striker], library_techniques[index].technique);
}

/* A name of those that the drum's own striker can play. */
static const char *technique_at(const void *def, size_t index) {
  for (size_t i = 0; i < LIBRARY_TECHNIQUES; i++) {
    if (has_technique(def, i) && index-- == 0) return library_techniques[i].name;
  }
  return NULL;
}

/* One word of the list, "rimshot" of "normal,rimshot". */
static Outcome add_technique(const TaborDrumDef *def, const char *word, LibraryShape *shape) {
  for (size_t i = 0; i < LIBRARY_TECHNIQUES; i++) {
    if (!has_technique(def, i) || strcmp(word, library_techniques[i].name) != 0) continue;
    if (shape->techniques[i]) return refuse("--techniques: '%s' given twice", word);
    shape->techniques[i] = true;
    return OUTCOME_OK;
  }
  char hint[160];
  suggest_choice(hint, sizeof hint, word, "", technique_at, def);
  return refuse("--techniques '%s': not for libraries of this drum%s", word, hint);
}

static Outcome read_techniques(const Arguments *arguments, const TaborDrumDef *def,
                               LibraryShape *shape) {
  const char *text = arguments_value(arguments, "techniques");
  Outcome outcome = OUTCOME_OK;
  if (!text) text = library_techniques[0].name;
  while (text && outcome == OUTCOME_OK) {
    char word[40];
    const size_t length = strcspn(text, ",");
    (void)snprintf(word, sizeof word, "%.*s", (int)length, text);
    outcome = add_technique(def, word, shape);
    text = text[length] ? text + length + 1 : NULL;
  }
  return outcome;
}

/* ---- the folder, and how sounds are rendered ---- */

static char *instrument_path(const LibraryRequest *request) {
  const size_t size = strlen(request->folder) + strlen(request->stem) + sizeof ".sfz";
  char *const path = malloc(size);
  if (path) (void)snprintf(path, size, "%s%s.sfz", request->folder, request->stem);
  return path;
}

static Outcome read_folder(const Arguments *arguments, LibraryRequest *request) {
  const char *const path = arguments_value(arguments, "output");
  if (!path || !*path) return refuse("a library needs a folder: -o FOLDER");
  const Outcome outcome = folder_check(path);
  if (outcome != OUTCOME_OK) return outcome;
  request->folder = folder_name(path);
  request->instrument = request->folder ? instrument_path(request) : NULL;
  return request->instrument ? OUTCOME_OK : fail_memory();
}

/* As every sound of a drum will be. None of their names is taken: what is finished may be
 * write-protected. */
static Outcome read_drum_rendering(const Arguments *arguments, LibraryRequest *request) {
  Arguments first;
  char *const path = folder_path(request->folder, ".tabor-sound.wav");
  Outcome outcome = arguments_copy(arguments, arguments->operand, &first);
  if (outcome == OUTCOME_OK && !path) outcome = fail_memory();
  if (outcome == OUTCOME_OK) {
    arguments_replace(&first, "output", path);
    outcome = render_request_read(&first, &request->render);
  }
  arguments_free(&first);
  free(path);
  if (outcome != OUTCOME_OK || request->render.channels <= MOST_SAMPLER_CHANNELS) return outcome;
  return refuse("--mic: %u given; allowed: up to %d, as samplers play mono and stereo sounds",
                (unsigned)request->render.channels, MOST_SAMPLER_CHANNELS);
}

static Outcome plan_drum(const Arguments *arguments, LibraryShape *shape, LibraryRequest *request) {
  TaborDrumDef def;
  Outcome outcome = drum_load(arguments, &def);
  if (outcome == OUTCOME_OK) outcome = read_techniques(arguments, &def, shape);
  if (outcome == OUTCOME_OK) outcome = check_count(shape);
  if (outcome != OUTCOME_OK) return outcome;
  return library_plan_make(&def, request->preset, shape, &request->plan);
}

static Outcome read_sounds(const Arguments *arguments, LibraryRequest *request) {
  LibraryShape shape;
  Outcome outcome = read_counts(arguments, &shape);
  if (outcome == OUTCOME_OK) outcome = read_scatter(arguments, request, &shape);
  if (outcome == OUTCOME_OK) outcome = midi_response_read(arguments, &shape.response);
  if (outcome != OUTCOME_OK) return outcome;
  if (arguments_has(arguments, "kit")) return library_kit_read(arguments, &shape, request);
  return plan_drum(arguments, &shape, request);
}

static Outcome read_rendering(const Arguments *arguments, LibraryRequest *request) {
  if (request->kit) return library_kit_read_rendering(arguments, request);
  return read_drum_rendering(arguments, request);
}

Outcome library_request_read(const Arguments *arguments, LibraryRequest *request) {
  const char *const kit = arguments_value(arguments, "kit");
  *request = (LibraryRequest){.preset = kit ? kit : preset_argument(arguments)};
  render_request_clear(&request->render);
  request->stem = library_stem(request->preset);
  Outcome outcome = request->stem ? OUTCOME_OK : fail_memory();
  if (outcome == OUTCOME_OK) outcome = render_threads_read(arguments, &request->threads);
  if (outcome == OUTCOME_OK) outcome = read_sounds(arguments, request);
  if (outcome == OUTCOME_OK) outcome = read_folder(arguments, request);
  if (outcome == OUTCOME_OK) outcome = read_rendering(arguments, request);
  return outcome;
}

void library_request_free(LibraryRequest *request) {
  render_request_free(&request->render);
  library_kit_free(request->kit);
  library_plan_free(&request->plan);
  free(request->instrument);
  free(request->folder);
  free(request->stem);
  *request = (LibraryRequest){0};
}
