/* SPDX-License-Identifier: MIT */
#include "play/controls.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/folder.h"
#include "base/number.h"
#include "base/suggest.h"
#include "base/text_file.h"
#include "drums/definition_text.h"
#include "drums/drum_args.h"
#include "drums/drum_file.h"
#include "drums/user_presets.h"
#include "kit/kit_args.h"
#include "kit/kit_build.h"
#include "kit/kit_file.h"
#include "midi/midi_map_file.h"
#include "platform/files.h"
#include "play/player_words.h"
#include "ui/command_words.h"

#define LEAST_GAIN (-60.0)
#define LARGEST_GAIN 24.0
#define MUFFLE 2.0 /* [N s/m]: a pad of gel, where the preset has none */
#define BUZZ_PRESSURE 0.2
#define CROSS_STICK_PLACE 0.6 /* of the radius, where its tip lies on the head */
#define BUZZ_TIME 0.3         /* of a buzz, unless its hand strikes again before [s] */
#define SWEEP_PRESSURE 0.5
#define SWEEP_TIME 0.6         /* of a sweep, unless its key comes again before [s] */
#define BRUSH_HAND 2u          /* the one that sweeps */
#define FIRST_HAND 0xFFFFFF00u /* id of its strokes; the others have the next */
#define MUFFLE_PLACE 0.75      /* of the radius: where it lies then */

/* ---- saying ---- */

#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
static void
tell(Controls *controls, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  (void)vsnprintf(controls->text, sizeof controls->text, format, arguments);
  va_end(arguments);
  controls->is_trouble = false;
}

/* What went wrong has been said into the text. */
static void begin_text(Controls *controls) {
  controls->text[0] = '\0';
  controls->is_trouble = true;
}

static void end_text(Controls *controls, MessageCapture before, const char *trouble) {
  message_release(before);
  if (!*trouble) return;
  (void)snprintf(controls->text, sizeof controls->text, "%s", trouble);
  controls->is_trouble = true;
}

/* ---- the drum ---- */

static ModelBuilder *builder_of(const Controls *controls) {
  return controls->builders[controls->drum];
}

/* The first frame that an event of this time can have. */
static uint64_t frame_at(const Controls *controls, double time) {
  return player_frame_at(controls->player, time);
}

static Outcome change(Controls *controls, double time, const char *key, const char *value) {
  return model_builder_set(builder_of(controls), frame_at(controls, time), "set", key, value);
}

static void set_number(Controls *controls, double time, const char *key, double value) {
  char text[32];
  (void)snprintf(text, sizeof text, "%.9g", value);
  (void)change(controls, time, key, text);
}

static void switch_snares(Controls *controls, double time) {
  TaborDrumDef def;
  model_builder_definition(builder_of(controls), &def);
  if (def.wires.count == 0) {
    (void)refuse("this drum has no snares");
    return;
  }
  const bool were_on = def.wires.strainer > 0;
  if (were_on) controls->strainer = def.wires.strainer;
  set_number(controls, time, "wires.strainer", were_on ? 0 : controls->strainer);
  tell(controls, "snares %s", were_on ? "off" : "on");
}

static void switch_muffle(Controls *controls, double time) {
  TaborDrumDef def;
  model_builder_definition(builder_of(controls), &def);
  const bool was_on = def.batter.muffle_strength > 0;
  if (was_on) controls->muffle = def.batter.muffle_strength;
  if (!was_on && def.batter.muffle_radius == 0) {
    set_number(controls, time, "batter.muffle_radius", MUFFLE_PLACE * def.shell.radius);
  }
  set_number(controls, time, "batter.muffle_strength", was_on ? 0 : controls->muffle);
  tell(controls, "muffle %s", was_on ? "off" : "on");
}

/* Another drum has its own. */
static void forget_switches(Controls *controls) {
  controls->strainer = 1;
  controls->muffle = MUFFLE;
}

static void step_preset(Controls *controls, int step, double time) {
  PlayStatus status;
  const uint64_t frame = frame_at(controls, time);
  if (model_builder_step_preset(builder_of(controls), frame, step) != OUTCOME_OK) return;
  forget_switches(controls);
  model_builder_status(builder_of(controls), &status);
  tell(controls, "preset %s", status.preset);
}

/* Its switches are its own. */
static void choose_drum(Controls *controls, uint32_t drum) {
  controls->drum = drum;
  forget_switches(controls);
  tell(controls, "drum %s", controls->kit->drum[drum].name);
}

