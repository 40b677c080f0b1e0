/* SPDX-License-Identifier: MIT */
/* Maps by name: what each note of an instrument stands for. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "midi/kit_map.h"

static KitMapNote table[MIDI_VALUES];

static void use(const char *name) {
  const KitMap *const map = kit_map_find(name);
  assert_non_null(map);
  kit_map_table(map, table);
}

static void stands_for(uint8_t note, uint8_t general, MidiStroke stroke) {
  assert_int_equal(table[note].general, general);
  assert_int_equal(table[note].stroke, stroke);
}

static void maps_have_names(void **state) {
  (void)state;
  static const char *const names[] = {"roland", "yamaha", "alesis", "superior", "addictive"};
  assert_int_equal(kit_map_count, sizeof names / sizeof *names);
  for (size_t i = 0; i < kit_map_count; i++) assert_string_equal(kit_maps[i].name, names[i]);
  assert_null(kit_map_find("Roland"));
  assert_null(kit_map_find(""));
}

static void without_a_map_notes_stand_for_themselves(void **state) {
  (void)state;
  kit_map_table(NULL, table);
  for (int note = 0; note < MIDI_VALUES; note++) {
    stands_for((uint8_t)note, (uint8_t)note, MIDI_STROKE_NONE);
  }
}

/* A second row of a note would hide the first; and all rows stand for notes of General MIDI's
 * percussion. */
static void a_note_has_one_row(void **state) {
  (void)state;
  for (size_t m = 0; m < kit_map_count; m++) {
    bool seen[MIDI_VALUES] = {false};
    for (size_t i = 0; i < kit_maps[m].count; i++) {
      const KitMapNote *const row = &kit_maps[m].notes[i];
      assert_true(row->note < MIDI_VALUES);
      assert_false(seen[row->note]);
      seen[row->note] = true;
      assert_in_range(row->general, 35, 81);
    }
  }
}

static void other_notes_stand_for_nothing(void **state) {
  (void)state;
  use("roland");
  stands_for(60, KIT_MAP_NOTHING, MIDI_STROKE_NONE);
  use("superior");
  stands_for(83, KIT_MAP_NOTHING, MIDI_STROKE_NONE); /* mutes the ride cymbal */
}

/* [RolandTD17] */
static void rims_of_roland_are_rimshots(void **state) {
  (void)state;
  use("roland");
  stands_for(36, 36, MIDI_STROKE_NONE);
  stands_for(40, 38, MIDI_STROKE_RIMSHOT);
  stands_for(37, 38, MIDI_STROKE_CROSS_STICK);
  stands_for(50, 48, MIDI_STROKE_RIMSHOT);
  stands_for(47, 45, MIDI_STROKE_RIMSHOT);
  stands_for(58, 43, MIDI_STROKE_RIMSHOT);
  stands_for(26, 46, MIDI_STROKE_NONE);
  stands_for(22, 42, MIDI_STROKE_NONE);
  stands_for(49, 49, MIDI_STROKE_BOW);
  stands_for(55, 49, MIDI_STROKE_EDGE);
  stands_for(52, 57, MIDI_STROKE_EDGE);
  stands_for(51, 51, MIDI_STROKE_NONE);
  stands_for(59, 51, MIDI_STROKE_EDGE);
}

/* [YamahaDTX502] */
static void rims_of_yamaha_are_open_or_closed(void **state) {
  (void)state;
  use("yamaha");
  stands_for(40, 38, MIDI_STROKE_RIMSHOT);
  stands_for(37, 38, MIDI_STROKE_CROSS_STICK);
  stands_for(31, 38, MIDI_STROKE_NONE);
  stands_for(34, 38, MIDI_STROKE_RIMSHOT);
  stands_for(27, 38, MIDI_STROKE_CROSS_STICK);
  for (uint8_t tom = 0; tom < 3; tom++) {
    static const uint8_t TOMS[] = {48, 47, 43};
    stands_for(TOMS[tom], TOMS[tom], MIDI_STROKE_NONE);
  }
  stands_for(78, 46, MIDI_STROKE_NONE);
  stands_for(79, 42, MIDI_STROKE_NONE);
  stands_for(52, 51, MIDI_STROKE_EDGE);
}

/* [AlesisNitro] */
static void alesis_has_four_toms_and_a_half_open_hi_hat(void **state) {
  (void)state;
  use("alesis");
  stands_for(23, 46, MIDI_STROKE_NONE);
  stands_for(21, 46, MIDI_STROKE_NONE);
  stands_for(40, 38, MIDI_STROKE_RIMSHOT);
  stands_for(47, 45, MIDI_STROKE_RIMSHOT);
  stands_for(41, 41, MIDI_STROKE_NONE);
  stands_for(39, 41, MIDI_STROKE_RIMSHOT);
  stands_for(37, KIT_MAP_NOTHING, MIDI_STROKE_NONE);
}

/* [SuperiorDrummer3], [AddictiveDrums2] */
static void plugins_have_rimshots_of_toms(void **state) {
  (void)state;
  use("superior");
  stands_for(47, 47, MIDI_STROKE_NONE);
  stands_for(82, 48, MIDI_STROKE_RIMSHOT);
  stands_for(73, 41, MIDI_STROKE_RIMSHOT);
  stands_for(55, 49, MIDI_STROKE_NONE);
  use("addictive");
  stands_for(37, 38, MIDI_STROKE_RIMSHOT);
  stands_for(42, 38, MIDI_STROKE_CROSS_STICK);
  stands_for(44, 38, MIDI_STROKE_RIM);
  stands_for(71, 48, MIDI_STROKE_NONE);
  stands_for(66, 41, MIDI_STROKE_RIMSHOT);
  stands_for(49, 42, MIDI_STROKE_NONE);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(maps_have_names),
    cmocka_unit_test(without_a_map_notes_stand_for_themselves),
    cmocka_unit_test(a_note_has_one_row),
    cmocka_unit_test(other_notes_stand_for_nothing),
    cmocka_unit_test(rims_of_roland_are_rimshots),
    cmocka_unit_test(rims_of_yamaha_are_open_or_closed),
    cmocka_unit_test(alesis_has_four_toms_and_a_half_open_hi_hat),
    cmocka_unit_test(plugins_have_rimshots_of_toms),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
