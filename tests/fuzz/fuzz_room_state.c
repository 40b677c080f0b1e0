/* SPDX-License-Identifier: MIT */
/* Saved states of rooms: arbitrary bytes, and forged contents with a right checksum, are refused,
 * or the room sounds on, in finite numbers. The first byte of the input chooses. 0 to 127: the rest
 * are the bytes, signed if it is odd. Else: a list of changes to a state of a room that sounds, 8
 * bytes each: place, and 4 bytes that replace those there. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

enum { FRAMES = 400, MICS = 3 };

typedef struct Scene {
  TaborRoom *room;
  unsigned char *good, *bytes;
  size_t size;
  float dry[FRAMES];
} Scene;

static void play(Scene *scene, bool is_struck) {
  float sound[MICS][FRAMES] = {{0}}, *outputs[TABOR_MAX_MICS] = {sound[0], sound[1], sound[2]};
  const float *dry[TABOR_MAX_MICS];
  for (int i = 0; i < TABOR_MAX_MICS; i++) dry[i] = is_struck ? scene->dry : NULL;
  tabor_room_process(scene->room, dry, outputs, FRAMES);
  for (uint32_t i = 0; i < MICS * FRAMES; i++) {
    fuzz_require(isfinite(sound[i / FRAMES][i % FRAMES]), "the sound is finite");
  }
  const double energy = tabor_room_energy(scene->room);
  fuzz_require(isfinite(energy) && energy >= 0.0, "the energy is finite");
}

static void set_up(Scene *scene) {
  TaborDrumDef def;
  fuzz_require(tabor_drum_def_preset(&def, "snare-14x5.5", NULL) == TABOR_OK, "a preset");
  def.room.kind = TABOR_ROOM_BOOTH;
  fuzz_require(tabor_room_create(&def, 22050.0, NULL, &scene->room, NULL) == TABOR_OK, "a room");
  for (int i = 0; i < FRAMES; i++) scene->dry[i] = (float)(i * 37 % 101) / 101.0f - 0.5f;
  scene->size = tabor_room_state_size(scene->room);
  scene->good = malloc(scene->size);
  scene->bytes = malloc(scene->size);
  fuzz_require(scene->good && scene->bytes, "memory");
  for (int i = 0; i < 8; i++) play(scene, i < 4);
  tabor_room_state_save(scene->room, scene->good);
}

/* FNV-1a over words of 8 bytes. */
static void sign(unsigned char *bytes, size_t size) {
  uint64_t hash = 14695981039346656037u;
  for (size_t i = 0; i + 16 <= size; i += 8) {
    uint64_t word;
    memcpy(&word, bytes + i, 8);
    hash = (hash ^ word) * 1099511628211u;
  }
  memcpy(bytes + size - 8, &hash, 8);
}

/* Of the input's size as it is, or of a state's size and with its checksum. */
static TaborStatus load_any(Scene *scene, const FuzzInput *input, bool is_signed) {
  if (!is_signed) return tabor_room_state_load(scene->room, input->at, input->left);
  memset(scene->bytes, 0, scene->size);
  const size_t most = scene->size - 8, count = input->left < most ? input->left : most;
  memcpy(scene->bytes, input->at, count);
  memcpy(scene->bytes, scene->good, 8); /* the fingerprint */
  sign(scene->bytes, scene->size);
  return tabor_room_state_load(scene->room, scene->bytes, scene->size);
}

static TaborStatus load_changed(Scene *scene, FuzzInput *input) {
  memcpy(scene->bytes, scene->good, scene->size);
  while (input->left >= 8) {
    const size_t at = 8 + fuzz_word(input) % (scene->size - 20);
    for (size_t i = 0; i < 4; i++) scene->bytes[at + i] = fuzz_byte(input);
  }
  sign(scene->bytes, scene->size);
  return tabor_room_state_load(scene->room, scene->bytes, scene->size);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static Scene scene;
  if (!scene.room) set_up(&scene);
  FuzzInput input = {data, size};
  fuzz_require(tabor_room_state_load(scene.room, scene.good, scene.size) == TABOR_OK, "a good one");
  const uint8_t choice = fuzz_byte(&input);
  const TaborStatus status =
    choice < 128 ? load_any(&scene, &input, choice & 1u) : load_changed(&scene, &input);
  fuzz_require(status == TABOR_OK || status == TABOR_ERROR_STATE, "a status that is documented");
  for (int i = 0; i < 6; i++) play(&scene, i % 3 == 0);
  return 0;
}