static void step_drum(Controls *controls, int step) {
  if (!controls->kit) {
    (void)refuse("there is one drum; --kit plays several");
    return;
  }
  const uint32_t count = controls->kit->drum_count;
  choose_drum(controls, (controls->drum + (step < 0 ? count - 1 : 1)) % count);
}

static void set_gain(Controls *controls, double gain_db, double time) {
  controls->gain_db = fmin(fmax(gain_db, LEAST_GAIN), LARGEST_GAIN);
  const PlayerMessage message = {.frame = frame_at(controls, time),
                                 .type = PLAYER_GAIN,
                                 .value = pow(10, controls->gain_db / 20)};
  (void)player_send(controls->player, SOURCE_KEYS, &message);
  tell(controls, "gain %+.1f dB", controls->gain_db);
}

static void set_speed(Controls *controls, double speed) {
  controls->speed = speed;
  tell(controls, "%.2f m/s", speed);
}

/* ---- strokes ---- */

static void send_event(Controls *controls, const TaborEvent *event, double time) {
  const PlayerMessage message = {.frame = frame_at(controls, time),
                                 .type = PLAYER_EVENT,
                                 .drum = controls->drum,
                                 .event = *event};
  (void)player_send(controls->player, SOURCE_KEYS, &message);
}

/* A place is a share of the radius, so that it is the same on every drum. */
static TaborEvent make_stroke(Controls *controls, double place, double speed) {
  TaborDrumDef def;
  model_builder_definition(builder_of(controls), &def);
  const int striker = tabor_drum_def_find_striker(&def, def.strike.striker);
  TaborEvent event = {.type = TABOR_EVENT_STRIKE,
                      .striker = striker > 0 ? (uint32_t)striker : 0,
                      .velocity = speed,
                      .radius = place * def.shell.radius,
                      .angle = def.strike.angle};
  humanize(&controls->humanizer, def.shell.radius, &event);
  return event;
}

static void strike(Controls *controls, double place, double speed, double time) {
  const TaborEvent event = make_stroke(controls, place, speed);
  send_event(controls, &event, time);
  controls->last_place = place;
  controls->last_speed = speed;
}

/* Those that the engine knows stand in its table, in the order of their numbers: -1 if it is none
 * of them. */
static int find_technique(const char *technique) {
  const TaborParameter *const parameter = tabor_parameter_find("strike.technique");
  const char *word = parameter ? parameter->choices : NULL;
  for (int i = 0; word && *word; i++) {
    const size_t length = strcspn(word, "|");
    if (strlen(technique) == length && memcmp(word, technique, length) == 0) return i;
    word += length + (word[length] == '|');
  }
  return -1;
}

/* Hands take turns, so that a key held down is a closed roll. */
static void hold(Controls *controls, TaborEvent *event, double time) {
  event->id = FIRST_HAND + controls->hand;
  event->value = BUZZ_PRESSURE;
  controls->release_time[controls->hand] = time + BUZZ_TIME;
  controls->hand = 1 - controls->hand;
}

/* With the drum's first brush, at its own speed; a key that is held down goes on. */
static void sweep(Controls *controls, double time) {
  TaborDrumDef def;
  model_builder_definition(builder_of(controls), &def);
  uint32_t brush = 0;
  while (brush < def.striker_count && def.striker[brush].kind != TABOR_STRIKER_BRUSH) brush++;
  if (brush == def.striker_count) {
    (void)refuse("this drum has no brush");
    return;
  }
  double *const release = &controls->release_time[BRUSH_HAND];
  const bool goes_on = *release != 0;
  *release = time + SWEEP_TIME;
  if (goes_on) return;
  TaborEvent event = make_stroke(controls, controls->last_place, def.striker[brush].sweep_speed);
  event.id = FIRST_HAND + BRUSH_HAND;
  event.striker = brush;
  event.technique = TABOR_TECHNIQUE_SWEEP;
  event.value = SWEEP_PRESSURE;
  send_event(controls, &event, time);
}

