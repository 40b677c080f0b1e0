/* SPDX-License-Identifier: MIT */
#include "saved_model/model_arrays.h"

#define ARRAY(transfer, pointer, count)                                                            \
  tb_transfer_array(transfer, (void *)&(pointer), sizeof *(pointer), count)
#define BEGIN_RECORDS(transfer, pointer, count)                                                    \
  tb_transfer_begin_records(transfer, (void *)&(pointer), sizeof *(pointer), count)

#define TB_TEMPLATE "saved_model/model_arrays_tmpl.h"
#include "kernels/both.h"

/* ---- the body ------------------------------------------------------------------------------- */

static void list_order(TbTransfer *t, TbBodyOrder *order) {
  ARRAY(t, order->zeros, order->zero_count);
  for (uint32_t s = 0; s < TB_HEADS; s++) {
    ARRAY(t, order->vectors[s], (size_t)order->mode_count * order->zero_count);
    ARRAY(t, order->edge[s], order->mode_count);
  }
  ARRAY(t, order->hoop, order->mode_count);
  ARRAY(t, order->rows, order->mode_count);
}

static void list_membrane_order(TbTransfer *t, TbMembraneOrder *order, size_t points) {
  ARRAY(t, order->curvature, 3u * points * order->modes);
  ARRAY(t, order->stress, points * order->stresses);
  ARRAY(t, order->rise, (size_t)order->stresses * order->modes);
}

static void list_membrane(TbTransfer *t, TbMembrane *membrane) {
  ARRAY(t, membrane->r, membrane->points);
  ARRAY(t, membrane->ring, membrane->points);
  const TbRecord before = BEGIN_RECORDS(t, membrane->orders, membrane->order_count);
  for (uint32_t m = 0; membrane->orders && m < membrane->order_count; m++) {
    list_membrane_order(t, &membrane->orders[m], membrane->points);
  }
  tb_transfer_end_records(t, before);
}

static void list_body(TbTransfer *t, TbBody *body) {
  ARRAY(t, body->modes, body->row_count);
  const TbRecord before = BEGIN_RECORDS(t, body->orders, body->order_count);
  for (uint32_t m = 0; body->orders && m < body->order_count; m++) list_order(t, &body->orders[m]);
  tb_transfer_end_records(t, before);
  list_membrane(t, &body->membrane);
}

/* ---- modes and what acts on them ------------------------------------------------------------ */

static void list_modes(TbTransfer *t, TbModes *modes) {
  double **const arrays[] = {&modes->a,          &modes->b,         &modes->g,
                             &modes->stiffness,  &modes->loss_head, &modes->loss_air,
                             &modes->loss_shell, &modes->pull};
  ARRAY(t, modes->row, modes->padded);
  ARRAY(t, modes->sine, modes->padded);
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) ARRAY(t, *arrays[i], modes->padded);
}

static void list_mics(TbTransfer *t, TaborModel *model) {
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
    TbMic *mic = &model->mics[i];
    ARRAY(t, mic->ahead, model->modes.padded);
    ARRAY(t, mic->behind, model->modes.padded);
    ARRAY(t, mic->push_now, model->modes.padded);
    ARRAY(t, mic->push_before, model->modes.padded);
  }
}

static void list_power(TbTransfer *t, TbRadiatedPower *power) {
  const size_t entries = power->group[TB_FAR_GROUPS];
  ARRAY(t, power->mode, entries);
  ARRAY(t, power->loss, entries);
  ARRAY(t, power->ahead, entries * TB_FAR_NODES);
  ARRAY(t, power->behind, entries * TB_FAR_NODES);
}

static void list_force(TbTransfer *t, TbModeForce *force, uint32_t padded) {
  ARRAY(t, force->mode, force->count);
  ARRAY(t, force->along, padded);
}

static void list_lugs(TbTransfer *t, TbLugs *lugs) {
  ARRAY(t, lugs->pull, (size_t)lugs->count * lugs->count);
  ARRAY(t, lugs->rows, lugs->row_count);
}

static void list_resting(TbTransfer *t, TaborModel *model) {
  TbResting *resting = &model->resting;
  ARRAY(t, resting->most, model->modes.padded / 8u);
  ARRAY(t, resting->heard, model->modes.padded);
  ARRAY(t, resting->heard_high, model->high.padded);
}

/* ---- large deflections ---------------------------------------------------------------------- */

static void list_mixing_block(TbTransfer *t, TbMixingBlock *block, uint32_t heads) {
  const size_t terms = (size_t)tb_pad(heads * block->count) * block->count;
  ARRAY(t, block->mode, block->count);
  ARRAY(t, block->part, block->count);
  ARRAY(t, block->matrix, terms);
  ARRAY(t, block->rounded, terms);
}

static void list_stretch(TbTransfer *t, TbStretch *stretch, uint32_t padded) {
  for (uint32_t i = 0; i < TB_COUPLINGS; i++) ARRAY(t, stretch->gain[i], padded);
  TbMixing *mixing = &stretch->mixing;
  const TbRecord before = BEGIN_RECORDS(t, mixing->block, mixing->count);
  for (uint32_t i = 0; mixing->block && i < mixing->count; i++) {
    list_mixing_block(t, &mixing->block[i], mixing->heads);
  }
  tb_transfer_end_records(t, before);
}

/* Products of pairs and functions of stress of one order. */
static size_t rise_count(const TbTransfer *t, const TbVonKarman *tables) {
  size_t products = 0;
  for (uint32_t m = 0; !t->failed && m < tables->stress_orders; m++) {
    products += (size_t)(tables->first_stress[m + 1u] - tables->first_stress[m]) *
                (tables->first[m + 1u] - tables->first[m]);
  }
  return products;
}

