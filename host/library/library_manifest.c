/* SPDX-License-Identifier: MIT */
#include "library/library_manifest.h"

#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/folder.h"
#include "base/json_output.h"
#include "base/text_file.h"
#include "drums/drum_args.h"
#include "library/library_kit.h"
#include "library/library_sums.h"
#include "midi/midi_map.h"
#include "platform/files.h"

#define VALUE_FLAGS (JSON_ENCODE_ANY | JSON_REAL_PRECISION(15))
#define TEMPORARY_PREFIX ".tabor-"
#define TEMPORARY_LENGTH 13 /* ".tabor-XXXXXX" */

/* ---- what a library is made from ---- */

/* Every parameter but name, comment and licence, after @p prefix: text that reads back to the same
 * bits. */
static json_t *with_parameters(json_t *object, const char *prefix, const TaborDrumDef *def) {
  char key[2 * TABOR_NAME_SIZE], full[4 * TABOR_NAME_SIZE], value[TABOR_TEXT_SIZE];
  TaborError error;
  for (uint32_t i = 0; tabor_drum_def_key(def, i, key, sizeof key); i++) {
    if (strncmp(key, "drum.", strlen("drum.")) == 0) continue;
    if (tabor_drum_def_get(def, key, value, sizeof value, &error) != TABOR_OK) continue;
    (void)snprintf(full, sizeof full, "%s%s", prefix, key);
    object = json_with_field(object, full, json_text(value));
  }
  return object;
}

typedef struct NamedNumber {
  const char *key;
  double value;
} NamedNumber;

static json_t *with_numbers(json_t *object, const char *prefix, const NamedNumber *numbers,
                            size_t count) {
  char key[4 * TABOR_NAME_SIZE];
  for (size_t i = 0; i < count; i++) {
    (void)snprintf(key, sizeof key, "%s%s", prefix, numbers[i].key);
    object = json_with_field(object, key, json_number(numbers[i].value));
  }
  return object;
}

static json_t *with_notes(json_t *object, const TaborKitDrumDef *drum) {
  char key[2 * TABOR_NAME_SIZE];
  for (int note = 0; note < MIDI_VALUES; note++) {
    if (drum->notes[note] == TABOR_KIT_STROKE_NONE) continue;
    (void)snprintf(key, sizeof key, "%s.note.%d", drum->name, note);
    object = json_with_field(object, key, json_text(midi_stroke_names[drum->notes[note]]));
  }
  return object;
}

/* Its close microphone is a part of the mix; what the drum itself is follows. */
static json_t *with_kit_drum(json_t *object, const TaborKitDrumDef *drum) {
  const NamedNumber place[] = {
    {"x", drum->x},       {"y", drum->y},           {"height", drum->height},
    {"tilt", drum->tilt}, {"facing", drum->facing}, {"gain", drum->gain},
    {"pan", drum->pan},   {"wake", drum->wake},     {"choke", drum->choke}};
  char prefix[TABOR_NAME_SIZE + 1], mic[2 * TABOR_NAME_SIZE];
  (void)snprintf(prefix, sizeof prefix, "%s.", drum->name);
  (void)snprintf(mic, sizeof mic, "%s.mic", drum->name);
  object = with_numbers(object, prefix, place, sizeof place / sizeof *place);
  object = json_with_field(object, mic, json_text(drum->mic));
  return with_parameters(with_notes(object, drum), prefix, &drum->def);
}

