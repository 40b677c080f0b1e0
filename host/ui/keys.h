/* SPDX-License-Identifier: MIT */
/**
 * @file keys.h
 * Which keys a terminal's bytes stand for.
 *
 * A key is a character's code point, or one of those below. Characters come as UTF-8, other keys as sequences
 * of bytes that begin with Escape (ECMA-48, and what xterm and the Linux console send). Bytes come in
 * pieces of any size; only time tells the Escape key from the beginning of a sequence.
 */
#ifndef TABOR_HOST_KEYS_H
#define TABOR_HOST_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef uint32_t Key;

/** Keys that are no characters. Ctrl with a letter is the control character, 1 to 26. */
enum {
  KEY_UNKNOWN = 0x110000, /**< a sequence that stands for none of these; a byte that is no UTF-8 */
  KEY_ESCAPE,
  KEY_ENTER,
  KEY_BACKSPACE,
  KEY_INSERT,
  KEY_DELETE,
  KEY_UP,
  KEY_DOWN,
  KEY_LEFT,
  KEY_RIGHT,
  KEY_HOME,
  KEY_END,
  KEY_PAGE_UP,
  KEY_PAGE_DOWN,
  KEY_F1 /**< up to KEY_F1 + 11 for F12 */
};

/** The key that Ctrl makes of a lower-case letter; Ctrl-I is Tab. */
#define KEY_CTRL(letter) ((Key)((letter) - 'a' + 1))
#define KEY_TAB KEY_CTRL('i')

/** Bytes of a key name with its terminator: "page-down", "left-bracket". */
#define KEY_NAME_SIZE 16
/** How long an Escape waits for the rest of a sequence [ms]: longer than links take to deliver it. */
#define KEY_PATIENCE 40

#define KEY_LONGEST_SEQUENCE 32 /**< bytes; longer ones stand for no key */

/** Bytes that do not make up a key yet. Begins as {0}. */
typedef struct KeyDecoder {
  unsigned char bytes[KEY_LONGEST_SEQUENCE];
  size_t count;
} KeyDecoder;

/** Keys that one byte can complete at most. */
#define KEYS_AT_ONCE KEY_LONGEST_SEQUENCE

/** Takes a byte; returns the number of @p keys that it completed. */
size_t key_decoder_feed(KeyDecoder *decoder, unsigned char byte, Key keys[KEYS_AT_ONCE]);
/** True while there are bytes that wait for more. */
bool key_decoder_waits(const KeyDecoder *decoder);
/** Nothing has followed within KEY_PATIENCE: returns the number of @p keys that the bytes are by themselves. */
size_t key_decoder_expire(KeyDecoder *decoder, Key keys[KEYS_AT_ONCE]);

/** Bytes of the valid UTF-8 character at the terminated @p text, and its code point; 0 if there is none. */
size_t utf8_read(const char *text, uint32_t *point);
/** Writes a code point as UTF-8, up to 4 bytes; returns how many. */
size_t utf8_write(uint32_t point, char *bytes);

/** What a key is called: the character itself, "space", "semicolon", "f1", "ctrl-a". Returns @p name. */
const char *key_name(Key key, char name[KEY_NAME_SIZE]);
/** The key of this name; KEY_UNKNOWN if there is none. */
Key key_from_name(const char *name);

#endif