/* Where the last stroke was, as fast as the next; a stick that lies across has its own place. */
static void strike_with(Controls *controls, const char *technique, double time) {
  const int number = find_technique(technique);
  if (number < 0) {
    (void)refuse("%s: this version has no such stroke yet", technique);
    return;
  }
  if (number == TABOR_TECHNIQUE_SWEEP) {
    sweep(controls, time);
    return;
  }
  const bool across = number == TABOR_TECHNIQUE_CROSS_STICK;
  const double place = across ? CROSS_STICK_PLACE : controls->last_place;
  TaborEvent event = make_stroke(controls, place, controls->speed);
  event.technique = (uint32_t)number;
  if (event.technique == TABOR_TECHNIQUE_BUZZ) hold(controls, &event, time);
  send_event(controls, &event, time);
}

static void lift(Controls *controls, double time) {
  for (unsigned hand = 0; hand < CONTROLS_HANDS; hand++) {
    if (controls->release_time[hand] == 0 || time < controls->release_time[hand]) continue;
    controls->release_time[hand] = 0;
    const TaborEvent event = {.type = TABOR_EVENT_RELEASE, .id = FIRST_HAND + hand};
    send_event(controls, &event, time);
  }
}

/* ---- MIDI controllers ---- */

static void run_learn(Controls *controls, const char *text, double time) {
  MidiControl target;
  (void)time;
  MidiInputStatus inputs;
  play_midi_status(controls->midi, &inputs);
  if (inputs.inputs + inputs.own == 0) {
    (void)refuse("learn: there is no MIDI input");
    return;
  }
  if (midi_control_read("learn", text, &target) != OUTCOME_OK) return;
  (void)snprintf(controls->learns, sizeof controls->learns, "%s", text);
  play_midi_learn(controls->midi, controls->drum, &target);
  if (target.target == MIDI_TARGET_NONE) {
    tell(controls, "move the controller that is to do nothing");
  } else {
    tell(controls, "move the controller that is to move %s; Escape cancels", text);
  }
}

/* Where there is no file, it lasts until the end. */
static void keep_learned(Controls *controls, int controller) {
  if (!controls->midi_map) {
    tell(controls, "controller %d moves %s until the end; --midi-map FILE would keep it",
         controller, controls->learns);
  } else if (midi_map_file_add(controls->midi_map, controller, controls->learns) == OUTCOME_OK) {
    tell(controls, "controller %d moves %s, and so does it in %s", controller, controls->learns,
         controls->midi_map);
  }
}

bool controls_forget_learning(Controls *controls) {
  if (!controls->learns[0]) return false;
  controls->learns[0] = '\0';
  play_midi_learn(controls->midi, 0, NULL);
  tell(controls, "no controller is learned");
  return true;
}

bool controls_pass(Controls *controls, double time) {
  lift(controls, time);
  const int controller = play_midi_learned(controls->midi);
  if (controller < 0 || !controls->learns[0]) return false; /* or it was given up meanwhile */
  char trouble[CONTROLS_TEXT_SIZE];
  begin_text(controls);
  const MessageCapture before = message_capture(trouble, sizeof trouble);
  keep_learned(controls, controller);
  controls->learns[0] = '\0';
  end_text(controls, before, trouble);
  return true;
}

/* ---- actions ---- */

static void act(Controls *controls, const Action *action, double time) {
  switch (action->kind) {
  case ACTION_NONE: break;
  case ACTION_STROKE: strike(controls, action->value, controls->speed, time); break;
  case ACTION_GHOST: strike(controls, action->value, GHOST_SPEED * controls->speed, time); break;
  case ACTION_REPEAT: strike(controls, controls->last_place, controls->last_speed, time); break;
  case ACTION_TECHNIQUE: strike_with(controls, action->text, time); break;
  case ACTION_SPEED: set_speed(controls, action->value); break;
  case ACTION_SNARES: switch_snares(controls, time); break;
  case ACTION_MUFFLE: switch_muffle(controls, time); break;
  case ACTION_PRESET: step_preset(controls, action->value < 0 ? -1 : 1, time); break;
  case ACTION_DRUM: step_drum(controls, action->value < 0 ? -1 : 1); break;
  case ACTION_GAIN: set_gain(controls, controls->gain_db + action->value, time); break;
  case ACTION_COMMAND: controls->opens_command = true; break;
  case ACTION_RUN: controls_run(controls, action->text, time); break;
  case ACTION_HELP: controls->shows_help = !controls->shows_help; break;
  case ACTION_QUIT: controls->quits = true; break;
  }
}

