/* SPDX-License-Identifier: MIT */
#include "sound/room_create.h"

Outcome room_create(const TaborDrumDef *def, double rate, RoomMix *room) {
  uint8_t mics[TABOR_MAX_MICS];
  TaborError error;
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) mics[i] = (uint8_t)i;
  const TaborStatus status = room_mix_create(room, def, rate, mics, def->mic_count, &error);
  return status == TABOR_OK ? OUTCOME_OK : report_engine_error(&error);
}
