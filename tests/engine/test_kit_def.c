/* SPDX-License-Identifier: MIT */
/* Kit definitions: built-in kits, text, checks, and where microphones stand seen from a drum. */
#include "physics.h"
#include "tabor/kit.h"

static TaborKitDef *new_kit(void) {
  TaborKitDef *def = malloc(sizeof *def);
  tabor_kit_def_default(def);
  return def;
}

static void set(TaborKitDef *def, const char *key, const char *value) {
  TaborError error = {0};
  if (tabor_kit_def_set(def, key, value, &error) != TABOR_OK) fail_msg("%s", error.message);
}

static void refuse(TaborKitDef *def, const char *key, const char *value, TaborStatus status,
                   const char *part) {
  TaborKitDef *before = malloc(sizeof *before);
  TaborError error = {0};
  *before = *def;
  assert_int_equal(tabor_kit_def_set(def, key, value, &error), status);
  if (!strstr(error.message, part)) fail_msg("'%s' does not say '%s'", error.message, part);
  assert_memory_equal(before, def, sizeof *def);
  free(before);
}

static void built_in_kits_are_valid(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  assert_true(tabor_kit_count() > 0);
  assert_null(tabor_kit(tabor_kit_count()));
  for (uint32_t i = 0; i < tabor_kit_count(); i++) {
    TaborError error = {0};
    if (tabor_kit_def_preset(def, tabor_kit(i)->name, &error) != TABOR_OK) {
      fail_msg("%s: %s", tabor_kit(i)->name, error.message);
    }
    assert_string_equal(def->name, tabor_kit(i)->name);
    assert_string_equal(def->comment, tabor_kit(i)->comment);
    if (tabor_kit_def_validate(def, &error) != TABOR_OK) fail_msg("%s", error.message);
    for (uint32_t drum = 0; drum < def->drum_count; drum++) {
      TaborDrumDef placed;
      if (tabor_kit_def_place(def, drum, &placed, &error) != TABOR_OK) {
        fail_msg("%s", error.message);
      }
      if (tabor_drum_def_tune(&placed, &error) != TABOR_OK) { /* its pitches can be had */
        fail_msg("%s, %s: %s", def->name, def->drum[drum].name, error.message);
      }
    }
  }
  TaborError error = {0};
  assert_int_equal(tabor_kit_def_preset(def, "standart", &error), TABOR_ERROR_NAME);
  assert_non_null(strstr(error.message, "standard"));
  free(def);
}

static void text_sets_fields(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  set(def, "kit.coupling", "off");
  assert_int_equal(def->coupled, 0);
  set(def, "kit.coupling", "-6");
  assert_true(def->coupled == 1 && def->coupling == -6.0);
  set(def, "room.kind", "hall");
  assert_int_equal(def->room.kind, TABOR_ROOM_HALL);
  set(def, "drum.a.preset", "tom-12");
  set(def, "drum.a.head", "45, 47 48");
  set(def, "drum.a.rim", "49");
  set(def, "drum.a.head", "45");
  set(def, "drum.a.batter.tension", "2000");
  set(def, "drum.a.x", "-0.5");
  const TaborKitDrumDef *drum = &def->drum[0];
  assert_int_equal(def->drum_count, 1);
  assert_true(drum->x == -0.5 && drum->height == 0.7 && drum->def.batter.tension == 2000.0);
  assert_int_equal(drum->notes[45], TABOR_KIT_STROKE_HEAD);
  assert_int_equal(drum->notes[47], TABOR_KIT_STROKE_NONE);
  assert_int_equal(drum->notes[49], TABOR_KIT_STROKE_RIM);
  free(def);
}

