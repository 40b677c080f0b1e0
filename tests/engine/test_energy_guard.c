/* SPDX-License-Identifier: MIT */
/* The energy guard on steps that were stretched by hand: x(n+1) = x(n-1) + g (x(n+1) - x(n-1)). The
 * sum of new energy and losses is convex in g and does not exceed the old energy at g = 0 and 1. So
 * there is one g > 1 from which on a step creates energy. */
#include "step/energy_guard.h"

#include "air/incident_sound.h"
#include "drum/drum.h"
#include "physics.h"
#include "step/energy.h"
#include "strikers/striker_hold.h"

enum { SCENES = 3 };

static TaborModel *model;
static TaborDrum *drum;
static char *kept; /* the drum's state after an honest step */

/* ---- scenes --------------------------------------------------------------------------------- */

/* Two heads, wires, hoops that move, a muffler; few modes. */
static TaborDrumDef small_snare(void) {
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.quality.two_way_bandwidth = 600.0;
  def.quality.bandwidth = 1200.0;
  def.quality.wire_points = 16;
  def.wires.count = 4;
  def.batter.muffle_strength = 0.5;
  return def;
}

static TaborEvent stroke(uint32_t frame, uint32_t technique, double velocity) {
  return (TaborEvent){.frame = frame,
                      .type = TABOR_EVENT_STRIKE,
                      .id = frame + 1,
                      .technique = technique,
                      .velocity = velocity,
                      .radius = 0.05,
                      .angle = 40.0 * frame,
                      .value = 0.7};
}

/* The view before its rotation: next, now, last are the three newest instants. */
static TbView view_of_step(void) {
  TbView view = tb_view(drum->state, model);
  tb_view_rotate(&view);
  tb_view_rotate(&view);
  return view;
}

/* Plays sticks in contact, bent, held and pressed, until just after some honest step. */
static void play_scene(int scene) {
  static const uint32_t LENGTHS[SCENES] = {20, 150, 700};
  const TaborEvent events[] = {stroke(0, TABOR_TECHNIQUE_BUZZ, 2.0),
                               stroke(3, TABOR_TECHNIQUE_RIMSHOT, 4.0),
                               stroke(10, TABOR_TECHNIQUE_NORMAL, 6.0)};
  tabor_drum_reset(drum);
  tabor_drum_process(drum, events, 3, NULL, LENGTHS[scene]);
  memcpy(kept, drum->state, tb_state_bytes(model));
}

static void go_back(void) { memcpy(drum->state, kept, tb_state_bytes(model)); }

static int set_up(void **state) {
  (void)state;
  const TaborDrumDef def = small_snare();
  model = physics_model(&def, 96000.0, TABOR_QUALITY_STUDIO);
  drum = physics_drum(model);
  kept = malloc(tb_state_bytes(model));
  return 0;
}

static int tear_down(void **state) {
  (void)state;
  free(kept);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return 0;
}

/* ---- a step and what it holds --------------------------------------------------------------- */

typedef struct Quantity {
  double *next;
  const double *now, *last;
  uint32_t count;
  const char *name;
} Quantity;

enum { QUANTITIES = 6 };

static void list(const TbView *view, Quantity *all) {
  const uint32_t rows = view->model->wires.stride + TB_SLOTS;
  const TbPhase *x = &view->next, *y = &view->now, *z = &view->last;
  all[0] = (Quantity){x->q, y->q, z->q, view->model->modes.padded, "a mode"};
  all[1] = (Quantity){x->v, y->v, z->v, view->model->wires.node_count, "a wire's node"};
  all[2] = (Quantity){x->eta, y->eta, z->eta, rows, "a penetration"};
  all[3] = (Quantity){x->z, y->z, z->z, TB_SLOTS, "a striker"};
  all[4] = (Quantity){x->truncated[0], y->truncated[0], z->truncated[0], TB_SLOTS * TB_TRUNCATED,
                      "a missing mode"};
  all[5] = (Quantity){x->bow[0], y->bow[0], z->bow[0], TB_SLOTS * TB_BENDS, "a bent stick"};
}

static void stretch(TbView *view, double g) {
  Quantity all[QUANTITIES];
  list(view, all);
  for (int k = 0; k < QUANTITIES; k++) {
    for (uint32_t i = 0; i < all[k].count; i++) {
      all[k].next[i] = all[k].last[i] + g * (all[k].next[i] - all[k].last[i]);
    }
  }
  for (uint32_t row = 0; row < view->model->wires.stride + TB_SLOTS; row++) view->s[row] *= g;
}

/* What the ledger would book for this step as created, contacts' losses left out: > 0 if energy
 * came from nowhere. */
