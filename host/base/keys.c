/* SPDX-License-Identifier: MIT */
#include "base/keys.h"

#include <stdio.h>
#include <string.h>

#define ESCAPE 0x1b

/* ---- UTF-8 ---- */

static bool is_continuation(unsigned char byte) { return (byte & 0xC0u) == 0x80u; }

/* Bytes that a character with this first byte has; 0 if none begins with it. */
static size_t utf8_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

/* Neither written longer than needed, nor a surrogate, nor beyond the last. */
static bool is_shortest(uint32_t point, size_t length) {
  static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = point >= 0xD800 && point <= 0xDFFF;
  return point >= least[length] && !is_surrogate && point <= 0x10FFFF;
}

size_t utf8_read(const char *text, uint32_t *point) {
  const unsigned char *const bytes = (const unsigned char *)text;
  const size_t length = utf8_length(bytes[0]);
  if (length == 0) return 0;
  *point = length == 1 ? bytes[0] : bytes[0] & (0x7Fu >> length);
  for (size_t i = 1; i < length; i++) {
    if (!is_continuation(bytes[i])) return 0;
    *point = *point << 6 | (bytes[i] & 0x3Fu);
  }
  return is_shortest(*point, length) ? length : 0;
}

size_t utf8_write(uint32_t point, char *bytes) {
  if (point < 0x80) {
    bytes[0] = (char)point;
    return 1;
  }
  const size_t length = point < 0x800 ? 2 : point < 0x10000 ? 3 : 4;
  for (size_t i = length - 1; i > 0; i--) {
    bytes[i] = (char)(0x80u | (point & 0x3Fu));
    point >>= 6;
  }
  bytes[0] = (char)((0xF00u >> length & 0xFFu) | point);
  return length;
}

/* ---- sequences ---- */

/* What the first bytes are: a key of so many bytes, or with 0 bytes the beginning of one. */
typedef struct Found {
  size_t bytes;
  Key key;
} Found;

static const Found incomplete = {0, KEY_UNKNOWN};

/* ESC [ A and ESC O A, on their own or with modifiers. */
static Key letter_key(unsigned char letter) {
  switch (letter) {
  case 'A': return KEY_UP;
  case 'B': return KEY_DOWN;
  case 'C': return KEY_RIGHT;
  case 'D': return KEY_LEFT;
  case 'F': return KEY_END;
  case 'H': return KEY_HOME;
  case 'M': return KEY_ENTER; /* of the keypad */
  case 'P':
  case 'Q':
  case 'R':
  case 'S': return KEY_F1 + (Key)(letter - 'P');
  default: return KEY_UNKNOWN;
  }
}

/* ESC [ 3 ~ */
static Key number_key(unsigned number) {
  static const Key editing[] = {KEY_UNKNOWN, KEY_HOME,      KEY_INSERT, KEY_DELETE, KEY_END,
                                KEY_PAGE_UP, KEY_PAGE_DOWN, KEY_HOME,   KEY_END};
  if (number < sizeof editing / sizeof editing[0]) return editing[number];
  if (number >= 11 && number <= 15) return KEY_F1 + number - 11;
  if (number >= 17 && number <= 21) return KEY_F1 + number - 12;
  if (number == 23 || number == 24) return KEY_F1 + number - 13;
  return KEY_UNKNOWN;
}

static unsigned read_number(const unsigned char *bytes) {
  unsigned number = 0;
  for (; *bytes >= '0' && *bytes <= '9' && number < 1000; bytes++)
    number = 10 * number + (*bytes - '0');
  return number;
}

/* ESC [ parameters letter. */
static Found find_control_sequence(const unsigned char *bytes, size_t count) {
  size_t end = 2;
  if (count > 2 && bytes[2] == '[') { /* the Linux console's F1 to F5: ESC [ [ A */
    if (count < 4) return incomplete;
    const bool is_function = bytes[3] >= 'A' && bytes[3] <= 'E';
    return (Found){4, is_function ? KEY_F1 + (Key)(bytes[3] - 'A') : KEY_UNKNOWN};
  }
  while (end < count && bytes[end] >= 0x20 && bytes[end] <= 0x3f) end++;
  if (end == count) return count < KEY_LONGEST_SEQUENCE ? incomplete : (Found){count, KEY_UNKNOWN};
  const unsigned char final = bytes[end];
  if (final < 0x40 || final > 0x7e) return (Found){end, KEY_UNKNOWN}; /* cut off by another */
  return (Found){end + 1, final == '~' ? number_key(read_number(bytes + 2)) : letter_key(final)};
}

static Found find_after_escape(const unsigned char *bytes, size_t count) {
  const Found alone = {1, KEY_ESCAPE};
  if (count < 2) return incomplete;
  if (bytes[1] == '[') return find_control_sequence(bytes, count);
  if (bytes[1] != 'O') return alone; /* two keys, the second perhaps with Alt */
  if (count < 3) return incomplete;
  const Key key = letter_key(bytes[2]);
  return key == KEY_UNKNOWN ? alone : (Found){3, key};
}

