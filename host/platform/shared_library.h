/* SPDX-License-Identifier: MIT */
/**
 * @file shared_library.h
 * Libraries of the system that need not be there.
 */
#ifndef TABOR_HOST_SHARED_LIBRARY_H
#define TABOR_HOST_SHARED_LIBRARY_H

/** Loads the library of a file, or of a name that the system knows. NULL if there is none. */
void *shared_library_open(const char *name);
/** Loads libsndfile, NULL if the system has none. */
void *shared_library_sndfile(void);
/** Copies the address of a function, named @p name, to *function; leaves NULL there if there is
 * none. */
void shared_library_find(void *library, const char *name, void *function);
void shared_library_close(void *library);

#endif
