/* SPDX-License-Identifier: MIT */
/**
 * @file midi_port.h
 * MIDI inputs as RtMidi has them, of every interface that works on this machine: ALSA's sequencer,
 * JACK, and those of other systems.
 *
 * RtMidi writes to standard error what fails; so an interface is asked for only where it is known to
 * work. All functions are for one thread that may wait.
 */
#ifndef TABOR_HOST_MIDI_PORT_H
#define TABOR_HOST_MIDI_PORT_H

#include <stdbool.h>
#include <stddef.h>

#define MIDI_PORT_NAME 256 /**< bytes of a name, with its terminator */
#define MIDI_PORT_APIS 8

/** What a port is called, and where: "JACK: system:midi_capture_1". */
typedef struct MidiPortName {
  int api;
  char text[MIDI_PORT_NAME]; /**< the interface's, without it */
} MidiPortName;

/** An open input. */
typedef struct RtMidiWrapper MidiPort;

/** Interfaces and what lists their ports. All zero is none. */
typedef struct MidiPorts {
  struct {
    int api;
    MidiPort *lister; /**< NULL while the interface does not work */
  } apis[MIDI_PORT_APIS];
  size_t count;
} MidiPorts;

/** A message of @p size bytes, @p later [s] than the one before. Called on a thread of RtMidi's. */
typedef void MidiPortFn(double later, const unsigned char *bytes, size_t size, void *context);

/** Finds the interfaces; silences those that talk. */
void midi_ports_begin(MidiPorts *ports);
/** Looks for interfaces that have begun to work, as a JACK server that was started. */
void midi_ports_refresh(MidiPorts *ports);
/** Fills in at most @p most names of inputs other than our own; returns how many. */
size_t midi_ports_list(MidiPorts *ports, MidiPortName *names, size_t most);
void midi_ports_end(MidiPorts *ports);

/** "JACK" and the like. */
const char *midi_port_api(int api);
/** True if it is one that a person plays on: no other program's, and nothing that passes on. */
bool midi_port_is_hardware(const MidiPortName *name);
/** Opens the input @p name; NULL if it is gone or does not open. */
MidiPort *midi_port_open(MidiPorts *ports, const MidiPortName *name, MidiPortFn *receive,
                         void *context);
/** Opens an input of our own in interface number @p index, to which others may connect. */
MidiPort *midi_port_open_own(const MidiPorts *ports, size_t index, MidiPortFn *receive,
                             void *context);
void midi_port_close(MidiPort *port);

#endif
