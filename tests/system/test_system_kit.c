/* SPDX-License-Identifier: MIT */
/* Kits: the sum of their drums, and drums that hear each other. */
#include "kit/kit.h"
#include "kits.h"

/* ---- the sum --------------------------------------------------------------------------------- */

/* The stereo mix of drums that do not hear each other, without a room. */
static void a_kit_is_its_drums_rendered_alone_and_summed(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"bass-drum-22", "snare-14x5.5", "tom-12"};
  static float left[LENGTH], sum[LENGTH], alone[2][LENGTH], part[3][LENGTH], mics[3][LENGTH];
  TaborKitDef *def = kit_of(3, PRESETS);
  set(def, "kit.coupling", "off");
  set(def, "drum.d1.pan", "-1"); /* its close microphone at the left, by a factor of 1 */
  TaborKit *kit = new_kit(def);
  const TaborKitEvent events[] = {stroke(def, 0, 10, 4.0), stroke(def, 1, 333, 3.0),
                                  stroke(def, 2, 4000, 6.0)};
  TaborKitOutputs outputs = {.stereo = {left, NULL}};
  for (int i = 0; i < 3; i++) {
    outputs.drum[i][0] = part[i];
    outputs.mic[i][0] = mics[i];
  }
  tabor_kit_process(kit, events, 3, &outputs, LENGTH);
  memset(sum, 0, sizeof sum);
  for (uint32_t i = 0; i < 3; i++) {
    TaborModel *model = placed_model(def, i);
    TaborDrum *drum = physics_drum(model);
    const TaborDrumDef *placed = tabor_model_definition(model);
    float *to[TABOR_MAX_MICS] = {alone[0]};
    to[tabor_drum_def_find_mic(placed, TABOR_KIT_LEFT)] = alone[1];
    tabor_drum_process(drum, &events[i].event, 1, to, LENGTH);
    assert_memory_equal(mics[i], alone[0], sizeof alone[0]);
    if (i == 1) {
      for (int f = 0; f < LENGTH; f++) {
        const float far_part = (float)(placed->full_scale / def->full_scale * (double)alone[1][f]);
        assert_true(part[1][f] == far_part + alone[0][f]);
      }
    }
    for (int f = 0; f < LENGTH; f++) sum[f] += part[i][f];
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
  for (int f = 0; f < LENGTH; f++) { /* the mix adds overheads and close microphones apart */
    assert_true(fabs((double)left[f] - (double)sum[f]) < 1e-6);
  }
  tabor_kit_destroy(kit);
  free(def);
}

static void outputs_of_drums_that_a_kit_lacks_stay_as_they_are(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12"};
  static float before[64], mic[64], part[64];
  TaborKitDef *def = kit_of(1, PRESETS);
  TaborKit *kit = new_kit(def);
  for (int i = 0; i < 64; i++) before[i] = mic[i] = part[i] = (float)i;
  TaborKitOutputs outputs = {.stereo = {NULL}};
  outputs.mic[1][0] = mic;
  outputs.drum[1][0] = part;
  tabor_kit_process(kit, NULL, 0, &outputs, 64);
  assert_memory_equal(mic, before, sizeof before);
  assert_memory_equal(part, before, sizeof before);
  tabor_kit_destroy(kit);
  free(def);
}

/* An event past the end of its block acts at the block's last frame, as one of a drum does. */
static void late_events_act_at_the_end_of_their_block(void **state) {
  (void)state;
  enum { BLOCK = 200 };
  static const char *const PRESETS[] = {"tom-12", "tom-12"};
  static float late[LENGTH], last[LENGTH];
  TaborKitDef *def = kit_of(2, PRESETS);
  TaborKit *kit = new_kit(def);
  for (int i = 0; i < 2; i++) {
    float *const to = i == 0 ? late : last;
    const TaborKitEvent event = stroke(def, 1, i == 0 ? BLOCK + 300 : BLOCK - 1, 4.0);
    tabor_kit_reset(kit);
    tabor_kit_process(kit, &event, 1, &(TaborKitOutputs){.stereo = {to}}, BLOCK);
    tabor_kit_process(kit, NULL, 0, &(TaborKitOutputs){.stereo = {to + BLOCK}}, LENGTH - BLOCK);
  }
  assert_memory_equal(late, last, sizeof late);
  assert_false(tabor_kit_is_silent(kit));
  const TaborKitEvent nobody = {.drum = 2, .event = {.frame = BLOCK, .type = TABOR_EVENT_RESET}};
  tabor_kit_process(kit, &nobody, 1, NULL, BLOCK);
  assert_int_equal(tabor_kit_dropped(kit), 1);
  tabor_kit_destroy(kit);
  free(def);
}

