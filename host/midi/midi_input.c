/* SPDX-License-Identifier: MIT */
#include "midi/midi_input.h"

#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "base/spsc_queue.h"
#include "midi/midi_clock.h"
#include "midi/midi_port.h"
#include "platform/clock.h"
#include "platform/wake.h"

#define MOST_INPUTS 32     /* open at once, with our own */
#define QUEUE_MESSAGES 512 /* of each */
#define LOOK_INTERVAL 1    /* [s] between looks for new ones */
#define CLOSE_TIME 1.0     /* [s] that interfaces may take to let go */
#define MOST_RATE 1000.0   /* messages a second */
#define MOST_AT_ONCE 64.0  /* messages */

/* A message on its way. */
typedef struct Arrival {
  double time; /* [s] */
  MidiMessage message;
} Arrival;

/* An input, open or not. */
typedef struct Slot {
  MidiInput *input;
  MidiPort *port; /* NULL: free. The watching thread's */
  MidiPortName name;
  bool is_own;
  MidiStream stream; /* these two are the port's thread's */
  MidiClock clock;
  SpscQueue queue; /* from there to the passing thread */
} Slot;

struct MidiInput {
  char *wanted; /* or NULL */
  bool quiet;
  MidiInputFn *receive;
  void *context;
  Slot slots[MOST_INPUTS];
  MidiPorts ports; /* the watching thread's */
  pthread_t watcher, passer;
  Wake waiting;           /* messages in the queues */
  pthread_mutex_t mutex;  /* of ends, with */
  pthread_cond_t changed; /* for the watching thread to wake */
  bool ends, watcher_done;
  atomic_bool passing_ends;
  double allowance,
    allowed; /* messages that may pass now, and when that was so; the passing thread's */
  atomic_uint inputs, own;
  atomic_ullong taken, dropped;
};

/* ---- a port's thread ------------------------------------------------------------------------ */

/* Real-time safe but for the clock and the semaphore, which do not wait. */
static void take_bytes(double later, const unsigned char *bytes, size_t size, void *context) {
  Slot *const slot = context;
  Arrival arrival = {.time =
                       midi_clock_take(&slot->clock, later, stopwatch_seconds(CLOCK_MONOTONIC))};
  for (size_t i = 0; i < size; i++) {
    if (!midi_stream_take(&slot->stream, bytes[i], &arrival.message)) continue;
    if (spsc_queue_push(&slot->queue, &arrival)) wake_post(&slot->input->waiting);
  }
}

/* ---- the passing thread --------------------------------------------------------------------- */

/* As a bucket that fills steadily and holds only so much. */
static bool is_allowed(MidiInput *input) {
  const double now = stopwatch_seconds(CLOCK_MONOTONIC);
  input->allowance += MOST_RATE * (now - input->allowed);
  input->allowed = now;
  if (input->allowance > MOST_AT_ONCE) input->allowance = MOST_AT_ONCE;
  if (input->allowance < 1) return false;
  input->allowance--;
  return true;
}

/* The slot whose message came first, or NULL. */
static Slot *first_slot(MidiInput *input) {
  Slot *first = NULL;
  double time = 0;
  for (size_t i = 0; i < MOST_INPUTS; i++) {
    const Arrival *const arrival = spsc_queue_peek(&input->slots[i].queue);
    if (!arrival || (first && arrival->time >= time)) continue;
    first = &input->slots[i];
    time = arrival->time;
  }
  return first;
}

static void pass_one(MidiInput *input, Slot *slot) {
  const Arrival arrival = *(const Arrival *)spsc_queue_peek(&slot->queue);
  spsc_queue_pop(&slot->queue);
  if (is_allowed(input)) {
    atomic_fetch_add(&input->taken, 1);
    input->receive(input->context, arrival.time, &arrival.message);
  } else {
    atomic_fetch_add(&input->dropped, 1);
  }
}

static void *pass(void *context) {
  MidiInput *const input = context;
  Slot *slot;
  while (!atomic_load(&input->passing_ends)) {
    if ((slot = first_slot(input)) != NULL) {
      pass_one(input, slot);
    } else {
      wake_wait(&input->waiting);
    }
  }
  return NULL;
}

/* ---- the watching thread -------------------------------------------------------------------- */

static bool is_wanted(const MidiInput *input, const MidiPortName *name) {
  return input->wanted ? strstr(name->text, input->wanted) != NULL : midi_port_is_hardware(name);
}

