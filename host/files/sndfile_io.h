/* SPDX-License-Identifier: MIT */
/**
 * @file sndfile_io.h
 * File access for libsndfile that remembers the first error. libsndfile itself forgets some: a
 * header that could not be written at the end goes unnoticed by sf_close(), and such a file may
 * even be read back without complaint, because readers guess what the header lacks.
 */
#ifndef TABOR_HOST_SNDFILE_IO_H
#define TABOR_HOST_SNDFILE_IO_H

#include <sndfile.h>

typedef struct SndfileIo {
  int descriptor; /**< of a file that can seek */
  int error;      /**< errno of the first call that failed, or 0 */
} SndfileIo;

/** Opens the file for writing; @p io must outlive the result. */
SNDFILE *sndfile_io_open(SndfileIo *io, int descriptor, SF_INFO *info);

#endif