/* What a kit of one drum in the middle adds by its room is what the drum's own room adds. */
static void a_room_is_as_loud_for_a_kit_as_for_its_drum(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12"};
  static float dry[LENGTH], both[LENGTH], alone[2][LENGTH], wet[2][LENGTH];
  const double rounding = 1e-3; /* of sums in float */
  TaborKitDef *def = kit_of(1, PRESETS);
  set(def, "drum.d0.height", "0.7"); /* as high as drums stand in a room */
  const TaborKitEvent event = stroke(def, 0, 0, 4.0);
  for (int i = 0; i < 2; i++) {
    if (i == 1) set(def, "room.kind", "studio");
    TaborKit *kit = new_kit(def);
    tabor_kit_process(kit, &event, 1, &(TaborKitOutputs){.stereo = {i ? both : dry}}, LENGTH);
    tabor_kit_destroy(kit);
  }
  TaborModel *model = placed_model(def, 0);
  TaborDrum *drum = physics_drum(model);
  TaborDrumDef placed = *tabor_model_definition(model);
  const int mics[2] = {tabor_drum_def_find_mic(&placed, TABOR_KIT_LEFT),
                       tabor_drum_def_find_mic(&placed, TABOR_KIT_RIGHT)};
  const TaborMicDef pair[2] = {placed.mic[mics[0]], placed.mic[mics[1]]};
  memcpy(placed.mic, pair, sizeof pair); /* late sound differs by the microphone's number */
  placed.mic_count = 2;
  placed.room = def->room;
  TaborRoom *room;
  assert_int_equal(tabor_room_create(&placed, RATE, NULL, &room, NULL), TABOR_OK);
  float *to[TABOR_MAX_MICS] = {NULL};
  to[mics[0]] = alone[0];
  to[mics[1]] = alone[1];
  tabor_drum_process(drum, &event.event, 1, to, LENGTH);
  tabor_room_process(room, (const float *[]){alone[0], alone[1]}, (float *[]){wet[0], wet[1]},
                     LENGTH);
  const double scale = placed.full_scale / def->full_scale;
  double energy = 0.0, error = 0.0;
  for (int f = 0; f < LENGTH; f++) {
    const double expected = scale * (double)wet[0][f];
    const double difference = (double)both[f] - (double)dry[f] - expected;
    energy += expected * expected;
    error += difference * difference;
  }
  print_message("energy of the room %.3g, difference %.1g of it\n", energy, error / energy);
  assert_true(energy > 0.0 && error < rounding * rounding * energy);
  tabor_room_destroy(room);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  free(def);
}

/* Plays the events in blocks of a size. */
static void play_in_blocks(TaborKit *kit, const TaborKitEvent *events, uint32_t count,
                           uint32_t block, float *left, float *right) {
  uint32_t next = 0;
  TaborKitEvent *part = malloc(count * sizeof *part);
  for (uint32_t at = 0; at < LENGTH; at += block) {
    const uint32_t frames = LENGTH - at < block ? LENGTH - at : block;
    uint32_t taken = 0;
    while (next < count && events[next].event.frame < at + frames) {
      part[taken] = events[next++];
      part[taken++].event.frame -= at;
    }
    const TaborKitOutputs outputs = {.stereo = {left + at, right + at}};
    tabor_kit_process(kit, part, taken, &outputs, frames);
  }
  free(part);
}

