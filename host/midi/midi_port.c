/* SPDX-License-Identifier: MIT */
#include "midi/midi_port.h"

#include <rtmidi_c.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/mute_stderr.h"
#include "platform/process.h"

#define CLIENT "tabor-midi"
#define LISTER CLIENT "-list" /* JACK has no two clients of one name */
#define OWN_PORT "in"
#define QUEUE 1 /* messages that RtMidi would keep, had it no receiver */

/* ---- interfaces that work ---- */

static void say_nothing(const char *message) { (void)message; }
static void say_nothing_of_alsa(const char *file, int line, const char *function, int error,
                                const char *format, ...) {
  (void)file, (void)line, (void)function, (void)error, (void)format;
}

static void silence(const char *setter, void *handler) {
  typedef void SetFn(void *);
  SetFn *set = NULL;
  void *const found = process_loaded_function(setter);
  memcpy(&set, &found, sizeof set); /* ISO C has no cast from an object to a function */
  if (set) set(handler);
}

static void silence_libraries(void) {
  void *handler = NULL;
  void (*const jack)(const char *) = say_nothing;
  void (*const alsa)(const char *, int, const char *, int, const char *, ...) = say_nothing_of_alsa;
  memcpy(&handler, &jack, sizeof handler);
  silence("jack_set_error_function", handler);
  silence("jack_set_info_function", handler);
  memcpy(&handler, &alsa, sizeof handler);
  silence("snd_lib_error_set_handler", handler);
}

#define JACK_NO_START_SERVER 1 /* JackNoStartServer */

/* True if a JACK server answers. */
static bool jack_answers(void) {
  typedef void *OpenFn(const char *name, int options, int *status, ...);
  typedef int CloseFn(void *client);
  OpenFn *open_client = NULL;
  CloseFn *close_client = NULL;
  void *const open_found = process_loaded_function("jack_client_open");
  void *const close_found = process_loaded_function("jack_client_close");
  if (!open_found || !close_found) return false;
  memcpy(&open_client, &open_found, sizeof open_client);
  memcpy(&close_client, &close_found, sizeof close_client);
  int status = 0;
  void *const client = open_client(LISTER, JACK_NO_START_SERVER, &status);
  if (client) (void)close_client(client);
  return client != NULL;
}

static bool works(int api) {
  if (api == RTMIDI_API_LINUX_ALSA) return access("/dev/snd/seq", R_OK | W_OK) == 0;
  if (api == RTMIDI_API_UNIX_JACK) return jack_answers();
  return api != RTMIDI_API_RTMIDI_DUMMY;
}

/* ---- inputs of RtMidi ---- */

/* A server may have gone since it was seen to work. */
static MidiPort *create(int api, const char *client) {
  const int muted = mute_stderr_begin();
  RtMidiInPtr const input = rtmidi_in_create((enum RtMidiApi)api, client, QUEUE);
  mute_stderr_end(muted);
  if (!input || input->ok) return input;
  rtmidi_in_free(input);
  return NULL;
}

/* One that came to no server tries again here, and says so. */
static size_t count_inputs(MidiPort *lister) {
  const int muted = mute_stderr_begin();
  const unsigned count = rtmidi_get_port_count(lister);
  mute_stderr_end(muted);
  return lister->ok ? count : 0;
}

static bool name_input(MidiPort *lister, unsigned index, char *text) {
  int size = MIDI_PORT_NAME;
  text[0] = '\0';
  (void)rtmidi_get_port_name(lister, index, text, &size);
  text[MIDI_PORT_NAME - 1] = '\0';
  return lister->ok && text[0] != '\0';
}

/* ---- all of them ---- */

void midi_ports_begin(MidiPorts *ports) {
  enum RtMidiApi apis[MIDI_PORT_APIS];
  *ports = (MidiPorts){.count = 0};
  silence_libraries();
  const int count = rtmidi_get_compiled_api(apis, MIDI_PORT_APIS);
  for (int i = 0; i < count; i++) ports->apis[ports->count++].api = (int)apis[i];
  midi_ports_refresh(ports);
}

void midi_ports_refresh(MidiPorts *ports) {
  for (size_t i = 0; i < ports->count; i++) {
    if (ports->apis[i].lister || !works(ports->apis[i].api)) continue;
    ports->apis[i].lister = create(ports->apis[i].api, LISTER);
  }
}

size_t midi_ports_list(MidiPorts *ports, MidiPortName *names, size_t most) {
  size_t count = 0;
  for (size_t i = 0; i < ports->count; i++) {
    MidiPort *const lister = ports->apis[i].lister;
    const size_t inputs = lister ? count_inputs(lister) : 0;
    for (unsigned input = 0; input < inputs && count < most; input++) {
      MidiPortName *const name = &names[count];
      name->api = ports->apis[i].api;
      if (!name_input(lister, input, name->text) || strstr(name->text, CLIENT)) continue;
      count++;
    }
  }
  return count;
}

void midi_ports_end(MidiPorts *ports) {
  for (size_t i = 0; i < ports->count; i++) {
    if (ports->apis[i].lister) rtmidi_in_free(ports->apis[i].lister);
  }
  *ports = (MidiPorts){.count = 0};
}

/* ---- one of them ---- */

const char *midi_port_api(int api) { return rtmidi_api_display_name((enum RtMidiApi)api); }

bool midi_port_is_hardware(const MidiPortName *name) {
  if (name->api == RTMIDI_API_UNIX_JACK) {
    return strncmp(name->text, "system:", 7) == 0 || strncmp(name->text, "a2j:", 4) == 0;
  }
  return strstr(name->text, "Midi Through") == NULL;
}

static MidiPort *keep_or_free(MidiPort *input) {
  if (input->ok) return input;
  rtmidi_in_free(input);
  return NULL;
}

static MidiPort *lister_of(const MidiPorts *ports, int api) {
  for (size_t i = 0; i < ports->count; i++) {
    if (ports->apis[i].api == api) return ports->apis[i].lister;
  }
  return NULL;
}

MidiPort *midi_port_open(MidiPorts *ports, const MidiPortName *name, MidiPortFn *receive,
                         void *context) {
  MidiPort *const lister = lister_of(ports, name->api);
  const size_t count = lister ? count_inputs(lister) : 0;
  char text[MIDI_PORT_NAME];
  for (unsigned index = 0; index < count; index++) {
    if (!name_input(lister, index, text) || strcmp(text, name->text) != 0) continue;
    MidiPort *const input = create(name->api, CLIENT);
    if (!input) return NULL;
    rtmidi_in_set_callback(input, receive, context);
    const int muted = mute_stderr_begin();
    rtmidi_open_port(input, index, OWN_PORT);
    mute_stderr_end(muted);
    return keep_or_free(input);
  }
  return NULL;
}

MidiPort *midi_port_open_own(const MidiPorts *ports, size_t index, MidiPortFn *receive,
                             void *context) {
  if (index >= ports->count || !ports->apis[index].lister) return NULL;
  MidiPort *const input = create(ports->apis[index].api, CLIENT);
  if (!input) return NULL;
  rtmidi_in_set_callback(input, receive, context);
  const int muted = mute_stderr_begin();
  rtmidi_open_virtual_port(input, OWN_PORT);
  mute_stderr_end(muted);
  return keep_or_free(input);
}

void midi_port_close(MidiPort *port) {
  if (port) rtmidi_in_free(port);
}
