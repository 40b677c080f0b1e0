/* SPDX-License-Identifier: MIT */
/**
 * @file host_inspect.c
 * Prints values of JSON and of sound files for the test scripts, one value per call:
 *
 *     host_inspect json PATH        the value at a path such as modes.0.frequency, from standard
 *                                   input; 'keys' or 'size' at its end prints just these
 *     host_inspect sound FILE       container encoding rate channels frames
 *     host_inspect peak FILE        largest absolute sample
 *     host_inspect first FILE       number of the first nonzero frame
 *     host_inspect onsets FILE      frames at which it becomes twice as loud as in the 20 ms before
 *     host_inspect rms FILE A B     root mean square from A to B [s]
 *     host_inspect sounds FILE      time [s] and largest sample of each sound after 50 ms of
 *     silence
 *     host_inspect distance A B     largest difference of two sounds
 *     host_inspect equal A B        status 0 if they do not differ; containers may differ
 */
#include <jansson.h>
#include <math.h>
#include <sndfile.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- JSON ---- */

static void print_keys(json_t *object) {
  const char *key, *separator = "";
  json_t *value;
  json_object_foreach(object, key, value) {
    printf("%s%s", separator, key);
    separator = " ";
  }
  printf("\n");
}

static int print_value(const json_t *value) {
  if (!value) return 1;
  if (json_is_string(value)) return puts(json_string_value(value)) < 0;
  char *const text = json_dumps(value, JSON_ENCODE_ANY | JSON_REAL_PRECISION(17));
  if (!text) return 1;
  (void)puts(text);
  free(text);
  return 0;
}

static int inspect_json(char *path) {
  json_error_t error;
  json_t *const root = json_loadf(stdin, JSON_REJECT_DUPLICATES, &error);
  json_t *value = root;
  int status = root ? 0 : 1;
  if (!root) (void)fprintf(stderr, "host_inspect: %d: %s\n", error.line, error.text);
  const char *step = strtok(path, ".");
  for (; value && step && strcmp(step, "keys") != 0 && strcmp(step, "size") != 0;
       step = strtok(NULL, ".")) {
    value = json_is_array(value) ? json_array_get(value, strtoul(step, NULL, 10))
                                 : json_object_get(value, step);
  }
  if (status == 0 && step && strcmp(step, "keys") == 0) {
    print_keys(value);
  } else if (status == 0 && step) {
    printf("%zu\n", json_array_size(value));
  } else if (status == 0) {
    status = print_value(value);
  }
  json_decref(root);
  return status;
}

/* ---- sound ---- */

typedef struct Sound {
  SF_INFO info;
  double *samples;
  sf_count_t count;
} Sound;

static bool sound_read(const char *path, Sound *sound) {
  sound->info = (SF_INFO){0};
  SNDFILE *const stream = sf_open(path, SFM_READ, &sound->info);
  if (!stream) {
    (void)fprintf(stderr, "host_inspect: %s: %s\n", path, sf_strerror(NULL));
    return false;
  }
  sound->count = sound->info.frames * sound->info.channels;
  sound->samples = calloc((size_t)sound->count + 1, sizeof *sound->samples);
  const bool complete =
    sound->samples && sf_read_double(stream, sound->samples, sound->count) == sound->count;
  (void)sf_close(stream);
  return complete;
}

static const char *container_name(int format) {
  switch (format & SF_FORMAT_TYPEMASK) {
  case SF_FORMAT_WAV: return "wav";
  case SF_FORMAT_FLAC: return "flac";
  case SF_FORMAT_AU: return "au";
  default: return "other";
  }
}

static const char *encoding_name(int format) {
  switch (format & SF_FORMAT_SUBMASK) {
  case SF_FORMAT_PCM_16: return "pcm16";
  case SF_FORMAT_PCM_24: return "pcm24";
  case SF_FORMAT_FLOAT: return "float";
  default: return "other";
  }
}

static double peak(const Sound *sound) {
  double largest = 0;
  for (sf_count_t i = 0; i < sound->count; i++) largest = fmax(largest, fabs(sound->samples[i]));
  return largest;
}