static double created(const TbView *view) {
  const TbLosses losses = tb_losses(view);
  const TbHoldWork hands = tb_hold_work(view);
  const double gone = losses.head + losses.shell + losses.wires + losses.radiated + hands.lost;
  return tb_energy_stored(view, &view->next, &view->now) + gone - hands.done -
         tb_energy_stored(view, &view->now, &view->last);
}

static double created_if_stretched(double g) {
  go_back();
  TbView view = view_of_step();
  stretch(&view, g);
  return created(&view);
}

/* The g from which on energy is created. */
static double limit(void) {
  double low = 1.0, high = 2.0;
  assert_true(created_if_stretched(low) <= 0.0);
  assert_true(created_if_stretched(high) > 0.0);
  for (int i = 0; i < 60; i++) {
    const double middle = 0.5 * (low + high);
    *(created_if_stretched(middle) > 0.0 ? &high : &low) = middle;
  }
  return low;
}

static double one_part(const TbView *view) {
  double most = 0.0;
  for (uint32_t row = 0; row < view->model->wires.stride + TB_SLOTS; row++) {
    if (fabs(view->s[row]) > fabs(most)) most = view->s[row];
  }
  return most;
}

/* ---- tests ---------------------------------------------------------------------------------- */

/* Each loss and each work counts: the least of them shifts the limit by more than one part in a
 * billion. */
static void it_acts_from_where_energy_is_created(void **state) {
  (void)state;
  for (int scene = 0; scene < SCENES; scene++) {
    play_scene(scene);
    const TbView plain = view_of_step();
    const double g = limit();
    const TbLosses losses = tb_losses(&plain);
    const TbHoldWork hands = tb_hold_work(&plain);
    print_message("%d: g %.9f, losses %.1e %.1e %.1e %.1e, hands %.1e %.1e J\n", scene, g,
                  losses.head, losses.shell, losses.wires, losses.radiated, hands.lost, hands.done);
    go_back();
    TbView view = view_of_step();
    stretch(&view, 1.0 + (g - 1.0) * (1.0 - 1e-6));
    assert_false(tb_energy_guard(&view));
    assert_int_equal(view.state->ledger.statistics.guarded, 0);
    go_back();
    view = view_of_step();
    stretch(&view, 1.0 + (g - 1.0) * (1.0 + 1e-6));
    assert_true(tb_energy_guard(&view));
    assert_int_equal(view.state->ledger.statistics.guarded, 1);
  }
}

static void an_honest_step_stays_as_it_is(void **state) {
  (void)state;
  for (int scene = 0; scene < SCENES; scene++) {
    play_scene(scene);
    TbView view = view_of_step();
    assert_false(tb_energy_guard(&view));
    go_back(); /* the view's rotation is in the state */
    view = view_of_step();
    char *const before = malloc(tb_state_bytes(model));
    memcpy(before, drum->state, tb_state_bytes(model));
    assert_false(tb_energy_guard(&view));
    assert_memory_equal(before, drum->state, tb_state_bytes(model));
    free(before);
  }
}

/* The work of loud sound from outside is no creation, and what it takes is missing. */
static void sound_from_outside_brings_what_it_works(void **state) {
  (void)state;
  enum { FRAMES = 64 };
  int brought = 0, taken = 0;
  float air[FRAMES];
  for (int i = 0; i < FRAMES; i++) air[i] = (float)(2000.0 * sin(0.2 * i));
  play_scene(0);
  for (uint32_t frames = 2; frames <= FRAMES; frames++) {
    const TaborSound sound = {.mic = 0, .pressure = air};
    go_back();
    tabor_drum_process_sound(drum, NULL, 0, &sound, NULL, frames);
    TbView view = view_of_step();
    view.incident =
      (TbIncident){.mic = 0, .now = (double)air[frames - 1], .before = (double)air[frames - 2]};
    const double work = tb_incident_work(&view);
    brought += work > 1e-9;
    taken += work < -1e-9;
    assert_true(created(&view) - work < 1e-12); /* the step is an honest one */
    assert_true(created(&view) - work > -1e-12 || !tb_energy_guard(&view));
  }
  print_message("work is done in %d of %d steps, and taken in %d\n", brought, FRAMES - 1, taken);
  assert_true(brought > 10 && taken > 10);
}

/* Neither is one in which nothing moves. */
static void rest_is_no_creation(void **state) {
  (void)state;
  tabor_drum_reset(drum);
  TbView view = tb_view(drum->state, model);
  assert_false(tb_energy_guard(&view));
  assert_int_equal(view.state->ledger.statistics.guarded, 0);
}

/* Everything is shortened by the same t, which the change of penetration tells to the last digit.
 */
