/* SPDX-License-Identifier: MIT */
/* MIDI on a kit: which drum hears which message. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "kit/kit_midi.h"

static TaborKitDef *kit;
static KitMidi *midi;
static TaborKitEvent events[KIT_MIDI_MOST_EVENTS];

static int prepare(void **state) {
  (void)state;
  kit = malloc(sizeof *kit);
  midi = malloc(sizeof *midi);
  if (tabor_kit_def_preset(kit, "standard", NULL) != TABOR_OK) return 1;
  kit_midi_begin(midi, kit, &kit_midi_setup_default);
  return 0;
}

static int clean_up(void **state) {
  (void)state;
  free(midi);
  free(kit);
  return 0;
}

static uint32_t take(uint8_t status, uint8_t first, uint8_t second) {
  const MidiMessage message = {.status = status, .data = {first, second}};
  return kit_midi_take(midi, &message, events);
}

static void a_note_goes_to_its_drum_alone(void **state) {
  (void)state;
  static const struct {
    uint8_t note;
    const char *drum;
    uint32_t technique;
  } rows[] = {{36, "kick", TABOR_TECHNIQUE_NORMAL},       {38, "snare", TABOR_TECHNIQUE_NORMAL},
              {37, "snare", TABOR_TECHNIQUE_CROSS_STICK}, {40, "snare", TABOR_TECHNIQUE_RIMSHOT},
              {50, "high-tom", TABOR_TECHNIQUE_NORMAL},   {45, "low-tom", TABOR_TECHNIQUE_NORMAL},
              {41, "floor-tom", TABOR_TECHNIQUE_NORMAL}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    assert_int_equal(take(0x99, rows[i].note, 100), 1);
    assert_int_equal(events[0].drum, tabor_kit_def_find(kit, rows[i].drum));
    assert_int_equal(events[0].event.type, TABOR_EVENT_STRIKE);
    assert_int_equal(events[0].event.technique, rows[i].technique);
    assert_int_equal(take(0x89, rows[i].note, 0), 0);
  }
}

/* A bass drum is struck where its beater lands, not in the middle as note 36 of a single drum is.
 */
static void a_drum_is_struck_where_its_preset_says(void **state) {
  (void)state;
  const TaborDrumDef *kick = &kit->drum[tabor_kit_def_find(kit, "kick")].def;
  assert_int_equal(take(0x99, 36, 100), 1);
  assert_true(events[0].event.radius == kick->strike.radius);
}

static void unknown_notes_are_counted_and_named(void **state) {
  (void)state;
  assert_int_equal(take(0x99, 54, 100), 0);
  assert_int_equal(take(0x99, 54, 0), 0); /* its end */
  assert_int_equal(take(0x99, 54, 1), 0);
  assert_int_equal(midi->unknown[54], 2);
  assert_string_equal(kit_midi_note_name(54), "tambourine");
  assert_string_equal(kit_midi_note_name(35), "acoustic bass drum");
  assert_string_equal(kit_midi_note_name(81), "open triangle");
  assert_null(kit_midi_note_name(34));
  assert_null(kit_midi_note_name(82));
}

static void silence_and_gain_reach_all_drums(void **state) {
  (void)state;
  assert_int_equal(take(0xB9, 123, 0), kit->drum_count);
  for (uint32_t i = 0; i < kit->drum_count; i++) {
    assert_int_equal(events[i].drum, i);
    assert_int_equal(events[i].event.type, TABOR_EVENT_SILENCE);
  }
  assert_int_equal(take(0xB9, 7, 127), kit->drum_count);
  assert_int_equal(events[0].event.type, TABOR_EVENT_GAIN);
  assert_int_equal(take(0xC9, 3, 0), 0); /* a program */
}

