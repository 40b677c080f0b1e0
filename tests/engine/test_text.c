/* SPDX-License-Identifier: MIT */
/* Texts of sections and keys: the traps of such files, and definitions that come back from theirs.
 */
#include "tabor/kit.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Everything that the reader gave, as "12:section.key=value|", and the sections as "11:section|".
 */
typedef struct Log {
  char text[4096];
  char sections[4096];
  const char *refused; /* key at which to say no */
  unsigned calls;
} Log;

static TaborStatus take(void *context, const TaborTextLine *line, TaborError *error) {
  Log *const log = context;
  const char *const name = line->key ? line->key : line->section;
  if (line->key) log->calls++;
  if (log->refused && strcmp(name, log->refused) == 0) {
    snprintf(error->message, sizeof error->message, "no '%s' today", name);
    return TABOR_ERROR_NAME;
  }
  if (!line->key) {
    const size_t length = strlen(log->sections);
    assert_null(line->value);
    snprintf(log->sections + length, sizeof log->sections - length, "%u:%s|",
             (unsigned)line->number, line->section);
    return TABOR_OK;
  }
  const size_t length = strlen(log->text);
  if (length + 600 < sizeof log->text) {
    snprintf(log->text + length, sizeof log->text - length, "%u:%s.%s=%s|", (unsigned)line->number,
             line->section, line->key, line->value);
  }
  return TABOR_OK;
}

static void accept_bytes(const char *bytes, size_t size, const char *expected) {
  Log log = {.calls = 0};
  TaborError error;
  if (tabor_text_read(bytes, size, take, &log, &error) != TABOR_OK) fail_msg("%s", error.message);
  assert_string_equal(log.text, expected);
  assert_string_equal(error.message, "");
}

static void accept(const char *text, const char *expected) {
  accept_bytes(text, strlen(text), expected);
}

/* Not one pair given; line 0: the text as a whole. */
static void refuse_bytes(const char *bytes, size_t size, unsigned line, const char *part) {
  Log log = {.calls = 0};
  TaborError error;
  const TaborStatus status = tabor_text_read(bytes, size, take, &log, &error);
  if (status != TABOR_ERROR_VALUE || error.line != line || !strstr(error.message, part)) {
    fail_msg("status %d, line %u, '%s', expected line %u, '%s'", (int)status, (unsigned)error.line,
             error.message, line, part);
  }
  assert_int_equal(error.status, status);
  assert_int_equal(error.column > 0, line > 0);
  for (const char *c = error.message; *c; c++) assert_true((unsigned char)*c >= 0x20);
  assert_int_equal(log.calls, 0);
  assert_string_equal(log.sections, "");
  assert_int_equal(tabor_text_read(bytes, size, take, &log, NULL), status);
}

static void refuse(const char *text, unsigned line, const char *part) {
  refuse_bytes(text, strlen(text), line, part);
}

static void test_good(void **state) {
  (void)state;
  accept("; c\n# d\n\n[a]\nx = 1 ; one\ny=2\n\n[b.c]  ; section\nx =\t3\t;three\n   ; indented "
         "comment\n \t\n",
         "5:a.x=1|6:a.y=2|9:b.c.x=3|");
  accept("[a]\r\nx = 1\r\n\r\ny = 2 ; z\r\n", "2:a.x=1|4:a.y=2|");
  accept("\xEF\xBB\xBF[a]\nx = 1\n", "2:a.x=1|");
  accept("[a]\nx =\ny = ; nothing\n", "2:a.x=|3:a.y=|");
  accept("[a]\nx = p=q:r;s [t] \xC3\xA9\n", "2:a.x=p=q:r;s [t] \xC3\xA9|");
  accept("[a]\nx = \"q\"\n[x]\nx=1\n",
         "2:a.x=\"q\"|4:x.x=1|"); /* quotes are text; sections apart */
}

