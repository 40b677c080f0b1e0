/* SPDX-License-Identifier: MIT */
/* The traps of INI files in general and of inih 55 in particular (host/drums/preset_file.h). */
#define _POSIX_C_SOURCE 200809L
#define _DEFAULT_SOURCE /* mkdtemp */
#include "drums/preset_file.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "definition/preset.h"
#include "windows_names.h"

static char folder[1000];
static char path[1100];

static int set_up(void **state) {
  (void)state;
  const char *const temporary = getenv("TMPDIR");
  snprintf(folder, sizeof folder, "%s/test_preset_file.XXXXXX", temporary ? temporary : "/tmp");
  if (!mkdtemp(folder)) return -1;
  snprintf(path, sizeof path, "%s/p.ini", folder);
  return 0;
}

static int tear_down(void **state) {
  (void)state;
  (void)unlink(path);
  return rmdir(folder);
}

static void write_bytes(const void *bytes, size_t size) {
  FILE *const file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, size, file), size);
  assert_int_equal(fclose(file), 0);
}

/* Everything that the reader gave, as "12:section.key=value|", and the sections as "11:section|". */
typedef struct Log {
  char text[4096];
  char sections[4096];
  const char *refused; /* key at which to say no */
  unsigned calls;
} Log;

static bool take(void *context, const char *section, const char *key, const char *value,
                 unsigned line, char *message, size_t size) {
  Log *const log = context;
  if (!key) {
    const size_t length = strlen(log->sections);
    assert_null(value);
    if (log->refused && strcmp(section, log->refused) == 0) {
      snprintf(message, size, "no [%s] today", section);
      return false;
    }
    snprintf(log->sections + length, sizeof log->sections - length, "%u:%s|", line, section);
    return true;
  }
  log->calls++;
  if (log->refused && strcmp(key, log->refused) == 0) {
    snprintf(message, size, "no '%s' today", key);
    return false;
  }
  const size_t length = strlen(log->text);
  if (length + 600 < sizeof log->text) {
    snprintf(log->text + length, sizeof log->text - length, "%u:%s.%s=%s|", line, section, key,
             value);
  }
  return true;
}

static void accept_bytes(const char *bytes, size_t size, const char *expected) {
  Log log = {.calls = 0};
  char message[2000];
  write_bytes(bytes, size);
  const PresetFileStatus status = preset_file_read(path, take, &log, message, sizeof message);
  if (status != PRESET_FILE_OK) fail_msg("%s", message);
  assert_string_equal(log.text, expected);
  assert_string_equal(message, "");
}

static void accept(const char *text, const char *expected) {
  accept_bytes(text, strlen(text), expected);
}

/* INVALID, not one pair given, and one line "path:LINE: ...part...". */
static void refuse_bytes(const char *bytes, size_t size, unsigned line, const char *part) {
  Log log = {.calls = 0};
  char message[2000], place[1200];
  write_bytes(bytes, size);
  const PresetFileStatus status = preset_file_read(path, take, &log, message, sizeof message);
  if (line > 0) {
    snprintf(place, sizeof place, "%s:%u: ", path, line);
  } else {
    snprintf(place, sizeof place, "%s: ", path);
  }
  if (status != PRESET_FILE_INVALID || strncmp(message, place, strlen(place)) != 0 ||
      !strstr(message, part)) {
    fail_msg("status %d, '%s', expected '%s...%s'", status, message, place, part);
  }
  for (const char *c = message; *c; c++) assert_true((unsigned char)*c >= 0x20);
  assert_int_equal(log.calls, 0);
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
  char text[1000], expected[1000];
  for (size_t length = 190; length <= 198; length++) {
    const size_t size = long_line(text, length, "\ny = 1\n");
    snprintf(expected, sizeof expected, "2:a.x=%.*s|3:a.y=1|", (int)length - 4, text + 8);
    accept_bytes(text, size, expected);
  }
  for (size_t length = 199; length <= 420; length++) {
    refuse_bytes(text, long_line(text, length, "\ny = 1\n"), 2,
                 "the line is longer than 198 bytes");
  }
  refuse_bytes(text, long_line(text, 198, "\r\n"), 2, "the line is longer than 198 bytes");
  long_line(text, 197, "\r\n");
  snprintf(expected, sizeof expected, "2:a.x=%.*s|", 193, text + 8);
  accept(text, expected);
  /* The classic: what is cut off becomes a key of its own. */
  memset(text, ' ', sizeof text);
  memcpy(text, "[a]\nx = 1 ;", 11);
  strcpy(text + 4 + 199, "y = 2\n");
  refuse(text, 2, "the line is longer");
}

