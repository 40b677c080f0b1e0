/* SPDX-License-Identifier: MIT */
#include "play/console.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/interrupt.h"
#include "base/keys.h"
#include "base/line_editor.h"
#include "drums/drum_args.h"
#include "platform/clock.h"
#include "platform/terminal.h"
#include "play/controls.h"
#include "ui/notices.h"
#include "ui/play_log.h"
#include "ui/screen.h"

#define WAIT 15           /* for keys [ms] */
#define FRAME 0.05        /* between pictures [s] */
#define MESSAGE_TIME 6.0  /* that a message stands [s] */
#define MESSAGE_LEAST 2.0 /* the same if others wait */
#define ESCAPE_TIME 1.5   /* in which the second Escape quits [s] */
#define KEYS_READ 64      /* bytes at once */

struct Console {
  LiveSession *session;
  Controls controls;
  bool has_keys, has_screen, tells_lines;

  KeyDecoder decoder;
  double byte_time;   /* of the last byte [s] */
  double escape_time; /* of the last key, if that was Escape [s] */
  LineEditor line;
  bool is_typing; /* a command */

  ScreenState screen;
  ParameterPanel panel;
  TaborDrumDef def;        /* of the drum that the keys play */
  TaborHeadDef pitched[2]; /* its heads when their pitches were computed */
  PlayLog log;
  Notices notices;
  double drawn_time, message_time; /* [s] */
  Canvas canvas;
  char bytes[CANVAS_BYTES];
};

static double now(void) { return stopwatch_seconds(CLOCK_MONOTONIC); }

/* ---- saying ---- */

static void show_message(Console *console, const char *text, bool is_trouble) {
  ScreenState *const screen = &console->screen;
  (void)snprintf(screen->message, sizeof screen->message, "%s", text);
  screen->is_trouble = is_trouble;
  console->message_time = now();
}

/* What the last action had to say. */
static void tell_line(Console *console) {
  const Controls *const controls = &console->controls;
  if (!*controls->text) return;
  if (console->has_screen) {
    show_message(console, controls->text, controls->is_trouble);
  } else if (controls->is_trouble || !console->session->request->quiet) {
    note("%s", controls->text);
  }
}

/* Messages of others have their turn, each long enough to be read. */
static void turn_messages(Console *console, double time) {
  char text[NOTICE_SIZE];
  bool is_trouble = false;
  const double age = time - console->message_time;
  const bool is_free = !*console->screen.message || age > MESSAGE_LEAST;
  if (is_free && notices_take(&console->notices, text, &is_trouble)) {
    show_message(console, text, is_trouble);
  } else if (age > MESSAGE_TIME) {
    console->screen.message[0] = '\0';
  }
}

/* ---- keys ---- */

static void begin_command(Console *console) {
  console->is_typing = true;
  console->screen.message[0] = '\0';
  line_editor_begin(&console->line);
}

static void complete_word(Console *console) {
  char word[LINE_SIZE];
  size_t start = 0;
  LineEditor *const line = &console->line;
  if (controls_complete(line->text, line->cursor, &start, word, sizeof word)) {
    line_editor_replace(line, start, word);
  }
}

/* Without a screen, the command line is shown as progress is. */
static void show_typing(const Console *console) {
  char text[LINE_SIZE + 1] = "";
  if (console->has_screen || !isatty(STDERR_FILENO)) return;
  if (console->is_typing) (void)snprintf(text, sizeof text, ":%s", console->line.text);
  status_line(text);
}

static void type(Console *console, Key key, double time) {
  LineOutcome outcome = LINE_EDITING;
  if (key == KEY_TAB) {
    complete_word(console);
  } else {
    outcome = line_editor_take(&console->line, key);
  }
  console->is_typing = outcome == LINE_EDITING;
  show_typing(console);
  if (outcome != LINE_DONE) return;
  controls_run(&console->controls, console->line.text, time);
  tell_line(console);
}

static void escape(Console *console, double time) {
  Controls *const controls = &console->controls;
  if (controls_forget_learning(controls)) {
    tell_line(console);
    return;
  }
  controls->quits = time - console->escape_time < ESCAPE_TIME;
  console->escape_time = time;
  controls->shows_help = console->panel.is_open = false;
  if (controls->quits) return;
  (void)snprintf(controls->text, sizeof controls->text, "Escape again quits");
  controls->is_trouble = false;
  tell_line(console);
}

static void list_keys(const Console *console) {
  char text[SCREEN_HELP_SIZE];
  for (size_t i = 0; screen_help(&console->session->request->keymap, i, text, sizeof text); i++)
    note("%s", text);
}

static void act(Console *console, Key key, double time) {
  Controls *const controls = &console->controls;
  const Action action = keymap_find(&console->session->request->keymap, key);
  controls_act(controls, &action, time);
  tell_line(console);
  if (controls->opens_command) begin_command(console);
  if (controls->opens_command) show_typing(console);
  controls->opens_command = false;
  if (action.kind == ACTION_HELP && !console->has_screen) list_keys(console);
}

