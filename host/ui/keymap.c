/* SPDX-License-Identifier: MIT */
#include "ui/keymap.h"

#include <stdio.h>
#include <string.h>

#include "base/number.h"
#include "base/suggest.h"
#include "drums/preset_file.h"
#include "ui/command_words.h"

/* ---- the map ---- */

static KeyBinding *find_binding(Keymap *keymap, Key key) {
  for (size_t i = 0; i < keymap->count; i++) {
    if (keymap->bindings[i].key == key) return &keymap->bindings[i];
  }
  return NULL;
}

/* Changes what a key does; false if there are too many. */
static bool bind(Keymap *keymap, const KeyBinding *binding) {
  KeyBinding *place = find_binding(keymap, binding->key);
  if (!place && keymap->count == MOST_KEYS) return false;
  if (!place) place = &keymap->bindings[keymap->count++];
  *place = *binding;
  return true;
}

static void bind_plain(Keymap *keymap, Key key, ActionKind kind, double value) {
  (void)bind(keymap, &(KeyBinding){.key = key, .kind = kind, .value = value});
}

static void bind_technique(Keymap *keymap, Key key, const char *technique) {
  KeyBinding binding = {.key = key, .kind = ACTION_TECHNIQUE};
  (void)snprintf(binding.text, sizeof binding.text, "%s", technique);
  (void)bind(keymap, &binding);
}

/* Rows of a keyboard from the centre to nearly the rim; what is left of a row plays the outermost
 * zone. */
static void bind_zones(Keymap *keymap, const char *row, ActionKind kind) {
  static const double outermost = 0.92; /* a stick that hits closer to the rim hits the rim */
  static const size_t zones = 9;
  for (size_t i = 0; row[i]; i++) {
    const size_t zone = i < zones ? i : zones - 1;
    bind_plain(keymap, (Key)row[i], kind, outermost * (double)zone / (double)(zones - 1));
  }
}

/* Nine speeds from 0.5 to 8 m/s, each the square root of 2 times the one before. */
static void bind_speeds(Keymap *keymap) {
  static const double speeds[] = {0.5, 0.71, 1, 1.41, 2, 2.83, 4, 5.66, 8};
  for (Key i = 0; i < 9; i++) bind_plain(keymap, '1' + i, ACTION_SPEED, speeds[i]);
}

void keymap_default(Keymap *keymap) {
  keymap->count = 0;
  bind_zones(keymap, "asdfghjkl", ACTION_STROKE);
  bind_zones(keymap, "qwertyuiop", ACTION_GHOST);
  bind_plain(keymap, ' ', ACTION_REPEAT, 0);
  bind_speeds(keymap);
  bind_technique(keymap, 'z', "rimshot");
  bind_technique(keymap, 'x', "cross-stick");
  bind_technique(keymap, 'c', "rim");
  bind_technique(keymap, 'v', "buzz");
  bind_technique(keymap, 'm', "sweep");
  bind_plain(keymap, 'b', ACTION_SNARES, 0);
  bind_plain(keymap, 'n', ACTION_MUFFLE, 0);
  bind_plain(keymap, '[', ACTION_PRESET, -1);
  bind_plain(keymap, ']', ACTION_PRESET, 1);
  bind_plain(keymap, ',', ACTION_DRUM, -1);
  bind_plain(keymap, '.', ACTION_DRUM, 1);
  bind_plain(keymap, '-', ACTION_GAIN, -1);
  bind_plain(keymap, '+', ACTION_GAIN, 1);
  bind_plain(keymap, '=', ACTION_GAIN, 1); /* where '+' needs the shift key */
  bind_plain(keymap, ':', ACTION_COMMAND, 0);
  bind_plain(keymap, '?', ACTION_HELP, 0);
  bind_plain(keymap, KEY_CTRL('c'), ACTION_QUIT, 0); /* where it does not come as a signal */
}

Action keymap_find(const Keymap *keymap, Key key) {
  for (size_t i = 0; i < keymap->count; i++) {
    const KeyBinding *const binding = &keymap->bindings[i];
    if (binding->key == key) return (Action){binding->kind, binding->value, binding->text};
  }
  return (Action){ACTION_NONE, 0, ""};
}

