/* SPDX-License-Identifier: MIT */
/**
 * @file library_sums.h
 * Checksums of a library's sounds, tabor-library.sums beside the manifest: a line "SUM  FILE" for
 * each sound that is finished. SUM is the FNV-1a hash of the file's bytes, 64 bits in hexadecimal
 * digits. A resumed run keeps a sound only if its bytes still have their checksum.
 *
 * Lines are added as sounds are finished, so a killed run leaves them. At the end they are in the
 * order of the plan.
 */
#ifndef TABOR_HOST_LIBRARY_SUMS_H
#define TABOR_HOST_LIBRARY_SUMS_H

#include <stdbool.h>

#include "library/library_request.h"
#include "render/render_batch.h"

#define LIBRARY_SUMS "tabor-library.sums"

typedef struct LibrarySum {
  bool is_known;
  uint64_t sum;
} LibrarySum;

typedef struct LibrarySums {
  const LibraryRequest *request;
  char *path;
  LibrarySum *of; /**< of each sound of the plan */
  int descriptor; /**< to add lines, or -1 */
} LibrarySums;

/** Reads the checksums of former runs; lines that mean nothing are passed over. Free with
 * library_sums_free(), whatever the outcome. */
Outcome library_sums_read(const LibraryRequest *request, LibrarySums *sums);
void library_sums_free(LibrarySums *sums);
/** True if the bytes of the file @p path are those of sound @p index; otherwise forgets its
 * checksum. Prints a note if they have changed. */
bool library_sums_keep(LibrarySums *sums, size_t index, const char *path);
/** Prepares for library_sums_add(). */
Outcome library_sums_begin(LibrarySums *sums);
/** Adds the checksum of a sound that has been rendered. Any thread, one at a time. @p context: the
 * sums. */
Outcome library_sums_add(void *context, const RenderJob *job);
/** Writes all checksums in the order of the plan, unless the file has them. */
Outcome library_sums_end(LibrarySums *sums);

#endif
