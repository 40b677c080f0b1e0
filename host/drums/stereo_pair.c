/* SPDX-License-Identifier: MIT */
#include "drums/stereo_pair.h"

#include <math.h>
#include <string.h>

static bool is_room_chosen(const Arguments *arguments) {
  static const char key[] = "room.kind=";
  size_t position = 0;
  const char *setting;
  while ((setting = arguments_next(arguments, "set", &position)) != NULL) {
    if (strncmp(setting, key, sizeof key - 1) == 0) return true;
  }
  return false;
}

Outcome stereo_pair_take(const Arguments *arguments, TaborDrumDef *def, uint32_t mics[2],
                         double *gain) {
  if (arguments_has(arguments, "mic")) {
    return refuse("--stereo and --mic: both would choose the microphones");
  }
  const int left = tabor_drum_def_find_mic(def, "left");
  const int right = tabor_drum_def_find_mic(def, "right");
  if (left < 0 || right < 0) {
    return refuse("--stereo: the drum lacks a microphone left or right");
  }
  mics[0] = (uint32_t)left;
  mics[1] = (uint32_t)right;
  if (def->room.kind == TABOR_ROOM_NONE && !is_room_chosen(arguments)) {
    def->room.kind = TABOR_ROOM_STUDIO;
  }
  *gain *= pow(10, STEREO_GAIN_DB / 20);
  return OUTCOME_OK;
}