static bool same_name(const MidiPortName *a, const MidiPortName *b) {
  return a->api == b->api && strcmp(a->text, b->text) == 0;
}

static Slot *free_slot(MidiInput *input) {
  for (size_t i = 0; i < MOST_INPUTS; i++) {
    if (!input->slots[i].port) return &input->slots[i];
  }
  return NULL;
}

static bool is_open(const MidiInput *input, const MidiPortName *name) {
  for (size_t i = 0; i < MOST_INPUTS; i++) {
    const Slot *const slot = &input->slots[i];
    if (slot->port && !slot->is_own && same_name(&slot->name, name)) return true;
  }
  return false;
}

static Slot *prepare_slot(MidiInput *input) {
  Slot *const slot = free_slot(input);
  if (!slot) return NULL;
  slot->stream = (MidiStream){0};
  slot->clock = (MidiClock){0};
  return slot;
}

static void open_input(MidiInput *input, const MidiPortName *name) {
  Slot *const slot = prepare_slot(input);
  if (!slot) return;
  slot->name = *name;
  slot->is_own = false;
  slot->port = midi_port_open(&input->ports, name, take_bytes, slot);
  if (!slot->port) return;
  atomic_fetch_add(&input->inputs, 1);
  if (!input->quiet) note("MIDI from %s: %s", midi_port_api(name->api), name->text);
}

/* Of interface number @p index, if it has none. */
static void open_own(MidiInput *input, size_t index) {
  const int api = input->ports.apis[index].api;
  for (size_t i = 0; i < MOST_INPUTS; i++) {
    const Slot *const slot = &input->slots[i];
    if (slot->port && slot->is_own && slot->name.api == api) return;
  }
  Slot *const slot = prepare_slot(input);
  if (!slot) return;
  slot->name = (MidiPortName){.api = api};
  slot->is_own = true;
  slot->port = midi_port_open_own(&input->ports, index, take_bytes, slot);
  if (slot->port) atomic_fetch_add(&input->own, 1);
}

/* Those that are no longer listed. */
static void close_gone(MidiInput *input, const MidiPortName *names, size_t count) {
  for (size_t i = 0; i < MOST_INPUTS; i++) {
    Slot *const slot = &input->slots[i];
    bool there = !slot->port || slot->is_own;
    for (size_t j = 0; j < count && !there; j++) there = same_name(&slot->name, &names[j]);
    if (there) continue;
    midi_port_close(slot->port);
    slot->port = NULL;
    atomic_fetch_sub(&input->inputs, 1);
    if (!input->quiet) note("MIDI: '%s' is gone", slot->name.text);
  }
}

static void look(MidiInput *input) {
  MidiPortName names[MOST_INPUTS];
  midi_ports_refresh(&input->ports);
  const size_t count = midi_ports_list(&input->ports, names, MOST_INPUTS);
  close_gone(input, names, count);
  for (size_t i = 0; i < input->ports.count; i++) open_own(input, i);
  for (size_t i = 0; i < count; i++) {
    if (is_wanted(input, &names[i]) && !is_open(input, &names[i])) open_input(input, &names[i]);
  }
}

/* Until the next look, or the end: then true. */
static bool wait_for_end(MidiInput *input) {
  struct timespec until;
  (void)clock_gettime(CLOCK_REALTIME, &until);
  until.tv_sec += LOOK_INTERVAL;
  int status = 0;
  (void)pthread_mutex_lock(&input->mutex);
  while (!input->ends && status == 0) {
    status = pthread_cond_timedwait(&input->changed, &input->mutex, &until);
  }
  const bool ends = input->ends;
  (void)pthread_mutex_unlock(&input->mutex);
  return ends;
}

/* Interfaces may hang when they let go; so nobody waits for this thread without a limit. */
static void *watch(void *context) {
  MidiInput *const input = context;
  while (!wait_for_end(input)) look(input);
  for (size_t i = 0; i < MOST_INPUTS; i++) {
    midi_port_close(input->slots[i].port);
    input->slots[i].port = NULL;
  }
  midi_ports_end(&input->ports);
  (void)pthread_mutex_lock(&input->mutex);
  input->watcher_done = true;
  (void)pthread_cond_broadcast(&input->changed);
  (void)pthread_mutex_unlock(&input->mutex);
  return NULL;
}

/* ---- beginning and end ---------------------------------------------------------------------- */

