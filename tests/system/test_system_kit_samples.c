/* SPDX-License-Identifier: MIT */
/* Sounds of notes: what a kit plays and does not model. */
#include "kits.h"

enum { FRAMES = 1000, FADE = 720 /* 15 ms */ };

static const char *const PRESETS[] = {"frame-drum"};

typedef struct Mix {
  float side[2][LENGTH];
} Mix;

static TaborKitDef *hats(void) {
  TaborKitDef *const def = kit_of(1, PRESETS);
  set(def, "note.42.sample", "closed.wav");
  set(def, "note.42.choke", "1");
  set(def, "note.46.sample", "open.wav");
  set(def, "note.46.choke", "1");
  set(def, "note.49.sample", "crash.wav");
  set(def, "note.49.gain", "-20");
  return def;
}

/* Note 42: 1 on both sides. Note 46: 0.5 and -0.5. Note 49: 1 before its gain. */
static TaborKit *kit_with_sounds(const TaborKitDef *def) {
  static float ones[FRAMES], half[2][FRAMES];
  TaborKit *const kit = new_kit(def);
  for (int i = 0; i < FRAMES; i++) {
    ones[i] = 1.0f;
    half[0][i] = 0.5f;
    half[1][i] = -0.5f;
  }
  assert_int_equal(tabor_kit_set_sample(kit, 42, ones, NULL, FRAMES, RATE, NULL), TABOR_OK);
  assert_int_equal(tabor_kit_set_sample(kit, 46, half[0], half[1], FRAMES, RATE, NULL), TABOR_OK);
  assert_int_equal(tabor_kit_set_sample(kit, 49, ones, NULL, FRAMES, RATE, NULL), TABOR_OK);
  return kit;
}

static TaborKitEvent hit(uint32_t note, uint32_t frame, double strength) {
  return (TaborKitEvent){
    .drum = TABOR_KIT_NOTE + note,
    .event = {.frame = frame, .type = TABOR_EVENT_STRIKE, .velocity = strength}};
}

static TaborKitEvent hush(uint32_t address, uint32_t frame) {
  return (TaborKitEvent){.drum = address, .event = {.frame = frame, .type = TABOR_EVENT_SILENCE}};
}

static void play(TaborKit *kit, const TaborKitEvent *events, uint32_t count, Mix *mix,
                 uint32_t from, uint32_t frames) {
  const TaborKitOutputs outputs = {.stereo = {mix->side[0] + from, mix->side[1] + from}};
  tabor_kit_process(kit, events, count, &outputs, frames);
}

static void a_stroke_plays_the_sound_from_its_frame_on(void **state) {
  (void)state;
  static Mix mix;
  TaborKitDef *const def = hats();
  TaborKit *const kit = kit_with_sounds(def);
  const TaborKitEvent events[] = {hit(42, 300, 0.5), hit(49, 2000, 1), hit(46, 4000, 1)};
  play(kit, events, 3, &mix, 0, LENGTH);
  for (int i = 0; i < LENGTH; i++) {
    double left = 0, right = 0;
    if (i >= 300 && i < 300 + FRAMES) left = right = 0.25;  /* the square of the strength */
    if (i >= 2000 && i < 2000 + FRAMES) left = right = 0.1; /* -20 dB */
    if (i >= 4000 && i < 4000 + FRAMES) left = 0.5, right = -0.5;
    assert_true(fabs((double)mix.side[0][i] - left) < 1e-7);
    assert_true(fabs((double)mix.side[1][i] - right) < 1e-7);
  }
  assert_true(tabor_kit_is_silent(kit) && tabor_kit_sounds(kit) == 0);
  tabor_kit_destroy(kit);
  free(def);
}

