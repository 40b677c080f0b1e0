/* SPDX-License-Identifier: MIT */
#include "library/library_sound.h"

#include <stdio.h>
#include <string.h>

#include "platform/files.h"
#include "platform/sound_stream.h"

#define RIFF_HEADER 8u /* "RIFF" and the length of what follows */

/* libsndfile reads a WAV that has been cut off as a shorter one: only its own length tells. An RF64, beyond 4 GiB,
   says it elsewhere. */
static bool is_cut_off(const char *path, uint64_t length) {
  unsigned char header[RIFF_HEADER];
  FILE *const stream = file_stream_to_read(path);
  const bool complete = stream && fread(header, sizeof header, 1, stream) == 1;
  if (stream) (void)fclose(stream);
  if (!complete) return true;
  const uint64_t rest =
    header[4] | (uint64_t)header[5] << 8 | (uint64_t)header[6] << 16 | (uint64_t)header[7] << 24;
  return memcmp(header, "RIFF", 4) == 0 && length < RIFF_HEADER + rest;
}

/* Without --duration sounds are as long as they ring, which nobody knows before. */
static bool is_of_length(sf_count_t frames, const RenderRequest *request) {
  return request->frames > 0 ? frames == (sf_count_t)request->frames : frames > 0;
}

static bool is_alike(const char *path, const RenderRequest *request) {
  SF_INFO info = {0};
  SNDFILE *const stream = sound_stream_to_read(path, &info);
  if (!stream) return false;
  (void)sf_close(stream);
  return info.samplerate == (int)request->audio.rate && info.channels == (int)request->channels &&
         is_of_length(info.frames, request);
}

bool library_sound_is_finished(const char *path, const RenderRequest *request) {
  FileStatus status;
  return file_status(path, &status) && status.kind == FILE_KIND_REGULAR &&
         !is_cut_off(path, status.size) && is_alike(path, request);
}
