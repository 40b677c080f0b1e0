/* SPDX-License-Identifier: MIT */
#include "step/modes_end.h"

void tb_modes_end(TbView *view, uint32_t mic) {
  const TaborModel *model = view->model;
  const TbModes *modes = &model->modes;
  const TbParts none = {.count = 0};
  TbModesEnd *end = &view->end;
  const bool heard = mic < model->def.mic_count;
  *end = (TbModesEnd){.modes = modes->padded,
                      .origins = modes->walls ? 3 : 2,
                      .pull = {view->stretch_pull[0], view->stretch_pull[1]},
                      .last = view->last.q,
                      .loss = {modes->loss_head, modes->loss_air, modes->loss_shell},
                      .ahead = heard ? model->mics[mic].ahead : modes->loss_air,
                      .behind = heard ? model->mics[mic].behind : modes->loss_air,
                      .stretch = {end->stretch[0], end->stretch[1]},
                      .next = view->next.q};
  view->ear = heard ? mic : TB_NO_EAR;
  model->kernels->end_modes(view->stretch_count > 0 ? &model->stretch.parts : &none, end);
}