static void test_long_words(void **state) {
  (void)state;
  char text[300], word[64];
  memset(word, 'w', sizeof word);
  word[49] = '\0';
  snprintf(text, sizeof text, "[%s]\n%s = 1\n", word, word);
  char expected[300];
  snprintf(expected, sizeof expected, "2:%s.%s=1|", word, word);
  accept(text, expected);
  word[49] = 'w', word[50] = '\0';
  snprintf(text, sizeof text, "[%s]\nx = 1\n", word);
  refuse(text, 1, "is longer than 49 bytes");
  snprintf(text, sizeof text, "[a]\n%s = 1\n", word);
  refuse(text, 2, "is longer than 49 bytes");
}

static void test_size(void **state) {
  (void)state;
  char *const text = malloc(PRESET_FILE_LIMIT + 2);
  memset(text, '\n', PRESET_FILE_LIMIT + 1);
  memcpy(text, "[a]\nx = 1\n", 10);
  accept_bytes(text, PRESET_FILE_LIMIT, "2:a.x=1|");
  refuse_bytes(text, PRESET_FILE_LIMIT + 1, 0, "the file is larger than 65536 bytes");
  free(text);
}

/* As many sections and keys as fit: no table overflows, and no search takes for ever. */
static void test_dense(void **state) {
  (void)state;
  char *const text = malloc(PRESET_FILE_LIMIT + 64);
  size_t length = 0;
  for (unsigned i = 0; length + 16 < PRESET_FILE_LIMIT; i++) {
    length += (size_t)sprintf(text + length, "[%x]\na=\n", i);
  }
  Log log = {.calls = 0};
  char message[2000];
  write_bytes(text, length);
  assert_int_equal(preset_file_read(path, take, &log, message, sizeof message), PRESET_FILE_OK);
  assert_true(log.calls > 6000);
  length = (size_t)sprintf(text, "[a]\n");
  for (unsigned i = 0; length + 16 < PRESET_FILE_LIMIT; i++) {
    length += (size_t)sprintf(text + length, "%x=\n", i);
  }
  write_bytes(text, length);
  log.calls = 0;
  assert_int_equal(preset_file_read(path, take, &log, message, sizeof message), PRESET_FILE_OK);
  assert_true(log.calls > 10000);
  free(text);
}

static void test_refused_pair(void **state) {
  (void)state;
  Log log = {.refused = "y"};
  char message[2000], expected[2000];
  const char *const text = "[a]\nx = 1\n\ny = 2\nz = 3\n";
  write_bytes(text, strlen(text));
  assert_int_equal(preset_file_read(path, take, &log, message, sizeof message),
                   PRESET_FILE_INVALID);
  snprintf(expected, sizeof expected, "%s:4: no 'y' today", path);
  assert_string_equal(message, expected);
  assert_int_equal(log.calls, 2); /* nothing after the refusal */
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
    char message[2000];
    write_bytes(files[i].text, strlen(files[i].text));
    assert_int_equal(preset_file_read(path, take, &log, message, sizeof message), PRESET_FILE_OK);
    assert_string_equal(log.sections, files[i].sections);
  }
  static const char *const refused[] = {"[a]\nx = 1\n[no]\n", "[a]\nx = 1\n[no]\ny = 1\n[b]\n"};
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    Log log = {.refused = "no"};
    char message[2000], expected[2000];
    write_bytes(refused[i], strlen(refused[i]));
    assert_int_equal(preset_file_read(path, take, &log, message, sizeof message),
                     PRESET_FILE_INVALID);
    snprintf(expected, sizeof expected, "%s:3: no [no] today", path);
    assert_string_equal(message, expected);
    assert_string_equal(log.text, "2:a.x=1|");
  }
}

static void unreadable(const char *name, const char *part) {
  Log log = {.calls = 0};
  char message[2000];
  assert_int_equal(preset_file_read(name, take, &log, message, sizeof message),
                   PRESET_FILE_UNREADABLE);
  if (strncmp(message, name, strlen(name)) != 0 || !strstr(message, part)) fail_msg("%s", message);
  assert_int_equal(log.calls, 0);
}

