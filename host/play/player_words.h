/* SPDX-License-Identifier: MIT */
/**
 * @file player_words.h
 * Parameters in the words of the plugins' controls (plugin/knobs.h), for what is typed and shown
 * while playing.
 */
#ifndef TABOR_PLAY_PLAYER_WORDS_H
#define TABOR_PLAY_PLAYER_WORDS_H

#include <stddef.h>
#include <tabor/tabor.h>

#define PLAYER_WORD_SIZE 32

/**
 * Writes the control's name and its value in @p def, " (Batter head muffling 50 %)", to @p text; of
 * a tension, the pitch that it gives. "" if @p key has no control, or one that shows the plain
 * number.
 */
void player_words_write(const TaborDrumDef *def, const char *key, char *text, size_t size);
/**
 * Returns the value for @p key that @p text means as the control's, "50 %", "open" or "A3 +12 ct",
 * or with a unit of its own, "140 mm", "6 in", "11 g" (plugin/key_text.h), written to @p room; or
 * @p text itself, which the engine reads or refuses.
 */
const char *player_words_read(const TaborDrumDef *def, const char *key, const char *text,
                              char room[PLAYER_WORD_SIZE]);

#endif
