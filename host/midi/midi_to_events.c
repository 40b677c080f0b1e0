/* SPDX-License-Identifier: MIT */
#include "midi/midi_to_events.h"

#include <math.h>
#include <string.h>

static const double RIM_RADIUS = 0.98;         /* of the head: further out it hardly moves */
static const double CROSS_STICK_RADIUS = 0.6;  /* where its tip lies on the head */
static const double CROSS_STICK_SPEED = 0.3;   /* of a stroke's: see docs/midi.md */
static const double PEDAL_SPEED = 0.25;        /* of a stroke's: a foot's */
static const double PEDAL_CLOSED = 112;        /* the controller's value of a closed hi-hat */
static const double HAND_RADIUS = 0.5;         /* of the head */
static const double HAND_WEAKEST = 0.06;       /* [N s/m] */
static const double HAND_STRONGEST = 6;        /* [N s/m] */
static const double EDGE_RADIUS = 0.97;        /* of a cymbal, where a hand chokes it */
static const double CHOKE = 30;                /* [N s/m] */
static const uint32_t FIRST_HAND = 0xFFFF0000; /* ids of hands; of strokes they stay below */
static const uint32_t FIRST_BUZZ = 0xFFFF0100; /* ids of held sticks, one for each note */
static const double BUZZ_PRESSURE = 0.5;       /* of the range, until key pressure tells */

enum { MODULATION = 1, EXPRESSION = 11, RESET_ALL_CONTROLLERS = 121 };

/* ---- binding ---- */

static MidiParameter find_parameter(const TaborDrumDef *def, const char *key) {
  char text[TABOR_TEXT_SIZE];
  const TaborParameter *const row = tabor_parameter_find(key);
  if (!row || !row->live) return (MidiParameter){0};
  if (tabor_drum_def_get(def, key, text, sizeof text, NULL) != TABOR_OK) return (MidiParameter){0};
  MidiParameter parameter = {.there = true,
                             .id = row->id,
                             .minimum = row->minimum,
                             .maximum = row->maximum,
                             .logarithmic = row->logarithmic};
  if (strncmp(key, "mic.", 4) == 0) {
    char name[TABOR_NAME_SIZE] = "";
    memcpy(name, key + 4, strcspn(key + 4, "."));
    parameter.index = (uint32_t)tabor_drum_def_find_mic(def, name);
  }
  return parameter;
}

static uint32_t find_striker(const TaborDrumDef *def, const char *name) {
  const int wanted = *name ? tabor_drum_def_find_striker(def, name) : -1;
  const int usual = tabor_drum_def_find_striker(def, def->strike.striker);
  if (wanted >= 0) return (uint32_t)wanted;
  return usual > 0 ? (uint32_t)usual : 0;
}

/* The note's striker if it is a brush, else the drum's first brush. */
static uint32_t find_brush(const TaborDrumDef *def, uint32_t wanted) {
  if (def->striker[wanted].kind == TABOR_STRIKER_BRUSH) return wanted;
  for (uint32_t i = 0; i < def->striker_count; i++) {
    if (def->striker[i].kind == TABOR_STRIKER_BRUSH) return i;
  }
  return MIDI_NO_BRUSH;
}

/* Where a cymbal is struck, and with what, unless the note says otherwise. */
typedef struct Place {
  double radius; /* of the cymbal's; 0: nowhere in particular */
  const char *striker;
} Place;

static const Place PLACES[MIDI_STROKE_COUNT] = {[MIDI_STROKE_BELL] = {0.2, "bell"},
                                                [MIDI_STROKE_BOW] = {0.65, "tip"},
                                                [MIDI_STROKE_EDGE] = {0.97, "shoulder"},
                                                [MIDI_STROKE_CLOSED] = {0.65, "tip"},
                                                [MIDI_STROKE_OPEN] = {0.65, "tip"}};

static uint32_t striker_of(const TaborDrumDef *def, const MidiNote *note) {
  const char *placed = PLACES[note->stroke].striker;
  return find_striker(def, *note->striker || !placed ? note->striker : placed);
}

static void bind_sweep(const TaborDrumDef *def, MidiBinding *binding, int note) {
  const uint32_t brush = find_brush(def, binding->strikers[note]);
  binding->strikers[note] = brush;
  if (brush != MIDI_NO_BRUSH) binding->sweep_speed[note] = def->striker[brush].sweep_speed;
}

