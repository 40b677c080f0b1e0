/* SPDX-License-Identifier: MIT */
/* A drum that is played by messages, with a room behind it: what acts when, whatever the blocks
 * are. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "sound/drum_player.h"

#include <cmocka.h>

#define RATE 48000.0
#define SOUND 1000 /* frames of a sample */
#define FADE 720u  /* 15 ms, as the engine and the room have it */

enum { OUTPUTS = 3, MOST_FRAMES = 4096, MOST_MESSAGES = 1024, MOST_ACTED = 2048 };

typedef struct Score {
  PlayerMessage list[MOST_MESSAGES];
  uint32_t count, next;
} Score;

/* A player with its drum and the sound so far. */
typedef struct Stage {
  DrumPlayer player;
  RoomMix rooms[2];
  Score score;
  float sound[OUTPUTS][MOST_FRAMES];
  uint32_t position;
  uint64_t acted[MOST_ACTED]; /* the frame at which each message acted, as the witness was told */
  uint32_t acted_count;
} Stage;

static TaborDrumDef def;
static TaborModel *model;

/* ---- a stage -------------------------------------------------------------------------------- */

static bool take(void *source, uint64_t end, PlayerMessage *message) REALTIME;
static bool take(void *source, uint64_t end, PlayerMessage *message) {
  Score *const score = source;
  if (score->next == score->count || score->list[score->next].frame >= end) return false;
  *message = score->list[score->next++];
  return true;
}

static void witness(void *context, const PlayerMessage *message, uint64_t frame) REALTIME;
static void witness(void *context, const PlayerMessage *message, uint64_t frame) {
  Stage *const stage = context;
  (void)message;
  stage->acted[stage->acted_count++] = frame;
}

static void find_mics(uint8_t *mics) {
  mics[0] = 0;
  mics[1] = (uint8_t)tabor_drum_def_find_mic(&def, "left");
  mics[2] = (uint8_t)tabor_drum_def_find_mic(&def, "right");
}

static void open_room(Stage *stage, int which, uint32_t kind) {
  TaborDrumDef roomy = def;
  uint8_t mics[OUTPUTS];
  find_mics(mics);
  roomy.room.kind = kind;
  assert_int_equal(room_mix_create(&stage->rooms[which], &roomy, RATE, mics, OUTPUTS, NULL),
                   TABOR_OK);
}

static Stage *open_stage(uint32_t room) {
  Stage *const stage = calloc(1, sizeof *stage);
  TaborDrum *drum;
  uint8_t mics[OUTPUTS];
  assert_non_null(stage);
  find_mics(mics);
  assert_int_equal(tabor_drum_create(model, &drum, NULL), TABOR_OK);
  tabor_drum_route(drum, mics, OUTPUTS);
  drum_player_begin(&stage->player, OUTPUTS, 1.0);
  drum_player_set_drum(&stage->player, drum, def.striker_count);
  stage->player.heard = 7;
  stage->player.witness = witness;
  stage->player.context = stage;
  if (room == TABOR_ROOM_NONE) return stage;
  open_room(stage, 0, room);
  drum_player_set_room(&stage->player, &stage->rooms[0]);
  return stage;
}

static void close_stage(Stage *stage) {
  tabor_drum_destroy(stage->player.drum);
  for (int i = 0; i < 2; i++) {
    if (stage->rooms[i].room) room_mix_free(&stage->rooms[i]);
  }
  free(stage);
}

static void play(Stage *stage, uint32_t until, uint32_t block) {
  assert_true(until <= MOST_FRAMES);
  while (stage->position < until) {
    const uint32_t left = until - stage->position, frames = left < block ? left : block;
    drum_player_play(&stage->player, take, &stage->score, frames);
    for (uint32_t i = 0; i < OUTPUTS; i++) {
      memcpy(stage->sound[i] + stage->position, stage->player.sound[i], frames * sizeof(float));
    }
    stage->position += frames;
    assert_int_equal(stage->player.position, stage->position);
  }
}

static void add(Stage *stage, PlayerMessage message) {
  assert_true(stage->score.count < MOST_MESSAGES);
  stage->score.list[stage->score.count++] = message;
}

static void strike(Stage *stage, uint32_t frame, uint32_t striker) {
  add(stage,
      (PlayerMessage){
        .frame = frame,
        .type = PLAYER_EVENT,
        .event = {.type = TABOR_EVENT_STRIKE, .striker = striker, .velocity = 3, .radius = 0.03}});
}

