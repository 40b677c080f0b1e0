/* SPDX-License-Identifier: MIT */
/* What MIDI bytes do to a drum: host/midi/midi_stream.h, midi_map.h, midi_speed.h,
 * midi_to_events.h. */
#include "midi/midi_to_events.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static const double ROUNDING = 1e-12; /* relative */

static TaborDrumDef def;
static MidiMap map;
static MidiToEvents drum;
static MidiStream stream;
static MidiAction action;

static void begin(void) {
  MidiBinding binding;
  midi_binding_make(&map, &def, &binding);
  midi_to_events_begin(&drum, &map, &binding);
  stream = (MidiStream){0};
}

static int set_up(void **state) {
  (void)state;
  midi_map_default(&map);
  if (tabor_drum_def_preset(&def, "snare-14x5.5", NULL) != TABOR_OK) return -1;
  begin();
  return 0;
}

/* Sends bytes; how many actions they make. The last is in action. */
static unsigned send(const void *bytes, size_t count) {
  unsigned actions = 0;
  MidiMessage message;
  for (size_t i = 0; i < count; i++) {
    const uint8_t byte = ((const uint8_t *)bytes)[i];
    if (!midi_stream_take(&stream, byte, &message)) continue;
    MidiAction made[MIDI_MOST_ACTIONS];
    const uint32_t acts = midi_to_events_take(&drum, &message, made);
    if (acts > 0) action = made[acts - 1];
    actions += acts;
  }
  return actions;
}

static unsigned send3(int status, int first, int second) {
  const uint8_t bytes[] = {(uint8_t)status, (uint8_t)first, (uint8_t)second};
  return send(bytes, status >> 4 == 0xC || status >> 4 == 0xD ? 2 : 3);
}

static void same(double value, double expected) {
  if (!(fabs(value - expected) <= ROUNDING * fabs(expected))) {
    fail_msg("%.17g, expected %.17g", value, expected);
  }
}

static void expect_stroke(double velocity, double radius, double angle) {
  assert_int_equal(action.type, MIDI_ACTION_EVENT);
  assert_int_equal(action.event.type, TABOR_EVENT_STRIKE);
  same(action.event.velocity, velocity);
  same(action.event.radius, radius);
  same(action.event.angle, angle);
}

static double live_value(const char *key, uint32_t index) {
  assert_int_equal(action.type, MIDI_ACTION_EVENT);
  assert_int_equal(action.event.type, TABOR_EVENT_PARAMETER);
  assert_int_equal(action.event.parameter, tabor_parameter_find(key)->id);
  assert_int_equal(action.event.index, index);
  return action.event.value;
}

/* ---- bytes ---- */

static void test_stream(void **state) {
  (void)state;
  assert_int_equal(send("\x26\x64", 2), 0);                             /* data before any status */
  assert_int_equal(send("\x99\x26\x64\x26\x64\x26\x64", 7), 3);         /* running status */
  assert_int_equal(send("\x99\xF8\x26\xFE\x64\xFF\x26\xF8\x64", 9), 2); /* real time inside */
  assert_int_equal(send("\xF0\x7E\x26\x64\x26\xF7\x26\x64", 8),
                   0);                                      /* exclusive, then nothing runs */
  assert_int_equal(send("\xF0\x01\x02\x99\x26\x64", 6), 1); /* that breaks off */
  assert_int_equal(send("\x99\x26\x99\x26\x64", 5), 1);     /* so does a message */
  assert_int_equal(send("\xF2\x26\x64\x26\x64", 5), 0);     /* common ones end the running status */
  assert_int_equal(send("\xF1\x26\x99\x26\x64", 5), 1);
  assert_int_equal(send("\xF6\xF4\xF5\xF7\x99\x26\x64", 7), 1);
  assert_int_equal(send("\xC9\x01\x02", 3), 2);
}

