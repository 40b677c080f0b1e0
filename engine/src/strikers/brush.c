/* SPDX-License-Identifier: MIT */
#include "strikers/brush.h"

#include <math.h>

#include "math/draw.h"
#include "math/portable_math.h"
#include "strikers/head_coating.h"
#include "strikers/striker_hold.h"

static const double COATING = 2.5e-5; /* root mean square of the coating's height [m] */

/* The fan comes down aslant: groups land one after another, over this part of its radius. */
static const double SLANT = 0.05;
/* Wires that are slapped down slide outwards at this part of the speed of the stroke, and come to
 * rest. */
static const double SPLAY = 0.3, SPLAY_TIME = 0.01; /* [s] */
/* From the middle of the fan to that of a group, in parts of its radius: the mean of an even disc.
 */
static const double GROUP_RADIUS = 2.0 / 3.0;

static const double WIRE_RESISTANCE = 0.0135; /* of one wire: see brush.h [N s/m] */

/* How long a wave takes along a wire of 0.1 m and back, at the 45 m/s of 200 Hz. */
static const double WAVE_TIME = 0.0045; /* [s] */

static const double LAYING = 0.05; /* speed of a brush that is laid down [m/s] */
static const double LIFTING = 0.5, LIFTING_TIME = 0.2; /* pull of a hand that lifts [N]; most [s] */
static const double LIFTED = 0.005;                    /* [m] */
static const double PRESSING_TIME = 0.01;              /* [s] */
static const double FASTEST = 5.0;                     /* [m/s] */
static const double HAND_TIME = 0.01;                  /* T [s] */
static const double SOONEST = 0.005, LATEST = 0.1;     /* of a move that does not say [s] */
static const double STRIDE = 2e-3, STRIDE_TIME = 3e-3; /* [m], [s] */
static const double LEAST_TURN = 0.02;                 /* radius of the tightest turn [m] */
static const double STILL = 1e-9;                      /* per sample: no motion [m] */
static const double DEGREES = 57.295779513082320877;

static uint32_t slot_of(uint32_t brush, uint32_t group) {
  return TB_BRISTLES + brush * TB_BRISTLE_GROUPS + group;
}

static bool is_there(const TbView *view, uint32_t slot) {
  return tb_slot_in_play(tb_slot(view, slot));
}

/* Seed of a group's track, and of what else is drawn for it. */
static uint64_t seed_of(const TbBrush *brush, uint32_t group) {
  return brush->seed + ((uint64_t)group + 1u) * 0xD1B54A32D192ED03u;
}

/* ---- places ---------------------------------------------------------------------------------- */

typedef struct Place {
  double radius, angle; /* [m], [deg] */
} Place;

/* Place of a group whose brush has its middle at x, y. */
static Place place_of(const TbView *view, const TbBrush *brush, uint32_t group) {
  const double spread = GROUP_RADIUS * view->model->def.striker[brush->definition].spread;
  double sine, cosine;
  tb_sin_cos_degrees(90.0 + 360.0 / TB_BRISTLE_GROUPS * group, &sine, &cosine);
  const double x = brush->x + spread * cosine, y = brush->y + spread * sine;
  const double ring = tb_brush_shapes_ring(view->model, brush->definition, sqrt(x * x + y * y));
  return (Place){ring, tb_arc_degrees(y, x)};
}

static double coat_height(const TbView *view, const TbBrush *brush, uint32_t group) {
  const double wires = view->model->def.striker[brush->definition].bristles;
  return COATING / sqrt(wires / TB_BRISTLE_GROUPS) *
         tb_head_coating_height(seed_of(brush, group), brush->track);
}

/* Metres that a group sticks where it is. */
static double stride(const TbView *view, const TbBrush *brush, uint32_t group, double way) {
  const double fast = way * view->model->step_rate * STRIDE_TIME;
  const double mean = fast > STRIDE ? fast : STRIDE;
  const uint64_t number = view->state->clock;
  return mean * (1.0 + 0.5 * tb_draw(~seed_of(brush, group), number));
}

/* ---- strokes --------------------------------------------------------------------------------- */

static void take_away(TbView *view, uint32_t b) {
  for (uint32_t g = 0; g < TB_BRISTLE_GROUPS; g++) {
    if (is_there(view, slot_of(b, g))) tb_pool_take_away(view, slot_of(b, g));
  }
  view->state->strikers.brushes[b] = (TbBrush){0};
}