void controls_act(Controls *controls, const Action *action, double time) {
  char trouble[CONTROLS_TEXT_SIZE];
  begin_text(controls);
  const MessageCapture before = message_capture(trouble, sizeof trouble);
  act(controls, action, time);
  end_text(controls, before, trouble);
}

#define SNARE_NOTE 38 /* of General MIDI */

static uint32_t first_drum(const TaborKitDef *kit) {
  uint32_t drum = 0;
  while (kit && drum < kit->drum_count && kit->drum[drum].notes[SNARE_NOTE] == 0) drum++;
  return kit && drum < kit->drum_count ? drum : 0;
}

void controls_opened(Controls *controls, const char *name) {
  char room[USER_PRESET_PATH];
  const char *const file = preset_is_file(name) ? name : user_preset_find(name, room);
  (void)snprintf(controls->own, sizeof controls->own, "%s", file ? file : "");
}

Controls controls_begin(Player *player, ModelBuilder *const *builders, const TaborKitDef *kit,
                        double rate, double gain_db, Humanizer humanizer) {
  TaborDrumDef def;
  const uint32_t drum = first_drum(kit);
  model_builder_definition(builders[drum], &def);
  Controls controls = {.player = player,
                       .builders = builders,
                       .kit = kit,
                       .drum = drum,
                       .humanizer = humanizer,
                       .rate = rate,
                       .speed = def.strike.velocity,
                       .gain_db = gain_db,
                       .last_place = def.strike.radius / def.shell.radius,
                       .last_speed = def.strike.velocity};
  forget_switches(&controls);
  if (kit) {
    controls.kit_values[TABOR_KIT_OVERHEADS] = kit->overheads;
    controls.kit_values[TABOR_KIT_COUPLING] = kit->coupled ? kit->coupling : KIT_VALUE_NONE;
  }
  return controls;
}

/* ---- commands ---- */

/* The message has the value as it was typed, with its unit or in other words. */
static void set_words(Controls *controls, double time, const char *key, const char *typed) {
  TaborDrumDef def;
  char room[PLAYER_WORD_SIZE], words[128];
  model_builder_definition(builder_of(controls), &def);
  const char *const value = player_words_read(&def, key, typed, room);
  if (change(controls, time, key, value) != OUTCOME_OK) return;
  model_builder_definition(builder_of(controls), &def);
  player_words_write(&def, key, words, sizeof words);
  const TaborParameter *const parameter = tabor_parameter_find(key);
  const bool is_word = (*value >= 'A' && *value <= 'Z') || (*value >= 'a' && *value <= 'z');
  const char *const unit = parameter && !is_word ? parameter->unit : "";
  tell(controls, "%s = %s%s%s%s", key, value, *unit ? " " : "", unit, words);
}

/* Overheads, coupling and samples of the kit move at once. */
static void set_kit_value(Controls *controls, double time, int value, const char *text) {
  double number = 0;
  if (value == TABOR_KIT_COUPLING && !controls->kit->coupled) {
    (void)refuse("set kit.coupling: this kit was started with it off");
    return;
  }
  if (kit_value_read(value, text, &number) != OUTCOME_OK) return;
  const PlayerMessage message = {
    .frame = frame_at(controls, time),
    .type = PLAYER_EVENT,
    .drum = TABOR_KIT_MIX,
    .event = {.type = TABOR_EVENT_PARAMETER, .parameter = (uint32_t)value, .value = number}};
  if (!player_send(controls->player, SOURCE_KEYS, &message)) return;
  controls->kit_values[value] = number;
  if (number > KIT_VALUE_NONE) {
    tell(controls, "%s = %g dB", kit_value_keys[value], number);
  } else {
    tell(controls, "%s = off", kit_value_keys[value]);
  }
}

static void run_set(Controls *controls, const char *text, double time) {
  const size_t length = strcspn(text, " =");
  char key[CONTROLS_TEXT_SIZE];
  (void)snprintf(key, sizeof key, "%.*s", (int)length, text);
  const char *value = text + length;
  value += strspn(value, " ");
  if (*value == '=') value++;
  value += strspn(value, " ");
  if (!*value) {
    (void)refuse("set %s: the value is missing, as in 'set wires.tension 20'", key);
    return;
  }
  const int kit_value = controls->kit ? kit_value_find(key) : -1;
  if (kit_value >= 0) {
    set_kit_value(controls, time, kit_value, value);
    return;
  }
  if (controls->kit && (strncmp(key, "drum.", 5) == 0 || strncmp(key, "kit.", 4) == 0) &&
      strcmp(key, "drum.name") != 0 && strcmp(key, "drum.comment") != 0) {
    (void)refuse(
      "set %s: keys here are those of one drum, which ':drum NAME' chooses; start with --set "
      "%s=%s for the kit",
      key, key, value);
    return;
  }
  set_words(controls, time, key, value);
}

