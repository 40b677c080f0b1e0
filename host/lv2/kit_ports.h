/* SPDX-License-Identifier: MIT */
/**
 * @file kit_ports.h
 * The ports of Tabor Kit.
 *
 *     0                 MIDI
 *     1 ...             outputs: left and right of the mix, then of each of the first drums
 *     then              freewheel, ready
 *     then              knobs, in the order of kit_knobs, which grows at its end
 */
#ifndef TABOR_LV2_KIT_PORTS_H
#define TABOR_LV2_KIT_PORTS_H

#include "lv2/ports.h"
#include "plugin/kit_knobs.h"

#define KIT_PORT_OUTPUTS (2 + 2 * KIT_KNOB_DRUMS)

/** Port number @p number; the index of a knob is a KitKnobId. */
static inline Port kit_port_at(uint32_t number) REALTIME {
  if (number == 0) return (Port){PORT_EVENTS, 0};
  if (number <= KIT_PORT_OUTPUTS) return (Port){PORT_OUTPUT, number - 1};
  if (number == KIT_PORT_OUTPUTS + 1) return (Port){PORT_FREEWHEEL, 0};
  if (number == KIT_PORT_OUTPUTS + 2) return (Port){PORT_READY, 0};
  const uint32_t knob = number - KIT_PORT_OUTPUTS - 3;
  return (Port){knob < KIT_KNOB_COUNT ? PORT_KNOB : PORT_NONE, knob};
}

#endif
