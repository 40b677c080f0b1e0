/* SPDX-License-Identifier: MIT */
/* Lines of a log: what is written is read back to the bit. */
#include "kit/kit_values.h"
#include "render/log_line.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#ifdef _WIN32
#  define ROOT "Z:\\"
#else
#  define ROOT "/"
#endif

static LogLine read_back(char *text) {
  LogLine line;
  assert_non_null(text);
  const size_t length = strlen(text);
  assert_true(length > 1 && strchr(text, '\n') == text + length - 1);
  assert_int_equal(log_line_read("test:1:", text, length, &line), OUTCOME_OK);
  free(text);
  return line;
}

static void assert_same_number(double a, double b) { assert_memory_equal(&a, &b, sizeof a); }

static void assert_same_message(const PlayerMessage *message) {
  const LogLine line = read_back(log_line_message(message));
  const TaborEvent *const event = &message->event, *const read = &line.message.event;
  assert_int_equal(line.type, LOG_MESSAGE);
  assert_true(line.message.frame == message->frame);
  assert_int_equal(line.message.type, message->type);
  assert_int_equal(line.message.drum, message->drum);
  assert_int_equal(line.message.model, message->model);
  assert_same_number(line.message.value, message->value);
  assert_int_equal(read->type, event->type);
  assert_int_equal(read->id, event->id);
  assert_int_equal(read->striker, event->striker);
  assert_int_equal(read->parameter, event->parameter);
  assert_int_equal(read->index, event->index);
  assert_int_equal(read->technique, event->technique);
  assert_same_number(read->velocity, event->velocity);
  assert_same_number(read->radius, event->radius);
  assert_same_number(read->angle, event->angle);
  assert_same_number(read->value, event->value);
}

/* Numbers that text is most likely to change. */
static const double hard[] = {0.0,
                              -0.0,
                              0.1,
                              1.0 / 3.0,
                              -1.0,
                              1e22,
                              9007199254740993.0,
                              4.9e-324,
                              2.2250738585072014e-308,
                              1.7976931348623157e308,
                              0.30000000000000004,
                              1e-5};
#define HARD (sizeof hard / sizeof hard[0])

static void events_are_read_back_to_the_bit(void **state) {
  (void)state;
  static const uint32_t types[] = {TABOR_EVENT_STRIKE,  TABOR_EVENT_PRESS, TABOR_EVENT_DAMP,
                                   TABOR_EVENT_RELEASE, TABOR_EVENT_RESET, TABOR_EVENT_MOVE,
                                   TABOR_EVENT_SILENCE};
  for (size_t type = 0; type < sizeof types / sizeof types[0]; type++) {
    for (size_t i = 0; i < HARD; i++) {
      const PlayerMessage message = {.frame = i * 1234567890123u,
                                     .type = PLAYER_EVENT,
                                     .event = {.type = types[type],
                                               .id = UINT32_MAX - (uint32_t)i,
                                               .striker = (uint32_t)i,
                                               .index = (uint32_t)i / 2,
                                               .technique = (uint32_t)i % 6,
                                               .velocity = hard[i],
                                               .radius = hard[(i + 1) % HARD],
                                               .angle = hard[(i + 2) % HARD],
                                               .value = hard[(i + 3) % HARD]}};
      assert_same_message(&message);
    }
  }
}

static void every_live_parameter_has_a_name(void **state) {
  (void)state;
  const TaborParameter *parameter;
  unsigned count = 0;
  for (uint32_t i = 0; (parameter = tabor_parameter(i)); i++) {
    if (!parameter->live) continue;
    const PlayerMessage message = {
      .frame = 1,
      .type = PLAYER_EVENT,
      .event = {.type = TABOR_EVENT_PARAMETER, .parameter = parameter->id, .value = 0.1}};
    assert_same_message(&message);
    count++;
  }
  assert_true(count >= 5);
}

