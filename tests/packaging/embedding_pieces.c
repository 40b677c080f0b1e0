/* SPDX-License-Identifier: MIT */
/* Runs what docs/embedding.md shows piece by piece; test_embedding.sh extracts it to pieces.c. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tabor/tabor.h>

#include "pieces.c"

enum { FRAMES = 2400 };

static const double rounding = 1e-9; /* of the balance, relative; some 1e-12 in practice */

static void require(bool holds, const char *what) {
  if (holds) return;
  (void)fprintf(stderr, "embedding_pieces: not so: %s\n", what);
  exit(1);
}

static void play(TaborDrum *drum, float *sound) {
  const TaborEvent strike = {.type = TABOR_EVENT_STRIKE, .velocity = 3, .radius = 0.04};
  float *outputs[TABOR_MAX_MICS] = {sound};
  tabor_drum_process(drum, &strike, 1, outputs, FRAMES);
}

/* A drum without the room, beside it with the room: the same, and something more. */
static void a_room_adds_to_its_drum(TaborDrum *drum, TaborModel *model) {
  static float left[FRAMES], right[FRAMES], dry[FRAMES], unheard[FRAMES];
  TaborDrumDef def = *tabor_model_definition(model);
  TaborModelInfo info;
  tabor_model_info(model, &info);
  def.room.kind = TABOR_ROOM_BOOTH;
  TaborRoom *room;
  require(tabor_room_create(&def, info.sample_rate, NULL, &room, NULL) == TABOR_OK, "a room");
  TaborRoomInfo facts;
  tabor_room_info(room, &facts);
  TaborDrum *const copy = copy_of(drum, model);
  float *outputs[TABOR_MAX_MICS] = {NULL};
  outputs[facts.feed[0]] = dry;
  outputs[facts.feed[1]] = unheard;
  tabor_drum_process(copy, NULL, 0, outputs, FRAMES);
  play_in_room(drum, room, left, right, FRAMES);
  require(memcmp(left, dry, sizeof dry) != 0 && !tabor_room_is_silent(room), "a room is heard");
  tabor_drum_destroy(copy);
  tabor_room_destroy(room);
}

static void copies_go_on_alike(TaborDrum *drum, TaborModel *model) {
  static float a[FRAMES], b[FRAMES];
  TaborDrum *const copy = copy_of(drum, model);
  require(copy != NULL, "a drum can be copied");
  play(drum, a);
  play(copy, b);
  require(a[FRAMES - 1] != 0 && memcmp(a, b, sizeof a) == 0, "a copy sounds the same");
  tabor_drum_destroy(copy);
}

static void a_view_sees_the_head(TaborDrum *drum, TaborModel *model) {
  TaborView *const view = prepare_view(model);
  TaborProbe probe;
  require(view != NULL, "a view can be made");
  tabor_drum_probe(drum, &probe);
  require(fabs(look_at_centre(drum, view) - probe.head) < 1e-4, "the view is near the probe");
  tabor_view_destroy(view);
}

static void tension_is_swapped(TaborDrum *drum, TaborModel *model) {
  static float sound[FRAMES];
  float *outputs[TABOR_MAX_MICS] = {sound};
  TaborModel *tighter = NULL;
  TaborSwap *const swap = prepare_tension(model, "3000", &tighter);
  require(swap != NULL, "a swap can be prepared");
  require(!tabor_swap_done(swap), "a swap that was not sent is not done");
  play_swap(drum, swap, outputs, FRAMES);
  require(tabor_drum_model(drum) == tighter, "the drum is on the new model");
  require(clean_up(swap), "the swap is done");
  play(drum, sound);
  require(fabs(left_over(drum)) < rounding, "the ledger closes");
  tabor_model_release(tighter);
}

int main(void) {
  static float sound[FRAMES];
  TaborDrumDef def;
  TaborModel *model = NULL;
  TaborDrum *drum = NULL;
  require(tabor_drum_def_preset(&def, "tabor", NULL) == TABOR_OK &&
            tabor_model_create(&def, NULL, &model, NULL) == TABOR_OK &&
            tabor_drum_create(model, &drum, NULL) == TABOR_OK,
          "a drum can be made");
  require(left_over(drum) == 0, "nothing came in, nothing is left over");
  play(drum, sound);
  require(fabs(left_over(drum)) < rounding, "the ledger closes");
  copies_go_on_alike(drum, model);
  a_room_adds_to_its_drum(drum, model);
  a_view_sees_the_head(drum, model);
  tension_is_swapped(drum, model);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return 0;
}