/* Whatever comes, messages are messages. */
static void test_stream_of_anything(void **state) {
  (void)state;
  uint32_t random = 12345;
  unsigned messages = 0;
  for (int i = 0; i < 1000000; i++) {
    random = random * 1664525u + 1013904223u;
    MidiMessage message = {0};
    if (!midi_stream_take(&stream, (uint8_t)(random >> 24), &message)) continue;
    messages++;
    assert_in_range(message.status, 0x80, 0xEF);
    assert_true(message.data[0] < 128 && message.data[1] < 128);
    MidiAction made[MIDI_MOST_ACTIONS];
    const uint32_t acts = midi_to_events_take(&drum, &message, made);
    for (uint32_t k = 0; k < acts; k++) {
      const TaborEvent *const event = &made[k].event;
      assert_true(isfinite(event->velocity) && isfinite(event->radius) && isfinite(event->angle) &&
                  isfinite(event->value) && isfinite(made[k].value));
      assert_true(event->radius >= 0 && event->radius <= def.shell.radius);
    }
  }
  assert_true(messages > 10000);
}

/* ---- notes ---- */

static void test_notes(void **state) {
  (void)state;
  static const struct {
    int note;
    double radius; /* of the head; -1: the preset's stroke */
    TaborTechnique technique;
  } rows[] = {{38, -1, TABOR_TECHNIQUE_NORMAL},  {36, 0, TABOR_TECHNIQUE_NORMAL},
              {40, -1, TABOR_TECHNIQUE_RIMSHOT}, {37, 0.6, TABOR_TECHNIQUE_CROSS_STICK},
              {39, -1, TABOR_TECHNIQUE_RIM},     {41, -1, TABOR_TECHNIQUE_NORMAL},
              {43, -1, TABOR_TECHNIQUE_NORMAL},  {45, -1, TABOR_TECHNIQUE_NORMAL},
              {47, -1, TABOR_TECHNIQUE_NORMAL},  {48, -1, TABOR_TECHNIQUE_NORMAL},
              {50, -1, TABOR_TECHNIQUE_NORMAL}};
  bool mapped[128] = {false};
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    mapped[rows[i].note] = true;
    assert_int_equal(send3(0x90, rows[i].note, 127), 1);
    const double speed = rows[i].technique == TABOR_TECHNIQUE_CROSS_STICK ? 3 : 10;
    expect_stroke(speed, rows[i].radius < 0 ? def.strike.radius : rows[i].radius * def.shell.radius,
                  def.strike.angle);
    assert_int_equal(action.event.id, i + 1);
    assert_int_equal(action.event.technique, rows[i].technique);
    assert_int_equal(send3(0x80, rows[i].note, 127), 0);
    assert_int_equal(send3(0x90, rows[i].note, 0), 0);
  }
  assert_int_equal(drum.counts.ignored_notes, 0);
  for (int note = 0; note < 128; note++) {
    if (!mapped[note]) assert_int_equal(send3(0x9F, note, 64), 0);
  }
  assert_int_equal(drum.counts.ignored_notes, 128 - 11);
  assert_int_equal(drum.counts.strokes, 11);
}

/* Values of the equation in midi_speed.h, at velocities where x, or its power, is a simple
 * fraction. */
static void test_speeds(void **state) {
  (void)state;
  static const struct {
    MidiRange range;
    MidiCurve curve;
    double velocity, speed;
  } rows[] = {
    {MIDI_RANGE_NORMAL, MIDI_CURVE_LINEAR, 73.5, 3.162277660168379},  /* 10^(1/2) */
    {MIDI_RANGE_NORMAL, MIDI_CURVE_LINEAR, 64, 2.577596618133124},    /* 10^(44/107) */
    {MIDI_RANGE_NORMAL, MIDI_CURVE_SOFT, 33.375, 1.778279410038923},  /* 10^((1/8)^(2/3)) */
    {MIDI_RANGE_NORMAL, MIDI_CURVE_HARD, 46.75, 1.333521432163324},   /* 10^((1/4)^(3/2)) */
    {MIDI_RANGE_NORMAL, MIDI_CURVE_LINEAR, 10.5, 0.5477225575051661}, /* 0.3^(1/2) */
    {MIDI_RANGE_NORMAL, MIDI_CURVE_SOFT, 3.375, 0.4053600464421103},  /* 0.3^(3/4) */
    {MIDI_RANGE_NORMAL, MIDI_CURVE_HARD, 5.75, 0.3487234060579145},   /* 0.3^(7/8) */
    {MIDI_RANGE_FULL, MIDI_CURVE_LINEAR, 64, 1.897366596101028},      /* (0.3 12)^(1/2) */
    {MIDI_RANGE_FULL, MIDI_CURVE_SOFT, 16.75, 0.7544600578097612},    /* 0.3 40^(1/4) */
    {MIDI_RANGE_FULL, MIDI_CURVE_HARD, 32.5, 0.4757499525411731},     /* 0.3 40^(1/8) */
  };
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    const MidiResponse response = {rows[i].curve, rows[i].range};
    same(midi_speed(response, rows[i].velocity), rows[i].speed);
  }
}

