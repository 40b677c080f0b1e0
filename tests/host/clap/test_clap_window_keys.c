/* SPDX-License-Identifier: MIT */
/*
 * The window of the CLAP plugins without a mouse, and to the digit: keys turn, typed values, fine
 * steps and defaults, all parameters of drums and kits, saved sounds and favourites, mute and solo,
 * and what is undone and done again. PICTURES in the environment is a folder for pictures.
 */
#define _POSIX_C_SOURCE 200809L
#include "clap_window.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "drums/drum_file.h"
#include "kit/kit_file.h"
#include "plugin/kit_knobs.h"
#include "user_files.h"
#include "window_checks.h"

enum { FRAMES = 2400, STRAINER_ROW = 4 };

static Opened open_host(const char *id) {
  Opened opened = {.host = clap_host_open(&clap_entry, id)};
  const bool is_kit = strcmp(id, ID_KIT) == 0;
  clap_host_set_id(opened.host, 0, is_kit ? KIT_KNOB_QUALITY : clap_host_id(KNOB_QUALITY), 0);
  clap_host_flush(opened.host);
  clap_host_activate(opened.host);
  clap_host_render(opened.host, true);
  clap_host_run(opened.host, FRAMES);
  open_window(&opened, 1);
  return opened;
}

static double value_of(const Opened *opened, clap_id id) {
  const clap_plugin_params_t *const params = clap_host_extension(opened->host, CLAP_EXT_PARAMS);
  double value = NAN;
  assert_true(params->get_value(opened->host->plugin, id, &value));
  return value;
}

static double strainer(const Opened *opened) {
  return clap_host_value(opened->host, KNOB_STRAINER);
}

static void press_with(const Opened *opened, const char *name, unsigned state) {
  desktop_key(&server, opened->inner, name, state);
  tick(opened);
}

static void press_times(const Opened *opened, const char *name, int times) {
  for (int i = 0; i < times; i++) press_key(opened, name);
}

/* Types a value over the one of the focused control. */
static void type_value(const Opened *opened, const char *text) {
  press_key(opened, "Return");
  press_with(opened, "u", DESKTOP_CONTROL);
  type_text(opened, text);
  press_key(opened, "Return");
}

static bool state_has(const Opened *opened, const char *text) {
  static ClapState saved;
  clap_host_save(opened->host, &saved);
  assert_true(saved.size < CLAP_STATE);
  saved.bytes[saved.size] = '\0';
  return strstr(saved.bytes, text) != NULL;
}

/* ---- one control ---------------------------------------------------------------------------- */

static void keys_turn_a_control(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  assert_true(strainer(&opened) == 1);
  press_times(&opened, "Tab", STRAINER_ROW + 1);
  press_times(&opened, "Left", 5);
  assert_true(fabs(strainer(&opened) - 0.9) < 1e-6);
  press_with(&opened, "Left", DESKTOP_SHIFT);
  assert_true(fabs(strainer(&opened) - 0.898) < 1e-6);
  keep_picture(opened.outer, "focus");
  press_with(&opened, "z", DESKTOP_CONTROL); /* all steps of one turn at once */
  assert_true(strainer(&opened) == 1);
  press_with(&opened, "y", DESKTOP_CONTROL);
  assert_true(fabs(strainer(&opened) - 0.898) < 1e-6);
  press_key(&opened, "Delete");
  assert_true(strainer(&opened) == 1);
  press_with(&opened, "z", DESKTOP_CONTROL);
  assert_true(fabs(strainer(&opened) - 0.898) < 1e-6);
  press_with(&opened, "Z", DESKTOP_CONTROL | DESKTOP_SHIFT);
  assert_true(strainer(&opened) == 1);
  close_host(&opened);
}

static void values_are_typed(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  press_times(&opened, "Down", STRAINER_ROW + 1);
  type_value(&opened, "25");
  print_message("strainer %g\n", strainer(&opened));
  assert_true(fabs(strainer(&opened) - 0.25) < 1e-6);
  type_value(&opened, "nonsense");
  keep_picture(opened.outer, "refused");
  assert_true(fabs(strainer(&opened) - 0.25) < 1e-6);
  press_key(&opened, "Return");
  type_text(&opened, "1");
  press_key(&opened, "Escape");
  assert_true(fabs(strainer(&opened) - 0.25) < 1e-6);
  click(&opened, CONTROL_X + CONTROL_WIDTH - 10, CONTROL_Y + 10); /* the pitch's value */
  press_with(&opened, "u", DESKTOP_CONTROL);
  type_text(&opened, "a3");
  keep_picture(opened.outer, "typing");
  press_key(&opened, "Return");
  const double pitch = clap_host_value(opened.host, KNOB_BATTER_PITCH);
  print_message("pitch %.3f, A3 is at %.3f\n", pitch, clap_host_pitch(220));
  assert_true(fabs(pitch - clap_host_pitch(220)) < 1e-4);
  close_host(&opened);
}

