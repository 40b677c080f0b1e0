/* SPDX-License-Identifier: MIT */
/* Logs of performances (render/replay.h): refused with one line, or a performance that can be
 * played. */
#include <math.h>

#include "fuzz.h"
#include "render/replay.h"

static void check_message(const Replay *replay, size_t i) {
  const PlayerMessage *const message = &replay->messages[i];
  const TaborEvent *const event = &message->event;
  fuzz_require(i == 0 || message->frame >= replay->messages[i - 1].frame, "messages are in order");
  fuzz_require(message->frame < replay->frames, "messages are played");
  fuzz_require(isfinite(message->value) && isfinite(event->velocity) && isfinite(event->radius) &&
                 isfinite(event->angle) && isfinite(event->value),
               "messages are finite");
  if (message->type != PLAYER_MODEL) return;
  fuzz_require(message->model >= 1 && message->model <= replay->model_count, "a model is there");
}

static void check_start(const Replay *replay) {
  const LogStart *const start = &replay->start;
  fuzz_require(start->channels >= 1 && start->channels <= TABOR_MAX_MICS, "channels");
  for (uint32_t i = 0; i < start->channels; i++) {
    fuzz_require(start->mics[i] < replay->drum->def.mic_count, "a microphone is there");
  }
  fuzz_require(start->rate >= 22050 && start->rate <= 192000 && start->gain >= 0, "rate and gain");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char message[1000] = "";
  Replay replay;
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = replay_read(fuzz_file(data, size), &replay);
  message_release(before);
  fuzz_require(outcome == OUTCOME_OK || message[0] != '\0', "a refusal has a reason");
  if (outcome == OUTCOME_OK) {
    check_start(&replay);
    for (size_t i = 0; i < replay.count; i++) check_message(&replay, i);
  }
  replay_free(&replay);
  return 0;
}