static void bad_text_is_refused_and_changes_nothing(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  set(def, "drum.a.preset", "tom-12");
  set(def, "drum.a.head", "45");
  refuse(def, "drum.a.rim", "45", TABOR_ERROR_VALUE, "45");
  refuse(def, "drum.a.rim", "46, x", TABOR_ERROR_VALUE, "notes");
  refuse(def, "drum.a.rim", "128", TABOR_ERROR_VALUE, "127");
  refuse(def, "drum.a.rim", "1234", TABOR_ERROR_VALUE, "127");
  refuse(def, "drum.a.preset", "tom-21", TABOR_ERROR_NAME, "tom-21");
  refuse(def, "drum.b.preset", "tom-21", TABOR_ERROR_NAME, "tom-21");
  refuse(def, "drum.a.x", "6", TABOR_ERROR_RANGE, "-5 to 5");
  refuse(def, "drum.a.choke", "16", TABOR_ERROR_RANGE, "15");
  refuse(def, "drum.a.y", "left", TABOR_ERROR_VALUE, "left");
  refuse(def, "drum.a.batter.tension", "1", TABOR_ERROR_RANGE, "drum.a");
  refuse(def, "drum.a.batter.tensoin", "2000", TABOR_ERROR_KEY, "tension");
  refuse(def, "drum.a.colour", "red", TABOR_ERROR_KEY, "colour");
  refuse(def, "drum..x", "1", TABOR_ERROR_KEY, "name");
  refuse(def, "kit.coupling", "30", TABOR_ERROR_RANGE, "24");
  refuse(def, "kit.colour", "red", TABOR_ERROR_KEY, "colour");
  refuse(def, "room.kind", "cave", TABOR_ERROR_VALUE, "cave");
  refuse(def, "pedal.x", "1", TABOR_ERROR_KEY, "pedal.x");
  free(def);
}

/* Of a kit's key, of a drum's, and of a drum's that stands without the drum. */
static void a_mistaken_key_is_told_the_right_one(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  set(def, "drum.a.preset", "tom-12");
  refuse(def, "kit.couplnig", "0", TABOR_ERROR_KEY, "did you mean 'coupling'");
  refuse(def, "drum.a.heihgt", "1", TABOR_ERROR_KEY, "did you mean 'height'");
  refuse(def, "batter.tension", "2000", TABOR_ERROR_KEY, "'drum.NAME.batter.tension'");
  TaborError error = {0};
  assert_int_equal(tabor_kit_def_set(def, "pedal", "1", &error), TABOR_ERROR_KEY);
  assert_null(strstr(error.message, "NAME")); /* no drum has this either */
  free(def);
}

static void names_and_texts_have_a_longest(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  char key[TABOR_NAME_LENGTH + 16], text[sizeof def->comment + 1];
  snprintf(key, sizeof key, "drum.%0*d.x", TABOR_NAME_LENGTH, 7);
  set(def, key, "1");
  assert_int_equal(strlen(def->drum[0].name), TABOR_NAME_LENGTH);
  snprintf(key, sizeof key, "drum.%0*d.x", TABOR_NAME_LENGTH + 1, 7);
  refuse(def, key, "1", TABOR_ERROR_KEY, "a drum's name has 1 to");
  memset(text, 'x', sizeof text - 1);
  text[sizeof text - 1] = '\0';
  refuse(def, "kit.comment", text, TABOR_ERROR_VALUE, "longer than");
  text[sizeof text - 2] = '\0';
  set(def, "kit.comment", text);
  assert_string_equal(def->comment, text);
  free(def);
}

static void a_section_begins_its_drum(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  TaborError error = {0};
  assert_int_equal(tabor_kit_def_section(def, "kit", &error), TABOR_OK);
  assert_int_equal(tabor_kit_def_section(def, "room", &error), TABOR_OK);
  assert_int_equal(def->drum_count, 0);
  for (int twice = 0; twice < 2; twice++) {
    assert_int_equal(tabor_kit_def_section(def, "drum.a", &error), TABOR_OK);
    assert_int_equal(def->drum_count, 1);
  }
  TaborKitDef *other = new_kit();
  set(other, "drum.a.gain", "0");
  assert_memory_equal(&def->drum[0], &other->drum[0],
                      sizeof def->drum[0]); /* as by its first key */
  assert_int_equal(tabor_kit_def_section(def, "drum.a.b", &error), TABOR_ERROR_KEY);
  assert_int_equal(tabor_kit_def_section(def, "pedal", &error), TABOR_ERROR_KEY);
  assert_int_equal(def->drum_count, 1);
  free(other);
  free(def);
}