static void blocks_and_saved_states_change_no_bit(void **state) {
  (void)state;
  static const uint32_t BLOCKS[] = {1, 37, 64, 1000};
  static float whole[2][LENGTH], parts[2][LENGTH];
  static const char *const PRESETS[] = {"tom-12", "snare-14x5.5", "floor-tom-16"};
  TaborKitDef *def = kit_of(3, PRESETS);
  set(def, "room.kind", "booth");
  set(def, "drum.d0.choke", "1");
  set(def, "drum.d2.choke", "1");
  TaborKit *kit = new_kit(def);
  const TaborKitEvent events[] = {stroke(def, 0, 0, 6.0),
                                  stroke(def, 1, 700, 2.0),
                                  value_at(901, TABOR_KIT_COUPLING, 9.0),
                                  stroke(def, 2, 4097, 5.0),
                                  value_at(4950, TABOR_KIT_OVERHEADS, -6.0), /* when it is saved, */
                                  value_at(4951, TABOR_KIT_COUPLING, -120.0)}; /* both move */
  enum { COUNT = sizeof events / sizeof *events };
  play_in_blocks(kit, events, COUNT, LENGTH, whole[0], whole[1]);
  for (size_t b = 0; b < sizeof BLOCKS / sizeof *BLOCKS; b++) {
    tabor_kit_reset(kit);
    play_in_blocks(kit, events, COUNT, BLOCKS[b], parts[0], parts[1]);
    assert_memory_equal(whole, parts, sizeof whole);
  }
  tabor_kit_reset(kit);
  enum { SAVED = 5001 };
  TaborKitOutputs outputs = {.stereo = {parts[0], parts[1]}};
  tabor_kit_process(kit, events, COUNT, &outputs, SAVED);
  const size_t size = tabor_kit_state_size(kit);
  char *bytes = malloc(size);
  tabor_kit_state_save(kit, bytes);
  TaborKit *other = new_kit(def);
  assert_int_equal(tabor_kit_state_load(other, bytes, size), TABOR_OK);
  outputs = (TaborKitOutputs){.stereo = {parts[0] + SAVED, parts[1] + SAVED}};
  tabor_kit_process(other, NULL, 0, &outputs, LENGTH - SAVED);
  /* A silence's fade, as of the choked tom, is not part of a state; it has ended by then. */
  assert_memory_equal(whole[0] + SAVED, parts[0] + SAVED, (LENGTH - SAVED) * sizeof(float));
  bytes[size / 2] ^= 1;
  assert_int_equal(tabor_kit_state_load(other, bytes, size), TABOR_ERROR_STATE);
  assert_int_equal(tabor_kit_state_load(other, bytes, size - 1), TABOR_ERROR_STATE);
  free(bytes);
  tabor_kit_destroy(other);
  tabor_kit_destroy(kit);
  free(def);
}

/* ---- live values ----------------------------------------------------------------------------- */

/* A value that is given before anything was heard is the definition's. */
static void a_first_value_is_as_if_it_were_defined(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12", "tom-12"}, *const VALUES[] = {"-3.7", "-120"};
  static float moved[LENGTH], defined[LENGTH];
  for (int i = 0; i < 2; i++) {
    TaborKitDef *def = kit_of(2, PRESETS);
    TaborKit *kit = new_kit(def);
    const TaborKitEvent events[] = {value_at(0, TABOR_KIT_OVERHEADS, atof(VALUES[i])),
                                    stroke(def, 0, 10, 4.0)};
    tabor_kit_process(kit, events, 2, &(TaborKitOutputs){.stereo = {moved}}, LENGTH);
    tabor_kit_destroy(kit);
    set(def, "kit.overheads", VALUES[i]);
    kit = new_kit(def);
    tabor_kit_process(kit, events + 1, 1, &(TaborKitOutputs){.stereo = {defined}}, LENGTH);
    assert_memory_equal(moved, defined, sizeof moved);
    tabor_kit_destroy(kit);
    free(def);
  }
}

/* Work of the air on a drum that nobody strikes, at a coupling in dB; without wires it must be
 * awake. */
static double heard_work(double coupling, bool live) {
  static const char *const PRESETS[] = {"bass-drum-22", "tom-12"};
  char text[32];
  TaborKitDef *def = kit_of(2, PRESETS);
  snprintf(text, sizeof text, "%g", coupling);
  if (!live) set(def, "kit.coupling", text);
  TaborKit *kit = new_kit(def);
  const TaborKitEvent events[] = {value_at(0, TABOR_KIT_COUPLING, coupling),
                                  stroke(def, 0, 10, 6.0), stroke(def, 1, 10, 0.01)};
  tabor_kit_process(kit, events + !live, live ? 3 : 2, NULL, LENGTH);
  const double work = tb_drum_air_energy(kit->voices[1].drum).work;
  tabor_kit_destroy(kit);
  free(def);
  return work;
}