static json_t *kit_json(const TaborKitDef *def) {
  const TaborRoomDef *const room = &def->room;
  const NamedNumber numbers[] = {{"kit.coupled", def->coupled},
                                 {"kit.coupling", def->coupling},
                                 {"kit.overheads", def->overheads},
                                 {"kit.full_scale", def->full_scale},
                                 {"kit.overhead_spacing", def->overhead_spacing},
                                 {"kit.overhead_x", def->overhead_x},
                                 {"kit.overhead_y", def->overhead_y},
                                 {"kit.overhead_height", def->overhead_height},
                                 {"room.kind", room->kind},
                                 {"room.size", room->size},
                                 {"room.decay", room->decay},
                                 {"room.tilt", room->tilt},
                                 {"room.level", room->level}};
  json_t *kit = with_numbers(json_object(), "", numbers, sizeof numbers / sizeof *numbers);
  for (uint32_t i = 0; i < def->drum_count; i++) kit = with_kit_drum(kit, &def->drum[i]);
  return kit;
}

static json_t *drum_json(const LibraryRequest *request) {
  if (request->kit) return kit_json(&request->kit->def);
  return with_parameters(json_object(), "", &request->render.def);
}

static json_t *mics_json(const RenderRequest *render) {
  json_t *mics = json_array();
  for (uint32_t i = 0; i < render->channels; i++) {
    mics = json_with_item(mics, json_text(render->def.mic[render->mics[i]].name));
  }
  return mics;
}

static json_t *techniques_json(const LibraryShape *shape) {
  json_t *techniques = json_array();
  for (size_t i = 0; i < LIBRARY_TECHNIQUES; i++) {
    if (!shape->techniques[i]) continue;
    techniques = json_with_item(techniques, json_text(library_techniques[i].name));
  }
  return techniques;
}

static json_t *manifest_json(const LibraryRequest *request) {
  static const char *const formats[] = {"pcm16", "pcm24", "float"};
  const LibraryShape *const shape = &request->plan.shape;
  const RenderRequest *const render = &request->render;
  return json_pack(
    "{s:s, s:o, s:i, s:i, s:i, s:o, s:s, s:s, s:o, s:I, s:I, s:s, s:s, s:o, s:o, s:I, s:o}",
    "tabor", tabor_version(), "preset", json_text(request->stem), "velocities",
    (int)shape->velocities, "positions", (int)shape->positions, "takes", (int)shape->takes,
    "techniques", techniques_json(shape), "velocity-curve", midi_curve_names[shape->response.curve],
    "velocity-range", midi_range_names[shape->response.range], "humanize",
    json_number(shape->humanizer.amount), "seed", (json_int_t)request->seed, "rate",
    (json_int_t)render->audio.rate, "quality", quality_name(render->model.quality), "format",
    formats[render->audio.encoding], "mic", mics_json(render), "gain", json_number(render->gain_db),
    "frames", (json_int_t)render->frames, "drum", drum_json(request));
}

/* ---- the same, or another ---- */

static char *value_text(const json_t *value) {
  return value ? json_dumps(value, VALUE_FLAGS) : strdup("nothing");
}

/* Refuses the first entry of @p wanted, but for the drum, that differs in @p found. */
static Outcome compare(const char *folder, json_t *found, json_t *wanted) {
  const char *key;
  json_t *value;
  Outcome outcome = OUTCOME_OK;
  json_object_foreach(wanted, key, value) {
    if (outcome != OUTCOME_OK || json_is_object(value)) continue;
    char *const mine = value_text(value), *const other = value_text(json_object_get(found, key));
    if (!mine || !other) {
      outcome = fail_memory();
    } else if (strcmp(mine, other) != 0) {
      outcome = refuse("'%s' holds another library, with %s %s, not %s", folder, key, other, mine);
    }
    free(mine);
    free(other);
  }
  return outcome;
}

/* Entries that only one of them has count, too, as a second head's. */
static Outcome compare_drums(const char *folder, json_t *found, json_t *wanted) {
  Outcome outcome = compare(folder, found, wanted);
  if (outcome != OUTCOME_OK || json_object_size(found) == json_object_size(wanted)) return outcome;
  return refuse("'%s' holds another library, of a drum with other parts", folder);
}

