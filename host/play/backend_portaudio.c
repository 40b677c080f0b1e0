/* SPDX-License-Identifier: MIT */
/*
 * Output to devices through PortAudio (ALSA, JACK). PortAudio's thread requests the sound.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/mute_stderr.h"
#include "platform/clock.h"
#include "play/backend.h"
#include "play/portaudio_devices.h"

#define STEREO 2u

struct BackendStream {
  PaStream *stream;
  BackendClient client;
};

static int ask_client(const void *input, void *output, unsigned long frames,
                      const PaStreamCallbackTimeInfo *times, PaStreamCallbackFlags flags,
                      void *context) {
  const BackendClient *const client = &((BackendStream *)context)->client;
  const double now = stopwatch_seconds(CLOCK_MONOTONIC);
  (void)input;
  (void)times;
  (void)client->process(client->context, output, (uint32_t)frames, now,
                        (flags & paOutputUnderflow) != 0);
  return paContinue; /* at the end silence, until the stream is stopped */
}

/* A single channel goes to a pair, if the device has one. */
static Outcome choose_width(const OutputDevice *device, const BackendRequest *request,
                            uint32_t *width) {
  *width = request->channels > STEREO ? request->channels : STEREO;
  if (device->channels < *width) *width = device->channels;
  if (*width >= request->channels) return OUTCOME_OK;
  return fail("'%s' has %u channels, %u were asked for", device->label, (unsigned)device->channels,
              (unsigned)request->channels);
}

static PaError open_at(BackendStream *stream, const OutputDevice *device, uint32_t width,
                       uint32_t buffer, double rate) {
  const PaStreamParameters output = {.device = device->index,
                                     .channelCount = (int)width,
                                     .sampleFormat = paFloat32,
                                     .suggestedLatency = 2 * buffer / rate};
  /* JACK has its own blocks: others would only be cut from those, and come in bursts. */
  const unsigned long frames = device->is_jack ? paFramesPerBufferUnspecified : buffer;
  PortaudioCare care;
  portaudio_enter(&care);
  const PaError error =
    Pa_OpenStream(&stream->stream, NULL, &output, rate, frames, paNoFlag, ask_client, stream);
  portaudio_leave(&care);
  return error;
}

/* At the rate that is wished for, or else the device's own. */
static Outcome open_device(BackendStream *stream, const OutputDevice *device,
                           const BackendRequest *request, BackendFacts *facts) {
  const double wished = request->rate > 0 ? request->rate : device->rate;
  const uint32_t width = facts->width;
  PaError error = open_at(stream, device, width, request->buffer, wished);
  facts->rate = wished;
  if (error == paInvalidSampleRate && wished != device->rate) {
    error = open_at(stream, device, width, request->buffer, device->rate);
    facts->rate = device->rate;
  }
  if (error == paNoError) return OUTCOME_OK;
  const PaHostErrorInfo *const host = Pa_GetLastHostErrorInfo();
  const bool unexpected = error == paUnanticipatedHostError && host && host->errorText;
  return fail("cannot open '%s': %s", device->label,
              unexpected ? host->errorText : Pa_GetErrorText(error));
}

static Outcome open_stream(const BackendRequest *request, BackendStream **opened,
                           BackendFacts *facts) {
  BackendStream *const stream = calloc(1, sizeof *stream);
  OutputDevice device;
  *opened = NULL;
  *facts = (BackendFacts){0};
  if (!stream) return fail_memory();
  Outcome outcome = portaudio_start();
  if (outcome != OUTCOME_OK) {
    free(stream);
    return outcome;
  }
  *opened = stream;
  outcome = portaudio_find(request->device, &device);
  if (outcome == OUTCOME_OK) outcome = choose_width(&device, request, &facts->width);
  if (outcome == OUTCOME_OK) outcome = open_device(stream, &device, request, facts);
  if (outcome != OUTCOME_OK) return outcome;
  (void)snprintf(facts->device, sizeof facts->device, "%s", device.label);
  facts->buffer = device.is_jack ? 0 : request->buffer;
  facts->latency = Pa_GetStreamInfo(stream->stream)->outputLatency;
  return OUTCOME_OK;
}

static Outcome start(BackendStream *stream, const BackendClient *client) {
  stream->client = *client;
  const int muted = mute_stderr_begin();
  const PaError error = Pa_StartStream(stream->stream);
  mute_stderr_end(muted);
  if (error == paNoError) return OUTCOME_OK;
  return fail("cannot start the sound: %s", Pa_GetErrorText(error));
}

static bool is_running(BackendStream *stream) { return Pa_IsStreamActive(stream->stream) == 1; }

static void close_stream(BackendStream *stream) {
  if (!stream) return;
  if (stream->stream) (void)Pa_CloseStream(stream->stream);
  portaudio_end();
  free(stream);
}

const Backend backend_portaudio = {
  .name = "portaudio",
  .open = open_stream,
  .start = start,
  .is_running = is_running,
  .close = close_stream,
};