static void a_double_click_is_the_default(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  click(&opened, CONTROL_X + CONTROL_WIDTH / 4, STRAINER_Y);
  assert_true(fabs(strainer(&opened) - 0.25) < 0.01);
  double_click(&opened, CONTROL_X + CONTROL_WIDTH / 2, STRAINER_Y);
  assert_true(strainer(&opened) == 1);
  click(&opened, REDO_X, BUTTON_Y); /* there is nothing */
  assert_true(strainer(&opened) == 1);
  click(&opened, UNDO_X, BUTTON_Y);
  assert_true(fabs(strainer(&opened) - 0.5) < 0.01); /* the first click of the two */
  click(&opened, REDO_X, BUTTON_Y);
  assert_true(strainer(&opened) == 1);
  close_host(&opened);
}

static void a_right_click_opens_the_hosts_menu(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  desktop_point(&server, opened.inner, DESKTOP_PRESS, DESKTOP_RIGHT, MIDDLE_X,
                MIDDLE_Y); /* the drum */
  tick(&opened);
  assert_int_equal(opened.host->menus, 0);
  desktop_point(&server, opened.inner, DESKTOP_PRESS, DESKTOP_RIGHT, CONTROL_X + 20, STRAINER_Y);
  tick(&opened);
  assert_int_equal(opened.host->menus, 1);
  assert_int_equal(opened.host->menu_of, clap_host_id(KNOB_STRAINER));
  assert_true(strainer(&opened) == 1);
  close_host(&opened);
}

static void space_strikes(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  double peak = 0;
  press_key(&opened, "space");
  clap_host_run(opened.host, FRAMES);
  for (uint32_t i = 0; i < FRAMES; i++) peak = fmax(peak, fabs((double)opened.host->sound[0][i]));
  assert_true(peak > 1e-3);
  close_host(&opened);
}

/* ---- all parameters ------------------------------------------------------------------------- */

/* Chooses the page from the list, by its place there. */
static void open_page(const Opened *opened, int steps_back) {
  press_key(opened, "p");
  press_key(opened, "End");
  press_times(opened, "Up", steps_back);
  press_key(opened, "Return");
}

/* The page of a section, among those of parameters. */
typedef struct Search {
  const char *section;
  char before[DEFINITION_KEY];
  int page, in_page, found;
} Search;

static void count_key(void *context, const char *key) {
  Search *const search = context;
  char here[DEFINITION_KEY];
  (void)snprintf(here, sizeof here, "%s", key);
  char *const dot = strrchr(here, '.');
  if (dot) *dot = '\0';
  if (strcmp(here, search->before) != 0 || search->in_page == KNOB_PAGE) {
    search->page++;
    search->in_page = 0;
  }
  search->in_page++;
  memcpy(search->before, here, sizeof here);
  if (search->found < 0 && strcmp(here, search->section) == 0) search->found = search->page;
}

static int page_of(bool is_kit, const char *section) {
  static Definition definition;
  Search search = {.section = section, .page = -1, .found = -1};
  definition.is_kit = is_kit;
  if (is_kit) {
    assert_int_equal(tabor_kit_def_preset(&definition.kit, "standard", NULL), TABOR_OK);
  } else {
    assert_int_equal(tabor_drum_def_preset(&definition.drum, "snare-14x5.5", NULL), TABOR_OK);
  }
  assert_true(definition_visit(&definition, count_key, &search));
  assert_true(search.found >= 0);
  return search.found;
}

static void go_to(const Opened *opened, int of_knobs, int page) {
  wheel(opened, PAGE_X, BUTTON_Y, -(of_knobs + page));
}

static void every_parameter_of_a_drum_can_be_typed(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  go_to(&opened, 4, page_of(false, "shell"));
  press_times(&opened, "Down", 2); /* depth */
  keep_picture(opened.outer, "parameters");
  type_value(&opened, "6 in");
  assert_true(state_has(&opened, "depth = 0.1524"));
  type_value(&opened, "99 m");
  keep_picture(opened.outer, "out-of-range");
  assert_true(state_has(&opened, "depth = 0.1524"));
  type_value(&opened, "6 kg");
  assert_true(state_has(&opened, "depth = 0.1524"));
  press_key(&opened, "Left"); /* by a step */
  assert_false(state_has(&opened, "depth = 0.1524"));
  press_with(&opened, "z", DESKTOP_CONTROL);
  assert_true(state_has(&opened, "depth = 0.1524"));
  press_key(&opened, "Delete");
  assert_true(state_has(&opened, "depth = 0.1397"));
  clap_host_run(opened.host, FRAMES);
  close_host(&opened);
}

