/* SPDX-License-Identifier: MIT */
#include "ui/command_words.h"

#include <string.h>

#include "base/suggest.h"

static const struct {
  const char *word;
  const char *usage; /* what has to follow; NULL: nothing may */
} commands[COMMAND_WORDS] = {
  [COMMAND_SET] = {"set", "KEY VALUE"},
  [COMMAND_LEARN] = {"learn", "KEY"},
  [COMMAND_UNDO] = {"undo", NULL},
  [COMMAND_REDO] = {"redo", NULL},
  [COMMAND_SAVE] = {"save", "NAME"},
  [COMMAND_REPLACE] = {"save!", "NAME"},
  [COMMAND_DRUM] = {"drum", "NAME"},
  [COMMAND_PRESET] = {"preset", "NAME"},
  [COMMAND_GAIN] = {"gain", "DB"},
  [COMMAND_SPEED] = {"speed", "M/S"},
  [COMMAND_HUMANIZE] = {"humanize", "AMOUNT"},
  [COMMAND_SILENCE] = {"silence", NULL},
  [COMMAND_HELP] = {"help", NULL},
  [COMMAND_QUIT] = {"quit", NULL},
};

const char *command_word_at(const void *list, size_t index) {
  (void)list;
  return index < COMMAND_WORDS ? commands[index].word : NULL;
}

/* COMMAND_WORDS if it is none. */
static CommandWord find(const char *word, size_t length) {
  if (length == 1 && *word == 'q') return COMMAND_QUIT;
  for (CommandWord i = 0; i < COMMAND_WORDS; i++) {
    if (strlen(commands[i].word) == length && memcmp(commands[i].word, word, length) == 0) return i;
  }
  return COMMAND_WORDS;
}

static Outcome refuse_word(const char *word, size_t length) {
  char name[32] = "", hint[200];
  if (length < sizeof name) memcpy(name, word, length);
  suggest_choice(hint, sizeof hint, name, "", command_word_at, NULL);
  return refuse("unknown command '%.*s'%s", (int)(length < 80 ? length : 80), word, hint);
}

Outcome command_words_read(const char *text, CommandWord *command, const char **rest) {
  const size_t length = strcspn(text, " ");
  *rest = text + length + strspn(text + length, " ");
  *command = find(text, length);
  if (*command == COMMAND_WORDS) return refuse_word(text, length);
  const char *const word = commands[*command].word, *const usage = commands[*command].usage;
  if (!**rest && usage) return refuse("%s needs more: %s %s", word, word, usage);
  if (**rest && !usage) return refuse("nothing may follow '%s'", word);
  return OUTCOME_OK;
}
