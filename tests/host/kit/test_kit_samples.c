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

#include <cmocka.h>
#include <sndfile.h>

enum { FRAMES = 1000, FADE = 100 };

/* Notes 42 and 46, of group 1, with samples of constant 1, and 0.5 at the left and -0.5 at the right. */
static int prepare(void **state) {
  KitSamples *samples = malloc(sizeof *samples);
  kit_samples_begin(samples);
  samples->fade = FADE;
  for (int i = 0; i < 2; i++) {
    KitSample *sample = &samples->notes[42 + 4 * i];
    sample->choke = 1;
    sample->frames = FRAMES;
    for (int side = 0; side <= i; side++) {
      sample->sound[side] = malloc(FRAMES * sizeof(float));
      for (int f = 0; f < FRAMES; f++) {
        sample->sound[side][f] = i == 0 ? 1.0f : 0.5f - (float)side;
      }
    }
  }
  *state = samples;
  return 0;
}

static int clean_up(void **state) {
  kit_samples_free(*state);
  free(*state);
  return 0;
}

static void a_stroke_plays_the_sample_from_its_frame_on(void **state) {
  KitSamples *samples = *state;
  static float left[2 * FRAMES], right[2 * FRAMES];
  memset(left, 0, sizeof left);
  memset(right, 0, sizeof right);
  assert_true(kit_samples_are_silent(samples));
  kit_samples_strike(samples, 42, 0.5, 300);
  kit_samples_add(samples, left, right, 2 * FRAMES);
  assert_true(left[299] == 0.0f && left[300] == 0.25f && left[1299] == 0.25f && left[1300] == 0.0f);
  assert_memory_equal(left, right, sizeof left); /* a mono file at both sides */
  assert_true(kit_samples_are_silent(samples));
  kit_samples_strike(samples, 46, 1.0, 0);
  memset(left, 0, sizeof left);
  memset(right, 0, sizeof right);
  kit_samples_add(samples, left, right, 10);
  assert_true(left[0] == 0.5f && right[0] == -0.5f);
}

static void blocks_change_nothing_and_a_stroke_chokes_its_group(void **state) {
  KitSamples *samples = *state;
  static float whole[2][2 * FRAMES], parts[2][2 * FRAMES];
  for (int run = 0; run < 2; run++) {
    float(*to)[2 * FRAMES] = run == 0 ? whole : parts;
    const uint32_t block = run == 0 ? 2 * FRAMES : 16;
    memset(to, 0, sizeof whole);
    for (uint32_t at = 0; at < 2 * FRAMES; at += block) {
      if (at == 0) kit_samples_strike(samples, 42, 1.0, 5);
      if (at <= 407 && 407 < at + block) kit_samples_strike(samples, 46, 1.0, 407 - at);
      kit_samples_add(samples, to[0] + at, to[1] + at, block);
    }
    assert_true(kit_samples_are_silent(samples));
  }
  assert_memory_equal(whole, parts, sizeof whole);
  assert_true(whole[1][406] == 1.0f);
  assert_true(whole[1][407] < 1.0f - 0.5f + 0.001f); /* the other begins, the first fades */
  assert_true(whole[1][407 + FADE] == -0.5f);
}

/* A grabbed cymbal fades, with others of its group and no others, from the event's frame on. */
static void a_choke_fades_the_sample_and_its_group(void **state) {
  KitSamples *samples = *state;
  const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE, .velocity = 1};
  const TaborEvent choke = {.type = TABOR_EVENT_SILENCE};
  for (uint32_t note = 42; note <= 51; note += note == 42 ? 4 : 5) {
    static float left[FRAMES], right[FRAMES];
    memset(left, 0, sizeof left);
    kit_samples_take(samples, 46, &stroke, 0);
    kit_samples_take(samples, note, &choke, 200);
    kit_samples_add(samples, left, right, FRAMES);
    assert_true(left[199] == 0.5f);
    if (note < 51) {
      assert_true(left[201] < 0.5f && left[200 + FADE] == 0.0f);
    } else {
      assert_true(left[200 + FADE] == 0.5f);
    }
    kit_samples_add(samples, left, right, FRAMES);
    assert_true(kit_samples_are_silent(samples));
  }
}

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

/* 20 dB are a factor of 10 in pressure. */
static void files_are_read_with_their_gain(void **state) {
  KitSamples *samples = *state;
  static TaborKitDef kit;
  static const TaborKitNoteDef NOTES[] = {{"test_kit_samples-mono.wav", -20, 0},
                                          {"test_kit_samples-pair.wav", 6.0206, 2}};
  char message[200];
  tabor_kit_def_default(&kit);
  for (int i = 0; i < 2; i++) {
    write_file(NOTES[i].sample, i + 1);
    kit.note[51 + i] = NOTES[i];
  }
  kit_samples_free(samples);
  assert_int_equal(kit_samples_load(samples, &kit, 48000.0), OUTCOME_OK);
  const KitSample *mono = &samples->notes[51], *pair = &samples->notes[52];
  assert_true(mono->frames == 8 && pair->frames == 8);
  assert_true(mono->choke == 0 && pair->choke == 2);
  assert_null(mono->sound[1]);
  for (int f = 0; f < 8; f++) {
    assert_true(fabsf(mono->sound[0][f] - 0.05f) < 1e-6f);
    assert_true(fabsf(pair->sound[0][f] - 1.0f) < 1e-5f);
    assert_true(fabsf(pair->sound[1][f] + 0.5f) < 1e-5f);
  }
  assert_true(samples->fade == 720); /* 15 ms */
  KitSamples other;
  kit_samples_begin(&other);
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = kit_samples_load(&other, &kit, 44100.0);
  message_release(before);
  assert_int_not_equal(outcome, OUTCOME_OK);
  assert_non_null(strstr(message, "48000 Hz"));
  kit_samples_free(&other);
  for (int i = 0; i < 2; i++) remove(NOTES[i].sample);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup_teardown(a_stroke_plays_the_sample_from_its_frame_on, prepare, clean_up),
    cmocka_unit_test_setup_teardown(blocks_change_nothing_and_a_stroke_chokes_its_group, prepare,
                                    clean_up),
    cmocka_unit_test_setup_teardown(a_choke_fades_the_sample_and_its_group, prepare, clean_up),
    cmocka_unit_test_setup_teardown(files_are_read_with_their_gain, prepare, clean_up),
    cmocka_unit_test_setup_teardown(files_are_beside_the_kit, prepare, clean_up),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
