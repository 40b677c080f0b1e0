/* SPDX-License-Identifier: MIT */
#include "model/plate_coupling.h"

#include <math.h>

#include "math/portable_math.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;

/* It acts at least so often [Hz]: its images then lie beyond what is heard. By quality. */
static const double LEAST_RATE[] = {0.0, 22000.0, 22000.0, 44000.0, 44000.0};
/* Part of the scale of energy. */
static const double QUIET = 1e-3;

/* The motion of the whole plate bends nothing. */
static bool is_rigid(const TbBodyMode *mode) { return mode->m < 2 && mode->n == 0; }

/* Row of a coupled mode, or TB_NO_MODE of one that is rigid. */
static uint32_t row_of(const TaborModel *model, uint32_t m, uint32_t place) {
  const uint32_t row = model->body.orders[m].rows[place];
  return is_rigid(&model->body.modes[row]) ? TB_NO_MODE : row;
}

static uint32_t pairs_of(const TaborModel *model, uint32_t m) {
  uint32_t pairs = 0;
  for (uint32_t i = 0; i < model->body.membrane.orders[m].modes; i++) {
    pairs += row_of(model, m, i) != TB_NO_MODE;
  }
  return pairs;
}

/* Orders that have pairs, or functions of stress. */
static uint32_t orders_with(const TaborModel *model, bool stresses) {
  uint32_t orders = 0;
  for (uint32_t m = 0; m < model->body.membrane.order_count; m++) {
    const TbMembraneOrder *order = &model->body.membrane.orders[m];
    if (stresses ? order->stresses : pairs_of(model, m)) orders = m + 1u;
  }
  return orders;
}

/* So many that no product of two modes and a function of stress is mistaken for another. */
static uint32_t angles_for(const TbVonKarman *tables) {
  const uint32_t least = 2u * tables->orders + tables->stress_orders;
  uint32_t angles = 16;
  while (angles < least) angles *= 2u;
  return angles;
}

/* Room for the tables, which are filled by those of the same names below. */
typedef struct Room {
  uint32_t *first, *first_stress;
  float *curvature, *stress, *rise, *ring, *cosine, *sine;
} Room;

static uint32_t count_all(const TaborModel *model, const TbVonKarman *tables, Room *room) {
  uint32_t products = 0;
  for (uint32_t m = 0; m < tables->orders; m++) {
    room->first[m + 1u] = room->first[m] + pairs_of(model, m);
  }
  for (uint32_t m = 0; m < tables->stress_orders; m++) {
    const uint32_t stresses = model->body.membrane.orders[m].stresses;
    room->first_stress[m + 1u] = room->first_stress[m] + stresses;
    products += stresses * (room->first[m + 1u] - room->first[m]);
  }
  return products;
}

static float *take_floats(TaborModel *model, size_t count) {
  return tb_arena_take(&model->arena, count + 1u, sizeof(float));
}

static void fill_circle(const TbMembrane *membrane, const TbVonKarman *tables, Room *room) {
  for (uint32_t i = 0; i < tables->angles; i++) {
    double sine, cosine;
    tb_sin_cos(2.0 * PI * i / tables->angles, &sine, &cosine);
    room->cosine[i] = (float)cosine;
    room->sine[i] = (float)sine;
  }
  for (uint32_t i = 0; i < tables->points; i++) {
    room->ring[i] = (float)(membrane->ring[i] * 2.0 * PI / tables->angles);
  }
}

static void fill_floats(size_t count, const double *from, float *to) {
  for (size_t i = 0; i < count; i++) to[i] = (float)from[i];
}