/* The prefix of a velocity is for the next note, whichever drum that plays. */
static void a_velocity_prefix_is_for_one_note(void **state) {
  (void)state;
  assert_int_equal(take(0x99, 38, 64), 1);
  const double plain = events[0].event.velocity;
  assert_int_equal(take(0xB9, 88, 127), 0);
  assert_int_equal(take(0x99, 36, 64), 1); /* takes it */
  assert_int_equal(take(0x99, 38, 64), 1);
  assert_true(events[0].event.velocity == plain);
  assert_int_equal(take(0xB9, 88, 127), 0);
  assert_int_equal(take(0x99, 38, 64), 1);
  assert_true(events[0].event.velocity > plain);
}

static void key_pressure_lays_a_hand_on_the_notes_drum(void **state) {
  (void)state;
  assert_int_equal(take(0xA9, 50, 127), 1);
  assert_int_equal(events[0].drum, tabor_kit_def_find(kit, "high-tom"));
  assert_int_equal(events[0].event.type, TABOR_EVENT_DAMP);
  assert_int_equal(take(0xA9, 54, 127), 0);
}

/* A buzz that was begun before the kit was tuned ends with its note, and a hand is lifted. */
static void a_kit_that_follows_knows_what_is_held(void **state) {
  (void)state;
  const int snare = tabor_kit_def_find(kit, "snare");
  kit->drum[snare].notes[29] = TABOR_KIT_STROKE_BUZZ;
  kit_midi_begin(midi, kit, &kit_midi_setup_default);
  KitMidi *const before = midi, *const after = malloc(sizeof *after);
  kit->drum[snare].def.strike.radius *= 0.5;
  kit_midi_begin(after, kit, &kit_midi_setup_default);
  assert_int_equal(take(0x99, 29, 100), 1);
  assert_int_equal(events[0].event.technique, TABOR_TECHNIQUE_BUZZ);
  assert_int_equal(take(0xA9, 50, 127), 1);
  kit_midi_follow(after, before);
  midi = after;
  free(before);
  assert_int_equal(take(0x89, 29, 0), 1);
  assert_int_equal(events[0].drum, snare);
  assert_int_equal(events[0].event.type, TABOR_EVENT_RELEASE);
  assert_int_equal(take(0xA9, 50, 0), 1);
  assert_int_equal(events[0].event.type, TABOR_EVENT_RELEASE);
  assert_int_equal(take(0x99, 38, 100), 1); /* where the kit has it now */
  assert_true(events[0].event.radius == kit->drum[snare].def.strike.radius);
  assert_int_equal(midi->strokes[snare], 2);
}

static void other_channels_are_passed_over(void **state) {
  (void)state;
  KitMidiSetup setup = kit_midi_setup_default;
  setup.channel = 9;
  kit_midi_begin(midi, kit, &setup);
  assert_int_equal(take(0x98, 38, 100), 0);
  assert_int_equal(take(0x98, 42, 100), 0);
  assert_int_equal(midi->unknown[42], 0);
  assert_int_equal(take(0x99, 38, 100), 1);
}

static void use_map(const char *name) {
  KitMidiSetup setup = kit_midi_setup_default;
  setup.map = kit_map_find(name);
  assert_non_null(setup.map);
  kit_midi_begin(midi, kit, &setup);
}

static void a_map_by_name_translates_notes(void **state) {
  (void)state;
  static const struct {
    const char *map;
    uint8_t note;
    const char *drum;
    uint32_t technique;
  } rows[] = {{"roland", 38, "snare", TABOR_TECHNIQUE_NORMAL},
              {"roland", 40, "snare", TABOR_TECHNIQUE_RIMSHOT},
              {"roland", 37, "snare", TABOR_TECHNIQUE_CROSS_STICK},
              {"roland", 47, "low-tom", TABOR_TECHNIQUE_RIMSHOT},
              {"roland", 58, "floor-tom", TABOR_TECHNIQUE_RIMSHOT},
              {"yamaha", 31, "snare", TABOR_TECHNIQUE_NORMAL},
              {"alesis", 50, "high-tom", TABOR_TECHNIQUE_RIMSHOT},
              {"superior", 75, "floor-tom", TABOR_TECHNIQUE_RIMSHOT},
              {"addictive", 44, "snare", TABOR_TECHNIQUE_RIM},
              {"addictive", 71, "high-tom", TABOR_TECHNIQUE_NORMAL}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    use_map(rows[i].map);
    assert_int_equal(take(0x99, rows[i].note, 100), 1);
    assert_int_equal(events[0].drum, tabor_kit_def_find(kit, rows[i].drum));
    assert_int_equal(events[0].event.technique, rows[i].technique);
    assert_int_equal(take(0x89, rows[i].note, 64), 0);
  }
}

