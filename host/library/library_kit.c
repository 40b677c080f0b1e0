/* SPDX-License-Identifier: MIT */
#include "library/library_kit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kit/kit_args.h"
#include "kit/kit_build.h"
#include "kit/kit_midi.h"
#include "library/library_sums.h"
#include "render/render_file.h"
#include "render/render_options.h"
#include "strokes/stroke.h"

#define NOTE_TIME 0.5 /* [s] for which a note is held: that of a stroke's buzz by itself */

/* ---- the plan ---- */

/* The notes that play this stroke. */
static void take_keys(const TaborKitDrumDef *drum, int stroke, LibrarySound *sound) {
  sound->key_count = 0;
  for (int note = 0; note < MIDI_VALUES; note++) {
    if (drum->notes[note] == stroke) sound->keys[sound->key_count++] = (uint8_t)note;
  }
}

static uint32_t count_strokes(const TaborKitDef *def) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < def->drum_count; i++) {
    for (int stroke = 1; stroke < MIDI_STROKE_COUNT; stroke++) {
      count += memchr(def->drum[i].notes, stroke, MIDI_VALUES) != NULL;
    }
  }
  return count;
}

static Outcome check_count(const TaborKitDef *def, const LibraryShape *shape) {
  const uint32_t count = count_strokes(def);
  const uint32_t sounds = count * shape->velocities * shape->takes;
  if (count == 0) return refuse("--kit: no note plays a drum of the kit");
  if (sounds <= LIBRARY_MOST_SOUNDS) return OUTCOME_OK;
  return refuse("--velocities and --takes make %u sounds of %u kinds of stroke; allowed: up to %d",
                (unsigned)sounds, (unsigned)count, LIBRARY_MOST_SOUNDS);
}

/* What the kit's first note for it does at this velocity. */
static void take_stroke(LibrarySound *sound, KitMidi *midi) {
  const MidiMessage note = {0x99, {sound->keys[0], (uint8_t)sound->midi}};
  TaborKitEvent events[KIT_MIDI_MOST_EVENTS];
  kit_midi_rest(midi);
  const uint32_t count = kit_midi_take(midi, &note, events);
  if (count > 0) sound->event = events[count - 1u].event;
  if (count > 1) sound->pedal = events[0].event;
}

static bool name_sound(const LibraryRequest *request, const char *drum, LibrarySound *sound) {
  const uint32_t takes = request->plan.shape.takes;
  const size_t size = strlen(request->stem) + strlen(drum) + 64;
  sound->file = malloc(size);
  if (!sound->file) return false;
  (void)snprintf(sound->file, size, "%s-%s-%s-v%03u-t%0*u.wav", request->stem, drum,
                 sound->technique, (unsigned)sound->midi, takes > 9 ? 2 : 1, (unsigned)sound->take);
  return true;
}

/* All sounds of one kind of stroke on one drum. False without memory. */
static bool add_stroke(uint32_t drum, int stroke, KitMidi *midi, Humanizer *player,
                       LibraryRequest *request) {
  const TaborKitDrumDef *const def = &request->kit->def.drum[drum];
  const LibraryShape *const shape = &request->plan.shape;
  for (uint32_t i = 0; i < shape->velocities * shape->takes; i++) {
    LibrarySound *const sound = &request->plan.sounds[request->plan.count++];
    *sound = (LibrarySound){
      .drum = drum, .technique = midi_stroke_names[stroke], .take = i % shape->takes + 1};
    take_keys(def, stroke, sound);
    library_set_layer(sound, i / shape->takes, shape->velocities);
    take_stroke(sound, midi);
    humanize(player, def->def.shell.radius, &sound->event);
    if (!name_sound(request, def->name, sound)) return false;
  }
  return true;
}

static bool add_strokes(KitMidi *midi, LibraryRequest *request) {
  const TaborKitDef *const def = &request->kit->def;
  Humanizer player = request->plan.shape.humanizer;
  bool complete = true;
  for (uint32_t i = 0; i < def->drum_count; i++) {
    for (int stroke = 1; stroke < MIDI_STROKE_COUNT && complete; stroke++) {
      if (!memchr(def->drum[i].notes, stroke, MIDI_VALUES)) continue;
      complete = add_stroke(i, stroke, midi, &player, request);
    }
  }
  return complete;
}

