/* SPDX-License-Identifier: MIT */
/**
 * @file portaudio_devices.h
 * PortAudio's outputs, found by name, because PortAudio's numbers change from run to run.
 */
#ifndef TABOR_HOST_PORTAUDIO_DEVICES_H
#define TABOR_HOST_PORTAUDIO_DEVICES_H

#include <portaudio.h>

#include "base/message.h"
#include "platform/signals.h"

typedef struct OutputDevice {
  PaDeviceIndex index;
  char label[TABOR_TEXT_SIZE]; /**< "JACK: system" */
  uint32_t channels;
  double rate;    /**< the device's default rate [Hz] */
  double latency; /**< lowest latency that the device reports [s] */
  bool is_jack;   /**< JACK sets rate and block size */
  bool is_default;
} OutputDevice;

/** Starts PortAudio; suppresses the lines that its libraries print without a sound card. */
Outcome portaudio_start(void);
/** Ends PortAudio. May hang if a sound server has died. */
void portaudio_end(void);
/** Describes output @p index; false past the last. */
bool portaudio_output(uint32_t index, OutputDevice *device);
/**
 * Finds the output whose label, name or host API is @p name. NULL: the default output, which is
 * JACK's if its server runs, or WASAPI's. A failure lists the available outputs.
 */
Outcome portaudio_find(const char *name, OutputDevice *device);

/** State to restore after portaudio_enter(). */
typedef struct PortaudioCare {
  int muted;
  SignalHandler before;
} PortaudioCare;

/**
 * Call before, and portaudio_leave() after, calls that talk to a sound server while there is
 * nothing to lose. In between, output of libraries is suppressed. PortAudio asserts that JACK calls
 * succeed, so it aborts if the server has just died; here such an abort ends the program with one
 * line and the status 1. One thread at a time.
 */
void portaudio_enter(PortaudioCare *care);
void portaudio_leave(const PortaudioCare *care);

#endif