#ifdef _WIN32
static void other_kinds_are_unreadable(void) { unreadable("NUL", "not a regular file"); }
#else
static void other_kinds_are_unreadable(void) {
  unreadable("/dev/null", "not a regular file");
  unreadable("/dev/zero", "not a regular file");
  (void)unlink(path);
  assert_int_equal(mkfifo(path, 0600), 0);
  alarm(20); /* would end the test rather than let it hang */
  unreadable(path, "not a regular file");
  alarm(0);
  (void)unlink(path);
  assert_int_equal(symlink(path, path), 0);
  unreadable(path, "symbolic link");
  (void)unlink(path);
  write_bytes("[a]\nx = 1\n", 10);
  assert_int_equal(chmod(path, 0), 0);
  if (geteuid() == 0) {
    print_message("SKIPPED: permissions mean nothing to root\n");
  } else {
    unreadable(path, "Permission denied");
  }
  (void)unlink(path);
}
#endif

static void test_unreadable(void **state) {
  (void)state;
  unreadable("/nonexistent/x.ini", "No such file");
  unreadable("", "No such file");
  unreadable(folder, "Is a directory");
  other_kinds_are_unreadable();
}

/* However little room there is, the message stays in it; a long path leaves room for the thing. */
static void test_message_room(void **state) {
  (void)state;
  Log log = {.calls = 0};
  char room[64];
  for (size_t size = 0; size <= 40; size++) {
    memset(room, '#', sizeof room);
    (void)preset_file_read("/nonexistent/x.ini", take, &log, room, size);
    for (size_t i = size; i < sizeof room; i++) assert_int_equal(room[i], '#');
    if (size > 0) assert_non_null(memchr(room, '\0', size));
  }
  char deep[1000], message[200];
  memset(deep, 'd', sizeof deep - 1);
  deep[sizeof deep - 1] = '\0';
  deep[0] = '\n';
  deep[998] = '\x1b';
  assert_int_equal(preset_file_read(deep, take, &log, message, sizeof message),
                   PRESET_FILE_UNREADABLE);
#ifdef _WIN32
  assert_non_null(strstr(message, "No such file"));
#else
  assert_non_null(strstr(message, "name too long"));
#endif
  for (const char *c = message; *c; c++) assert_true((unsigned char)*c >= 0x20);
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
    char text[2048] = "[s]\nk = 0\n", message[256];
    const unsigned count = i % 20;
    for (unsigned j = 0; j < count; j++) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      strcat(text, pieces[(random >> 33) % (sizeof pieces / sizeof pieces[0])]);
    }
    Log log = {.calls = 0};
    write_bytes(text, strlen(text));
    const PresetFileStatus status = preset_file_read(path, take, &log, message, sizeof message);
    accepted += status == PRESET_FILE_OK;
    assert_int_equal(status == PRESET_FILE_OK, *message == '\0');
    assert_null(strstr(message, "inih")); /* the checks and inih agree on every file */
    if (status != PRESET_FILE_OK) assert_int_equal(log.calls, 0);
  }
  assert_true(accepted > 20);
}

/* A preset of the engine's table, pair by pair. */
typedef struct TableReader {
  const TbPreset *preset;
  uint32_t next;
} TableReader;

static bool compare_pair(void *context, const char *section, const char *key, const char *value,
                         unsigned line, char *message, size_t size) {
  TableReader *const table = context;
  char full[128];
  (void)line, (void)message, (void)size;
  assert_true(table->next < table->preset->pair_count);
  const TbPresetPair *const pair = &table->preset->pairs[table->next++];
  snprintf(full, sizeof full, "%s%s%s", section, key ? "." : "", key ? key : "");
  assert_string_equal(pair->key, full);
  if (value) {
    assert_string_equal(pair->value, value);
  } else {
    assert_null(pair->value);
  }
  return true;
}

/* The table is written by CMake, which has a reader of its own. */
static void test_built_in(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tb_preset_count; i++) {
    TableReader table = {.preset = &tb_presets[i]};
    char name[1000], message[2000];
    snprintf(name, sizeof name, "%s/../presets/%s", TABOR_TEST_DATA, tb_presets[i].info.file);
    if (preset_file_read(name, compare_pair, &table, message, sizeof message) != PRESET_FILE_OK)
      fail_msg("%s", message);
    assert_int_equal(table.next, tb_presets[i].pair_count);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_good),       cmocka_unit_test(test_last_line),
    cmocka_unit_test(test_structure),  cmocka_unit_test(test_duplicates),
    cmocka_unit_test(test_characters), cmocka_unit_test(test_long_lines),
    cmocka_unit_test(test_long_words), cmocka_unit_test(test_size),
    cmocka_unit_test(test_dense),      cmocka_unit_test(test_refused_pair),
    cmocka_unit_test(test_unreadable), cmocka_unit_test(test_message_room),
    cmocka_unit_test(test_random),     cmocka_unit_test(test_sections),
    cmocka_unit_test(test_built_in),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
