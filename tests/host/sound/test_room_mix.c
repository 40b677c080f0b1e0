/* SPDX-License-Identifier: MIT */
/* The room behind a drum player's outputs: silences fade it, what is played after them sounds in
 * full, and blocks change no bit. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "sound/room_mix.h"

#include <cmocka.h>

#define RATE 48000.0
#define OUTPUTS 3u /* the snare drum's first microphone, then its pair */
#define HEARD 7u
#define FRAMES 9000u
#define SILENCE 4000u
#define FADE 720u /* 15 ms */

typedef float Sound[OUTPUTS][FRAMES];

static void open_room(RoomMix *mix, uint32_t kind) {
  TaborDrumDef def;
  TaborError error;
  assert_int_equal(tabor_drum_def_preset(&def, "snare-14x5.5", NULL), TABOR_OK);
  def.room.kind = kind;
  const uint8_t mics[OUTPUTS] = {0, (uint8_t)tabor_drum_def_find_mic(&def, "left"),
                                 (uint8_t)tabor_drum_def_find_mic(&def, "right")};
  assert_int_equal(room_mix_create(mix, &def, RATE, mics, OUTPUTS, &error), TABOR_OK);
}

/* What the drum plays: noise of the pair between two frames, another one on each side. */
static void strike(Sound *sound, uint32_t from, uint32_t to) {
  uint32_t random = 1;
  for (uint32_t frame = from; frame < to; frame++) {
    for (uint32_t output = 1; output < OUTPUTS; output++) {
      random = random * 1664525u + 1013904223u;
      (*sound)[output][frame] = (float)(random >> 8) / 16777216.0f - 0.5f;
    }
  }
}

/* Plays what is in `sound`, in pieces of `block` frames, with a silence at frame `silence`. */
static void play(RoomMix *mix, Sound *sound, uint32_t block, uint32_t silence) {
  float piece[OUTPUTS][ROOM_MIX_PIECE];
  uint32_t frames;
  for (uint32_t at = 0; at < FRAMES; at += frames) {
    const uint32_t limit = at < silence ? silence : FRAMES;
    if (at == silence) room_mix_silence(mix);
    frames = limit - at < block ? limit - at : block;
    for (uint32_t i = 0; i < OUTPUTS; i++)
      memcpy(piece[i], (*sound)[i] + at, frames * sizeof(float));
    room_mix_play(mix, piece, HEARD, 0, frames);
    for (uint32_t i = 0; i < OUTPUTS; i++)
      memcpy((*sound)[i] + at, piece[i], frames * sizeof(float));
  }
}

/* The sound of a room of its own; 0 to FRAMES for `silence`, FRAMES for none. */
static Sound *sound_of(uint32_t kind, const uint32_t (*strokes)[2], uint32_t count, uint32_t block,
                       uint32_t silence) {
  RoomMix mix;
  Sound *const sound = calloc(1, sizeof *sound);
  assert_non_null(sound);
  for (uint32_t i = 0; i < count; i++) strike(sound, strokes[i][0], strokes[i][1]);
  open_room(&mix, kind);
  play(&mix, sound, block, silence);
  room_mix_free(&mix);
  return sound;
}

static const uint32_t before[][2] = {{0, 300}}, after[][2] = {{SILENCE + 200, SILENCE + 300}},
                      both[][2] = {{0, 300}, {SILENCE + 200, SILENCE + 300}};

static void without_a_room_nothing_is_added(void **state) {
  (void)state;
  Sound *const played = sound_of(TABOR_ROOM_NONE, both, 2, 100, SILENCE);
  Sound dry = {{0}};
  strike(&dry, both[0][0], both[0][1]);
  strike(&dry, both[1][0], both[1][1]);
  assert_memory_equal(played, &dry, sizeof dry);
  free(played);
}

static void blocks_change_no_bit(void **state) {
  (void)state;
  static const uint32_t blocks[] = {1, 7, 64};
  Sound *const expected = sound_of(TABOR_ROOM_STUDIO, both, 2, ROOM_MIX_PIECE, SILENCE);
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) {
    Sound *const sound = sound_of(TABOR_ROOM_STUDIO, both, 2, blocks[i], SILENCE);
    assert_memory_equal(sound, expected, sizeof *sound);
    free(sound);
  }
  free(expected);
}