static void gains_and_changes_are_read_back(void **state) {
  (void)state;
  for (size_t i = 0; i < HARD; i++) {
    assert_same_message(&(PlayerMessage){.type = PLAYER_GAIN, .value = hard[i]});
    assert_same_message(&(PlayerMessage){.type = PLAYER_EXPRESSION, .value = hard[i]});
  }
  assert_same_message(
    &(PlayerMessage){.type = PLAYER_MODEL, .model = 7, .event = {.type = TABOR_EVENT_SWAP}});
  assert_same_message(
    &(PlayerMessage){.type = PLAYER_MODEL, .model = 8, .event = {.type = TABOR_EVENT_REPLACE}});
}

/* A drum of a kit, all of them, and a sample. */
static void addresses_are_read_back(void **state) {
  (void)state;
  static const uint32_t drums[] = {
    0, 1, TABOR_KIT_DRUMS - 1, TABOR_KIT_ALL, TABOR_KIT_NOTE, TABOR_KIT_NOTE + MIDI_VALUES - 1};
  for (size_t i = 0; i < sizeof drums / sizeof drums[0]; i++) {
    PlayerMessage message = {.frame = 7, .type = PLAYER_EVENT, .drum = drums[i]};
    message.event = (TaborEvent){.type = TABOR_EVENT_STRIKE, .velocity = 1};
    assert_same_message(&message);
    message.event = (TaborEvent){.type = TABOR_EVENT_GAIN, .value = 0.25};
    assert_same_message(&message);
    if (drums[i] >= TABOR_KIT_DRUMS) continue;
    message = (PlayerMessage){.frame = 7,
                              .type = PLAYER_MODEL,
                              .drum = drums[i],
                              .model = 3,
                              .event = {.type = TABOR_EVENT_SWAP}};
    assert_same_message(&message);
  }
}

/* A value of the mix, whose parameters have names of their own. */
static void values_of_a_kit_are_read_back(void **state) {
  (void)state;
  for (uint32_t i = 0; i < KIT_VALUES; i++) {
    assert_same_message(
      &(PlayerMessage){.frame = 9,
                       .type = PLAYER_EVENT,
                       .drum = TABOR_KIT_MIX,
                       .event = {.type = TABOR_EVENT_PARAMETER, .parameter = i, .value = -0.1}});
  }
}

static void check_frames(const LogLine *line, LogLineType type) {
  assert_int_equal(line->type, type);
  assert_true(line->frames == 9007199254740992u);
  assert_int_equal(line->lost, 12);
}

static void mark_and_end_are_read_back(void **state) {
  (void)state;
  const LogLine mark = read_back(log_line_mark(9007199254740992u, 12));
  const LogLine end = read_back(log_line_end(9007199254740992u, 12));
  check_frames(&mark, LOG_MARK);
  check_frames(&end, LOG_END);
}

/* The end is written over the mark, and must cover it. */
static void the_end_is_as_long_as_the_mark(void **state) {
  (void)state;
  char *const mark = log_line_mark(48000, 3), *const end = log_line_end(48000, 3);
  assert_int_equal(strlen(mark), strlen(end));
  free(mark);
  free(end);
}

static void a_cut_line_is_seen(void **state) {
  (void)state;
  char *const line = log_line_end(48000, 3);
  const size_t whole = strlen(line) - 1; /* without its line feed */
  for (size_t size = 0; size < whole; size++) assert_true(log_line_is_cut(line, size));
  assert_false(log_line_is_cut(line, whole));
  free(line);
}

static void check_drum(const TaborModel *model, const LogDrum *drum) {
  const TaborDrumDef *const def = tabor_model_definition(model);
  TaborModelInfo info;
  tabor_model_info(model, &info);
  assert_non_null(drum);
  assert_string_equal(drum->preset, "a \"name\"\\, with \xC3\xA4");
  assert_int_equal(drum->quality, info.quality);
  assert_memory_equal(&drum->def, def, sizeof *def);
}