/* Where the spans of a range meet and end, whatever the curve. */
static void check_ends(MidiResponse response) {
  static const double step =
    1e-9; /* from 20; x of a soft curve moves by 1e-11^(2/3) at most, the speed by 3e-7 */
  const bool full = response.range == MIDI_RANGE_FULL;
  same(midi_speed(response, 1), 0.3);
  same(midi_speed(response, 0), 0.3);
  same(midi_speed(response, 127), full ? 12 : 10);
  same(midi_speed(response, 128), full ? 12 : 10);
  if (full) return;
  same(midi_speed(response, 20), 1);
  assert_true(fabs(midi_speed(response, 20 - step) - 1) < 1e-6);
  assert_true(fabs(midi_speed(response, 20 + step) - 1) < 1e-6);
}

static void check_order(MidiResponse response) {
  const MidiResponse linear = {MIDI_CURVE_LINEAR, response.range};
  double before = 0;
  for (int i = 128; i <= 127 * 128; i++) { /* as fine as controller 88 makes them */
    const double velocity = i / 128.0, speed = midi_speed(response, velocity);
    assert_true(speed > before);
    before = speed;
    if (i == 128 || i == 127 * 128 || (response.range == MIDI_RANGE_NORMAL && i == 20 * 128)) {
      continue;
    }
    if (response.curve == MIDI_CURVE_SOFT) assert_true(speed > midi_speed(linear, velocity));
    if (response.curve == MIDI_CURVE_HARD) assert_true(speed < midi_speed(linear, velocity));
  }
}

static void test_curves(void **state) {
  (void)state;
  for (MidiRange range = MIDI_RANGE_NORMAL; range <= MIDI_RANGE_FULL; range++) {
    for (MidiCurve curve = MIDI_CURVE_SOFT; curve <= MIDI_CURVE_HARD; curve++) {
      check_ends((MidiResponse){curve, range});
      check_order((MidiResponse){curve, range});
    }
  }
}

static void test_velocity(void **state) {
  (void)state;
  assert_int_equal(send3(0x90, 38, 1), 1);
  same(action.event.velocity, 0.3);
  assert_int_equal(send3(0x90, 38, 20), 1);
  same(action.event.velocity, 1);
  map.response = (MidiResponse){MIDI_CURVE_HARD, MIDI_RANGE_FULL};
  assert_int_equal(send3(0x90, 38, 64), 1);
  same(action.event.velocity, midi_speed(map.response, 64));
}

static void test_high_resolution(void **state) {
  (void)state;
  assert_int_equal(send3(0xB0, 88, 64), 0);
  assert_int_equal(send3(0x90, 38, 63), 1);
  same(action.event.velocity, midi_speed(midi_response_default, 63.5));
  assert_int_equal(send3(0x90, 38, 63), 1); /* of one note only */
  same(action.event.velocity, midi_speed(midi_response_default, 63));
  assert_int_equal(send3(0xB1, 88, 64), 0); /* of its channel only */
  assert_int_equal(send3(0x90, 38, 63), 1);
  same(action.event.velocity, midi_speed(midi_response_default, 63));
  assert_int_equal(send3(0xB0, 88, 127), 0);
  assert_int_equal(send3(0x90, 38, 127), 1);
  same(action.event.velocity, 10);
  assert_int_equal(send3(0xB0, 88, 127), 0);
  assert_int_equal(send3(0x80, 38, 0), 0); /* a note's end uses it up */
  assert_int_equal(send3(0x90, 38, 63), 1);
  same(action.event.velocity, midi_speed(midi_response_default, 63));
}