static void silence(Stage *stage, uint32_t frame) {
  add(stage, (PlayerMessage){
               .frame = frame, .type = PLAYER_EVENT, .event = {.type = TABOR_EVENT_SILENCE}});
}

static void set(Stage *stage, uint32_t frame, uint32_t type, double value) {
  add(stage, (PlayerMessage){.frame = frame, .type = type, .value = value});
}

static double peak(const Stage *stage, uint32_t output, uint32_t from, uint32_t until) {
  double most = 0;
  for (uint32_t i = from; i < until; i++) most = fmax(most, fabs((double)stage->sound[output][i]));
  return most;
}

static void assert_same(const Stage *one, const Stage *other, uint32_t from, uint32_t until,
                        const char *what) {
  for (uint32_t output = 0; output < OUTPUTS; output++) {
    for (uint32_t i = from; i < until; i++) {
      if (memcmp(&one->sound[output][i], &other->sound[output][i], sizeof(float)) == 0) continue;
      fail_msg("%s: output %u, frame %u: %.9g, not %.9g", what, (unsigned)output, (unsigned)i,
               (double)one->sound[output][i], (double)other->sound[output][i]);
    }
  }
}

/* ---- silences in a room --------------------------------------------------------------------- */

/* Wherever in a block they come, one or two of them, and with a stroke right behind. */
static void silences_at_each_frame_of_a_block(void **state) {
  (void)state;
  enum { BLOCK = 32, AT = 640, UNTIL = AT + BLOCK + FADE + 300 };
  for (uint32_t frame = 0; frame < BLOCK; frame++) {
    Stage *const stages[2] = {open_stage(TABOR_ROOM_STUDIO), open_stage(TABOR_ROOM_STUDIO)};
    const uint32_t second = frame + frame * 7 % (BLOCK - frame);
    for (int i = 0; i < 2; i++) {
      strike(stages[i], 5, 0);
      silence(stages[i], AT + frame);
      strike(stages[i], AT + frame, 0);
      if (frame % 2) silence(stages[i], AT + second);
      play(stages[i], UNTIL, i ? BLOCK : 1);
    }
    assert_true(peak(stages[0], 0, AT - 100, AT) > 1e-4);
    assert_same(stages[1], stages[0], 0, UNTIL, "a silence");
    if (frame % 2) { /* nothing has been struck since; the room answers what faded */
      const double before = peak(stages[0], 0, 0, AT + second);
      assert_true(peak(stages[0], 0, AT + second, AT + second + FADE) > 1e-6);
      assert_true(peak(stages[0], 0, AT + second + FADE + 1, UNTIL) < 0.1 * before);
    }
    for (int i = 0; i < 2; i++) close_stage(stages[i]);
  }
}

/* What sounds in the room fades, too, but for its answer to the drum while that fades. A hall that
 * went on ringing behind a silenced drum would leave twice the limit. */
static void a_silence_ends_what_rings_in_the_room(void **state) {
  (void)state;
  enum { AT = 1500, UNTIL = 3000 };
  Stage *const silenced = open_stage(TABOR_ROOM_HALL), *const rings = open_stage(TABOR_ROOM_HALL);
  strike(silenced, 0, 0);
  strike(rings, 0, 0);
  silence(silenced, AT);
  play(silenced, UNTIL, 64);
  play(rings, UNTIL, 64);
  const double left = peak(silenced, 0, AT + FADE + 1, UNTIL);
  const double else_left = peak(rings, 0, AT + FADE + 1, UNTIL);
  print_message("after a silence %.2g, without one %.2g\n", left, else_left);
  assert_true(left < 0.04 * else_left);
  close_stage(silenced);
  close_stage(rings);
}

/* The room behind a drum answers it, and does not without strokes. */
static void a_room_answers(void **state) {
  (void)state;
  Stage *const dry = open_stage(TABOR_ROOM_NONE), *const wet = open_stage(TABOR_ROOM_HALL),
               *const still = open_stage(TABOR_ROOM_HALL);
  strike(dry, 0, 0);
  strike(wet, 0, 0);
  play(dry, 3000, 256);
  play(wet, 3000, 256);
  play(still, 3000, 256);
  double answer = 0;
  for (int i = 0; i < 3000; i++) {
    answer = fmax(answer, fabs((double)wet->sound[0][i] - (double)dry->sound[0][i]));
  }
  assert_true(answer > 1e-3);
  assert_true(peak(still, 0, 0, 3000) == 0);
  close_stage(dry);
  close_stage(wet);
  close_stage(still);
}