/* A file that was cut off lacks its last line end, wherever that was. */
static void test_last_line(void **state) {
  (void)state;
  refuse("[a]\nx = 1 ; cut comm", 2, "no line end");
  refuse("[a]\nx = 1\n; cut comm", 3, "no line end");
  refuse("[a]\nx = 1\n[b]", 3, "no line end");
  refuse("[a]\nx = 30", 2, "no line end");
  refuse("[a]\nx = 30  ", 2, "no line end");
  refuse("[a]\nx = 30\r", 2, "no line end");
  refuse("[a]\nx = 30;0", 2, "no line end");
  refuse("[a]\nx = ", 2, "no line end");
  refuse("[a]\nx = 1\nten", 3, "neither [section], key = value nor ; comment");
  refuse("[a]\nx = 1\n[b", 3, "a '[' without a ']'");
}

static void test_structure(void **state) {
  (void)state;
  refuse("", 0, "holds no section");
  refuse("; nothing\n\n", 0, "holds no section");
  refuse("x = 1\n[a]\n", 1, "'x' stands before the first section");
  refuse("[a]\nx\n", 2, "'x' is neither");
  refuse("[a]\nx 1 ; y = 2\n", 2, "neither");
  refuse("[a]\nx: 1\n", 2, "neither");
  refuse("[a]\nx: y = 1\n", 2, "neither");
  refuse("[a]\n = 1\n", 2, "the line is indented");
  refuse("[a]\n= 1\n", 2, "a key without a name");
  refuse("[]\nx = 1\n", 1, "a section without a name");
  refuse("[a\nx = 1\n", 1, "a '[' without a ']'");
  refuse("[a ;]\nx = 1\n", 1, "a '[' without a ']'");
  refuse("[a] x = 1\n", 1, "'x = 1' after the section's ']'");
  refuse("[a]]\nx = 1\n", 1, "']' after");
  refuse("[a]\nx = 1\n y = 2\n", 3, "the line is indented");
  refuse("[a]\nx = 1\n\ty\n", 3, "the line is indented");
  refuse(" [a]\nx = 1\n", 1, "the line is indented");
}

static void test_duplicates(void **state) {
  (void)state;
  refuse("[a]\nx = 1\ny = 2\nx = 1\n", 4, "'x' occurs twice in its section, first in line 2");
  refuse("[a]\nx = 1\nx=1\n", 3, "occurs twice");
  refuse("[a]\nx = 1\n[b]\nx = 1\n[a]\ny = 1\n", 5, "section [a] occurs twice, first in line 1");
  refuse("[a]\n[a]\nx = 1\n", 2, "occurs twice");
  accept("[a]\nx = 1\nxx = 2\nX = 3\n[aa]\nx = 4\n", "2:a.x=1|3:a.xx=2|4:a.X=3|6:aa.x=4|");
}

static void test_characters(void **state) {
  (void)state;
  static const char nul[] = "[a]\nx = 12\0"
                            "34\n";
  refuse_bytes(nul, sizeof nul - 1, 2, "a control character (0x00)");
  refuse("[a]\nx = 1\n\x01\n", 3, "a control character (0x01)");
  refuse("[a]\nx = \x1b[31m\n", 2, "a control character (0x1b)");
  refuse("[a]\nx = 1\v\n", 2, "a control character (0x0b)");
  refuse("[a]\nx = 1\x7f\n", 2, "a control character (0x7f)");
  refuse("[a]\nx = 1\xC2\x85y = 2\n", 2, "a control character (0x85)");
  refuse("[a]\rx = 1\ry = 2\r", 1, "a control character (0x0d)");
  static const char *const broken[] = {"\x80",
                                       "\xBF",
                                       "\xC0\x80",
                                       "\xC1\xBF",
                                       "\xC3",
                                       "\xC3x",
                                       "\xE0\x9F\xBF",
                                       "\xE2\x82",
                                       "\xED\xA0\x80",
                                       "\xF0\x8F\xBF\xBF",
                                       "\xF0\x9F\xA5",
                                       "\xF4\x90\x80\x80",
                                       "\xF5\x80\x80\x80",
                                       "\xFF",
                                       "\xFE"};
  for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
    char text[64];
    snprintf(text, sizeof text, "[a]\n; %s\nx = 1\n", broken[i]);
    refuse(text, 2, "not UTF-8");
    snprintf(text, sizeof text, "[a]\nx = 1\n; %s", broken[i]); /* cut off within a character */
    refuse(text, 3, "not UTF-8");
  }
  accept(
    "[a]\nx = "
    "\xC2\xA0\xDF\xBF\xE0\xA0\x80\xED\x9F\xBF\xEF\xBF\xBD\xF0\x90\x80\x80\xF4\x8F\xBF\xBF\n",
    "2:a.x=\xC2\xA0\xDF\xBF\xE0\xA0\x80\xED\x9F\xBF\xEF\xBF\xBD\xF0\x90\x80\x80\xF4\x8F\xBF\xBF|");
  static const unsigned char elf[] = {0x7F, 'E', 'L', 'F', 2, 1, 1, 0, 0, 0, 0, 0};
  refuse_bytes((const char *)elf, sizeof elf, 1, "a control character");
}

