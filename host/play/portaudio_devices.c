/* SPDX-License-Identifier: MIT */
#include "play/portaudio_devices.h"

#ifdef __linux__
#  include <pa_jack.h>
#endif
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "base/mute_stderr.h"

#define CLIENT "tabor" /* at JACK */
#define LISTED 600     /* bytes of names in a message at most */

/* ---- start and end -------------------------------------------------------------------------- */

static volatile sig_atomic_t voice; /* the standard error; a handler has no other way to know */

static void end_with_server(int number) {
  static const char text[] = "tabor: cannot use sound: its server went away\n";
  (void)number;
  (void)!write(voice, text, sizeof text - 1);
  _exit(OUTCOME_FAILED);
}

void portaudio_enter(PortaudioCare *care) {
  care->muted = mute_stderr_begin();
  voice = care->muted >= 0 ? care->muted : STDERR_FILENO;
  signals_take_abort(end_with_server, &care->before);
}

void portaudio_leave(const PortaudioCare *care) {
  signals_restore_abort(&care->before);
  mute_stderr_end(care->muted);
}

Outcome portaudio_start(void) {
  PortaudioCare care;
  portaudio_enter(&care);
#ifdef __linux__
  (void)PaJack_SetClientName(CLIENT);
#endif
  const PaError error = Pa_Initialize();
  portaudio_leave(&care);
  return error == paNoError ? OUTCOME_OK : fail("cannot use sound: %s", Pa_GetErrorText(error));
}

void portaudio_end(void) { (void)Pa_Terminate(); }

/* ---- devices -------------------------------------------------------------------------------- */

/* "JACK" for "JACK Audio Connection Kit", which nobody wants to type. */
static const char *api_name(const PaHostApiInfo *api) {
  return api->type == paJACK ? "JACK" : api->name;
}

/* JACK's where a server runs: who starts one wants its sound there. On Windows WASAPI's, which is
 * sooner heard than that of the multimedia interface. */
static PaDeviceIndex default_output(void) {
  static const PaHostApiTypeId preferred[] = {paJACK, paWASAPI};
  for (size_t i = 0; i < sizeof preferred / sizeof *preferred; i++) {
    const PaHostApiIndex api = Pa_HostApiTypeIdToHostApiIndex(preferred[i]);
    const PaHostApiInfo *const info = api >= 0 ? Pa_GetHostApiInfo(api) : NULL;
    if (info && info->defaultOutputDevice != paNoDevice) return info->defaultOutputDevice;
  }
  return Pa_GetDefaultOutputDevice();
}

static void describe(PaDeviceIndex index, const PaDeviceInfo *info, OutputDevice *device) {
  const PaHostApiInfo *const api = Pa_GetHostApiInfo(info->hostApi);
  *device = (OutputDevice){.index = index,
                           .channels = (uint32_t)info->maxOutputChannels,
                           .rate = info->defaultSampleRate,
                           .latency = info->defaultLowOutputLatency,
                           .is_jack = api->type == paJACK,
                           .is_default = index == default_output()};
  (void)snprintf(device->label, sizeof device->label, "%s: %s", api_name(api), info->name);
}

bool portaudio_output(uint32_t wanted, OutputDevice *device) {
  const PaDeviceIndex count = Pa_GetDeviceCount();
  uint32_t outputs = 0;
  for (PaDeviceIndex index = 0; index < count; index++) {
    const PaDeviceInfo *const info = Pa_GetDeviceInfo(index);
    if (!info || info->maxOutputChannels < 1 || outputs++ != wanted) continue;
    describe(index, info, device);
    return true;
  }
  return false;
}

/* ---- by name -------------------------------------------------------------------------------- */

static bool is_whole(const OutputDevice *device, const char *name) {
  return strcasecmp(device->label, name) == 0;
}

static bool is_name(const OutputDevice *device, const char *name) {
  return strcasecmp(strstr(device->label, ": ") + 2, name) == 0;
}

/* A host API is its first output, as JACK has one for each of its clients. */
static bool is_api(const OutputDevice *device, const char *name) {
  const size_t length = (size_t)(strstr(device->label, ": ") - device->label);
  return strlen(name) == length && strncasecmp(device->label, name, length) == 0;
}

static bool is_default(const OutputDevice *device, const char *name) {
  (void)name;
  return device->is_default;
}

static bool find(bool (*fits)(const OutputDevice *, const char *), const char *name,
                 OutputDevice *device) {
  for (uint32_t i = 0; portaudio_output(i, device); i++) {
    if (fits(device, name)) return true;
  }
  return false;
}

static void list_outputs(char *text, size_t size) {
  OutputDevice device;
  size_t length = 0;
  text[0] = '\0';
  for (uint32_t i = 0; portaudio_output(i, &device) && length < size; i++) {
    length +=
      (size_t)snprintf(text + length, size - length, "%s'%s'", i > 0 ? ", " : "", device.label);
  }
}

Outcome portaudio_find(const char *name, OutputDevice *device) {
  char list[LISTED];
  if (!portaudio_output(0, device)) {
    return fail("there is no sound output; --backend null plays without one");
  }
  if (!name && find(is_default, NULL, device)) return OUTCOME_OK;
  if (!name) return portaudio_output(0, device), OUTCOME_OK;
  if (find(is_whole, name, device) || find(is_name, name, device) || find(is_api, name, device)) {
    return OUTCOME_OK;
  }
  list_outputs(list, sizeof list);
  return fail("--device '%.80s': no such output; there are %s", name, list);
}