/* The room before fades beside the new one, hears nothing any more, and is left then. Later on it
 * is as if the new room had been the first one. */
static void a_room_follows_another(void **state) {
  (void)state;
  enum { AT = 1000, UNTIL = 3000 };
  static const uint32_t blocks[] = {1, 64, 250};
  Stage *const plain = open_stage(TABOR_ROOM_NONE), *const first = open_stage(TABOR_ROOM_HALL);
  open_room(plain, 0, TABOR_ROOM_STUDIO);
  strike(plain, 3, 0);
  strike(plain, AT + 100, 0);
  strike(first, 3, 0);
  play(plain, AT, 100);
  drum_player_set_room(&plain->player, &plain->rooms[0]);
  play(plain, UNTIL, 100);
  for (int k = 0; k < 3; k++) {
    Stage *const stage = open_stage(TABOR_ROOM_HALL);
    open_room(stage, 1, TABOR_ROOM_STUDIO);
    strike(stage, 3, 0);
    strike(stage, AT + 100, 0);
    play(stage, AT, blocks[k]);
    drum_player_set_room(&stage->player, &stage->rooms[1]);
    play(stage, AT + FADE - 200, blocks[k]);
    assert_false(atomic_load(&stage->rooms[0].is_left));
    play(stage, UNTIL, blocks[k]);
    assert_true(atomic_load(&stage->rooms[0].is_left));
    assert_null(stage->player.former);
    double rest = 0;
    for (int i = AT; i < AT + 400; i++) {
      rest = fmax(rest, fabs((double)stage->sound[0][i] - (double)plain->sound[0][i]));
    }
    assert_true(rest > 1e-5); /* the hall is heard while it fades */
    assert_same(stage, plain, AT + FADE + 1, UNTIL, "a second room");
    if (k == 0) memcpy(first->sound, stage->sound, sizeof first->sound);
    assert_same(stage, first, 0, UNTIL, "blocks");
    close_stage(stage);
  }
  close_stage(plain);
  close_stage(first);
}

/* A third room while the first one fades: that is left at once. */
static void a_room_too_many_is_cut(void **state) {
  (void)state;
  Stage *const stage = open_stage(TABOR_ROOM_HALL);
  open_room(stage, 1, TABOR_ROOM_STUDIO);
  strike(stage, 3, 0);
  play(stage, 1000, 100);
  drum_player_set_room(&stage->player, &stage->rooms[1]);
  play(stage, 1100, 100);
  drum_player_set_room(&stage->player, NULL);
  assert_true(atomic_load(&stage->rooms[0].is_left));
  assert_false(atomic_load(&stage->rooms[1].is_left));
  assert_ptr_equal(stage->player.former, &stage->rooms[1]);
  close_stage(stage);
}

/* ---- what acts when ------------------------------------------------------------------------- */

static void messages_act_at_their_frames(void **state) {
  (void)state;
  static const uint32_t FRAMES[] = {0, 3, 3, 100, 255, 256, 256, 300, 511};
  enum { COUNT = sizeof FRAMES / sizeof *FRAMES };
  static const uint32_t blocks[] = {1, 7, 256};
  for (int k = 0; k < 3; k++) {
    Stage *const stage = open_stage(TABOR_ROOM_NONE);
    for (int i = 0; i < COUNT; i++) set(stage, FRAMES[i], PLAYER_GAIN, 1);
    play(stage, 511, blocks[k]);
    assert_int_equal(stage->acted_count, COUNT - 1); /* the last one's frame has not come */
    play(stage, 600, blocks[k]);
    assert_int_equal(stage->acted_count, COUNT);
    for (int i = 0; i < COUNT; i++) assert_int_equal(stage->acted[i], FRAMES[i]);
    set(stage, 4, PLAYER_GAIN, 1); /* long past: at once */
    set(stage, 610, PLAYER_GAIN, 1);
    set(stage, 605, PLAYER_GAIN, 1); /* behind one that acts later: with it */
    play(stage, 700, blocks[k]);
    assert_int_equal(stage->acted_count, COUNT + 3);
    assert_int_equal(stage->acted[COUNT], 600);
    assert_int_equal(stage->acted[COUNT + 1], 610);
    assert_int_equal(stage->acted[COUNT + 2], 610);
    close_stage(stage);
  }
}