/* A pitch is kept as the tension that it gives. */
static const char *kept_as(const char *key) {
  if (strcmp(key, "batter.pitch") == 0) return "batter.tension";
  return strcmp(key, "resonant.pitch") == 0 ? "resonant.tension" : key;
}

static void tell_again(Controls *controls, const char *changed) {
  const char *const key = kept_as(changed);
  char words[128], value[TABOR_TEXT_SIZE];
  TaborDrumDef def;
  model_builder_definition(builder_of(controls), &def);
  if (tabor_drum_def_get(&def, key, value, sizeof value, NULL) != TABOR_OK) {
    tell(controls, "%s as before", key);
    return;
  }
  player_words_write(&def, key, words, sizeof words);
  tell(controls, "%s = %.100s again%s", key, value, words);
}

static void run_undo(Controls *controls, const char *text, double time) {
  char key[DRUM_KEY_SIZE];
  (void)text;
  if (model_builder_undo(builder_of(controls), frame_at(controls, time), key) == OUTCOME_OK)
    tell_again(controls, key);
}

static void run_redo(Controls *controls, const char *text, double time) {
  char key[DRUM_KEY_SIZE];
  (void)text;
  if (model_builder_redo(builder_of(controls), frame_at(controls, time), key) == OUTCOME_OK)
    tell_again(controls, key);
}

static bool is_of_this_kind(const Controls *controls, const char *path) {
  char message[2 * TABOR_TEXT_SIZE];
  TaborDrumDef def;
  if (!controls->kit) {
    return drum_file_read(path, &def, message, sizeof message) == PRESET_FILE_OK;
  }
  TaborKitDef *const kit = malloc(sizeof *kit);
  const bool is_kit = kit && kit_file_read(path, kit, message, sizeof message) == PRESET_FILE_OK;
  free(kit);
  return is_kit;
}

/* Keeps what the user wrote: only a drum is replaced by a drum, and a kit by a kit, and only what
   this session has saved or opened before, unless it is told to. */
static Outcome check_replaced(const Controls *controls, const char *path, bool replaces) {
  const char *const kind = controls->kit ? "kit" : "drum";
  if (!file_exists(path)) return OUTCOME_OK;
  if (!is_of_this_kind(controls, path)) return refuse("save: %s is no %s, and stays", path, kind);
  if (replaces || strcmp(path, controls->own) == 0) return OUTCOME_OK;
  return refuse("save: %s is there already; ':save! NAME' replaces it", path);
}

/* Names the file of a user's preset, and makes its folder. */
static Outcome plan_user_preset(const Controls *controls, const char *name,
                                char path[USER_PRESET_PATH]) {
  const char *const kind = controls->kit ? "kit" : "drum";
  if (controls->kit ? kit_is_builtin(name) : preset_place(name) >= 0)
    return refuse("save %s: that is a built-in %s; a name of your own, or a path as ./%s.ini", name,
                  kind, name);
  if (!user_folder(path))
    return refuse("save %s: there is no HOME for it; a path, as ./%s.ini", name, name);
  const Outcome outcome = folder_create_whole(path);
  if (outcome != OUTCOME_OK) return outcome;
  if (!user_preset_path(name, path)) return refuse("save: the name is too long");
  return OUTCOME_OK;
}

/* NULL: what was wrong has been said. */
static char *drum_text(const Controls *controls) {
  TaborDrumDef def;
  TaborError error;
  model_builder_definition(builder_of(controls), &def);
  char *const text = definition_write(&def, TABOR_TEXT_EDIT, "'tabor play'", &error);
  if (!text) (void)report_engine_error(&error);
  return text;
}

/* With its drums as they are now, and sound files where they are, wherever the kit's file will be.
 */