/* Beyond what presets use: numbers with many digits, wires and lugs of their own. */
static void vary(TaborDrumDef *def, uint32_t seed) {
  char value[32];
  const double third = 1.0 / (3.0 + seed);
  (void)snprintf(value, sizeof value, "%.17g", 0.09 + third / 10); /* on every drum */
  assert_int_equal(tabor_drum_def_set(def, "strike.radius", value, NULL), TABOR_OK);
  (void)snprintf(value, sizeof value, "%.17g", 3000 * (1 + third));
  assert_int_equal(tabor_drum_def_set(def, "batter.tension", value, NULL), TABOR_OK);
  if (def->wires.count < 2) return;
  (void)snprintf(value, sizeof value, "%.17g", 10 * (1 + third));
  assert_int_equal(tabor_drum_def_set(def, "wire.2.tension", value, NULL), TABOR_OK);
}

static void every_preset_is_read_back(void **state) {
  (void)state;
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_DRAFT;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    TaborDrumDef def;
    TaborModel *model;
    assert_int_equal(tabor_drum_def_preset(&def, tabor_preset(i)->name, NULL), TABOR_OK);
    vary(&def, i);
    assert_int_equal(tabor_model_create(&def, &options, &model, NULL), TABOR_OK);
    const char name[] = "a \"name\"\\, with \xC3\xA4";
    const LogStart start = {.program = "1.2.3", .rate = 44100.1, .gain = 0.1, .channels = 1};
    LogLine line = read_back(log_line_start(&start, model, name));
    assert_int_equal(line.type, LOG_START);
    assert_same_number(line.start.rate, start.rate);
    assert_same_number(line.start.gain, start.gain);
    assert_string_equal(line.start.program, start.program);
    assert_int_equal(line.start.channels, 1);
    assert_int_equal(line.start.mics[0], 0);
    check_drum(model, line.drum);
    free(line.drum);
    line = read_back(log_line_model(3, model, name));
    assert_int_equal(line.type, LOG_MODEL);
    assert_int_equal(line.model, 3);
    check_drum(model, line.drum);
    free(line.drum);
    tabor_model_release(model);
  }
}

static void check_kit(const char *name, const TaborKitNoteDef *sample) {
  static TaborKitDef kit;
  TaborModelOptions options;
  TaborDrumDef placed;
  TaborModel *model;
  assert_int_equal(tabor_kit_def_preset(&kit, name, NULL), TABOR_OK);
  for (uint32_t i = 0; i < kit.drum_count; i++) vary(&kit.drum[i].def, i);
  kit.note[42] = *sample;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_DRAFT;
  assert_int_equal(tabor_kit_def_place(&kit, 0, &placed, NULL), TABOR_OK);
  assert_int_equal(tabor_model_create(&placed, &options, &model, NULL), TABOR_OK);
  const LogStart start = {.program = "1", .rate = 48000, .gain = 1, .channels = 2, .kit = &kit};
  const LogLine line = read_back(log_line_start(&start, model, name));
  assert_int_equal(line.type, LOG_START);
  assert_int_equal(line.drum->quality, TABOR_QUALITY_DRAFT);
  assert_string_equal(line.drum->preset, name);
  assert_memory_equal(line.kit, &kit, sizeof kit);
  free(line.drum);
  free(line.kit);
  tabor_model_release(model);
}

static void every_kit_is_read_back(void **state) {
  (void)state;
  /* from the root already, and there */
  static const TaborKitNoteDef sample = {.sample = ROOT, .gain = -0.1, .choke = 3};
  for (uint32_t i = 0; i < tabor_kit_count(); i++) check_kit(tabor_kit(i)->name, &sample);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(events_are_read_back_to_the_bit),
    cmocka_unit_test(every_live_parameter_has_a_name),
    cmocka_unit_test(gains_and_changes_are_read_back),
    cmocka_unit_test(mark_and_end_are_read_back),
    cmocka_unit_test(the_end_is_as_long_as_the_mark),
    cmocka_unit_test(a_cut_line_is_seen),
    cmocka_unit_test(addresses_are_read_back),
    cmocka_unit_test(values_of_a_kit_are_read_back),
    cmocka_unit_test(every_preset_is_read_back),
    cmocka_unit_test(every_kit_is_read_back),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
