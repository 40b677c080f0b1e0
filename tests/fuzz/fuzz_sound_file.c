/* SPDX-License-Identifier: MIT */
/* Sound files of `tabor analyze`: refused or too short, or partials with finite numbers. */
#include <math.h>

#include "files/audio_clip.h"
#include "fuzz.h"
#include "inspect/partials.h"

static void analyse(const AudioClip *clip) {
  static Partials partials;
  const size_t onset = find_onset(clip->samples, clip->count);
  const PartialSearch search = {.rate = clip->rate, .most = 10, .least_level = -120.0};
  fuzz_require(onset <= clip->count, "an onset lies in the sound");
  if (clip->count - onset < partials_least_samples(clip->rate)) return;
  partials.count = 0;
  if (partials_find(&search, clip->samples + onset, clip->count - onset, &partials) != OUTCOME_OK)
    return;
  fuzz_require(partials.count <= search.most, "no more partials than wanted");
  for (size_t i = 0; i < partials.count; i++) {
    fuzz_require(isfinite(partials.list[i].frequency) && partials.list[i].frequency >= 0.0 &&
                   isfinite(partials.list[i].level) && isfinite(partials.list[i].decay_rate),
                 "partials are finite");
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const AudioClipPart part = {1, 0.0, INFINITY};
  AudioClip clip = {.samples = NULL};
  char message[1000] = "";
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = audio_clip_read(fuzz_file(data, size), &part, &clip);
  if (outcome == OUTCOME_OK) analyse(&clip);
  message_release(before);
  fuzz_require(outcome == OUTCOME_OK || message[0] != '\0', "a refusal has a reason");
  audio_clip_free(&clip);
  return 0;
}