static char *kit_text(const Controls *controls, const char *path) {
  TaborError error;
  TaborKitDef *const kit = malloc(sizeof *kit);
  if (!kit) {
    (void)fail_memory();
    return NULL;
  }
  *kit = *controls->kit;
  for (uint32_t i = 0; i < kit->drum_count; i++) {
    model_builder_definition(controls->builders[i], &kit->drum[i].def);
    kit_fit_mic(&kit->drum[i]);
  }
  for (int i = 0; i < KIT_VALUES; i++) kit_value_define(kit, i, controls->kit_values[i]);
  kit_name_after(kit, path);
  kit_file_root_samples(kit);
  char *const text = definition_write_kit(kit, TABOR_TEXT_EDIT, "'tabor play'", &error);
  if (!text) (void)report_engine_error(&error);
  free(kit);
  return text;
}

static void save(Controls *controls, const char *name, bool replaces) {
  char room[USER_PRESET_PATH];
  const bool is_file = preset_is_file(name);
  const char *const path = is_file ? name : room;
  if (!is_file && plan_user_preset(controls, name, room) != OUTCOME_OK) return;
  if (check_replaced(controls, path, replaces) != OUTCOME_OK) return;
  char *const text = controls->kit ? kit_text(controls, path) : drum_text(controls);
  const Outcome outcome = text ? text_file_write(path, text, false) : OUTCOME_FAILED;
  free(text);
  if (outcome != OUTCOME_OK) return;
  (void)snprintf(controls->own, sizeof controls->own, "%s", path);
  tell(controls, "saved %s", path);
}

static void run_save(Controls *controls, const char *text, double time) {
  (void)time;
  save(controls, text, false);
}

static void run_replace(Controls *controls, const char *text, double time) {
  (void)time;
  save(controls, text, true);
}

static void run_drum(Controls *controls, const char *text, double time) {
  (void)time;
  const int drum = controls->kit ? tabor_kit_def_find(controls->kit, text) : -1;
  if (!controls->kit) {
    (void)refuse("drum %.80s: there is one drum; --kit plays several", text);
  } else if (drum >= 0) {
    choose_drum(controls, (uint32_t)drum);
  } else {
    char hint[512];
    suggest_choice(hint, sizeof hint, text, "", kit_drum_name, controls->kit);
    (void)refuse("drum: the kit has no drum '%.80s'%s", text, hint);
  }
}

static void run_preset(Controls *controls, const char *text, double time) {
  const uint64_t frame = frame_at(controls, time);
  if (model_builder_preset(builder_of(controls), frame, text) != OUTCOME_OK) return;
  forget_switches(controls);
  controls_opened(controls, text);
  tell(controls, "preset %s", text);
}

static bool read_number(const char *name, double minimum, double maximum, const char *text,
                        double *value) {
  const NumberField field = {name, minimum, maximum, false};
  return number_read(&field, text, value) == OUTCOME_OK;
}

static void run_gain(Controls *controls, const char *text, double time) {
  double gain_db = 0;
  if (read_number("gain", LEAST_GAIN, LARGEST_GAIN, text, &gain_db))
    set_gain(controls, gain_db, time);
}

static void run_speed(Controls *controls, const char *text, double time) {
  (void)time;
  double speed = 0;
  if (read_number("speed", 0.01, 30, text, &speed)) set_speed(controls, speed);
}

static void run_humanize(Controls *controls, const char *text, double time) {
  (void)time;
  double amount = 0;
  if (!read_number("humanize", 0, 1, text, &amount)) return;
  controls->humanizer.amount = amount;
  tell(controls, "humanize %g", amount);
}

static void run_silence(Controls *controls, const char *text, double time) {
  (void)text;
  const PlayerMessage message = {.frame = frame_at(controls, time),
                                 .type = PLAYER_EVENT,
                                 .drum = controls->kit ? TABOR_KIT_ALL : 0,
                                 .event = {.type = TABOR_EVENT_SILENCE}};
  (void)player_send(controls->player, SOURCE_KEYS, &message);
  tell(controls, "silence");
}

static void run_help(Controls *controls, const char *text, double time) {
  (void)text;
  (void)time;
  controls->shows_help = true;
}

static void run_quit(Controls *controls, const char *text, double time) {
  (void)text;
  (void)time;
  controls->quits = true;
}

