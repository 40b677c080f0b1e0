/* SPDX-License-Identifier: MIT */
/* A forged state has the right size, fingerprint and checksum, and wrong contents. It is refused,
 * or it is harmless: no step leaves its arrays, which the build with sanitizers watches, and the
 * sound stays finite.
 *
 * usage: test_state_check [brief]: every place of the head with one wrong value and not with all, a
 * quarter of the places of the arrays. */
#include "step/state_check.h"

#include "physics.h"

static bool brief;

enum { BURST = 16 }; /* frames played from each state that is accepted */

static TaborModel *model;
static TaborDrum *drum;
static unsigned char *good, *bytes; /* a state in mid-play, and its forged copy */
static size_t size;
static unsigned long accepted, refused;

/* A whole snare drum with few modes and wires, so that a state is small. */
static TaborDrumDef small_drum(void) {
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.quality.two_way_bandwidth = 450.0;
  def.quality.bandwidth = 900.0;
  def.quality.wire_points = 8;
  def.wires.count = 3;
  def.batter.muffle_strength = 0.5;
  return def;
}

static uint32_t striker_named(const TaborDrumDef *def, const char *name) {
  const int striker = tabor_drum_def_find_striker(def, name);
  assert_true(striker >= 0);
  return (uint32_t)striker;
}

static TaborEvent stroke_of(uint32_t frame, uint32_t striker, uint32_t technique, double velocity) {
  return (TaborEvent){.frame = frame,
                      .type = TABOR_EVENT_STRIKE,
                      .id = frame,
                      .striker = striker,
                      .technique = technique,
                      .velocity = velocity,
                      .radius = 0.05,
                      .angle = 7.0 * frame,
                      .value = 0.5};
}

/* Everything that a state can hold: plain, pressed and paired sticks, a brush, a hand, values under
 * way. */
static uint32_t everything(const TaborDrumDef *def, TaborEvent *events) {
  uint32_t count = 0;
  events[count++] = stroke_of(1, 0, TABOR_TECHNIQUE_NORMAL, 3.0);
  events[count++] = stroke_of(2, 0, TABOR_TECHNIQUE_BUZZ, 2.0);
  events[count++] = stroke_of(3, striker_named(def, "brush"), TABOR_TECHNIQUE_SWEEP, 0.8);
  events[count++] = (TaborEvent){
    .frame = 4, .type = TABOR_EVENT_DAMP, .id = 9, .radius = 0.06, .angle = 80.0, .value = 6.0};
  events[count++] = (TaborEvent){.frame = 200,
                                 .type = TABOR_EVENT_PARAMETER,
                                 .parameter = tabor_parameter_find("wires.strainer")->id,
                                 .value = 0.5};
  events[count++] = stroke_of(210, 0, TABOR_TECHNIQUE_RIMSHOT, 3.0);
  events[count++] = stroke_of(240, 0, TABOR_TECHNIQUE_RIM, 3.0);
  return count;
}

static int set_up(void **state) {
  (void)state;
  const TaborDrumDef def = small_drum();
  TaborEvent events[16];
  const uint32_t count = everything(&def, events);
  float sound[256], *outputs[TABOR_MAX_MICS] = {sound};
  model = physics_model(&def, 22050.0, TABOR_QUALITY_DRAFT);
  drum = physics_drum(model);
  tabor_drum_process(drum, events, count, outputs, 256);
  size = tabor_drum_state_size(drum);
  good = malloc(size);
  bytes = malloc(size + 8);
  tabor_drum_state_save(drum, good);
  memcpy(bytes, good, size);
  return 0;
}

static int tear_down(void **state) {
  (void)state;
  print_message("%lu forged states accepted, %lu refused\n", accepted, refused);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  free(good);
  free(bytes);
  return 0;
}

