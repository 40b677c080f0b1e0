/* SPDX-License-Identifier: MIT */
/**
 * @file ports.h
 * The ports of the two plugins.
 *
 *     0                 MIDI
 *     1 ...             outputs: left and right, or one per microphone
 *     then              freewheel, ready
 *     then              knobs, in the order of knob_ports; in the multi-output plugin the output of the
 *                       microphone inside stands among them, at PORT_INSIDE, where it was the last port once
 */
#ifndef TABOR_LV2_PORTS_H
#define TABOR_LV2_PORTS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/realtime.h"
#include "plugin/knobs.h"

typedef enum PortKind {
  PORT_EVENTS,
  PORT_OUTPUT, /**< audio; index: the channel */
  PORT_FREEWHEEL,
  PORT_READY,
  PORT_KNOB, /**< index: a KnobId */
  PORT_NONE  /**< past the last */
} PortKind;

typedef struct Port {
  PortKind kind;
  uint32_t index;
} Port;

#define PORT_INSIDE 14 /**< knobs of the multi-output plugin before the output inside */

/** Number of audio outputs of a plugin. */
static inline uint32_t port_outputs(bool stereo) { return stereo ? 2 : 7; }

/** Port number @p number of the stereo or the multi-output plugin. */
static inline Port port_at(bool stereo, uint32_t number) REALTIME {
  const uint32_t outputs = stereo ? 2 : 6; /* in one row */
  if (number == 0) return (Port){PORT_EVENTS, 0};
  if (number <= outputs) return (Port){PORT_OUTPUT, number - 1};
  if (number == outputs + 1) return (Port){PORT_FREEWHEEL, 0};
  if (number == outputs + 2) return (Port){PORT_READY, 0};
  const uint32_t place = number - outputs - 3;
  if (!stereo && place == PORT_INSIDE) return (Port){PORT_OUTPUT, outputs};
  const KnobId knob = knob_at(stereo, place - (!stereo && place > PORT_INSIDE));
  return (Port){knob < KNOB_COUNT ? PORT_KNOB : PORT_NONE, knob};
}

#endif