/* "[a]\nx = 7777...\n" whose second line has @p length bytes before its end. */
static size_t long_line(char *text, size_t length, const char *end) {
  memcpy(text, "[a]\nx = ", 8);
  memset(text + 8, '7', length - 4);
  strcpy(text + 4 + length, end);
  return 4 + length + strlen(end);
}

static void test_long_lines(void **state) {
  (void)state;
  enum { MOST = TABOR_TEXT_LINE };
  char text[2 * MOST], expected[2 * MOST];
  for (size_t length = MOST - 8; length <= MOST; length++) {
    const size_t size = long_line(text, length, "\ny = 1\n");
    snprintf(expected, sizeof expected, "2:a.x=%.*s|3:a.y=1|", (int)length - 4, text + 8);
    accept_bytes(text, size, expected);
  }
  for (size_t length = MOST + 1; length <= MOST + 200; length++) {
    refuse_bytes(text, long_line(text, length, "\ny = 1\n"), 2,
                 "the line is longer than 511 bytes");
  }
  refuse_bytes(text, long_line(text, MOST, "\r\n"), 2, "the line is longer than 511 bytes");
  long_line(text, MOST - 1, "\r\n");
  snprintf(expected, sizeof expected, "2:a.x=%.*s|", MOST - 5, text + 8);
  accept(text, expected);
}

static void test_long_words(void **state) {
  (void)state;
  enum { MOST = TABOR_TEXT_WORD };
  char text[600], word[MOST + 2];
  memset(word, 'w', sizeof word);
  word[MOST] = '\0';
  snprintf(text, sizeof text, "[%s]\n%s = 1\n", word, word);
  char expected[600];
  snprintf(expected, sizeof expected, "2:%s.%s=1|", word, word);
  accept(text, expected);
  word[MOST] = 'w', word[MOST + 1] = '\0';
  snprintf(text, sizeof text, "[%s]\nx = 1\n", word);
  refuse(text, 1, "is longer than 127 bytes");
  snprintf(text, sizeof text, "[a]\n%s = 1\n", word);
  refuse(text, 2, "is longer than 127 bytes");
}

static void test_size(void **state) {
  (void)state;
  char *const text = malloc(TABOR_TEXT_LIMIT + 2);
  memset(text, '\n', TABOR_TEXT_LIMIT + 1);
  memcpy(text, "[a]\nx = 1\n", 10);
  accept_bytes(text, TABOR_TEXT_LIMIT, "2:a.x=1|");
  refuse_bytes(text, TABOR_TEXT_LIMIT + 1, 0, "the file is larger than 1048576 bytes");
  free(text);
}

/* As many sections and keys as fit: no table overflows, and no search takes for ever. */
static void test_dense(void **state) {
  (void)state;
  char *const text = malloc(TABOR_TEXT_LIMIT + 64);
  size_t length = 0;
  for (unsigned i = 0; length + 16 < TABOR_TEXT_LIMIT; i++) {
    length += (size_t)sprintf(text + length, "[%x]\na=\n", i);
  }
  Log log = {.calls = 0};
  assert_int_equal(tabor_text_read(text, length, take, &log, NULL), TABOR_OK);
  assert_true(log.calls > 90000);
  length = (size_t)sprintf(text, "[a]\n");
  for (unsigned i = 0; length + 16 < TABOR_TEXT_LIMIT; i++) {
    length += (size_t)sprintf(text + length, "%x=\n", i);
  }
  log.calls = 0;
  assert_int_equal(tabor_text_read(text, length, take, &log, NULL), TABOR_OK);
  assert_true(log.calls > 150000);
  free(text);
}

