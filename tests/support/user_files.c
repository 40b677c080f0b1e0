/* SPDX-License-Identifier: MIT */
#include "user_files.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "windows_names.h"

#define FRAMES 4800u

static char data[] = "/tmp/tabor-data-XXXXXX";

const char *user_data(void) { return data; }

const char *user_file(const char *name) {
  static char path[512];
  (void)snprintf(path, sizeof path, "%s/tabor/%s", data, name);
  return path;
}

static void write_bytes(const char *name, const void *bytes, size_t size) {
  FILE *const file = fopen(user_file(name), "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, size, file), size);
  assert_int_equal(fclose(file), 0);
}

void user_file_write(const char *name, const char *text) { write_bytes(name, text, strlen(text)); }

/* A tenth of a second that falls from a half to nothing and changes its sign at each frame. */
static void write_sound(const char *name) {
  struct {
    char riff[4];
    uint32_t size;
    char wave[8];
    uint32_t format_size;
    uint16_t format, channels;
    uint32_t rate, bytes;
    uint16_t frame, bits;
    char data[4];
    uint32_t data_size;
    int16_t samples[FRAMES];
  } wav = {{'R', 'I', 'F', 'F'},
           36 + 2 * FRAMES,
           {'W', 'A', 'V', 'E', 'f', 'm', 't', ' '},
           16,
           1,
           1,
           48000,
           96000,
           2,
           16,
           {'d', 'a', 't', 'a'},
           2 * FRAMES,
           {0}};
  for (uint32_t i = 0; i < FRAMES; i++)
    wav.samples[i] = (int16_t)((i % 2 == 0 ? 16384 : -16384) * (1 - (double)i / FRAMES));
  write_bytes(name, &wav, sizeof wav);
}

int user_files_make(void **state) {
  (void)state;
  strcpy(data, "/tmp/tabor-data-XXXXXX");
  if (!mkdtemp(data) || setenv(USER_DATA, data, 1) != 0) return 1;
  if (make_folder(user_file("")) != 0) return 1;
  user_file_write("drum.ini", "[drum]\nname = mine\n[shell]\nradius = 0.15\nboundary = open\n"
                              "[batter]\ntension = 2000\nsurface_density = 0.3\n"
                              "[striker.stick]\nkind = stick\n"
                              "[mic.top]\nradius = 0.1\nheight = 0.1\n");
  user_file_write("kit.ini", "[kit]\nname = my-kit\ncomment = Two toms\n"
                             "[drum.high]\npreset = tom-10\nhead = 38\n"
                             "[drum.low]\npreset = tom-12\nx = 0.5\nhead = 41\n"
                             "[note.42]\nsample = hat.wav\n");
  user_file_write("else.ini", "[window]\nwidth = 100\n");
  write_sound("hat.wav");
  return 0;
}

int user_files_remove(void **state) {
  (void)state;
  return remove_folder(data);
}
