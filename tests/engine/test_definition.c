/* SPDX-License-Identifier: MIT */
/* The parameter table, setting and getting, and the validation of definitions from anywhere. */
#define _GNU_SOURCE /* mkdtemp, setenv */
#include "definition/def_key.h"
#include "definition/def_text.h"
#include "definition/definition.h"
#include "definition/error.h"
#include "definition/params.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* A fixed sequence; its seed is printed by the tests that use it. */
typedef struct Random {
  uint64_t state;
} Random;

static uint32_t random_whole(Random *random) {
  random->state = random->state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(random->state >> 32);
}

static uint32_t random_below(Random *random, uint32_t limit) {
  return random_whole(random) % limit;
}

static double random_bits(Random *random) {
  const uint64_t bits = (uint64_t)random_whole(random) << 32 | random_whole(random);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static bool same_bits(const void *a, const void *b, size_t size) { return memcmp(a, b, size) == 0; }

/* One line without control characters, and an error that belongs to its status. */
static void assert_tidy(const TaborError *error, TaborStatus status) {
  assert_int_equal(error->status, status);
  assert_true(tb_text_is_valid(error->message, sizeof error->message));
  assert_true(tb_text_is_valid(error->key, sizeof error->key));
  assert_true(tb_text_is_valid(error->value, sizeof error->value));
  assert_int_equal(*error->message == '\0', status == TABOR_OK);
}

/* set() must fail with this status, name the key and leave the definition alone. */
static void refuse_set(const char *key, const char *value, TaborStatus status, const char *part) {
  TaborDrumDef def, before;
  TaborError error;
  tabor_drum_def_default(&def);
  before = def;
  const TaborStatus got = tabor_drum_def_set(&def, key, value, &error);
  if (got != status || !strstr(error.message, part)) {
    fail_msg("%s = '%s': status %d, not %d: %s (expected '%s')", key, value, got, status,
             error.message, part);
  }
  assert_tidy(&error, status);
  assert_true(same_bits(&def, &before, sizeof def));
  assert_int_equal(tabor_drum_def_set(&def, key, value, NULL), status);
}

/* validate() must fail with this status and name the key. */
static void refuse_def(const TaborDrumDef *def, TaborStatus status, const char *key,
                       const char *part) {
  TaborError error;
  const TaborStatus got = tabor_drum_def_validate(def, &error);
  if (got != status || strcmp(error.key, key) != 0 || !strstr(error.message, part)) {
    fail_msg("status %d, not %d; key '%s', not '%s': %s", got, status, error.key, key,
             error.message);
  }
  assert_tidy(&error, status);
  assert_int_equal(tabor_drum_def_validate(def, NULL), status);
}

static void must_set(TaborDrumDef *def, const char *key, const char *value) {
  TaborError error;
  if (tabor_drum_def_set(def, key, value, &error) != TABOR_OK) fail_msg("%s", error.message);
  assert_tidy(&error, TABOR_OK);
}

static void must_validate(const TaborDrumDef *def) {
  TaborError error;
  if (tabor_drum_def_validate(def, &error) != TABOR_OK) fail_msg("%s", error.message);
  assert_tidy(&error, TABOR_OK);
}

/* The table ------------------------------------------------------------------------------------ */

static void check_row(const TaborParameter *row) {
  assert_non_null(row->section);
  assert_non_null(row->key);
  assert_non_null(row->unit);
  assert_true(row->text && *row->text);
  assert_true(row->id > 0);
  const bool has_range = row->type == TABOR_TYPE_NUMBER || row->type == TABOR_TYPE_WHOLE;
  assert_int_equal(isnan(row->minimum), !has_range);
  assert_int_equal(isnan(row->maximum), !has_range);
  assert_int_equal(row->choices != NULL, row->type == TABOR_TYPE_CHOICE);
  assert_true(!has_range || row->minimum < row->maximum);
  assert_true(!row->logarithmic || row->minimum > 0);
  const bool follows = strcmp(row->section, "wire.") == 0 ||
                       (strncmp(row->key, "lug_", 4) == 0 && strspn(row->key + 4, "123456789") > 0);
  assert_int_equal(isnan(row->fallback), row->type == TABOR_TYPE_TEXT || follows);
  if (has_range && !follows) {
    assert_true(row->fallback >= row->minimum && row->fallback <= row->maximum);
  }
}

static void test_table(void **state) {
  (void)state;
  const uint32_t count = tabor_parameter_count();
  assert_true(count > 60);
  assert_null(tabor_parameter(count));
  assert_null(tabor_parameter(UINT32_MAX));
  for (uint32_t i = 0; i < count; i++) {
    const TaborParameter *const row = tabor_parameter(i);
    check_row(row);
    assert_ptr_equal(tb_param_by_id(row->id), &tb_params[i]);
    for (uint32_t j = 0; j < i; j++) {
      const TaborParameter *const other = tabor_parameter(j);
      assert_int_not_equal(row->id, other->id);
      assert_false(strcmp(row->section, other->section) == 0 && strcmp(row->key, other->key) == 0);
    }
  }
  assert_null(tb_param_by_id(0));
  assert_null(tb_param_by_id(99999));
}

/* Saved automation holds on to these numbers. */
static void test_live_keys(void **state) {
  (void)state;
  static const struct {
    const char *key;
    uint32_t id;
  } live[] = {
    {"batter.muffle_strength", 308}, {"resonant.muffle_strength", 408}, {"wires.tension", 508},
    {"wires.damping_0", 512},        {"wires.damping_1", 513},          {"wires.strainer", 514},
    {"mic.top.gain", 1103},          {"output.full_scale", 1400},       {"hand.grip", 803},
    {"hihat.opening", 1700},
  };
  uint32_t count = 0;
  for (uint32_t i = 0; i < tabor_parameter_count(); i++) count += tabor_parameter(i)->live;
  assert_int_equal(count, sizeof live / sizeof live[0]);
  for (size_t i = 0; i < sizeof live / sizeof live[0]; i++) {
    const TaborParameter *const row = tabor_parameter_find(live[i].key);
    assert_non_null(row);
    assert_true(row->live);
    assert_int_equal(row->id, live[i].id);
  }
}

static void test_parameter_find(void **state) {
  (void)state;
  assert_string_equal(tabor_parameter_find("wire.40.offset")->key, "offset");
  assert_string_equal(tabor_parameter_find("striker.my-stick_2.mass")->section, "striker.");
  static const char *const unknown[] = {
    "",
    ".",
    "..",
    "batter",
    "batter.",
    ".tension",
    "batter.tension.",
    "batter.x.tension",
    "mic.gain",
    "mic..gain",
    "mic.top.",
    "mic.a.b.gain",
    "mic.a b.gain",
    "wire.0.tension",
    "wire.41.tension",
    "wire.01.tension",
    "wire.x.tension",
    "wire.4294967297.tension",
    "wires.1.tension",
    "resonant",
    "resonant.",
    "resonant.x.tension",
    "resonant.1.tension",
    "resonant.batter",
    "hoop.frequency_1",
    "hand.grasp",
    "batter.lug_17",
    "batter.muffle",
    "shell.height",
    "quality.newton",
    "striker.brush.wires",
    "Batter.tension",
    " batter.tension",
  };
  for (size_t i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
    if (tabor_parameter_find(unknown[i])) fail_msg("'%s' is a key", unknown[i]);
  }
  assert_null(tabor_parameter_find(NULL));
}

/* Every field of the structs that a key could name has one: what is no key's is counted here. */
static bool count_bytes(void *context, const TbParam *param, uint32_t element) {
  unsigned char *const owned = context;
  const size_t sizes[] = {[TABOR_TYPE_NUMBER] = sizeof(double),
                          [TABOR_TYPE_WHOLE] = sizeof(uint32_t),
                          [TABOR_TYPE_CHOICE] = sizeof(uint32_t),
                          [TABOR_TYPE_TEXT] = param->size};
  const size_t start = param->offset + element * param->stride;
  for (size_t i = start; i < start + sizes[param->info.type]; i++) {
    assert_true(i < sizeof(TaborDrumDef));
    assert_int_equal(owned[i], 0); /* no two keys share a byte */
    owned[i] = 1;
  }
  return true;
}

static void test_table_covers_the_struct(void **state) {
  (void)state;
  static unsigned char owned[sizeof(TaborDrumDef)];
  memset(owned, 0, sizeof owned);
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.striker_count = TABOR_MAX_STRIKERS;
  def.mic_count = TABOR_MAX_MICS;
  def.two_headed = 1;
  def.body.kind = TABOR_BODY_HIHAT;
  assert_true(tb_walk(&def, count_bytes, owned));
  size_t bytes = 0;
  for (size_t i = 0; i < sizeof owned; i++) bytes += owned[i];
  const size_t names = (TABOR_MAX_STRIKERS + TABOR_MAX_MICS) * TABOR_NAME_SIZE;
  const size_t counts =
    4 * sizeof(uint32_t);                   /* struct_size, two_headed, striker_count, mic_count */
  const size_t linear = 2 * sizeof(double); /* what the lower plate of a hi-hat has no keys for */
  const size_t paddings = 16 + 2 * TABOR_MAX_STRIKERS +
                          TABOR_MAX_MICS; /* a word after each odd run of uint32_t, at most */
  assert_in_range(bytes, sizeof def - names - counts - linear - 4 * paddings,
                  sizeof def - names - counts - linear);
}

/* Defaults ------------------------------------------------------------------------------------- */

static void test_default(void **state) {
  (void)state;
  TaborDrumDef def, again;
  memset(&def, 0xA5, sizeof def);
  memset(&again, 0x5A, sizeof again);
  tabor_drum_def_default(&def);
  tabor_drum_def_default(&again);
  assert_true(same_bits(&def, &again, sizeof def));
  must_validate(&def);
  assert_int_equal(def.struct_size, sizeof def);
  assert_int_equal(def.two_headed, 0);
  assert_int_equal(def.wires.head, TABOR_HEAD_BATTER);
  assert_int_equal(def.wires.count, 0);
  assert_int_equal(def.quality.level, TABOR_QUALITY_STUDIO);
  assert_int_equal(def.striker_count, 1);
  assert_int_equal(tabor_drum_def_find_striker(&def, "stick"), 0);
  assert_int_equal(tabor_drum_def_find_mic(&def, "top"), 0);
  assert_int_equal(tabor_drum_def_find_mic(&def, "bottom"), -1);
  assert_int_equal(tabor_drum_def_find_mic(&def, ""), -1);
  assert_int_equal(tabor_drum_def_find_mic(&def, NULL), -1);
  for (int i = 0; i < TABOR_MAX_WIRES; i++) assert_true(isnan(def.wire[i].tension));
}

static void test_clear(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_clear(&def);
  assert_int_equal(def.striker_count, 0);
  assert_int_equal(def.mic_count, 0);
  refuse_def(&def, TABOR_ERROR_RANGE, "striker", "0 strikers");
  must_set(&def, "striker.stick.kind", "stick");
  refuse_def(&def, TABOR_ERROR_RANGE, "mic", "0 microphones");
  must_set(&def, "mic.top.gain", "1");
  TaborDrumDef fresh;
  tabor_drum_def_default(&fresh);
  assert_true(same_bits(&def, &fresh, sizeof def));
  tabor_drum_def_clear(NULL);
  tabor_drum_def_default(NULL);
}

/* Setting and getting -------------------------------------------------------------------------- */

/* A value of the row that is not its default, as text. */
static void other_value(Random *random, const TbParam *param, char text[TABOR_TEXT_SIZE]) {
  const TaborParameter *const row = &param->info;
  const double fraction = random_whole(random) / 4294967296.0;
  switch (row->type) {
  case TABOR_TYPE_NUMBER: {
    double value = row->minimum + fraction * (row->maximum - row->minimum);
    if (row->logarithmic) value = row->minimum * pow(row->maximum / row->minimum, fraction);
    if (fabs(value) < param->least) value = row->maximum;
    tb_number_print(value, text);
    break;
  }
  case TABOR_TYPE_WHOLE: {
    const double least = fmax(param->least, row->minimum);
    snprintf(text, TABOR_TEXT_SIZE, "%.0f", floor(least + fraction * (row->maximum - least)));
    break;
  }
  case TABOR_TYPE_CHOICE:
    snprintf(text, TABOR_TEXT_SIZE, "%s",
             strrchr(row->choices, '|') ? strrchr(row->choices, '|') + 1 : row->choices);
    break;
  case TABOR_TYPE_TEXT:
    snprintf(text, TABOR_TEXT_SIZE, "%s", param->identifier ? "stick" : "h\xC3\xA9 = ; [x] \"'\\");
    break;
  }
}

static void full_key(const TaborParameter *row, const char *name, char key[TB_DEF_KEY_SIZE]) {
  const bool single = row->section[strlen(row->section) - 1] != '.';
  snprintf(key, TB_DEF_KEY_SIZE, "%s%s.%s", row->section, single ? "" : name, row->key);
}

/* Every key, of a new definition and of elements that come into being with it. */
static void test_round_trip(void **state) {
  (void)state;
  Random random = {20240611};
  print_message("seed %llu\n", (unsigned long long)random.state);
  for (int pass = 0; pass < 200; pass++) {
    TaborDrumDef def, copy;
    tabor_drum_def_clear(&def);
    tabor_drum_def_clear(&copy);
    for (uint32_t i = 0; i < tb_param_count; i++) {
      const bool is_wire = tb_params[i].group == TB_GROUP_WIRE;
      char key[TB_DEF_KEY_SIZE], text[TABOR_TEXT_SIZE], back[TABOR_TEXT_SIZE];
      full_key(&tb_params[i].info, is_wire ? "17" : "some_name-1", key);
      other_value(&random, &tb_params[i], text);
      must_set(&def, key, text);
      assert_int_equal(tabor_drum_def_get(&def, key, back, sizeof back, NULL), TABOR_OK);
      if (tb_params[i].info.type != TABOR_TYPE_NUMBER) assert_string_equal(back, text);
      must_set(&copy, key, back);
    }
    assert_true(same_bits(&def, &copy, sizeof def));
  }
}

/* Walking the keys and setting them in order makes the same definition. */
static void test_keys_in_order(void **state) {
  (void)state;
  TaborDrumDef def, copy;
  tabor_drum_def_default(&def);
  must_set(&def, "wire.3.tension", "7.25");
  must_set(&def, "mic.far.height", "-1");
  must_set(&def, "striker.mallet.kind", "mallet");
  tabor_drum_def_clear(&copy);
  char key[TB_DEF_KEY_SIZE], text[TABOR_TEXT_SIZE], all[8192] = "";
  uint32_t index = 0;
  for (; tabor_drum_def_key(&def, index, key, sizeof key); index++) {
    assert_int_equal(tabor_drum_def_get(&def, key, text, sizeof text, NULL), TABOR_OK);
    must_set(&copy, key, text);
    assert_true(strlen(all) + sizeof key < sizeof all);
    strcat(strcat(all, key), " ");
  }
  assert_true(same_bits(&def, &copy, sizeof def));
  assert_non_null(
    strstr(all, "wires.contact_loss wire.3.tension striker.stick.kind striker.stick.mass"));
  assert_non_null(strstr(all, "mic.top.gain mic.top.response mic.far.radius"));
  assert_null(strstr(all, "wire.1."));
  assert_false(tabor_drum_def_key(&def, index, key, sizeof key));
  assert_false(tabor_drum_def_key(&def, UINT32_MAX, key, sizeof key));
  assert_false(tabor_drum_def_key(&def, 0, key, 9)); /* "drum.name" takes 10 */
  assert_true(tabor_drum_def_key(&def, 0, key, 10));
  assert_false(tabor_drum_def_key(NULL, 0, key, sizeof key));
}

static void test_set_values(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  static const struct {
    const char *text;
    double value;
  } numbers[] = {
    {"3000", 3000},    {"3e3", 3000},
    {"3.E+3", 3000},   {"+3000.0", 3000},
    {"0003000", 3000}, {"20000", 20000},
    {"100", 100},      {"1234.5678901234567890123456789", 1234.567890123456789},
  };
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
    must_set(&def, "batter.tension", numbers[i].text);
    assert_true(def.batter.tension == numbers[i].value);
  }
  must_set(&def, "batter.bending_stiffness", ".5");
  assert_true(def.batter.bending_stiffness == 0.5);
  must_set(&def, "batter.bending_stiffness", "1e-999");
  assert_true(def.batter.bending_stiffness == 0);
  must_set(&def, "wires.seed", "4294967295");
  assert_int_equal(def.wires.seed, UINT32_MAX);
  must_set(&def, "quality.level", "draft");
  assert_int_equal(def.quality.level, TABOR_QUALITY_DRAFT);
  must_set(&def, "quality.level", "reference");
  assert_int_equal(def.quality.level, TABOR_QUALITY_REFERENCE);
  must_set(&def, "wires.side", "below");
  assert_int_equal(def.wires.side, TABOR_SIDE_BELOW);
  must_set(&def, "quality.wire_points", "0");
  must_set(&def, "quality.wire_points", "8");
  must_set(&def, "strike.striker", "");
  must_set(&def, "drum.comment", "");
  must_set(&def, "wire.2.offset", "0.01");
  assert_true(def.wire[1].offset == 0.01);
  must_set(&def, "wire.2.offset", "");
  assert_true(isnan(def.wire[1].offset));
  must_validate(&def);
}

