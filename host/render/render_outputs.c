/* SPDX-License-Identifier: MIT */
#include "render/render_outputs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "drums/drum_args.h"

/* ---- one sound file ---- */

static Outcome refuse_extension(const char *name) {
  return refuse("-o '%s': the name must end in .wav, .flac or .au, with something before it", name);
}

/* The extension decides; what is no regular file, as /dev/full, may do without and gets AU. */
static Outcome choose_container(const OutputFile *output, AudioContainer *container) {
  if (audio_container(output->name, container)) return OUTCOME_OK;
  *container = AUDIO_AU;
  return output->kind == OUTPUT_REPLACED ? refuse_extension(output->name) : OUTCOME_OK;
}

static Outcome plan_single(const Arguments *arguments, const char *name, RenderRequest *request) {
  OutputFile *const output = &request->outputs[0];
  request->output_count = 1;
  Outcome outcome = output_plan(output, name, arguments_has(arguments, "no-overwrite"));
  if (outcome == OUTCOME_OK) outcome = choose_container(output, &request->audio.container);
  if (outcome != OUTCOME_OK) return outcome;
  if (strcmp(output->name, "-") != 0) return OUTCOME_OK;
  if (request->json) return refuse("--json and -o -: both would go to standard output");
  if (isatty(STDOUT_FILENO)) {
    return refuse("-o -: standard output is a terminal; send it to a pipe or a file");
  }
  return OUTCOME_OK;
}

/* ---- a sound file for each microphone, or each drum of a kit ---- */

static const char *part_name(const RenderRequest *request, uint32_t index) {
  if (request->kit) return request->kit->drum[index].name;
  return request->def.mic[request->mics[index]].name;
}

/* "FOLDER/take-top.wav" for "FOLDER/take.wav", which has an extension, and "top". */
static char *split_name(const char *name, const char *mic) {
  const char *const extension = strrchr(name, '.');
  const size_t size = strlen(name) + strlen(mic) + 2;
  char *const text = malloc(size);
  if (text) (void)snprintf(text, size, "%.*s-%s%s", (int)(extension - name), name, mic, extension);
  return text;
}

/* The new file must be none of those before it, which a link may lead to. */
static Outcome check_split(const RenderRequest *request, uint32_t index) {
  const OutputFile *const output = &request->outputs[index];
  for (uint32_t i = 0; i < index; i++) {
    if (output_same(&request->outputs[i], output)) {
      return refuse("--split: '%s' and '%s' are the same file", request->outputs[i].name,
                    output->name);
    }
  }
  return OUTCOME_OK;
}

static Outcome plan_split(const Arguments *arguments, const char *name, RenderRequest *request) {
  if (strcmp(name, "-") == 0 || strcmp(name, "/dev/stdout") == 0) {
    return refuse("--split and -o -: standard output takes one sound only");
  }
  if (!audio_container(name, &request->audio.container)) return refuse_extension(name);
  Outcome outcome = OUTCOME_OK;
  const uint32_t count = request->kit ? request->kit->drum_count : request->channels;
  for (uint32_t i = 0; i < count && outcome == OUTCOME_OK; i++) {
    request->names[i] = split_name(name, part_name(request, i));
    if (!request->names[i]) return fail_memory();
    request->output_count = i + 1;
    outcome = output_plan(&request->outputs[i], request->names[i],
                          arguments_has(arguments, "no-overwrite"));
    if (outcome == OUTCOME_OK) outcome = check_split(request, i);
  }
  return outcome;
}

static Outcome plan_sounds(const Arguments *arguments, RenderRequest *request) {
  const char *const given = arguments_value(arguments, "output");
  if (given && !*given) return refuse("-o needs the name of a file");
  const char *const usual = request->kit ? DEFAULT_KIT_OUTPUT : DEFAULT_OUTPUT;
  const char *const name = given ? given : usual;
  const Outcome outcome =
    request->split ? plan_split(arguments, name, request) : plan_single(arguments, name, request);
  return outcome == OUTCOME_OK ? audio_format_check(&request->audio) : outcome;
}

/* ---- the trace, and what is read ---- */

static Outcome plan_trace(const Arguments *arguments, RenderRequest *request) {
  const char *const name = arguments_value(arguments, "trace");
  if (!name) return OUTCOME_OK;
  if (!*name || strcmp(name, "-") == 0) {
    return refuse("--trace '%s': allowed: the name of a file, as trace.csv", name);
  }
  request->has_trace = true;
  const Outcome outcome =
    output_plan(&request->trace, name, arguments_has(arguments, "no-overwrite"));
  for (uint32_t i = 0; i < request->output_count && outcome == OUTCOME_OK; i++) {
    if (output_same(&request->outputs[i], &request->trace)) {
      return refuse("-o and --trace: both name the file '%s'", name);
    }
  }
  return outcome;
}

/* No output may replace the file @p name, which is @p what. */
static Outcome protect(const RenderRequest *request, const char *name, const char *what) {
  bool replaced = request->has_trace && output_overwrites(&request->trace, name);
  for (uint32_t i = 0; i < request->output_count; i++) {
    replaced = replaced || output_overwrites(&request->outputs[i], name);
  }
  return replaced ? refuse("the output would overwrite the %s '%s'", what, name) : OUTCOME_OK;
}

Outcome render_outputs_protect(const Arguments *arguments, const RenderRequest *request) {
  static const struct {
    const char *option, *what;
  } files[] = {{"midi-file", "MIDI file"},
               {"midi-map", "MIDI map"},
               {"replay", "log"},
               {"input", "sound"},
               {"kit", "kit"}};
  char room[USER_PRESET_PATH];
  const char *events;
  size_t position = 0;
  Outcome outcome = OUTCOME_OK;
  const char *const file = request->kit ? NULL : preset_file(preset_argument(arguments), room);
  if (file) outcome = protect(request, file, "preset");
  while (outcome == OUTCOME_OK && (events = arguments_next(arguments, "events", &position))) {
    outcome = protect(request, events, "events");
  }
  for (size_t i = 0; i < sizeof files / sizeof files[0] && outcome == OUTCOME_OK; i++) {
    const char *const name = arguments_value(arguments, files[i].option);
    if (name) outcome = protect(request, name, files[i].what);
  }
  for (int i = 0; request->kit && i < TABOR_KIT_NOTES && outcome == OUTCOME_OK; i++) {
    const char *const path = request->kit->note[i].sample;
    if (*path) outcome = protect(request, path, "sample");
  }
  return outcome;
}

Outcome render_outputs_plan(const Arguments *arguments, RenderRequest *request) {
  Outcome outcome = plan_sounds(arguments, request);
  if (outcome == OUTCOME_OK) outcome = plan_trace(arguments, request);
  if (outcome == OUTCOME_OK) outcome = render_outputs_protect(arguments, request);
  return outcome;
}
