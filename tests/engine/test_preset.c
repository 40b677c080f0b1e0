/* SPDX-License-Identifier: MIT */
/* The built-in presets, and the files that they are made of. */
#include "definition/definition.h"
#include "definition/preset.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define FILE_LIMIT 65536

static TaborDrumDef load(const char *name) {
  TaborDrumDef def;
  TaborError error;
  memset(&def, 0xEE, sizeof def);
  if (tabor_drum_def_preset(&def, name, &error) != TABOR_OK)
    fail_msg("%s: %s", name, error.message);
  assert_int_equal(error.status, TABOR_OK);
  return def;
}

static void test_list(void **state) {
  (void)state;
  static const char *const names[] = {"tabor", "frame-drum", "bodhran-piano-string",
                                      "bodhran-d-string", "bodhran-d-string-tensioned"};
  enum { NAMES = sizeof names / sizeof *names };
  assert_true(tabor_preset_count() >= NAMES);
  assert_null(tabor_preset(tabor_preset_count()));
  assert_null(tabor_preset(UINT32_MAX));
  for (uint32_t i = 0; i < NAMES; i++) assert_string_equal(tabor_preset(i)->name, names[i]);
}

static void test_all_valid(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    const TaborPresetInfo *const info = tabor_preset(i);
    const TaborDrumDef def = load(info->name);
    TaborError error;
    if (tabor_drum_def_validate(&def, &error) != TABOR_OK)
      fail_msg("%s: %s", info->name, error.message);
    assert_string_equal(def.name, info->name);
    assert_string_equal(def.comment, info->comment);
    assert_true(strlen(info->comment) > 0 && strlen(def.license) > 0);
    assert_string_equal(def.mic[0].name, "top");
    assert_true(def.mic[0].height > 0);
    char file[TABOR_TEXT_SIZE];
    snprintf(file, sizeof file, "%s.ini", info->name);
    assert_string_equal(info->file, file);
  }
}

/* What a preset's own keys write gives the same preset: `tabor show` loses nothing. */
static void test_round_trip(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    const TaborDrumDef def = load(tabor_preset(i)->name);
    TaborDrumDef copy;
    tabor_drum_def_clear(&copy);
    char key[TABOR_TEXT_SIZE], value[TABOR_TEXT_SIZE];
    for (uint32_t k = 0; tabor_drum_def_key(&def, k, key, sizeof key); k++) {
      assert_int_equal(tabor_drum_def_get(&def, key, value, sizeof value, NULL), TABOR_OK);
      assert_int_equal(tabor_drum_def_set(&copy, key, value, NULL), TABOR_OK);
    }
    assert_memory_equal(&copy, &def, sizeof def);
  }
}

static void test_unknown(void **state) {
  (void)state;
  static const struct {
    const char *name, *nearest;
  } names[] = {
    {"taber", "'tabor'"},
    {"Tabor", "'tabor'"},
    {"framedrum", "'frame-drum'"},
    {"bodhran", "'bodhran-"},
    {"", "unknown preset ''"},
    {"-", "unknown preset '-'"},
    {"foo.bar", "unknown preset 'foo.bar'"},
    {"\x1b]0;x\n", "unknown preset '?]0;x?'"},
  };
  TaborDrumDef def, before;
  tabor_drum_def_default(&def);
  before = def;
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    TaborError error;
    assert_int_equal(tabor_drum_def_preset(&def, names[i].name, &error), TABOR_ERROR_NAME);
    assert_non_null(strstr(error.message, names[i].nearest));
    const bool is_guess = strstr(error.message, "did you mean") != NULL;
    assert_int_equal(is_guess, strncmp(names[i].nearest, "unknown", 7) != 0);
    for (const char *c = error.message; *c; c++) assert_true((unsigned char)*c >= 0x20);
    assert_memory_equal(&def, &before, sizeof def);
  }
  assert_int_equal(tabor_drum_def_preset(&def, "taber", NULL), TABOR_ERROR_NAME);
  assert_int_equal(tabor_drum_def_preset(&def, NULL, NULL), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_preset(NULL, "tabor", NULL), TABOR_ERROR_ARGUMENT);
}