/* For people: ';' rather than "semicolon", which files need. */
static const char *key_label(Key key, char label[KEY_NAME_SIZE]) {
  if (key <= ' ' || key >= KEY_UNKNOWN) return key_name(key, label);
  label[utf8_write(key, label)] = '\0';
  return label;
}

size_t keymap_list(const Keymap *keymap, ActionKind kind, char *text, size_t size) {
  size_t count = 0, length = 0;
  if (size > 0) text[0] = '\0';
  for (size_t i = 0; i < keymap->count; i++) {
    if (keymap->bindings[i].kind != kind) continue;
    char name[KEY_NAME_SIZE];
    const int written = snprintf(text + length, size - length, "%s%s", count ? " " : "",
                                 key_label(keymap->bindings[i].key, name));
    count++;
    if (written > 0) length += (size_t)written;
    if (length >= size) length = size > 0 ? size - 1 : 0;
  }
  return count;
}

/* ---- the file ---- */

/* A line of the file. */
typedef struct Line {
  const char *key, *action; /* as they stand there */
  char *message;
  size_t size;
  KeyBinding binding;
} Line;

/* Reads what follows an action's word; writes what is wrong. */
typedef bool ArgumentReader(Line *line, const char *text);

static bool refuse_action(const Line *line, const char *what) {
  (void)snprintf(line->message, line->size, "'%s = %.60s': %s", line->key, line->action, what);
  return false;
}

static bool read_number(Line *line, const NumberField *field, const char *text) {
  char reason[TABOR_TEXT_SIZE];
  const MessageCapture before = message_capture(reason, sizeof reason);
  const Outcome outcome = number_read(field, text, &line->binding.value);
  message_release(before);
  return outcome == OUTCOME_OK || refuse_action(line, reason);
}

static bool read_nothing(Line *line, const char *text) {
  return *text == '\0' || refuse_action(line, "nothing may follow this action");
}

static bool read_technique(Line *line, const char *text) {
  (void)snprintf(line->binding.text, sizeof line->binding.text, "%s", line->action);
  return read_nothing(line, text);
}

static bool read_place(Line *line, const char *text) {
  static const NumberField field = {"place in per cent", 0, 100, false};
  char number[32];
  const size_t length = strlen(text);
  if (length < 2 || length >= sizeof number || text[length - 1] != '%') {
    return refuse_action(line, "its place is missing; allowed: 0% to 100% of the head's radius");
  }
  memcpy(number, text, length - 1);
  number[length - 1] = '\0';
  if (!read_number(line, &field, number)) return false;
  line->binding.value /= 100;
  return true;
}

static bool read_speed(Line *line, const char *text) {
  static const NumberField field = {"speed", 0.01, 30, false};
  return read_number(line, &field, text);
}

static bool read_gain(Line *line, const char *text) {
  static const NumberField field = {"gain", -24, 24, false};
  return read_number(line, &field, text);
}

static bool read_direction(Line *line, const char *text) {
  const bool next = strcmp(text, "next") == 0;
  line->binding.value = next ? 1 : -1;
  if (next || strcmp(text, "previous") == 0) return true;
  const char *const word = line->binding.kind == ACTION_DRUM ? "drum" : "preset";
  char allowed[120];
  (void)snprintf(allowed, sizeof allowed, "allowed: %s next, %s previous; ':%s NAME' for one drum",
                 word, word, word);
  return refuse_action(line, allowed);
}