void midi_binding_make(const MidiMap *map, const TaborDrumDef *def, MidiBinding *binding) {
  memset(binding, 0, sizeof *binding);
  binding->head_radius = def->shell.radius;
  binding->radius = def->strike.radius;
  binding->angle = def->strike.angle;
  binding->striker = find_striker(def, "");
  binding->strainer = def->wires.strainer;
  binding->presets = tabor_preset_count();
  binding->grip = find_parameter(def, "hand.grip");
  binding->strainer_parameter = find_parameter(def, "wires.strainer");
  binding->opening = find_parameter(def, "hihat.opening");
  binding->plate = def->body.kind != TABOR_BODY_DRUM;
  binding->open = def->hihat.open;
  binding->closed = def->hihat.closed;
  for (int i = 0; i < MIDI_VALUES; i++) {
    binding->strikers[i] = striker_of(def, &map->notes[i]);
    if (map->notes[i].stroke == MIDI_STROKE_SWEEP) bind_sweep(def, binding, i);
    if (map->controls[i].target == MIDI_TARGET_PARAMETER) {
      binding->parameters[i] = find_parameter(def, map->controls[i].key);
    }
  }
}

void midi_to_events_begin(MidiToEvents *drum, const MidiMap *map, const MidiBinding *binding) {
  memset(drum, 0, sizeof *drum);
  drum->map = map;
  drum->binding = *binding;
  drum->radius = drum->angle = NAN;
  drum->sweeping = -1;
}

/* ---- notes ---- */

/* Of the note, else of the controller, else of the preset. */
static double choose(double note, double controller, double preset) {
  if (!isnan(note)) return note;
  return isnan(controller) ? preset : controller;
}

static double stroke_radius(const MidiToEvents *drum, const MidiNote *note) {
  const double head = drum->binding.head_radius;
  if (isnan(note->radius) && note->stroke == MIDI_STROKE_CROSS_STICK) {
    return CROSS_STICK_RADIUS * head;
  }
  const double place = PLACES[note->stroke].radius;
  if (isnan(note->radius) && place > 0) return place * head;
  return choose(note->radius * head, drum->radius * head, drum->binding.radius);
}

/* With the prefix, if one came; it is for one note only. */
static double take_velocity(MidiToEvents *drum, const MidiMessage *message) {
  uint8_t *const prefix = &drum->prefixes[midi_channel(message)];
  const double velocity = message->data[1] + *prefix / 128.0;
  *prefix = 0;
  return velocity;
}

static double stroke_speed(const MidiToEvents *drum, const MidiNote *note, double velocity) {
  const double speed = note->speed * midi_speed(drum->map->response, velocity);
  if (note->stroke == MIDI_STROKE_CROSS_STICK) return CROSS_STICK_SPEED * speed;
  return note->stroke == MIDI_STROKE_PEDAL ? PEDAL_SPEED * speed : speed;
}

static uint32_t new_id(MidiToEvents *drum) {
  drum->next_id = drum->next_id % (FIRST_HAND - 1) + 1;
  return drum->next_id;
}

/* The stick of a note that buzzes, at its end or when its key is pressed. */
static bool act_on_stick(MidiToEvents *drum, uint8_t key, TaborEventType type, double pressure,
                         MidiAction *action) {
  if (!drum->held[key]) return false;
  drum->held[key] = type != TABOR_EVENT_RELEASE;
  if (!drum->held[key] && drum->sweeping == key) drum->sweeping = -1;
  action->type = MIDI_ACTION_EVENT;
  action->event = (TaborEvent){.type = type, .id = FIRST_BUZZ + key, .value = pressure};
  return true;
}

/* Of a plain stroke nothing: it ends by itself. */
static bool end_note(MidiToEvents *drum, uint8_t key, MidiAction *action) {
  return act_on_stick(drum, key, TABOR_EVENT_RELEASE, 0, action);
}

static TaborTechnique technique_of(MidiStroke stroke) {
  switch (stroke) {
  case MIDI_STROKE_RIMSHOT: return TABOR_TECHNIQUE_RIMSHOT;
  case MIDI_STROKE_CROSS_STICK: return TABOR_TECHNIQUE_CROSS_STICK;
  case MIDI_STROKE_RIM: return TABOR_TECHNIQUE_RIM;
  case MIDI_STROKE_BUZZ: return TABOR_TECHNIQUE_BUZZ;
  case MIDI_STROKE_SWEEP: return TABOR_TECHNIQUE_SWEEP;
  case MIDI_STROKE_PEDAL: return TABOR_TECHNIQUE_PEDAL;
  default: return TABOR_TECHNIQUE_NORMAL;
  }
}

