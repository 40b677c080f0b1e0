/* SPDX-License-Identifier: MIT */
/**
 * @file play_glue.c
 * What happens to an instrument, and its sound, on the audio thread or wherever it is played.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "glue.h"

/* ---- messages ------------------------------------------------------------------------------- */

enum { FIRST_ROOM = 256 };

static bool grow(WebInstrument *web, uint32_t room) {
  PlayerMessage *const grown = realloc(web->messages, room * sizeof *grown);
  if (!grown) return false;
  web->messages = grown;
  web->message_room = room;
  return true;
}

bool web_make_room(WebInstrument *web) { return grow(web, FIRST_ROOM); }

bool web_add(WebInstrument *web, uint32_t frame, const PlayerMessage *message) {
  if (web->message_count == web->message_room && !grow(web, 2 * web->message_room)) return false;
  PlayerMessage *const added = &web->messages[web->message_count++];
  *added = *message;
  added->frame = web->player.position + frame;
  return true;
}

bool web_add_event(WebInstrument *web, uint32_t drum, const TaborEvent *event) {
  return web_add(web, event->frame,
                 &(PlayerMessage){.type = PLAYER_EVENT, .drum = drum, .event = *event});
}

/* A DrumSourceFn. */
static bool next(void *source, uint64_t end, PlayerMessage *message) {
  WebInstrument *const web = source;
  if (web->taken == web->message_count || web->messages[web->taken].frame >= end) return false;
  *message = web->messages[web->taken++];
  return true;
}

/* A stroke at a frame of the next block, @p radius [m] from the centre. A @p striker below 0 is the
 * drum's own. Messages come in order of their frames. False, as of the functions that follow, if
 * there is no memory. */
EXPORT("instrument_strike")
bool web_instrument_strike(WebInstrument *web, uint32_t drum, uint32_t frame, double velocity,
                           double radius, double angle, uint32_t technique, int32_t striker) {
  if (drum >= web->def.drum_count) return true;
  const uint32_t own = web_definition_own_striker(web_definition(web, drum));
  const TaborEvent event = {.type = TABOR_EVENT_STRIKE,
                            .frame = frame,
                            .striker = striker < 0 ? own : (uint32_t)striker,
                            .technique = technique,
                            .velocity = velocity,
                            .radius = radius,
                            .angle = angle};
  return web_add_event(web, drum, &event);
}

/* The number of a parameter that may change while a drum rings; 0 if there is none. */
EXPORT("live_parameter") uint32_t web_live_parameter(const char *key) {
  const TaborParameter *const parameter = tabor_parameter_find(key);
  return parameter && parameter->live ? parameter->id : 0;
}

/* Least, 0, or greatest, 1, value of a live parameter. */
EXPORT("parameter_bound") double web_parameter_bound(uint32_t id, uint32_t which) {
  const TaborParameter *parameter;
  for (uint32_t i = 0; (parameter = tabor_parameter(i)) != NULL; i++) {
    if (parameter->id == id) return which == 0 ? parameter->minimum : parameter->maximum;
  }
  return NAN;
}

/* Moves a live parameter of a drum at a frame of the next block; one of a microphone's has its @p
 * index. */
EXPORT("instrument_change")
bool web_instrument_change(WebInstrument *web, uint32_t drum, uint32_t frame, uint32_t parameter,
                           uint32_t index, double value) {
  const TaborEvent event = {.type = TABOR_EVENT_PARAMETER,
                            .frame = frame,
                            .parameter = parameter,
                            .index = index,
                            .value = value};
  return web_add_event(web, drum, &event);
}

/* Moves a value of a kit's mix, a TaborKitParameter [dB]. */
EXPORT("instrument_mix")
bool web_instrument_mix(WebInstrument *web, uint32_t frame, uint32_t parameter, double value) {
  return web_instrument_change(web, TABOR_KIT_MIX, frame, parameter, 0, value);
}

/* Puts the snares of all drums that have some on the head, 1, or off it, 0. */
EXPORT("instrument_set_strainer")
void web_instrument_set_strainer(WebInstrument *web, double strainer) {
  const uint32_t parameter = web_live_parameter("wires.strainer");
  for (uint32_t i = 0; i < web->def.drum_count; i++) {
    if (web_definition(web, i)->wires.count == 0) continue;
    (void)web_instrument_change(web, i, 0, parameter, 0, strainer);
  }
}

/* ---- sound ---------------------------------------------------------------------------------- */

static void play(WebInstrument *web, uint32_t at, uint32_t frames) {
  drum_player_play(&web->player, next, web, frames);
  for (uint32_t i = 0; i < web->channels; i++)
    memcpy(web->sound[i] + at, web->player.sound[web_output(web, i)], frames * sizeof(float));
}

static const float *finish(WebInstrument *web) {
  web->message_count = web->taken = 0;
  return web->sound[0];
}

/* The next frames, at most 128, of the first channel; each further channel begins 128 frames after
 * the one before. They stay until the next call. */
EXPORT("instrument_play")
const float *web_instrument_play(WebInstrument *web, uint32_t frames) {
  play(web, 0, frames);
  return finish(web);
}

/* The next 128 frames in the same way, with four pictures of a drum, one each 32 frames. The sound
 * does not depend on the division. */
EXPORT("instrument_film")
const float *web_instrument_film(WebInstrument *web, uint32_t drum) {
  enum { FRAMES = BLOCK / PICTURES };
  web->filmed = drum;
  for (uint32_t i = 0; i < PICTURES; i++) {
    play(web, i * FRAMES, FRAMES);
    web_take_picture(web, web->pictures + (size_t)i * web_picture_size(web, drum));
  }
  return finish(web);
}

/* Begins to listen for the end of a sound whose last event is at a frame. */
EXPORT("instrument_ring_out") void web_instrument_ring_out(WebInstrument *web, uint32_t last) {
  web->ring_out = ring_out_begin(0, last, web->rate);
}

/* True once the sound has died away, as `tabor render` has it, or has gone on for long enough. To
 * be asked every RING_OUT_BLOCK frames. */
EXPORT("instrument_is_over") bool web_instrument_is_over(WebInstrument *web) {
  return ring_out_is_over(&web->ring_out, &web->player);
}

/* ---- facts ---------------------------------------------------------------------------------- */

const TaborDrum *web_drum(const WebInstrument *web, uint32_t drum) {
  if (web->kit) return tabor_kit_drum(web->kit, drum);
  return drum == 0 ? web->drum : NULL;
}

/* The energy accounts of all drums in one [J], as numbers in the order of TaborLedger; until the
 * next call. */
EXPORT("instrument_ledger") const TaborLedger *web_instrument_ledger(WebInstrument *web) {
  drum_player_ledger(&web->player, &web->ledger);
  return &web->ledger;
}

/* Events that the engine did not carry out (TaborStatistics). */
EXPORT("instrument_dropped_events")
double web_instrument_dropped_events(const WebInstrument *web) {
  TaborStatistics statistics;
  drum_player_statistics(&web->player, &statistics);
  return (double)statistics.dropped_events;
}

/* Everything has died away, but perhaps in a drum's room. */
EXPORT("instrument_is_silent") bool web_instrument_is_silent(const WebInstrument *web) {
  return drum_player_is_silent(&web->player);
}

/* Energy of what a drum's room holds, of no unit; 0 if it is silent, and of a kit. */
EXPORT("room_energy") double web_room_energy(const WebInstrument *web) {
  return web->room.room ? tabor_room_energy(web->room.room) : 0;
}