static void list_plate(TbTransfer *t, TbPlateCoupling *plate) {
  TbVonKarman *tables = &plate->tables;
  if (!tables->first) return;
  const size_t points = tables->points;
  ARRAY(t, tables->first, tables->orders + 1u);
  ARRAY(t, tables->first_stress, tables->stress_orders + 1u);
  if (t->failed) return;
  ARRAY(t, tables->curvature, 3u * points * tables->pairs);
  ARRAY(t, tables->stress, points * tables->first_stress[tables->stress_orders]);
  ARRAY(t, tables->rise, rise_count(t, tables));
  ARRAY(t, tables->ring, points);
  ARRAY(t, tables->cosine, tables->angles);
  ARRAY(t, tables->sine, tables->angles);
  ARRAY(t, plate->mode, 2u * (size_t)tables->pairs);
}

static void list_cascade(TbTransfer *t, TbCascade *cascade) {
  const uint32_t bands = cascade->bands < TB_CASCADE_BANDS ? cascade->bands : TB_CASCADE_BANDS;
  ARRAY(t, cascade->mode, cascade->first[bands]);
  ARRAY(t, cascade->low, cascade->low_count);
}

/* ---- contacts ------------------------------------------------------------------------------- */

static void list_wires(TbTransfer *t, TbWires *wires) {
  double **const arrays[] = {&wires->inner, &wires->real, &wires->row_x, &wires->row_y,
                             &wires->shape};
  ARRAY(t, wires->wires, wires->count);
  ARRAY(t, wires->laws, wires->count);
  ARRAY(t, wires->row_wire, wires->stride);
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) ARRAY(t, *arrays[i], wires->stride);
}

static void list_projection(TbTransfer *t, TbProjection *projection) {
  list_wire_grid(t, &projection->wire_grid);
  for (uint32_t g = 0; g < 4; g++) {
    TbProjectionGroup *group = &projection->group[g];
    const size_t size = (size_t)group->points * group->modes;
    ARRAY(t, group->gather, size);
    ARRAY(t, group->scatter, size);
    ARRAY(t, group->gather_rounded, size);
    ARRAY(t, group->scatter_rounded, size);
    ARRAY(t, group->run, group->runs);
    ARRAY(t, group->along, group->modes);
    ARRAY(t, group->along_rounded, group->modes);
  }
}

static void list_rest(TbTransfer *t, TaborModel *model) {
  TbRest *rest = &model->rest;
  ARRAY(t, rest->q, model->modes.padded);
  ARRAY(t, rest->v, model->wires.node_count);
  ARRAY(t, rest->bend, model->wires.node_count);
  ARRAY(t, rest->eta, model->wires.stride);
  ARRAY(t, rest->force, tb_row_count(&model->rows));
  ARRAY(t, rest->grid, model->projection.wire_grid.size);
  ARRAY(t, rest->offset, model->wires.count);
}

/* ---- high band and strikers ----------------------------------------------------------------- */

static void list_high_band(TbTransfer *t, TbHighBand *band, uint32_t stride) {
  double **const arrays[] = {&band->zero, &band->scale, &band->g, &band->stiffness};
  ARRAY(t, band->order, band->padded);
  ARRAY(t, band->of_air, band->padded);
  ARRAY(t, band->hold_band, band->padded);
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) ARRAY(t, *arrays[i], band->padded);
  list_ringing(t, &band->ringing, band->padded);
  list_ringingf(t, &band->ringingf, band->padded);
  ARRAY(t, band->row_group, stride);
  for (uint32_t p = 0; p < 2; p++) {
    ARRAY(t, band->push[p].table, (size_t)band->push[p].rows * band->push[p].size);
  }
}

static void list_strikers(TbTransfer *t, TaborModel *model) {
  const uint32_t cosines = model->high.cosines[TABOR_HEAD_BATTER];
  for (uint32_t i = 0; i < TABOR_MAX_STRIKERS; i++) {
    ARRAY(t, model->high_patches[i], model->high.padded);
    ARRAY(t, model->places[i].rows, (size_t)TB_RINGS * model->body.row_count);
    ARRAY(t, model->places[i].waves, (size_t)TB_RINGS * cosines);
  }
  for (uint32_t i = 0; i <= TABOR_MAX_STRIKERS; i++) {
    ARRAY(t, model->patches[i], model->body.zero_count);
  }
  ARRAY(t, model->palm_patch, model->body.zero_count);
}

void tb_model_arrays(TbTransfer *t, TaborModel *model) {
  const uint32_t padded = model->modes.padded;
  list_body(t, &model->body);
  list_wires(t, &model->wires);
  list_modes(t, &model->modes);
  list_mics(t, model);
  list_power(t, &model->power);
  list_high_band(t, &model->high, model->wires.stride);
  list_strikers(t, model);
  list_rest(t, model);
  list_resting(t, model);
  list_projection(t, &model->projection);
  list_compliance(t, &model->compliance);
  list_wire_gridf(t, &model->wire_gridf);
  list_compliancef(t, &model->compliancef);
  list_stretch(t, &model->stretch, padded);
  list_plate(t, &model->plate);
  list_cascade(t, &model->cascade);
  list_force(t, &model->rod, padded);
  list_force(t, &model->hihat_air.volume, padded);
  list_lugs(t, &model->lugs);
  ARRAY(t, model->yield, tb_row_count(&model->rows));
  ARRAY(t, model->reach, padded);
  ARRAY(t, model->center, padded);
}