/* Typed on as if it had been begun by hand. */
static void begin_typed(Console *console, const char *command) {
  begin_command(console);
  line_editor_replace(&console->line, 0, command);
  show_typing(console);
}

/* False: the key is not the panel's. */
static bool take_panel_key(Console *console, Key key, double time) {
  char command[PANEL_COMMAND_SIZE];
  if (!console->has_screen) return false;
  const PanelWish wish = parameter_panel_take(&console->panel, &console->def, key, command);
  if (wish == PANEL_RUN) {
    controls_run(&console->controls, command, time);
    tell_line(console);
  } else if (wish == PANEL_TYPE) {
    begin_typed(console, command);
  }
  return wish != PANEL_NOTHING;
}

static void take_key(Console *console, Key key, double time) {
  if (console->is_typing) {
    type(console, key, time);
  } else if (take_panel_key(console, key, time)) {
    console->controls.shows_help = false;
  } else if (key == KEY_ESCAPE) {
    escape(console, time);
    return;
  } else {
    act(console, key, time);
  }
  console->escape_time = -ESCAPE_TIME;
}

static void take_keys(Console *console, const Key *keys, size_t count, double time) {
  for (size_t i = 0; i < count; i++) take_key(console, keys[i], time);
}

/* A lone Escape is one once nothing follows. */
static void expire_keys(Console *console, double time) {
  Key keys[KEYS_AT_ONCE];
  if (!key_decoder_waits(&console->decoder)) return;
  if (1e3 * (time - console->byte_time) < KEY_PATIENCE) return;
  take_keys(console, keys, key_decoder_expire(&console->decoder, keys), time);
}

static void read_keys(Console *console) {
  unsigned char bytes[KEYS_READ];
  Key keys[KEYS_AT_ONCE];
  const ptrdiff_t count = terminal_read(bytes, sizeof bytes, WAIT);
  const double time = now();
  if (count > 0) console->byte_time = time;
  if (count < 0) console->controls.quits = true; /* nobody is there any more */
  for (ptrdiff_t i = 0; i < count; i++) {
    take_keys(console, keys, key_decoder_feed(&console->decoder, bytes[i], keys), time);
  }
  expire_keys(console, time);
}

/* ---- showing ---- */

/* A channel keeps its microphone by name; a drum without it lends its first. */
static void name_channels(const PlayRequest *request, const TaborDrumDef *def,
                          ScreenState *screen) {
  for (uint32_t i = 0; i < request->channels; i++) {
    if (request->kit) {
      (void)snprintf(screen->mics[i], sizeof screen->mics[i], "%s", i == 0 ? "left" : "right");
      continue;
    }
    const char *const name = request->def.mic[request->mics[i]].name;
    const int mic = tabor_drum_def_find_mic(def, name);
    memcpy(screen->mics[i], def->mic[mic < 0 ? 0 : mic].name, sizeof screen->mics[i]);
  }
}

static void take_tuning(const TaborDrumDef *def, ScreenTuning *tuning) {
  const bool has_heads = def->body.kind == TABOR_BODY_DRUM;
  tuning->heads[0] = has_heads ? def->batter.tension : 0;
  tuning->heads[1] = has_heads && def->two_headed ? def->resonant.tension : 0;
  tuning->wires = def->wires.tension;
}

/* Which takes some hundredths of a second, and so only where a head has changed. */
static void take_pitches(Console *console) {
  const TaborHeadDef heads[] = {console->def.batter, console->def.resonant};
  ScreenTuning *const tuning = &console->screen.tuning;
  for (uint32_t head = 0; head < 2; head++) {
    if (memcmp(&heads[head], &console->pitched[head], sizeof *heads) == 0) continue;
    console->pitched[head] = heads[head];
    if (tuning->heads[head] == 0 ||
        tabor_drum_def_pitch(&console->def, head, &tuning->pitches[head], NULL) != TABOR_OK)
      tuning->pitches[head] = 0;
  }
}

static void name_heard(const PlayRequest *request, ScreenState *screen) {
  static const char *const rooms[] = {"free air", "a booth", "a studio", "a hall"};
  size_t length = 0;
  for (uint32_t i = 0; i < request->channels && length < sizeof screen->heard; i++)
    length += (size_t)snprintf(screen->heard + length, sizeof screen->heard - length, "%s%s",
                               i > 0 ? ", " : "", screen->mics[i]);
  if (length >= sizeof screen->heard) return;
  const TaborRoomDef *const room = request->kit ? &request->kit->room : &request->def.room;
  const bool has_room = request->kit || arguments_has(request->arguments, "stereo");
  (void)snprintf(screen->heard + length, sizeof screen->heard - length, " in %s",
                 rooms[has_room ? room->kind : TABOR_ROOM_NONE]);
}