static void test_set_refusals(void **state) {
  (void)state;
  static const char *const no_numbers[] = {
    "",         " ",     "x",     " 1000",    "1000 ",  "1000 N/m",   "1,000",
    "1000,5",   "0x3E8", "1e",    "1e+",      "e3",     ".",          "-",
    "+",        "--1",   "+-1",   "1.2.3",    "1e3.5",  "nan",        "NAN",
    "nan(1)",   "inf",   "-inf",  "infinity", "1000\n", "10\xC2\xA0", "\xD9\xA1\xD9\xA2",
    "\xFF\xFE", "1000f", "1_000", "0b1",      "1000;",
  };
  for (size_t i = 0; i < sizeof no_numbers / sizeof no_numbers[0]; i++) {
    refuse_set("batter.tension", no_numbers[i], TABOR_ERROR_VALUE, "is not a number");
  }
  static const char *const outside[] = {"0",     "-3000", "99.999", "20000.001",
                                        "1e308", "1e309", "-1e999"};
  for (size_t i = 0; i < sizeof outside / sizeof outside[0]; i++) {
    refuse_set("batter.tension", outside[i], TABOR_ERROR_RANGE, "is outside 100 to 20000 N/m");
  }
  static const char *const no_wholes[] = {"",    " 1",  "1 ",  "+1",  "-1",
                                          "1.0", "1e1", "0x1", "one", "-0"};
  for (size_t i = 0; i < sizeof no_wholes / sizeof no_wholes[0]; i++) {
    refuse_set("wires.count", no_wholes[i], TABOR_ERROR_VALUE,
               "is not a whole number from 0 to 40");
  }
  refuse_set("wires.count", "41", TABOR_ERROR_RANGE, "wires.count = 41 is outside 0 to 40");
  refuse_set("wires.seed", "4294967296", TABOR_ERROR_RANGE, "outside 0 to 4294967295");
  refuse_set("wires.seed", "99999999999999999999999999", TABOR_ERROR_RANGE, "outside");
  refuse_set("quality.wire_points", "7", TABOR_ERROR_RANGE, "neither 0 nor in 8 to 400");
  refuse_set("quality.losses", "2", TABOR_ERROR_RANGE, "outside 0 to 1");
  refuse_set("mic.top.height", "0", TABOR_ERROR_RANGE, "within 0.01 m of 0");
  refuse_set("mic.top.height", "-0.009", TABOR_ERROR_RANGE, "within 0.01 m of 0");
  refuse_set("shell.boundary", "half", TABOR_ERROR_VALUE, "is none of: open, baffled, closed");
  refuse_set("shell.boundary", "", TABOR_ERROR_VALUE, "is none of");
  refuse_set("shell.boundary", "open|baffled", TABOR_ERROR_VALUE, "is none of");
  refuse_set("shell.boundary", "Open", TABOR_ERROR_VALUE, "is none of");
  refuse_set("shell.depth", "0.009", TABOR_ERROR_RANGE, "outside 0.01 to 1.5 m");
  refuse_set("wires.head", "top", TABOR_ERROR_VALUE, "is none of: batter, resonant");
  refuse_set("batter.stretch_stiffness", "-1", TABOR_ERROR_RANGE, "outside 0 to 1e7 N/m");
  refuse_set("batter.damping_k", "-0.1", TABOR_ERROR_RANGE, "-0.1 is outside 0 to 5 m/s");
  refuse_set("resonant.damping_k", "5.1", TABOR_ERROR_RANGE, "5.1 is outside 0 to 5 m/s");
  refuse_set("batter.muffle_strength", "30.1", TABOR_ERROR_RANGE, "outside 0 to 30 N s/m");
  refuse_set("batter.muffle_radius", "0.61", TABOR_ERROR_RANGE, "outside 0 to 0.6 m");
  refuse_set("batter.ring_radius", "0.61", TABOR_ERROR_RANGE, "outside 0 to 0.6 m");
  refuse_set("resonant.ring_width", "0", TABOR_ERROR_RANGE, "outside 0.001 to 1.2 m");
  refuse_set("resonant.ring_strength", "-1", TABOR_ERROR_RANGE, "outside 0 to 30 N s/m");
  refuse_set("resonant.tension", "99", TABOR_ERROR_RANGE, "outside 100 to 20000 N/m");
  refuse_set("resonant.damping_0", "x", TABOR_ERROR_VALUE, "is not a number");
  refuse_set("striker.stick.kind", "rake", TABOR_ERROR_VALUE, "stick, mallet, finger, brush");
  refuse_set("strike.technique", "sweeps", TABOR_ERROR_VALUE, "is none of: normal, buzz");
  refuse_set("shell.mass", "0.04", TABOR_ERROR_RANGE, "neither 0 nor in 0.05 to 100 kg");
  refuse_set("wire.1.tension", "nan", TABOR_ERROR_VALUE, "is not a number");
  refuse_set("wire.1.tension", " ", TABOR_ERROR_VALUE, "is not a number");
}