/* What the issue and the founding paper ask of them. */
static void test_tabor(void **state) {
  (void)state;
  const TaborDrumDef def = load("tabor");
  assert_true(def.shell.radius >= 0.13);
  assert_int_equal(def.wires.count, 1);
  assert_int_equal(def.wires.side, TABOR_SIDE_ABOVE);
}

static void test_frame_drum(void **state) {
  (void)state;
  const TaborDrumDef def = load("frame-drum");
  assert_int_equal(def.wires.count, 0);
  assert_int_equal(def.shell.boundary, TABOR_BOUNDARY_OPEN);
}

static void assert_near(double value, double expected, double relative) {
  if (!(fabs(value - expected) <= relative * fabs(expected))) {
    fail_msg("%.17g is not within %g of %.17g", value, relative, expected);
  }
}

/* [Torin2014] section 2.1 and Table 1 as corrected in REFERENCES.md; a wound string bends half as
 * hard as solid steel of its size. */
static void check_bodhran(const TaborDrumDef *def, double density, double r, double tension) {
  const double pi = 3.14159265358979323846;
  assert_true(def->shell.radius == 0.2 && def->batter.surface_density == 0.26);
  assert_true(def->batter.tension == 3000 && def->batter.bending_stiffness == 0);
  assert_true(def->batter.damping_0 == 20 && def->batter.damping_1 == 0.0005);
  assert_near(def->wires.mass_per_length, density * pi * r * r, 1e-4);
  assert_near(def->wires.bending_stiffness, 0.5 * 2e11 * pi * r * r * r * r / 4, 3e-4);
  assert_true(def->wires.tension == tension);
  assert_true(def->wires.damping_0 == 2 && def->wires.damping_1 == 0.001);
  assert_true(def->strike.radius == 0.13 && def->mic[0].height == 0.08);
  assert_true(def->air.gravity > 9); /* an untensioned string comes back by its weight alone */
}

/* Everything but names and the string itself. */
static void assert_same_drum(TaborDrumDef def, const TaborDrumDef *other) {
  memcpy(def.name, other->name, sizeof def.name);
  memcpy(def.comment, other->comment, sizeof def.comment);
  def.wires.mass_per_length = other->wires.mass_per_length;
  def.wires.bending_stiffness = other->wires.bending_stiffness;
  def.wires.tension = other->wires.tension;
  assert_memory_equal(&def, other, sizeof def);
}

static void test_bodhran(void **state) {
  (void)state;
  const TaborDrumDef piano = load("bodhran-piano-string"), slack = load("bodhran-d-string");
  const TaborDrumDef tensioned = load("bodhran-d-string-tensioned");
  check_bodhran(&piano, 7800, 0.78e-3, 0.2);
  check_bodhran(&slack, 7041, 0.29e-3, 0.2);
  check_bodhran(&tensioned, 7041, 0.29e-3, 2.0);
  assert_same_drum(piano, &slack);
  assert_same_drum(tensioned, &slack);
}

/* Tunings -------------------------------------------------------------------------------------- */

static TaborStatus read_text(TaborDrumDef *def, const char *text, TaborError *error) {
  return tabor_drum_def_read(def, text, strlen(text), error);
}

static void test_base(void **state) {
  (void)state;
  TaborDrumDef def, expected = load("tom-12");
  TaborError error;
  assert_int_equal(tabor_drum_def_set(&expected, "drum.name", "low", NULL), TABOR_OK);
  assert_int_equal(tabor_drum_def_set(&expected, "batter.tension", "900", NULL), TABOR_OK);
  const char *const low = "[drum]\nbase = tom-12\nname = low\n[batter]\ntension = 900\n";
  assert_int_equal(read_text(&def, low, &error), TABOR_OK);
  assert_memory_equal(&def, &expected, sizeof def);
  const TaborDrumDef before = def;
  assert_int_equal(read_text(&def, "[drum]\nname = low\nbase = tom-12\n", &error), TABOR_ERROR_KEY);
  assert_string_equal(error.message, "'base' is not the first key of the file");
  assert_int_equal(error.line, 3);
  assert_int_equal(read_text(&def, "[drum]\nbase = tom-21\n", &error), TABOR_ERROR_NAME);
  assert_non_null(strstr(error.message, "did you mean 'tom-1"));
  assert_int_equal(error.line, 2);
  assert_memory_equal(&def, &before, sizeof def);
}