static void take_drum(Console *console) {
  const PlayRequest *const request = console->session->request;
  ScreenState *const screen = &console->screen;
  TaborDrumDef *const def = &console->def;
  const uint32_t drum = console->controls.drum;
  model_builder_definition(console->session->builders[drum], def);
  if (request->kit) {
    (void)snprintf(screen->drum, sizeof screen->drum, "%s, %s", request->kit->drum[drum].name,
                   def->name);
  }
  name_channels(request, def, screen);
  name_heard(request, screen);
  screen->head_radius = def->shell.radius;
  screen->has_snares = def->wires.count > 0;
  screen->snares_on = def->wires.strainer > 0;
  screen->is_muffled = def->batter.muffle_strength > 0;
  take_tuning(def, &screen->tuning);
  if (console->has_screen) take_pitches(console);
}

static void take_meters(ScreenState *screen, double seconds) {
  const PlayStatus *const play = &screen->play;
  for (uint32_t i = 0; i < play->channels; i++)
    meter_take(&screen->meters[i], play->peak[i], seconds);
  load_meter_take(&screen->load, play->load_median, play->load_worst, seconds);
}

static void take_controls(Console *console) {
  const Controls *const controls = &console->controls;
  ScreenState *const screen = &console->screen;
  screen->speed = controls->speed;
  screen->humanize = controls->humanizer.amount;
  screen->help = controls->shows_help ? &console->session->request->keymap : NULL;
  screen->line = console->is_typing ? &console->line : NULL;
  screen->panel = console->panel.is_open ? &console->panel : NULL;
  screen->def = &console->def;
}

static void draw(Console *console) {
  const TerminalSize size = terminal_size();
  if (terminal_changed()) canvas_forget(&console->canvas);
  canvas_begin(&console->canvas, size.columns, size.rows);
  screen_draw(&console->screen, &console->canvas);
  const size_t count = canvas_update(&console->canvas, console->bytes);
  if (!terminal_write(console->bytes, count)) canvas_forget(&console->canvas);
}

static void show(Console *console) {
  const double time = now(), passed = time - console->drawn_time;
  if (passed < FRAME) return;
  console->drawn_time = time;
  live_session_status(console->session, &console->screen.play);
  console->screen.quality = quality_name(console->screen.play.quality);
  take_drum(console);
  if (console->has_screen) {
    take_meters(&console->screen, passed);
    take_controls(console);
    turn_messages(console, time);
    draw(console);
  } else {
    play_log_take(&console->log, &console->screen.play, console->screen.head_radius);
  }
}

static Outcome enter_terminal(bool screen) {
  interrupt_at_end(terminal_restore);
  if (terminal_enter(screen)) return OUTCOME_OK;
  return fail("cannot change the terminal's settings: %s", strerror(errno));
}

/* ---- the whole ---- */

/* Without keys there is no screen: nothing on it could be changed. */
static Outcome choose(Console *console) {
  const PlayRequest *const request = console->session->request;
  const TerminalAbilities can = terminal_abilities();
  const bool speaks = !request->quiet && !request->backend->waits;
  console->has_keys = can.keys && !request->backend->waits;
  console->has_screen = console->has_keys && can.screen && !request->no_ui && !request->json;
  console->tells_lines = speaks && (request->no_ui || (console->has_keys && !console->has_screen));
  console->canvas.colour = can.colour;
  console->canvas.utf8 = can.utf8;
  if (!can.keys && speaks) {
    note("the standard input is no terminal%s: there are no keys to play on%s",
         isatty(STDIN_FILENO) ? " of this job" : "",
         request->no_ui ? "" : ", and there is no screen");
  }
  return console->has_keys ? enter_terminal(console->has_screen) : OUTCOME_OK;
}

Outcome console_open(LiveSession *session, Console **created) {
  Console *const console = calloc(1, sizeof *console);
  const PlayRequest *const request = session->request;
  *created = console;
  if (!console) return fail_memory();
  console->session = session;
  console->controls =
    controls_begin(session->player, session->builders, request->kit, session->facts.rate,
                   20 * log10(request->gain), request->humanizer);
  const char *const kit = arguments_value(request->arguments, "kit");
  controls_opened(&console->controls, kit ? kit : request->preset);
  console->controls.midi = session->midi;
  console->controls.midi_map = arguments_value(request->arguments, "midi-map");
  console->escape_time = -ESCAPE_TIME;
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) console->screen.meters[i] = meter_begin();
  const Outcome outcome = choose(console);
  if (outcome != OUTCOME_OK) console->has_screen = false;
  if (console->has_screen) notices_begin(&console->notices);
  return outcome;
}

bool console_turn(void *context) {
  Console *const console = context;
  if (console->has_keys) {
    read_keys(console);
  } else {
    const struct timespec moment = {.tv_nsec = WAIT * 1000000L};
    (void)nanosleep(&moment, NULL);
  }
  if (controls_pass(&console->controls, now())) tell_line(console);
  if (console->has_screen || console->tells_lines) show(console);
  return !console->controls.quits;
}

void console_close(Console *console) {
  if (!console) return;
  console->is_typing = false;
  show_typing(console);
  terminal_leave();
  if (console->has_screen) notices_end(&console->notices);
  free(console);
}
