/* SPDX-License-Identifier: MIT */
/* What drums, kits and definitions for JavaScript (glue.c, kit_glue.c, definition_glue.c) have in common. */
#ifndef TABOR_WEB_GLUE_H
#define TABOR_WEB_GLUE_H

#include "midi/midi_to_events.h"
#include "tabor/tabor.h"

enum { BLOCK = 128, MOST_EVENTS = 64 };

#define EXPORT(name) __attribute__((export_name(name)))
#define IMPORT(name) __attribute__((import_module("tabor"), import_name(name)))

/* Hears how far a model is, 0 to 1. False ends the build. */
IMPORT("progress") bool report_progress(double done);

/* What a build may take at most by its estimate (TaborModelOptions): time [s] on a server of 2024, and memory. */
typedef struct WebLimit {
  double seconds, bytes;
} WebLimit;

/* What a MIDI message or an event of a file does, as numbers for JavaScript. */
typedef struct WebMidiAction {
  double kind;                     /* a WebMidiKind */
  double drum;                     /* of a kit */
  double value;                    /* speed of the stick [m/s]; position of the strainer */
  double radius, angle, technique; /* of a stroke [m], [deg] */
  double frame;                    /* of a file's event, from its beginning */
} WebMidiAction;

typedef enum WebMidiKind { WEB_MIDI_NOTHING, WEB_MIDI_STROKE, WEB_MIDI_STRAINER } WebMidiKind;

/* The action of an event that a message or a file gave; WEB_MIDI_NOTHING for what JavaScript does not play: pressure, grip, gain. */
WebMidiAction web_midi_action(uint32_t drum, const TaborEvent *event);

MidiMessage web_midi_message(uint32_t status, uint32_t first, uint32_t second);

/* Index of the striker with which a drum is struck unless another one is named. */
uint32_t web_definition_own_striker(const TaborDrumDef *def);

#endif