/* A line from 1 to 0 over what would have sounded; then exactly nothing. */
static void a_silence_fades_the_room(void **state) {
  (void)state;
  Sound *const free_sound = sound_of(TABOR_ROOM_STUDIO, before, 1, 128, FRAMES);
  Sound *const faded = sound_of(TABOR_ROOM_STUDIO, before, 1, 128, SILENCE);
  double heard = 0;
  for (uint32_t output = 0; output < OUTPUTS; output++) {
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
      const double left = frame < SILENCE ? FADE + 1 : (double)SILENCE + FADE - frame;
      const double weight = left > 0 ? left / (FADE + 1) : 0;
      const double expected = weight * (double)(*free_sound)[output][frame];
      assert_true(fabs((double)(*faded)[output][frame] - expected) <= 1e-7);
      if (frame >= SILENCE) heard += fabs((double)(*free_sound)[output][frame]);
    }
    assert_true((*faded)[output][FRAMES - 1] == 0);
  }
  assert_true(heard > 1); /* the room was still loud */
  free(free_sound);
  free(faded);
}

/* A stroke within the fade sounds as it would alone, on top of what fades. */
static void a_stroke_in_the_fade_sounds_in_full(void **state) {
  (void)state;
  Sound *const faded = sound_of(TABOR_ROOM_HALL, before, 1, 100, SILENCE);
  Sound *const alone = sound_of(TABOR_ROOM_HALL, after, 1, 100, FRAMES);
  Sound *const together = sound_of(TABOR_ROOM_HALL, both, 2, 100, SILENCE);
  for (uint32_t output = 0; output < OUTPUTS; output++) {
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
      const double sum = (double)(*faded)[output][frame] + (double)(*alone)[output][frame];
      assert_true(fabs((double)(*together)[output][frame] - sum) <= 1e-6);
    }
  }
  free(faded);
  free(alone);
  free(together);
}

static void rest_is_a_new_beginning(void **state) {
  (void)state;
  Sound *const expected = sound_of(TABOR_ROOM_BOOTH, before, 1, 256, FRAMES);
  Sound *const again = calloc(1, sizeof *again);
  RoomMix mix;
  assert_non_null(again);
  open_room(&mix, TABOR_ROOM_BOOTH);
  strike(again, 0, 5000);
  play(&mix, again, 256, SILENCE);
  room_mix_rest(&mix);
  memset(again, 0, sizeof *again);
  strike(again, before[0][0], before[0][1]);
  play(&mix, again, 256, FRAMES);
  assert_memory_equal(again, expected, sizeof *again);
  room_mix_free(&mix);
  free(again);
  free(expected);
}

static void it_is_over_when_it_has_died_away(void **state) {
  (void)state;
  RoomMix mix;
  Sound *const sound = calloc(1, sizeof *sound);
  uint32_t rounds = 0;
  assert_non_null(sound);
  open_room(&mix, TABOR_ROOM_BOOTH);
  strike(sound, 0, 300);
  play(&mix, sound, 256, FRAMES);
  for (; !room_mix_is_over(&mix); rounds++) {
    memset(sound, 0, sizeof *sound);
    play(&mix, sound, 256, FRAMES);
    assert_true(rounds < 20);
  }
  assert_true(rounds > 0); /* 90 dB at 60 dB in 0.3 s, 0.19 s a round */
  room_mix_free(&mix);
  open_room(&mix, TABOR_ROOM_NONE);
  assert_true(room_mix_is_over(&mix));
  room_mix_free(&mix);
  free(sound);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(without_a_room_nothing_is_added),
    cmocka_unit_test(blocks_change_no_bit),
    cmocka_unit_test(a_silence_fades_the_room),
    cmocka_unit_test(a_stroke_in_the_fade_sounds_in_full),
    cmocka_unit_test(rest_is_a_new_beginning),
    cmocka_unit_test(it_is_over_when_it_has_died_away),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