/* Of more than fit into a frame the others act a frame later; of more than fit into a block none is
 * lost, or late. */
static void crowds_act_in_order(void **state) {
  (void)state;
  enum { MORE = 44, AT = 70, SPREAD = 300, FROM = 130 };
  static const uint32_t blocks[] = {1, 16, 64, 256};
  for (int k = 0; k < 4; k++) {
    Stage *const stage = open_stage(TABOR_ROOM_NONE);
    uint32_t next = 0;
    for (int i = 0; i < DRUM_PLAYER_EVENTS + MORE; i++) set(stage, AT, PLAYER_GAIN, 1);
    for (uint32_t i = 0; i < SPREAD; i++) set(stage, FROM + i / 5, PLAYER_EXPRESSION, 1);
    play(stage, 512, blocks[k]);
    assert_int_equal(stage->acted_count, DRUM_PLAYER_EVENTS + MORE + SPREAD);
    for (; next < DRUM_PLAYER_EVENTS; next++) assert_int_equal(stage->acted[next], AT);
    for (; next < DRUM_PLAYER_EVENTS + MORE; next++) assert_int_equal(stage->acted[next], AT + 1);
    for (uint32_t i = 0; i < SPREAD; i++) assert_int_equal(stage->acted[next + i], FROM + i / 5);
    close_stage(stage);
  }
}

/* A crowd that fills a block exactly leaves the stroke behind it at its frame. */
static void a_stroke_behind_a_crowd_keeps_its_frame(void **state) {
  (void)state;
  Stage *stages[2];
  for (int k = 0; k < 2; k++) {
    stages[k] = open_stage(TABOR_ROOM_NONE);
    for (int i = 0; i < DRUM_PLAYER_EVENTS; i++) set(stages[k], 10 + i / 100, PLAYER_GAIN, 1);
    strike(stages[k], 40, 0);
    strike(stages[k], 200, 0);
    play(stages[k], 1000, k ? 1 : 256);
  }
  assert_true(peak(stages[0], 0, 40, 1000) > 1e-3);
  assert_same(stages[0], stages[1], 0, 1000, "behind a crowd");
  for (int k = 0; k < 2; k++) close_stage(stages[k]);
}

/* ---- gain, strikers, outputs ---------------------------------------------------------------- */

/* The factors multiply; a rest forgets the expression, keeps the gain, and loses what has been
 * taken but not played. */
static void gain_and_expression_multiply(void **state) {
  (void)state;
  Stage *const stage = open_stage(TABOR_ROOM_NONE), *const plain = open_stage(TABOR_ROOM_NONE);
  set(stage, 0, PLAYER_GAIN, 0.5);
  set(stage, 0, PLAYER_EXPRESSION, 0.25);
  strike(stage, 300, 0);
  strike(plain, 300, 0);
  play(stage, 1000, 100);
  play(plain, 1000, 100);
  for (int i = 0; i < 1000; i++) {
    assert_true(stage->sound[0][i] == 0.125f * plain->sound[0][i]);
  }
  set(stage, 1100, PLAYER_EXPRESSION, 1); /* back: the gain is still there */
  play(stage, 1300, 100);
  play(plain, 1300, 100);
  for (int i = 1100; i < 1300; i++) {
    const double whole = (double)plain->sound[0][i];
    const double factor = fmin(0.125 + 0.375 * (i - 1099) / 241.0, 0.5);
    assert_true(fabs((double)stage->sound[0][i] - factor * whole) <= 1e-6 * fabs(whole));
  }
  close_stage(stage);
  close_stage(plain);
}