/* FNV-1a over words of 8 bytes, as drum.c has it. */
static void sign(void) {
  uint64_t hash = 14695981039346656037u;
  for (size_t i = 0; i + 16 <= size; i += 8) {
    uint64_t word;
    memcpy(&word, bytes + i, 8);
    hash = (hash ^ word) * 1099511628211u;
  }
  memcpy(bytes + size - 8, &hash, 8);
}

/* The recovery of a drum comes with its housekeeping; until then a sound may be anything that is no
 * crash. */
static void play_on(void) {
  TaborEvent events[4] = {stroke_of(1, 0, TABOR_TECHNIQUE_NORMAL, 3.0),
                          stroke_of(2, 1, TABOR_TECHNIQUE_CROSS_STICK, 3.0),
                          {.frame = 9, .type = TABOR_EVENT_PRESS, .value = 0.4},
                          {.frame = 12, .type = TABOR_EVENT_RELEASE}};
  float sound[BURST], *outputs[TABOR_MAX_MICS] = {sound};
  TaborLedger ledger;
  TaborProbe probe;
  TaborStatistics statistics;
  tabor_drum_process(drum, events, 4, outputs, BURST);
  tabor_drum_ledger(drum, &ledger);
  tabor_drum_probe(drum, &probe);
  tabor_drum_statistics(drum, &statistics);
}

static bool load_forged(void) {
  sign();
  const TaborStatus status = tabor_drum_state_load(drum, bytes, size);
  if (status != TABOR_OK) {
    assert_int_equal(status, TABOR_ERROR_STATE);
    refused++;
    return false;
  }
  accepted++;
  play_on();
  return true;
}

/* Sets some bytes, tries the state, and mends it. */
static bool try_with(size_t at, const void *value, size_t length) {
  memcpy(bytes + at, value, length);
  const bool loaded = load_forged();
  memcpy(bytes + at, good + at, length);
  return loaded;
}

static void every_word_of_the_head(void **state) {
  (void)state;
  static const uint32_t NARROW[] = {0, 1, 17, 0x7fffffffu, UINT32_MAX};
  static const double WIDE[] = {NAN, INFINITY, -1.0, 1e14};
  const size_t end = tb_state_head_bytes();
  enum { NARROWS = sizeof NARROW / sizeof *NARROW, WIDES = sizeof WIDE / sizeof *WIDE };
  for (size_t at = 8; at + 8 <= end; at += 4) {
    const size_t turn = at / 4; /* a brief test tries one value here and another one there */
    for (size_t i = 0; i < NARROWS; i++) {
      if (!brief || turn % NARROWS == i) try_with(at, &NARROW[i], 4);
    }
    if (at % 8) continue;
    for (size_t i = 0; i < WIDES; i++) {
      if (!brief || turn / 2 % WIDES == i) try_with(at, &WIDE[i], 8);
    }
  }
}

static void every_byte_of_the_head(void **state) {
  (void)state;
  for (size_t at = 8; at < tb_state_head_bytes(); at += brief ? 3 : 1) {
    const unsigned char turned = (unsigned char)~good[at];
    try_with(at, &turned, 1);
  }
}

static void words_of_the_arrays(void **state) {
  (void)state;
  static const double WIDE[] = {NAN, -INFINITY, 1e14};
  const uint64_t ones = UINT64_MAX;
  for (size_t at = tb_state_head_bytes(); at + 16 <= size; at += (brief ? 4 : 1) * 31 * 8) {
    for (size_t i = 0; i < sizeof WIDE / sizeof *WIDE; i++) try_with(at, &WIDE[i], 8);
    try_with(at, &ones, 8);
  }
}

static void assert_refused(size_t at, uint32_t value, const char *what) {
  if (try_with(at, &value, sizeof value)) fail_msg("accepted: %s", what);
}