static void free_input(MidiInput *input) {
  for (size_t i = 0; i < MOST_INPUTS; i++) spsc_queue_destroy(&input->slots[i].queue);
  wake_destroy(&input->waiting);
  (void)pthread_cond_destroy(&input->changed);
  (void)pthread_mutex_destroy(&input->mutex);
  free(input->wanted);
  free(input);
}

static MidiInput *allocate(const char *wanted) {
  MidiInput *const input = calloc(1, sizeof *input);
  if (!input) return NULL;
  bool complete = wake_create(&input->waiting);
  (void)pthread_mutex_init(&input->mutex, NULL);
  (void)pthread_cond_init(&input->changed, NULL);
  if (wanted) complete = (input->wanted = strdup(wanted)) != NULL && complete;
  for (size_t i = 0; i < MOST_INPUTS; i++) {
    input->slots[i].input = input;
    complete =
      spsc_queue_create(&input->slots[i].queue, sizeof(Arrival), QUEUE_MESSAGES) && complete;
  }
  if (complete) return input;
  free_input(input);
  return NULL;
}

static void stop_passing(MidiInput *input) {
  atomic_store(&input->passing_ends, true);
  wake_post(&input->waiting);
  (void)pthread_join(input->passer, NULL);
}

static void close_ports(MidiInput *input) {
  for (size_t i = 0; i < MOST_INPUTS; i++) midi_port_close(input->slots[i].port);
  midi_ports_end(&input->ports);
}

/* What fits nothing may be a slip, or not plugged in yet. */
static void note_missing(MidiInput *input) {
  MidiPortName names[MOST_INPUTS];
  if (!input->wanted || atomic_load(&input->inputs) > 0) return;
  const size_t count = midi_ports_list(&input->ports, names, MOST_INPUTS);
  warn("--midi-in '%.80s': no MIDI input has this in its name%s; it may come", input->wanted,
       count == 0 ? ", there is none" : "");
  for (size_t i = 0; i < count && !input->quiet; i++) {
    note("MIDI input of %s: %s", midi_port_api(names[i].api), names[i].text);
  }
}

Outcome midi_input_open(const char *wanted, bool quiet, MidiInputFn *receive, void *context,
                        MidiInput **result) {
  MidiInput *const input = *result = allocate(wanted);
  if (!input) return fail_memory();
  input->quiet = quiet;
  input->receive = receive;
  input->context = context;
  input->allowance = MOST_AT_ONCE;
  input->allowed = stopwatch_seconds(CLOCK_MONOTONIC);
  midi_ports_begin(&input->ports);
  look(input);
  note_missing(input);
  int error = pthread_create(&input->passer, NULL, pass, input);
  if (error == 0) {
    error = pthread_create(&input->watcher, NULL, watch, input);
    if (error == 0) return OUTCOME_OK;
    stop_passing(input);
  }
  close_ports(input);
  free_input(input);
  *result = NULL;
  return fail("cannot listen to MIDI: %s", strerror(error));
}

void midi_input_status(const MidiInput *input, MidiInputStatus *status) {
  *status = (MidiInputStatus){.inputs = atomic_load(&input->inputs),
                              .own = atomic_load(&input->own),
                              .taken = atomic_load(&input->taken),
                              .dropped = atomic_load(&input->dropped)};
  for (size_t i = 0; i < MOST_INPUTS; i++)
    status->dropped += spsc_queue_dropped(&input->slots[i].queue);
}

/* True once the watching thread has let go of everything. */
static bool wait_for_watcher(MidiInput *input) {
  const double end = stopwatch_seconds(CLOCK_REALTIME) + CLOSE_TIME;
  const struct timespec until = {.tv_sec = (time_t)end,
                                 .tv_nsec = (long)(1e9 * (end - (double)(time_t)end))};
  (void)pthread_mutex_lock(&input->mutex);
  input->ends = true;
  (void)pthread_cond_broadcast(&input->changed);
  int status = 0;
  while (!input->watcher_done && status == 0) {
    status = pthread_cond_timedwait(&input->changed, &input->mutex, &until);
  }
  const bool done = input->watcher_done;
  (void)pthread_mutex_unlock(&input->mutex);
  return done;
}

void midi_input_close(MidiInput *input) {
  if (!input) return;
  stop_passing(input);
  if (wait_for_watcher(input)) {
    (void)pthread_join(input->watcher, NULL);
    free_input(input);
  } else {
    (void)pthread_detach(input->watcher); /* it still uses all of this */
  }
}