/* A parameter and the knob of the same key are one. */
static void knobs_follow_parameters(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  const double before = clap_host_value(opened.host, KNOB_BATTER_TENSION);
  go_to(&opened, 4, page_of(false, "batter"));
  press_key(&opened, "Down"); /* tension */
  type_value(&opened, "3000");
  print_message("tension %.4f before, %.4f\n", before,
                clap_host_value(opened.host, KNOB_BATTER_TENSION));
  assert_true(state_has(&opened, "tension = 3000"));
  assert_true(clap_host_value(opened.host, KNOB_BATTER_TENSION) < before);
  clap_host_run(opened.host, FRAMES);
  assert_true(state_has(&opened, "tension = 3000"));
  close_host(&opened);
}

static void every_parameter_of_a_kit_can_be_typed(void **state) {
  (void)state;
  Opened opened = open_host(ID_KIT);
  go_to(&opened, 4, page_of(true, "drum.snare.shell"));
  press_times(&opened, "Down", 2);
  keep_picture(opened.outer, "kit-parameters");
  type_value(&opened, "6 in");
  assert_true(value_of(&opened, KIT_KNOB_KIT) == tabor_kit_count()); /* the user's own kit */
  assert_true(state_has(&opened, "shell.depth = 0.1524"));
  press_with(&opened, "z", DESKTOP_CONTROL);
  assert_true(value_of(&opened, KIT_KNOB_KIT) == 0);
  press_with(&opened, "y", DESKTOP_CONTROL);
  assert_true(value_of(&opened, KIT_KNOB_KIT) == tabor_kit_count());
  assert_true(state_has(&opened, "shell.depth = 0.1524"));
  type_value(&opened, "5 in");
  assert_true(state_has(&opened, "shell.depth = 0.127"));
  press_with(&opened, "z", DESKTOP_CONTROL); /* the own kit of before */
  assert_true(state_has(&opened, "shell.depth = 0.1524"));
  close_host(&opened);
}

static void the_list_of_pages_leads_to_a_page(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  click(&opened, PAGE_X, BUTTON_Y);
  keep_picture(opened.outer, "pages");
  press_key(&opened, "Escape");
  open_page(&opened, 0); /* the last */
  press_key(&opened, "Page_Down");
  press_times(&opened, "Down", STRAINER_ROW + 1); /* after the last comes the first */
  type_value(&opened, "50");
  assert_true(fabs(strainer(&opened) - 0.5) < 1e-6);
  press_with(&opened, "question", DESKTOP_SHIFT);
  keep_picture(opened.outer, "keys");
  press_key(&opened, "Escape");
  close_host(&opened);
}

/* ---- sounds of the user's own --------------------------------------------------------------- */

static void save_as(const Opened *opened, const char *name) {
  press_key(opened, "w");
  press_with(opened, "u", DESKTOP_CONTROL);
  type_text(opened, name);
  press_key(opened, "Return");
}

static void a_sound_is_saved_and_chosen_again(void **state) {
  (void)state;
  static TaborDrumDef def;
  char message[512];
  Opened opened = open_host(ID_DRUM);
  press_times(&opened, "Down", STRAINER_ROW + 1);
  type_value(&opened, "25");
  save_as(&opened, "soft");
  keep_picture(opened.outer, "saved");
  assert_int_equal(drum_file_read(user_file("soft.ini"), &def, message, sizeof message),
                   PRESET_FILE_OK);
  assert_string_equal(def.name, "soft");
  assert_true(def.wires.strainer == 0.25);
  save_as(&opened, "snare-14x5.5"); /* built in */
  press_key(&opened, "Escape");
  struct stat status;
  assert_true(stat(user_file("snare-14x5.5.ini"), &status) != 0);
  type_value(&opened, "50");
  save_as(&opened, "soft"); /* asks */
  keep_picture(opened.outer, "asks");
  assert_int_equal(drum_file_read(user_file("soft.ini"), &def, message, sizeof message),
                   PRESET_FILE_OK);
  assert_true(def.wires.strainer == 0.25);
  press_key(&opened, "Return");
  assert_int_equal(drum_file_read(user_file("soft.ini"), &def, message, sizeof message),
                   PRESET_FILE_OK);
  assert_true(def.wires.strainer == 0.5);
  press_key(&opened, "Delete");
  press_key(&opened, "l"); /* the list has it, last */
  press_key(&opened, "End");
  press_key(&opened, "Return");
  assert_true(strainer(&opened) == 0.5);
  press_key(&opened, "f");
  keep_picture(opened.outer, "favourite");
  assert_int_equal(stat(user_file("favourites"), &status), 0);
  close_host(&opened);
}

