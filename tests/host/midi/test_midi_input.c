/* SPDX-License-Identifier: MIT */
/* Live MIDI (host/midi/midi_input.h, midi_clock.h) with inputs that the test plugs in and plays on,
 * in the place of RtMidi's. */
#include "midi/midi_input.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "midi/midi_clock.h"
#include "midi/midi_port.h"

/* ---- in the place of RtMidi ---- */

#define PORTS 3 /* the last is our own */

struct RtMidiWrapper {
  char name[MIDI_PORT_NAME];
  atomic_bool there, open;
  MidiPortFn *receive;
  void *context;
};

static MidiPort ports[PORTS];

const char *midi_port_api(int api) { return api == 7 ? "Test" : "?"; }
void midi_ports_refresh(MidiPorts *all) { (void)all; }
void midi_ports_end(MidiPorts *all) { all->count = 0; }
bool midi_port_is_hardware(const MidiPortName *name) { return strncmp(name->text, "hw", 2) == 0; }

void midi_ports_begin(MidiPorts *all) {
  *all = (MidiPorts){.count = 1};
  all->apis[0].api = 7;
}

size_t midi_ports_list(MidiPorts *all, MidiPortName *names, size_t most) {
  size_t count = 0;
  (void)all;
  for (int i = 0; i + 1 < PORTS && count < most; i++) {
    if (!atomic_load(&ports[i].there)) continue;
    names[count] = (MidiPortName){.api = 7};
    memcpy(names[count++].text, ports[i].name, MIDI_PORT_NAME);
  }
  return count;
}

static MidiPort *open_port(MidiPort *port, MidiPortFn *receive, void *context) {
  port->receive = receive;
  port->context = context;
  atomic_store(&port->open, true);
  return port;
}

MidiPort *midi_port_open(MidiPorts *all, const MidiPortName *name, MidiPortFn *receive,
                         void *context) {
  (void)all;
  for (int i = 0; i + 1 < PORTS; i++) {
    if (strcmp(ports[i].name, name->text) == 0) return open_port(&ports[i], receive, context);
  }
  return NULL;
}

MidiPort *midi_port_open_own(const MidiPorts *all, size_t index, MidiPortFn *receive,
                             void *context) {
  (void)all;
  assert_int_equal(index, 0);
  return open_port(&ports[PORTS - 1], receive, context);
}

void midi_port_close(MidiPort *port) {
  if (port) atomic_store(&port->open, false);
}

/* ---- what is received ---- */

static atomic_uint received, last_note;
static double last_time;

static void receive(void *context, double time, const MidiMessage *message) {
  (void)context;
  last_time = time;
  atomic_store(&last_note, message->data[0]);
  atomic_fetch_add(&received, 1);
}

