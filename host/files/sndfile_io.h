/* SPDX-License-Identifier: MIT */
/**
 * @file sndfile_io.h
 * File access for libsndfile that keeps the first error. libsndfile loses some errors: sf_close()
 * does not report a header that could not be written at the end. Such a file may even be read back
 * without an error, because readers guess the values missing in the header.
 */
#ifndef TABOR_HOST_SNDFILE_IO_H
#define TABOR_HOST_SNDFILE_IO_H

#include <sndfile.h>

typedef struct SndfileIo {
  int descriptor; /**< descriptor of a seekable file */
  long before;    /**< bytes at its beginning that are not libsndfile's */
  int error;      /**< errno of the first call that failed, or 0 */
} SndfileIo;

/** Opens the file for writing behind its first @p before bytes; @p io must outlive the result. */
SNDFILE *sndfile_io_open(SndfileIo *io, int descriptor, long before, SF_INFO *info);

#endif