static void a_stroke_chokes_its_group_and_a_silence_all(void **state) {
  (void)state;
  static Mix mix;
  TaborKitDef *const def = hats();
  TaborKit *const kit = kit_with_sounds(def);
  const TaborKitEvent events[] = {hit(46, 0, 1), hit(49, 0, 1), hit(42, 100, 1),
                                  hush(TABOR_KIT_NOTE + 42, 200)};
  play(kit, events, 4, &mix, 0, 2000);
  for (int i = 0; i < FRAMES; i++) {
    const double open = i < 100 ? 1 : fmax(0, 1 - (i - 99.0) / FADE);
    const double closed = i < 100 ? 0 : i < 200 ? 1 : fmax(0, 1 - (i - 199.0) / FADE);
    const double expected = 0.5 * open + closed + 0.1;
    if (i < 900) assert_true(fabs((double)mix.side[0][i] - expected) < 1e-5);
  }
  const TaborKitEvent again[] = {hit(49, 0, 1), hush(TABOR_KIT_ALL, 10)};
  play(kit, again, 2, &mix, 0, 2000);
  assert_true(mix.side[0][9] > 0.09f && mix.side[0][10 + FADE / 2] < 0.06f);
  assert_true(mix.side[0][10 + FADE] == 0);
  tabor_kit_destroy(kit);
  free(def);
}

static void blocks_and_saved_states_change_no_bit_of_sounds(void **state) {
  (void)state;
  static Mix mixes[4];
  static const uint32_t blocks[] = {LENGTH, 1, 77, 480};
  TaborKitDef *const def = hats();
  for (int k = 0; k < 4; k++) {
    TaborKit *kit = kit_with_sounds(def);
    const TaborKitEvent events[] = {stroke(def, 0, 20, 3.0), hit(42, 5, 1),
                                    hit(46, 100, 0.7),       value_at(150, TABOR_KIT_SAMPLES, -6),
                                    hit(49, 407, 1),         hush(TABOR_KIT_NOTE + 46, 500)};
    TaborKitEvent sorted[6] = {events[1], events[0], events[2], events[3], events[4], events[5]};
    uint32_t next = 0;
    for (uint32_t at = 0; at < 2000; at += blocks[k]) {
      const uint32_t frames = at + blocks[k] < 2000 ? blocks[k] : 2000 - at;
      TaborKitEvent due[6];
      uint32_t count = 0;
      for (; next < 6 && sorted[next].event.frame < at + frames; next++) {
        due[count] = sorted[next];
        due[count++].event.frame -= at;
      }
      play(kit, due, count, &mixes[k], at, frames);
      if (k == 3 && at == 480) {
        const size_t size = tabor_kit_state_size(kit);
        char *const bytes = malloc(size);
        tabor_kit_state_save(kit, bytes);
        tabor_kit_destroy(kit);
        kit = new_kit(def); /* without sounds: the state is of another kit */
        assert_int_equal(tabor_kit_state_load(kit, bytes, size), TABOR_ERROR_STATE);
        tabor_kit_destroy(kit);
        kit = kit_with_sounds(def);
        assert_int_equal(tabor_kit_state_load(kit, bytes, size), TABOR_OK);
        free(bytes);
      }
    }
    assert_memory_equal(&mixes[k], &mixes[0], sizeof mixes[0]);
    tabor_kit_destroy(kit);
  }
  free(def);
}

static void the_gain_of_all_sounds_moves_smoothly(void **state) {
  (void)state;
  static Mix mix;
  TaborKitDef *const def = hats();
  TaborKit *const kit = kit_with_sounds(def);
  const TaborKitEvent events[] = {hit(42, 0, 1)};
  play(kit, events, 1, &mix, 0, 64);
  const TaborKitEvent later[] = {value_at(36, TABOR_KIT_SAMPLES, -120)};
  play(kit, later, 1, &mix, 64, 936);
  for (int i = 1; i < FRAMES; i++) {
    assert_true(fabsf(mix.side[0][i] - mix.side[0][i - 1]) < 1.1f / 240); /* 5 ms */
  }
  assert_true(mix.side[0][99] > 0 && mix.side[0][100 + 240] == 0);
  tabor_kit_destroy(kit);
  free(def);
}

/* A flood takes the place of the oldest; what is no stroke of a sound is dropped, and what names a
 * file alone is silent. */
