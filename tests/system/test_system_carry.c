/* SPDX-License-Identifier: MIT */
/* What goes on and what ends when a drum with every kind of striker in play is swapped, replaced,
 * silenced or reset.
 *
 * usage: test_system_carry [brief]: of drums with fewer wires, and for a shorter time. */
#include "drum/drum.h"
#include "physics.h"

enum { SCENES = 3, BEFORE = 1200, AFTER = 2400, MOST_EVENTS = 16 };

static bool brief;
static TaborDrumDef def;

typedef struct Scene {
  TaborEvent events[MOST_EVENTS];
  uint32_t count;
} Scene;

/* A snare drum with both mufflers and every kind of striker; few modes. */
static TaborDrumDef small_snare(void) {
  TaborDrumDef small = physics_preset("snare-14x5.5");
  small.quality.two_way_bandwidth = 900.0;
  small.quality.bandwidth = 1800.0;
  small.quality.wire_points = 16;
  small.quality.newton_cap = 16;
  small.wires.count = 4;
  if (brief) {
    small.quality.bandwidth = 1200.0;
    small.quality.wire_points = 8;
    small.wires.count = 2;
  }
  small.batter.muffle_strength = 0.3;
  small.resonant.muffle_strength = 0.2;
  return small;
}

static uint32_t named(const char *name) {
  const int striker = tabor_drum_def_find_striker(&def, name);
  assert_true(striker >= 0);
  return (uint32_t)striker;
}

static void add(Scene *scene, TaborEvent event) {
  assert_true(scene->count < MOST_EVENTS);
  scene->events[scene->count++] = event;
}

static TaborEvent stroke(uint32_t frame, uint32_t id, const char *striker, uint32_t technique,
                         double velocity) {
  return (TaborEvent){.frame = frame,
                      .type = TABOR_EVENT_STRIKE,
                      .id = id,
                      .striker = named(striker),
                      .technique = technique,
                      .velocity = velocity,
                      .radius = 0.03 + 0.01 * id,
                      .angle = 47.0 * id,
                      .value = 0.5};
}

static TaborEvent hand(uint32_t frame, uint32_t id) {
  return (TaborEvent){.frame = frame,
                      .type = TABOR_EVENT_DAMP,
                      .id = id,
                      .radius = 0.08,
                      .angle = 200.0,
                      .value = 5.0};
}

static TaborEvent parameter(uint32_t frame, const char *key, double value) {
  return (TaborEvent){.frame = frame,
                      .type = TABOR_EVENT_PARAMETER,
                      .parameter = tabor_parameter_find(key)->id,
                      .value = value};
}

/* 0: free and pressed sticks, a rimshot, a hand. 1: a cross-stick with its palm, a stick on the
 * rim, one that is lifted. 2: brushes, one in a sweep, one in a slap. Values move in all, and stand
 * where the definition has them not. */
static Scene make_scene(int which) {
  Scene scene = {.count = 0};
  add(&scene, parameter(0, "resonant.muffle_strength", 0.4));
  add(&scene, parameter(0, "output.full_scale", 0.7 * def.full_scale));
  if (which == 0) {
    add(&scene, stroke(100, 1, "stick", TABOR_TECHNIQUE_BUZZ, 2.0));
    add(&scene, hand(300, 2));
    add(&scene, stroke(BEFORE - 60, 3, "stick", TABOR_TECHNIQUE_RIMSHOT, 3.0));
    add(&scene, parameter(BEFORE - 50, "wires.strainer", 0.8));
    add(&scene, stroke(BEFORE - 40, 4, "stick", TABOR_TECHNIQUE_NORMAL, 4.0));
    add(&scene, stroke(BEFORE - 5, 5, "stick", TABOR_TECHNIQUE_NORMAL, 3.0));
  } else if (which == 1) {
    add(&scene, stroke(200, 1, "stick", TABOR_TECHNIQUE_BUZZ, 1.0));
    add(&scene, stroke(BEFORE - 200, 2, "stick", TABOR_TECHNIQUE_CROSS_STICK, 3.0));
    add(&scene, parameter(BEFORE - 100, "batter.muffle_strength", 1.0));
    add(&scene, (TaborEvent){.frame = BEFORE - 60, .type = TABOR_EVENT_RELEASE, .id = 1});
    add(&scene, stroke(BEFORE - 10, 3, "stick", TABOR_TECHNIQUE_RIM, 3.0));
  } else {
    add(&scene, stroke(100, 1, "brush", TABOR_TECHNIQUE_SWEEP, 0.8));
    add(&scene, (TaborEvent){.frame = 300,
                             .type = TABOR_EVENT_MOVE,
                             .id = 1,
                             .radius = 0.1,
                             .angle = 90.0,
                             .value = 0.05});
    add(&scene, stroke(BEFORE - 30, 2, "brush", TABOR_TECHNIQUE_NORMAL, 2.0));
    add(&scene, stroke(BEFORE - 20, 3, "stick", TABOR_TECHNIQUE_NORMAL, 2.0));
  }
  return scene;
}