static void a_rest_is_a_new_beginning(void **state) {
  (void)state;
  Stage *const stage = open_stage(TABOR_ROOM_STUDIO), *const fresh = open_stage(TABOR_ROOM_STUDIO);
  open_room(stage, 1, TABOR_ROOM_STUDIO);
  drum_player_set_room(&stage->player, &stage->rooms[1]);
  set(stage, 0, PLAYER_GAIN, 0.5);
  set(stage, 0, PLAYER_EXPRESSION, 0.25);
  strike(stage, 100, 0);
  play(stage, 500, 100);
  stage->player.has_next = true; /* taken, and waiting for room in a block */
  stage->player.next = (PlayerMessage){.frame = 510, .type = PLAYER_GAIN, .value = 0};
  drum_player_rest(&stage->player);
  assert_true(stage->player.expression == 1 && stage->player.gain == 0.5);
  assert_null(stage->player.former);
  assert_true(atomic_load(&stage->rooms[0].is_left));
  assert_true(tabor_drum_is_silent(stage->player.drum));
  assert_true(tabor_room_is_silent(stage->rooms[1].room));
  strike(stage, 600, 0);
  strike(fresh, 600, 0);
  play(stage, 1600, 100);
  play(fresh, 1600, 100);
  assert_true(peak(stage, 0, 500, 600) == 0 && peak(stage, 0, 600, 1600) > 1e-4);
  for (uint32_t output = 0; output < OUTPUTS; output++) {
    for (int i = 500; i < 1600; i++) {
      const double expected = 0.5 * (double)fresh->sound[output][i];
      assert_true(fabs((double)stage->sound[output][i] - expected) <= 1e-6);
    }
  }
  assert_int_equal(stage->player.strokes, 2);
  drum_player_rest(&fresh->player);
  assert_int_equal(fresh->player.count, 1); /* the gain alone, at once */
  assert_int_equal(fresh->player.events[0].event.type, TABOR_EVENT_GAIN);
  close_stage(stage);
  close_stage(fresh);
}

/* A striker that the drum lacks is its first one; with a new model its number counts. */
static void strikers_are_those_of_the_model(void **state) {
  (void)state;
  assert_true(def.striker_count > 1);
  Stage *const stage = open_stage(TABOR_ROOM_NONE), *const first = open_stage(TABOR_ROOM_NONE),
               *const last = open_stage(TABOR_ROOM_NONE);
  const uint32_t other = def.striker_count - 1;
  strike(stage, 0, def.striker_count);
  strike(first, 0, 0);
  strike(last, 0, other);
  play(stage, 1000, 100);
  play(first, 1000, 100);
  play(last, 1000, 100);
  assert_same(stage, first, 0, 1000, "a striker too many");
  assert_true(memcmp(stage->sound[0], last->sound[0], 1000 * sizeof(float)) != 0);
  TaborSwap *swap;
  uint8_t mics[OUTPUTS];
  find_mics(mics);
  assert_int_equal(tabor_swap_create(model, model, &swap, NULL), TABOR_OK);
  tabor_swap_route(swap, mics, OUTPUTS);
  add(stage, (PlayerMessage){.frame = 1200,
                             .type = PLAYER_MODEL,
                             .strikers = 1,
                             .event = {.type = TABOR_EVENT_REPLACE, .swap = swap}});
  strike(stage, 3200, other); /* the new model has one */
  strike(first, 3200, 0);
  play(stage, 3000, 100);
  assert_int_equal(stage->player.strikers[0], 1);
  assert_true(tabor_swap_done(swap));
  drum_player_rest(&stage->player);
  drum_player_rest(&first->player);
  first->position = 0;
  first->player.position = 0;
  first->score.list[1].frame = 200;
  stage->position = 0;
  stage->player.position = 0;
  stage->score.list[stage->score.count - 1].frame = 200;
  tabor_swap_destroy(swap);
  play(stage, 1000, 100);
  play(first, 1000, 100);
  assert_true(peak(stage, 1, 200, 1000) > 1e-4);
  assert_same(stage, first, 0, 1000, "after a change");
  close_stage(stage);
  close_stage(first);
  close_stage(last);
}

/* What nobody hears is silent, unless the room hears the drum by it. */
static void unheard_outputs_are_silent(void **state) {
  (void)state;
  Stage *const all = open_stage(TABOR_ROOM_STUDIO), *const one = open_stage(TABOR_ROOM_STUDIO),
               *const dry = open_stage(TABOR_ROOM_NONE);
  one->player.heard = 1;
  dry->player.heard = 2;
  strike(all, 0, 0);
  strike(one, 0, 0);
  strike(dry, 0, 0);
  play(all, 1000, 100);
  play(one, 1000, 100);
  for (uint32_t i = 0; i < OUTPUTS; i++) dry->player.sound[i][7] = 1;
  play(dry, 1000, 100);
  assert_memory_equal(all->sound[0], one->sound[0], 1000 * sizeof(float));
  assert_true(peak(dry, 0, 0, 1000) == 0 && peak(dry, 2, 0, 1000) == 0);
  assert_true(peak(dry, 1, 0, 1000) > 1e-4);
  close_stage(all);
  close_stage(one);
  close_stage(dry);
}