static void the_coupling_moves_as_it_is_defined(void **state) {
  (void)state;
  const double usual = heard_work(0, false), louder = heard_work(6, false);
  print_message("work of the air %.3g J, at +6 dB %.3g\n", usual, louder);
  assert_true(usual != 0.0 && fabs(louder / usual) > 1.5);
  assert_true(fabs(heard_work(6, true) / louder - 1.0) < 1e-4);
  assert_true(heard_work(0, true) == usual);
  assert_true(heard_work(-120, true) == 0.0);
}

/* From one value to another and back in 5 ms each, without a step; then the sound is as before. */
static void overheads_move_smoothly(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12"};
  static float still[LENGTH], moved[LENGTH];
  TaborKitDef *def = kit_of(1, PRESETS);
  set(def, "drum.d0.gain", "-120");
  TaborKit *kit = new_kit(def);
  const TaborKitEvent events[] = {stroke(def, 0, 0, 4.0), value_at(2000, TABOR_KIT_OVERHEADS, -6.0),
                                  value_at(6000, TABOR_KIT_OVERHEADS, 0.0)};
  const double half = pow(10.0, -6.0 / 20);
  tabor_kit_process(kit, events, 1, &(TaborKitOutputs){.stereo = {still}}, LENGTH);
  tabor_kit_reset(kit);
  tabor_kit_process(kit, events, 3, &(TaborKitOutputs){.stereo = {moved}}, LENGTH);
  for (int f = 0; f < LENGTH; f++) {
    const double down = fmin(fmax((f - 1999) / 240.0, 0.0), 1.0),
                 up = fmin(fmax((f - 5999) / 240.0, 0.0), 1.0);
    const double factor = 1.0 + (half - 1.0) * (down - up);
    assert_true(fabs((double)moved[f] - factor * (double)still[f]) <=
                1e-6 * fabs((double)still[f]));
  }
  tabor_kit_destroy(kit);
  free(def);
}

static void what_is_no_value_of_the_kit_is_dropped(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12"};
  TaborKitDef *def = kit_of(1, PRESETS);
  TaborKit *kit = new_kit(def);
  const TaborKitEvent events[] = {value_at(0, TABOR_KIT_OVERHEADS, 24.1),
                                  value_at(0, TABOR_KIT_OVERHEADS, NAN),
                                  value_at(0, TABOR_KIT_COUPLING, -61.0),
                                  value_at(0, 3, 0.0),
                                  {.drum = TABOR_KIT_MIX, .event = {.type = TABOR_EVENT_STRIKE}},
                                  value_at(0, TABOR_KIT_OVERHEADS, 24.0),
                                  value_at(0, TABOR_KIT_COUPLING, -60.0)};
  tabor_kit_process(kit, events, 7, NULL, 0);
  assert_int_equal(tabor_kit_dropped(kit), 5);
  tabor_kit_destroy(kit);
  set(def, "kit.coupling", "off");
  kit = new_kit(def);
  tabor_kit_process(kit, events + 6, 1, NULL, 64);
  assert_int_equal(tabor_kit_dropped(kit), 1);
  tabor_kit_destroy(kit);
  free(def);
}

static void a_stroke_chokes_its_group(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12", "tom-12", "tom-12"};
  TaborKitDef *def = kit_of(3, PRESETS);
  set(def, "kit.coupling", "off");
  set(def, "drum.d0.choke", "2");
  set(def, "drum.d1.choke", "2");
  TaborKit *kit = new_kit(def);
  const TaborKitEvent events[] = {stroke(def, 0, 0, 4.0), stroke(def, 2, 0, 4.0),
                                  stroke(def, 1, 2000, 4.0)};
  tabor_kit_process(kit, events, 3, NULL, LENGTH);
  assert_true(tabor_drum_is_silent(tabor_kit_drum(kit, 0)));
  assert_false(tabor_drum_is_silent(tabor_kit_drum(kit, 1)));
  assert_false(tabor_drum_is_silent(tabor_kit_drum(kit, 2)));
  const TaborKitEvent nobody = {.drum = 3, .event = {.type = TABOR_EVENT_RESET}};
  tabor_kit_process(kit, &nobody, 1, NULL, 64);
  assert_int_equal(tabor_kit_dropped(kit), 1);
  tabor_kit_destroy(kit);
  free(def);
}

/* ---- floods of events ------------------------------------------------------------------------ */

static uint64_t dropped_by(const TaborKit *kit, uint32_t drum) {
  TaborStatistics statistics;
  tabor_drum_statistics(tabor_kit_drum(kit, drum), &statistics);
  return statistics.dropped_events;
}