/* Plays the events of a scene that come in its frames from .. to; `output` may be NULL. */
static void play_scene(TaborDrum *drum, const Scene *scene, uint32_t from, uint32_t to,
                       float *output) {
  TaborEvent events[MOST_EVENTS];
  uint32_t count = 0;
  float *outputs[TABOR_MAX_MICS] = {output};
  for (uint32_t i = 0; i < scene->count; i++) {
    if (scene->events[i].frame < from || scene->events[i].frame >= to) continue;
    events[count] = scene->events[i];
    events[count++].frame -= from;
  }
  tabor_drum_process(drum, events, count, outputs, to - from);
}

static void play(TaborDrum *drum, uint32_t frames, float *output) {
  float *outputs[TABOR_MAX_MICS] = {output};
  tabor_drum_process(drum, NULL, 0, outputs, frames);
}

/* Sends a swap or a replacement, which acts before the next frame. */
static TaborSwap *send(TaborDrum *drum, TaborModel *to, uint32_t type) {
  TaborSwap *swap;
  TaborModel *const from = (TaborModel *)tabor_drum_model(drum);
  assert_int_equal(tabor_swap_create(from, to, &swap, NULL), TABOR_OK);
  const TaborEvent event = {.type = type, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 0);
  return swap;
}

static TaborStatistics counted(const TaborDrum *drum) {
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  return statistics;
}

static TaborLedger ledger_of(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  return ledger;
}

static void assert_closes(const TaborDrum *drum) {
  const TaborLedger ledger = ledger_of(drum);
  const TaborStatistics statistics = counted(drum);
  assert_int_equal(statistics.recovered, 0);
  assert_int_equal(statistics.newton_capped, 0);
  const double moved = ledger.injected + fabs(ledger.control);
  if (fabs(ledger.residual) > 1e-9 * moved) {
    fail_msg("residual %.3g of %.3g J", ledger.residual, moved);
  }
}

static bool is_near(double a, double b, double tolerance) {
  return (isnan(a) && isnan(b)) || fabs(a - b) <= tolerance * (fabs(a) + fabs(b)) + 1e-15;
}

/* A tip that passes the rest height is near as far as the head has moved. */
static bool is_near_height(double a, double b, double head) {
  return is_near(a, b, 1e-5) || fabs(a - b) <= 1e-5 * fabs(head);
}

/* Forces may be as small as rounding leaves them. */
static bool is_near_force(double a, double b) {
  return is_near(a, b, 1e-3) || fabs(a - b) < 1e-5; /* [N] */
}

/* Every kind was there: nothing of the following would be tested otherwise. */
static void assert_scene(const TaborDrum *drum, int which) {
  uint32_t sticks = 0, held = 0, pairs = 0, hands = 0, palms = 0, leaving = 0, bristles = 0;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = &drum->state->strikers.slots[i];
    const bool bristly = slot->kind == TB_SLOT_BRISTLES;
    sticks += slot->kind == TB_SLOT_TIP && !slot->hold.held;
    held += slot->hold.held && !bristly && !slot->hold.leaving;
    pairs += slot->kind == TB_SLOT_END;
    hands += slot->kind == TB_SLOT_HAND;
    palms += slot->kind == TB_SLOT_PALM;
    leaving += slot->hold.leaving != 0 && !bristly;
    bristles += bristly;
  }
  if (which == 0) assert_true(sticks >= 2 && held == 1 && pairs == 2 && hands == 1);
  if (which == 1) assert_true(pairs == 2 && palms == 1 && leaving == 1 && sticks >= 1);
  if (which == 2) assert_true(bristles == 2 * TB_BRISTLE_GROUPS && sticks >= 1);
  assert_true(drum->state->strikers.slots[TB_MUFFLERS].kind == TB_SLOT_MUFFLER);
  assert_true(drum->state->strikers.slots[TB_MUFFLERS + 1].kind == TB_SLOT_MUFFLER);
}

/* Leaves what stands for something: not what was in a slot that is free now, nor what the next step
 * overwrites, nor the height at which hands begin, which follow the head. */
static void keep_what_counts(TbState *state) {
  const uint32_t scratch = (state->newest + 1) % 3;
  memset(state->strikers.z[scratch], 0, sizeof state->strikers.z[scratch]);
  memset(state->strikers.truncated[scratch], 0, sizeof state->strikers.truncated[scratch]);
  memset(state->strikers.bow[scratch], 0, sizeof state->strikers.bow[scratch]);
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    if (!tb_slot_strikes(&state->strikers.slots[i])) state->strikers.slots[i].rest_height = 0.0;
    if (state->strikers.slots[i].kind != TB_SLOT_FREE) continue;
    memset(&state->strikers.slots[i], 0, sizeof state->strikers.slots[i]);
    memset(&state->strikers.laws[i], 0, sizeof state->strikers.laws[i]);
    for (int instant = 0; instant < 3; instant++) {
      state->strikers.z[instant][i] = 0.0;
      memset(state->strikers.truncated[instant][i], 0,
             sizeof state->strikers.truncated[instant][i]);
      memset(state->strikers.bow[instant][i], 0, sizeof state->strikers.bow[instant][i]);
    }
  }
}