static void test_refused_pair(void **state) {
  (void)state;
  Log log = {.refused = "y"};
  TaborError error;
  const char *const text = "[a]\nx = 1\n\ny = 2\nz = 3\n";
  assert_int_equal(tabor_text_read(text, strlen(text), take, &log, &error), TABOR_ERROR_NAME);
  assert_string_equal(error.message, "no 'y' today");
  assert_int_equal(error.line, 4);
  assert_int_equal(error.column, 5); /* of the value */
  assert_int_equal(log.calls, 2);    /* nothing after the refusal */
}

static void test_columns(void **state) {
  (void)state;
  static const struct {
    const char *text;
    unsigned line, column;
  } texts[] = {
    {"[a]\nx = 1\v\n", 2, 6},
    {"[a]\nx = \xC3\xA9\x80\n", 2, 7},
    {"[a] x\n", 1, 5},
    {"[a]\n  x = 1\n", 2, 3},
    {"[a]\nx = 1", 2, 6},
    {"\xEF\xBB\xBFx\n", 1, 1},
    {"; c\n[a]\n[b]\n[a]\n", 4, 2},
    {"[a]\nxyz\n", 2, 1},
  };
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
    Log log = {.calls = 0};
    TaborError error;
    assert_int_equal(tabor_text_read(texts[i].text, strlen(texts[i].text), take, &log, &error),
                     TABOR_ERROR_VALUE);
    assert_int_equal(error.line, texts[i].line);
    assert_int_equal(error.column, texts[i].column);
  }
  TaborDrumDef def;
  TaborError error;
  const char *const value = "[batter]\ntension =  loud ; N/m\n", *const key =
                                                                   "[batter]\ntenson = 3\n";
  assert_int_equal(tabor_drum_def_read(&def, value, strlen(value), &error), TABOR_ERROR_VALUE);
  assert_true(error.line == 2 && error.column == 12);
  assert_string_equal(error.key, "batter.tension");
  assert_int_equal(tabor_drum_def_read(&def, key, strlen(key), &error), TABOR_ERROR_KEY);
  assert_true(error.line == 2 && error.column == 1);
}

/* Sections are given, too, each before its pairs, and those without any. */
static void test_sections(void **state) {
  (void)state;
  static const struct {
    const char *text, *sections;
  } files[] = {
    {"[a]\nx = 1\n[b]\ny = 2\n", "1:a|3:b|"},
    {"; c\n[a]\n[b]\n\n[c]  ; why\nx = 1\n[d]\n", "2:a|3:b|5:c|7:d|"},
    {"[a]\n", "1:a|"},
  };
  for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
    Log log = {.calls = 0};
    const char *const text = files[i].text;
    assert_int_equal(tabor_text_read(text, strlen(text), take, &log, NULL), TABOR_OK);
    assert_string_equal(log.sections, files[i].sections);
  }
  static const char *const refused[] = {"[a]\nx = 1\n[no]\n", "[a]\nx = 1\n[no]\ny = 1\n[b]\n"};
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    Log log = {.refused = "no"};
    TaborError error;
    assert_int_equal(tabor_text_read(refused[i], strlen(refused[i]), take, &log, &error),
                     TABOR_ERROR_NAME);
    assert_string_equal(error.message, "no 'no' today");
    assert_true(error.line == 3 && error.column == 2);
    assert_string_equal(log.text, "2:a.x=1|");
  }
}

/* Random mixtures of what means something: read or refused, never a crash or a pair made up. */
static void test_random(void **state) {
  (void)state;
  static const char *const pieces[] = {
    "[a]",          "[b]",     "\n",      "\n",   "\n", "x", "y", "=",    " = ", "1",        ";",
    " ;",           ":",       "#",       " ",    "\t", "]", "[", "\r\n", "\r",  "\xC3\xA9", "\xC3",
    "\xEF\xBB\xBF", "x = 1\n", "y = 2\n", "[c]\n"};
  uint64_t random = 31337;
  print_message("seed %llu\n", (unsigned long long)random);
  unsigned accepted = 0;
  for (int i = 0; i < 1500; i++) {
    char text[2048] = "[s]\nk = 0\n";
    const unsigned count = i % 20;
    for (unsigned j = 0; j < count; j++) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      strcat(text, pieces[(random >> 33) % (sizeof pieces / sizeof pieces[0])]);
    }
    Log log = {.calls = 0};
    TaborError error;
    const TaborStatus status = tabor_text_read(text, strlen(text), take, &log, &error);
    accepted += status == TABOR_OK;
    assert_int_equal(status == TABOR_OK, error.message[0] == '\0');
    if (status != TABOR_OK) assert_int_equal(log.calls, 0);
  }
  assert_true(accepted > 20);
}

