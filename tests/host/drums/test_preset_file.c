/* SPDX-License-Identifier: MIT */
/* Files that are read, and those that cannot be; what stands in them is test_text's. */
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

/* A TaborTextTake. */
static TaborStatus count_line(void *lines, const TaborTextLine *line, TaborError *error) {
  if (line->key && strcmp(line->key, "no") == 0) {
    snprintf(error->message, sizeof error->message, "no '%s' today", line->key);
    return TABOR_ERROR_KEY;
  }
  (*(unsigned *)lines)++;
  return TABOR_OK;
}

static void test_read(void **state) {
  (void)state;
  static const struct {
    const char *text, *message;
  } files[] = {
    {"[a]\nx = 1\n", ""},
    {"[a]\nx = 1\nno = 2\n", ":3: no 'no' today"},
    {"[a]\nx\n", ":2: 'x' is neither [section], key = value nor ; comment"},
    {"", ": the file holds no section"},
  };
  for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
    unsigned lines = 0;
    char message[2000], expected[2000] = "";
    write_bytes(files[i].text, strlen(files[i].text));
    const PresetFileStatus status =
      preset_file_read(path, count_line, &lines, message, sizeof message);
    if (*files[i].message) snprintf(expected, sizeof expected, "%s%s", path, files[i].message);
    assert_string_equal(message, expected);
    assert_int_equal(status, i == 0 ? PRESET_FILE_OK : PRESET_FILE_INVALID);
    assert_int_equal(lines, i < 2 ? 2 : 0);
  }
}

static void test_size(void **state) {
  (void)state;
  unsigned lines = 0;
  char message[2000];
  char *const text = malloc(TABOR_TEXT_LIMIT + 2);
  memset(text, '\n', TABOR_TEXT_LIMIT + 2);
  memcpy(text, "[a]\nx = 1\n", 10);
  write_bytes(text, TABOR_TEXT_LIMIT);
  assert_int_equal(preset_file_read(path, count_line, &lines, message, sizeof message),
                   PRESET_FILE_OK);
  for (size_t more = 1; more <= 2; more++) {
    write_bytes(text, TABOR_TEXT_LIMIT + more);
    assert_int_equal(preset_file_read(path, count_line, &lines, message, sizeof message),
                     PRESET_FILE_INVALID);
    assert_non_null(strstr(message, ": the file is larger than 1048576 bytes"));
  }
  free(text);
}

static void unreadable(const char *name, const char *part) {
  unsigned lines = 0;
  char message[2000];
  assert_int_equal(preset_file_read(name, count_line, &lines, message, sizeof message),
                   PRESET_FILE_UNREADABLE);
  if (strncmp(message, name, strlen(name)) != 0 || !strstr(message, part)) fail_msg("%s", message);
  assert_int_equal(lines, 0);
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
  unsigned lines = 0;
  char room[64];
  for (size_t size = 0; size <= 40; size++) {
    memset(room, '#', sizeof room);
    (void)preset_file_read("/nonexistent/x.ini", count_line, &lines, room, size);
    for (size_t i = size; i < sizeof room; i++) assert_int_equal(room[i], '#');
    if (size > 0) assert_non_null(memchr(room, '\0', size));
  }
  char deep[1000], message[200];
  memset(deep, 'd', sizeof deep - 1);
  deep[sizeof deep - 1] = '\0';
  deep[0] = '\n';
  deep[998] = '\x1b';
  assert_int_equal(preset_file_read(deep, count_line, &lines, message, sizeof message),
                   PRESET_FILE_UNREADABLE);
#ifdef _WIN32
  assert_non_null(strstr(message, "No such file"));
#else
  assert_non_null(strstr(message, "name too long"));
#endif
  for (const char *c = message; *c; c++) assert_true((unsigned char)*c >= 0x20);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_read),
    cmocka_unit_test(test_size),
    cmocka_unit_test(test_unreadable),
    cmocka_unit_test(test_message_room),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