static void test_set_texts(void **state) {
  (void)state;
  char text[TABOR_NAME_SIZE + 1];
  memset(text, 'x', sizeof text);
  text[TABOR_NAME_SIZE] = '\0';
  refuse_set("drum.name", text, TABOR_ERROR_VALUE, "longer than 63 bytes");
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  text[TABOR_NAME_SIZE - 1] = '\0';
  must_set(&def, "drum.name", text);
  assert_string_equal(def.name, text);
  static const char *const broken[] = {
    "a\nb",
    "a\tb",
    "a\rb",
    "\x01",
    "\x1b[31m",
    "\x7f",
    "\xC2\x9B",
    "\xC3",
    "\xC3(",
    "\xA9",
    "\xFF",
    "\xC0\xAF",
    "\xE0\x80\xAF",
    "\xED\xA0\x80",
    "\xF0\x80\x80\x80",
    "\xF4\x90\x80\x80",
    "\xE2\x82",
    "\xF5\x80\x80\x80",
  };
  for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
    refuse_set("drum.comment", broken[i], TABOR_ERROR_VALUE, "not UTF-8");
  }
  must_set(&def, "drum.comment", "caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\xA5\x81");
  refuse_set("strike.striker", "a b", TABOR_ERROR_VALUE, "letters, digits");
  refuse_set("strike.striker", "a.b", TABOR_ERROR_VALUE, "letters, digits");
}

static void test_unknown_keys(void **state) {
  (void)state;
  static const struct {
    const char *key, *nearest;
  } keys[] = {
    {"batter.tensoin", "'batter.tension'"},
    {"bater.tension", "'batter.tension'"},
    {"tension", "'batter.tension'"},
    {"strainer", "'wires.strainer'"},
    {"wire.2.tensio", "'wire.2.tension'"},
    {"mic.top.gian", "'mic.top.gain'"},
    {"mic.bottom.hight", "'mic.bottom.height'"},
    {"micro.top.gain", "'mic.top.gain'"},
    {"striker.stick.mas", "'striker.stick.mass'"},
    {"batter.strainer", "'wires.strainer'"},
    {"resonant.tensoin", "'resonant.tension'"},
    {"resonnant.damping_1", "'resonant.damping_1'"},
    {"batter.mufle_angle", "'batter.muffle_angle'"},
  };
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
    refuse_set(keys[i].key, "1", TABOR_ERROR_KEY, keys[i].nearest);
  }
  static const char *const far[] = {"", "-", "x", "foo.bar", "zzzzzz", "\x1b[2J\n", "batter.foo"};
  for (size_t i = 0; i < sizeof far / sizeof far[0]; i++) { /* a guess would only mislead */
    TaborDrumDef def;
    TaborError error;
    tabor_drum_def_default(&def);
    assert_int_equal(tabor_drum_def_set(&def, far[i], "1", &error), TABOR_ERROR_KEY);
    assert_null(strstr(error.message, "did you mean"));
  }
  char longest[1000];
  memset(longest, 'k', sizeof longest);
  longest[sizeof longest - 1] = '\0';
  refuse_set(longest, "1", TABOR_ERROR_KEY, "unknown key");
  memcpy(longest, "mic.", 4);
  memcpy(longest + sizeof longest - 6, ".gain", 6);
  refuse_set(longest, "1", TABOR_ERROR_KEY, "1 to 40 letters");
  refuse_set("mic.to p.gain", "1", TABOR_ERROR_KEY, "1 to 40 letters");
  refuse_set("mic.caf\xC3\xA9.gain", "1", TABOR_ERROR_KEY, "1 to 40 letters");
  refuse_set("mic.a.b.gain", "1", TABOR_ERROR_KEY, "1 to 40 letters");
  refuse_set("wire.0.tension", "1", TABOR_ERROR_KEY, "numbered 1 to 40");
  refuse_set("wire.41.tension", "1", TABOR_ERROR_KEY, "numbered 1 to 40");
  refuse_set("wire.01.tension", "1", TABOR_ERROR_KEY, "numbered 1 to 40");
}

