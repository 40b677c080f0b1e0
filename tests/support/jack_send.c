/* SPDX-License-Identifier: MIT */
/**
 * @file jack_send.c
 * A MIDI keyboard for the tests: a JACK client that sends given messages, each at its frame.
 *
 *     jack_send PORT MESSAGE...     connects to PORT, or for '-' waits for a connection, and sends;
 *                                   MESSAGE is SECONDS:HEX, as 0.5:992640, timed from the
 *                                   connection
 *     jack_send PORT flood RATE SECONDS   sends RATE notes a second
 *
 * Waits up to a minute for the port. Status 1 if there is no server, port or connection.
 */
#include <jack/jack.h>
#include <jack/midiport.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define MOST_MESSAGES 64

typedef struct Message {
  double time;
  uint8_t bytes[8];
  size_t size;
} Message;

typedef struct Sender {
  jack_client_t *client;
  jack_port_t *port;
  double rate;
  Message messages[MOST_MESSAGES];
  size_t count, next;
  double flood;        /* notes a second, or 0 */
  double end;          /* [s] */
  uint64_t frame;      /* since the beginning */
  uint64_t flooded;    /* notes */
  atomic_bool running; /* connected */
  atomic_bool done;
} Sender;

static void write_flood(Sender *sender, void *buffer, jack_nframes_t frames) {
  static const uint8_t note[] = {0x99, 38, 60};
  for (jack_nframes_t at = 0; at < frames; at++) {
    const double due = (double)(sender->frame + at) / sender->rate * sender->flood;
    for (; (double)sender->flooded < due; sender->flooded++) {
      if (jack_midi_event_write(buffer, at, note, sizeof note) != 0) return;
    }
  }
}

static void write_messages(Sender *sender, void *buffer, jack_nframes_t frames) {
  for (; sender->next < sender->count; sender->next++) {
    const Message *const message = &sender->messages[sender->next];
    const uint64_t due = (uint64_t)(message->time * sender->rate);
    if (due >= sender->frame + frames) return;
    const uint64_t at = due > sender->frame ? due - sender->frame : 0;
    (void)jack_midi_event_write(buffer, (jack_nframes_t)at, message->bytes, message->size);
  }
}

static int process(jack_nframes_t frames, void *context) {
  Sender *const sender = context;
  void *const buffer = jack_port_get_buffer(sender->port, frames);
  jack_midi_clear_buffer(buffer);
  if (!atomic_load(&sender->running)) return 0;
  if (sender->flood > 0) {
    write_flood(sender, buffer, frames);
  } else {
    write_messages(sender, buffer, frames);
  }
  sender->frame += frames;
  if ((double)sender->frame > sender->end * sender->rate) atomic_store(&sender->done, true);
  return 0;
}

static bool read_message(Sender *sender, const char *text) {
  Message *const message = &sender->messages[sender->count];
  char *at = NULL;
  message->time = strtod(text, &at);
  if (*at++ != ':' || sender->count == MOST_MESSAGES) return false;
  for (unsigned byte; message->size < sizeof message->bytes && sscanf(at, "%2x", &byte) == 1;
       at += 2) {
    message->bytes[message->size++] = (uint8_t)byte;
  }
  sender->end = message->time + 0.2;
  sender->count++;
  return message->size > 0;
}

static bool read_arguments(Sender *sender, int argc, char **argv) {
  if (argc == 5 && strcmp(argv[2], "flood") == 0) {
    sender->flood = atof(argv[3]);
    sender->end = atof(argv[4]);
    return true;
  }
  bool good = argc > 2;
  for (int i = 2; i < argc && good; i++) good = read_message(sender, argv[i]);
  return good;
}

static void wait_a_moment(void) {
  const struct timespec moment = {.tv_nsec = 5000000};
  (void)nanosleep(&moment, NULL);
}

static bool open_client(Sender *sender) {
  sender->client = jack_client_open("jack_send", JackNoStartServer, NULL);
  if (!sender->client) return false;
  sender->rate = jack_get_sample_rate(sender->client);
  sender->port =
    jack_port_register(sender->client, "out", JACK_DEFAULT_MIDI_TYPE, JackPortIsOutput, 0);
  jack_set_process_callback(sender->client, process, sender);
  return sender->port && jack_activate(sender->client) == 0;
}

static bool is_connected(const Sender *sender, const char *port) {
  if (strcmp(port, "-") == 0) return jack_port_connected(sender->port) > 0;
  return jack_port_by_name(sender->client, port) &&
         jack_connect(sender->client, jack_port_name(sender->port), port) == 0;
}

static bool begin(Sender *sender, const char *port) {
  if (!open_client(sender)) return false;
  for (int i = 0; i < 12000; i++) {
    if (is_connected(sender, port)) return true;
    wait_a_moment();
  }
  return false;
}

static void wait_until_done(const Sender *sender) {
  for (int i = 0; i < 12000 && !atomic_load(&sender->done); i++) wait_a_moment();
}

int main(int argc, char **argv) {
  static Sender sender;
  if (!read_arguments(&sender, argc, argv)) return 2;
  if (!begin(&sender, argv[1])) return 1;
  atomic_store(&sender.running, true);
  wait_until_done(&sender);
  if (sender.flood > 0) printf("%llu\n", (unsigned long long)sender.flooded);
  (void)jack_client_close(sender.client);
  return atomic_load(&sender.done) ? 0 : 1;
}
