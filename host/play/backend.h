/* SPDX-License-Identifier: MIT */
/**
 * @file backend.h
 * Where sound goes: one interface, several implementations.
 */
#ifndef TABOR_HOST_BACKEND_H
#define TABOR_HOST_BACKEND_H

#include "base/message.h"

#define BACKEND_WIDEST 64 /* channels of a device that are used at most */

/** What the user asked for. */
typedef struct BackendRequest {
  const char *device; /**< "HOST API: NAME", or NULL for the default */
  double rate;        /**< [Hz], or 0 for the device's */
  uint32_t buffer;    /**< frames at once */
  uint32_t channels;  /**< at least so many; a single one is sent to a stereo pair */
} BackendRequest;

/** What there is. */
typedef struct BackendFacts {
  char device[TABOR_TEXT_SIZE]; /**< "JACK: system" */
  double rate;                  /**< [Hz] */
  uint32_t buffer;              /**< frames asked for at once, or 0: the first block will show */
  uint32_t width;               /**< channels */
  double latency;               /**< from asking for a block to its sound [s] */
} BackendFacts;

/** Whom a backend asks for sound. Both functions run on its thread. */
typedef struct BackendClient {
  /** Fills @p frames frames of all channels, interleaved, asked for at @p now [s of CLOCK_MONOTONIC];
   * @p gap: the device has run dry before. Real-time safe. False: there is no more. */
  bool (*process)(void *context, float *samples, uint32_t frames, double now, bool gap);
  /** Backends that wait call this before each block; may take any time. False: stop. */
  bool (*prepare)(void *context, uint32_t frames);
  void *context;
} BackendClient;

typedef struct BackendStream BackendStream; /* each backend's own */

typedef struct Backend {
  const char *name;
  bool waits; /**< there is no clock that sound must keep up with */
  Outcome (*open)(const BackendRequest *request, BackendStream **stream, BackendFacts *facts);
  /** Starts to ask @p client, which must stay until the stream is closed. */
  Outcome (*start)(BackendStream *stream, const BackendClient *client);
  /** False once it asks no more: the client said so, or the device is gone. */
  bool (*is_running)(BackendStream *stream);
  /** Stops and frees; NULL is allowed. May hang where a sound server has died. */
  void (*close)(BackendStream *stream);
} Backend;

extern const Backend backend_portaudio; /* backend_portaudio.c */
extern const Backend backend_null;      /* backend_thread.c: paced by a clock, and not heard */
extern const Backend backend_file;      /* backend_thread.c: as fast as can be computed */

/** The backend called @p name; refuses a name that is none. */
Outcome backend_find(const char *name, const Backend **backend);

#endif