static const struct ActionWord {
  const char *word;
  ActionKind kind;
  ArgumentReader *read;
} words[] = {
  {"none", ACTION_NONE, read_nothing},
  {"stroke", ACTION_STROKE, read_place},
  {"ghost", ACTION_GHOST, read_place},
  {"repeat", ACTION_REPEAT, read_nothing},
  {"rimshot", ACTION_TECHNIQUE, read_technique},
  {"cross-stick", ACTION_TECHNIQUE, read_technique},
  {"rim", ACTION_TECHNIQUE, read_technique},
  {"buzz", ACTION_TECHNIQUE, read_technique},
  {"sweep", ACTION_TECHNIQUE, read_technique},
  {"speed", ACTION_SPEED, read_speed},
  {"snares", ACTION_SNARES, read_nothing},
  {"muffle", ACTION_MUFFLE, read_nothing},
  {"preset", ACTION_PRESET, read_direction},
  {"drum", ACTION_DRUM, read_direction},
  {"gain", ACTION_GAIN, read_gain},
  {"command", ACTION_COMMAND, read_nothing},
  {"help", ACTION_HELP, read_nothing},
  {"quit", ACTION_QUIT, read_nothing},
};
#define WORDS (sizeof words / sizeof words[0])

static const char *word_at(const void *list, size_t index) {
  (void)list;
  return index < WORDS ? words[index].word : NULL;
}

static bool read_command(Line *line) {
  line->binding.kind = ACTION_RUN;
  const char *text = line->action + 1, *rest;
  CommandWord command;
  char reason[TABOR_TEXT_SIZE];
  (void)snprintf(line->binding.text, sizeof line->binding.text, "%s", text);
  text += strspn(text, " ");
  if (*text == '\0') return refuse_action(line, "no command follows the ':'");
  const MessageCapture before = message_capture(reason, sizeof reason);
  const Outcome outcome = command_words_read(text, &command, &rest);
  message_release(before);
  return outcome == OUTCOME_OK || refuse_action(line, reason);
}

static bool read_action(Line *line) {
  const size_t length = strcspn(line->action, " \t");
  const char *const rest = line->action + length + strspn(line->action + length, " \t");
  if (line->action[0] == ':') return read_command(line);
  for (size_t i = 0; i < WORDS; i++) {
    if (strlen(words[i].word) != length || memcmp(words[i].word, line->action, length) != 0)
      continue;
    line->binding.kind = words[i].kind;
    return words[i].read(line, rest);
  }
  char word[24] = "", hint[200], reason[240];
  if (length < sizeof word) memcpy(word, line->action, length);
  suggest_choice(hint, sizeof hint, word, "", word_at, NULL);
  (void)snprintf(reason, sizeof reason, "unknown action%s", hint);
  return refuse_action(line, reason);
}

static bool read_key(Line *line) {
  line->binding.key = key_from_name(line->key);
  const bool quits = line->binding.key == KEY_ESCAPE || line->binding.key == KEY_CTRL('c');
  if (quits) {
    (void)snprintf(line->message, line->size, "'%s' always quits", line->key);
    return false;
  }
  if (line->binding.key != KEY_UNKNOWN) return true;
  (void)snprintf(line->message, line->size,
                 "unknown key '%s'; allowed: a character, space, enter, tab, up, page-down, f1, "
                 "ctrl-a, semicolon, left-bracket and their like",
                 line->key);
  return false;
}

/* A TaborTextTake. */
static TaborStatus take_line(void *context, const TaborTextLine *text, TaborError *error) {
  Keymap *const keymap = context;
  Line line = {.key = text->key,
               .action = text->value,
               .message = error->message,
               .size = sizeof error->message};
  if (strcmp(text->section, "keys") != 0) {
    (void)snprintf(line.message, line.size, "unknown section [%s]; allowed: [keys]", text->section);
    return TABOR_ERROR_KEY;
  }
  if (!text->key) return TABOR_OK;
  if (!read_key(&line) || !read_action(&line)) return TABOR_ERROR_VALUE;
  if (bind(keymap, &line.binding)) return TABOR_OK;
  (void)snprintf(line.message, line.size, "too many keys; allowed: up to %d", MOST_KEYS);
  return TABOR_ERROR_FULL;
}

Outcome keymap_read(const char *path, Keymap *keymap) {
  char message[2 * TABOR_TEXT_SIZE];
  switch (preset_file_read(path, take_line, keymap, message, sizeof message)) {
  case PRESET_FILE_OK: return OUTCOME_OK;
  case PRESET_FILE_UNREADABLE: return fail("--keys: %s", message);
  case PRESET_FILE_INVALID: break;
  }
  return refuse("--keys: %s", message);
}