static void lift(TbView *view, TbBrush *brush) {
  if (brush->lifting) return;
  brush->lifting = (uint32_t)(LIFTING_TIME * view->model->step_rate) + 1u;
  brush->press = -LIFTING;
}

static bool sounded(const TbView *view, uint32_t b) {
  for (uint32_t g = 0; g < TB_BRISTLE_GROUPS; g++) {
    if (tb_slot(view, slot_of(b, g))->striker.sounded) return true;
  }
  return false;
}

/* Rank for being replaced: 3 is free, 0 must stay. */
static uint32_t spare(const TbView *view, uint32_t b, uint32_t id) {
  const TbBrush *brush = &view->state->strikers.brushes[b];
  if (!brush->active) return 3;
  if (brush->lifting && sounded(view, b)) return 2;
  return id != 0 && brush->id == id;
}

/* One that is free, or made so; TB_BRUSHES if none. A hand holds one brush. */
static uint32_t obtain(TbView *view, uint32_t id) {
  uint32_t best = 0;
  for (uint32_t b = 1; b < TB_BRUSHES; b++) {
    if (spare(view, b, id) > spare(view, best, id)) best = b;
  }
  if (spare(view, best, id) == 0) return TB_BRUSHES;
  if (spare(view, best, id) < 3) {
    view->state->ledger.statistics.dropped_events += !sounded(view, best);
    take_away(view, best);
  }
  for (uint32_t b = 0; b < TB_BRUSHES && id != 0; b++) {
    TbBrush *brush = &view->state->strikers.brushes[b];
    if (brush->active && brush->id == id) lift(view, brush);
  }
  return best;
}

static double clamp(double value, double minimum, double maximum) {
  return value < minimum ? minimum : (value > maximum ? maximum : value);
}

/* Around the centre; a turn tighter than LEAST_TURN is as fast as that. */
static void go_around(const TbView *view, TbBrush *brush, double velocity) {
  const double speed = clamp(velocity, -FASTEST, FASTEST) * view->model->time_step;
  const double radius = brush->radius > LEAST_TURN ? brush->radius : LEAST_TURN;
  brush->around = speed / radius * DEGREES;
}

static bool is_sweep(const TbStroke *stroke) { return stroke->technique == TABOR_TECHNIQUE_SWEEP; }

static void begin(TbView *view, uint32_t b, const TbStroke *stroke) {
  TbState *state = view->state;
  TbBrush *brush = &state->strikers.brushes[b];
  double sine, cosine;
  tb_sin_cos_degrees(stroke->angle, &sine, &cosine);
  *brush = (TbBrush){.active = 1,
                     .id = stroke->id,
                     .definition = stroke->striker,
                     .seed = ++state->strikers.serial * 0x9E3779B97F4A7C15u,
                     .moved = state->clock,
                     .radius = stroke->radius,
                     .angle = stroke->angle,
                     .x = stroke->radius * cosine,
                     .y = stroke->radius * sine};
  if (is_sweep(stroke)) {
    go_around(view, brush, stroke->velocity);
  } else {
    brush->slide = SPLAY * stroke->velocity * view->model->time_step;
  }
}

static void put_group(TbView *view, uint32_t b, uint32_t group, const TbStroke *stroke) {
  const TbBrush *brush = &view->state->strikers.brushes[b];
  const TaborStrikerDef *def = &view->model->def.striker[stroke->striker];
  const Place place = place_of(view, brush, group);
  const bool wires = view->model->def.quality.losses != 0;
  const TbSlot striker = {
    .kind = TB_SLOT_BRISTLES,
    .id = stroke->id,
    .serial = view->state->strikers.serial,
    .radius = place.radius,
    .angle = place.angle,
    .striker = {.mass = def->mass / TB_BRISTLE_GROUPS,
                .part = 1.0 / TB_BRISTLE_GROUPS,
                .velocity = is_sweep(stroke) ? LAYING : stroke->velocity,
                .definition = stroke->striker},
    .hold = {.resistance = wires ? WIRE_RESISTANCE * def->bristles / TB_BRISTLE_GROUPS : 0.0},
    .bristles = {.coat = coat_height(view, brush, group), .due = stride(view, brush, group, 0.0)}};
  const uint32_t slot = slot_of(b, group);
  const double above = is_sweep(stroke) ? 0.0 : SLANT * def->spread * group / TB_BRISTLE_GROUPS;
  tb_pool_put(view, slot, &striker, above);
  tb_hold(view, slot, 0.0);
  if (!is_sweep(stroke))
    tb_slot(view, slot)->hold.push = striker.hold.resistance * stroke->velocity;
}