static Outcome plan(const LibraryShape *shape, LibraryRequest *request) {
  const TaborKitDef *const def = &request->kit->def;
  const size_t most = (size_t)count_strokes(def) * shape->velocities * shape->takes;
  KitMidiSetup setup = kit_midi_setup_default;
  KitMidi *const midi = malloc(sizeof *midi);
  request->plan =
    (LibraryPlan){.shape = *shape, .sounds = calloc(most, sizeof *request->plan.sounds)};
  setup.response = shape->response;
  if (midi) kit_midi_begin(midi, def, &setup);
  const bool complete = midi && request->plan.sounds && add_strokes(midi, request);
  free(midi);
  return complete ? OUTCOME_OK : fail_memory();
}

/* ---- the request ---- */

static Outcome check_options(const Arguments *arguments) {
  static const char *const excluded[] = {"positions", "techniques", "mic"};
  return kit_refuse_options(arguments, excluded, sizeof excluded / sizeof *excluded,
                            "not together; a kit has notes for its strokes, and a mix");
}

/* Sound files for notes are the user's already. */
static void note_samples(const Arguments *arguments, const TaborKitDef *def) {
  if (arguments_has(arguments, "quiet")) return;
  for (int i = 0; i < TABOR_KIT_NOTES; i++) {
    if (!def->note[i].sample[0]) continue;
    note("note %d: its sound file '%s' is not put into the library", i, def->note[i].sample);
  }
}

static Outcome load(const Arguments *arguments, TaborKitDef *def) {
  const Outcome outcome = kit_load(arguments, def);
  if (outcome == OUTCOME_OK) note_samples(arguments, def);
  memset(def->note, 0, sizeof def->note);
  return outcome;
}

Outcome library_kit_read(const Arguments *arguments, const LibraryShape *shape,
                         LibraryRequest *request) {
  Outcome outcome = check_options(arguments);
  if (outcome != OUTCOME_OK) return outcome;
  request->kit = calloc(1, sizeof *request->kit);
  if (!request->kit) return fail_memory();
  outcome = load(arguments, &request->kit->def);
  if (outcome == OUTCOME_OK) outcome = check_count(&request->kit->def, shape);
  return outcome == OUTCOME_OK ? plan(shape, request) : outcome;
}

Outcome library_kit_read_rendering(const Arguments *arguments, LibraryRequest *request) {
  return render_kit_format_read(arguments, &request->kit->def, &request->render);
}

void library_kit_free(LibraryKit *kit) {
  if (kit) kit_models_release(kit->models);
  free(kit);
}

/* ---- rendering ---- */

Outcome library_kit_build(const LibraryRequest *request) {
  LibraryKit *const kit = request->kit;
  return kit_models_build(&kit->def, &request->render.model, request->threads, kit->models);
}

void library_kit_prepare(const LibraryRequest *request, const LibrarySound *sound, RenderJob *job) {
  job->sound = sound;
  job->rate = request->render.model.sample_rate;
  job->length = request->render.frames / job->rate;
}

/* The pedal, the note, and its end, which matters to what is held. */
static Outcome make_song(const LibrarySound *sound, double rate, KitSong *song) {
  song->events = calloc(3, sizeof *song->events);
  if (!song->events) return fail_memory();
  if (sound->pedal.type != 0) {
    song->events[song->count++] = (TaborKitEvent){sound->drum, sound->pedal};
  }
  song->events[song->count++] = (TaborKitEvent){sound->drum, sound->event};
  if (sound->event.technique != TABOR_TECHNIQUE_BUZZ &&
      sound->event.technique != TABOR_TECHNIQUE_SWEEP) {
    return OUTCOME_OK;
  }
  song->last_frame = (uint32_t)lround(NOTE_TIME * rate);
  const TaborEvent release = {
    .type = TABOR_EVENT_RELEASE, .id = sound->event.id, .frame = song->last_frame};
  song->events[song->count++] = (TaborKitEvent){sound->drum, release};
  return OUTCOME_OK;
}

static Outcome fill(const LibraryRequest *request, RenderJob *job) {
  RenderRequest *const render = &job->request;
  render_request_clear(render);
  *render = request->render;
  render->json = false;
  render->quiet = !render->verbose;
  render->kit_models = request->kit->models;
  render->threads = 1;
  render->output_count = 1;
  const Outcome outcome = make_song(job->sound, job->rate, &render->kit_song);
  return outcome == OUTCOME_OK ? output_plan(&render->outputs[0], job->output, false) : outcome;
}

Outcome library_kit_render(void *sums, RenderJob *job) {
  const Outcome outcome = fill(((const LibrarySums *)sums)->request, job);
  if (outcome != OUTCOME_OK) return outcome;
  return render_file(&job->request, render_job_played, job, &job->report);
}
