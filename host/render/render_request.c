/* SPDX-License-Identifier: MIT */
#include "render/render_request.h"

#include <stdlib.h>
#include <string.h>

void render_request_clear(RenderRequest *request) {
  memset(request, 0, sizeof *request);
  request->trace = OUTPUT_FILE_NONE;
  for (uint32_t i = 0; i < SOUND_FILES_MOST; i++) request->outputs[i] = OUTPUT_FILE_NONE;
}

void render_request_set_kit(RenderRequest *request, const TaborKitDef *kit) {
  request->kit = kit;
  request->preset = kit->name;
  request->def = kit->drum[0].def;
}

static void free_outputs(RenderRequest *request) {
  for (uint32_t i = 0; i < SOUND_FILES_MOST; i++) {
    output_discard(&request->outputs[i]);
    free(request->names[i]);
    request->names[i] = NULL;
  }
  output_discard(&request->trace);
}

void render_request_free(RenderRequest *request) {
  free_outputs(request);
  strokes_free(&request->strokes);
  midi_song_free(&request->song);
  kit_song_free(&request->kit_song);
  free(request->kit_midi);
  free(request->own_kit);
  request->kit_midi = NULL;
  request->own_kit = NULL;
  replay_free(&request->replay);
  sound_input_free(&request->input);
}

/* The later of a frame, the song's last and that of the sound from outside. */
static uint32_t or_song_end(const RenderRequest *request, uint32_t frame) {
  const MidiSong *const song = &request->song;
  const uint32_t last = song->count > 0 ? song->items[song->count - 1].frame : 0;
  const uint32_t heard = request->input.count > 0 ? request->input.count - 1 : 0;
  const uint32_t later = request->kit ? request->kit_song.last_frame : frame > last ? frame : last;
  return later > heard ? later : heard;
}

uint32_t render_request_last_frame(const RenderRequest *request) {
  return or_song_end(request, strokes_last_frame(&request->strokes));
}

uint32_t render_request_last_stroke(const RenderRequest *request) {
  if (request->kit) return kit_song_last_stroke(&request->kit_song);
  return or_song_end(request, strokes_last_stroke(&request->strokes));
}