/* Largest sample in size of those from @p from on. */
static double loudest(const Sound *sound, sf_count_t from, sf_count_t count) {
  double largest = 0;
  for (sf_count_t i = from > 0 ? from : 0; i < from + count && i < sound->count; i++) {
    largest = fmax(largest, fabs(sound->samples[i]));
  }
  return largest;
}

/* To a millisecond, one in 20 ms at most; the quietest are 80 dB below full scale. */
static void print_onsets(const Sound *sound) {
  const sf_count_t step = sound->info.samplerate / 1000 * sound->info.channels;
  for (sf_count_t i = 0; i < sound->count; i += step) {
    const double before = loudest(sound, i - 20 * step, 20 * step);
    if (loudest(sound, i, step) <= fmax(2 * before, 1e-4)) continue;
    printf("%lld\n", (long long)(i / sound->info.channels));
    i += 19 * step;
  }
}

static double rms(const Sound *sound, double from, double to) {
  const double rate = sound->info.samplerate * sound->info.channels;
  double sum = 0, count = 0;
  for (sf_count_t i = 0; i < sound->count; i++) {
    if ((double)i < from * rate || (double)i >= to * rate) continue;
    sum += sound->samples[i] * sound->samples[i];
    count++;
  }
  return sqrt(sum / count); /* of nothing: not a number */
}

static long long first_frame(const Sound *sound) {
  sf_count_t i = 0;
  while (i < sound->count && sound->samples[i] == 0) i++;
  return (long long)(i / sound->info.channels);
}

/* Of the first channel. */
static void print_sounds(const Sound *sound) {
  static const double silent = 1e-4, pause = 0.05;
  const int channels = sound->info.channels;
  const double rate = sound->info.samplerate;
  sf_count_t onset = -1, last = (sf_count_t)(-pause * rate) - 1;
  double largest = 0;
  for (sf_count_t frame = 0; frame <= sound->info.frames; frame++) {
    const bool over = frame == sound->info.frames;
    const double size = over ? 1 : fabs(sound->samples[frame * channels]);
    if (size < silent) continue;
    if (over || (double)(frame - last) > pause * rate) {
      if (onset >= 0) printf("%.6f %.6f\n", (double)onset / rate, largest);
      onset = frame;
      largest = 0;
    }
    largest = fmax(largest, size);
    last = frame;
  }
}

/* Largest difference of two sounds; infinite if they are not of one shape. */
static double distance(const Sound *a, const char *path) {
  Sound b = {0};
  const bool alike =
    sound_read(path, &b) && a->count == b.count && a->info.channels == b.info.channels;
  double largest = alike ? 0 : INFINITY;
  for (sf_count_t i = 0; alike && i < a->count; i++) {
    largest = fmax(largest, fabs(a->samples[i] - b.samples[i]));
  }
  free(b.samples);
  return largest;
}

static int inspect_sound(const char *what, const Sound *sound, char *const *others) {
  const char *const other = others[0];
  const int format = sound->info.format;
  if (strcmp(what, "sound") == 0) {
    printf("%s %s %d %d %lld\n", container_name(format), encoding_name(format),
           sound->info.samplerate, sound->info.channels, (long long)sound->info.frames);
  } else if (strcmp(what, "peak") == 0) {
    printf("%.9g\n", peak(sound));
  } else if (strcmp(what, "onsets") == 0) {
    print_onsets(sound);
  } else if (strcmp(what, "rms") == 0 && other && others[1]) {
    printf("%.9g\n", rms(sound, atof(other), atof(others[1])));
  } else if (strcmp(what, "first") == 0) {
    printf("%lld\n", first_frame(sound));
  } else if (strcmp(what, "sounds") == 0) {
    print_sounds(sound);
  } else if (strcmp(what, "distance") == 0) {
    printf("%.17g\n", distance(sound, other));
  } else {
    return distance(sound, other) == 0 ? 0 : 1;
  }
  return 0;
}

int main(int argc, char **argv) {
  if (argc < 3) return 2;
  if (strcmp(argv[1], "json") == 0) return inspect_json(argv[2]);
  Sound sound = {0};
  const int status = sound_read(argv[2], &sound) ? inspect_sound(argv[1], &sound, argv + 3) : 1;
  free(sound.samples);
  return status;
}