/* ---- definitions ---- */

static char *write_drum(const TaborDrumDef *def, uint32_t form) {
  size_t length, again;
  assert_int_equal(tabor_drum_def_write(def, form, NULL, 0, &length, NULL), TABOR_OK);
  char *const text = malloc(length + 1);
  assert_int_equal(tabor_drum_def_write(def, form, text, length, &again, NULL),
                   TABOR_ERROR_ARGUMENT);
  assert_true(text[0] == '\0' && again == 0);
  assert_int_equal(tabor_drum_def_write(def, form, text, length + 1, &again, NULL), TABOR_OK);
  assert_true(again == length && strlen(text) == length);
  return text;
}

static void check_drum(const TaborDrumDef *def) {
  for (uint32_t form = TABOR_TEXT_EDIT; form <= TABOR_TEXT_KEEP; form++) {
    TaborDrumDef read;
    char *const text = write_drum(def, form);
    assert_int_equal(tabor_drum_def_read(&read, text, strlen(text), NULL), TABOR_OK);
    assert_memory_equal(&read, def, sizeof read);
    assert_int_equal(strstr(text, "; [m]") != NULL, form == TABOR_TEXT_EDIT);
    free(text);
  }
}

/* The file of a preset or kit, which the library was built with. */
static char *read_file(const char *folder, const char *file, size_t *size) {
  char name[1000];
  snprintf(name, sizeof name, "%s/../%s/%s", TABOR_TEST_DATA, folder, file);
  FILE *const stream = fopen(name, "rb");
  assert_non_null(stream);
  char *const text = malloc(65536);
  *size = fread(text, 1, 65536, stream);
  fclose(stream);
  return text;
}

static void test_presets(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    TaborDrumDef def, read;
    size_t size;
    assert_int_equal(tabor_drum_def_preset(&def, tabor_preset(i)->name, NULL), TABOR_OK);
    char *const text = read_file("presets", tabor_preset(i)->file, &size);
    assert_int_equal(tabor_drum_def_read(&read, text, size, NULL), TABOR_OK);
    free(text);
    assert_memory_equal(&read, &def, sizeof def);
    assert_string_equal(tabor_preset(i)->comment, def.comment);
    check_drum(&def);
  }
}

/* Every text field and every array as long as it may be. */
static void test_largest_drum(void **state) {
  (void)state;
  TaborDrumDef def;
  char name[TABOR_NAME_SIZE], key[2 * TABOR_NAME_SIZE], words[TABOR_TEXT_SIZE];
  tabor_drum_def_clear(&def);
  memset(words, 'w', sizeof words - 1);
  words[sizeof words - 1] = '\0';
  assert_int_equal(tabor_drum_def_set(&def, "drum.comment", words, NULL), TABOR_OK);
  memset(name, 'n', TABOR_NAME_LENGTH);
  name[TABOR_NAME_LENGTH] = '\0';
  for (char i = '0'; i < '0' + TABOR_MAX_MICS; i++) {
    name[0] = i;
    snprintf(key, sizeof key, "mic.%s.gain", name);
    assert_int_equal(tabor_drum_def_set(&def, key, "0.125", NULL), TABOR_OK);
    snprintf(key, sizeof key, "striker.%s.contact_stiffness", name);
    (void)tabor_drum_def_set(&def, key, "1.2345678e8", NULL);
  }
  for (int i = 1; i <= TABOR_MAX_WIRES; i++) {
    snprintf(key, sizeof key, "wire.%d.bending_stiffness", i);
    assert_int_equal(tabor_drum_def_set(&def, key, "1.23456789e-7", NULL), TABOR_OK);
  }
  check_drum(&def);
}