static void hold(MidiToEvents *drum, uint8_t key, TaborEvent *event) {
  drum->held[key] = true;
  event->id = FIRST_BUZZ + key;
  event->value = BUZZ_PRESSURE;
}

/* The louder the note, the faster the sweep. */
static void sweep(MidiToEvents *drum, uint8_t key, double velocity, TaborEvent *event) {
  hold(drum, key, event);
  drum->sweeping = key;
  event->velocity = drum->map->notes[key].speed * drum->binding.sweep_speed[key] * velocity / 64;
}

/* Notes that need a pedal. */
static bool needs_pedal(MidiStroke stroke) {
  return stroke == MIDI_STROKE_CLOSED || stroke == MIDI_STROKE_OPEN || stroke == MIDI_STROKE_PEDAL;
}

static bool plays(const MidiToEvents *drum, uint8_t key) {
  const MidiStroke stroke = drum->map->notes[key].stroke;
  if (drum->binding.strikers[key] == MIDI_NO_BRUSH) return false;
  return stroke != MIDI_STROKE_NONE && (drum->binding.opening.there || !needs_pedal(stroke));
}

static bool take_note(MidiToEvents *drum, const MidiMessage *message, MidiAction *action) {
  const uint8_t key = message->data[0];
  const MidiNote *const note = &drum->map->notes[key];
  const double velocity = take_velocity(drum, message);
  if (message->data[1] == 0) return end_note(drum, key, action);
  if (!plays(drum, key)) {
    drum->counts.ignored_notes++;
    return false;
  }
  drum->counts.strokes++;
  action->type = MIDI_ACTION_EVENT;
  action->event = (TaborEvent){
    .type = TABOR_EVENT_STRIKE,
    .id = new_id(drum),
    .striker = drum->binding.strikers[key],
    .technique = technique_of(note->stroke),
    .velocity = stroke_speed(drum, note, velocity),
    .radius = stroke_radius(drum, note),
    .angle = choose(note->angle, drum->angle, drum->binding.angle),
  };
  if (note->stroke == MIDI_STROKE_BUZZ) hold(drum, key, &action->event);
  if (note->stroke == MIDI_STROKE_SWEEP) sweep(drum, key, velocity, &action->event);
  return true;
}

/* ---- pressure ---- */

/* By channel or by key pressure: a hand each. */
static bool press_hand(MidiToEvents *drum, uint32_t hand, uint8_t pressure, MidiAction *action) {
  const bool lifts = pressure == 0;
  if (lifts && !drum->hands[hand]) return false;
  drum->hands[hand] = !lifts;
  action->type = MIDI_ACTION_EVENT;
  action->event =
    (TaborEvent){.type = lifts ? TABOR_EVENT_RELEASE : TABOR_EVENT_DAMP, .id = FIRST_HAND + hand};
  if (lifts) return true;
  const bool plate = drum->binding.plate;
  const double strongest = plate ? CHOKE : HAND_STRONGEST;
  action->event.radius = (plate ? EDGE_RADIUS : HAND_RADIUS) * drum->binding.head_radius;
  action->event.angle = drum->binding.angle + 180;
  action->event.value = HAND_WEAKEST * pow(strongest / HAND_WEAKEST, (pressure - 1) / 126.0);
  return true;
}

static bool take_key_pressure(MidiToEvents *drum, const MidiMessage *message, MidiAction *action) {
  const MidiStroke stroke = drum->map->notes[message->data[0]].stroke;
  if (!drum->map->pressure || stroke == MIDI_STROKE_NONE) return false;
  if (stroke == MIDI_STROKE_BUZZ || stroke == MIDI_STROKE_SWEEP) {
    return act_on_stick(drum, message->data[0], TABOR_EVENT_PRESS, message->data[1] / 127.0,
                        action);
  }
  return press_hand(drum, 1, message->data[1], action);
}