static const TaborPresetInfo *info_of(const char *name) {
  uint32_t i = 0;
  while (strcmp(tabor_preset(i)->name, name) != 0) i++;
  return tabor_preset(i);
}

/* Every preset has a category, a tuning that of its drum, and tunings stand behind the drums. tom-8
 * is a drum of another size than its base, fitted to a recording. */
static void test_tunings(void **state) {
  (void)state;
  uint32_t tunings = 0;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    const TaborPresetInfo *const info = tabor_preset(i);
    const TaborDrumDef def = load(info->name);
    assert_string_equal(info->category, def.category);
    assert_true(strlen(info->category) > 0);
    if (!info->base) assert_int_equal(tunings, 0);
    if (!info->base) continue;
    tunings++;
    const TaborDrumDef base = load(info->base);
    assert_null(info_of(info->base)->base);
    assert_string_equal(info->category, base.category);
    assert_memory_not_equal(&def.batter, &base.batter, sizeof def.batter);
    if (strcmp(info->name, "tom-8") != 0) assert_true(def.shell.radius == base.shell.radius);
  }
  assert_true(tunings >= 20);
}

/* The files ------------------------------------------------------------------------------------ */

/* " ; unit: reason" behind the value, or the whole line. */
static bool has_reason(const char *line) {
  if (*line == ';' || *line == '\0') return true;
  const char *const comment = strstr(line, " ; ");
  const char *const colon = comment ? strchr(comment, ':') : NULL;
  return colon && colon > comment + 3 && strlen(colon) > 4;
}

/* The unit in the comment is the table's: "m2/s" for damping_1. */
static bool has_unit(const char *line, const char *section) {
  char key[64], full[256];
  if (sscanf(line, "%63[a-z0-9_] =", key) != 1) return true;
  snprintf(full, sizeof full, "%s.%s", section, key);
  const TaborParameter *const row = tabor_parameter_find(full);
  if (strcmp(full, "drum.base") == 0) return strstr(line, " ; -:") != NULL;
  if (!row) return false;
  if (strchr(row->unit, '^'))
    return strstr(line, " ; N/m^") != NULL; /* with the exponent's value */
  char expected[64];
  snprintf(expected, sizeof expected, " ; %s:", *row->unit ? row->unit : "-");
  return strstr(line, expected) != NULL;
}

static void check_lines(FILE *file, const char *name) {
  char line[256], section[64] = "";
  for (int number = 1; fgets(line, sizeof line, file); number++) {
    assert_non_null(strchr(line, '\n'));
    *strchr(line, '\n') = '\0';
    (void)sscanf(line, "[%63[^]]", section);
    if (!has_reason(line)) fail_msg("%s:%d: no unit and reason: %s", name, number, line);
    if (!has_unit(line, section)) fail_msg("%s:%d: not the table's unit: %s", name, number, line);
  }
}

static void test_files(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    char path[1024];
    snprintf(path, sizeof path, "%s/../presets/%s", TABOR_TEST_DATA, tabor_preset(i)->file);
    FILE *const file = fopen(path, "rb");
    if (!file) fail_msg("%s cannot be opened", path);
    check_lines(file, tabor_preset(i)->file);
    assert_true(ftell(file) <= FILE_LIMIT);
    fclose(file);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_list),       cmocka_unit_test(test_all_valid),
    cmocka_unit_test(test_round_trip), cmocka_unit_test(test_unknown),
    cmocka_unit_test(test_tabor),      cmocka_unit_test(test_frame_drum),
    cmocka_unit_test(test_bodhran),    cmocka_unit_test(test_base),
    cmocka_unit_test(test_tunings),    cmocka_unit_test(test_files),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