static void a_file_is_opened_by_its_path(void **state) {
  (void)state;
  Opened opened = open_host(ID_DRUM);
  press_key(&opened, "o");
  type_text(&opened, "/no/such.ini");
  press_key(&opened, "Return");
  keep_picture(opened.outer, "no-file");
  assert_false(state_has(&opened, "name = mine"));
  press_key(&opened, "o");
  type_text(&opened, user_file("kit.ini")); /* a kit is no drum */
  press_key(&opened, "Return");
  assert_false(state_has(&opened, "name = mine"));
  press_key(&opened, "o");
  type_text(&opened, user_file("drum.ini"));
  press_key(&opened, "Return");
  assert_true(state_has(&opened, "name = mine"));
  press_with(&opened, "z", DESKTOP_CONTROL);
  assert_false(state_has(&opened, "name = mine"));
  close_host(&opened);
}

static void a_kit_is_saved(void **state) {
  (void)state;
  static TaborKitDef def, standard;
  char message[512];
  Opened opened = open_host(ID_KIT);
  press_key(&opened, "Page_Down"); /* tunings */
  press_key(&opened, "Down");
  type_value(&opened, "2");
  save_as(&opened, "high");
  assert_int_equal(kit_file_read(user_file("high.ini"), &def, message, sizeof message),
                   PRESET_FILE_OK);
  assert_int_equal(tabor_kit_def_preset(&standard, "standard", NULL), TABOR_OK);
  assert_string_equal(def.name, "high");
  const double ratio = def.drum[0].def.batter.tension / standard.drum[0].def.batter.tension;
  print_message("two semitones: tension by %.4f\n", ratio);
  assert_true(fabs(ratio - exp2(4.0 / 12)) < 1e-9);
  assert_true(value_of(&opened, KIT_KNOB_KIT) == tabor_kit_count());
  assert_true(value_of(&opened, KIT_KNOB_TUNE) == 0); /* it is in the kit now */
  close_host(&opened);
}

/* ---- mute and solo -------------------------------------------------------------------------- */

static void levels_are_mute_and_solo(void **state) {
  (void)state;
  Opened opened = open_host(ID_KIT);
  press_key(&opened, "Down");
  type_value(&opened, "-6");
  press_key(&opened, "m");
  assert_true(value_of(&opened, KIT_KNOB_LEVEL) == -60);
  press_key(&opened, "m");
  assert_true(value_of(&opened, KIT_KNOB_LEVEL) == -6);
  press_key(&opened, "s");
  keep_picture(opened.outer, "solo");
  assert_true(value_of(&opened, KIT_KNOB_LEVEL) == -6);
  for (int i = 1; i < KIT_KNOB_DRUMS; i++)
    assert_true(value_of(&opened, (clap_id)(KIT_KNOB_LEVEL + i)) == -60);
  assert_true(value_of(&opened, KIT_KNOB_OVERHEADS) == -60);
  press_key(&opened, "s");
  for (int i = 1; i < KIT_KNOB_DRUMS; i++)
    assert_true(value_of(&opened, (clap_id)(KIT_KNOB_LEVEL + i)) == 0);
  click(&opened, CONTROL_X + 159, CONTROL_Y + 10); /* the mouse, on M */
  assert_true(value_of(&opened, KIT_KNOB_LEVEL) == -60);
  close_host(&opened);
}

static int run(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(keys_turn_a_control),
    cmocka_unit_test(values_are_typed),
    cmocka_unit_test(a_double_click_is_the_default),
    cmocka_unit_test(space_strikes),
    cmocka_unit_test(a_right_click_opens_the_hosts_menu),
    cmocka_unit_test(every_parameter_of_a_drum_can_be_typed),
    cmocka_unit_test(knobs_follow_parameters),
    cmocka_unit_test(every_parameter_of_a_kit_can_be_typed),
    cmocka_unit_test(the_list_of_pages_leads_to_a_page),
    cmocka_unit_test_setup_teardown(a_sound_is_saved_and_chosen_again, user_files_make,
                                    user_files_remove),
    cmocka_unit_test_setup_teardown(a_file_is_opened_by_its_path, user_files_make,
                                    user_files_remove),
    cmocka_unit_test_setup_teardown(a_kit_is_saved, user_files_make, user_files_remove),
    cmocka_unit_test(levels_are_mute_and_solo),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

int main(void) { return desktop_run(&server, run); }
