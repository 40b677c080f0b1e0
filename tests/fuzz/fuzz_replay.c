/* SPDX-License-Identifier: MIT */
/* Logs of performances are played (render/offline_player.h): with drums made small, the first
 * moments of any log that is accepted give finite sound. */
#include <math.h>
#include <stdio.h>

#include "base/command.h"
#include "fuzz.h"
#include "render/offline_player.h"
#include "render/render_options.h"

enum { MOST_FRAMES = 2048, MOST_MODELS = 3 };

/* So that a model is built at once; the physics of large ones is not meant here. */
static void make_small(TaborDrumDef *def, uint32_t *quality) {
  *quality = TABOR_QUALITY_DRAFT;
  def->quality.two_way_bandwidth = 300;
  def->quality.bandwidth = 600;
  def->quality.wire_points = 4;
  if (def->wires.count > 2) def->wires.count = 2;
}

static void make_request_small(RenderRequest *request) {
  Replay *const replay = &request->replay;
  make_small(&request->def, &request->model.quality);
  for (size_t i = 0; i < replay->model_count; i++) {
    make_small(&replay->models[i]->def, &replay->models[i]->quality);
  }
  if (request->frames > MOST_FRAMES) request->frames = MOST_FRAMES;
}

/* Messages may come late in a log: they are moved into what is played, in their order. */
static void gather_messages(Replay *replay) {
  const uint64_t last = replay->count > 0 ? replay->messages[replay->count - 1].frame : 0;
  const uint64_t divisor = last / MOST_FRAMES + 1;
  for (size_t i = 0; i < replay->count; i++) replay->messages[i].frame /= divisor;
}

static void check_sound(const OfflinePlayer *player, uint32_t samples) {
  for (uint32_t i = 0; i < samples; i++) {
    fuzz_require(isfinite(player->interleaved[i]), "the sound is finite");
  }
}

static Outcome play(RenderRequest *request, OfflinePlayer *player) {
  Outcome outcome = offline_player_open(player, request);
  for (uint32_t at = 0; at < request->frames && outcome == OUTCOME_OK; at += OFFLINE_BLOCK) {
    const uint32_t left = request->frames - at;
    const uint32_t frames = left < OFFLINE_BLOCK ? left : OFFLINE_BLOCK;
    outcome = offline_player_play(player, frames);
    if (outcome == OUTCOME_OK) check_sound(player, frames * request->channels);
  }
  offline_player_free(player);
  return outcome;
}

static Outcome replay(const char *path) {
  static RenderRequest request;
  static OfflinePlayer player;
  Arguments arguments;
  char option[80];
  (void)snprintf(option, sizeof option, "--replay=%s", path);
  char *const words[] = {(char[]){"render"}, (char[]){"--output=/dev/null"}, option, NULL};
  fuzz_require(arguments_read(&render_command, 3, words, &arguments) == OUTCOME_OK, "arguments");
  Outcome outcome = render_request_read(&arguments, &request);
  if (outcome == OUTCOME_OK && request.replay.model_count <= MOST_MODELS) {
    make_request_small(&request);
    gather_messages(&request.replay);
    outcome = play(&request, &player);
  }
  render_request_free(&request);
  arguments_free(&arguments);
  return outcome;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char message[1000] = "";
  const char *const path = fuzz_file(data, size);
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = replay(path);
  message_release(before);
  fuzz_require(outcome == OUTCOME_OK || message[0] != '\0', "a refusal has a reason");
  return 0;
}
