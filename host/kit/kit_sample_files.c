/* SPDX-License-Identifier: MIT */
#include "kit/kit_sample_files.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "files/audio_clip.h"
#include "platform/files.h"
#include "platform/paths.h"

#define FADE_TIME 0.015 /* [s], as of a drum's silence */
enum { MOST_CHOKE = 15 };

/* ---- the kit file ---------------------------------------------------------------------------- */

void kit_samples_begin(KitSamples *samples) { memset(samples, 0, sizeof *samples); }

static int note_of(const char *section) {
  static const char prefix[] = "note.";
  const size_t digits = strspn(section + sizeof prefix - 1, "0123456789");
  if (strncmp(section, prefix, sizeof prefix - 1) != 0 || digits == 0 || digits > 3) return -1;
  if (section[sizeof prefix - 1 + digits] != '\0') return -1;
  const int note = atoi(section + sizeof prefix - 1);
  return note < MIDI_VALUES ? note : -1;
}

/* "FOLDER/hat.wav" beside "FOLDER/kit.ini"; a path of its own stays. */
static char *beside(const char *file, const char *name) {
  const size_t folder = path_has_folder(name) ? 0 : (size_t)(path_base(file) - file);
  char *const path = malloc(folder + strlen(name) + 1);
  if (!path) return NULL;
  memcpy(path, file, folder);
  memcpy(path + folder, name, strlen(name) + 1);
  return path;
}

static bool read_number(const char *key, const char *value, double least, double most, bool whole,
                        double *number, char *message, size_t size) {
  const NumberField field = {key, least, most, whole};
  const MessageCapture before = message_capture(message, size);
  const bool read = number_read(&field, value, number) == OUTCOME_OK;
  message_release(before);
  return read;
}

bool kit_samples_set(KitSamples *samples, const char *file, const char *section, const char *key,
                     const char *value, char *message, size_t size) {
  const int note = note_of(section);
  double number = 0;
  if (note < 0) {
    (void)snprintf(message, size, "[%.40s]: allowed are note.0 to note.127", section);
    return false;
  }
  KitSample *const sample = &samples->notes[note];
  if (!key) return true;
  if (strcmp(key, "sample") == 0) {
    free(sample->path);
    sample->path = beside(file, value);
    return sample->path != NULL;
  }
  if (strcmp(key, "gain") == 0) {
    return read_number("gain", value, -120, 24, false, &sample->gain_db, message, size);
  }
  if (strcmp(key, "choke") == 0) {
    const bool read = read_number("choke", value, 0, MOST_CHOKE, true, &number, message, size);
    sample->choke = (uint32_t)number;
    return read;
  }
  (void)snprintf(message, size, "[%.40s] has no key '%.40s'; allowed: sample, gain, choke", section,
                 key);
  return false;
}

bool kit_samples_take_pair(void *context, const char *section, const char *key, const char *value,
                           unsigned line, char *message, size_t size) {
  const KitSampleReader *const reader = context;
  (void)line;
  return kit_samples_set(reader->samples, reader->file, section, key, value, message, size);
}

KitSamples kit_samples_from_root(const KitSamples *samples) {
  KitSamples rooted;
  kit_samples_begin(&rooted);
  for (int note = 0; note < MIDI_VALUES; note++) {
    const KitSample *const sample = &samples->notes[note];
    rooted.notes[note] = (KitSample){.gain_db = sample->gain_db, .choke = sample->choke};
    if (sample->path) rooted.notes[note].path = file_absolute(sample->path);
  }
  return rooted;
}

void kit_samples_map(const KitSamples *samples, bool has_sample[MIDI_VALUES]) {
  for (int note = 0; note < MIDI_VALUES; note++) {
    has_sample[note] = samples->notes[note].path != NULL;
  }
}

/* ---- the files ------------------------------------------------------------------------------- */

static Outcome read_side(KitSample *sample, uint32_t channel, double rate, AudioClip *clip) {
  const AudioClipPart whole = {channel, 0, INFINITY};
  const Outcome outcome = audio_clip_read(sample->path, &whole, clip);
  if (outcome != OUTCOME_OK) return outcome;
  if (clip->rate != rate) {
    return refuse("'%s': its rate is %u Hz, that of the kit %.10g Hz; --rate %u fits", sample->path,
                  (unsigned)clip->rate, rate, (unsigned)clip->rate);
  }
  float *const sound = calloc(clip->count + 1, sizeof *sound);
  if (!sound) return fail_memory();
  const double gain = pow(10, sample->gain_db / 20);
  for (size_t i = 0; i < clip->count; i++) sound[i] = (float)(gain * clip->samples[i]);
  sample->sound[channel - 1] = sound;
  sample->frames = (uint32_t)clip->count;
  return OUTCOME_OK;
}

static Outcome read_sample(KitSample *sample, double rate) {
  AudioClip clip = {0};
  Outcome outcome = read_side(sample, 1, rate, &clip);
  const uint32_t channels = clip.channels;
  audio_clip_free(&clip);
  if (outcome != OUTCOME_OK || channels < 2) return outcome;
  outcome = read_side(sample, 2, rate, &clip);
  audio_clip_free(&clip);
  return outcome;
}

Outcome kit_samples_load(KitSamples *samples, double rate) {
  Outcome outcome = OUTCOME_OK;
  samples->fade = (uint32_t)(FADE_TIME * rate);
  for (int note = 0; note < MIDI_VALUES && outcome == OUTCOME_OK; note++) {
    if (samples->notes[note].path) outcome = read_sample(&samples->notes[note], rate);
  }
  return outcome;
}

void kit_samples_free(KitSamples *samples) {
  for (int note = 0; note < MIDI_VALUES; note++) {
    free(samples->notes[note].path);
    free(samples->notes[note].sound[0]);
    free(samples->notes[note].sound[1]);
  }
  kit_samples_begin(samples);
}