/* The channel's is the brush's while one sweeps, else a hand's. */
static bool take_channel_pressure(MidiToEvents *drum, const MidiMessage *message,
                                  MidiAction *action) {
  if (!drum->map->pressure) return false;
  if (drum->sweeping < 0) return press_hand(drum, 0, message->data[0], action);
  return act_on_stick(drum, (uint8_t)drum->sweeping, TABOR_EVENT_PRESS, message->data[0] / 127.0,
                      action);
}

/* ---- controllers ---- */

static bool move_parameter(const MidiParameter *parameter, double value, MidiAction *action) {
  if (!parameter->there) return false;
  action->type = MIDI_ACTION_EVENT;
  action->event = (TaborEvent){.type = TABOR_EVENT_PARAMETER,
                               .parameter = parameter->id,
                               .index = parameter->index,
                               .value = value};
  return true;
}

/* In equal ratios where a control of the parameter should go so and the range allows it. */
static bool move_over(const MidiParameter *parameter, double from, double to, uint8_t value,
                      MidiAction *action) {
  const double part = value / 127.0;
  const bool ratios = parameter->logarithmic && from > 0 && to > 0;
  return move_parameter(parameter, ratios ? from * pow(to / from, part) : from + (to - from) * part,
                        action);
}

/* 64 is what the preset says, whatever that is. */
static double strainer(double preset, uint8_t value) {
  if (value <= 64) return preset * value / 64.0;
  return preset + (1 - preset) * (value - 64) / 63.0;
}

static double opening(const MidiBinding *binding, uint8_t value) {
  if (value <= PEDAL_CLOSED) {
    return binding->open + (binding->closed - binding->open) * value / PEDAL_CLOSED;
  }
  return binding->closed - fabs(binding->closed) * (value - PEDAL_CLOSED) / (127.0 - PEDAL_CLOSED);
}

static double gain(const MidiToEvents *drum) {
  double product = 1;
  for (int i = 0; i < MIDI_VALUES; i++) {
    const double part = drum->values[i] / 127.0;
    if (drum->map->controls[i].target == MIDI_TARGET_GAIN && drum->moved[i]) product *= part * part;
  }
  return product;
}

static bool set_gain(const MidiToEvents *drum, MidiAction *action) {
  action->type = MIDI_ACTION_GAIN;
  action->value = gain(drum);
  return true;
}

/* A silenced drum has no hands and no sticks on it. */
static bool silence(MidiToEvents *drum, MidiAction *action) {
  drum->hands[0] = drum->hands[1] = false;
  memset(drum->held, 0, sizeof drum->held);
  drum->sweeping = -1;
  action->type = MIDI_ACTION_SILENCE;
  return true;
}

/* A brush that sweeps goes to where the controllers say. */
static bool move_brush(const MidiToEvents *drum, MidiAction *action) {
  if (drum->sweeping < 0) return false;
  const MidiBinding *const binding = &drum->binding;
  action->type = MIDI_ACTION_EVENT;
  action->event =
    (TaborEvent){.type = TABOR_EVENT_MOVE,
                 .id = FIRST_BUZZ + (uint32_t)drum->sweeping,
                 .radius = choose(NAN, drum->radius * binding->head_radius, binding->radius),
                 .angle = choose(NAN, drum->angle, binding->angle)};
  return true;
}

static bool move(MidiToEvents *drum, uint8_t number, MidiAction *action) {
  const MidiControl *const control = &drum->map->controls[number];
  const MidiBinding *const binding = &drum->binding;
  const uint8_t value = drum->values[number];
  switch (control->target) {
  case MIDI_TARGET_NONE: break;
  case MIDI_TARGET_RADIUS: drum->radius = RIM_RADIUS * value / 127; return move_brush(drum, action);
  case MIDI_TARGET_ANGLE:
    drum->angle = 360.0 * value / MIDI_VALUES;
    return move_brush(drum, action);
  case MIDI_TARGET_GRIP:
    return move_over(&binding->grip, binding->grip.minimum, binding->grip.maximum, value, action);
  case MIDI_TARGET_STRAINER:
    return move_parameter(&binding->strainer_parameter, strainer(binding->strainer, value), action);
  case MIDI_TARGET_OPENING:
    drum->pedalled = true;
    return move_parameter(&binding->opening, opening(binding, value), action);
  case MIDI_TARGET_GAIN: return set_gain(drum, action);
  case MIDI_TARGET_SILENCE: return silence(drum, action);
  case MIDI_TARGET_PARAMETER:
    return move_over(&binding->parameters[number], control->from, control->to, value, action);
  }
  return false;
}