static void refuse_section(const char *section, TaborStatus status, const char *part) {
  TaborDrumDef def, before;
  TaborError error;
  tabor_drum_def_default(&def);
  before = def;
  assert_int_equal(tabor_drum_def_section(&def, section, &error), status);
  if (!strstr(error.message, part)) fail_msg("'%s' lacks '%s'", error.message, part);
  assert_tidy(&error, status);
  assert_true(same_bits(&def, &before, sizeof def));
}

/* A section alone is the same as a section with a key that has its default. */
static void test_sections(void **state) {
  (void)state;
  TaborDrumDef def, keyed;
  TaborError error;
  tabor_drum_def_default(&def);
  keyed = def;
  static const char *const plain[] = {"drum", "shell",  "batter", "wires",   "wire.40",      "hand",
                                      "air",  "strike", "output", "mic.top", "striker.stick"};
  for (size_t i = 0; i < sizeof plain / sizeof plain[0]; i++) {
    assert_int_equal(tabor_drum_def_section(&def, plain[i], &error), TABOR_OK);
    assert_true(same_bits(&def, &keyed, sizeof def));
  }
  static const char *const added[][3] = {{"resonant", "resonant.tension", "2600"},
                                         {"mic.b", "mic.b.gain", "1"},
                                         {"striker.a", "striker.a.mass", "0.012"}};
  for (size_t i = 0; i < sizeof added / sizeof added[0]; i++) {
    assert_int_equal(tabor_drum_def_section(&def, added[i][0], &error), TABOR_OK);
    must_set(&keyed, added[i][1], added[i][2]);
    assert_true(same_bits(&def, &keyed, sizeof def));
  }
  assert_int_equal(def.two_headed, 1);
  for (int i = def.mic_count; i < TABOR_MAX_MICS; i++) {
    char section[TB_DEF_KEY_SIZE];
    snprintf(section, sizeof section, "mic.m%d", i);
    assert_int_equal(tabor_drum_def_section(&def, section, &error), TABOR_OK);
  }
  assert_int_equal(tabor_drum_def_section(&def, "mic.more", &error), TABOR_ERROR_FULL);
  assert_string_equal(error.message, "mic.more: a drum has at most 8 microphones");
  refuse_section("foo", TABOR_ERROR_KEY, "unknown section 'foo'");
  refuse_section("", TABOR_ERROR_KEY, "unknown section ''");
  refuse_section("strikr.z", TABOR_ERROR_KEY, "did you mean 'striker.z'?");
  refuse_section("striker", TABOR_ERROR_KEY, "did you mean 'striker.NAME'?");
  refuse_section("mics.b", TABOR_ERROR_KEY, "did you mean 'mic.b'?");
  refuse_section("wire", TABOR_ERROR_KEY, "did you mean 'wire");
  refuse_section("resonnant", TABOR_ERROR_KEY, "did you mean 'resonant'?");
  refuse_section("Batter", TABOR_ERROR_KEY, "did you mean 'batter'?");
  refuse_section("wire.41", TABOR_ERROR_KEY, "numbered 1 to 40");
  refuse_section("mic.", TABOR_ERROR_KEY, "1 to 40 letters");
  refuse_section("mic.a.b", TABOR_ERROR_KEY, "1 to 40 letters");
  char longest[49] = "mic.";
  memset(longest + 4, 'x', 41);
  refuse_section(longest, TABOR_ERROR_KEY, "1 to 40 letters");
  longest[44] = '\0';
  assert_int_equal(tabor_drum_def_section(&keyed, longest, NULL), TABOR_OK);
  must_validate(&keyed);
  assert_int_equal(tabor_drum_def_section(NULL, "air", NULL), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_section(&def, NULL, NULL), TABOR_ERROR_ARGUMENT);
}

static void test_full(void **state) {
  (void)state;
  TaborDrumDef def, before;
  TaborError error;
  tabor_drum_def_clear(&def);
  for (int i = 1; i <= TABOR_MAX_MICS; i++) {
    char key[TB_DEF_KEY_SIZE];
    snprintf(key, sizeof key, "mic.m%d.gain", i);
    must_set(&def, key, "2");
    snprintf(key, sizeof key, "striker.s%d.mass", i);
    must_set(&def, key, "0.02");
  }
  must_validate(&def);
  before = def;
  assert_int_equal(tabor_drum_def_set(&def, "mic.m9.gain", "1", &error), TABOR_ERROR_FULL);
  assert_string_equal(error.message, "mic.m9.gain: a drum has at most 8 microphones");
  assert_int_equal(tabor_drum_def_set(&def, "striker.s9.mass", "1", &error), TABOR_ERROR_FULL);
  assert_string_equal(error.message, "striker.s9.mass: a drum has at most 8 strikers");
  assert_true(same_bits(&def, &before, sizeof def));
  must_set(&def, "mic.m8.gain", "3");
}

static void test_arguments(void **state) {
  (void)state;
  TaborDrumDef def;
  TaborError error;
  char text[TABOR_TEXT_SIZE];
  tabor_drum_def_default(&def);
  assert_int_equal(tabor_drum_def_set(NULL, "batter.tension", "1", &error), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_set(&def, NULL, "1", &error), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_set(&def, "batter.tension", NULL, &error), TABOR_ERROR_ARGUMENT);
  assert_tidy(&error, TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_get(&def, "batter.tension", NULL, 9, &error),
                   TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_validate(NULL, &error), TABOR_ERROR_ARGUMENT);
  static const uint32_t sizes[] = {0, 1, sizeof def - 1, sizeof def + 1, UINT32_MAX};
  for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
    def.struct_size = sizes[i];
    refuse_def(&def, TABOR_ERROR_ARGUMENT, "", "struct_size");
    assert_int_equal(tabor_drum_def_set(&def, "batter.tension", "3000", &error),
                     TABOR_ERROR_ARGUMENT);
    assert_int_equal(tabor_drum_def_get(&def, "batter.tension", text, sizeof text, &error),
                     TABOR_ERROR_ARGUMENT);
  }
}

static void test_get_refusals(void **state) {
  (void)state;
  TaborDrumDef def;
  TaborError error;
  char text[TABOR_TEXT_SIZE] = "old";
  tabor_drum_def_default(&def);
  assert_int_equal(tabor_drum_def_get(&def, "mic.tip.gain", text, sizeof text, &error),
                   TABOR_ERROR_NAME);
  assert_string_equal(error.message,
                      "mic.tip.gain: the drum has no microphone 'tip'; did you mean 'top'?");
  assert_string_equal(text, "");
  assert_int_equal(tabor_drum_def_get(&def, "resonant.tension", text, sizeof text, &error),
                   TABOR_ERROR_NAME);
  assert_string_equal(error.message, "resonant.tension: the drum has no resonant head");
  assert_string_equal(error.key, "resonant.tension");
  assert_int_equal(tabor_drum_def_get(&def, "shell.radis", text, sizeof text, &error),
                   TABOR_ERROR_KEY);
  assert_int_equal(tabor_drum_def_get(&def, "batter.tension", text, 4, &error),
                   TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_get(&def, "batter.tension", text, 0, &error),
                   TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_get(&def, "batter.tension", text, 5, &error), TABOR_OK);
  assert_string_equal(text, "3000");
  assert_int_equal(tabor_drum_def_get(&def, "wire.9.tension", text, 1, &error), TABOR_OK);
  def.quality.level = 9;
  assert_int_equal(tabor_drum_def_get(&def, "quality.level", text, sizeof text, &error),
                   TABOR_ERROR_RANGE);
}

/* Random bytes, most of them near what means something. */
static void random_text(Random *random, char *text, uint32_t size) {
  static const char letters[] = "0123456789.eE+-xnainf.batermicstkwg[];=| \t\n\x80\xC3\xA9\xFF";
  const uint32_t length = random_below(random, size);
  for (uint32_t i = 0; i < length; i++) {
    const uint32_t c = random_below(random, 4)
                         ? (uint32_t)letters[random_below(random, sizeof letters - 1)]
                         : 1 + random_below(random, 255);
    text[i] = (char)c;
  }
  text[length] = '\0';
}

