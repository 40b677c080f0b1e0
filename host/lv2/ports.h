/* SPDX-License-Identifier: MIT */
/**
 * @file ports.h
 * The ports of the plugins, whose numbers never change.
 *
 *     0                 MIDI
 *     1, 2              inputs of an effect
 *     then              outputs, a port for each channel
 *     then              freewheel, ready
 *     then              knobs, in the order of the instrument
 *
 * But in the plugin with an output per microphone the one inside stands among the knobs, after
 * PORT_INSIDE of them, where it was the last port once.
 */
#ifndef TABOR_LV2_PORTS_H
#define TABOR_LV2_PORTS_H

#include <math.h>

#include "plugin/instrument.h"

typedef enum PortKind {
  PORT_EVENTS,
  PORT_INPUT,  /**< audio; index: the side */
  PORT_OUTPUT, /**< audio; index: the channel */
  PORT_FREEWHEEL,
  PORT_READY,
  PORT_KNOB, /**< index: its id */
  PORT_NONE  /**< past the last */
} PortKind;

typedef struct Port {
  PortKind kind;
  uint32_t index;
} Port;

#define PORT_INSIDE 14 /**< knobs of the multi-output plugin before the output inside */

/**
 * Ports of pitches are logarithmic, so their range cannot begin at 0, where the knob is off: it
 * begins at the lowest pitch, which is off there, as is all below. Sessions from before have 0.
 */
static inline float port_minimum(const KnobRange *range) REALTIME {
  return range->least > 0 ? range->least : range->minimum;
}
/** The knob's value at a value of its port, and the port's at one of the knob. */
static inline float port_to_knob(const KnobRange *range, float value) REALTIME {
  if (range->least > 0 && value <= range->least) return range->minimum;
  return fminf(fmaxf(value, range->minimum), range->maximum);
}
static inline float port_of_knob(const KnobRange *range, float value) REALTIME {
  return fminf(fmaxf(value, port_minimum(range)), range->maximum);
}

/** Port number @p number of a plugin. */
static inline Port port_at(const InstrumentKind *kind, uint32_t number) REALTIME {
  const bool multi = kind->id == INSTRUMENT_MULTI;
  const uint32_t inputs = kind->has_input ? 2 : 0;
  const uint32_t outputs = multi ? kind->channels - 1 : kind->channels; /* in one row */
  if (number == 0) return (Port){PORT_EVENTS, 0};
  if (number <= inputs) return (Port){PORT_INPUT, number - 1};
  const uint32_t behind = number - inputs;
  if (behind <= outputs) return (Port){PORT_OUTPUT, behind - 1};
  if (behind == outputs + 1) return (Port){PORT_FREEWHEEL, 0};
  if (behind == outputs + 2) return (Port){PORT_READY, 0};
  const uint32_t place = behind - outputs - 3;
  if (multi && place == PORT_INSIDE) return (Port){PORT_OUTPUT, outputs};
  const uint32_t knob = instrument_knob_at(kind, place - (multi && place > PORT_INSIDE));
  return (Port){knob < kind->knob_count ? PORT_KNOB : PORT_NONE, knob};
}

#endif