static void the_limits_of_numbers_are_allowed(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  set(def, "drum.a.x", "-5");
  set(def, "drum.a.y", "5");
  set(def, "drum.a.choke", "15");
  set(def, "drum.a.head", "0, 127");
  assert_true(def->drum[0].x == -5.0 && def->drum[0].y == 5.0 && def->drum[0].choke == 15);
  assert_int_equal(def->drum[0].notes[0], TABOR_KIT_STROKE_HEAD);
  assert_int_equal(def->drum[0].notes[127], TABOR_KIT_STROKE_HEAD);
  set(def, "drum.a.head", "");
  assert_int_equal(def->drum[0].notes[127], TABOR_KIT_STROKE_NONE);
  free(def);
}

static void a_kit_has_sixteen_drums_and_one_drum_a_note(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  char key[32];
  for (int i = 0; i < TABOR_KIT_DRUMS; i++) {
    snprintf(key, sizeof key, "drum.d%d.preset", i);
    set(def, key, "frame-drum");
  }
  TaborError error = {0};
  assert_int_equal(tabor_kit_def_validate(def, &error), TABOR_OK);
  refuse(def, "drum.more.preset", "frame-drum", TABOR_ERROR_FULL, "16");
  set(def, "drum.d3.head", "60");
  set(def, "drum.d7.rim", "60");
  assert_int_equal(tabor_kit_def_validate(def, &error), TABOR_ERROR_VALUE);
  assert_non_null(strstr(error.message, "60"));
  free(def);
}

/* A microphone 1 m over the floor and 0.5 m to the right, seen by a drum that lies on its side:
 * along the axis is to the player. */
static void a_tilted_drum_sees_the_overheads_turned(void **state) {
  (void)state;
  TaborKitDef *def = new_kit();
  TaborDrumDef placed;
  TaborError error = {0};
  set(def, "kit.overhead_height", "1.3");
  set(def, "kit.overhead_spacing", "1");
  set(def, "kit.overhead_y", "-0.25");
  set(def, "drum.a.preset", "bass-drum-22");
  set(def, "drum.a.height", "0.3");
  set(def, "drum.a.tilt", "90");
  assert_int_equal(tabor_kit_def_place(def, 0, &placed, &error), TABOR_OK);
  const TaborMicDef *right = &placed.mic[tabor_drum_def_find_mic(&placed, TABOR_KIT_RIGHT)];
  const double rounding = 1e-12;
  assert_true(fabs(right->height - 0.25) < rounding);
  assert_true(fabs(right->radius - hypot(0.5, 1.0)) < rounding);
  set(def, "drum.a.tilt", "0");
  assert_int_equal(tabor_kit_def_place(def, 0, &placed, &error), TABOR_OK);
  right = &placed.mic[tabor_drum_def_find_mic(&placed, TABOR_KIT_RIGHT)];
  assert_true(fabs(right->height - 1.0) < rounding);
  assert_true(fabs(right->radius - hypot(0.5, 0.25)) < rounding);
  free(def);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(built_in_kits_are_valid),
    cmocka_unit_test(text_sets_fields),
    cmocka_unit_test(bad_text_is_refused_and_changes_nothing),
    cmocka_unit_test(a_mistaken_key_is_told_the_right_one),
    cmocka_unit_test(names_and_texts_have_a_longest),
    cmocka_unit_test(a_section_begins_its_drum),
    cmocka_unit_test(the_limits_of_numbers_are_allowed),
    cmocka_unit_test(a_kit_has_sixteen_drums_and_one_drum_a_note),
    cmocka_unit_test(a_tilted_drum_sees_the_overheads_turned),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