static void run_command(Controls *controls, const char *text, double time) {
  static void (*const runs[COMMAND_WORDS])(Controls *, const char *, double) = {
    [COMMAND_LEARN] = run_learn, [COMMAND_UNDO] = run_undo,         [COMMAND_REDO] = run_redo,
    [COMMAND_SAVE] = run_save,   [COMMAND_REPLACE] = run_replace,   [COMMAND_DRUM] = run_drum,
    [COMMAND_SET] = run_set,     [COMMAND_PRESET] = run_preset,     [COMMAND_GAIN] = run_gain,
    [COMMAND_SPEED] = run_speed, [COMMAND_HUMANIZE] = run_humanize, [COMMAND_SILENCE] = run_silence,
    [COMMAND_HELP] = run_help,   [COMMAND_QUIT] = run_quit,
  };
  CommandWord command;
  const char *rest;
  if (command_words_read(text, &command, &rest) == OUTCOME_OK) runs[command](controls, rest, time);
}

void controls_run(Controls *controls, const char *command, double time) {
  char text[CONTROLS_TEXT_SIZE], trouble[CONTROLS_TEXT_SIZE];
  (void)snprintf(text, sizeof text, "%s", command + strspn(command, " "));
  for (size_t end = strlen(text); end > 0 && text[end - 1] == ' '; end--) text[end - 1] = '\0';
  begin_text(controls);
  if (!*text) return;
  const MessageCapture before = message_capture(trouble, sizeof trouble);
  run_command(controls, text, time);
  end_text(controls, before, trouble);
}

/* ---- completion ---- */

/* Word @p index of those that may stand there, perhaps in @p room; NULL past the last. */
typedef const char *WordAt(size_t index, char room[2 * TABOR_NAME_SIZE]);

static const char *typed_word_at(size_t index, char room[2 * TABOR_NAME_SIZE]) {
  (void)room;
  return command_word_at(NULL, index);
}

static const char *preset_word_at(size_t index, char room[2 * TABOR_NAME_SIZE]) {
  (void)room;
  const TaborPresetInfo *const preset = tabor_preset((uint32_t)index);
  return preset ? preset->name : NULL;
}

/* "wires.tension"; "mic." of those that have a name in between. */
static const char *key_word_at(size_t index, char room[2 * TABOR_NAME_SIZE]) {
  const TaborParameter *const parameter = tabor_parameter((uint32_t)index);
  if (!parameter) return NULL;
  const size_t length = strlen(parameter->section);
  const bool is_family = length > 0 && parameter->section[length - 1] == '.';
  (void)snprintf(room, 2 * TABOR_NAME_SIZE, "%s%s%s", parameter->section, is_family ? "" : ".",
                 is_family ? "" : parameter->key);
  return room;
}

/* Of those that controllers can move. */
static const char *live_key_word_at(size_t index, char room[2 * TABOR_NAME_SIZE]) {
  size_t live = 0;
  for (uint32_t i = 0; tabor_parameter(i); i++) {
    if (tabor_parameter(i)->live && live++ == index) return key_word_at(i, room);
  }
  return NULL;
}

/* Cuts @p word back to what it has in common with @p name. */
static void keep_common(char *word, const char *name) {
  while (*word && *word == *name) {
    word++;
    name++;
  }
  *word = '\0';
}

/* What the first @p length bytes of @p begun can go on to be. */
static bool complete(const char *begun, size_t length, WordAt *word_at, char *word, size_t size) {
  char room[2 * TABOR_NAME_SIZE];
  bool found = false, is_only = true;
  const char *name;
  for (size_t i = 0; (name = word_at(i, room)) != NULL; i++) {
    if (strncmp(name, begun, length) != 0) continue;
    if (!found) {
      (void)snprintf(word, size, "%s", name);
    } else if (strcmp(word, name) != 0) {
      keep_common(word, name);
      is_only = false;
    }
    found = true;
  }
  const size_t end = found ? strlen(word) : 0;
  if (found && is_only && word[end - 1] != '.' && end + 1 < size) {
    word[end] = ' ';
    word[end + 1] = '\0';
  }
  return found;
}

bool controls_complete(const char *command, size_t cursor, size_t *start, char *word, size_t size) {
  static const struct {
    const char *before;
    WordAt *word_at;
  } places[] = {{"", typed_word_at},
                {"set ", key_word_at},
                {"learn ", live_key_word_at},
                {"preset ", preset_word_at}};
  *start = cursor;
  while (*start > 0 && command[*start - 1] != ' ') (*start)--;
  for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
    if (strlen(places[i].before) != *start || strncmp(places[i].before, command, *start) != 0)
      continue;
    return complete(command + *start, cursor - *start, places[i].word_at, word, size);
  }
  return false;
}