static bool set_control(MidiToEvents *drum, uint8_t number, uint8_t value, MidiAction *action) {
  drum->values[number] = value;
  drum->moved[number] = true;
  return move(drum, number, action);
}

/* What RP-015 of MIDI's manufacturers resets: see midi_to_events.h. */
static const struct {
  uint8_t number, value;
} RESET_VALUES[] = {{EXPRESSION, 127}, {MODULATION, 0}};

static uint32_t reset_controls(MidiToEvents *drum, uint8_t channel,
                               MidiAction actions[MIDI_MOST_ACTIONS]) {
  uint32_t count = 0;
  drum->prefixes[channel] = 0;
  for (size_t i = 0; i < sizeof RESET_VALUES / sizeof *RESET_VALUES; i++) {
    if (!drum->moved[RESET_VALUES[i].number]) continue;
    actions[count] = (MidiAction){0};
    count += set_control(drum, RESET_VALUES[i].number, RESET_VALUES[i].value, &actions[count]);
  }
  for (uint32_t hand = 0; hand < 2; hand++) {
    actions[count] = (MidiAction){0};
    count += press_hand(drum, hand, 0, &actions[count]);
  }
  return count;
}

static bool take_control(MidiToEvents *drum, const MidiMessage *message, MidiAction *action) {
  const uint8_t number = message->data[0];
  if (number == MIDI_HIGH_RESOLUTION_PREFIX &&
      drum->map->controls[number].target == MIDI_TARGET_NONE) {
    drum->prefixes[midi_channel(message)] = message->data[1];
    return false;
  }
  return set_control(drum, number, message->data[1], action);
}

/* ---- all of them ---- */

static bool choose_preset(const MidiToEvents *drum, uint8_t program, MidiAction *action) {
  if (!drum->map->programs || program >= drum->binding.presets) return false;
  action->type = MIDI_ACTION_PRESET;
  action->preset = program;
  return true;
}

static bool resets_controls(const MidiToEvents *drum, const MidiMessage *message) {
  return midi_kind(message) == MIDI_CONTROL && message->data[0] == RESET_ALL_CONTROLLERS &&
         drum->map->controls[RESET_ALL_CONTROLLERS].target == MIDI_TARGET_NONE;
}

static bool take_one(MidiToEvents *drum, const MidiMessage *message, MidiAction *action) {
  *action = (MidiAction){0};
  switch (midi_kind(message)) {
  case MIDI_NOTE_OFF:
    (void)take_velocity(drum, message);
    return end_note(drum, message->data[0], action);
  case MIDI_NOTE_ON: return take_note(drum, message, action);
  case MIDI_POLY_PRESSURE: return take_key_pressure(drum, message, action);
  case MIDI_CONTROL: return take_control(drum, message, action);
  case MIDI_PROGRAM: return choose_preset(drum, message->data[0], action);
  case MIDI_CHANNEL_PRESSURE: return take_channel_pressure(drum, message, action);
  default: return false;
  }
}

/* Moves the pedal for a note that says where it is. */
static bool set_pedal(const MidiToEvents *drum, const MidiMessage *message, MidiAction *action) {
  const MidiBinding *const binding = &drum->binding;
  if (midi_kind(message) != MIDI_NOTE_ON || message->data[1] == 0 || drum->pedalled) return false;
  *action = (MidiAction){0};
  switch (drum->map->notes[message->data[0]].stroke) {
  case MIDI_STROKE_CLOSED: return move_parameter(&binding->opening, binding->closed, action);
  case MIDI_STROKE_OPEN: return move_parameter(&binding->opening, binding->open, action);
  default: return false;
  }
}

uint32_t midi_to_events_take(MidiToEvents *drum, const MidiMessage *message,
                             MidiAction actions[MIDI_MOST_ACTIONS]) {
  const int channel = drum->map->channel;
  if (channel != MIDI_OMNI && channel != midi_channel(message)) return 0;
  if (resets_controls(drum, message)) return reset_controls(drum, midi_channel(message), actions);
  const uint32_t moved = set_pedal(drum, message, actions) ? 1 : 0;
  return moved + (take_one(drum, message, actions + moved) ? 1 : 0);
}
