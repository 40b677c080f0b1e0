/* SPDX-License-Identifier: MIT */
/**
 * @file command_words.h
 * The commands for typing or for a key while a drum is played, such as "set KEY VALUE".
 */
#ifndef TABOR_HOST_COMMAND_WORDS_H
#define TABOR_HOST_COMMAND_WORDS_H

#include <stddef.h>

#include "base/message.h"

typedef enum CommandWord {
  COMMAND_SET,
  COMMAND_LEARN,
  COMMAND_UNDO,
  COMMAND_REDO,
  COMMAND_SAVE,
  COMMAND_REPLACE,
  COMMAND_DRUM,
  COMMAND_PRESET,
  COMMAND_GAIN,
  COMMAND_SPEED,
  COMMAND_HUMANIZE,
  COMMAND_SILENCE,
  COMMAND_HELP,
  COMMAND_QUIT,
  COMMAND_WORDS
} CommandWord;

/** The word of command @p index, a NameAt; NULL past the last. @p list is ignored. */
const char *command_word_at(const void *list, size_t index);
/**
 * Finds the command in @p text and the text after its word. Refuses an unknown word, with the
 * nearest command; a missing argument; and an argument that the command does not take.
 */
Outcome command_words_read(const char *text, CommandWord *command, const char **rest);

#endif
