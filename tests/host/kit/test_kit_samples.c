/* SPDX-License-Identifier: MIT */
/* Sound files that stand for what a kit does not model. */
#include "base/message.h"
#include "kit/kit_file.h"
#include "kit/kit_sample_files.h" /* before cmocka, whose fail() is a macro */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sndfile.h>

#include "kits.h"

enum { FRAMES = 8 };

/* Sound files lie beside their kit file, unless they have a folder of their own. */
static void files_are_beside_the_kit(void **state) {
  (void)state;
  static TaborKitDef kit;
  char message[400];
  const char *const text = "[note.51]\nsample = ride.wav\nchoke = 3\n[note.52]\nsample = ./a.wav\n";
  assert_int_equal(kit_file_parse("kits/a.ini", text, strlen(text), &kit, message, sizeof message),
                   PRESET_FILE_OK);
  assert_string_equal(kit.note[51].sample, "kits/ride.wav");
  assert_string_equal(kit.note[52].sample, "./a.wav");
  assert_int_equal(kit.note[51].choke, 3);
  static const char *const bad[] = {"[note.128]\ngain = 0\n",  "[note.x]\ngain = 0\n",
                                    "[note.51]\ngain = 25\n",  "[note.51]\nchoke = 1.5\n",
                                    "[note.51]\npitch = 1\n",  "[note.51]\ngain = loud\n",
                                    "[note.51]\nchoke = 16\n", "[note]\n"};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    assert_int_equal(kit_file_parse("a.ini", bad[i], strlen(bad[i]), &kit, message, sizeof message),
                     PRESET_FILE_INVALID);
    assert_true(strncmp(message, "a.ini:", 6) == 0);
  }
  char folder[TABOR_TEXT_SIZE + 8];
  memset(folder, 'f', sizeof folder);
  memcpy(folder + sizeof folder - 7, "/a.ini", 7);
  assert_int_equal(kit_file_parse(folder, text, strlen(text), &kit, message, sizeof message),
                   PRESET_FILE_INVALID);
  assert_non_null(strstr(message, "longer than 255 bytes"));
}

/* A file of 8 frames, 0.5 and, if there are two, -0.25. */
static void write_file(const char *name, int channels) {
  SF_INFO info = {
    .samplerate = 48000, .channels = channels, .format = SF_FORMAT_WAV | SF_FORMAT_FLOAT};
  SNDFILE *file = sf_open(name, SFM_WRITE, &info);
  assert_non_null(file);
  float sound[16];
  for (int i = 0; i < 8 * channels; i++) sound[i] = channels == 2 && i % 2 ? -0.25f : 0.5f;
  assert_int_equal(sf_writef_float(file, sound, 8), 8);
  sf_close(file);
}

/* 20 dB are a factor of 10 in pressure; what stands in a file is at once in the mix. */
static void files_are_read_with_their_gain(void **state) {
  (void)state;
  static TaborKitDef kit;
  static const TaborKitNoteDef NOTES[] = {{"test_kit_samples-mono.wav", -20, 0},
                                          {"test_kit_samples-pair.wav", 6.0206, 2}};
  static const float expected[2][2] = {{0.05f, 0.05f}, {1.0f, -0.5f}};
  char message[300];
  tabor_kit_def_default(&kit);
  assert_int_equal(tabor_kit_def_set(&kit, "drum.d.preset", "frame-drum", NULL), TABOR_OK);
  for (int i = 0; i < 2; i++) {
    write_file(NOTES[i].sample, i + 1);
    kit.note[51 + i] = NOTES[i];
  }
  TaborKit *const made = new_kit(&kit);
  assert_int_equal(kit_sample_files_read(made), OUTCOME_OK);
  for (uint32_t i = 0; i < 2; i++) {
    float sides[2][FRAMES + 1];
    const TaborKitEvent stroke = {.drum = TABOR_KIT_NOTE + 51 + i,
                                  .event = {.type = TABOR_EVENT_STRIKE, .velocity = 1}};
    const TaborKitOutputs outputs = {.stereo = {sides[0], sides[1]}};
    tabor_kit_process(made, &stroke, 1, &outputs, FRAMES + 1);
    for (int f = 0; f < FRAMES; f++) {
      assert_true(fabsf(sides[0][f] - expected[i][0]) < 1e-5f);
      assert_true(fabsf(sides[1][f] - expected[i][1]) < 1e-5f);
    }
    assert_true(sides[0][FRAMES] == 0 && sides[1][FRAMES] == 0);
  }
  tabor_kit_destroy(made);
  for (int i = 0; i < 2; i++) remove(NOTES[i].sample);
  TaborKit *const lacking = new_kit(&kit);
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = kit_sample_files_read(lacking);
  message_release(before);
  assert_int_not_equal(outcome, OUTCOME_OK);
  assert_non_null(strstr(message, NOTES[0].sample));
  tabor_kit_destroy(lacking);
}

int main(void) {
  brief = true; /* the drum is not what is looked at */
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(files_are_beside_the_kit),
    cmocka_unit_test(files_are_read_with_their_gain),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
