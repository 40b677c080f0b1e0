/* SPDX-License-Identifier: MIT */
/* Keys from bytes, however these are divided, and their names. */
#include "base/keys.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#define UNKNOWN KEY_UNKNOWN

/* Bytes as a terminal sends them, and the keys that they are. */
typedef struct Sequence {
  const char *bytes;
  Key keys[8]; /* up to a 0 */
} Sequence;

/* xterm's, the Linux console's and rxvt's, from their documents (ctlseqs, console_codes(4),
 * terminfo). */
static const Sequence sequences[] = {
  {"a", {'a'}},
  {"sdf", {'s', 'd', 'f'}},
  {" ;[", {' ', ';', '['}},
  {"\r", {KEY_ENTER}},
  {"\n", {KEY_ENTER}},
  {"\x7f", {KEY_BACKSPACE}},
  {"\b", {KEY_BACKSPACE}},
  {"\x03", {KEY_CTRL('c')}},
  {"\t", {KEY_TAB}},
  {"\xc3\xa9", {0xe9}},
  {"\xe2\x82\xac", {0x20ac}},
  {"\xf0\x9f\xa5\x81", {0x1f941}},
  {"\033[A", {KEY_UP}},
  {"\033OB", {KEY_DOWN}},
  {"\033[C", {KEY_RIGHT}},
  {"\033[1;5D", {KEY_LEFT}}, /* with Ctrl */
  {"\033[H", {KEY_HOME}},
  {"\033OF", {KEY_END}},
  {"\033[1~", {KEY_HOME}},
  {"\033[2~", {KEY_INSERT}},
  {"\033[3~", {KEY_DELETE}},
  {"\033[3;2~", {KEY_DELETE}},
  {"\033[4~", {KEY_END}},
  {"\033[5~", {KEY_PAGE_UP}},
  {"\033[6~", {KEY_PAGE_DOWN}},
  {"\033[7~", {KEY_HOME}},
  {"\033[8~", {KEY_END}},
  {"\033OP", {KEY_F1}},
  {"\033[[A", {KEY_F1}},
  {"\033[11~", {KEY_F1}},
  {"\033[[E", {KEY_F1 + 4}},
  {"\033[15~", {KEY_F1 + 4}},
  {"\033[17~", {KEY_F1 + 5}},
  {"\033[21~", {KEY_F1 + 9}},
  {"\033[23~", {KEY_F1 + 10}},
  {"\033[24~", {KEY_F1 + 11}},
  {"\033OM", {KEY_ENTER}},
  {"\033[A\033[Bx", {KEY_UP, KEY_DOWN, 'x'}},
  {"\033a", {KEY_ESCAPE, 'a'}}, /* Alt-a, or two keys */
  {"\033\033[A", {KEY_ESCAPE, KEY_UP}},
  {"\033Oz", {KEY_ESCAPE, 'O', 'z'}},
  {"\033[9;9z", {UNKNOWN}},
  {"\033[99~a", {UNKNOWN, 'a'}},
  {"\033[200~", {UNKNOWN}},
  {"\033[<0;1;1Mb", {KEY_ENTER, 'b'}}, /* a mouse's, which nobody asked for; harmless */
  {"\033[1\033[A", {UNKNOWN, KEY_UP}}, /* cut off by another */
  {"\033[1\xc3\xa9", {UNKNOWN, 0xe9}},
  {"\xc3(", {UNKNOWN, '('}}, /* not UTF-8 */
  {"\xff-", {UNKNOWN, '-'}},
  {"\xc0\x80", {UNKNOWN, UNKNOWN}},
  {"\xed\xa0\x80", {UNKNOWN}},     /* a surrogate */
  {"\xf4\x90\x80\x80", {UNKNOWN}}, /* beyond the last character */
  {"\xe2\x82\033[A", {UNKNOWN, KEY_UP}},
};
#define SEQUENCES (sizeof sequences / sizeof sequences[0])

static void expect_keys(const char *bytes, const Key *expected, const Key *keys, size_t count) {
  size_t expected_count = 0;
  while (expected[expected_count]) expected_count++;
  if (count != expected_count || memcmp(keys, expected, count * sizeof *keys) != 0) {
    char text[200] = "";
    for (size_t i = 0; i < count; i++)
      snprintf(text + strlen(text), sizeof text - strlen(text), " %x", (unsigned)keys[i]);
    fail_msg("'%s' gave %zu keys:%s", bytes, count, text);
  }
}

static void sequences_are_keys(void **state) {
  (void)state;
  for (size_t s = 0; s < SEQUENCES; s++) {
    KeyDecoder decoder = {0};
    Key keys[100];
    size_t count = 0;
    for (const char *byte = sequences[s].bytes; *byte; byte++) {
      count += key_decoder_feed(&decoder, (unsigned char)*byte, keys + count);
    }
    assert_false(key_decoder_waits(&decoder));
    expect_keys(sequences[s].bytes, sequences[s].keys, keys, count);
  }
}

