/* SPDX-License-Identifier: MIT */
#include "sound/room_mix.h"

#include <string.h>

#define ENERGY_FALL 1e-9 /* 90 dB */

uint32_t room_mix_extra(const TaborDrumDef *def) {
  return def->room.kind == TABOR_ROOM_NONE ? 0 : ROOM_FEEDS;
}

void room_mix_begin(RoomMix *mix, TaborRoom *room, const uint32_t *mics, uint32_t channels) {
  mix->room = room;
  mix->mics = mics;
  mix->channels = channels;
  mix->loudest = 0;
  if (!room) return;
  TaborRoomInfo info;
  tabor_room_info(room, &info);
  memcpy(mix->feed, info.feed, sizeof mix->feed);
}

static void take_dry(RoomMix *mix, double *const *sound, uint32_t from, uint32_t frames) {
  for (uint32_t feed = 0; feed < ROOM_FEEDS; feed++) {
    const double *const dry = sound[mix->channels + feed] + from;
    for (uint32_t i = 0; i < frames; i++) mix->dry[feed][i] = (float)dry[i];
  }
}

static void play_piece(RoomMix *mix, double *const *sound, uint32_t from, uint32_t frames) {
  const float *dry[TABOR_MAX_MICS] = {NULL};
  float *wet[TABOR_MAX_MICS] = {NULL};
  take_dry(mix, sound, from, frames);
  for (uint32_t feed = 0; feed < ROOM_FEEDS; feed++) dry[mix->feed[feed]] = mix->dry[feed];
  for (uint32_t channel = 0; channel < mix->channels; channel++) {
    const uint32_t mic = mix->mics[channel];
    wet[mic] = mix->wet[mic];
    memset(wet[mic], 0, frames * sizeof *wet[mic]);
  }
  tabor_room_process(mix->room, dry, wet, frames);
  for (uint32_t channel = 0; channel < mix->channels; channel++) {
    const float *const heard = wet[mix->mics[channel]];
    for (uint32_t i = 0; i < frames; i++) sound[channel][from + i] += (double)heard[i];
  }
}

void room_mix_play(RoomMix *mix, double *const *sound, uint32_t frames) {
  if (!mix->room) return;
  for (uint32_t from = 0; from < frames; from += ROOM_PIECE) {
    play_piece(mix, sound, from, frames - from < ROOM_PIECE ? frames - from : ROOM_PIECE);
  }
}

void room_mix_cut(RoomMix *mix) {
  if (mix->room) tabor_room_reset(mix->room);
}

bool room_mix_is_over(RoomMix *mix) {
  if (!mix->room) return true;
  const double energy = tabor_room_energy(mix->room);
  if (energy > mix->loudest) mix->loudest = energy;
  return energy <= ENERGY_FALL * mix->loudest;
}