static void test_channels(void **state) {
  (void)state;
  for (int channel = 0; channel < 16; channel++) assert_int_equal(send3(0x90 + channel, 38, 9), 1);
  map.channel = 9;
  for (int channel = 0; channel < 16; channel++) {
    assert_int_equal(send3(0x90 + channel, 38, 9), channel == 9);
    assert_int_equal(send3(0xB0 + channel, 7, 9), channel == 9);
    assert_int_equal(send3(0xC0 + channel, 0, 0), channel == 9);
  }
}

/* ---- controllers ---- */

static void test_place(void **state) {
  (void)state;
  assert_int_equal(send3(0xB0, 16, 127), 0);
  assert_int_equal(send3(0xB0, 17, 32), 0);
  assert_int_equal(send3(0x90, 38, 127), 1);
  expect_stroke(10, 0.98 * def.shell.radius, 90);
  assert_int_equal(send3(0xB5, 16, 0), 0);
  assert_int_equal(send3(0x90, 41, 127), 1);
  expect_stroke(10, 0, 90);
  assert_int_equal(send3(0x90, 37, 127), 1); /* a stick that lies across stays where it is */
  expect_stroke(3, 0.6 * def.shell.radius, 90);
}

static void test_strainer(void **state) {
  (void)state;
  static const struct {
    double preset;
    int value;
    double expected;
  } rows[] = {{1, 0, 0},  {1, 32, 0.5}, {1, 64, 1},  {1, 127, 1},    {0, 0, 0},
              {0, 64, 0}, {0, 127, 1},  {0.5, 0, 0}, {0.5, 64, 0.5}, {0.5, 127, 1}};
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    def.wires.strainer = rows[i].preset;
    begin();
    assert_int_equal(send3(0xB0, 20, rows[i].value), 1);
    same(live_value("wires.strainer", 0), rows[i].expected);
  }
}

static void test_grip(void **state) {
  (void)state;
  const TaborParameter *const grip = tabor_parameter_find("hand.grip");
  const bool there = grip && grip->live;
  assert_int_equal(send3(0xB0, 1, 127), there);
  if (there) same(live_value("hand.grip", 0), grip->maximum);
}

static void test_gain(void **state) {
  (void)state;
  assert_int_equal(send3(0xB0, 7, 127), 1);
  assert_int_equal(action.type, MIDI_ACTION_GAIN);
  same(action.value, 1);
  assert_int_equal(send3(0xB0, 7, 64), 1);
  same(action.value, 64.0 * 64 / (127 * 127));
  assert_int_equal(send3(0xB0, 11, 32), 1);
  same(action.value, 64.0 * 64 / (127 * 127) * 32 * 32 / (127 * 127));
  assert_int_equal(send3(0xB0, 7, 0), 1);
  same(action.value, 0);
}

static void test_silence_and_presets(void **state) {
  (void)state;
  assert_int_equal(send3(0xB0, 120, 0), 1);
  assert_int_equal(action.type, MIDI_ACTION_SILENCE);
  assert_int_equal(send3(0xB0, 123, 0), 1);
  assert_int_equal(action.type, MIDI_ACTION_SILENCE);
  const int presets = (int)tabor_preset_count();
  for (int program = 0; program < 128; program++) {
    assert_int_equal(send3(0xC0, program, 0), program < presets);
    if (program < presets) assert_int_equal(action.preset, program);
  }
  assert_int_equal(action.type, MIDI_ACTION_PRESET);
  map.programs = false;
  assert_int_equal(send3(0xC0, 0, 0), 0);
}

static void expect_hand(double strength, uint32_t *id) {
  assert_int_equal(action.event.type, TABOR_EVENT_DAMP);
  same(action.event.value, strength);
  same(action.event.radius, 0.5 * def.shell.radius);
  *id = action.event.id;
}

static void test_pressure(void **state) {
  (void)state;
  uint32_t channel = 0, key = 0;
  assert_int_equal(send3(0xD0, 0, 0), 0); /* no hand to lift */
  assert_int_equal(send3(0xD0, 127, 0), 1);
  expect_hand(6, &channel);
  assert_int_equal(send3(0xA0, 38, 1), 1);
  expect_hand(0.06, &key);
  assert_int_not_equal(channel, key);
  assert_int_equal(send3(0xA0, 60, 127), 0); /* a key that does nothing */
  assert_int_equal(send3(0xD0, 0, 0), 1);
  assert_int_equal(action.event.type, TABOR_EVENT_RELEASE);
  assert_int_equal(action.event.id, channel);
  assert_int_equal(send3(0xA0, 38, 0), 1);
  assert_int_equal(action.event.id, key);
  map.pressure = false;
  assert_int_equal(send3(0xD0, 127, 0), 0);
  assert_int_equal(send3(0xA0, 38, 127), 0);
}