static TaborEvent late_stroke(uint32_t frame) {
  return stroke(frame, 9, "stick", TABOR_TECHNIQUE_NORMAL, 3.0);
}

/* ---- continuing ----------------------------------------------------------------------------- */

/* Onto a model of the same definition: as if nothing had been, to the bit, in whatever is saved. */
static void the_same_model_changes_nothing(void **state) {
  (void)state;
  static const uint32_t qualities[] = {TABOR_QUALITY_DRAFT, TABOR_QUALITY_STUDIO};
  static float sound[AFTER], expected[AFTER];
  for (int q = 0; q < 2; q++) {
    TaborModel *model = physics_model(&def, 48000.0, qualities[q]),
               *twin = physics_model(&def, 48000.0, qualities[q]);
    for (int which = 0; which < SCENES; which++) {
      Scene scene = make_scene(which);
      add(&scene, late_stroke(BEFORE + 100));
      TaborDrum *drum = physics_drum(model), *same = physics_drum(model);
      play_scene(drum, &scene, 0, BEFORE, NULL);
      play_scene(same, &scene, 0, BEFORE, NULL);
      assert_scene(drum, which);
      TaborSwap *swap = send(drum, twin, TABOR_EVENT_SWAP);
      assert_true(tabor_swap_done(swap));
      play_scene(drum, &scene, BEFORE, BEFORE + AFTER, sound);
      play_scene(same, &scene, BEFORE, BEFORE + AFTER, expected);
      assert_memory_equal(sound, expected, sizeof sound);
      /* The debt of the swap has been paid back. */
      TbState one_state = *drum->state, other_state = *same->state;
      keep_what_counts(&one_state);
      keep_what_counts(&other_state);
      one_state.newest = other_state.newest = 0;
      assert_memory_equal(&one_state, &other_state, sizeof one_state);
      const TaborLedger one = ledger_of(drum), other = ledger_of(same);
      assert_memory_equal(&one, &other, sizeof one);
      tabor_drum_destroy(drum);
      tabor_drum_destroy(same);
      tabor_swap_destroy(swap);
    }
    tabor_model_release(model);
    tabor_model_release(twin);
  }
}

/* A change of the head of one part in a billion: every striker stays where it is, as fast as it is,
 * and is pressed as hard; the ledger closes, and what is heard of it hardly differs. Without a high
 * band, which begins anew. */
static void a_slightly_other_model_changes_next_to_nothing(void **state) {
  (void)state;
  enum { LOOKS = 60 };
  TaborDrumDef one = def, other;
  one.quality.bandwidth = one.quality.two_way_bandwidth;
  other = one;
  other.batter.tension *= 1.0 + 1e-9;
  TaborModel *model = physics_model(&one, 96000.0, TABOR_QUALITY_STUDIO),
             *near = physics_model(&other, 96000.0, TABOR_QUALITY_STUDIO);
  for (int which = 0; which < SCENES; which++) {
    const Scene scene = make_scene(which);
    TaborDrum *drum = physics_drum(model), *same = physics_drum(model);
    play_scene(drum, &scene, 0, BEFORE, NULL);
    play_scene(same, &scene, 0, BEFORE, NULL);
    TaborSwap *swap = send(drum, near, TABOR_EVENT_SWAP);
    assert_int_equal(counted(drum).in_play, counted(same).in_play);
    const double control = ledger_of(drum).control - ledger_of(same).control;
    if (fabs(control) >= 1e-6 * ledger_of(same).stored)
      fail_msg("scene %d: %.3g J of control, %.3g J stored", which, control,
               ledger_of(same).stored);
    for (int look = 0; look < LOOKS; look++) {
      TaborProbe probe, expected;
      play(drum, 1, NULL);
      play(same, 1, NULL);
      tabor_drum_probe(drum, &probe);
      tabor_drum_probe(same, &expected);
      if (is_near(probe.head, expected.head, 1e-5) && is_near(probe.wire, expected.wire, 1e-5) &&
          is_near_height(probe.striker, expected.striker, expected.head) &&
          is_near_force(probe.striker_force, expected.striker_force) &&
          is_near_force(probe.wire_force, expected.wire_force))
        continue;
      fail_msg("scene %d, frame %d: head %g %g, wire %g %g, striker %g %g, force %g %g, %g %g",
               which, look, probe.head, expected.head, probe.wire, expected.wire, probe.striker,
               expected.striker, probe.striker_force, expected.striker_force, probe.wire_force,
               expected.wire_force);
    }
    for (uint32_t i = 0; i < TB_SLOTS; i++) {
      const TbView a = tb_view(drum->state, near), b = tb_view(same->state, model);
      const TbSlot *x = &drum->state->strikers.slots[i], *y = &same->state->strikers.slots[i];
      assert_int_equal(x->kind, y->kind);
      assert_true(x->age == y->age && x->hold.leaving == y->hold.leaving && x->serial == y->serial);
      if (!tb_slot_strikes(x)) continue;
      assert_true(is_near(a.now.z[i], b.now.z[i], 1e-4));
      assert_true(is_near(a.now.z[i] - a.last.z[i], b.now.z[i] - b.last.z[i], 1e-3));
      for (uint32_t n = 0; n < TB_TRUNCATED; n++) {
        assert_true(fabs(a.now.truncated[i][n] - b.now.truncated[i][n]) <=
                    1e-3 * fabs(b.now.truncated[i][n]) + 1e-12);
      }
    }
    play(drum, brief ? 500 : AFTER, NULL);
    play(same, brief ? 500 : AFTER, NULL);
    assert_int_equal(counted(drum).in_play, counted(same).in_play);
    assert_int_equal(counted(drum).strikes, counted(same).strikes);
    assert_closes(drum);
    assert_closes(same);
    tabor_drum_destroy(drum);
    tabor_drum_destroy(same);
    tabor_swap_destroy(swap);
  }
  tabor_model_release(model);
  tabor_model_release(near);
}