/* All sequences one behind the other, as a slow reader finds them. */
static void batches_are_their_keys(void **state) {
  (void)state;
  KeyDecoder decoder = {0};
  for (int times = 0; times < 2; times++) {
    for (size_t s = 0; s < SEQUENCES; s++) {
      Key keys[100];
      size_t count = 0;
      for (const char *byte = sequences[s].bytes; *byte; byte++)
        count += key_decoder_feed(&decoder, (unsigned char)*byte, keys + count);
      expect_keys(sequences[s].bytes, sequences[s].keys, keys, count);
    }
  }
}

static void expect_expired(const char *bytes, const Key *expected) {
  KeyDecoder decoder = {0};
  Key keys[100];
  size_t count = 0;
  for (const char *byte = bytes; *byte; byte++)
    count += key_decoder_feed(&decoder, (unsigned char)*byte, keys + count);
  assert_true(key_decoder_waits(&decoder));
  count += key_decoder_expire(&decoder, keys + count);
  assert_false(key_decoder_waits(&decoder));
  expect_keys(bytes, expected, keys, count);
}

static void time_tells_escape_from_a_sequence(void **state) {
  (void)state;
  expect_expired("\033", (Key[]){KEY_ESCAPE, 0});
  expect_expired("\033\033", (Key[]){KEY_ESCAPE, KEY_ESCAPE, 0});
  expect_expired("\033[", (Key[]){KEY_ESCAPE, '[', 0});
  expect_expired("\033O", (Key[]){KEY_ESCAPE, 'O', 0});
  expect_expired("\033[12", (Key[]){KEY_ESCAPE, '[', '1', '2', 0});
  expect_expired("a\xe2\x82", (Key[]){'a', UNKNOWN, UNKNOWN, 0});
}

/* Nothing that is sent can make the decoder wait for ever or overflow (sanitizers watch in dev). */
static void garbage_does_no_harm(void **state) {
  (void)state;
  uint64_t random = 88172645463325252u; /* xorshift64's seed */
  KeyDecoder decoder = {0};
  for (int i = 0; i < 200000; i++) {
    random ^= random << 13;
    random ^= random >> 7;
    random ^= random << 17;
    static const char likely[] = "\033\033\033[[[OO;0129~A\xc3\xe2\xf0\x80";
    const unsigned char byte = random & 1
                                 ? (unsigned char)likely[(random >> 8) % (sizeof likely - 1)]
                                 : (unsigned char)(random >> 16);
    Key keys[KEYS_AT_ONCE];
    assert_true(key_decoder_feed(&decoder, byte, keys) <= KEYS_AT_ONCE);
    assert_true(decoder.count < KEY_LONGEST_SEQUENCE);
  }
}

static void endless_sequences_end(void **state) {
  (void)state;
  KeyDecoder decoder = {0};
  Key keys[KEYS_AT_ONCE];
  size_t count = key_decoder_feed(&decoder, '\033', keys) + key_decoder_feed(&decoder, '[', keys);
  for (size_t i = 2; i < KEY_LONGEST_SEQUENCE; i++) count += key_decoder_feed(&decoder, '1', keys);
  assert_int_equal(count, 1);
  assert_int_equal(keys[0], UNKNOWN);
  assert_false(key_decoder_waits(&decoder));
}

static void names_go_both_ways(void **state) {
  (void)state;
  const Key keys[] = {'a',     ' ',           ';',     '=',     '[',         ']',
                      '#',     ':',           KEY_TAB, KEY_F1,  KEY_F1 + 11, KEY_PAGE_DOWN,
                      KEY_END, KEY_CTRL('a'), 0xe9,    0x1f941, KEY_ENTER,   KEY_ESCAPE};
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
    char name[KEY_NAME_SIZE];
    assert_int_equal(key_from_name(key_name(keys[i], name)), keys[i]);
  }
  char name[KEY_NAME_SIZE];
  assert_string_equal(key_name(' ', name), "space");
  assert_string_equal(key_name(KEY_F1 + 11, name), "f12");
  assert_string_equal(key_name(0xe9, name), "\xc3\xa9");
  assert_string_equal(key_name(KEY_UNKNOWN, name), "unknown");
}

static void what_is_no_name_is_no_key(void **state) {
  (void)state;
  const char *const names[] = {"",      "aa",      "f0",   "f13",    "f01",  "f1x",
                               "ctrl-", "ctrl-aa", "Up",   "space ", "\xff", "ctrl-\xc3",
                               " ",     "\x7f",    "\x01", "unknown"};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    if (key_from_name(names[i]) != KEY_UNKNOWN) fail_msg("'%s' is a key", names[i]);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(sequences_are_keys),
    cmocka_unit_test(batches_are_their_keys),
    cmocka_unit_test(time_tells_escape_from_a_sequence),
    cmocka_unit_test(garbage_does_no_harm),
    cmocka_unit_test(endless_sequences_end),
    cmocka_unit_test(names_go_both_ways),
    cmocka_unit_test(what_is_no_name_is_no_key),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
