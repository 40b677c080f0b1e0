/* SPDX-License-Identifier: MIT */
#include "files/audio_clip.h"

#include <errno.h>
#include <math.h>
#include <sndfile.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "platform/files.h"
#include "platform/sound_stream.h"

#define CHUNK 16384 /* samples read at once */

/* A file while it is being read. */
typedef struct Reader {
  const char *name; /* "-": the standard input */
  SNDFILE *stream;
  const AudioClipPart *part;
  uint64_t first, end; /* frames of the part */
  double chunk[CHUNK];
  AudioClip *clip;
} Reader;

static Outcome open_stream(Reader *reader, const char *name) {
  SF_INFO info = {0};
  const bool standard = strcmp(name, "-") == 0;
  FileStatus status;
  if (!(standard ? file_status_of(STDIN_FILENO, &status) : file_status(name, &status))) {
    return fail("cannot read " INPUT ": %s", INPUT_OF(name), strerror(errno));
  }
  if (status.kind == FILE_KIND_FOLDER) {
    return fail("cannot read " INPUT ": it is a folder", INPUT_OF(name));
  }
  errno = 0;
  reader->stream = standard ? sf_open_fd(STDIN_FILENO, SFM_READ, &info, SF_FALSE)
                            : sound_stream_to_read(name, &info);
  if (!reader->stream) {
    const bool system = sf_error(NULL) == SF_ERR_SYSTEM && errno != 0;
    return fail("cannot read " INPUT ": %s", INPUT_OF(reader->name),
                system ? strerror(errno) : sf_strerror(NULL));
  }
  if (info.channels > CHUNK)
    return fail("cannot read " INPUT ": too many channels", INPUT_OF(reader->name));
  reader->clip->rate = (uint32_t)info.samplerate;
  reader->clip->channels = (uint32_t)info.channels;
  return OUTCOME_OK;
}

static Outcome choose_part(Reader *reader) {
  const AudioClipPart *const part = reader->part;
  const AudioClip *const clip = reader->clip;
  if (part->channel > clip->channels) {
    return refuse("--channel '%u': " INPUT " has %u", (unsigned)part->channel,
                  INPUT_OF(reader->name), (unsigned)clip->channels);
  }
  reader->first = (uint64_t)llround(part->from * clip->rate);
  reader->end = isfinite(part->to) ? (uint64_t)llround(part->to * clip->rate) : UINT64_MAX;
  return OUTCOME_OK;
}

static Outcome keep_sample(Reader *reader, double sample) {
  AudioClip *const clip = reader->clip;
  if (!isfinite(sample))
    return fail(INPUT " holds samples that are not finite", INPUT_OF(reader->name));
  if (clip->count >= (size_t)(AUDIO_CLIP_LONGEST * clip->rate)) {
    return refuse(INPUT " is too long; take at most %.0f s of it with --from and --to",
                  INPUT_OF(reader->name), AUDIO_CLIP_LONGEST);
  }
  if (clip->count == clip->capacity) {
    const size_t capacity = clip->capacity ? 2 * clip->capacity : 65536;
    double *const samples = realloc(clip->samples, capacity * sizeof *samples);
    if (!samples) return fail_memory();
    clip->samples = samples;
    clip->capacity = capacity;
  }
  clip->samples[clip->count++] = sample;
  return OUTCOME_OK;
}

/* What a file says of its length is not relied on: from a pipe it may be anything. */
static Outcome read_chunks(Reader *reader) {
  AudioClip *const clip = reader->clip;
  const uint32_t channels = clip->channels;
  Outcome outcome = OUTCOME_OK;
  sf_count_t frames;
  while (outcome == OUTCOME_OK &&
         (frames = sf_readf_double(reader->stream, reader->chunk, CHUNK / channels)) > 0) {
    for (sf_count_t i = 0; i < frames && outcome == OUTCOME_OK; i++, clip->frames++) {
      if (clip->frames < reader->first || clip->frames >= reader->end) continue;
      outcome =
        keep_sample(reader, reader->chunk[(size_t)i * channels + reader->part->channel - 1]);
    }
  }
  if (outcome == OUTCOME_OK && sf_error(reader->stream) != 0) {
    return fail("cannot read " INPUT ": %s", INPUT_OF(reader->name), sf_strerror(reader->stream));
  }
  return outcome;
}

static Outcome check_part(const Reader *reader) {
  const AudioClip *const clip = reader->clip;
  if (clip->count > 0 || reader->first < clip->frames || reader->first == 0) return OUTCOME_OK;
  return refuse("--from '%.10g': " INPUT " is %.10g s long", reader->part->from,
                INPUT_OF(reader->name), (double)clip->frames / clip->rate);
}

Outcome audio_clip_read(const char *name, const AudioClipPart *part, AudioClip *clip) {
  *clip = (AudioClip){0};
  Reader *const reader = calloc(1, sizeof *reader);
  if (!reader) return fail_memory();
  reader->name = name;
  reader->part = part;
  reader->clip = clip;
  Outcome outcome = open_stream(reader, name);
  if (outcome == OUTCOME_OK) outcome = choose_part(reader);
  if (outcome == OUTCOME_OK) outcome = read_chunks(reader);
  if (outcome == OUTCOME_OK) outcome = check_part(reader);
  if (reader->stream) (void)sf_close(reader->stream);
  free(reader);
  return outcome;
}

void audio_clip_free(AudioClip *clip) {
  free(clip->samples);
  *clip = (AudioClip){0};
}
