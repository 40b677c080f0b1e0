/* SPDX-License-Identifier: MIT */
/**
 * @file backend.h
 * Audio output: one interface, several implementations.
 */
#ifndef TABOR_HOST_BACKEND_H
#define TABOR_HOST_BACKEND_H

#include "base/options.h"

#define BACKEND_WIDEST 64 /* most channels of a device that are used */

/** The output that the user asked for. */
typedef struct BackendRequest {
  const char *device; /**< "HOST API: NAME", or NULL for the default */
  double rate;        /**< [Hz], or 0 for the device's own rate */
  uint32_t buffer;    /**< frames per block */
  uint32_t channels;  /**< smallest number; a single channel goes to a stereo pair */
} BackendRequest;

/** The output that was opened. */
typedef struct BackendFacts {
  char device[TABOR_TEXT_SIZE]; /**< "JACK: system" */
  double rate;                  /**< [Hz] */
  uint32_t buffer;              /**< frames per block, or 0: unknown until the first block */
  uint32_t width;               /**< channels */
  double latency;               /**< from the request for a block to its sound [s] */
} BackendFacts;

/** The source of sound for a backend. Both functions run on the backend's thread. */
typedef struct BackendClient {
  /** Fills @p frames frames of all channels, interleaved. @p now: time of the request [s of
   * CLOCK_MONOTONIC]. @p gap: the device had a dropout before. Real-time safe. False: the end. */
  bool (*process)(void *context, float *samples, uint32_t frames, double now, bool gap);
  /** Called before each block by backends that wait; may take any time. False: stop. */
  bool (*prepare)(void *context, uint32_t frames);
  void *context;
} BackendClient;

typedef struct BackendStream BackendStream; /* each backend defines its own */

typedef struct Backend {
  const char *name;
  bool waits; /**< sound has no deadline: the backend waits for it */
  Outcome (*open)(const BackendRequest *request, BackendStream **stream, BackendFacts *facts);
  /** Starts to request sound of @p client, which must live until the stream is closed. */
  Outcome (*start)(BackendStream *stream, const BackendClient *client);
  /** False once the requests have ended: the client returned false, or the device is gone. */
  bool (*is_running)(BackendStream *stream);
  /** Stops and frees the stream; NULL is allowed. May hang if a sound server has died. */
  void (*close)(BackendStream *stream);
} Backend;

extern const Backend backend_portaudio; /* backend_portaudio.c */
extern const Backend backend_null;      /* backend_thread.c: paced by a clock, inaudible */
extern const Backend backend_file;      /* backend_thread.c: as fast as possible */

/** Reads --backend, --device and --buffer, the latter two to @p request. Refuses an unknown
 * backend, and what does not go with it. */
Outcome backend_read(const Arguments *arguments, const Backend **backend, BackendRequest *request);

#endif