static void test_texts_that_do_not_survive(void **state) {
  (void)state;
  static const char *const texts[] = {" a", "a ", "; a", "a ; b", ";", " "};
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
    TaborError error;
    char text[65536];
    assert_int_equal(tabor_drum_def_set(&def, "drum.comment", texts[i], NULL), TABOR_OK);
    assert_int_equal(tabor_drum_def_write(&def, TABOR_TEXT_EDIT, text, sizeof text, NULL, &error),
                     TABOR_ERROR_VALUE);
    assert_string_equal(error.key, "drum.comment");
    assert_string_equal(text, "");
  }
  assert_int_equal(tabor_drum_def_set(&def, "drum.comment", "a;b = [c]", NULL), TABOR_OK);
  check_drum(&def);
  assert_int_equal(tabor_drum_def_write(&def, 2, NULL, 0, NULL, NULL), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_drum_def_write(NULL, 0, NULL, 0, NULL, NULL), TABOR_ERROR_ARGUMENT);
}

/* Full keys stand before the first section, as plugins saved them before 0.2.0. */
static void test_full_keys(void **state) {
  (void)state;
  TaborDrumDef def;
  const char *const text = "shell.radius = 0.2\nmic.top.gain = 0.5\n[batter]\ntension = 3000\n";
  assert_int_equal(tabor_drum_def_read(&def, text, strlen(text), NULL), TABOR_OK);
  assert_true(def.shell.radius == 0.2 && def.mic[0].gain == 0.5 && def.batter.tension == 3000);
}

/* ---- kits ---- */

static void check_kit(const TaborKitDef *kit, uint32_t form) {
  TaborKitDef *const read = malloc(sizeof *read);
  size_t length;
  assert_int_equal(tabor_kit_def_write(kit, form, NULL, 0, &length, NULL), TABOR_OK);
  char *const text = malloc(length + 1);
  TaborError error;
  assert_int_equal(tabor_kit_def_write(kit, form, text, length + 1, NULL, NULL), TABOR_OK);
  if (tabor_kit_def_read(read, text, length, &error) != TABOR_OK) fail_msg("%s", error.message);
  assert_memory_equal(read, kit, sizeof *read);
  free(text);
  free(read);
}

static void test_kits(void **state) {
  (void)state;
  TaborKitDef *const kit = malloc(sizeof *kit), *const read = malloc(sizeof *read);
  for (uint32_t i = 0; i < tabor_kit_count(); i++) {
    size_t size;
    assert_int_equal(tabor_kit_def_preset(kit, tabor_kit(i)->name, NULL), TABOR_OK);
    char *const text = read_file("kits", tabor_kit(i)->file, &size);
    assert_int_equal(tabor_kit_def_read(read, text, size, NULL), TABOR_OK);
    free(text);
    assert_memory_equal(read, kit, sizeof *kit);
    check_kit(kit, TABOR_TEXT_EDIT);
    check_kit(kit, TABOR_TEXT_KEEP);
    kit->coupled = 0;
    kit->note[46] = (TaborKitNoteDef){"sounds/hat.wav", -0.1, 3};
    kit->drum[0].def.batter.tension += 0.1;
    check_kit(kit, TABOR_TEXT_EDIT);
    check_kit(kit, TABOR_TEXT_KEEP);
  }
  free(read);
  free(kit);
}

/* As large as a kit can be: its text stays within the limit. */
static void test_largest_kit(void **state) {
  (void)state;
  TaborKitDef *const kit = malloc(sizeof *kit);
  tabor_kit_def_default(kit);
  memset(kit->name, 'n', TABOR_NAME_SIZE - 1);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    char name[TABOR_NAME_SIZE], key[4 * TABOR_NAME_SIZE];
    memset(name, 'd', sizeof name);
    name[TABOR_NAME_LENGTH] = '\0';
    name[0] = (char)('a' + i);
    snprintf(key, sizeof key, "drum.%s.preset", name);
    assert_int_equal(tabor_kit_def_set(kit, key, "snare-14x5.5", NULL), TABOR_OK);
    for (int wire = 1; wire <= TABOR_MAX_WIRES; wire++) {
      snprintf(key, sizeof key, "drum.%s.wire.%d.tension", name, wire);
      assert_int_equal(tabor_kit_def_set(kit, key, "1.2345678901234567", NULL), TABOR_OK);
    }
  }
  for (uint32_t i = 0; i < TABOR_KIT_NOTES; i++) {
    memset(kit->note[i].sample, 's', TABOR_TEXT_SIZE - 1);
    kit->drum[0].notes[i] = TABOR_KIT_STROKE_CROSS_STICK;
  }
  check_kit(kit, TABOR_TEXT_EDIT);
  check_kit(kit, TABOR_TEXT_KEEP);
  free(kit);
}