/* Time goes on, and what is sent is lost. */
static void without_a_drum_there_is_silence(void **state) {
  (void)state;
  Stage *const stage = open_stage(TABOR_ROOM_NONE);
  TaborDrum *const drum = stage->player.drum;
  stage->player.drum = NULL;
  strike(stage, 5, 0);
  for (uint32_t i = 0; i < OUTPUTS; i++) stage->player.sound[i][7] = 1;
  play(stage, 300, 100);
  for (uint32_t i = 0; i < OUTPUTS; i++) assert_true(peak(stage, i, 0, 300) == 0);
  drum_player_rest(&stage->player);
  drum_player_set_drum(&stage->player, drum, def.striker_count);
  play(stage, 1000, 100);
  assert_true(peak(stage, 0, 300, 1000) == 0);
  close_stage(stage);
}

/* ---- kits ----------------------------------------------------------------------------------- */

static TaborKit *kit_of_two(void) {
  TaborKitDef *const kit_def = calloc(1, sizeof *kit_def);
  TaborModel *models[2];
  TaborModelOptions options;
  TaborKit *kit;
  assert_non_null(kit_def);
  tabor_kit_def_default(kit_def);
  assert_int_equal(tabor_kit_def_section(kit_def, "drum.left", NULL), TABOR_OK);
  assert_int_equal(tabor_kit_def_set(kit_def, "drum.right.x", "0.6", NULL), TABOR_OK);
  tabor_model_options_default(&options);
  options.sample_rate = RATE;
  options.quality = TABOR_QUALITY_DRAFT;
  for (uint32_t i = 0; i < 2; i++) {
    TaborDrumDef placed;
    kit_def->drum[i].def = def;
    assert_int_equal(tabor_kit_def_place(kit_def, i, &placed, NULL), TABOR_OK);
    assert_int_equal(tabor_model_create(&placed, &options, &models[i], NULL), TABOR_OK);
  }
  assert_int_equal(tabor_kit_create(kit_def, models, &kit, NULL), TABOR_OK);
  for (uint32_t i = 0; i < 2; i++) tabor_model_release(models[i]);
  free(kit_def);
  return kit;
}

/* Strokes on both drums and on a note with the sound `sample`, if that is not NULL, a choke, and a
 * gain in the midst of them. */
static Stage *play_kit(const float *sample, double gain, uint32_t block) {
  Stage *const stage = calloc(1, sizeof *stage);
  assert_non_null(stage);
  TaborKit *const kit = kit_of_two();
  if (sample) {
    assert_int_equal(tabor_kit_set_sample(kit, 42, sample, NULL, SOUND, RATE, NULL), TABOR_OK);
  }
  drum_player_begin(&stage->player, 2, 1);
  drum_player_set_kit(&stage->player, kit, RATE);
  stage->player.heard = 3;
  strike(stage, 10, 0);
  strike(stage, 10, 0);
  stage->score.list[1].drum = 1;
  strike(stage, 33, 0);
  stage->score.list[2].drum = TABOR_KIT_NOTE + 42;
  stage->score.list[2].event.velocity = 1;
  add(stage, (PlayerMessage){.frame = 301, .type = PLAYER_GAIN, .value = gain});
  add(stage, (PlayerMessage){.frame = 500,
                             .type = PLAYER_EVENT,
                             .drum = TABOR_KIT_NOTE + 42,
                             .event = {.type = TABOR_EVENT_SILENCE}});
  strike(stage, 700, 0);
  stage->score.list[5].drum = 77; /* nobody */
  play(stage, 1600, block);
  return stage;
}

static void close_kit(Stage *stage) {
  tabor_kit_destroy(stage->player.kit);
  free(stage);
}

