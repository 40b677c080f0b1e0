/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <windows.h>
#define ENABLE_SNDFILE_WINDOWS_PROTOTYPES 1

#include "platform/sound_stream.h"
#include "platform/wide.h"

SNDFILE *sound_stream_to_read(const char *path, SF_INFO *info) {
  wchar_t *const wide = wide_from_utf8(path);
  SNDFILE *const stream = wide ? sf_wchar_open(wide, SFM_READ, info) : NULL;
  free(wide);
  return stream;
}