static void fill_order(const TaborModel *model, const TbVonKarman *tables, uint32_t m, Room *room,
                       float **rise) {
  const TbMembraneOrder *order = &model->body.membrane.orders[m];
  const size_t shape = (size_t)3u * tables->points;
  uint32_t pair = room->first[m];
  for (uint32_t i = 0; i < order->modes; i++) {
    if (row_of(model, m, i) == TB_NO_MODE) continue;
    fill_floats(shape, order->curvature + shape * i, room->curvature + shape * pair++);
  }
  if (m >= tables->stress_orders) return;
  fill_floats((size_t)order->stresses * tables->points, order->stress,
              room->stress + (size_t)room->first_stress[m] * tables->points);
  for (uint32_t j = 0; j < order->stresses; j++) {
    for (uint32_t i = 0; i < order->modes; i++) {
      if (row_of(model, m, i) == TB_NO_MODE) continue;
      *(*rise)++ = (float)order->rise[(size_t)j * order->modes + i];
    }
  }
}

/* The places of each pair's copies among the modes. */
static void find_modes(TaborModel *model, TbPlateCoupling *plate) {
  const TbModes *modes = &model->modes;
  uint32_t pair = 0;
  for (uint32_t m = 0; m < plate->tables.orders; m++) {
    for (uint32_t i = 0; i < model->body.membrane.orders[m].modes; i++) {
      const uint32_t row = row_of(model, m, i);
      if (row == TB_NO_MODE) continue;
      plate->mode[2u * pair] = plate->mode[2u * pair + 1u] = TB_NO_MODE;
      for (uint32_t at = 0; at < modes->padded; at++) {
        if (modes->row[at] == row) plate->mode[2u * pair + modes->sine[at]] = at;
      }
      pair++;
    }
  }
}

static TaborStatus fill_tables(TaborModel *model) {
  TbPlateCoupling *plate = &model->plate;
  TbVonKarman *tables = &plate->tables;
  const size_t points = tables->points;
  Room room = {.first = tb_arena_take(&model->arena, tables->orders + 1u, sizeof *room.first),
               .first_stress = tb_arena_take(&model->arena, tables->stress_orders + 1u,
                                             sizeof *room.first_stress)};
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  const uint32_t products = count_all(model, tables, &room);
  tables->pairs = room.first[tables->orders];
  room.curvature = take_floats(model, 3u * points * tables->pairs);
  room.stress = take_floats(model, points * room.first_stress[tables->stress_orders]);
  room.rise = take_floats(model, products);
  room.ring = take_floats(model, points);
  room.cosine = take_floats(model, tables->angles);
  room.sine = take_floats(model, tables->angles);
  plate->mode = tb_arena_take(&model->arena, 2u * tables->pairs + 1u, sizeof *plate->mode);
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  fill_circle(&model->body.membrane, tables, &room);
  float *rise = room.rise;
  for (uint32_t m = 0; m < tables->orders; m++) fill_order(model, tables, m, &room, &rise);
  find_modes(model, plate);
  tables->first = room.first;
  tables->first_stress = room.first_stress;
  tables->curvature = room.curvature;
  tables->stress = room.stress;
  tables->rise = room.rise;
  tables->ring = room.ring;
  tables->cosine = room.cosine;
  tables->sine = room.sine;
  return TABOR_OK;
}

TaborStatus tb_plate_coupling_prepare(TaborModel *model) {
  const TbMembrane *membrane = &model->body.membrane;
  TbPlateCoupling *plate = &model->plate;
  *plate = (TbPlateCoupling){.every = 1};
  if (membrane->points == 0) return TABOR_OK;
  const TaborHeadDef *sheet = &model->body.sheet[0];
  const double slenderness =
    sheet->surface_density / (model->def.plate.density * model->body.radius);
  while ((plate->every + 1u) * LEAST_RATE[model->quality] <= model->step_rate) plate->every++;
  plate->scale = sheet->bending_stiffness * slenderness * slenderness;
  plate->quiet = QUIET * plate->scale;
  plate->tables = (TbVonKarman){.points = membrane->points,
                                .orders = orders_with(model, false),
                                .stress_orders = orders_with(model, true)};
  if (plate->tables.stress_orders > plate->tables.orders)
    plate->tables.orders = plate->tables.stress_orders;
  plate->tables.angles = angles_for(&plate->tables);
  return fill_tables(model);
}