static void a_flood_and_what_is_dropped(void **state) {
  (void)state;
  static Mix mix;
  TaborKitDef *const def = hats();
  set(def, "note.51.sample", "missing.wav");
  TaborKit *const kit = kit_with_sounds(def);
  TaborKitEvent events[40];
  for (uint32_t i = 0; i < 40; i++) events[i] = hit(49, i, 1);
  play(kit, events, 40, &mix, 0, 64);
  assert_int_equal(tabor_kit_sounds(kit), 32);
  assert_int_equal(tabor_kit_dropped(kit), 0);
  const TaborKitEvent others[] = {
    hit(51, 0, 1),
    hit(50, 0, 1),
    {.drum = TABOR_KIT_NOTE + 42, .event = {.type = TABOR_EVENT_DAMP}},
    {.drum = TABOR_KIT_NOTE + 128, .event = {.type = TABOR_EVENT_STRIKE, .velocity = 1}}};
  play(kit, others, 4, &mix, 0, 64);
  assert_int_equal(tabor_kit_dropped(kit), 3);
  tabor_kit_reset(kit);
  assert_true(tabor_kit_is_silent(kit));
  assert_int_equal(tabor_kit_set_sample(kit, 128, mix.side[0], NULL, 1, RATE, NULL),
                   TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_kit_set_sample(kit, 42, mix.side[0], NULL, 1, 0, NULL), TABOR_ERROR_RANGE);
  assert_int_equal(tabor_kit_set_sample(kit, 42, NULL, NULL, 0, RATE, NULL), TABOR_ERROR_ARGUMENT);
  tabor_kit_destroy(kit);
  free(def);
}

/* At another rate a sound lasts as long, and is as loud. */
static void sounds_of_other_rates_are_converted(void **state) {
  (void)state;
  static Mix mix;
  static float sine[1000];
  TaborKitDef *const def = hats();
  TaborKit *const kit = kit_with_sounds(def);
  for (int i = 0; i < 1000; i++) sine[i] = (float)sin(2 * 3.14159265358979 * 1000 * i / 32000);
  assert_int_equal(tabor_kit_set_sample(kit, 42, sine, NULL, 1000, 32000, NULL), TABOR_OK);
  const TaborKitEvent events[] = {hit(42, 0, 1)};
  play(kit, events, 1, &mix, 0, 2000);
  for (int i = 200; i < 1300; i++) {
    assert_true(fabs((double)mix.side[0][i] - sin(2 * 3.14159265358979 * 1000 * i / 48000)) < 1e-3);
  }
  assert_true(mix.side[0][1500] == 0);
  tabor_kit_destroy(kit);
  free(def);
}

/* A kit that takes over goes on with sounds that are the same, and needs none of its own. */
static void sounds_go_on_in_a_kit_that_follows(void **state) {
  (void)state;
  static Mix one, other;
  static const uint8_t drums[] = {0};
  TaborKitDef *const def = hats();
  TaborKit *const whole = kit_with_sounds(def), *const first = kit_with_sounds(def),
                  *const second = new_kit(def);
  const TaborKitEvent before[] = {hit(46, 0, 1), value_at(50, TABOR_KIT_SAMPLES, -6)};
  const TaborKitEvent after[] = {hit(42, 100, 1)};
  play(whole, before, 2, &one, 0, 333);
  play(first, before, 2, &other, 0, 333);
  assert_int_equal(tabor_kit_follow(second, first, drums, NULL), TABOR_OK);
  tabor_kit_take_over(second, first);
  assert_int_equal(tabor_kit_sounds(first), 0);
  tabor_kit_destroy(first);
  play(whole, after, 1, &one, 333, 2000);
  play(second, after, 1, &other, 333, 2000);
  assert_memory_equal(&one, &other, sizeof one);
  tabor_kit_destroy(second);
  tabor_kit_destroy(whole);
  free(def);
}

int main(void) {
  brief = true; /* the drum is not what is looked at */
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_stroke_plays_the_sound_from_its_frame_on),
    cmocka_unit_test(a_stroke_chokes_its_group_and_a_silence_all),
    cmocka_unit_test(blocks_and_saved_states_change_no_bit_of_sounds),
    cmocka_unit_test(the_gain_of_all_sounds_moves_smoothly),
    cmocka_unit_test(a_flood_and_what_is_dropped),
    cmocka_unit_test(sounds_of_other_rates_are_converted),
    cmocka_unit_test(sounds_go_on_in_a_kit_that_follows),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