static void wrong_indices_are_refused(void **state) {
  (void)state;
  const size_t slot = offsetof(TbState, strikers.slots);
  assert_refused(offsetof(TbState, newest), 3, "a fourth instant");
  assert_refused(offsetof(TbState, strikers.mask), UINT32_MAX, "slots that are none");
  assert_refused(offsetof(TbState, strikers.mask), 0, "a mask that lacks slots");
  assert_refused(offsetof(TbState, mics.delay_at), model->mics[0].delay + 1u,
                 "beyond a delay line");
  assert_refused(offsetof(TbState, mics.heard), 1u << model->def.mic_count,
                 "a microphone too many");
  assert_refused(slot + offsetof(TbSlot, kind), TB_SLOT_MUFFLER + 1u, "a slot of no kind");
  assert_refused(slot + offsetof(TbSlot, striker.definition), model->def.striker_count,
                 "no such striker");
  assert_refused(slot + offsetof(TbSlot, head), 2, "a third head");
  assert_refused(slot + offsetof(TbSlot, end.other), 17, "a stick's end without the other");
  assert_refused(slot + offsetof(TbSlot, end.other), 0, "an end that is its own other");
  assert_refused(slot + offsetof(TbSlot, kind), TB_SLOT_BRISTLES, "bristles at a stick's place");
  assert_refused(slot + offsetof(TbSlot, end.grip), TB_GRIPS, "a fourth grip");
  assert_refused(offsetof(TbState, strikers.laws) + offsetof(TbContactLaw, kind), 5, "a sixth law");
}

static void numbers_that_are_none_are_refused(void **state) {
  (void)state;
  const double none = NAN;
  const size_t arrays = tb_state_head_bytes();
  const size_t places[] = {offsetof(TbState, strikers.z),      offsetof(TbState, wires.shift),
                           arrays + model->layout.q[1],        arrays + model->layout.v[2] + 8,
                           arrays + model->layout.coupling[0], arrays + model->layout.delay[0]};
  for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
    if (try_with(places[i], &none, sizeof none)) fail_msg("accepted: not a number, place %zu", i);
  }
  const float single = NAN;
  if (try_with(arrays + model->layout.high[0], &single, sizeof single)) {
    fail_msg("accepted: not a number in the high band");
  }
}

/* Bytes may stand anywhere, as in a file that was read in one go. */
static void a_good_state_is_accepted_at_any_address(void **state) {
  (void)state;
  for (size_t shift = 0; shift < 8; shift++) {
    memmove(bytes + shift, good, size);
    assert_int_equal(tabor_drum_state_load(drum, bytes + shift, size), TABOR_OK);
  }
  memcpy(bytes, good, size);
}

/* No state of an honest performance is refused, at either precision. */
static void honest_states_are_accepted(void **state) {
  (void)state;
  const TaborDrumDef def = small_drum();
  for (uint32_t quality = TABOR_QUALITY_DRAFT; quality <= TABOR_QUALITY_STUDIO; quality += 2) {
    TaborModel *its = physics_model(&def, 22050.0, quality);
    TaborDrum *one = physics_drum(its), *other = physics_drum(its);
    const size_t length = tabor_drum_state_size(one);
    void *saved = malloc(length);
    TaborEvent events[16];
    for (uint32_t block = 0; block < 400; block++) {
      uint32_t count = block % 100 < 3 ? everything(&def, events) : 0;
      for (uint32_t i = 0; i < count; i++) events[i].frame = 0;
      tabor_drum_process(one, events, count, NULL, 37);
      tabor_drum_state_save(one, saved);
      assert_int_equal(tabor_drum_state_load(other, saved, length), TABOR_OK);
    }
    free(saved);
    tabor_drum_destroy(one);
    tabor_drum_destroy(other);
    tabor_model_release(its);
  }
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_good_state_is_accepted_at_any_address),
    cmocka_unit_test(honest_states_are_accepted),
    cmocka_unit_test(wrong_indices_are_refused),
    cmocka_unit_test(numbers_that_are_none_are_refused),
    cmocka_unit_test(every_word_of_the_head),
    cmocka_unit_test(every_byte_of_the_head),
    cmocka_unit_test(words_of_the_arrays),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