/* Live sees one step a sample, studio two: what lasts goes on for as long a time, and what moves as
 * fast. */
static void times_and_speeds_stay_when_steps_are_halved(void **state) {
  (void)state;
  TaborDrumDef one = def;
  one.quality.bandwidth = one.quality.two_way_bandwidth;
  TaborModel *live = physics_model(&one, 48000.0, TABOR_QUALITY_LIVE),
             *studio = physics_model(&one, 48000.0, TABOR_QUALITY_STUDIO);
  for (int way = 0; way < 2; way++) {
    TaborModel *from = way ? studio : live, *to = way ? live : studio;
    const double ratio = to->time_step / from->time_step;
    for (int which = 0; which < SCENES; which++) {
      const Scene scene = make_scene(which);
      TaborDrum *drum = physics_drum(from), *same = physics_drum(from);
      play_scene(drum, &scene, 0, BEFORE, NULL);
      play_scene(same, &scene, 0, BEFORE, NULL);
      TaborSwap *swap = send(drum, to, TABOR_EVENT_SWAP);
      const TbState *x = drum->state, *y = same->state;
      assert_int_equal(counted(drum).in_play, counted(same).in_play);
      for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
        assert_true(fabs(x->live.values[i].left * ratio - y->live.values[i].left) <= 1.0);
        assert_true(is_near(x->live.values[i].step, y->live.values[i].step * ratio, 1e-12));
        assert_true(x->live.values[i].now == y->live.values[i].now &&
                    x->live.values[i].target == y->live.values[i].target);
      }
      const TbView a = tb_view(drum->state, to), b = tb_view(same->state, from);
      for (uint32_t i = 0; i < TB_SLOTS; i++) {
        assert_int_equal(x->strikers.slots[i].kind, y->strikers.slots[i].kind);
        assert_true(
          fabs((double)x->strikers.slots[i].age * ratio - (double)y->strikers.slots[i].age) <= 1.0);
        assert_true(fabs(x->strikers.slots[i].hold.leaving * ratio -
                         y->strikers.slots[i].hold.leaving) <= 1.0);
        if (!tb_slot_strikes(&x->strikers.slots[i])) continue;
        assert_true(a.now.z[i] == b.now.z[i]);
        assert_true(is_near((a.now.z[i] - a.last.z[i]) / ratio, b.now.z[i] - b.last.z[i], 1e-9));
      }
      for (uint32_t i = 0; i < TB_BRUSHES; i++) {
        const TbBrush *m = &x->strikers.brushes[i], *n = &y->strikers.brushes[i];
        assert_int_equal(m->active, n->active);
        assert_true(is_near(m->along, n->along * ratio, 1e-12));
        assert_true(is_near(m->around, n->around * ratio, 1e-12));
        assert_true(is_near(m->dx, n->dx * ratio, 1e-12) && is_near(m->dy, n->dy * ratio, 1e-12));
        assert_true(is_near(m->slide, n->slide * ratio, 1e-12));
        assert_true(m->x == n->x && m->y == n->y && m->press == n->press);
        assert_true(fabs(m->left * ratio - n->left) <= 1.0);
        assert_true(fabs(m->lifting * ratio - n->lifting) <= 1.0);
        if (!m->active) continue;
        const double ago = (double)(x->clock - m->moved) * ratio;
        assert_true(fabs(ago - (double)(y->clock - n->moved)) <= 1.0);
      }
      play(drum, brief ? 2000 : 12000, NULL);
      play(same, brief ? 2000 : 12000, NULL);
      assert_int_equal(counted(drum).in_play, counted(same).in_play);
      for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
        assert_true(drum->state->live.values[i].now == same->state->live.values[i].now);
      }
      tabor_drum_destroy(drum);
      tabor_drum_destroy(same);
      tabor_swap_destroy(swap);
    }
  }
  tabor_model_release(live);
  tabor_model_release(studio);
}