static void a_kit_plays_with_its_samples_in_any_blocks(void **state) {
  (void)state;
  static float sound[SOUND];
  static const uint32_t blocks[3] = {DRUM_PLAYER_BLOCK, 1, 77};
  const int faded = 500 + (int)(0.015 * RATE);
  Stage *stages[3];
  for (int i = 0; i < SOUND; i++) sound[i] = 0.25f;
  for (int i = 0; i < 3; i++) {
    stages[i] = play_kit(sound, 0.5, blocks[i]);
    assert_memory_equal(stages[i]->sound, stages[0]->sound, sizeof stages[i]->sound);
  }
  Stage *const without = play_kit(NULL, 0.5, 100), *const loud = play_kit(NULL, 1, 100);
  for (int i = 0; i < 1600; i++) {
    const double sample = (double)(stages[0]->sound[0][i] - without->sound[0][i]);
    if (i < 33 || i >= faded) assert_true(sample == 0);
    if (i >= 33 && i < 301) assert_true(fabs(sample - 0.25) < 1e-6);
    if (i <= 300) assert_true(without->sound[0][i] == loud->sound[0][i]);
    if (i >= 301 + FADER_TIME * RATE) {
      assert_true(without->sound[0][i] == 0.5f * loud->sound[0][i]);
    }
  }
  TaborStatistics statistics;
  drum_player_statistics(&without->player, &statistics);
  assert_int_equal(statistics.strikes, 2);
  assert_int_equal(statistics.dropped_events, 3); /* and two for a note without a sound */
  assert_false(drum_player_is_silent(&without->player));
  TaborLedger ledger;
  drum_player_ledger(&without->player, &ledger);
  assert_true(ledger.stored > 0 && ledger.injected > ledger.stored);
  drum_player_rest(&without->player);
  assert_true(drum_player_is_silent(&without->player));
  for (int i = 0; i < 3; i++) close_kit(stages[i]);
  close_kit(without);
  close_kit(loud);
}

/* ---- MIDI ----------------------------------------------------------------------------------- */

static void actions_become_messages(void **state) {
  (void)state;
  PlayerMessage message;
  const MidiAction stroke = {.type = MIDI_ACTION_EVENT,
                             .event = {.type = TABOR_EVENT_STRIKE, .velocity = 2}};
  assert_true(player_message_from_midi(&stroke, 77, &message));
  assert_true(message.frame == 77 && message.type == PLAYER_EVENT);
  assert_true(message.event.type == TABOR_EVENT_STRIKE && message.event.velocity == 2);
  const MidiAction gain = {.type = MIDI_ACTION_GAIN, .value = 0.3};
  assert_true(player_message_from_midi(&gain, 5, &message));
  assert_true(message.type == PLAYER_EXPRESSION && message.value == 0.3 && message.frame == 5);
  const MidiAction hush = {.type = MIDI_ACTION_SILENCE};
  assert_true(player_message_from_midi(&hush, 9, &message));
  assert_true(message.type == PLAYER_EVENT && message.event.type == TABOR_EVENT_SILENCE);
  const MidiAction preset = {.type = MIDI_ACTION_PRESET, .preset = 1};
  assert_false(player_message_from_midi(&preset, 9, &message));
}

static int set_up(void **state) {
  (void)state;
  TaborModelOptions options;
  assert_int_equal(tabor_drum_def_preset(&def, "snare-14x5.5", NULL), TABOR_OK);
  def.quality.two_way_bandwidth = 600;
  def.quality.bandwidth = 1200;
  def.quality.wire_points = 8;
  def.wires.count = 2;
  tabor_model_options_default(&options);
  options.sample_rate = RATE;
  options.quality = TABOR_QUALITY_DRAFT;
  assert_int_equal(tabor_model_create(&def, &options, &model, NULL), TABOR_OK);
  return 0;
}

static int tear_down(void **state) {
  (void)state;
  tabor_model_release(model);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(silences_at_each_frame_of_a_block),
    cmocka_unit_test(a_silence_ends_what_rings_in_the_room),
    cmocka_unit_test(a_room_answers),
    cmocka_unit_test(a_room_follows_another),
    cmocka_unit_test(a_room_too_many_is_cut),
    cmocka_unit_test(messages_act_at_their_frames),
    cmocka_unit_test(crowds_act_in_order),
    cmocka_unit_test(a_stroke_behind_a_crowd_keeps_its_frame),
    cmocka_unit_test(gain_and_expression_multiply),
    cmocka_unit_test(a_rest_is_a_new_beginning),
    cmocka_unit_test(strikers_are_those_of_the_model),
    cmocka_unit_test(unheard_outputs_are_silent),
    cmocka_unit_test(without_a_drum_there_is_silence),
    cmocka_unit_test(a_kit_plays_with_its_samples_in_any_blocks),
    cmocka_unit_test(actions_become_messages),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
