/* SPDX-License-Identifier: MIT */
/**
 * @file user_sounds.h
 * What the files of the user's folder (drums/user_presets.h) are: drums or kits, and what they say
 * of themselves.
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_KIT_USER_SOUNDS_H
#define TABOR_KIT_USER_SOUNDS_H

#include <tabor/kit.h>

typedef struct UserSound {
  bool is_kit;
  char name[TABOR_NAME_SIZE];     /**< as it calls itself, which may not be its file's */
  char category[TABOR_NAME_SIZE]; /**< "kit" of a kit */
  char comment[TABOR_TEXT_SIZE];
} UserSound;

/** Reads a file. False, with a line in @p message, if it is neither a drum nor a kit. */
bool user_sound_read(const char *path, UserSound *sound, char *message, size_t size);
/** Tells @p visit of each drum, or kit, of the folder: by the name of its file without extension,
 * in no order. */
void user_sounds_visit(bool kits,
                       void (*visit)(void *context, const char *file, const UserSound *sound),
                       void *context);

#endif