static Outcome compare_manifest(const char *folder, const char *path, json_t *wanted) {
  json_error_t error;
  FILE *const stream = file_stream_to_read(path);
  if (!stream) return refuse("'%s' is no library's: %s", path, strerror(errno));
  json_t *const found = json_loadf(stream, JSON_REJECT_DUPLICATES, &error);
  (void)fclose(stream);
  if (!found) return refuse("'%s' is no library's: %s", path, error.text);
  Outcome outcome = json_is_string(json_object_get(found, "tabor"))
                      ? compare(folder, found, wanted)
                      : refuse("'%s' is no library's: it names no version of tabor", path);
  if (outcome == OUTCOME_OK) {
    outcome =
      compare_drums(folder, json_object_get(found, "drum"), json_object_get(wanted, "drum"));
  }
  json_decref(found);
  return outcome;
}

/* ---- taking the folder ---- */

/* Files that somebody else has put there are neither finished sounds nor ours to replace. */
static Outcome check_absent(const LibraryRequest *request, const char *path) {
  if (!file_exists(path)) return OUTCOME_OK;
  return refuse("'%s' exists, but '%s' holds no library", path, request->folder);
}

static Outcome check_foreign(const LibraryRequest *request) {
  char *const sums = folder_path(request->folder, LIBRARY_SUMS);
  Outcome outcome = sums ? check_absent(request, sums) : fail_memory();
  free(sums);
  if (outcome == OUTCOME_OK) outcome = check_absent(request, request->instrument);
  for (size_t i = 0; i < request->plan.count && outcome == OUTCOME_OK; i++) {
    char *const path = folder_path(request->folder, request->plan.sounds[i].file);
    if (!path) return fail_memory();
    outcome = check_absent(request, path);
    free(path);
  }
  return outcome;
}

static Outcome write_manifest(const LibraryRequest *request, const char *path, json_t *wanted) {
  Outcome outcome = check_foreign(request);
  if (outcome == OUTCOME_OK) outcome = folder_create(request->folder);
  if (outcome != OUTCOME_OK) return outcome;
  char *const text = json_write(wanted);
  outcome = text ? text_file_write(path, text, true) : fail_memory();
  free(text);
  return outcome;
}

static Outcome lock(const char *folder, const char *path, int *hold) {
  *hold = file_open_to_read(path);
  if (*hold < 0) return fail("cannot read '%s': %s", path, strerror(errno));
  if (file_lock(*hold)) return OUTCOME_OK;
  return fail("another run is at work in '%s'", folder);
}

static bool is_temporary(const char *name) {
  return strncmp(name, TEMPORARY_PREFIX, strlen(TEMPORARY_PREFIX)) == 0 &&
         strlen(name) == TEMPORARY_LENGTH;
}

static void remove_temporary(void *folder, const char *name) {
  char path[4096];
  const int length = snprintf(path, sizeof path, "%s/%s", (const char *)folder, name);
  if (is_temporary(name) && length > 0 && (size_t)length < sizeof path) (void)file_remove(path);
}

static Outcome claim(const LibraryRequest *request, const char *path, json_t *wanted, int *hold) {
  const bool is_there = file_exists(path);
  Outcome outcome = is_there ? compare_manifest(request->folder, path, wanted)
                             : write_manifest(request, path, wanted);
  if (outcome == OUTCOME_OK) outcome = lock(request->folder, path, hold);
  /* of runs that were killed; before there was a manifest, none of the folder's files were a
   * library's */
  if (outcome == OUTCOME_OK && is_there)
    folder_visit(request->folder, remove_temporary, (void *)request->folder);
  return outcome;
}

Outcome library_manifest_claim(const LibraryRequest *request, int *hold) {
  *hold = -1;
  json_t *const wanted = manifest_json(request);
  char *const path = folder_path(request->folder, LIBRARY_MANIFEST);
  const Outcome outcome = wanted && path ? claim(request, path, wanted, hold) : fail_memory();
  free(path);
  json_decref(wanted);
  return outcome;
}
