/* SPDX-License-Identifier: MIT */
/**
 * @file jack_drum.c
 * A drum as a JACK client, played by MIDI: jack_drum [PRESET]
 *
 * Every note-on strikes, at its own frame: the note's velocity is the stick's speed. There is a
 * port out_NAME for each microphone. SIGINT or SIGTERM ends it. What it shows: set-up before the
 * audio thread runs, events with frames, and an audio thread that calls one function.
 */
#include <jack/jack.h>
#include <jack/midiport.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tabor/tabor.h>
#include <unistd.h>

enum { MOST_EVENTS = 64, NOTE_ON = 0x90, STATUS_MASK = 0xf0 };

typedef struct Client {
  jack_client_t *jack;
  jack_port_t *midi, *outputs[TABOR_MAX_MICS];
  TaborDrumDef def;
  TaborModel *model;
  TaborDrum *drum;
} Client;

static volatile sig_atomic_t stopped;

static void stop(int number) {
  (void)number;
  stopped = 1;
}

/* In equal ratios: 1 to 10 m/s for 20 to 127, and from there down to 0.3 m/s for 1. */
static double speed_of(unsigned velocity) {
  return velocity < 20 ? pow(0.3, (20 - velocity) / 19.0) : pow(10, (velocity - 20) / 107.0);
}

static bool is_stroke(const jack_midi_event_t *midi) {
  return midi->size == 3 && (midi->buffer[0] & STATUS_MASK) == NOTE_ON && midi->buffer[2] > 0;
}

/* The strokes of a cycle; more than MOST_EVENTS are left out. */
static uint32_t read_strokes(const Client *client, jack_nframes_t frames, TaborEvent *events) {
  void *const buffer = jack_port_get_buffer(client->midi, frames);
  const uint32_t received = jack_midi_get_event_count(buffer);
  uint32_t count = 0;
  for (uint32_t i = 0; i < received && count < MOST_EVENTS; i++) {
    jack_midi_event_t midi;
    if (jack_midi_event_get(&midi, buffer, i) != 0 || !is_stroke(&midi)) continue;
    events[count++] = (TaborEvent){
      .frame = midi.time,
      .type = TABOR_EVENT_STRIKE,
      .velocity = speed_of(midi.buffer[2]),
      .radius = client->def.strike.radius,
      .angle = client->def.strike.angle,
    };
  }
  return count;
}

/* JACK's audio thread. */
static int process(jack_nframes_t frames, void *context) {
  Client *const client = context;
  TaborEvent events[MOST_EVENTS];
  float *outputs[TABOR_MAX_MICS] = {NULL};
  const uint32_t count = read_strokes(client, frames, events);
  for (uint32_t i = 0; i < client->def.mic_count; i++)
    outputs[i] = jack_port_get_buffer(client->outputs[i], frames);
  tabor_drum_process(client->drum, events, count, outputs, frames);
  return 0;
}

static void server_ended(void *context) {
  (void)context;
  stopped = 1;
}

static bool register_ports(Client *client) {
  client->midi =
    jack_port_register(client->jack, "midi_in", JACK_DEFAULT_MIDI_TYPE, JackPortIsInput, 0);
  bool good = client->midi != NULL;
  for (uint32_t i = 0; i < client->def.mic_count && good; i++) {
    char name[TABOR_NAME_SIZE + 4];
    (void)snprintf(name, sizeof name, "out_%s", client->def.mic[i].name);
    client->outputs[i] =
      jack_port_register(client->jack, name, JACK_DEFAULT_AUDIO_TYPE, JackPortIsOutput, 0);
    good = client->outputs[i] != NULL;
  }
  return good;
}

static bool build_drum(Client *client, const char *preset) {
  TaborModelOptions options;
  TaborError error;
  tabor_model_options_default(&options);
  options.sample_rate = jack_get_sample_rate(client->jack);
  options.quality = TABOR_QUALITY_LIVE;
  const bool good =
    tabor_drum_def_preset(&client->def, preset, &error) == TABOR_OK &&
    tabor_model_create(&client->def, &options, &client->model, &error) == TABOR_OK &&
    tabor_drum_create(client->model, &client->drum, &error) == TABOR_OK;
  if (!good) (void)fprintf(stderr, "jack_drum: %s\n", error.message);
  return good;
}

static bool start(Client *client, const char *preset) {
  client->jack = jack_client_open("tabor", JackNoStartServer, NULL);
  if (!client->jack) {
    (void)fprintf(stderr, "jack_drum: no JACK server is running\n");
    return false;
  }
  if (!build_drum(client, preset)) return false;
  (void)jack_set_process_callback(client->jack, process, client);
  jack_on_shutdown(client->jack, server_ended, NULL);
  if (register_ports(client) && jack_activate(client->jack) == 0) return true;
  (void)fprintf(stderr, "jack_drum: JACK refused the ports or the client\n");
  return false;
}

int main(int argc, char **argv) {
  static Client client;
  if (argc > 2) {
    (void)fprintf(stderr, "usage: jack_drum [PRESET]\n");
    return 2;
  }
  (void)signal(SIGINT, stop);
  (void)signal(SIGTERM, stop);
  const bool started = start(&client, argc > 1 ? argv[1] : "snare-14x5.5");
  if (started) {
    printf("playing '%s' as JACK client '%s'\n", client.def.name,
           jack_get_client_name(client.jack));
    (void)fflush(stdout);
    while (!stopped) (void)usleep(50000);
  }
  if (client.jack) (void)jack_client_close(client.jack); /* ends the audio thread */
  tabor_drum_destroy(client.drum);
  tabor_model_release(client.model);
  return started ? EXIT_SUCCESS : EXIT_FAILURE;
}