static void test_random_texts(void **state) {
  (void)state;
  Random random = {77};
  print_message("seed %llu\n", (unsigned long long)random.state);
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  for (int i = 0; i < 40000; i++) {
    char key[TB_DEF_KEY_SIZE], text[300];
    TaborError error;
    const TbParam *const param = &tb_params[random_below(&random, tb_param_count)];
    full_key(&param->info, param->group == TB_GROUP_WIRE ? "7" : "top", key);
    if (i % 200 == 0) random_text(&random, key, sizeof key);
    random_text(&random, text, random_below(&random, 2) ? 6 : sizeof text);
    const TaborDrumDef before = def;
    const TaborStatus status = tabor_drum_def_set(&def, key, text, &error);
    assert_tidy(&error, status);
    if (status != TABOR_OK) assert_true(same_bits(&def, &before, sizeof def));
  }
  /* Whatever was accepted is fine, but for what must hold between fields. */
  TaborError error;
  const TaborStatus status = tabor_drum_def_validate(&def, &error);
  assert_true(status == TABOR_OK || strncmp(error.key, "strike.", 7) == 0 ||
              strncmp(error.key, "wire", 4) == 0 || strncmp(error.key, "mic.", 4) == 0 ||
              strstr(error.key, ".muffle_radius") || strstr(error.key, ".ring_radius") ||
              strstr(error.key, ".lug_") || strcmp(error.key, "resonant") == 0 ||
              strcmp(error.key, "shell.boundary") == 0);
}

/* Numbers as text ------------------------------------------------------------------------------ */

static void test_number_print(void **state) {
  (void)state;
  static const struct {
    double value;
    const char *text;
  } numbers[] = {
    {0, "0"},
    {1, "1"},
    {-1, "-1"},
    {0.1, "0.1"},
    {3000, "3000"},
    {1234567, "1234567"},
    {1e7, "1e7"},
    {1e8, "1e8"},
    {0.0016, "0.0016"},
    {1e-4, "0.0001"},
    {1e-5, "1e-5"},
    {12.5, "12.5"},
    {120, "120"},
    {1.0 / 3, "0.3333333333333333"},
    {-1.5e-7, "-1.5e-7"},
    {1e-300, "1e-300"},
    {123456.75, "123456.75"},
    {DBL_MAX, "1.7976931348623157e308"},
    {DBL_MIN, "2.2250738585072014e-308"},
    {5e-324, "5e-324"},
    {(double)NAN, "nan"},
    {(double)INFINITY, "inf"},
    {-(double)INFINITY, "-inf"},
    {-0.0, "-0"},
  };
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
    char text[TB_NUMBER_SIZE];
    tb_number_print(numbers[i].value, text);
    assert_string_equal(text, numbers[i].text);
  }
}

static void test_number_round_trip(void **state) {
  (void)state;
  Random random = {4711};
  print_message("seed %llu\n", (unsigned long long)random.state);
  for (int i = 0; i < 20000; i++) {
    const double value = random_bits(&random);
    double back;
    char text[TB_NUMBER_SIZE];
    tb_number_print(value, text);
    if (!isfinite(value)) {
      assert_int_equal(tb_number_parse(text, &back), TB_PARSE_INVALID);
      continue;
    }
    assert_int_equal(tb_number_parse(text, &back), TB_PARSE_OK);
    assert_true(same_bits(&value, &back, sizeof value));
  }
}

/* A locale whose decimal point is none: the program that embeds the library may have set it. */
static bool set_comma_locale(void) {
  static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8",  "de_DE",       "fr_FR.UTF-8",
                                      "fr_FR.utf8",  "nl_NL.UTF-8", "it_IT.UTF-8", "es_ES.UTF-8",
                                      "pl_PL.UTF-8", "German"};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    if (setlocale(LC_ALL, names[i]) && strcmp(localeconv()->decimal_point, ".") != 0) return true;
  }
  (void)setlocale(LC_ALL, "C");
  return false;
}

#ifdef _WIN32
static bool find_comma_locale(void) { return set_comma_locale(); }
#else
/* Most systems have the sources of all locales and none compiled: compiles one for this test. */
static bool make_comma_locale(const char *folder) {
  char command[512];
  snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 '%s/de_DE.UTF-8' >'%s/log' 2>&1",
           folder, folder);
  if (system(command) != 0) return false;
  (void)setenv("LOCPATH", folder, 1);
  const bool made = set_comma_locale();
  (void)unsetenv("LOCPATH");
  return made;
}

static bool find_comma_locale(void) {
  if (set_comma_locale()) return true;
  const char *const temporary = getenv("TMPDIR");
  char folder[200], command[256];
  snprintf(folder, sizeof folder, "%s/test_definition.XXXXXX", temporary ? temporary : "/tmp");
  if (!mkdtemp(folder)) return false;
  const bool made = make_comma_locale(folder);
  snprintf(command, sizeof command, "rm -r '%s'", folder);
  return system(command) == 0 && made;
}
#endif

