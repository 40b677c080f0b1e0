/* SPDX-License-Identifier: MIT */
/**
 * @file keys.h
 * Decodes a terminal's bytes into keys.
 *
 * A key is a character's code point, or a constant below. Characters come as UTF-8. Other keys come
 * as sequences of bytes that start with Escape (ECMA-48, and the sequences of xterm and the Linux
 * console). Bytes come in pieces of any size. Only a pause tells the Escape key from the start of a
 * sequence.
 */
#ifndef TABOR_HOST_KEYS_H
#define TABOR_HOST_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef uint32_t Key;

/** Keys that are not characters. Ctrl with a letter is the control character, 1 to 26. */
enum {
  KEY_UNKNOWN = 0x110000, /**< an unknown sequence, or a byte that is not UTF-8 */
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

/** The key for Ctrl with a lower-case letter; Ctrl-I is Tab. */
#define KEY_CTRL(letter) ((Key)((letter) - 'a' + 1))
#define KEY_TAB KEY_CTRL('i')

/** Bytes of a key name with its terminator: "page-down", "left-bracket". */
#define KEY_NAME_SIZE 16
/** Time that an Escape waits for the rest of a sequence [ms]: longer than a connection takes to
 * deliver it. */
#define KEY_PATIENCE 40

#define KEY_LONGEST_SEQUENCE 32 /**< bytes; longer sequences are no key */

/** Bytes of an incomplete key. Initialise with {0}. */
typedef struct KeyDecoder {
  unsigned char bytes[KEY_LONGEST_SEQUENCE];
  size_t count;
} KeyDecoder;

/** Most keys that one byte can complete. */
#define KEYS_AT_ONCE KEY_LONGEST_SEQUENCE

/** Takes a byte; returns the number of completed @p keys. */
size_t key_decoder_feed(KeyDecoder *decoder, unsigned char byte, Key keys[KEYS_AT_ONCE]);
/** True while an incomplete key waits for more bytes. */
bool key_decoder_waits(const KeyDecoder *decoder);
/** Call after KEY_PATIENCE without a byte: turns the waiting bytes into @p keys; returns their
 * number. */
size_t key_decoder_expire(KeyDecoder *decoder, Key keys[KEYS_AT_ONCE]);

/** Number of bytes of the UTF-8 character at the terminated @p text, and its code point; 0 if
 * invalid. */
size_t utf8_read(const char *text, uint32_t *point);
/** Writes a code point as UTF-8, up to 4 bytes; returns their number. */
size_t utf8_write(uint32_t point, char *bytes);

/** Name of a key: the character itself, "space", "semicolon", "f1", "ctrl-a". Returns @p name. */
const char *key_name(Key key, char name[KEY_NAME_SIZE]);
/** The key with this name; KEY_UNKNOWN if there is none. */
Key key_from_name(const char *name);

#endif
