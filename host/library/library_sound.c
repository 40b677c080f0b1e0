/* SPDX-License-Identifier: MIT */
#include "library/library_sound.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#define RIFF_HEADER 8u /* "RIFF" and the length of what follows */

/* libsndfile reads a WAV that has been cut off as a shorter one: only its own length tells. An RF64, beyond 4 GiB,
   says it elsewhere. */
static bool is_cut_off(const char *path, off_t length) {
  unsigned char header[RIFF_HEADER];
  FILE *const stream = fopen(path, "rb");
  const bool complete = stream && fread(header, sizeof header, 1, stream) == 1;
  if (stream) (void)fclose(stream);
  if (!complete) return true;
  const uint64_t rest =
    header[4] | (uint64_t)header[5] << 8 | (uint64_t)header[6] << 16 | (uint64_t)header[7] << 24;
  return memcmp(header, "RIFF", 4) == 0 && (uint64_t)length < RIFF_HEADER + rest;
}

/* Without --duration sounds are as long as they ring, which nobody knows before. */
static bool is_of_length(sf_count_t frames, const RenderRequest *request) {
  return request->frames > 0 ? frames == (sf_count_t)request->frames : frames > 0;
}

static bool is_alike(const char *path, const RenderRequest *request) {
  SF_INFO info = {0};
  SNDFILE *const stream = sf_open(path, SFM_READ, &info);
  if (!stream) return false;
  (void)sf_close(stream);
  return info.samplerate == (int)request->audio.rate && info.channels == (int)request->channels &&
         is_of_length(info.frames, request);
}

bool library_sound_is_finished(const char *path, const RenderRequest *request) {
  struct stat status;
  return stat(path, &status) == 0 && S_ISREG(status.st_mode) && !is_cut_off(path, status.st_size) &&
         is_alike(path, request);
}