/* The choke mutes: after a tenth of a second, a tenth of the energy that would be left, or less. */
static void test_choke(void **state) {
  (void)state;
  static const char *const presets[] = {"snare-14x5.5", "tom-12"};
  for (size_t i = 0; i < 2; i++) {
    double stored[2];
    assert_int_equal(tabor_drum_def_preset(&def, presets[i], NULL), TABOR_OK);
    def.wires.unevenness = 0; /* a hand does not stop wires that hang clear of the head */
    def.wires.rest_offset = -5e-5;
    begin();
    TaborModelOptions options;
    TaborModel *model = NULL;
    tabor_model_options_default(&options);
    options.quality = TABOR_QUALITY_DRAFT;
    assert_int_equal(tabor_model_create(&def, &options, &model, NULL), TABOR_OK);
    for (int choked = 0; choked < 2; choked++) {
      TaborDrum *sounding = NULL;
      TaborLedger ledger;
      assert_int_equal(tabor_drum_create(model, &sounding, NULL), TABOR_OK);
      assert_int_equal(send3(0x90, 38, 100), 1);
      tabor_drum_process(sounding, &action.event, 1, NULL, 2400);
      assert_int_equal(send3(0xD0, 127, 0), 1);
      tabor_drum_process(sounding, &action.event, choked, NULL, 4800);
      tabor_drum_ledger(sounding, &ledger);
      stored[choked] = ledger.stored;
      tabor_drum_destroy(sounding);
    }
    tabor_model_release(model);
    printf("%s: %.3g J ringing, %.3g J choked\n", presets[i], stored[0], stored[1]);
    assert_true(stored[1] < 0.1 * stored[0]);
  }
}

/* ---- maps of one's own ---- */

static void test_buzz(void **state) {
  (void)state;
  map.notes[60].stroke = MIDI_STROKE_BUZZ;
  begin();
  assert_int_equal(send3(0x80, 60, 0), 0); /* nothing is held */
  assert_int_equal(send3(0xA0, 60, 9), 0);
  assert_int_equal(send3(0x90, 60, 64), 1);
  assert_int_equal(action.event.type, TABOR_EVENT_STRIKE);
  assert_int_equal(action.event.technique, TABOR_TECHNIQUE_BUZZ);
  const uint32_t id = action.event.id;
  assert_int_equal(send3(0xA0, 60, 127), 1);
  assert_int_equal(action.event.type, TABOR_EVENT_PRESS);
  assert_int_equal(action.event.id, id);
  same(action.event.value, 1);
  assert_int_equal(send3(0x90, 60, 0), 1);
  assert_int_equal(action.event.type, TABOR_EVENT_RELEASE);
  assert_int_equal(action.event.id, id);
  assert_int_equal(send3(0x80, 60, 0), 0); /* it has ended */
  assert_int_equal(send3(0x90, 60, 64), 1);
  assert_int_equal(send3(0xB0, 120, 0), 1);
  assert_int_equal(send3(0x80, 60, 0), 0); /* silence has taken it away */
  assert_int_equal(send3(0x90, 38, 64), 1);
  assert_int_equal(action.event.technique, TABOR_TECHNIQUE_NORMAL);
}

static void expect_move(uint32_t id, double radius, double angle) {
  assert_int_equal(action.event.type, TABOR_EVENT_MOVE);
  assert_int_equal(action.event.id, id);
  same(action.event.radius, radius);
  same(action.event.angle, angle);
  same(action.event.value, 0);
}

