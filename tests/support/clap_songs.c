/* SPDX-License-Identifier: MIT */
#include "clap_songs.h"

#include <string.h>

void clap_host_play(ClapHost *host, uint32_t block, uint32_t first, Take *take) {
  static uint64_t random = 7;
  size_t next = 0;
  for (uint32_t at = 0; at < take->frames;) {
    uint32_t run = block > 0 ? block : (uint32_t)(midi_random(&random) % (CLAP_BLOCK + 1));
    if (run > take->frames - at) run = take->frames - at;
    for (; next < song.count && song.messages[next].frame < at + run; next++) {
      clap_host_midi(host, (uint32_t)song.messages[next].frame - at, &song.messages[next].message);
    }
    clap_host_run(host, run);
    for (uint32_t i = 0; i < take->channels; i++) {
      memcpy(take->sound[i] + at, host->sound[first + i], run * sizeof(float));
    }
    at += run;
  }
}
