/* SPDX-License-Identifier: MIT */
#include "files/sample_spool.h"

#include <errno.h>
#include <string.h>

#include "platform/files.h"

#define CHUNK 1024 /* samples converted at once */

static size_t smaller(size_t a, size_t b) { return a < b ? a : b; }

static Outcome failure(const char *what) {
  return fail("cannot %s a temporary file: %s", what, strerror(errno));
}

Outcome sample_spool_open(SampleSpool *spool) {
  spool->stream = file_stream_unnamed();
  return spool->stream ? OUTCOME_OK : failure("create");
}

Outcome sample_spool_write(SampleSpool *spool, const double *samples, size_t count) {
  float chunk[CHUNK];
  while (count > 0) {
    const size_t size = smaller(count, CHUNK);
    for (size_t i = 0; i < size; i++) chunk[i] = (float)samples[i];
    if (fwrite(chunk, sizeof chunk[0], size, spool->stream) != size) return failure("write");
    samples += size;
    count -= size;
  }
  return OUTCOME_OK;
}

Outcome sample_spool_rewind(SampleSpool *spool) {
  if (fflush(spool->stream) != 0) return failure("write");
  return fseek(spool->stream, 0, SEEK_SET) == 0 ? OUTCOME_OK : failure("read");
}

Outcome sample_spool_read(SampleSpool *spool, double *samples, size_t count) {
  float chunk[CHUNK];
  while (count > 0) {
    const size_t size = smaller(count, CHUNK);
    errno = 0;
    if (fread(chunk, sizeof chunk[0], size, spool->stream) != size) return failure("read");
    for (size_t i = 0; i < size; i++) samples[i] = (double)chunk[i];
    samples += size;
    count -= size;
  }
  return OUTCOME_OK;
}

void sample_spool_free(SampleSpool *spool) {
  if (spool->stream) (void)fclose(spool->stream);
  spool->stream = NULL;
}
