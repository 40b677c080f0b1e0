/* SPDX-License-Identifier: MIT */
#include "platform/sound_stream.h"

SNDFILE *sound_stream_to_read(const char *path, SF_INFO *info) {
  return sf_open(path, SFM_READ, info);
}