enum { FLOOD = 1300 };

/* Strokes, gains, hands, releases and now and then a reset, within 64 frames; nine of ten for
 * drum 1. */
static void draw_flood(const TaborKitDef *def, uint64_t *random, TaborKitEvent events[FLOOD]) {
  static const uint32_t TYPES[] = {TABOR_EVENT_STRIKE, TABOR_EVENT_GAIN,    TABOR_EVENT_GAIN,
                                   TABOR_EVENT_DAMP,   TABOR_EVENT_RELEASE, TABOR_EVENT_GAIN,
                                   TABOR_EVENT_STRIKE, TABOR_EVENT_SILENCE};
  for (uint32_t i = 0; i < FLOOD; i++) {
    TaborKitEvent *const event = &events[i];
    const uint32_t drum = physics_random(random) % 10 < 9 ? 1 : physics_random(random) % 2 * 2;
    *event = stroke(def, drum, i * 64 / FLOOD, 3.0);
    event->event.type =
      physics_random(random) % 100 == 0 ? TABOR_EVENT_RESET : TYPES[physics_random(random) % 8];
    event->event.id = (uint32_t)(physics_random(random) % 4);
    event->event.value = physics_uniform(random, 0.2, 1.0);
  }
}

static void a_flood_of_events_sounds_alike_in_all_blocks(void **state) {
  (void)state;
  static const uint32_t BLOCKS[] = {1, 3, 16, 64, 8192};
  static const char *const PRESETS[] = {"tom-12", "snare-14x5.5", "floor-tom-16"};
  static float first[2][LENGTH], again[2][LENGTH];
  uint64_t random = physics_seed();
  TaborKitDef *def = kit_of(3, PRESETS);
  set(def, "drum.d0.choke", "1");
  set(def, "drum.d2.choke", "1");
  TaborKit *kit = new_kit(def);
  for (int trial = 0; trial < (brief ? 1 : 3); trial++) {
    TaborKitEvent events[FLOOD];
    uint64_t dropped[3];
    draw_flood(def, &random, events);
    for (size_t b = 0; b < sizeof BLOCKS / sizeof *BLOCKS; b++) {
      tabor_kit_reset(kit);
      play_in_blocks(kit, events, FLOOD, BLOCKS[b], b ? again[0] : first[0],
                     b ? again[1] : first[1]);
      if (b) assert_memory_equal(first, again, sizeof first);
      for (uint32_t i = 0; i < 3; i++) {
        if (b) assert_int_equal(dropped_by(kit, i), dropped[i]);
        dropped[i] = dropped_by(kit, i);
      }
    }
    assert_true(dropped[0] + dropped[1] + dropped[2] > 0);
  }
  tabor_kit_destroy(kit);
  free(def);
}

/* A hand that moves too often leaves the drum in debt, which lasts across calls and in a saved
 * state. */
static void a_debt_of_events_is_part_of_the_state(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12"};
  TaborKitDef *def = kit_of(1, PRESETS);
  TaborKit *kit = new_kit(def), *other = new_kit(def);
  TaborKitEvent events[100];
  for (uint32_t i = 0; i < 100; i++) {
    events[i] = (TaborKitEvent){.event = {.type = TABOR_EVENT_DAMP, .id = 1, .value = 1.0}};
  }
  tabor_kit_process(kit, events, 100, NULL, 1);
  const uint64_t dropped = dropped_by(kit, 0);
  assert_int_equal(dropped, 100 - TABOR_BURST);
  char *bytes = malloc(tabor_kit_state_size(kit));
  tabor_kit_state_save(kit, bytes);
  assert_int_equal(tabor_kit_state_load(other, bytes, tabor_kit_state_size(kit)), TABOR_OK);
  tabor_kit_process(other, events, 1, NULL, 1);
  assert_int_equal(dropped_by(other, 0), dropped + 1);
  free(bytes);
  tabor_kit_destroy(other);
  tabor_kit_destroy(kit);
  free(def);
}

static uint32_t in_play(const TaborKit *kit, uint32_t drum) {
  TaborStatistics statistics;
  tabor_drum_statistics(tabor_kit_drum(kit, drum), &statistics);
  return statistics.in_play;
}