static void test_locale(void **state) {
  (void)state;
  if (!find_comma_locale()) {
    print_message("SKIPPED: no locale with a decimal comma, nor its source: needs locales\n");
    skip();
  }
  print_message("locale %s\n", setlocale(LC_ALL, NULL));
  TaborDrumDef def;
  TaborError error;
  char text[TABOR_TEXT_SIZE];
  tabor_drum_def_default(&def);
  must_set(&def, "shell.radius", "0.125");
  assert_true(def.shell.radius == 0.125);
  assert_int_equal(tabor_drum_def_get(&def, "shell.radius", text, sizeof text, NULL), TABOR_OK);
  assert_string_equal(text, "0.125");
  assert_int_equal(tabor_drum_def_set(&def, "shell.radius", "0,125", &error), TABOR_ERROR_VALUE);
  assert_int_equal(tabor_drum_def_set(&def, "shell.radius", "0.04", &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.message, "shell.radius = 0.04 is outside 0.05 to 0.6 m");
  (void)setlocale(LC_ALL, "C");
}

/* Errors --------------------------------------------------------------------------------------- */

static void test_error_set(void **state) {
  (void)state;
  TaborError error;
  assert_int_equal(tb_error_set(NULL, TABOR_ERROR_VALUE, "k", "v", 0, 1, "%s", "x"),
                   TABOR_ERROR_VALUE);
  tb_error_set(&error, TABOR_ERROR_RANGE, "a\nb", NULL, 0.5, (double)NAN,
               "%s|%d|%u|%zu|%c|%g|%%|%s", "s\x1b\xC3\xA9\xFF", -7, 7u, (size_t)9, 'c', 1e-7, "");
  assert_string_equal(error.message, "s?\xC3\xA9?|-7|7|9|c|1e-7|%|");
  assert_string_equal(error.key, "a?b");
  assert_string_equal(error.value, "");
  assert_true(error.minimum == 0.5 && isnan(error.maximum));
  char longest[2000];
  memset(longest, 0, sizeof longest);
  for (size_t i = 0; i + 4 < sizeof longest; i += 3) memcpy(longest + i, "\xE2\x82\xAC", 3);
  tb_error_set(&error, TABOR_ERROR_VALUE, longest, longest, 0, 1, "x%s|%s|%s.", longest, longest,
               longest);
  assert_tidy(&error, TABOR_ERROR_VALUE); /* cut between characters */
  assert_int_equal(strlen(error.value), 63);
  const char *const second = strchr(error.message, '|');
  assert_int_equal(second - error.message, 1 + 96 + 3);
  assert_int_equal(strlen(error.message), sizeof error.message - 1);
}

static void test_edit_distance(void **state) {
  (void)state;
  assert_int_equal(tb_edit_distance("", ""), 0);
  assert_int_equal(tb_edit_distance("abc", ""), 3);
  assert_int_equal(tb_edit_distance("", "abc"), 3);
  assert_int_equal(tb_edit_distance("kitten", "sitting"), 3);
  assert_int_equal(tb_edit_distance("tensoin", "tension"), 1);
}

/* Validation ----------------------------------------------------------------------------------- */

static void test_between_fields(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.strike.radius = def.shell.radius; /* as an event's */
  must_validate(&def);
  def.strike.radius = 0.16511;
  refuse_def(&def, TABOR_ERROR_RANGE, "strike.radius", "is beyond shell.radius, 0.1651 m");
  tabor_drum_def_default(&def);
  must_set(&def, "strike.striker", "stik");
  refuse_def(&def, TABOR_ERROR_NAME, "strike.striker", "did you mean 'stick'?");
  must_set(&def, "strike.striker", "foo");
  refuse_def(&def, TABOR_ERROR_NAME, "strike.striker", "no striker 'foo'; it has: stick");
  tabor_drum_def_default(&def);
  def.wires.count = 3;
  must_validate(&def);
  def.wires.spacing = 0.1;
  must_validate(&def);
  def.wires.offset = 0.07; /* 0.17 m: only the third lies outside */
  refuse_def(&def, TABOR_ERROR_RANGE, "wires.spacing", "wire 3 would lie 0.17");
  def.wire[2].offset = 0;
  must_validate(&def);
  def.wire[2].offset = -0.1651;
  refuse_def(&def, TABOR_ERROR_RANGE, "wire.3.offset", "wire 3 would lie -0.1651 m");
  def.wire[2].offset = 0;
  def.wires.offset = 0.5;
  refuse_def(&def, TABOR_ERROR_RANGE, "wires.offset", "wire 1 would lie 0.4 m");
  def.wires.count = 0; /* without wires their layout is nobody's concern */
  must_validate(&def);
}

/* Two heads ------------------------------------------------------------------------------------ */

/* The keys in order, each with a blank behind it. */
static uint32_t list_keys(const TaborDrumDef *def, char *all, size_t size) {
  char key[TB_DEF_KEY_SIZE];
  uint32_t count = 0;
  *all = '\0';
  for (; tabor_drum_def_key(def, count, key, sizeof key); count++) {
    assert_true(strlen(all) + sizeof key < size);
    strcat(strcat(all, key), " ");
  }
  return count;
}

/* Each of its keys brings the second head, with defaults for the others. */
static void test_second_head(void **state) {
  (void)state;
  enum { KEYS = 18 + TABOR_MAX_LUGS };
  TaborDrumDef one, two;
  tabor_drum_def_default(&one);
  tabor_drum_def_default(&two);
  two.two_headed = 1; /* by hand: the defaults are there already */
  must_validate(&two);
  uint32_t count = 0;
  for (uint32_t i = 0; i < tb_param_count; i++) {
    const TaborParameter *const row = &tb_params[i].info;
    if (strcmp(row->section, "resonant") != 0) continue;
    char key[TB_DEF_KEY_SIZE], text[TABOR_TEXT_SIZE];
    full_key(row, "", key);
    TaborDrumDef def = one;
    def.resonant = (TaborHeadDef){.tension = NAN}; /* what a head left behind counts for nothing */
    tb_number_print(row->fallback, text);
    must_set(&def, key, isnan(row->fallback) ? "" : text);
    assert_true(same_bits(&def, &two, sizeof def));
    count++;
  }
  assert_int_equal(count, KEYS);

  must_set(&one, "resonant.tension", "1234");
  must_set(&one, "resonant.damping_1", "0.002");
  must_set(&one, "resonant.damping_k", "0.25");
  assert_int_equal(one.two_headed, 1);
  assert_true(one.resonant.tension == 1234 && one.resonant.damping_1 == 0.002);
  assert_true(one.resonant.damping_k == 0.25 && one.batter.damping_k == 0.0);
  assert_true(one.resonant.surface_density == two.resonant.surface_density);
  assert_true(one.batter.tension == two.batter.tension);
}

static void test_second_head_keys(void **state) {
  (void)state;
  enum { KEYS = 18 }; /* but for lugs' own values, which are not set */
  TaborDrumDef def, copy;
  char all[8192];
  tabor_drum_def_default(&def);
  const uint32_t count = list_keys(&def, all, sizeof all);
  assert_null(strstr(all, "resonant."));
  assert_non_null(strstr(all, "shell.stand_damping batter.tension "));
  assert_non_null(strstr(all, "shell.absorption shell.surface_density "));
  assert_non_null(strstr(all, "batter.ring_strength batter.unevenness batter.lug_count "
                              "batter.lug_spread batter.lug_seed wires.head "));
  must_set(&def, "resonant.damping_0", "17");
  assert_int_equal(list_keys(&def, all, sizeof all), count + KEYS);
  assert_non_null(strstr(all, "batter.lug_seed resonant.tension "));
  assert_non_null(strstr(all, "resonant.lug_seed wires.head "));
  tabor_drum_def_clear(&copy);
  char key[TB_DEF_KEY_SIZE], text[TABOR_TEXT_SIZE];
  for (uint32_t i = 0; tabor_drum_def_key(&def, i, key, sizeof key); i++) {
    assert_int_equal(tabor_drum_def_get(&def, key, text, sizeof text, NULL), TABOR_OK);
    must_set(&copy, key, text);
  }
  assert_true(same_bits(&def, &copy, sizeof def));
}

/* Resonant ids are the batter's and a hundred, and so are ranges, units and kinds. */
static void test_heads_alike(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tb_param_count; i++) {
    const TaborParameter *const row = &tb_params[i].info;
    if (strcmp(row->section, "batter") != 0) continue;
    const TbParam *const other = tb_param_by_id(row->id + 100);
    assert_non_null(other);
    assert_string_equal(other->info.section, "resonant");
    assert_string_equal(other->info.key, row->key);
    assert_string_equal(other->info.unit, row->unit);
    assert_true(other->info.minimum == row->minimum && other->info.maximum == row->maximum);
    assert_int_equal(other->info.logarithmic, row->logarithmic);
    assert_int_equal(other->info.live, row->live);
    assert_int_equal(other->offset - tb_params[i].offset,
                     offsetof(TaborDrumDef, resonant) - offsetof(TaborDrumDef, batter));
  }
}

/* The default head is one sheet: its bending stiffness follows from its weight. */
static void test_resonant_sheet(void **state) {
  (void)state;
  const double density = 1390, modulus = 3.8e9, poisson = 0.3; /* of Mylar */
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  const double thickness = def.resonant.surface_density / density;
  assert_true(fabs(thickness / 76.2e-6 - 1) < 0.02); /* 3 mil */
  const double stiffness =
    modulus * thickness * thickness * thickness / (12 * (1 - poisson * poisson));
  assert_true(fabs(def.resonant.bending_stiffness / stiffness - 1) < 0.02);
}

static void test_between_heads(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.two_headed = 2;
  refuse_def(&def, TABOR_ERROR_RANGE, "resonant", "two_headed is 2");
  def.two_headed = UINT32_MAX;
  refuse_def(&def, TABOR_ERROR_RANGE, "resonant", "needs to be 0 or 1");
  tabor_drum_def_default(&def);
  must_set(&def, "wires.head", "resonant");
  refuse_def(&def, TABOR_ERROR_RANGE, "wires.head", "the drum has no resonant head");
  must_set(&def, "resonant.tension", "2000");
  must_validate(&def);
  must_set(&def, "shell.boundary", "baffled");
  refuse_def(&def, TABOR_ERROR_RANGE, "shell.boundary", "baffled is for a single head");
  must_set(&def, "shell.boundary", "closed");
  refuse_def(&def, TABOR_ERROR_RANGE, "shell.boundary", "it has to be open");
  must_set(&def, "shell.boundary", "open");
  must_validate(&def);

  must_set(&def, "resonant.muffle_radius", "0.1651"); /* the rim, of a damper that does nothing */
  refuse_def(&def, TABOR_ERROR_RANGE, "resonant.muffle_radius", "is not below shell.radius");
  must_set(&def, "batter.muffle_radius", "0.3");
  refuse_def(&def, TABOR_ERROR_RANGE, "batter.muffle_radius", "is not below shell.radius, 0.1651");
  must_set(&def, "batter.muffle_radius", "0.165");
  must_set(&def, "batter.ring_radius", "0.15");
  must_set(&def, "batter.ring_width", "0.0303"); /* of a ring that is not there */
  must_set(&def, "resonant.muffle_radius", "0");
  must_validate(&def);
  must_set(&def, "batter.ring_strength", "0.4");
  refuse_def(&def, TABOR_ERROR_RANGE, "batter.ring_radius",
             "0.15: with ring_width 0.0303 m the ring reaches beyond shell.radius, 0.1651 m");
  must_set(&def, "batter.ring_width", "0.03");
  must_validate(&def);
  must_set(&def, "resonant.ring_radius", "0.16");
  must_set(&def, "resonant.ring_strength", "1");
  refuse_def(&def, TABOR_ERROR_RANGE, "resonant.ring_radius", "with ring_width 0.03 m");
  must_set(&def, "wires.head", "batter");
  def.two_headed = 0; /* and nobody looks at the head that is gone */
  must_validate(&def);
}