/* A value that nobody moved becomes the new definition's; one that was moved stays. Mufflers
 * follow. */
static void live_values_stay_if_they_were_moved(void **state) {
  (void)state;
  TaborDrumDef other = def;
  other.batter.muffle_strength = 0.9;
  other.resonant.muffle_strength = 0.0;
  other.full_scale = 2.0 * def.full_scale;
  TaborModel *models[] = {physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT),
                          physics_model(&other, 48000.0, TABOR_QUALITY_DRAFT)};
  const Scene scene = make_scene(0); /* moves full scale and the resonant muffler */
  TaborDrum *drum = physics_drum(models[0]);
  play_scene(drum, &scene, 0, BEFORE, NULL);
  TaborSwap *swap = send(drum, models[1], TABOR_EVENT_SWAP);
  const TbLiveParam *live = drum->state->live.values;
  assert_true(live[TB_LIVE_MUFFLE].now == 0.9);
  assert_true(live[TB_LIVE_MUFFLE_RESONANT].now == 0.4);
  assert_true(live[TB_LIVE_FULL_SCALE].now == 0.7 * def.full_scale);
  assert_true(drum->state->strikers.slots[TB_MUFFLERS].resistance == 0.9);
  assert_true(drum->state->strikers.slots[TB_MUFFLERS + 1].resistance == 0.4);
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* A definition without brushes has nothing to go on with in a brush's place: the brush vanishes,
 * the stick stays. */
static void strikers_that_the_other_drum_lacks_vanish(void **state) {
  (void)state;
  TaborDrumDef other = def;
  const uint32_t brush = named("brush"), stick = named("stick");
  other.striker[brush] = other.striker[stick];
  (void)snprintf(other.striker[brush].name, sizeof other.striker[brush].name, "second");
  TaborModel *models[] = {physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO),
                          physics_model(&other, 48000.0, TABOR_QUALITY_STUDIO)};
  const Scene scene = make_scene(2);
  TaborDrum *drum = physics_drum(models[0]);
  play_scene(drum, &scene, 0, BEFORE, NULL);
  TaborSwap *swap = send(drum, models[1], TABOR_EVENT_SWAP);
  uint32_t bristles = 0, sticks = 0;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    bristles += drum->state->strikers.slots[i].kind == TB_SLOT_BRISTLES;
    sticks += tb_slot_strikes(&drum->state->strikers.slots[i]);
  }
  assert_int_equal(bristles, 0);
  assert_int_equal(sticks, 1);
  play(drum, AFTER, NULL);
  assert_closes(drum);
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* A microphone that only the new drum has is heard in full at once; one that both have passes from
 * one to the other. */
static void a_new_microphone_shares_with_nobody(void **state) {
  (void)state;
  enum { CROSSED = 768, UNTIL = 1200 }; /* 16 ms, as the engine has it */
  TaborDrumDef other = def;
  other.mic[other.mic_count] = def.mic[0];
  (void)snprintf(other.mic[other.mic_count].name, TABOR_NAME_SIZE, "extra");
  const uint32_t extra = other.mic_count++;
  TaborModel *models[] = {physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT),
                          physics_model(&other, 48000.0, TABOR_QUALITY_DRAFT)};
  const Scene scene = make_scene(0);
  TaborDrum *drum = physics_drum(models[0]), *former = physics_drum(models[0]),
            *alone = physics_drum(models[1]);
  static float sound[2][UNTIL], expected[2][UNTIL], old[UNTIL];
  play_scene(drum, &scene, 0, BEFORE, NULL);
  play_scene(former, &scene, 0, BEFORE, NULL);
  TaborSwap *swap = send(drum, models[1], TABOR_EVENT_SWAP);
  const size_t size = tabor_drum_state_size(drum);
  void *const saved = malloc(size);
  tabor_drum_state_save(drum, saved); /* without what fades */
  assert_int_equal(tabor_drum_state_load(alone, saved, size), TABOR_OK);
  free(saved);
  float *outputs[TABOR_MAX_MICS] = {sound[0]}, *alone_outputs[TABOR_MAX_MICS] = {expected[0]};
  outputs[extra] = sound[1];
  alone_outputs[extra] = expected[1];
  tabor_drum_process(drum, NULL, 0, outputs, UNTIL);
  tabor_drum_process(alone, NULL, 0, alone_outputs, UNTIL);
  play(former, UNTIL, old);
  assert_memory_equal(sound[1], expected[1], sizeof sound[1]);
  assert_memory_equal(sound[0], old, CROSSED / 2 * sizeof(float));
  for (uint32_t i = CROSSED; i < UNTIL; i++) assert_true(sound[0][i] == expected[0][i]);
  tabor_drum_destroy(drum);
  tabor_drum_destroy(former);
  tabor_drum_destroy(alone);
  tabor_swap_destroy(swap);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* Modes that creep back have no phase: from and to a head so damped they keep place and velocity.
 */
