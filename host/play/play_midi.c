/* SPDX-License-Identifier: MIT */
#include "play/play_midi.h"
#include "midi/midi_mask.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "platform/clock.h"

#define BINDING_AGE 0.05     /* [s] after which the drum may be another one */
#define MIDI_CONTROLLERS 120 /* the numbers behind are messages about the channel */

/* All but what play_midi_open() sets, and the count, belongs to the thread that receives. */
struct PlayMidi {
  MidiMap map;
  MidiToEvents drum;
  double bound; /* when the drum was looked at [s] */
  Humanizer humanizer;
  MidiMask mask;
  Player *player;
  ModelBuilder *builder;
  MidiInput *input;
  atomic_uint_least64_t ignored;
  /* under lock */
  pthread_mutex_t lock;
  bool learns;
  MidiControl target; /* of the next controller, if it learns */
  int learned;        /* the controller that was learned, until somebody asks; -1 */
};

static void bind(PlayMidi *midi, double now) {
  TaborDrumDef def;
  model_builder_definition(midi->builder, &def);
  midi_binding_make(&midi->map, &def, &midi->drum.binding);
  midi->bound = now;
}

Cue play_midi_cue(const MidiAction *action, uint64_t frame) {
  Cue cue = {0};
  if (!player_message_from_midi(action, frame, &cue.message)) {
    cue.preset = tabor_preset(action->preset)->name;
  }
  return cue;
}

static bool is_for(const PlayMidi *midi, const MidiMessage *message) {
  return midi->map.channel == MIDI_OMNI || midi->map.channel == midi_channel(message);
}

/* Controllers above are messages about the channel. */
static bool may_be_learned(const PlayMidi *midi, const MidiMessage *message) {
  return midi_kind(message) == MIDI_CONTROL && message->data[0] < MIDI_CONTROLLERS &&
         is_for(midi, message);
}

static void learn(PlayMidi *midi, const MidiMessage *message, double now) {
  if (!may_be_learned(midi, message)) return;
  (void)pthread_mutex_lock(&midi->lock);
  const bool learns = midi->learns;
  if (learns) {
    midi->map.controls[message->data[0]] = midi->target;
    midi->learned = message->data[0];
  }
  midi->learns = false;
  (void)pthread_mutex_unlock(&midi->lock);
  if (learns) bind(midi, now);
}

void play_midi_learn(PlayMidi *midi, const MidiControl *target) {
  (void)pthread_mutex_lock(&midi->lock);
  midi->learns = target != NULL;
  if (target) midi->target = *target;
  (void)pthread_mutex_unlock(&midi->lock);
}

int play_midi_learned(PlayMidi *midi) {
  if (!midi) return -1;
  (void)pthread_mutex_lock(&midi->lock);
  const int learned = midi->learned;
  midi->learned = -1;
  (void)pthread_mutex_unlock(&midi->lock);
  return learned;
}

static void act(PlayMidi *midi, const MidiAction *action, double time, double now) {
  Cue cue = play_midi_cue(action, player_frame_at(midi->player, time));
  humanize(&midi->humanizer, midi->drum.binding.head_radius, &cue.message.event);
  if (cue.preset) {
    (void)model_builder_program(midi->builder, cue.message.frame, cue.preset); /* it says */
    bind(midi, now);
  } else {
    (void)player_send(midi->player, SOURCE_MIDI, &cue.message); /* counts what it drops */
  }
}

static void receive(void *context, double time, const MidiMessage *message) {
  PlayMidi *const midi = context;
  const double now = stopwatch_seconds(CLOCK_MONOTONIC);
  MidiAction actions[MIDI_MOST_ACTIONS];
  if (now - midi->bound > BINDING_AGE) bind(midi, now);
  learn(midi, message, now);
  if (!midi_mask_passes(&midi->mask, message, time)) return;
  const uint32_t count = midi_to_events_take(&midi->drum, message, actions);
  atomic_store(&midi->ignored, midi->drum.counts.ignored_notes);
  for (uint32_t i = 0; i < count; i++) act(midi, &actions[i], time, now);
}

Outcome play_midi_open(const PlayRequest *request, Player *player, ModelBuilder *builder,
                       PlayMidi **result) {
  PlayMidi *const midi = *result = calloc(1, sizeof *midi);
  if (!midi) return fail_memory();
  (void)pthread_mutex_init(&midi->lock, NULL);
  midi->learned = -1;
  midi->map = request->midi_map;
  midi->humanizer = request->humanizer;
  midi->mask.time = request->mask_time;
  midi->player = player;
  midi->builder = builder;
  midi_to_events_begin(&midi->drum, &midi->map, &(MidiBinding){0});
  bind(midi, stopwatch_seconds(CLOCK_MONOTONIC));
  return midi_input_open(arguments_value(request->arguments, "midi-in"), request->quiet, receive,
                         midi, &midi->input);
}

void play_midi_status(const PlayMidi *midi, MidiInputStatus *status) {
  *status = (MidiInputStatus){0};
  if (midi && midi->input) midi_input_status(midi->input, status);
}

uint64_t play_midi_ignored(const PlayMidi *midi) { return midi ? atomic_load(&midi->ignored) : 0; }

void play_midi_close(PlayMidi *midi) {
  if (!midi) return;
  midi_input_close(midi->input);
  (void)pthread_mutex_destroy(&midi->lock);
  free(midi);
}