static Found find_character(const unsigned char *bytes, size_t count) {
  char text[5] = "";
  uint32_t point = 0;
  const size_t length = utf8_length(bytes[0]), seen = count < length ? count : length;
  if (length == 0) return (Found){1, KEY_UNKNOWN};
  for (size_t i = 1; i < seen; i++) {
    if (!is_continuation(bytes[i])) return (Found){i, KEY_UNKNOWN};
  }
  if (count < length) return incomplete;
  memcpy(text, bytes, length);
  return (Found){length, utf8_read(text, &point) ? point : KEY_UNKNOWN};
}

static Found find(const unsigned char *bytes, size_t count) {
  switch (bytes[0]) {
  case ESCAPE: return find_after_escape(bytes, count);
  case '\r':
  case '\n': return (Found){1, KEY_ENTER};
  case '\b':
  case 0x7f: return (Found){1, KEY_BACKSPACE};
  default: return find_character(bytes, count);
  }
}

static void drop(KeyDecoder *decoder, size_t count) {
  decoder->count -= count;
  memmove(decoder->bytes, decoder->bytes + count, decoder->count);
}

static size_t take_complete(KeyDecoder *decoder, Key keys[KEYS_AT_ONCE]) {
  size_t keys_found = 0;
  while (decoder->count > 0) {
    const Found found = find(decoder->bytes, decoder->count);
    if (found.bytes == 0) break;
    keys[keys_found++] = found.key;
    drop(decoder, found.bytes);
  }
  return keys_found;
}

size_t key_decoder_feed(KeyDecoder *decoder, unsigned char byte, Key keys[KEYS_AT_ONCE]) {
  decoder->bytes[decoder->count++] = byte; /* there is room: 32 bytes are never incomplete */
  return take_complete(decoder, keys);
}

bool key_decoder_waits(const KeyDecoder *decoder) { return decoder->count > 0; }

size_t key_decoder_expire(KeyDecoder *decoder, Key keys[KEYS_AT_ONCE]) {
  size_t count = 0;
  while (decoder->count > 0) {
    keys[count++] = decoder->bytes[0] == ESCAPE ? KEY_ESCAPE : KEY_UNKNOWN;
    drop(decoder, 1);
    count += take_complete(decoder, keys + count);
  }
  return count;
}

/* ---- names ---- */

/* Of keys whose character cannot be written, or means something else, in a file of keys. */
static const struct {
  const char *name;
  Key key;
} named[] = {
  {"escape", KEY_ESCAPE},
  {"enter", KEY_ENTER},
  {"backspace", KEY_BACKSPACE},
  {"insert", KEY_INSERT},
  {"delete", KEY_DELETE},
  {"up", KEY_UP},
  {"down", KEY_DOWN},
  {"left", KEY_LEFT},
  {"right", KEY_RIGHT},
  {"home", KEY_HOME},
  {"end", KEY_END},
  {"page-up", KEY_PAGE_UP},
  {"page-down", KEY_PAGE_DOWN},
  {"tab", KEY_TAB},
  {"space", ' '},
  {"semicolon", ';'},
  {"colon", ':'},
  {"equals", '='},
  {"hash", '#'},
  {"left-bracket", '['},
  {"right-bracket", ']'},
};
#define NAMED (sizeof named / sizeof named[0])

const char *key_name(Key key, char name[KEY_NAME_SIZE]) {
  for (size_t i = 0; i < NAMED; i++) {
    if (named[i].key == key) return strcpy(name, named[i].name);
  }
  if (key >= KEY_F1 && key < KEY_F1 + 12) {
    (void)snprintf(name, KEY_NAME_SIZE, "f%u", (unsigned)(key - KEY_F1 + 1));
  } else if (key >= 1 && key <= 26) {
    (void)snprintf(name, KEY_NAME_SIZE, "ctrl-%c", (char)('a' + key - 1));
  } else if (key < KEY_UNKNOWN) {
    name[utf8_write(key, name)] = '\0';
  } else {
    (void)snprintf(name, KEY_NAME_SIZE, "unknown");
  }
  return name;
}

static Key function_key(const char *digits) {
  const unsigned number = read_number((const unsigned char *)digits);
  char again[KEY_NAME_SIZE];
  if (number < 1 || number > 12) return KEY_UNKNOWN;
  const Key key = KEY_F1 + number - 1;
  return strcmp(key_name(key, again) + 1, digits) == 0 ? key : KEY_UNKNOWN;
}

Key key_from_name(const char *name) {
  uint32_t point = 0;
  if (!*name) return KEY_UNKNOWN;
  const size_t length = utf8_read(name, &point);
  if (length > 0 && name[length] == '\0' && point > ' ' && point != 0x7f) return point;
  for (size_t i = 0; i < NAMED; i++) {
    if (strcmp(named[i].name, name) == 0) return named[i].key;
  }
  const bool is_control = strncmp(name, "ctrl-", 5) == 0 && name[5] >= 'a' && name[5] <= 'z';
  if (is_control && name[6] == '\0') return KEY_CTRL(name[5]);
  return name[0] == 'f' ? function_key(name + 1) : KEY_UNKNOWN;
}