static void overdamped_modes_keep_place_and_velocity(void **state) {
  (void)state;
  TaborDrumDef slack = physics_preset("frame-drum");
  slack.shell.radius = 0.5;
  slack.batter.tension = 100.0;
  slack.batter.surface_density = 1.0;
  slack.batter.damping_0 = 1000.0;
  slack.quality.two_way_bandwidth = slack.quality.bandwidth = 600.0;
  TaborDrumDef loose = slack;
  loose.batter.damping_0 = 5.0;
  TaborModel *models[] = {physics_model(&slack, 96000.0, TABOR_QUALITY_STUDIO),
                          physics_model(&loose, 96000.0, TABOR_QUALITY_STUDIO)};
  for (int way = 0; way < 2; way++) {
    TaborDrum *drum = physics_drum(models[way]);
    const TaborEvent strike = physics_strike(&slack);
    tabor_drum_process(drum, &strike, 1, NULL, 300);
    const TbView before = tb_view(drum->state, models[way]);
    const uint32_t modes = before.model->modes.padded;
    double *const place = malloc(2 * modes * sizeof *place);
    memcpy(place, before.now.q, modes * sizeof *place);
    memcpy(place + modes, before.last.q, modes * sizeof *place);
    TaborSwap *swap = send(drum, models[1 - way], TABOR_EVENT_SWAP);
    const TbView after = tb_view(drum->state, models[1 - way]);
    assert_true(models[way]->body.modes[before.model->modes.row[0]].m ==
                models[1 - way]->body.modes[after.model->modes.row[0]].m);
    double most = 0.0;
    for (uint32_t i = 0; i < modes && i < after.model->modes.padded; i++) {
      most = fmax(most, fabs(place[i]));
      const TbBodyMode *mode = &models[0]->body.modes[models[0]->modes.row[i]];
      if (models[0]->modes.row[i] == TB_NO_MODE || mode->omega > mode->decay_rate) continue;
      assert_true(after.now.q[i] == place[i] && after.last.q[i] == place[modes + i]);
    }
    assert_true(most > 0.0);
    play(drum, 1000, NULL);
    assert_closes(drum);
    free(place);
    tabor_drum_destroy(drum);
    tabor_swap_destroy(swap);
  }
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* ---- beginning anew ------------------------------------------------------------------------- */

/* Counters, ledger, gain and debt apart, which go on through what leaves a drum at rest. */
static void assert_at_rest_like_new(const TaborDrum *drum, TaborModel *model) {
  TaborDrum *fresh = physics_drum(model);
  const size_t size = tb_state_bytes(model);
  TbState *const state = malloc(size);
  assert_non_null(state);
  memcpy(state, drum->state, size);
  state->ledger.sums = fresh->state->ledger.sums;
  state->ledger.radiated_beyond = fresh->state->ledger.radiated_beyond;
  state->ledger.statistics = fresh->state->ledger.statistics;
  state->live.output = fresh->state->live.output;
  state->event_debt = fresh->state->event_debt;
  assert_memory_equal(state, fresh->state, size);
  free(state);
  tabor_drum_destroy(fresh);
}

static void a_replacement_is_at_rest(void **state) {
  (void)state;
  TaborDrumDef other = def;
  other.batter.tension *= 1.1;
  TaborModel *models[] = {physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO),
                          physics_model(&other, 48000.0, TABOR_QUALITY_STUDIO)};
  static float sound[AFTER], expected[AFTER];
  for (int which = 0; which < SCENES; which++) {
    const Scene scene = make_scene(which);
    TaborDrum *drum = physics_drum(models[0]), *fresh = physics_drum(models[1]);
    play_scene(drum, &scene, 0, BEFORE, NULL);
    const TaborEvent gain = {.type = TABOR_EVENT_GAIN, .value = 0.5};
    tabor_drum_process(drum, &gain, 1, NULL, 300);
    const TaborStatistics before = counted(drum);
    const TaborLedger booked = ledger_of(drum);
    TaborSwap *swap = send(drum, models[1], TABOR_EVENT_REPLACE);
    assert_at_rest_like_new(drum, models[1]);
    const TaborStatistics after = counted(drum);
    assert_int_equal(after.in_play, 0);
    assert_int_equal(after.strikes, before.strikes);
    assert_int_equal(after.frames, before.frames);
    assert_true(ledger_of(drum).injected == booked.injected && ledger_of(drum).stored == 0.0);
    assert_closes(drum);
    assert_true(drum->state->live.output.now == 0.5);
    assert_false(tabor_drum_is_silent(drum)); /* the former drum rings out */
    play(drum, AFTER, NULL);
    assert_true(tabor_drum_is_silent(drum) && tabor_swap_done(swap));
    const TaborEvent strike = late_stroke(0);
    float *outputs[TABOR_MAX_MICS] = {sound}, *fresh_outputs[TABOR_MAX_MICS] = {expected};
    tabor_drum_process(drum, &strike, 1, outputs, AFTER);
    tabor_drum_process(fresh, &strike, 1, fresh_outputs, AFTER);
    for (int i = 0; i < AFTER; i++) assert_true(sound[i] == 0.5f * expected[i]);
    tabor_drum_destroy(drum);
    tabor_drum_destroy(fresh);
    tabor_swap_destroy(swap);
  }
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* Whatever has been played, a drum that was reset cannot be told from a new one, byte for byte. */
static void a_reset_leaves_a_new_drum(void **state) {
  (void)state;
  static float sound[AFTER], expected[AFTER];
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO),
             *twin = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  const TaborLedger nothing = {0};
  for (int which = 0; which < SCENES; which++) {
    const Scene scene = make_scene(which);
    TaborDrum *drum = physics_drum(model), *fresh = physics_drum(model);
    const TaborEvent gain = {.type = TABOR_EVENT_GAIN, .value = 0.5},
                     silence = {.type = TABOR_EVENT_SILENCE};
    play_scene(drum, &scene, 0, BEFORE, NULL);
    TaborSwap *swap = send(drum, twin, TABOR_EVENT_SWAP);
    TaborSwap *back = send(drum, model, TABOR_EVENT_SWAP);
    tabor_drum_process(drum, &gain, 1, NULL, 100);
    if (which == 1) tabor_drum_process(drum, &silence, 1, NULL, 10); /* its tail ends, too */
    tabor_drum_reset(drum);
    assert_true(tabor_drum_is_silent(drum));
    play(drum, AFTER, sound); /* what it owes for all this is paid back */
    for (int i = 0; i < AFTER; i++) assert_true(sound[i] == 0.0f);
    assert_int_equal(counted(drum).frames, AFTER);
    tabor_drum_reset(drum);
    const TaborStatistics statistics = counted(drum);
    const TaborLedger ledger = ledger_of(drum);
    assert_memory_equal(&statistics, &(TaborStatistics){0}, sizeof statistics);
    assert_memory_equal(&ledger, &nothing, sizeof ledger);
    const size_t size = tabor_drum_state_size(drum);
    char *const one = malloc(size), *const other = malloc(size);
    tabor_drum_state_save(drum, one);
    tabor_drum_state_save(fresh, other);
    assert_memory_equal(one, other, size);
    free(one);
    free(other);
    play_scene(drum, &scene, BEFORE - 100, BEFORE - 100 + AFTER, sound);
    play_scene(fresh, &scene, BEFORE - 100, BEFORE - 100 + AFTER, expected);
    assert_memory_equal(sound, expected, sizeof sound);
    tabor_drum_destroy(drum);
    tabor_drum_destroy(fresh);
    tabor_swap_destroy(swap);
    tabor_swap_destroy(back);
  }
  tabor_model_release(model);
  tabor_model_release(twin);
}

