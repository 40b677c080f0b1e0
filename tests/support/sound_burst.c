/* SPDX-License-Identifier: MIT */
#include "sound_burst.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include <sndfile.h>

#include "windows_names.h"

static const double PI = 3.14159265358979323846;

float burst[BURST_FRAMES];

void burst_make(void) {
  for (uint32_t i = 0; i < BURST_FRAMES; i++) {
    const double t = i / 48000.0;
    burst[i] = (float)(0.8 * exp(-12 * t) * sin(2 * PI * 180 * t));
  }
}

static void write_burst(const char *path) {
  SF_INFO info = {.samplerate = 48000, .channels = 1, .format = SF_FORMAT_WAV | SF_FORMAT_FLOAT};
  SNDFILE *const file = sf_open(path, SFM_WRITE, &info);
  assert_non_null(file);
  assert_int_equal(sf_write_float(file, burst, BURST_FRAMES), BURST_FRAMES);
  assert_int_equal(sf_close(file), 0);
}

void burst_render(const char *program, Take *take) {
  char in[256], out[256], command[1024];
  song_path(in, sizeof in, "burst.wav");
  song_path(out, sizeof out, "song.wav");
  write_burst(in);
  (void)snprintf(
    command, sizeof command,
    QUOTED("%s") " render snare-14x5.5 --quality draft --input " QUOTED(
      "%s") " --mic left --mic right --gain "
            "12 --set room.kind=none --duration 0.5 --format float -q -o " QUOTED("%s"),
    program, in, out);
  assert_int_equal(run_command(command), 0);
  take_read(out, take);
}
