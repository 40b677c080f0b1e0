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
  KitMidi *kit; /* in place of map and drum; NULL: a drum is played */
  Humanizer humanizer;
  MidiMask mask;
  Player *player;
  ModelBuilder *const *builders;
  MidiInput *input;
  atomic_uint_least64_t ignored;
  /* under lock */
  pthread_mutex_t lock;
  bool learns;
  uint32_t learner;   /* drum of the kit */
  MidiControl target; /* of the next controller, if it learns */
  int learned;        /* the controller that was learned, until somebody asks; -1 */
};

static void bind(PlayMidi *midi, double now) {
  TaborDrumDef def;
  const uint32_t drums = midi->kit ? midi->kit->count : 1;
  for (uint32_t i = 0; i < drums; i++) {
    MidiToEvents *const drum = midi->kit ? &midi->kit->drums[i] : &midi->drum;
    const MidiMap *const map = midi->kit ? &midi->kit->maps[i] : &midi->map;
    model_builder_definition(midi->builders[i], &def);
    midi_binding_make(map, &def, &drum->binding);
    if (midi->kit) midi->kit->head_radius[i] = def.shell.radius;
  }
  midi->bound = now;
}

Cue play_midi_cue(const MidiAction *action, uint64_t frame) {
  Cue cue = {0};
  if (!player_message_from_midi(action, frame, &cue.message)) {
    cue.preset = tabor_preset(action->preset)->name;
  }
  return cue;
}

/* Under lock: of the drum that learns. */
static MidiMap *map_of(PlayMidi *midi) {
  return midi->kit ? &midi->kit->maps[midi->learner] : &midi->map;
}

static bool is_for(PlayMidi *midi, const MidiMessage *message) {
  const int channel = map_of(midi)->channel;
  return channel == MIDI_OMNI || channel == midi_channel(message);
}

/* Controllers above are messages about the channel. */
static bool may_be_learned(PlayMidi *midi, const MidiMessage *message) {
  return midi_kind(message) == MIDI_CONTROL && message->data[0] < MIDI_CONTROLLERS &&
         is_for(midi, message);
}

static void learn(PlayMidi *midi, const MidiMessage *message, double now) {
  (void)pthread_mutex_lock(&midi->lock);
  const bool learns = midi->learns && may_be_learned(midi, message);
  if (learns) {
    map_of(midi)->controls[message->data[0]] = midi->target;
    midi->learned = message->data[0];
  }
  midi->learns = midi->learns && !learns;
  (void)pthread_mutex_unlock(&midi->lock);
  if (learns) bind(midi, now);
}

void play_midi_learn(PlayMidi *midi, uint32_t drum, const MidiControl *target) {
  (void)pthread_mutex_lock(&midi->lock);
  midi->learns = target != NULL;
  midi->learner = drum;
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
    (void)model_builder_program(midi->builders[0], cue.message.frame, cue.preset); /* it says */
    bind(midi, now);
  } else {
    (void)player_send(midi->player, SOURCE_MIDI, &cue.message); /* counts what it drops */
  }
}

static void take_for_drum(PlayMidi *midi, const MidiMessage *message, double time, double now) {
  MidiAction actions[MIDI_MOST_ACTIONS];
  const uint32_t count = midi_to_events_take(&midi->drum, message, actions);
  atomic_store(&midi->ignored, midi->drum.counts.ignored_notes);
  for (uint32_t i = 0; i < count; i++) act(midi, &actions[i], time, now);
}

static void take_for_kit(PlayMidi *midi, const MidiMessage *message, double time) {
  KitMidi *const kit = midi->kit;
  TaborKitEvent events[KIT_MIDI_MOST_EVENTS];
  const uint32_t count = kit_midi_take(kit, message, events);
  atomic_store(&midi->ignored, kit_midi_unknown(kit));
  for (uint32_t i = 0; i < count; i++) {
    kit_midi_humanize(kit, &midi->humanizer, &events[i]);
    PlayerMessage sent = player_message_from_kit(&events[i]);
    sent.frame = player_frame_at(midi->player, time);
    (void)player_send(midi->player, SOURCE_MIDI, &sent); /* counts what it drops */
  }
}

static void receive(void *context, double time, const MidiMessage *message) {
  PlayMidi *const midi = context;
  const double now = stopwatch_seconds(CLOCK_MONOTONIC);
  if (now - midi->bound > BINDING_AGE) bind(midi, now);
  learn(midi, message, now);
  if (!midi_mask_passes(&midi->mask, message, time)) return;
  if (midi->kit) {
    take_for_kit(midi, message, time);
  } else {
    take_for_drum(midi, message, time, now);
  }
}

static bool begin_map(PlayMidi *midi, const PlayRequest *request) {
  midi->map = request->midi_map;
  midi_to_events_begin(&midi->drum, &midi->map, &(MidiBinding){0});
  if (!request->kit) return true;
  midi->kit = malloc(sizeof *midi->kit);
  if (midi->kit) play_request_kit_midi(request, midi->kit);
  return midi->kit != NULL;
}

Outcome play_midi_open(const PlayRequest *request, Player *player, ModelBuilder *const *builders,
                       PlayMidi **result) {
  PlayMidi *const midi = *result = calloc(1, sizeof *midi);
  if (!midi) return fail_memory();
  (void)pthread_mutex_init(&midi->lock, NULL);
  midi->learned = -1;
  midi->humanizer = request->humanizer;
  midi->mask.time = request->mask_time;
  midi->player = player;
  midi->builders = builders;
  if (!begin_map(midi, request)) return fail_memory();
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
  free(midi->kit);
  free(midi);
}