/* A buzz that its release ends, whatever other events come at the same frame. */
static void a_release_among_a_thousand_events_ends_its_buzz(void **state) {
  (void)state;
  enum { BUZZ_ID = 7, GAINS = 1000, UNTIL = 4800 };
  static const char *const PRESETS[] = {"snare-14x5.5"};
  TaborKitDef *def = kit_of(1, PRESETS);
  TaborKit *kit = new_kit(def);
  TaborKitEvent buzz = stroke(def, 0, 0, 2.0);
  buzz.event.technique = TABOR_TECHNIQUE_BUZZ;
  buzz.event.value = 0.5;
  buzz.event.id = BUZZ_ID;
  tabor_kit_process(kit, &buzz, 1, NULL, UNTIL);
  assert_int_equal(in_play(kit, 0), 1);
  TaborKitEvent events[GAINS + 1];
  for (int i = 0; i < GAINS; i++) {
    events[i] = (TaborKitEvent){.event = {.type = TABOR_EVENT_GAIN, .value = 1.0}};
  }
  events[GAINS] = (TaborKitEvent){.event = {.type = TABOR_EVENT_RELEASE, .id = BUZZ_ID}};
  tabor_kit_process(kit, events, GAINS + 1, NULL, RATE);
  assert_int_equal(in_play(kit, 0), 0);
  tabor_kit_destroy(kit);
  free(def);
}

/* ---- saved states that are damaged ----------------------------------------------------------- */

/* Each bit of the kit's own head, and 3,000 bits anywhere. */
static void damaged_states_are_refused(void **state) {
  (void)state;
  enum { HEAD = 600, ANYWHERE = 3000 };
  static const char *const PRESETS[] = {"tom-12", "frame-drum"};
  uint64_t random = physics_seed();
  TaborKitDef *def = kit_of(2, PRESETS);
  TaborKit *kit = new_kit(def), *other = new_kit(def);
  const TaborKitEvent event = stroke(def, 0, 0, 4.0);
  tabor_kit_process(kit, &event, 1, NULL, 2048);
  const size_t size = tabor_kit_state_size(kit);
  char *bytes = malloc(size), *after = malloc(size), *before = malloc(size);
  tabor_kit_state_save(kit, bytes);
  tabor_kit_state_save(other, before);
  for (uint32_t i = 0; i < 8 * HEAD + ANYWHERE; i++) {
    const size_t bit = i < 8 * HEAD ? i : physics_random(&random) % (8 * size);
    bytes[bit / 8] ^= (char)(1u << bit % 8);
    assert_int_equal(tabor_kit_state_load(other, bytes, size), TABOR_ERROR_STATE);
    bytes[bit / 8] ^= (char)(1u << bit % 8);
  }
  tabor_kit_state_save(other, after);
  assert_memory_equal(before, after, size);
  assert_int_equal(tabor_kit_state_load(other, bytes, size), TABOR_OK);
  tabor_kit_state_save(other, after);
  assert_memory_equal(bytes, after, size); /* the good one is loaded whole */
  free(before);
  free(after);
  free(bytes);
  tabor_kit_destroy(other);
  tabor_kit_destroy(kit);
  free(def);
}

/* ---- drums that hear each other -------------------------------------------------------------- */

static TaborLedger ledger_of(const TaborKit *kit, uint32_t drum) {
  TaborLedger ledger;
  tabor_drum_ledger(tabor_kit_drum(kit, drum), &ledger);
  return ledger;
}

static uint64_t slept(const TaborKit *kit, uint32_t drum) {
  TaborStatistics statistics;
  tabor_drum_statistics(tabor_kit_drum(kit, drum), &statistics);
  return statistics.slept_frames;
}

/* Work of a tom's stroke on a snare drum with its wires off, which is linear, at a distance [m]. */
static double work_at(double distance, uint64_t *first) {
  static const char *const PRESETS[] = {"tom-12", "snare-14x5.5"};
  TaborKitDef *def = kit_of(2, PRESETS);
  char place[32];
  snprintf(place, sizeof place, "%g", distance);
  set(def, "drum.d1.x", place);
  set(def, "drum.d1.wake", "0"); /* the first sound wakes it */
  set(def, "drum.d1.wires.strainer", "0");
  TaborKit *kit = new_kit(def);
  const TaborKitEvent event = stroke(def, 0, 0, 0.3);
  tabor_kit_process(kit, &event, 1, NULL, LENGTH);
  const double work = ledger_of(kit, 1).injected;
  *first = slept(kit, 1);
  tabor_kit_destroy(kit);
  free(def);
  return work;
}

