/* SPDX-License-Identifier: MIT */
/* room-response KIND SECONDS: what the microphones left and right hear of a room at 48 kHz when the
 * drum is an impulse at the left feed, as pairs of floats on standard output. For
 * tools/docs/room-picture. */
#include <stdio.h>
#include <stdlib.h>
#include <tabor/tabor.h>

enum { RATE = 48000 };

static TaborRoom *create(const char *kind) {
  TaborDrumDef def;
  TaborRoom *room;
  TaborError error;
  if (tabor_drum_def_preset(&def, "snare-14x5.5", &error) == TABOR_OK &&
      tabor_drum_def_set(&def, "room.kind", kind, &error) == TABOR_OK &&
      tabor_room_create(&def, RATE, NULL, &room, &error) == TABOR_OK) {
    return room;
  }
  (void)fprintf(stderr, "room-response: %s\n", error.message);
  exit(1);
}

int main(int count, char **arguments) {
  if (count != 3) {
    (void)fputs("usage: room-response KIND SECONDS\n", stderr);
    return 2;
  }
  TaborRoom *const room = create(arguments[1]);
  TaborRoomInfo info;
  tabor_room_info(room, &info);
  const long frames = (long)(strtod(arguments[2], NULL) * RATE);
  float impulse = 1.0f;
  for (long frame = 0; frame < frames; frame++) {
    float pair[2] = {0.0f, 0.0f};
    const float *dry[TABOR_MAX_MICS] = {NULL};
    float *outputs[TABOR_MAX_MICS] = {NULL};
    dry[info.feed[0]] = &impulse;
    outputs[info.feed[0]] = &pair[0];
    outputs[info.feed[1]] = &pair[1];
    tabor_room_process(room, dry, outputs, 1);
    impulse = 0.0f;
    (void)fwrite(pair, sizeof pair, 1, stdout);
  }
  tabor_room_destroy(room);
  return ferror(stdout) || fflush(stdout) ? 1 : 0;
}