/* Each key that is listed can be had, and set to what it was. */
static void test_keys_of_kits(void **state) {
  (void)state;
  TaborKitDef *const kit = malloc(sizeof *kit), *const copy = malloc(sizeof *copy);
  char key[4 * TABOR_NAME_SIZE], value[2 * TABOR_TEXT_SIZE];
  TaborError error;
  uint32_t count = 0;
  assert_int_equal(tabor_kit_def_preset(kit, "standard", NULL), TABOR_OK);
  assert_int_equal(tabor_kit_def_set(kit, "note.42.sample", "hat.wav", NULL), TABOR_OK);
  *copy = *kit;
  for (; tabor_kit_def_key(kit, count, key, sizeof key); count++) {
    if (tabor_kit_def_get(kit, key, value, sizeof value, &error) != TABOR_OK) {
      fail_msg("%s: %s", key, error.message);
    }
    if (strstr(key, ".preset")) continue; /* its own changes would go */
    if (tabor_kit_def_set(copy, key, value, &error) != TABOR_OK) fail_msg("%s", error.message);
  }
  assert_memory_equal(kit, copy, sizeof *kit);
  assert_true(count > 500);
  assert_false(tabor_kit_def_key(kit, 0, key, 4));
  static const struct {
    const char *key, *value;
  } known[] = {{"kit.overheads", "-11"},  {"drum.snare.preset", "snare-14x5.5"},
               {"drum.snare.head", "38"}, {"note.42.sample", "hat.wav"},
               {"note.43.sample", ""},    {"note.42.gain", "0"},
               {"drum.kick.tilt", "90"}};
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    assert_int_equal(tabor_kit_def_get(kit, known[i].key, value, sizeof value, &error), TABOR_OK);
    assert_string_equal(value, known[i].value);
  }
  static const struct {
    const char *key;
    TaborStatus status;
  } wrong[] = {
    {"kit.loud", TABOR_ERROR_KEY},        {"drum.snair.x", TABOR_ERROR_NAME},
    {"drum.snare.loud", TABOR_ERROR_KEY}, {"note.128.gain", TABOR_ERROR_KEY},
    {"note.42.pitch", TABOR_ERROR_KEY},   {"loud", TABOR_ERROR_KEY},
    {"drum.snare", TABOR_ERROR_KEY},      {"drum.snare.mic.none.gain", TABOR_ERROR_NAME}};
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    assert_int_equal(tabor_kit_def_get(kit, wrong[i].key, value, sizeof value, &error),
                     wrong[i].status);
    assert_string_equal(value, "");
    assert_true(error.message[0] != '\0');
  }
  assert_int_equal(tabor_kit_def_get(kit, "kit.name", value, 3, &error), TABOR_ERROR_ARGUMENT);
  free(copy);
  free(kit);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_good),         cmocka_unit_test(test_last_line),
    cmocka_unit_test(test_structure),    cmocka_unit_test(test_duplicates),
    cmocka_unit_test(test_characters),   cmocka_unit_test(test_long_lines),
    cmocka_unit_test(test_long_words),   cmocka_unit_test(test_size),
    cmocka_unit_test(test_dense),        cmocka_unit_test(test_refused_pair),
    cmocka_unit_test(test_columns),      cmocka_unit_test(test_random),
    cmocka_unit_test(test_sections),     cmocka_unit_test(test_presets),
    cmocka_unit_test(test_largest_drum), cmocka_unit_test(test_texts_that_do_not_survive),
    cmocka_unit_test(test_full_keys),    cmocka_unit_test(test_kits),
    cmocka_unit_test(test_largest_kit),  cmocka_unit_test(test_keys_of_kits),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