static void refuse_mic(TaborDrumDef *def, const char *radius, const char *height,
                       const char *part) {
  must_set(def, "mic.low.radius", radius);
  must_set(def, "mic.low.height", height);
  refuse_def(def, TABOR_ERROR_RANGE, "mic.low.height", part);
}

static void accept_mic(TaborDrumDef *def, const char *radius, const char *height) {
  must_set(def, "mic.low.radius", radius);
  must_set(def, "mic.low.height", height);
  must_validate(def);
}

/* radius 0.1651, depth 0.14 */
static void test_mics_and_shell(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  accept_mic(&def, "0.05", "-0.05"); /* an open frame has no inside */
  must_set(&def, "shell.boundary", "closed");
  accept_mic(&def, "0.05", "-0.05");   /* inside */
  accept_mic(&def, "0.165", "-0.139"); /* inside: a rigid bottom has no motion to be near to */
  accept_mic(&def, "0.1651", "-0.05");
  accept_mic(&def, "0", "-0.145");
  must_set(&def, "shell.boundary", "open");
  must_set(&def, "resonant.tension", "2000");
  accept_mic(&def, "0.05", "-0.05");
  refuse_mic(&def, "0", "-0.135", "within 0.01 m of the resonant head's plane, 0.14 m below");
  refuse_mic(&def, "0", "-0.145", "within 0.01 m of the resonant head's plane, 0.14 m below");
  refuse_mic(&def, "1", "-0.132", "within 0.01 m of the resonant head's plane");
  accept_mic(&def, "0", "-0.15");
  accept_mic(&def, "1", "-0.13");
  accept_mic(&def, "0.2", "-0.05");
  must_set(&def, "shell.depth", "0.3");
  accept_mic(&def, "0", "-0.15");
}

static void test_inside(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  TaborMicDef *mic = &def.mic[0];
  mic->radius = 0.1;
  mic->height = -0.05;
  assert_false(tb_mic_is_inside(&def, mic)); /* an open frame has no inside */
  def.shell.boundary = TABOR_BOUNDARY_BAFFLED;
  assert_false(tb_mic_is_inside(&def, mic));
  def.shell.boundary = TABOR_BOUNDARY_CLOSED;
  assert_true(tb_mic_is_inside(&def, mic));
  must_set(&def, "mic.near.height", "0.05");
  must_set(&def, "mic.below.height", "-0.2");
  must_set(&def, "mic.beside.height", "-0.05");
  must_set(&def, "mic.beside.radius", "0.1651");
  uint32_t mics[TABOR_MAX_MICS];
  assert_int_equal(tb_mics_outside(&def, mics), 3);
  assert_int_equal(mics[0], 1);
  assert_int_equal(mics[2], 3);
  def.shell.boundary = TABOR_BOUNDARY_OPEN;
  assert_int_equal(tb_mics_outside(&def, mics), 4);
  must_set(&def, "resonant.tension", "2000");
  assert_int_equal(tb_mics_outside(&def, mics), 3);
}

static void test_names(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  must_set(&def, "mic.far.gain", "1");
  strcpy(def.mic[1].name, "top");
  refuse_def(&def, TABOR_ERROR_VALUE, "mic", "two of the drum's mics are called 'top'");
  strcpy(def.mic[1].name, "");
  refuse_def(&def, TABOR_ERROR_VALUE, "mic", "mic number 2");
  strcpy(def.mic[1].name, "a.b");
  refuse_def(&def, TABOR_ERROR_VALUE, "mic", "'a.b'");
  memset(def.mic[1].name, 'a', sizeof def.mic[1].name);
  refuse_def(&def, TABOR_ERROR_VALUE, "mic", "mic number 2");
  tabor_drum_def_default(&def);
  strcpy(def.striker[0].name, "st\x1b[0m");
  refuse_def(&def, TABOR_ERROR_VALUE, "striker", "striker number 1");
}

static void test_counts(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.mic_count = 9;
  refuse_def(&def, TABOR_ERROR_RANGE, "mic", "9 microphones; it needs 1 to 8");
  def.mic_count = UINT32_MAX;
  def.striker_count = 1u << 31;
  refuse_def(&def, TABOR_ERROR_RANGE, "striker", "2147483648 strikers");
  assert_int_equal(tabor_drum_def_find_mic(&def, "nothing"), -1);
  assert_int_equal(tabor_drum_def_set(&def, "mic.new.gain", "1", NULL), TABOR_ERROR_FULL);
  tabor_drum_def_default(&def);
  def.wires.count = 41;
  refuse_def(&def, TABOR_ERROR_RANGE, "wires.count", "outside 0 to 40");
}

/* Every number at NaN, the infinities and beyond its limits; every whole number and choice
 * beyond. */
typedef struct Corners {
  TaborDrumDef *def;
  unsigned checked;
} Corners;

static void refuse_field(const Corners *corners, const char *key) {
  TaborError error;
  const TaborStatus status = tabor_drum_def_validate(corners->def, &error);
  if (status != TABOR_ERROR_RANGE || strcmp(error.key, key) != 0) {
    fail_msg("%s: status %d, key '%s': %s", key, status, error.key, error.message);
  }
  assert_tidy(&error, status);
}

static void corner_number(const Corners *corners, const TbParam *param, const char *key,
                          double *field) {
  const double good = *field;
  const double bad[] = {(double)INFINITY,
                        -(double)INFINITY,
                        DBL_MAX,
                        -DBL_MAX,
                        nextafter(param->info.minimum, -1e300),
                        nextafter(param->info.maximum, 1e300),
                        (double)NAN};
  const size_t count = sizeof bad / sizeof bad[0] - isnan(param->info.fallback);
  for (size_t i = 0; i < count; i++) {
    *field = bad[i];
    refuse_field(corners, key);
  }
  *field = good;
}

static void corner_text(const Corners *corners, const TbParam *param, const char *key,
                        char *field) {
  TaborError error;
  char good[TABOR_TEXT_SIZE];
  memcpy(good, field, param->size);
  memset(field, 'x', param->size);
  assert_int_equal(tabor_drum_def_validate(corners->def, &error), TABOR_ERROR_VALUE);
  assert_string_equal(error.key, key);
  assert_int_equal(tabor_drum_def_get(corners->def, key, (char[300]){0}, 300, &error),
                   TABOR_ERROR_VALUE);
  memcpy(field, "\n", 2);
  assert_int_equal(tabor_drum_def_validate(corners->def, &error), TABOR_ERROR_VALUE);
  assert_tidy(&error, TABOR_ERROR_VALUE);
  memcpy(field, good, param->size);
}

static bool corner_field(void *context, const TbParam *param, uint32_t element) {
  Corners *const corners = context;
  void *const field = tb_param_field(param, corners->def, element);
  char key[TB_DEF_KEY_SIZE];
  tb_def_key_write(corners->def, param, element, key);
  corners->checked++;
  if (param->info.type == TABOR_TYPE_NUMBER) {
    corner_number(corners, param, key, field);
  } else if (param->info.type == TABOR_TYPE_TEXT) {
    corner_text(corners, param, key, field);
  } else {
    uint32_t *const whole = field;
    const uint32_t good = *whole;
    *whole = UINT32_MAX;
    if (param->info.maximum < UINT32_MAX || param->info.type == TABOR_TYPE_CHOICE)
      refuse_field(corners, key);
    *whole = 0;
    if (param->base > 0) refuse_field(corners, key);
    *whole = good;
  }
  return true;
}

static void test_corners(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  must_set(&def, "mic.far.gain", "1");
  must_set(&def, "striker.two.mass", "1");
  must_set(&def, "resonant.tension", "3000");
  Corners corners = {&def, 0};
  assert_true(tb_walk(&def, corner_field, &corners));
  assert_true(corners.checked > 40 * 12);
  must_validate(&def);
}

