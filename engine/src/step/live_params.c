/* SPDX-License-Identifier: MIT */
#include "step/live_params.h"

#include <math.h>

#include "definition/params.h"
#include "heads/coupling.h"
#include "heads/pedal.h"
#include "step/energy.h"
#include "step/wire_clearance.h"
#include "strikers/striker_hold.h"
#include "strikers/striker_pool.h"

static const double TENSION_SLEW = 0.01 / 64.0; /* relative change per sample at most */
enum { WIRE_SAMPLES = 8 };                      /* that wires' tension and damping take at once */

static double definition_value(const TaborDrumDef *def, uint32_t index) {
  switch (index) {
  case TB_LIVE_TENSION: return def->wires.tension;
  case TB_LIVE_DAMPING_0: return def->wires.damping_0;
  case TB_LIVE_DAMPING_1: return def->wires.damping_1;
  case TB_LIVE_STRAINER: return def->wires.strainer;
  case TB_LIVE_MUFFLE: return def->batter.muffle_strength;
  case TB_LIVE_MUFFLE_RESONANT: return def->resonant.muffle_strength;
  case TB_LIVE_FULL_SCALE: return def->full_scale;
  case TB_LIVE_GRIP: return def->hand.grip;
  case TB_LIVE_OPENING: return def->hihat.opening;
  default: return index - TB_LIVE_GAIN < def->mic_count ? def->mic[index - TB_LIVE_GAIN].gain : 1.0;
  }
}

static double clamp(double value, double minimum, double maximum) {
  return value < minimum ? minimum : (value > maximum ? maximum : value);
}

/* Applies the live values to one wire. */
static void apply_wire(TbView *view, uint32_t w) {
  const TaborModel *model = view->model;
  const TbWire *wire = &model->wires.wires[w];
  const TbLiveParam *live = view->state->live.values;
  const bool lossless = model->def.quality.losses == 0;
  double tension = wire->tension;
  if (!wire->own_tension) tension *= live[TB_LIVE_TENSION].now / model->def.wires.tension;
  double damping_0 = wire->own_damping_0 ? wire->damping_0 : live[TB_LIVE_DAMPING_0].now;
  double damping_1 = wire->own_damping_1 ? wire->damping_1 : live[TB_LIVE_DAMPING_1].now;
  if (lossless) damping_0 = damping_1 = 0.0;
  tb_wire_coefficients(wire, model->time_step, clamp(tension, 0.0, wire->tension_limit), damping_0,
                       clamp(damping_1, 0.0, wire->damping_1_limit),
                       &view->state->wires.coefficients[w]);

  const double ends =
    wire->rest_offset + (1.0 - live[TB_LIVE_STRAINER].now) * model->wires.strainer_travel;
  const double shift = model->rest.offset[w] - ends;
  const double change = shift - view->state->wires.shift[w];
  view->state->wires.shift[w] = shift;
  if (change == 0.0) return;
  for (uint32_t row = wire->first_row; row < wire->first_row + wire->row_count; row++) {
    view->now.eta[row] += change;
    view->last.eta[row] += change;
  }
}

void tb_live_params_apply(TbView *view) {
  const TbWires *wires = &view->model->wires;
  for (uint32_t w = 0; w < wires->count; w++) apply_wire(view, w);
  for (uint32_t row = 0; row < wires->stride; row++) {
    view->contact_compliance[row] =
      wires->real[row] * view->state->wires.coefficients[wires->row_wire[row]].compliance;
  }
  tb_coupling_renew(view);
}

void tb_live_params_definition(const TaborModel *model, TbLiveParam *live) {
  for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
    const double value = definition_value(&model->def, i);
    live[i] = (TbLiveParam){.now = value, .target = value};
  }
}

void tb_live_params_reset(TbView *view) {
  tb_live_params_definition(view->model, view->state->live.values);
  view->state->live.output = (TbLiveParam){.now = 1.0, .target = 1.0};
  tb_pool_muffle(view);
  tb_live_params_apply(view);
}

/* The parameters, in the order of TbLiveIndex; the gain stands for those of all microphones. */
static const uint32_t PARAMETERS[TB_LIVE_GAIN + 1] = {
  [TB_LIVE_TENSION] = TB_PARAM_WIRES_TENSION,
  [TB_LIVE_DAMPING_0] = TB_PARAM_WIRES_DAMPING_0,
  [TB_LIVE_DAMPING_1] = TB_PARAM_WIRES_DAMPING_1,
  [TB_LIVE_STRAINER] = TB_PARAM_WIRES_STRAINER,
  [TB_LIVE_MUFFLE] = TB_PARAM_BATTER + TB_HEAD_MUFFLE_STRENGTH,
  [TB_LIVE_MUFFLE_RESONANT] = TB_PARAM_RESONANT + TB_HEAD_MUFFLE_STRENGTH,
  [TB_LIVE_FULL_SCALE] = TB_PARAM_OUTPUT_FULL_SCALE,
  [TB_LIVE_GRIP] = TB_PARAM_HAND_GRIP,
  [TB_LIVE_OPENING] = TB_PARAM_HIHAT_OPENING,
  [TB_LIVE_GAIN] = TB_PARAM_MIC_GAIN,
};

static int live_index(uint32_t parameter) {
  for (int i = 0; i <= TB_LIVE_GAIN; i++) {
    if (PARAMETERS[i] == parameter) return i;
  }
  return -1;
}

static bool in_range(const TbLiveParam *live, const TaborParameter *info) {
  return live->now >= info->minimum && live->now <= info->maximum &&
         live->target >= info->minimum && live->target <= info->maximum &&
         fabs(live->step) <= info->maximum - info->minimum;
}