static void hold(TbView *view, uint32_t b, double pressure) {
  TbBrush *brush = &view->state->strikers.brushes[b];
  brush->press = tb_hold_force(pressure);
  brush->lifting = 0;
}

bool tb_brush_strike(TbView *view, const TbStroke *stroke) {
  const uint32_t b = obtain(view, stroke->id);
  if (b == TB_BRUSHES) return false;
  begin(view, b, stroke);
  for (uint32_t g = 0; g < TB_BRISTLE_GROUPS; g++) put_group(view, b, g, stroke);
  const bool buzz = stroke->technique == TABOR_TECHNIQUE_BUZZ;
  if (is_sweep(stroke) || buzz) {
    hold(view, b, stroke->pressure);
  } else {
    lift(view, &view->state->strikers.brushes[b]);
  }
  view->state->ledger.statistics.strikes++;
  return true;
}

/* ---- hands ----------------------------------------------------------------------------------- */

static bool is_meant(const TbBrush *brush, uint32_t id) {
  return brush->active && (id == 0 || brush->id == id);
}

/* Seconds that a move takes which does not say: as long as since the last, of which a controller's
 * second half, right behind its first, is no part. */
static double usual_time(const TbView *view, const TbBrush *brush) {
  const double passed = (double)(view->state->clock - brush->moved) * view->model->time_step;
  if (passed < SOONEST && brush->left > 0) return (double)brush->left * view->model->time_step;
  return clamp(passed, SOONEST, LATEST);
}

static double shorter_way(double from, double to) {
  const double turns = (to - from) / 360.0;
  const int64_t whole = (int64_t)(turns + (turns < 0.0 ? -0.5 : 0.5));
  return to - from - 360.0 * (double)whole;
}

static void aim(const TbView *view, TbBrush *brush, double radius, double angle, double seconds) {
  if (seconds <= 0.0) seconds = usual_time(view, brush);
  brush->left = (uint32_t)(seconds * view->model->step_rate) + 1u;
  brush->along = (radius - brush->radius) / (double)brush->left;
  brush->around = shorter_way(brush->angle, angle) / (double)brush->left;
  brush->moved = view->state->clock;
}

bool tb_brush_move(TbView *view, uint32_t id, double radius, double angle, double seconds) {
  bool found = false;
  for (uint32_t b = 0; b < TB_BRUSHES; b++) {
    TbBrush *brush = &view->state->strikers.brushes[b];
    if (!is_meant(brush, id)) continue;
    aim(view, brush, radius, angle, seconds);
    found = true;
  }
  return found;
}

bool tb_brush_press(TbView *view, uint32_t id, double pressure) {
  bool found = false;
  for (uint32_t b = 0; b < TB_BRUSHES; b++) {
    if (!is_meant(&view->state->strikers.brushes[b], id)) continue;
    hold(view, b, pressure);
    found = true;
  }
  return found;
}

void tb_brush_release(TbView *view, uint32_t id) {
  for (uint32_t b = 0; b < TB_BRUSHES; b++) {
    TbBrush *brush = &view->state->strikers.brushes[b];
    if (!is_meant(brush, id)) continue;
    lift(view, brush);
  }
}

/* ---- step ------------------------------------------------------------------------------------ */

static void move_aim(TbBrush *brush) {
  brush->angle += brush->around;
  if (brush->left == 0) return;
  brush->radius += brush->along;
  if (--brush->left == 0) brush->along = brush->around = 0.0;
}

/* One step of p_tt = (P - p)/T^2 - 2 p_t/T, exact for a P that stands still; returns the way. */
static double follow_aim(const TbView *view, TbBrush *brush) {
  const double t = view->model->time_step / HAND_TIME;
  const double decay = 1.0 / (1.0 + t * (1.0 + 0.5 * t * (1.0 + t / 3.0)));
  double sine, cosine;
  tb_sin_cos_degrees(brush->angle, &sine, &cosine);
  const double off_x = brush->x - brush->radius * cosine, off_y = brush->y - brush->radius * sine;
  const double carry_x = brush->dx + t * off_x, carry_y = brush->dy + t * off_y;
  brush->dx = (brush->dx - t * carry_x) * decay;
  brush->dy = (brush->dy - t * carry_y) * decay;
  const double most = FASTEST * view->model->time_step;
  double way = sqrt(brush->dx * brush->dx + brush->dy * brush->dy);
  if (way > most) {
    brush->dx *= most / way;
    brush->dy *= most / way;
    way = most;
  }
  if (way < STILL * view->model->time_step && brush->around == 0.0 && brush->left == 0) {
    brush->dx = brush->dy = way = 0.0;
  }
  brush->x += brush->dx;
  brush->y += brush->dy;
  return way;
}

