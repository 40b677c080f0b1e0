/* SPDX-License-Identifier: MIT */
/**
 * @file portaudio_devices.h
 * PortAudio's outputs, by name: its numbers change from run to run.
 */
#ifndef TABOR_HOST_PORTAUDIO_DEVICES_H
#define TABOR_HOST_PORTAUDIO_DEVICES_H

#include <portaudio.h>
#include <signal.h>

#include "base/message.h"

typedef struct OutputDevice {
  PaDeviceIndex index;
  char label[TABOR_TEXT_SIZE]; /**< "JACK: system" */
  uint32_t channels;
  double rate;    /**< its own [Hz] */
  double latency; /**< the least that it promises [s] */
  bool is_jack;   /**< JACK decides on rate and block */
  bool is_default;
} OutputDevice;

/** Starts PortAudio, without the lines that its libraries print where there is no sound card. */
Outcome portaudio_start(void);
/** Ends PortAudio. May hang where a sound server has died. */
void portaudio_end(void);
/** Output @p index, or false past the last. */
bool portaudio_output(uint32_t index, OutputDevice *device);
/**
 * The output with the label @p name, or whose name alone or host API alone that is; NULL: the default,
 * JACK's where its server runs. Fails with a list of those that there are.
 */
Outcome portaudio_find(const char *name, OutputDevice *device);

/** What portaudio_enter() has changed. */
typedef struct PortaudioCare {
  int muted;
  struct sigaction before;
} PortaudioCare;

/**
 * Goes around what speaks to a sound server before there is anything to lose. What libraries print is not
 * seen; and PortAudio asserts that JACK does as it is told, which a server that has just died does not: that
 * ends the program with one line and the status 1, not with an abort that says nothing. One thread at a time.
 */
void portaudio_enter(PortaudioCare *care);
void portaudio_leave(const PortaudioCare *care);

#endif