/* A note of the instrument plays the sample of the General MIDI note that it stands for, or is
 * counted as it came. */
static void a_map_by_name_finds_samples(void **state) {
  (void)state;
  use_map("roland");
  midi->has_sample[46] = true;
  assert_int_equal(take(0x99, 26, 127), 1);
  assert_int_equal(events[0].drum, TABOR_KIT_NOTE + 46);
  assert_int_equal(events[0].event.type, TABOR_EVENT_STRIKE);
  assert_true(events[0].event.velocity == 1);
  assert_int_equal(take(0x99, 22, 127), 2); /* the kit's hi-hat: pedal and stroke */
  assert_int_equal(midi->general[22], 42);
  assert_int_equal(take(0x99, 60, 127), 0);
  assert_int_equal(midi->unknown[60], 1);
}

/* A note-on of velocity 0 ends a note, which a sample does not hear; key pressure of a grabbed
 * cymbal chokes it. */
static void a_sample_is_struck_and_choked_but_not_ended(void **state) {
  (void)state;
  kit_midi_begin(midi, kit, &kit_midi_setup_default);
  midi->has_sample[42] = true;
  assert_int_equal(take(0x99, 42, 1), 1);
  assert_int_equal(events[0].event.type, TABOR_EVENT_STRIKE);
  assert_int_equal(take(0x99, 42, 0), 0);
  assert_int_equal(take(0x89, 42, 64), 0);
  assert_int_equal(take(0xA9, 42, 0), 0);
  assert_int_equal(take(0xA9, 42, 1), 0);
  assert_int_equal(take(0xA9, 42, 2), 1);
  assert_int_equal(events[0].drum, TABOR_KIT_NOTE + 42);
  assert_int_equal(events[0].event.type, TABOR_EVENT_SILENCE);
  assert_int_equal(midi->unknown[42], 0);
}

static double radius_after(uint8_t controller, uint8_t value, uint8_t note) {
  assert_int_equal(take(0xB9, controller, value), 0);
  assert_int_equal(take(0x99, note, 100), 1);
  return events[0].event.radius;
}

/* 16 is the snare pad's place, 17 the ride cymbal's and 18 the toms'; a kick has none. */
static void a_place_moves_its_drum_alone(void **state) {
  (void)state;
  use_map("roland");
  assert_int_equal(take(0x99, 48, 100), 1);
  const double tom = events[0].event.radius;
  assert_int_equal(take(0x99, 36, 100), 1);
  const double kick = events[0].event.radius;
  assert_true(radius_after(16, 0, 38) == 0);
  assert_true(radius_after(16, 127, 38) >
              0.9 * kit->drum[tabor_kit_def_find(kit, "snare")].def.shell.radius);
  assert_true(radius_after(16, 0, 48) == tom);
  assert_true(radius_after(16, 0, 36) == kick);
  const double angle = events[0].event.angle;
  assert_true(radius_after(17, 127, 36) == kick);
  assert_true(events[0].event.angle == angle);
  assert_true(radius_after(18, 0, 48) == 0);
  assert_true(radius_after(18, 127, 38) == 0);
}