/* Definitions of random bytes, and good ones with random bytes in them. */
static void test_random_structs(void **state) {
  (void)state;
  Random random = {99};
  print_message("seed %llu\n", (unsigned long long)random.state);
  for (int i = 0; i < 3000; i++) {
    TaborDrumDef def;
    TaborError error;
    char key[TB_DEF_KEY_SIZE], text[TABOR_TEXT_SIZE];
    tabor_drum_def_default(&def);
    unsigned char *const bytes = (unsigned char *)&def;
    const uint32_t start = random_below(&random, sizeof def);
    const uint32_t end = i % 4 ? start + random_below(&random, 32) : sizeof def;
    for (uint32_t j = i % 8 ? start : 0; j < end && j < sizeof def; j++) {
      bytes[j] = (unsigned char)random_whole(&random);
    }
    def.struct_size = sizeof def;
    const TaborStatus status = tabor_drum_def_validate(&def, &error);
    assert_tidy(&error, status);
    for (uint32_t k = 0; k < 6 && tabor_drum_def_key(&def, k * 83 + 5, key, sizeof key); k++) {
      (void)tabor_drum_def_get(&def, key, text, sizeof text, &error);
    }
    (void)tabor_drum_def_find_striker(&def, "stick");
    if (i % 16 == 0) (void)tabor_drum_def_set(&def, "mic.top.gian", "1", &error);
    (void)tabor_drum_def_set(&def, "mic.top.gain", "1", &error);
    assert_tidy(&error, error.status);
  }
}

/* Wires ---------------------------------------------------------------------------------------- */

static void test_wire_resolve(void **state) {
  (void)state;
  TaborDrumDef def;
  TaborWireDef wire;
  tabor_drum_def_default(&def);
  def.wires.count = 4;
  def.wires.offset = 0.01;
  def.wires.spacing = 0.002;
  def.wires.angle = 30;
  tb_wire_resolve(&def, 0, &wire);
  assert_true(wire.offset == 0.01 - 1.5 * 0.002);
  assert_true(wire.tension == def.wires.tension); /* no spread: untouched */
  assert_true(wire.angle == 30 && wire.length == def.wires.length);
  for (size_t i = 0; i < sizeof wire / sizeof(double); i++) {
    double value;
    memcpy(&value, (const char *)&wire + i * sizeof value, sizeof value);
    assert_true(isfinite(value));
  }
  def.wire[3] = (TaborWireDef){0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2};
  def.wires.tension_spread = 0.5;
  tb_wire_resolve(&def, 3, &wire);
  assert_true(same_bits(&wire, &def.wire[3], sizeof wire)); /* its own tension has no spread */
}

/* The draw must never change: it is part of what a preset sounds like. */
static void test_wire_spread(void **state) {
  (void)state;
  double sum = 0, lowest = 1, highest = -1;
  for (uint32_t seed = 0; seed < 1000; seed++) {
    for (uint32_t i = 0; i < TABOR_MAX_WIRES; i++) {
      const double u = tb_deviate(seed, i);
      assert_true(u >= -1 && u <= 1);
      sum += u;
      lowest = fmin(lowest, u);
      highest = fmax(highest, u);
    }
  }
  assert_true(fabs(sum / 40000) < 0.012); /* four standard errors of the mean, 0.577/200 */
  assert_true(lowest < -0.999 && highest > 0.999);
  /* SplitMix64's published first output for state 0 is 0xE220A8397B1DCDAF. */
  assert_true(tb_deviate(0, 0) ==
              (2.0 * (double)(0xE220A8397B1DCDAFu >> 12) + 1) / 4503599627370496.0 - 1);
  assert_true(tb_deviate(1, 0) != tb_deviate(0, 1));
}

/* At twice the head's tension wire and head both sound higher by sqrt(2). */
static void test_wires_follow_their_head(void **state) {
  (void)state;
  TaborDrumDef def;
  TaborWireDef wire;
  tabor_drum_def_default(&def);
  def.wires.count = 4;
  def.wires.head = TABOR_HEAD_RESONANT;
  def.wires.tension = 12;
  def.wires.head_tension = 3000;
  def.resonant.tension = 3000;
  tb_wire_resolve(&def, 1, &wire);
  assert_true(wire.tension == 12);
  def.resonant.tension = 6000;
  def.batter.tension = 1000;
  tb_wire_resolve(&def, 1, &wire);
  assert_true(wire.tension == 24);
  def.wires.tension = 200;
  tb_wire_resolve(&def, 1, &wire);
  assert_true(wire.tension == 200); /* no wire bears more */
  def.wire[1].tension = 5;
  tb_wire_resolve(&def, 1, &wire);
  assert_true(wire.tension == 5); /* its own does not follow */
  def.wires.head_tension = 0;
  tb_wire_resolve(&def, 2, &wire);
  assert_true(wire.tension == 200);
}

static int by_value(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* However few wires there are, the highest and the lowest lie the spread from a mean of
 * rest_offset, and the others evenly between them: the same standard deviation, spread sqrt((n +
 * 1)/(3 (n - 1))), for every seed. */
static void test_rest_spread(void **state) {
  (void)state;
  const double spread = 2e-4, mean = -5e-5;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.wires.rest_spread = 1e-4;
  def.wires.unevenness = 2;
  def.wires.rest_offset = mean;
  for (uint32_t count = 2; count <= TABOR_MAX_WIRES; count++) {
    def.wires.count = count;
    def.wires.seed = 77 * count;
    double lifted[TABOR_MAX_WIRES];
    for (uint32_t w = 0; w < count; w++) {
      TaborWireDef wire;
      tb_wire_resolve(&def, w, &wire);
      lifted[w] = wire.rest_offset - mean;
    }
    qsort(lifted, count, sizeof *lifted, by_value);
    for (uint32_t i = 0; i < count; i++) {
      const double expected = spread * (2.0 * i / (count - 1.0) - 1);
      assert_true(fabs(lifted[i] - expected) < 1e-19);
    }
  }
}

/* A wire of its own, one alone and even ones get none; each seed has its own order, which no
 * tension follows. */
static void test_rest_order(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.wires.rest_offset = 1e-4;
  def.wires.rest_spread = 1e-3;
  TaborWireDef wire;
  def.wires.count = 1;
  tb_wire_resolve(&def, 0, &wire);
  assert_true(wire.rest_offset == 1e-4);
  def.wires.count = TABOR_MAX_WIRES;
  double product = 0;
  uint32_t moved = 0;
  for (uint32_t seed = 0; seed < 1000; seed++) {
    for (uint32_t w = 0; w < TABOR_MAX_WIRES; w++) {
      def.wires.seed = seed;
      tb_wire_resolve(&def, w, &wire);
      const double own = wire.rest_offset;
      product += (own - 1e-4) / 1e-3 * tb_deviate(seed, w);
      def.wires.seed = seed + 1;
      tb_wire_resolve(&def, w, &wire);
      moved += wire.rest_offset != own;
    }
  }
  assert_true(fabs(product / 40000) < 0.01); /* five standard errors, 0.59 0.577/200 each */
  assert_true(moved > 38000);                /* one in 40 stays where it was */
  def.wires.unevenness = 0;
  tb_wire_resolve(&def, 5, &wire);
  assert_true(wire.rest_offset == 1e-4);
  def.wires.unevenness = 1;
  def.wire[5].rest_offset = 3e-4;
  tb_wire_resolve(&def, 5, &wire);
  assert_true(wire.rest_offset == 3e-4);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_wires_follow_their_head),
    cmocka_unit_test(test_rest_spread),
    cmocka_unit_test(test_rest_order),
    cmocka_unit_test(test_table),
    cmocka_unit_test(test_live_keys),
    cmocka_unit_test(test_parameter_find),
    cmocka_unit_test(test_table_covers_the_struct),
    cmocka_unit_test(test_default),
    cmocka_unit_test(test_clear),
    cmocka_unit_test(test_round_trip),
    cmocka_unit_test(test_keys_in_order),
    cmocka_unit_test(test_set_values),
    cmocka_unit_test(test_set_refusals),
    cmocka_unit_test(test_set_texts),
    cmocka_unit_test(test_unknown_keys),
    cmocka_unit_test(test_sections),
    cmocka_unit_test(test_full),
    cmocka_unit_test(test_arguments),
    cmocka_unit_test(test_get_refusals),
    cmocka_unit_test(test_random_texts),
    cmocka_unit_test(test_number_print),
    cmocka_unit_test(test_number_round_trip),
    cmocka_unit_test(test_locale),
    cmocka_unit_test(test_error_set),
    cmocka_unit_test(test_edit_distance),
    cmocka_unit_test(test_between_fields),
    cmocka_unit_test(test_names),
    cmocka_unit_test(test_counts),
    cmocka_unit_test(test_corners),
    cmocka_unit_test(test_random_structs),
    cmocka_unit_test(test_wire_resolve),
    cmocka_unit_test(test_wire_spread),
    cmocka_unit_test(test_second_head),
    cmocka_unit_test(test_second_head_keys),
    cmocka_unit_test(test_heads_alike),
    cmocka_unit_test(test_resonant_sheet),
    cmocka_unit_test(test_between_heads),
    cmocka_unit_test(test_mics_and_shell),
    cmocka_unit_test(test_inside),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
