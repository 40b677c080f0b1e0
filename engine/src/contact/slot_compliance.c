/* SPDX-License-Identifier: MIT */
#include "contact/slot_compliance.h"

void tb_solve_stretch(const TbContacts *in, const double *pushed, const double *slots,
                      double *answer, double *out) {
  const uint32_t size = in->wire_grid->size;
  double along[TB_COUPLINGS] = {0.0, 0.0};
  for (uint32_t h = 0; h < in->stretch_count; h++) {
    along[h] = in->kernels->dot(size, in->stretch_grid[h], pushed) +
               in->kernels->dot(TB_SLOTS, in->stretch_slots[h], slots);
  }
  for (uint32_t h = 0; h < in->stretch_count; h++) {
    const double *w = in->stretch_weight[h];
    const double pull = -(w[0] * along[0] + w[1] * along[1]);
    in->kernels->axpy(size, answer, pull, in->stretch_grid[h]);
    in->kernels->axpy(TB_SLOTS, out, pull, in->stretch_slots[h]);
  }
}

void tb_solve_slots(const TbContacts *in, const double *pushed, const double *slots, double *answer,
                    double *out) {
  const uint32_t size = in->wire_grid->size;
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    out[slot] = 0.0;
    if (!tb_contacts_have_slot(in, slot)) continue;
    const double *coupling = in->coupling + (uint64_t)slot * size;
    out[slot] = in->kernels->dot(size, coupling, pushed);
    for (uint32_t other = 0; other < TB_SLOTS; other++) {
      out[slot] += in->slot_coupling[slot * TB_SLOTS + other] * slots[other];
    }
    if (slots[slot] != 0.0) in->kernels->axpy(size, answer, slots[slot], coupling);
  }
}