static void the_controllers_of_places_can_be_chosen(void **state) {
  (void)state;
  KitMidiSetup setup = kit_midi_setup_default;
  setup.map = kit_map_find("roland");
  setup.snare_place = setup.toms_place = 17;
  kit_midi_begin(midi, kit, &setup);
  assert_true(radius_after(16, 0, 38) > 0);
  assert_true(radius_after(17, 0, 38) == 0);
  assert_true(radius_after(17, 0, 43) == 0);
}

/* Without a map by name, 16 is the place of all drums, as before. */
static void without_a_map_a_place_moves_all_drums(void **state) {
  (void)state;
  assert_true(radius_after(16, 0, 38) == 0);
  assert_true(radius_after(16, 0, 48) == 0);
}

static void key_pressure_chokes_on_every_note_of_a_drum(void **state) {
  (void)state;
  static const uint8_t notes[] = {38, 40, 37};
  use_map("roland");
  for (size_t i = 0; i < sizeof notes; i++) {
    assert_int_equal(take(0xA9, notes[i], 127), 1);
    assert_int_equal(events[0].drum, tabor_kit_def_find(kit, "snare"));
    assert_int_equal(events[0].event.type, TABOR_EVENT_DAMP);
    assert_int_equal(take(0xA9, notes[i], 0), 1);
    assert_int_equal(events[0].event.type, TABOR_EVENT_RELEASE);
  }
}

/* A closed hi-hat is grabbed at its edge or at its bow, notes 22 and 42. */
static void key_pressure_chokes_a_sample(void **state) {
  (void)state;
  use_map("roland");
  midi->has_sample[42] = true;
  for (uint8_t note = 22; note <= 42; note += 20) {
    assert_int_equal(take(0xA9, note, 127), 1);
    assert_int_equal(events[0].drum, TABOR_KIT_NOTE + 42);
    assert_int_equal(events[0].event.type, TABOR_EVENT_SILENCE);
    assert_int_equal(take(0xA9, note, 0), 0);
    assert_int_equal(take(0xA9, note, 1), 0);
    assert_int_equal(take(0x89, note, 64), 0);
  }
}

/* (velocity + prefix/128)/127, and no more than 1. */
static void a_velocity_prefix_reaches_samples(void **state) {
  (void)state;
  midi->has_sample[42] = true;
  assert_int_equal(take(0xB9, 88, 64), 0);
  assert_int_equal(take(0x99, 42, 100), 1);
  assert_true(events[0].event.velocity == 100.5 / 127);
  assert_int_equal(take(0x99, 42, 100), 1);
  assert_true(events[0].event.velocity == 100.0 / 127);
  assert_int_equal(take(0xB9, 88, 127), 0);
  assert_int_equal(take(0x99, 42, 127), 1);
  assert_true(events[0].event.velocity == 1);
}

static const TaborHihatDef *hihat_of_kit(void) {
  return &kit->drum[tabor_kit_def_find(kit, "hihat")].def.hihat;
}

static void assert_opening(uint32_t i, double value) {
  assert_int_equal(events[i].drum, tabor_kit_def_find(kit, "hihat"));
  assert_int_equal(events[i].event.type, TABOR_EVENT_PARAMETER);
  assert_int_equal(events[i].event.parameter, tabor_parameter_find("hihat.opening")->id);
  assert_true(fabs(events[i].event.value - value) < 1e-12);
}

/* A hand chokes a cymbal at its edge, and damps a drum inside. */
static void key_pressure_grips_a_cymbals_edge(void **state) {
  (void)state;
  assert_int_equal(take(0xA9, 49, 127), 1);
  const TaborDrumDef *crash = &kit->drum[events[0].drum].def;
  assert_string_equal(kit->drum[events[0].drum].name, "crash");
  assert_int_equal(events[0].event.type, TABOR_EVENT_DAMP);
  assert_true(events[0].event.radius > 0.9 * crash->shell.radius);
  assert_true(fabs(events[0].event.value - 30) < 1e-9);
  assert_int_equal(take(0xA9, 49, 0), 1);
  assert_int_equal(events[0].event.type, TABOR_EVENT_RELEASE);
  assert_int_equal(take(0xA9, 38, 127), 1);
  assert_true(fabs(events[0].event.value - 6) < 1e-9);
}

