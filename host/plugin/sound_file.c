/* SPDX-License-Identifier: MIT */
#include "plugin/sound_file.h"

#include <sndfile.h>
#include <stdio.h>
#include <stdlib.h>

#include "files/audio_clip.h"
#include "platform/shared_library.h"

enum { CHUNK = 4096 }; /* frames read at once */

/* What is used of libsndfile. */
typedef struct Library {
  void *handle;
  SNDFILE *(*open)(const char *path, int mode, SF_INFO *info);
  sf_count_t (*read)(SNDFILE *file, float *samples, sf_count_t frames);
  int (*close)(SNDFILE *file);
  const char *(*error)(SNDFILE *file);
} Library;

static bool library_open(Library *library) {
  *library = (Library){.handle = shared_library_sndfile()};
  if (!library->handle) return false;
  shared_library_find(library->handle, "sf_open", &library->open);
  shared_library_find(library->handle, "sf_readf_float", &library->read);
  shared_library_find(library->handle, "sf_close", &library->close);
  shared_library_find(library->handle, "sf_strerror", &library->error);
  if (library->open && library->read && library->close && library->error) return true;
  shared_library_close(library->handle);
  return false;
}

static bool make_room(KitSound *sound, const SF_INFO *info) {
  sound->rate = info->samplerate;
  for (int side = 0; side < 2 && side < info->channels; side++) {
    sound->side[side] = calloc((size_t)info->frames + 1, sizeof(float));
    if (!sound->side[side]) return false;
  }
  return true;
}

/* A file may have fewer frames than it says. */
static bool read_frames(const Library *library, SNDFILE *file, const SF_INFO *info,
                        KitSound *sound) {
  const size_t channels = (size_t)info->channels;
  float *const chunk = malloc(CHUNK * channels * sizeof *chunk);
  while (chunk && (sf_count_t)sound->frames < info->frames) {
    const sf_count_t left = info->frames - (sf_count_t)sound->frames;
    const sf_count_t count = library->read(file, chunk, left < CHUNK ? left : CHUNK);
    if (count <= 0) break;
    for (size_t i = 0; i < (size_t)count; i++) {
      for (int side = 0; side < 2 && sound->side[side]; side++) {
        sound->side[side][sound->frames + i] = chunk[i * channels + (size_t)side];
      }
    }
    sound->frames += (uint32_t)count;
  }
  free(chunk);
  return chunk != NULL;
}

/* What is wrong, or NULL. */
static const char *read_open(const Library *library, SNDFILE *file, const SF_INFO *info,
                             KitSound *sound) {
  if (info->channels < 1 || info->channels > 1024) return "it has too many channels";
  if (info->frames < 0 || (double)info->frames > AUDIO_CLIP_LONGEST * info->samplerate) {
    return "it is longer than 120 s";
  }
  const bool is_read = make_room(sound, info) && read_frames(library, file, info, sound);
  return is_read ? NULL : "out of memory";
}

static void forget(KitSound *sound) {
  free(sound->side[0]);
  free(sound->side[1]);
  *sound = (KitSound){{NULL, NULL}, 0, 0};
}

bool sound_file_read(const char *path, KitSound *sound, char *message, size_t size) {
  Library library;
  SF_INFO info = {0};
  const char *wrong = "libsndfile is not there to read it";
  *sound = (KitSound){{NULL, NULL}, 0, 0};
  if (library_open(&library)) {
    SNDFILE *const file = library.open(path, SFM_READ, &info);
    wrong = file ? read_open(&library, file, &info, sound) : library.error(NULL);
    if (wrong) (void)snprintf(message, size, "'%.200s': %s", path, wrong);
    if (file) (void)library.close(file);
    shared_library_close(library.handle);
  } else {
    (void)snprintf(message, size, "'%.200s': %s", path, wrong);
  }
  if (wrong) forget(sound);
  return !wrong;
}
