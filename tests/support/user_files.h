/* SPDX-License-Identifier: MIT */
/**
 * @file user_files.h
 * A folder of the user's own drums and kits, which the process takes for that of its user:
 * drum.ini, a drum that calls itself "mine"; kit.ini, a kit of two toms and a closed hi-hat, the
 * sound file hat.wav, that calls itself "my-kit"; else.ini, which is neither.
 */
#ifndef TABOR_TESTS_USER_FILES_H
#define TABOR_TESTS_USER_FILES_H

/** A cmocka set-up: makes the folder. */
int user_files_make(void **state);
/** A cmocka teardown: removes it. */
int user_files_remove(void **state);
/** The path of the file @p name, until the next call. */
const char *user_file(const char *name);
/** The folder of all of the user's data. */
const char *user_data(void);
void user_file_write(const char *name, const char *text);

#endif
