/* SPDX-License-Identifier: MIT */
/* Arrays in either precision: see model_arrays.c. */

static void TB_NAME(list_wire_grid)(TbTransfer *t, TB_TYPE(TbWireGrid) * grid) {
  ARRAY(t, grid->across, (size_t)grid->wires * grid->lines);
  for (uint32_t along = 0; along < 2; along++) {
    ARRAY(t, grid->contract[along], (size_t)grid->half * grid->padded[along]);
    ARRAY(t, grid->expand[along], (size_t)grid->columns[along] * grid->half);
    ARRAY(t, grid->place[along], (size_t)grid->lines * grid->columns[along]);
  }
}

static void TB_NAME(list_compliance)(TbTransfer *t, TB_TYPE(TbCompliance) * compliance) {
  for (uint32_t c = 0; c < 4; c++) {
    const size_t points = compliance->first[c + 1u] - compliance->first[c];
    ARRAY(t, compliance->matrix[c], points * points);
  }
}

static void TB_NAME(list_ringing)(TbTransfer *t, TB_TYPE(TbRinging) * ringing, uint32_t padded) {
  ARRAY(t, ringing->a, padded);
  ARRAY(t, ringing->b, padded);
  ARRAY(t, ringing->walk, padded);
  ARRAY(t, ringing->hold, padded);
  for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) {
    ARRAY(t, ringing->ahead[mic], padded);
    ARRAY(t, ringing->behind[mic], padded);
  }
}