/* ---- silences ------------------------------------------------------------------------------- */

/* A silence leaves a drum that has its live values, and nobody in play; the ledger closes. */
static void a_silence_takes_everybody_away(void **state) {
  (void)state;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  const TaborEvent silence = {.type = TABOR_EVENT_SILENCE};
  for (int which = 0; which < SCENES; which++) {
    const Scene scene = make_scene(which);
    TaborDrum *drum = physics_drum(model);
    play_scene(drum, &scene, 0, BEFORE, NULL);
    const TaborStatistics before = counted(drum);
    tabor_drum_process(drum, &silence, 1, NULL, 0);
    assert_int_equal(counted(drum).in_play, 0);
    assert_int_equal(counted(drum).strikes, before.strikes);
    assert_true(drum->state->live.values[TB_LIVE_MUFFLE_RESONANT].target == 0.4);
    assert_true(drum->state->strikers.slots[TB_MUFFLERS + 1].resistance == 0.4);
    assert_closes(drum);
    play(drum, 9600, NULL);
    assert_closes(drum);
    tabor_drum_destroy(drum);
  }
  tabor_model_release(model);
}

/* At a drum at rest, beside what rings out, a silence costs nothing: as many strokes act after any
 * number of them. */
static void silences_of_a_drum_at_rest_are_free(void **state) {
  (void)state;
  TaborDrumDef other = def;
  other.batter.tension *= 1.1;
  TaborModel *models[] = {physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT),
                          physics_model(&other, 48000.0, TABOR_QUALITY_DRAFT)};
  const Scene scene = make_scene(0);
  const TaborEvent silence = {.type = TABOR_EVENT_SILENCE};
  TaborDrum *drum = physics_drum(models[0]);
  play_scene(drum, &scene, 0, BEFORE, NULL);
  TaborSwap *swap = send(drum, models[1], TABOR_EVENT_REPLACE);
  const uint32_t debt = drum->state->event_debt;
  for (int i = 0; i < 20; i++) tabor_drum_process(drum, &silence, 1, NULL, 0);
  assert_int_equal(drum->state->event_debt, debt);
  play(drum, 720, NULL); /* 15 ms, as the engine has it: what rang out has faded, too */
  assert_true(tabor_drum_is_silent(drum) && tabor_swap_done(swap));
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