static double now(void) {
  struct timespec time;
  (void)clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void play(MidiPort *port, uint8_t note) {
  const uint8_t bytes[] = {0x99, note, 100};
  assert_true(atomic_load(&port->open));
  port->receive(0, bytes, sizeof bytes, port->context);
}

/* Until it is so, for a while; no test says how long it takes. */
static void wait_for(const atomic_uint *value, unsigned expected) {
  const struct timespec moment = {.tv_nsec = 1000000};
  for (int i = 0; i < 20000 && atomic_load(value) != expected; i++) (void)nanosleep(&moment, NULL);
  assert_int_equal(atomic_load(value), expected);
}

static void wait_until(const atomic_bool *value, bool expected) {
  const struct timespec moment = {.tv_nsec = 1000000};
  for (int i = 0; i < 20000 && atomic_load(value) != expected; i++) (void)nanosleep(&moment, NULL);
  assert_int_equal(atomic_load(value), expected);
}

static int set_up(void **state) {
  (void)state;
  memset(ports, 0, sizeof ports);
  strcpy(ports[0].name, "hw pads");
  strcpy(ports[1].name, "some program");
  atomic_store(&received, 0);
  return 0;
}

/* ---- tests ---- */

static void test_hardware_and_own(void **state) {
  (void)state;
  MidiInput *input = NULL;
  MidiInputStatus status;
  ports[0].there = ports[1].there = true;
  assert_int_equal(midi_input_open(NULL, true, receive, NULL, &input), OUTCOME_OK);
  assert_true(ports[0].open && !ports[1].open && ports[2].open);
  const double before = now();
  play(&ports[0], 38);
  wait_for(&received, 1);
  assert_true(last_time >= before && last_time <= now());
  play(&ports[2], 40);
  wait_for(&received, 2);
  assert_int_equal(last_note, 40);
  midi_input_status(input, &status);
  assert_int_equal(status.inputs, 1);
  assert_int_equal(status.own, 1);
  assert_int_equal(status.taken, 2);
  assert_int_equal(status.dropped, 0);
  midi_input_close(input);
  assert_true(!ports[0].open && !ports[2].open);
}

static void test_plugging(void **state) {
  (void)state;
  MidiInput *input = NULL;
  MidiInputStatus status;
  assert_int_equal(midi_input_open("program", true, receive, NULL, &input), OUTCOME_OK);
  assert_true(!ports[0].open && !ports[1].open);
  atomic_store(&ports[0].there, true); /* not wanted */
  atomic_store(&ports[1].there, true);
  wait_until(&ports[1].open, true);
  assert_false(ports[0].open);
  play(&ports[1], 38);
  wait_for(&received, 1);
  atomic_store(&ports[1].there, false);
  wait_until(&ports[1].open, false);
  atomic_store(&ports[1].there, true); /* plugged in again */
  wait_until(&ports[1].open, true);
  play(&ports[1], 38);
  wait_for(&received, 2);
  midi_input_status(input, &status);
  assert_int_equal(status.inputs, 1);
  midi_input_close(input);
}

/* What a person cannot play is dropped, and none of it is lost uncounted. */
static void test_flood(void **state) {
  (void)state;
  MidiInput *input = NULL;
  MidiInputStatus status = {0};
  enum { FLOOD = 50000 };
  assert_int_equal(midi_input_open(NULL, true, receive, NULL, &input), OUTCOME_OK);
  const double before = now();
  for (int i = 0; i < FLOOD; i++) play(&ports[2], 38);
  for (int i = 0; i < 20000 && status.taken + status.dropped < FLOOD; i++) {
    const struct timespec moment = {.tv_nsec = 1000000};
    (void)nanosleep(&moment, NULL);
    midi_input_status(input, &status);
  }
  assert_int_equal(status.taken + status.dropped, FLOOD);
  assert_true(status.taken >= 64);
  assert_true((double)status.taken <= 65 + 1000 * (now() - before));
  wait_for(&received, (unsigned)status.taken);
  midi_input_close(input);
}

/* A port's times count, not when its thread wakes; the least lateness is what remains. */
static void test_clock(void **state) {
  (void)state;
  MidiClock clock = {0};
  unsigned random = 1;
  double time = 0;
  for (int i = 0; i < 1000; i++) {
    const double played = 100 + 0.01 * i;
    random = random * 1103515245u + 12345u;
    const double late = i == 0 ? 0.002 : 0.001 + 0.01 * (random >> 16 & 0x7FFF) / 32768.0;
    time = midi_clock_take(&clock, i == 0 ? 0 : 0.01, played + late);
    if (i > 100) assert_true(time - played > 0.0009 && time - played < 0.0025);
  }
  /* its clock tells nothing: then the thread's time is all there is */
  assert_true(fabs(midi_clock_take(&clock, 0, 200) - 200) < 1e-9);
  assert_true(fabs(midi_clock_take(&clock, NAN, 201) - 201) < 1e-9);
  assert_true(midi_clock_take(&clock, 1e9, 202) <= 202 + 1e-6);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(test_hardware_and_own, set_up),
    cmocka_unit_test_setup(test_plugging, set_up),
    cmocka_unit_test_setup(test_flood, set_up),
    cmocka_unit_test_setup(test_clock, set_up),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