/* What a head takes from a wave goes with the square of the pressure, which falls with the
 * distance. */
static void sound_falls_with_the_distance_and_takes_its_time(void **state) {
  (void)state;
  uint64_t near_frames, far_frames;
  const double near_work = work_at(1.0, &near_frames), far_work = work_at(2.0, &far_frames);
  const double way = 1.0 / 343.0 * RATE;
  print_message("work at 1 m %.3g J, at 2 m %.3g J; %.0f frames later, expected %.1f\n", near_work,
                far_work, (double)(far_frames - near_frames), way);
  assert_true(fabs(near_work / far_work - 4.0) < 0.02); /* the directions are the same */
  assert_true(fabs((double)(far_frames - near_frames) - way) <= 2.0);
}

/* Heads that all but touch, and that are far apart. */
static void the_shortest_way_takes_a_third_of_a_millisecond(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12", "floor-tom-16"};
  static const char *const PLACES[] = {"0.05", "2"};
  for (int i = 0; i < 2; i++) {
    TaborKitDef *def = kit_of(2, PRESETS);
    set(def, "drum.d1.x", PLACES[i]);
    TaborKit *kit = new_kit(def);
    const uint32_t delay = kit->voices[0].delay[1];
    assert_true(i == 0 ? delay == RATE / 3000 : delay > RATE * 1.5 / 343.0);
    assert_int_equal(kit->piece, i == 0 ? RATE / 3000 : TB_KIT_PIECE);
    tabor_kit_destroy(kit);
    free(def);
  }
}

/* What a tom's stroke gives the other drum [J], after much sound and, if asked for, a reset of the
 * tom. */
static double work_after(TaborKit *kit, const TaborKitDef *def, bool reset) {
  tabor_kit_reset(kit);
  for (int i = 0; i < 4; i++) {
    const TaborKitEvent loud = stroke(def, 0, 0, 8.0);
    tabor_kit_process(kit, &loud, 1, NULL, 2 * LENGTH);
  }
  const TaborKitEvent still = {.event = {.type = TABOR_EVENT_RESET}};
  tabor_kit_process(kit, &still, reset ? 1 : 0, NULL, 15 * LENGTH); /* it dies away all the same */
  const double before = ledger_of(kit, 1).injected;
  for (int i = 0; i < 3; i++) {
    const TaborKitEvent event = stroke(def, 0, 0, 3.0);
    tabor_kit_process(kit, &event, 1, NULL, LENGTH);
  }
  return ledger_of(kit, 1).injected - before;
}

/* The bound on the air takes its sums from no ledger that a reset clears. */
static void a_reset_of_one_drum_leaves_the_air_as_it_is(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12", "snare-14x5.5"};
  TaborKitDef *def = kit_of(2, PRESETS);
  set(def, "drum.d1.wake", "0");
  set(def, "drum.d1.wires.strainer", "0"); /* wires that touch rattle twice alike only from rest */
  TaborKit *kit = new_kit(def);
  const double plain = work_after(kit, def, false), after = work_after(kit, def, true);
  print_message("work of three strokes %.3g J, after a reset %.3g J\n", plain, after);
  assert_true(plain > 0.0 && fabs(after / plain - 1.0) < 1e-6);
  assert_false(kit->muffled);
  tabor_kit_destroy(kit);
  free(def);
}

static void a_tom_makes_the_snares_sound_and_wakes_no_tom(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"tom-12", "snare-14x5.5", "floor-tom-16"};
  TaborKitDef *def = kit_of(3, PRESETS);
  TaborKit *kit = new_kit(def);
  TaborKitEvent event = stroke(def, 0, 0, 5.0);
  tabor_kit_process(kit, &event, 1, NULL, LENGTH);
  assert_true(slept(kit, 1) < 200);
  assert_true(ledger_of(kit, 1).contact_loss > 0.0);
  assert_int_equal(slept(kit, 2), LENGTH);
  for (uint32_t drum = 0; drum < 2; drum++) {
    const TaborLedger ledger = ledger_of(kit, drum);
    assert_true(fabs(ledger.residual) < physics_residual(quality()) * ledger.injected + 1e-15);
  }
  tabor_kit_reset(kit);
  event = stroke(def, 0, 0, 0.02); /* too soft to lift a wire */
  tabor_kit_process(kit, &event, 1, NULL, LENGTH);
  assert_int_equal(slept(kit, 1), LENGTH);
  tabor_kit_destroy(kit);
  free(def);
}