/* Where a drum fell asleep by itself nothing sounds, and nothing happens. */
static void a_silence_of_a_sleeping_drum_does_nothing(void **state) {
  (void)state;
  TaborDrumDef deaf = physics_preset("frame-drum");
  deaf.batter.damping_0 = 500.0;
  deaf.quality.two_way_bandwidth = deaf.quality.bandwidth = 600.0;
  TaborModel *model = physics_model(&deaf, 48000.0, TABOR_QUALITY_DRAFT);
  const TaborEvent strike = physics_strike(&deaf), silence = {.type = TABOR_EVENT_SILENCE};
  TaborDrum *drum = physics_drum(model);
  tabor_drum_process(drum, &strike, 1, NULL, 96000);
  assert_true(tabor_drum_is_silent(drum));
  const size_t size = tabor_drum_state_size(drum);
  char *const before = malloc(size), *const after = malloc(size);
  tabor_drum_state_save(drum, before);
  tabor_drum_process(drum, &silence, 1, NULL, 0);
  tabor_drum_state_save(drum, after);
  assert_true(tabor_drum_is_silent(drum));
  assert_memory_equal(before, after, size);
  free(before);
  free(after);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* A silence that fades does not keep a hand that came after it on the head. */
static void a_silence_lifts_hands_that_came_after_another(void **state) {
  (void)state;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  const Scene scene = make_scene(0);
  const TaborEvent events[] = {
    {.type = TABOR_EVENT_SILENCE}, hand(10, 7), {.frame = 20, .type = TABOR_EVENT_SILENCE}};
  TaborDrum *drum = physics_drum(model);
  play_scene(drum, &scene, 0, BEFORE, NULL);
  tabor_drum_process(drum, events, 2, NULL, 20);
  assert_int_equal(counted(drum).in_play, 1);
  tabor_drum_process(drum, &events[2], 1, NULL, 20);
  assert_int_equal(counted(drum).in_play, 0);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Snares that are off leave the head again after a silence, unheard; on another model, too. */
static void what_is_hushed_stays_so_through_a_swap(void **state) {
  (void)state;
  enum { FADE = 720 };
  static float sound[AFTER];
  TaborModel *models[] = {physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT),
                          physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT)};
  Scene scene = make_scene(0);
  add(&scene, parameter(BEFORE - 30, "wires.strainer", 0.0));
  const TaborEvent silence = {.type = TABOR_EVENT_SILENCE};
  TaborDrum *drum = physics_drum(models[0]);
  play_scene(drum, &scene, 0, BEFORE + 1000, NULL);
  tabor_drum_process(drum, &silence, 1, NULL, 10);
  TaborSwap *swap = send(drum, models[1], TABOR_EVENT_SWAP);
  play(drum, AFTER, sound);
  double before = 0.0;
  for (int i = 0; i < FADE - 10; i++) before = fmax(before, fabs((double)sound[i]));
  assert_true(before > 0.0);
  for (int i = FADE - 10; i < AFTER; i++) assert_true(sound[i] == 0.0f);
  assert_true(tabor_drum_model(drum) == models[1]);
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

static int set_up(void **state) {
  (void)state;
  def = small_snare();
  return 0;
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_same_model_changes_nothing),
    cmocka_unit_test(a_slightly_other_model_changes_next_to_nothing),
    cmocka_unit_test(times_and_speeds_stay_when_steps_are_halved),
    cmocka_unit_test(live_values_stay_if_they_were_moved),
    cmocka_unit_test(strikers_that_the_other_drum_lacks_vanish),
    cmocka_unit_test(a_new_microphone_shares_with_nobody),
    cmocka_unit_test(overdamped_modes_keep_place_and_velocity),
    cmocka_unit_test(a_replacement_is_at_rest),
    cmocka_unit_test(a_reset_leaves_a_new_drum),
    cmocka_unit_test(a_silence_takes_everybody_away),
    cmocka_unit_test(silences_of_a_drum_at_rest_are_free),
    cmocka_unit_test(a_silence_of_a_sleeping_drum_does_nothing),
    cmocka_unit_test(a_silence_lifts_hands_that_came_after_another),
    cmocka_unit_test(what_is_hushed_stays_so_through_a_swap),
  };
  return cmocka_run_group_tests(tests, set_up, NULL);
}