bool tb_live_params_in_range(const TbState *state) {
  if (!tb_live_is_gain(&state->live.output) || !tb_stamp_is_right(&state->live.stamp)) return false;
  for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
    const uint32_t parameter = PARAMETERS[i < TB_LIVE_GAIN ? i : TB_LIVE_GAIN];
    if (!in_range(&state->live.values[i], &tb_param_by_id(parameter)->info)) return false;
  }
  return true;
}

static void move_to(TbLiveParam *live, double target, double rate) {
  tb_live_move(live, target, (uint32_t)(TB_LIVE_TIME * rate) + 1u);
}

bool tb_live_params_set(TbView *view, uint32_t parameter, uint32_t index, double value) {
  const TbParam *param = tb_param_by_id(parameter);
  const int first = live_index(parameter);
  if (!param || first < 0) return false;
  if (first == TB_LIVE_MUFFLE_RESONANT && view->model->body.surfaces < 2) return false;
  if (first == TB_LIVE_OPENING && view->model->rod.count == 0) return false;
  if (first == TB_LIVE_GAIN && index >= view->model->def.mic_count) return false;
  if (first == TB_LIVE_OPENING) view->state->live.stamp.phase = TB_STAMP_NONE;
  TbLiveParam *live = &view->state->live.values[first + (first == TB_LIVE_GAIN ? (int)index : 0)];
  move_to(live, clamp(value, param->info.minimum, param->info.maximum), view->model->step_rate);
  return true;
}

void tb_live_params_gain(TbView *view, double value, bool at_once) {
  TbLiveParam *output = &view->state->live.output;
  const double gain = clamp(value, 0.0, TB_LIVE_MOST_GAIN);
  move_to(output, gain, view->model->sample_rate);
  if (at_once) tb_live_move(output, gain, 0);
}

bool tb_live_params_keep(TbView *view, const TbLiveParam *live) {
  TbLiveParam *own = view->state->live.values;
  bool moves = false;
  for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
    const bool pushes = i < TB_LIVE_MUFFLE || i == TB_LIVE_OPENING;
    if (!pushes) own[i] = live[i];
    if (!pushes || live[i].target == own[i].now) continue;
    move_to(&own[i], live[i].target, view->model->step_rate);
    moves = true;
  }
  tb_pool_muffle(view);
  tb_live_params_apply(view);
  return moves;
}

/* The most that a value may change by in a step. */
static double slew(const TbView *view, uint32_t index) {
  const double now = view->state->live.values[index].now;
  if (index == TB_LIVE_TENSION) return now * TENSION_SLEW;
  if (index == TB_LIVE_OPENING) return tb_pedal_speed(view) * view->model->time_step;
  return INFINITY;
}

/* True if the value moved. A slow one stays under way until the limit lets it arrive. */
static bool advance(TbView *view, uint32_t index) {
  TbLiveParam *live = &view->state->live.values[index];
  if (live->left == 0) return false;
  const double before = live->now, most = slew(view, index);
  live->now = clamp(tb_live_next(live), before - most, before + most);
  if (live->left == 0 && live->now != live->target) live->left = 1;
  return true;
}

double tb_live_params_gain_step(TbState *state) { return tb_live_next(&state->live.output); }

static bool under_way(const TbLiveParam *live, uint32_t first, uint32_t end) {
  bool moving = false;
  for (uint32_t i = first; i < end; i++) moving |= live[i].left > 0;
  return moving;
}

static void advance_all(TbView *view, uint32_t first, uint32_t end) {
  for (uint32_t i = first; i < end; i++) advance(view, i);
}

/* Mufflers store no energy. */
static void move_mufflers(TbView *view) {
  if (!under_way(view->state->live.values, TB_LIVE_MUFFLE, TB_LIVE_FULL_SCALE)) return;
  advance_all(view, TB_LIVE_MUFFLE, TB_LIVE_FULL_SCALE);
  tb_pool_muffle(view);
}

/* The wires' ends move sample by sample: larger steps would knock. How tense and damped they are
 * does not. */
static void move_wires(TbView *view) {
  TbLiveParam *live = view->state->live.values;
  const bool ends = under_way(live, TB_LIVE_STRAINER, TB_LIVE_MUFFLE);
  const bool due = view->state->clock % WIRE_SAMPLES == 0;
  const bool strings = due && under_way(live, TB_LIVE_TENSION, TB_LIVE_STRAINER);
  if (!ends && !strings) return;
  tb_wire_clearance_end(view);
  const double before = tb_energy_wires(view, &view->now, &view->last);
  for (uint32_t i = 0; strings && i < WIRE_SAMPLES; i++) {
    advance_all(view, TB_LIVE_TENSION, TB_LIVE_STRAINER);
  }
  if (ends) advance_all(view, TB_LIVE_STRAINER, TB_LIVE_MUFFLE);
  tb_live_params_apply(view);
  view->state->ledger.sums.control += tb_energy_wires(view, &view->now, &view->last) - before;
}

void tb_live_params_step(TbView *view) {
  const TbLiveParam *live = view->state->live.values;
  for (uint32_t i = TB_LIVE_FULL_SCALE; i < TB_LIVE_COUNT; i++) {
    if (live[i].left == 0 || !advance(view, i)) continue;
    if (i == TB_LIVE_GRIP) tb_hold_regrip(view);
    if (i == TB_LIVE_OPENING) tb_pedal_follow(view);
  }
  move_mufflers(view);
  move_wires(view);
}
