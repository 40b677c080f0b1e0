/* SPDX-License-Identifier: MIT */
/**
 * @file command_words.h
 * The commands that may be typed, or bound to a key, while a drum is played: "set KEY VALUE" and the like.
 */
#ifndef TABOR_HOST_COMMAND_WORDS_H
#define TABOR_HOST_COMMAND_WORDS_H

#include <stddef.h>

#include "base/message.h"

typedef enum CommandWord {
  COMMAND_SET,
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
 * Which command @p text is, and what follows its word. Refuses words that are none, with the nearest, commands that
 * lack what has to follow, and those that nothing may follow.
 */
Outcome command_words_read(const char *text, CommandWord *command, const char **rest);

#endif
