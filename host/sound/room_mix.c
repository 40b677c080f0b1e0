/* SPDX-License-Identifier: MIT */
#include "sound/room_mix.h"

#include <string.h>

#define ENERGY_FALL 1e-9 /* 90 dB */

/* ---- set-up --------------------------------------------------------------------------------- */

static uint32_t find_feeds(const RoomMix *mix) {
  TaborRoomInfo info;
  uint32_t feeds = 0;
  tabor_room_info(mix->room, &info);
  for (uint32_t i = 0; i < mix->outputs; i++) {
    if (mix->mics[i] == info.feed[0] || mix->mics[i] == info.feed[1]) feeds |= 1u << i;
  }
  return feeds;
}

TaborStatus room_mix_create(RoomMix *mix, const TaborDrumDef *def, double rate, const uint8_t *mics,
                            uint32_t outputs, TaborError *error) {
  memset(mix, 0, sizeof *mix);
  if (def->room.kind == TABOR_ROOM_NONE) return TABOR_OK;
  mix->outputs = outputs;
  memcpy(mix->mics, mics, outputs * sizeof *mics);
  mix->fade = (uint32_t)(ROOM_MIX_FADE * rate);
  TaborStatus status = tabor_room_create(def, rate, NULL, &mix->room, error);
  if (status == TABOR_OK) status = tabor_room_create(def, rate, NULL, &mix->fading, error);
  if (status == TABOR_OK) mix->feeds = find_feeds(mix);
  return status;
}

void room_mix_free(RoomMix *mix) {
  tabor_room_destroy(mix->room);
  tabor_room_destroy(mix->fading);
  mix->room = mix->fading = NULL;
}

/* ---- sound ---------------------------------------------------------------------------------- */

static bool hears(const RoomMix *mix, uint32_t outputs, uint32_t output) {
  return outputs >> output & 1u && mix->mics[output] != ROOM_MIX_NO_MIC;
}

/* Frames of what a room adds to the outputs. */
typedef struct Part {
  TaborRoom *room;
  uint32_t heard, from, frames;
  uint32_t left; /* frames of a fade that are left; 0: it does not fade */
} Part;

static void add_output(const RoomMix *mix, const Part *part, const float *wet, float *sound) {
  const float fade = (float)(mix->fade + 1);
  for (uint32_t i = 0; i < part->frames; i++) {
    const float weight = part->left == 0 ? 1 : (float)(part->left - i) / fade;
    sound[part->from + i] += weight * wet[i];
  }
}

static void add(RoomMix *mix, const Part *part, const float *const *dry,
                float (*sound)[ROOM_MIX_PIECE]) {
  float *wet[TABOR_MAX_MICS] = {NULL};
  for (uint32_t i = 0; i < mix->outputs; i++) {
    const uint8_t mic = mix->mics[i];
    if (!hears(mix, part->heard, i) || wet[mic]) continue;
    wet[mic] = mix->wet[mic];
    memset(wet[mic], 0, part->frames * sizeof *wet[mic]);
  }
  tabor_room_process(part->room, dry, wet, part->frames);
  for (uint32_t i = 0; i < mix->outputs; i++) {
    if (hears(mix, part->heard, i)) add_output(mix, part, wet[mix->mics[i]], sound[i]);
  }
}

void room_mix_play(RoomMix *mix, float (*sound)[ROOM_MIX_PIECE], uint32_t heard, uint32_t from,
                   uint32_t frames) {
  const float *dry[TABOR_MAX_MICS] = {NULL};
  if (!mix->room || frames == 0) return;
  for (uint32_t i = 0; i < mix->outputs; i++) {
    if (hears(mix, mix->feeds, i)) dry[mix->mics[i]] = sound[i] + from;
  }
  Part part = {.room = mix->room, .heard = heard, .from = from, .frames = frames};
  add(mix, &part, dry, sound);
  if (mix->left == 0) return;
  part.room = mix->fading;
  part.left = mix->left;
  part.frames = frames < mix->left ? frames : mix->left;
  mix->left -= part.frames;
  add(mix, &part, NULL, sound);
}

void room_mix_silence(RoomMix *mix) {
  TaborRoom *const room = mix->room;
  if (!room || tabor_room_is_silent(room)) return; /* an earlier fade goes on */
  mix->room = mix->fading;
  mix->fading = room;
  mix->left = mix->fade;
  tabor_room_reset(mix->room);
}

bool room_mix_is_fading(const RoomMix *mix) { return mix->left > 0; }

void room_mix_rest(RoomMix *mix) {
  mix->left = 0;
  if (mix->room) tabor_room_reset(mix->room);
}

bool room_mix_is_over(RoomMix *mix) {
  if (!mix->room) return true;
  const double energy = tabor_room_energy(mix->room);
  if (energy > mix->loudest) mix->loudest = energy;
  return energy <= ENERGY_FALL * mix->loudest;
}