/* The drum's brush, whatever its usual striker; place and pressure are its while it lasts. */
static void test_sweep(void **state) {
  (void)state;
  const int brush = tabor_drum_def_find_striker(&def, "brush");
  map.notes[60].stroke = MIDI_STROKE_SWEEP;
  begin();
  assert_int_equal(send3(0xB0, 17, 32), 0); /* nothing sweeps yet */
  assert_int_equal(send3(0x90, 60, 32), 1);
  assert_int_equal(action.event.type, TABOR_EVENT_STRIKE);
  assert_int_equal(action.event.technique, TABOR_TECHNIQUE_SWEEP);
  assert_int_equal(action.event.striker, brush);
  same(action.event.velocity, 0.5 * def.striker[brush].sweep_speed);
  same(action.event.angle, 90);
  const uint32_t id = action.event.id;
  assert_int_equal(send3(0xB0, 16, 127), 1);
  expect_move(id, 0.98 * def.shell.radius, 90);
  assert_int_equal(send3(0xB0, 17, 64), 1);
  expect_move(id, 0.98 * def.shell.radius, 180);
  for (int channel = 0; channel < 2; channel++) {
    assert_int_equal(channel ? send3(0xD0, 127, 0) : send3(0xA0, 60, 127), 1);
    assert_int_equal(action.event.type, TABOR_EVENT_PRESS);
    assert_int_equal(action.event.id, id);
    same(action.event.value, 1);
  }
  assert_int_equal(send3(0x80, 60, 0), 1);
  assert_int_equal(action.event.type, TABOR_EVENT_RELEASE);
  assert_int_equal(action.event.id, id);
  assert_int_equal(send3(0xB0, 16, 0), 0); /* it has ended */
  assert_int_equal(send3(0xD0, 127, 0), 1);
  assert_int_equal(action.event.type, TABOR_EVENT_DAMP);
}

static void test_no_brush(void **state) {
  (void)state;
  map.notes[60].stroke = MIDI_STROKE_SWEEP;
  def.striker_count = 1;
  begin();
  assert_int_equal(send3(0x90, 60, 64), 0);
  assert_int_equal(drum.counts.ignored_notes, 1);
}

static void test_other_map(void **state) {
  (void)state;
  map.notes[60] = (MidiNote){.stroke = MIDI_STROKE_HEAD, .radius = 0.25, .angle = 45, .speed = 0.5};
  map.controls[74] =
    (MidiControl){.target = MIDI_TARGET_PARAMETER, .key = "wires.damping_0", .from = 1, .to = 9};
  map.controls[75] =
    (MidiControl){.target = MIDI_TARGET_PARAMETER, .key = "mic.bottom.gain", .from = 0, .to = 2};
  map.controls[76] =
    (MidiControl){.target = MIDI_TARGET_PARAMETER, .key = "mic.nobody.gain", .from = 0, .to = 2};
  begin();
  assert_int_equal(send3(0xB0, 16, 127), 0);
  assert_int_equal(send3(0x90, 60, 127), 1);
  expect_stroke(5, 0.25 * def.shell.radius, 45);
  assert_int_equal(send3(0xB0, 74, 0), 1);
  same(live_value("wires.damping_0", 0), 1);
  assert_int_equal(send3(0xB0, 74, 127), 1);
  same(live_value("wires.damping_0", 0), 9);
  assert_int_equal(send3(0xB0, 75, 127), 1);
  same(live_value("mic.bottom.gain", 1), 2);
  assert_int_equal(send3(0xB0, 76, 127), 0); /* the drum has none */
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test_setup(test_stream, set_up),
    cmocka_unit_test_setup(test_stream_of_anything, set_up),
    cmocka_unit_test_setup(test_notes, set_up),
    cmocka_unit_test_setup(test_speeds, set_up),
    cmocka_unit_test_setup(test_curves, set_up),
    cmocka_unit_test_setup(test_velocity, set_up),
    cmocka_unit_test_setup(test_high_resolution, set_up),
    cmocka_unit_test_setup(test_channels, set_up),
    cmocka_unit_test_setup(test_place, set_up),
    cmocka_unit_test_setup(test_strainer, set_up),
    cmocka_unit_test_setup(test_grip, set_up),
    cmocka_unit_test_setup(test_gain, set_up),
    cmocka_unit_test_setup(test_silence_and_presets, set_up),
    cmocka_unit_test_setup(test_pressure, set_up),
    cmocka_unit_test_setup(test_choke, set_up),
    cmocka_unit_test_setup(test_buzz, set_up),
    cmocka_unit_test_setup(test_sweep, set_up),
    cmocka_unit_test_setup(test_no_brush, set_up),
    cmocka_unit_test_setup(test_other_map, set_up),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