static void assert_shortened(const TbView *view, const Quantity *forged, double t, double g) {
  Quantity all[QUANTITIES];
  list(view, all);
  for (int k = 0; k < QUANTITIES; k++) {
    for (uint32_t i = 0; i < all[k].count; i++) {
      const double last = all[k].last[i], step = forged[k].next[i] - last;
      const double expected = last + t * step;
      const double rounding = 1e-14 * (fabs(last) + fabs(step));
      assert_true(isfinite(all[k].next[i]));
      if (fabs(all[k].next[i] - expected) <= rounding) continue;
      fail_msg("g %g: %s, number %u: %.17g, not %.17g", g, all[k].name, (unsigned)i, all[k].next[i],
               expected);
    }
  }
}

/* The energy that a step creates is taken out of it, and hardly more: a fourth of the shortening
 * would not have been enough. What came before the step stays as it is. */
static void a_stretched_step_is_shortened(void **state) {
  (void)state;
  static const double STRETCHES[] = {1e-9, 1e-7, 2e-6, 3e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 2.0, 1e6};
  char *const forged = malloc(tb_state_bytes(model)), *const after = malloc(tb_state_bytes(model));
  for (int scene = 0; scene < SCENES; scene++) {
    play_scene(scene);
    const double end = limit();
    for (size_t i = 0; i < sizeof STRETCHES / sizeof *STRETCHES; i++) {
      const double g = end * (1.0 + STRETCHES[i]);
      go_back();
      TbView view = view_of_step();
      stretch(&view, g);
      Quantity before[QUANTITIES], now[QUANTITIES];
      list(&view, before);
      const double whole = one_part(&view);
      memcpy(forged, drum->state, tb_state_bytes(model));
      for (int k = 0; k < QUANTITIES; k++) { /* of the copy, as the guard changes the state */
        const ptrdiff_t at = (char *)before[k].next - (char *)drum->state;
        before[k].next = (double *)(forged + at);
      }
      assert_true(tb_energy_guard(&view));
      const double t = one_part(&view) / whole;
      assert_true(t >= 0.0 && t < 1.0);
      assert_true(created(&view) <= 0.0 || t == 0.0);
      assert_shortened(&view, before, t, g);
      list(&view, now);
      for (int k = 0; k < QUANTITIES; k++) {
        const ptrdiff_t at = (char *)now[k].now - (char *)drum->state,
                        last = (char *)now[k].last - (char *)drum->state;
        assert_memory_equal(now[k].now, forged + at, now[k].count * sizeof(double));
        assert_memory_equal(now[k].last, forged + last, now[k].count * sizeof(double));
      }
      if (t > 0.0 && 1.0 - t > 1e-11) {
        memcpy(after, drum->state, tb_state_bytes(model));
        memcpy(drum->state, forged, tb_state_bytes(model));
        stretch(&view, 1.0 - 0.25 * (1.0 - t));
        assert_true(created(&view) > 0.0);
        memcpy(drum->state, after, tb_state_bytes(model));
      }
      if (STRETCHES[i] <= 0.3) assert_true(t > 0.6 / (1.0 + STRETCHES[i]));
      if (STRETCHES[i] > 1.0) assert_true(t < 1.0 / STRETCHES[i]);
    }
  }
  free(forged);
  free(after);
}

/* A step that goes astray without bound is undone: the drum turns back to where it was. */
static void a_step_without_bound_is_undone(void **state) {
  (void)state;
  play_scene(1);
  TbView view = view_of_step();
  stretch(&view, 1e12);
  assert_true(tb_energy_guard(&view));
  Quantity all[QUANTITIES];
  list(&view, all);
  for (int k = 0; k < QUANTITIES; k++) {
    assert_memory_equal(all[k].next, all[k].last, all[k].count * sizeof(double));
  }
  assert_true(one_part(&view) == 0.0);
  const double before = tb_energy_stored(&view, &view.now, &view.last);
  assert_true(fabs(tb_energy_stored(&view, &view.next, &view.now) - before) <= 1e-12 * before);
}

/* A drum whose whole motion lost a fifth at once would be heard: next to nothing is taken for next
 * to nothing. */
static void a_little_too_much_takes_next_to_nothing(void **state) {
  (void)state;
  play_scene(0);
  const double g = limit();
  go_back();
  TbView view = view_of_step();
  stretch(&view, g * (1.0 + 3e-14));
  if (created(&view) <= 0.0) return; /* rounding */
  const double whole = one_part(&view);
  assert_true(tb_energy_guard(&view));
  assert_true(1.0 - one_part(&view) / whole <= 1.5e-12);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(it_acts_from_where_energy_is_created),
    cmocka_unit_test(an_honest_step_stays_as_it_is),
    cmocka_unit_test(sound_from_outside_brings_what_it_works),
    cmocka_unit_test(rest_is_no_creation),
    cmocka_unit_test(a_stretched_step_is_shortened),
    cmocka_unit_test(a_step_without_bound_is_undone),
    cmocka_unit_test(a_little_too_much_takes_next_to_nothing),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