/* Work of the loudest air (engine/src/kit/kit.h) on a head at rest: a force F = 2 p A through 64
 * frames on the mass of the head. */
static double most_work(const TaborDrumDef *def) {
  const double area = 3.14159265358979 * def->shell.radius * def->shell.radius;
  const double impulse = 2.0 * 200.0 * area * 64.0 / RATE;
  return 0.5 * impulse * impulse / (def->batter.surface_density * area);
}

/* Loud air between drums close together: R <= (S + D)/(1 - 1/4). */
static void loud_air_stays_bounded(void **state) {
  (void)state;
  uint64_t random = physics_seed();
  for (int trial = 0; trial < (brief ? 1 : 4); trial++) {
    TaborKitDef *def = malloc(sizeof *def);
    tabor_kit_def_default(def);
    set(def, "kit.coupling", "24");
    static const char *const PRESETS[] = {"tom-12", "floor-tom-16", "bass-drum-22", "frame-drum"};
    for (uint32_t i = 0; i < 4; i++) {
      char key[32];
      snprintf(key, sizeof key, "drum.d%u.preset", i);
      set(def, key, PRESETS[physics_random(&random) % 4]);
      def->drum[i].x = physics_uniform(&random, -0.3, 0.3);
      def->drum[i].y = physics_uniform(&random, -0.3, 0.3);
      def->drum[i].height = physics_uniform(&random, 0.3, 0.9);
      def->drum[i].tilt = physics_uniform(&random, 0.0, 90.0);
    }
    set(def, "kit.overhead_height", "4");
    TaborKit *kit = new_kit(def);
    TaborKitEvent events[4];
    for (uint32_t i = 0; i < 4; i++) events[i] = stroke(def, i, 10 * i, 3.0);
    tabor_kit_process(kit, events, 4, NULL, 3 * LENGTH);
    double strokes = 0.0, radiated = 0.0;
    for (uint32_t i = 0; i < 4; i++) {
      const TaborDrumDef *own = &def->drum[i].def;
      const double mass = own->striker[events[i].event.striker].mass;
      strokes += 0.5 * mass * 3.0 * 3.0;
      strokes += most_work(own);
      radiated += ledger_of(kit, i).radiated;
    }
    print_message("strokes and a piece's work %.3g J, radiated %.3g J\n", strokes, radiated);
    assert_true(radiated <= strokes / 0.75);
    tabor_kit_destroy(kit);
    free(def);
  }
}

int main(int argc, char **argv) {
  const struct CMUnitTest physics[] = {
    cmocka_unit_test(sound_falls_with_the_distance_and_takes_its_time),
    cmocka_unit_test(the_shortest_way_takes_a_third_of_a_millisecond),
  };
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_kit_is_its_drums_rendered_alone_and_summed),
    cmocka_unit_test(outputs_of_drums_that_a_kit_lacks_stay_as_they_are),
    cmocka_unit_test(late_events_act_at_the_end_of_their_block),
    cmocka_unit_test(a_room_is_as_loud_for_a_kit_as_for_its_drum),
    cmocka_unit_test(blocks_and_saved_states_change_no_bit),
    cmocka_unit_test(a_first_value_is_as_if_it_were_defined),
    cmocka_unit_test(the_coupling_moves_as_it_is_defined),
    cmocka_unit_test(overheads_move_smoothly),
    cmocka_unit_test(what_is_no_value_of_the_kit_is_dropped),
    cmocka_unit_test(a_stroke_chokes_its_group),
    cmocka_unit_test(a_flood_of_events_sounds_alike_in_all_blocks),
    cmocka_unit_test(a_debt_of_events_is_part_of_the_state),
    cmocka_unit_test(a_release_among_a_thousand_events_ends_its_buzz),
    cmocka_unit_test(damaged_states_are_refused),
    cmocka_unit_test(a_reset_of_one_drum_leaves_the_air_as_it_is),
    cmocka_unit_test(a_tom_makes_the_snares_sound_and_wakes_no_tom),
    cmocka_unit_test(loud_air_stays_bounded),
  };
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const int failed = brief ? 0 : cmocka_run_group_tests(physics, NULL, NULL);
  return failed + cmocka_run_group_tests(tests, NULL, NULL);
}
