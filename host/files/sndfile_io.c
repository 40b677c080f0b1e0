/* SPDX-License-Identifier: MIT */
#include "files/sndfile_io.h"

#include <errno.h>
#include <unistd.h>

#include "platform/files.h"

static sf_count_t record(SndfileIo *io, sf_count_t result) {
  if (result < 0 && io->error == 0) io->error = errno;
  return result;
}

static sf_count_t file_length(void *context) {
  SndfileIo *const io = context;
  FileStatus status;
  if (!file_status_of(io->descriptor, &status)) return record(io, -1);
  const sf_count_t size = (sf_count_t)status.size;
  return size > io->before ? size - io->before : 0;
}

static sf_count_t seek(sf_count_t offset, int whence, void *context) {
  SndfileIo *const io = context;
  const sf_count_t place =
    lseek(io->descriptor, whence == SEEK_SET ? io->before + offset : offset, whence);
  return record(io, place < 0 ? place : place - io->before);
}

static sf_count_t tell_place(void *context) { return seek(0, SEEK_CUR, context); }

static sf_count_t read_some(void *bytes, sf_count_t size, void *context) {
  SndfileIo *const io = context;
  return record(io, read(io->descriptor, bytes, (size_t)size));
}

static sf_count_t write_all(const void *bytes, sf_count_t size, void *context) {
  SndfileIo *const io = context;
  sf_count_t done = 0;
  while (done < size) {
    const ssize_t written =
      write(io->descriptor, (const char *)bytes + done, (size_t)(size - done));
    if (written < 0 && errno == EINTR) continue;
    if (record(io, written) < 0) return done;
    done += written;
  }
  return done;
}

SNDFILE *sndfile_io_open(SndfileIo *io, int descriptor, long before, SF_INFO *info) {
  *io = (SndfileIo){.descriptor = descriptor, .before = before};
  SF_VIRTUAL_IO calls = {.get_filelen = file_length,
                         .seek = seek,
                         .read = read_some,
                         .write = write_all,
                         .tell = tell_place};
  return sf_open_virtual(&calls, SFM_WRITE, info, io);
}
