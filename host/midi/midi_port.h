/* SPDX-License-Identifier: MIT */
/**
 * @file midi_port.h
 * MIDI inputs through RtMidi, for every interface that works on this machine: ALSA's sequencer,
 * JACK, and the interfaces of other systems.
 *
 * RtMidi prints failures to standard error, so an interface is used only if it is known to work.
 * All functions are for one thread that may wait.
 */
#ifndef TABOR_HOST_MIDI_PORT_H
#define TABOR_HOST_MIDI_PORT_H

#include <stdbool.h>
#include <stddef.h>

#define MIDI_PORT_NAME 256 /**< size of a name with its terminator [bytes] */
#define MIDI_PORT_APIS 8

/** Interface and name of a port: "JACK: system:midi_capture_1". */
typedef struct MidiPortName {
  int api;
  char text[MIDI_PORT_NAME]; /**< the port's name, without the interface's */
} MidiPortName;

/** An open input. */
typedef struct RtMidiWrapper MidiPort;

/** Interfaces, each with the object that lists its ports. All members zero is an empty list. */
typedef struct MidiPorts {
  struct {
    int api;
    MidiPort *lister; /**< NULL while the interface does not work */
  } apis[MIDI_PORT_APIS];
  size_t count;
} MidiPorts;

/** Receives a message of @p size bytes, @p later [s] after the previous one. Called on a thread of
 * RtMidi's. */
typedef void MidiPortFn(double later, const unsigned char *bytes, size_t size, void *context);

/** Finds the interfaces; silences libraries that print. */
void midi_ports_begin(MidiPorts *ports);
/** Checks for interfaces that have started to work, such as a new JACK server. */
void midi_ports_refresh(MidiPorts *ports);
/** Fills in at most @p most names of inputs other than our own; returns how many. */
size_t midi_ports_list(MidiPorts *ports, MidiPortName *names, size_t most);
void midi_ports_end(MidiPorts *ports);

/** Name of an interface, such as "JACK". */
const char *midi_port_api(int api);
/** True for a port of an instrument: not of another program, and not a through port. */
bool midi_port_is_hardware(const MidiPortName *name);
/** Opens the input @p name; NULL if it has disappeared or does not open. */
MidiPort *midi_port_open(MidiPorts *ports, const MidiPortName *name, MidiPortFn *receive,
                         void *context);
/** Opens an input of our own in interface number @p index, to which other programs may connect. */
MidiPort *midi_port_open_own(const MidiPorts *ports, size_t index, MidiPortFn *receive,
                             void *context);
void midi_port_close(MidiPort *port);

#endif
