/* SPDX-License-Identifier: MIT */
/* Which microphone each output of a drum has. */
#include "drum/drum.h"

TbRoute tb_route_plain(const TaborModel *model) {
  TbRoute route = {.count = model->def.mic_count};
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
    route.mics[i] = (uint8_t)(i < route.count ? i : (uint32_t)TB_NO_MIC);
  }
  return route;
}

TbRoute tb_route_chosen(const TaborModel *model, const uint8_t *mics, uint32_t count) {
  TbRoute route = {.count = count < TABOR_MAX_MICS ? count : TABOR_MAX_MICS};
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
    const bool is_there = i < route.count && mics[i] < model->def.mic_count;
    route.mics[i] = is_there ? mics[i] : (uint8_t)TB_NO_MIC;
  }
  return route;
}

void tabor_drum_route(TaborDrum *drum, const uint8_t *mics, uint32_t count) {
  drum->route = tb_route_chosen(drum->model, mics, count);
}

void tabor_swap_route(TaborSwap *swap, const uint8_t *mics, uint32_t count) {
  swap->route = tb_route_chosen(swap->new_model, mics, count);
  swap->routed = true;
}