static void draw_on(TbView *view, uint32_t b, uint32_t group, double way) {
  const TbBrush *brush = &view->state->strikers.brushes[b];
  TbSlot *s = tb_slot(view, slot_of(b, group));
  const Place place = place_of(view, brush, group);
  s->bristles.due = brush->way + stride(view, brush, group, way);
  tb_pool_draw(view, slot_of(b, group), place.radius, place.angle);
}

static void press_on(TbView *view, const TbBrush *brush, TbSlot *s) {
  const double k = view->model->time_step;
  s->hold.press += (brush->press - s->hold.press) * (k / (k + PRESSING_TIME));
  s->hold.push *= 1.0 - k / WAVE_TIME;
}

static bool is_lifted(const TbView *view, const TbBrush *brush, uint32_t slot) {
  if (!brush->lifting) return false;
  return brush->lifting == 1 || view->now.eta[tb_slot_row(&view->model->rows, slot)] < -LIFTED;
}

static void step_group(TbView *view, uint32_t b, uint32_t group, double way, bool slides) {
  const TbBrush *brush = &view->state->strikers.brushes[b];
  const uint32_t slot = slot_of(b, group);
  TbSlot *s = tb_slot(view, slot);
  if (is_lifted(view, brush, slot)) {
    tb_pool_take_away(view, slot);
    return;
  }
  press_on(view, brush, s);
  if (slides) tb_pool_raise(view, slot, coat_height(view, brush, group) - s->bristles.coat);
  if (brush->way >= s->bristles.due) draw_on(view, b, group, way);
}

static void step_brush(TbView *view, uint32_t b) {
  TbBrush *brush = &view->state->strikers.brushes[b];
  move_aim(brush);
  const double way = follow_aim(view, brush);
  brush->way += way;
  brush->track += way + brush->slide;
  const bool slides = way > 0.0 || brush->slide > 0.0;
  brush->slide *= 1.0 - view->model->time_step / SPLAY_TIME;
  if (brush->slide < STILL) brush->slide = 0.0;
  bool there = false;
  for (uint32_t g = 0; g < TB_BRISTLE_GROUPS; g++) {
    if (!is_there(view, slot_of(b, g))) continue;
    step_group(view, b, g, way, slides);
    there = true;
  }
  if (brush->lifting) brush->lifting--;
  if (!there) *brush = (TbBrush){0};
}

void tb_brush_step(TbView *view) {
  for (uint32_t b = 0; b < TB_BRUSHES; b++) {
    if (view->state->strikers.brushes[b].active) step_brush(view, b);
  }
}

bool tb_brush_moves(const TbState *state) {
  for (uint32_t b = 0; b < TB_BRUSHES; b++) {
    const TbBrush *brush = &state->strikers.brushes[b];
    if (!brush->active) continue;
    if (brush->lifting || brush->left || brush->around != 0.0 || brush->slide > 0.0) return true;
    if (brush->dx != 0.0 || brush->dy != 0.0) return true;
  }
  return false;
}

uint32_t tb_brush_count(const TbState *state) {
  uint32_t count = 0;
  for (uint32_t b = 0; b < TB_BRUSHES; b++) count += state->strikers.brushes[b].active;
  return count;
}

/* Its paths are per step, and its times in steps. */
static TbBrush brush_at_steps(TbBrush brush, uint64_t clock, double ratio) {
  if (ratio == 1.0) return brush;
  double *const paths[] = {&brush.along, &brush.around, &brush.dx, &brush.dy, &brush.slide};
  for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) *paths[i] *= ratio;
  brush.left = tb_steps_left(brush.left, ratio);
  brush.lifting = tb_steps_left(brush.lifting, ratio);
  brush.moved = clock - (uint64_t)((double)(clock - brush.moved) / ratio);
  return brush;
}

void tb_brush_carry(const TbView *from, TbView *to, double ratio) {
  for (uint32_t b = 0; b < TB_BRUSHES; b++) {
    to->state->strikers.brushes[b] =
      brush_at_steps(from->state->strikers.brushes[b], from->state->clock, ratio);
  }
}