/* The pedal moves before the tip strikes. */
static void notes_of_a_hihat_move_its_pedal(void **state) {
  (void)state;
  const TaborHihatDef *hihat = hihat_of_kit();
  assert_int_equal(take(0x99, 42, 100), 2);
  assert_opening(0, hihat->closed);
  assert_int_equal(events[1].event.type, TABOR_EVENT_STRIKE);
  assert_int_equal(take(0x89, 42, 0), 0);
  assert_int_equal(take(0x99, 46, 100), 2);
  assert_opening(0, hihat->open);
  const double speed = events[1].event.velocity;
  assert_int_equal(take(0x99, 44, 100), 1);
  assert_int_equal(events[0].event.technique, TABOR_TECHNIQUE_PEDAL);
  assert_true(fabs(events[0].event.velocity / speed - 0.25) < 1e-12);
}

/* Once the pedal is played, notes leave it where it is. */
static void a_pedal_that_is_played_decides(void **state) {
  (void)state;
  const TaborHihatDef *hihat = hihat_of_kit();
  assert_int_equal(take(0xB9, 4, 0), 1);
  assert_opening(0, hihat->open);
  assert_int_equal(take(0xB9, 4, 112), 1);
  assert_opening(0, hihat->closed);
  assert_int_equal(take(0xB9, 4, 127), 1);
  assert_opening(0, 2 * hihat->closed);
  double last = 1;
  for (uint8_t value = 0; value < 128; value++) { /* the farther down the tighter */
    assert_int_equal(take(0xB9, 4, value), 1);
    assert_true(events[0].event.value < last);
    last = events[0].event.value;
  }
  assert_int_equal(take(0x99, 42, 100), 1);
  assert_int_equal(events[0].event.type, TABOR_EVENT_STRIKE);
  assert_int_equal(take(0x99, 46, 100), 1);
  kit_midi_rest(midi);
  assert_int_equal(take(0x99, 46, 100), 2);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup_teardown(a_note_goes_to_its_drum_alone, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_drum_is_struck_where_its_preset_says, prepare, clean_up),
    cmocka_unit_test_setup_teardown(unknown_notes_are_counted_and_named, prepare, clean_up),
    cmocka_unit_test_setup_teardown(silence_and_gain_reach_all_drums, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_velocity_prefix_is_for_one_note, prepare, clean_up),
    cmocka_unit_test_setup_teardown(key_pressure_lays_a_hand_on_the_notes_drum, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_kit_that_follows_knows_what_is_held, prepare, clean_up),
    cmocka_unit_test_setup_teardown(other_channels_are_passed_over, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_map_by_name_translates_notes, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_sample_is_struck_and_choked_but_not_ended, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_map_by_name_finds_samples, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_place_moves_its_drum_alone, prepare, clean_up),
    cmocka_unit_test_setup_teardown(the_controllers_of_places_can_be_chosen, prepare, clean_up),
    cmocka_unit_test_setup_teardown(without_a_map_a_place_moves_all_drums, prepare, clean_up),
    cmocka_unit_test_setup_teardown(key_pressure_chokes_on_every_note_of_a_drum, prepare, clean_up),
    cmocka_unit_test_setup_teardown(key_pressure_chokes_a_sample, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_velocity_prefix_reaches_samples, prepare, clean_up),
    cmocka_unit_test_setup_teardown(key_pressure_grips_a_cymbals_edge, prepare, clean_up),
    cmocka_unit_test_setup_teardown(notes_of_a_hihat_move_its_pedal, prepare, clean_up),
    cmocka_unit_test_setup_teardown(a_pedal_that_is_played_decides, prepare, clean_up),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
