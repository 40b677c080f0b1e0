/* SPDX-License-Identifier: MIT */
/**
 * @file player_message.h
 * What a drum or kit that is played is asked to do, and at which frame: the one language of render,
 * play and plugins.
 */
#ifndef TABOR_HOST_PLAYER_MESSAGE_H
#define TABOR_HOST_PLAYER_MESSAGE_H

#include <tabor/kit.h>

#include "midi/midi_to_events.h"

/** value of a message's frame: as soon as possible, never counted as late */
#define PLAYER_NOW 0
#define PLAYER_CHANNELS 64      /**< most channels */
#define PLAYER_NO_MIC UINT8_MAX /**< the channel has no microphone: it is silent */

typedef enum PlayerMessageType {
  PLAYER_EVENT, /**< event: any but swaps, and gains of a single drum, which have types of their own
                 */
  PLAYER_MODEL, /**< event: a swap, with its outputs chosen; see strikers */
  PLAYER_GAIN,  /**< value: output gain, a factor, reached over 5 ms */
  PLAYER_EXPRESSION /**< value: a second such factor, set by MIDI */
} PlayerMessageType;

typedef struct PlayerMessage {
  uint64_t frame; /**< since playing started, or PLAYER_NOW */
  uint32_t type;  /**< a PlayerMessageType */
  uint32_t
    drum; /**< of a kit, or TABOR_KIT_ALL, or TABOR_KIT_NOTE and a note: of events and models */
  uint32_t strikers; /**< number of strikers of the new model */
  uint32_t model;    /**< number of the new model in a log (log_line.h) */
  double value;
  TaborEvent event; /**< its own frame is ignored */
} PlayerMessage;

/** The message for an event of a kit, whose own frame it has. */
static inline PlayerMessage player_message_from_kit(const TaborKitEvent *event) REALTIME;
static inline PlayerMessage player_message_from_kit(const TaborKitEvent *event) {
  return (PlayerMessage){
    .frame = event->event.frame, .type = PLAYER_EVENT, .drum = event->drum, .event = event->event};
}
/** The message for a MIDI action at @p frame. False for a preset, whose model has to be built
 * first. */
bool player_message_from_midi(const MidiAction *action, uint64_t frame,
                              PlayerMessage *message) REALTIME;

#endif
