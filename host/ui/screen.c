/* SPDX-License-Identifier: MIT */
#include "ui/screen.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drums/pitch_text.h"

#define LABEL 9          /* columns of what stands in front of a row */
#define METER_NUMBERS 21 /* columns behind a meter: level, peak, light */
#define LOAD_NUMBERS 34
#define SHORTEST_BAR 8
#define LOUD (-3.0) /* from here on a meter is red [dBFS] */
#define DEADLINE_NEAR 0.8

static const char *dash(const Canvas *canvas) { return canvas->utf8 ? "\xc2\xb7" : "-"; }

/* "1:02:03" or "2:03". */
static const char *write_time(double seconds, char *text, size_t size) {
  const unsigned long long whole = seconds > 0 ? (unsigned long long)seconds : 0;
  const unsigned hours = (unsigned)(whole / 3600);
  const unsigned minutes = (unsigned)(whole / 60 % 60), rest = (unsigned)(whole % 60);
  if (hours > 0) {
    (void)snprintf(text, size, "%u:%02u:%02u", hours, minutes, rest);
  } else {
    (void)snprintf(text, size, "%u:%02u", minutes, rest);
  }
  return text;
}

static void draw_label(Canvas *canvas, int row, const char *label) {
  canvas_text(canvas, row, 1, STYLE_FAINT, label);
}

/* ---- rows ---- */

static void draw_title(const ScreenState *state, Canvas *canvas, int row) {
  const PlayStatus *const play = &state->play;
  char right[64], time[24];
  for (int column = 0; column < canvas->columns; column++)
    canvas_put(canvas, row, column, STYLE_REVERSE, ' ');
  int column = canvas_text(canvas, row, 1, STYLE_REVERSE, "tabor  ");
  column = canvas_print(canvas, row, column, STYLE_REVERSE, "%s", play->preset);
  if (*state->drum) {
    column = canvas_print(canvas, row, column, STYLE_REVERSE, " %s %s", dash(canvas), state->drum);
  }
  if (state->quality) {
    column =
      canvas_print(canvas, row, column, STYLE_REVERSE, " %s %s", dash(canvas), state->quality);
  }
  if (play->building) column = canvas_text(canvas, row, column, STYLE_REVERSE, "  (building)");
  (void)snprintf(right, sizeof right, "%s%s ", play->recording ? "REC " : "",
                 write_time(play->time, time, sizeof time));
  const int start = canvas->columns - (int)strlen(right);
  if (start > column + 1) canvas_text(canvas, row, start, STYLE_REVERSE, right);
}

static void draw_device(const ScreenState *state, Canvas *canvas, int row) {
  const PlayStatus *const play = &state->play;
  const char *const device = play->device[0] ? play->device : "no device";
  draw_label(canvas, row, "output");
  canvas_print(canvas, row, LABEL, STYLE_PLAIN, "%s %s %.0f Hz %s %u frames %s latency %.1f ms",
               device, dash(canvas), play->rate, dash(canvas), (unsigned)play->buffer, dash(canvas),
               1e3 * play->latency);
}

/* Where a level stands on the scale. */
static double share_of(double level) { return 1 - level / METER_FLOOR; }

/* The part up to @p share, red where it is loud. */
static void draw_level(Canvas *canvas, int row, int width, double level) {
  const double loud = share_of(LOUD), share = share_of(level);
  canvas_bar(canvas, row, LABEL, width, share, STYLE_BAD);
  canvas_bar(canvas, row, LABEL, width, fmin(share, floor(loud * width) / width), STYLE_GOOD);
}

static void write_level(double level, char *text, size_t size) {
  if (level <= METER_FLOOR) {
    (void)snprintf(text, size, "%6s", "-");
  } else {
    (void)snprintf(text, size, "%+6.1f", level);
  }
}

static void draw_meter(const ScreenState *state, Canvas *canvas, int row, uint32_t channel) {
  const Meter *const meter = &state->meters[channel];
  const int width = canvas->columns - LABEL - METER_NUMBERS;
  char level[16], peak[16], name[LABEL];
  (void)snprintf(name, sizeof name, "%.7s", state->mics[channel]);
  draw_label(canvas, row, name);
  write_level(meter->level, level, sizeof level);
  write_level(meter->peak, peak, sizeof peak);
  int column = LABEL;
  if (width >= SHORTEST_BAR) {
    draw_level(canvas, row, width, meter->level);
    const int mark = (int)lround(share_of(meter->peak) * (width - 1));
    if (meter->peak > METER_FLOOR) {
      canvas_put(canvas, row, LABEL + mark, STYLE_STRONG, canvas->utf8 ? 0x2502 : '|');
    }
    column += width;
  }
  column = canvas_text(canvas, row, column, STYLE_PLAIN, level);
  column = canvas_text(canvas, row, column + 1, STYLE_STRONG, peak);
  if (meter->clip_left > 0) canvas_text(canvas, row, column + 1, STYLE_ALARM, " CLIP ");
}

static void draw_load(const ScreenState *state, Canvas *canvas, int row) {
  const PlayStatus *const play = &state->play;
  const int width = canvas->columns - LABEL - LOAD_NUMBERS;
  const bool is_near = state->load.worst > DEADLINE_NEAR;
  const Style style = is_near ? STYLE_BAD : STYLE_GOOD;
  const double deadline = play->rate > 0 ? 1e3 * play->buffer / play->rate : 0;
  draw_label(canvas, row, "load");
  int column = LABEL;
  if (width >= SHORTEST_BAR) {
    canvas_bar(canvas, row, LABEL, width, state->load.median, style);
    const int mark = (int)lround(fmin(state->load.worst, 1) * (width - 1));
    canvas_put(canvas, row, LABEL + mark, STYLE_STRONG, canvas->utf8 ? 0x2502 : '|');
    column += width + 1;
  }
  column =
    canvas_print(canvas, row, column, STYLE_PLAIN, "%3.0f %%, worst ", 100 * state->load.median);
  column = canvas_print(canvas, row, column, is_near ? STYLE_BAD : STYLE_PLAIN, "%3.0f %%",
                        100 * state->load.worst);
  canvas_print(canvas, row, column, STYLE_PLAIN, " of %.2f ms", deadline);
}

/* "name 12", marked if it should be 0 and is not. */
static int draw_count(Canvas *canvas, int row, int column, const char *name, uint64_t count,
                      bool is_trouble) {
  const Style style = is_trouble && count > 0 ? STYLE_BAD : STYLE_PLAIN;
  column = canvas_print(canvas, row, column, style, "%s %llu", name, (unsigned long long)count);
  return column + 3;
}

static void draw_health(const ScreenState *state, Canvas *canvas, int row) {
  const PlayStatus *const play = &state->play;
  draw_label(canvas, row, "health");
  int column = draw_count(canvas, row, LABEL, "xruns", play->xruns, true);
  column = draw_count(canvas, row, column, "clipped", play->clipped, true);
  column = draw_count(canvas, row, column, "late", play->late, false);
  column = draw_count(canvas, row, column, "dropped", play->dropped, true);
  if (play->recovered > 0)
    column = draw_count(canvas, row, column, "resets", play->recovered, true);
  if (play->lost_frames > 0)
    column = draw_count(canvas, row, column, "lost frames", play->lost_frames, true);
  if (play->ignored_notes > 0)
    draw_count(canvas, row, column, "notes that play nothing", play->ignored_notes, true);
}

static void draw_drum(const ScreenState *state, Canvas *canvas, int row) {
  const PlayStatus *const play = &state->play;
  draw_label(canvas, row, "drum");
  int column = canvas_text(canvas, row, LABEL, play->sleeping ? STYLE_FAINT : STYLE_STRONG,
                           play->sleeping ? "asleep " : "sounds ");
  column = draw_count(canvas, row, column + 2, "strokes", play->strokes, false);
  draw_count(canvas, row, column, "strikers", play->strikers, false);
}

static int draw_head(Canvas *canvas, int row, int column, const char *name, double tension,
                     double pitch) {
  char note[32];
  column = canvas_print(canvas, row, column, STYLE_PLAIN, "%s ", name);
  if (pitch > 0) {
    (void)pitch_text(pitch, note, sizeof note);
    column = canvas_print(canvas, row, column, STYLE_STRONG, "%s, ", note);
  }
  return canvas_print(canvas, row, column, STYLE_PLAIN, "%.0f N/m", tension);
}

/* A plate has no tension. */
static void draw_tuning(const ScreenState *state, Canvas *canvas, int row) {
  const ScreenTuning *const tuning = &state->tuning;
  draw_label(canvas, row, "tuning");
  if (tuning->heads[0] == 0) {
    canvas_text(canvas, row, LABEL, STYLE_FAINT, "a plate: none");
    return;
  }
  int column = draw_head(canvas, row, LABEL, "batter", tuning->heads[0], tuning->pitches[0]);
  if (tuning->heads[1] > 0)
    column = draw_head(canvas, row, column + 3, "resonant", tuning->heads[1], tuning->pitches[1]);
  if (state->has_snares)
    canvas_print(canvas, row, column + 3, STYLE_PLAIN, "wires %.3g N", tuning->wires);
}

const char *screen_event(const TaborEvent *event, double head_radius, char *text, size_t size) {
  const double place = head_radius > 0 ? 100 * event->radius / head_radius : 0;
  text[0] = '\0';
  switch (event->type) {
  case TABOR_EVENT_STRIKE:
    (void)snprintf(text, size, "stroke at %.0f %% of the radius, %.0f degrees, %.2f m/s", place,
                   event->angle, event->velocity);
    break;
  case TABOR_EVENT_PRESS: (void)snprintf(text, size, "press %.2f", event->value); break;
  case TABOR_EVENT_DAMP:
    (void)snprintf(text, size, "hand on the head, %.2f N s/m", event->value);
    break;
  case TABOR_EVENT_RELEASE: (void)snprintf(text, size, "release"); break;
  case TABOR_EVENT_PARAMETER: (void)snprintf(text, size, "parameter to %g", event->value); break;
  case TABOR_EVENT_SWAP: (void)snprintf(text, size, "another drum"); break;
  case TABOR_EVENT_RESET: (void)snprintf(text, size, "silence"); break;
  default: break;
  }
  return text;
}

static void draw_last(const ScreenState *state, Canvas *canvas, int row) {
  char text[CANVAS_COLUMNS];
  const TaborEvent *const event = &state->play.last_event;
  draw_label(canvas, row, "last");
  screen_event(event, state->head_radius, text, sizeof text);
  const int column = canvas_text(canvas, row, LABEL, STYLE_PLAIN, *text ? text : "nothing yet");
  if (*text) canvas_print(canvas, row, column, STYLE_FAINT, ", at %.2f s", state->play.last_time);
}

static void draw_heard(const ScreenState *state, Canvas *canvas, int row) {
  draw_label(canvas, row, "heard");
  canvas_text(canvas, row, LABEL, STYLE_PLAIN, state->heard);
}

static void draw_settings(const ScreenState *state, Canvas *canvas, int row) {
  const double gain = state->play.gain > 0 ? 20 * log10(state->play.gain) : -INFINITY;
  draw_label(canvas, row, "next");
  int column = canvas_print(canvas, row, LABEL, STYLE_STRONG, "%.2f m/s", state->speed);
  column = canvas_print(canvas, row, column + 3, STYLE_PLAIN, "gain %+.1f dB", gain);
  if (state->has_snares) {
    column = canvas_print(canvas, row, column + 3, STYLE_PLAIN, "snares %s",
                          state->snares_on ? "on" : "off");
  }
  column = canvas_print(canvas, row, column + 3, STYLE_PLAIN, "muffle %s",
                        state->is_muffled ? "on" : "off");
  canvas_print(canvas, row, column + 3, STYLE_PLAIN, "humanize %.2g", state->humanize);
}

/* Bytes of @p text that fit into so many columns, up to a blank if there is one. */
static size_t fitting(const char *text, int columns) {
  size_t bytes = 0, blank = 0;
  for (int column = 0; text[bytes]; bytes++) {
    if (((unsigned char)text[bytes] & 0xC0u) != 0x80u && column++ == columns) {
      return blank > 0 ? blank : bytes;
    }
    if (text[bytes] == ' ') blank = bytes;
  }
  return bytes;
}

static void clear_row(Canvas *canvas, int row) {
  for (int column = 0; column < canvas->columns; column++)
    canvas_put(canvas, row, column, STYLE_PLAIN, ' ');
}

/* A long one begins a row above its own. */
static void draw_message(const ScreenState *state, Canvas *canvas, int row) {
  const Style style = state->is_trouble ? STYLE_BAD : STYLE_STRONG;
  const char *text = state->message;
  const size_t first = fitting(text, canvas->columns - 2);
  if (text[first] && row > 1) {
    char part[SCREEN_MESSAGE_SIZE];
    (void)snprintf(part, sizeof part, "%.*s", (int)first, text);
    clear_row(canvas, row - 1);
    canvas_text(canvas, row - 1, 1, style, part);
    text += first;
    text += strspn(text, " ");
  }
  canvas_text(canvas, row, 1, style, text);
}

/* The part of a long line that has the cursor in it. */
static void draw_line(const LineEditor *line, Canvas *canvas, int row) {
  int cursor = 1; /* its column if everything is shown */
  for (size_t i = 0; i < line->cursor; i++) cursor += ((unsigned char)line->text[i] & 0xC0) != 0x80;
  const int hidden = cursor >= canvas->columns ? cursor - canvas->columns + 1 : 0;
  canvas_text(canvas, row, -hidden, STYLE_STRONG, ":");
  canvas_text(canvas, row, 1 - hidden, STYLE_PLAIN, line->text);
  uint32_t point = ' ';
  if (line->cursor < line->length) (void)utf8_read(line->text + line->cursor, &point);
  canvas_put(canvas, row, cursor - hidden, STYLE_REVERSE, point);
}

static void draw_hints(const ScreenState *state, Canvas *canvas, int row) {
  canvas_text(canvas, row, 1, STYLE_FAINT,
              state->panel ? "up, down: choose   left, right: turn   Enter: type   Tab closes"
                           : "? help   Tab parameters   : command   Escape twice or Ctrl-C quits");
}

static void draw_bottom(const ScreenState *state, Canvas *canvas, int row) {
  if (state->line) {
    draw_line(state->line, canvas, row);
  } else {
    draw_hints(state, canvas, row);
  }
}

/* ---- help ---- */

/* What keys do, in the order in which it is explained. */
static const struct {
  ActionKind kind;
  const char *text;
} explained[] = {
  {ACTION_STROKE, "strokes, from the centre to the rim"},
  {ACTION_GHOST, "ghost notes: a third as fast"},
  {ACTION_REPEAT, "the last stroke again"},
  {ACTION_SPEED, "speed of the strokes"},
  {ACTION_TECHNIQUE, "rimshot, cross-stick, rim, buzz, sweep"},
  {ACTION_SNARES, "snares on and off"},
  {ACTION_MUFFLE, "muffle on and off"},
  {ACTION_PRESET, "another drum"},
  {ACTION_DRUM, "the drum of a kit that keys play"},
  {ACTION_GAIN, "gain"},
  {ACTION_RUN, "commands of your own"},
  {ACTION_COMMAND, "command, as :set wires.tension 20"},
  {ACTION_HELP, "this help"},
};

#define HELP_TEXT 22 /* columns of the keys, in front of what they do */

/* Line @p index of those whose action has a key; false past the last. */
static bool find_help(const Keymap *keymap, size_t index, char *keys, size_t size,
                      const char **text) {
  for (size_t i = 0; i < sizeof explained / sizeof explained[0]; i++) {
    if (keymap_list(keymap, explained[i].kind, keys, size) == 0 || index-- > 0) continue;
    *text = explained[i].text;
    return true;
  }
  (void)snprintf(keys, size, index == 0 ? "Tab" : "Escape twice, Ctrl-C");
  *text =
    index == 0 ? "all parameters, to walk through and turn" : "quit; a key held down plays a roll";
  return index <= 1;
}

bool screen_help(const Keymap *keymap, size_t index, char *text, size_t size) {
  char keys[64];
  const char *what = "";
  if (!find_help(keymap, index, keys, sizeof keys, &what)) return false;
  (void)snprintf(text, size, "%-*s  %s", HELP_TEXT - 1, keys, what);
  return true;
}

static void draw_help(const ScreenState *state, Canvas *canvas, int row, int last) {
  char keys[64];
  const char *text = "";
  for (size_t i = 0; row <= last && find_help(state->help, i, keys, sizeof keys, &text); i++) {
    const int column = canvas_text(canvas, row, 1, STYLE_STRONG, keys) + 2;
    canvas_text(canvas, row++, column > HELP_TEXT + 2 ? column : HELP_TEXT + 2, STYLE_PLAIN, text);
  }
}

/* ---- the whole ---- */

typedef void RowFn(const ScreenState *state, Canvas *canvas, int row);

/* Rows below the meters, with how much each matters: the least go first. */
static const struct {
  RowFn *draw; /* NULL: an empty row */
  int importance;
} rows[] = {
  {NULL, 1},          {draw_load, 7},   {draw_health, 6}, {NULL, 2},
  {draw_drum, 5},     {draw_tuning, 5}, {draw_last, 8},   {NULL, 2},
  {draw_settings, 9}, {draw_heard, 3},  {draw_device, 4},
};
#define ROWS ((int)(sizeof rows / sizeof rows[0]))

static int count_rows(int least) {
  int count = 0;
  for (int i = 0; i < ROWS; i++) count += rows[i].importance >= least;
  return count;
}

/* Those of the rows that there is room for. */
static int draw_rows(const ScreenState *state, Canvas *canvas, int row, int room) {
  int least = 0;
  while (count_rows(least) > (room > 0 ? room : 0)) least++;
  for (int i = 0; i < ROWS; i++) {
    if (rows[i].importance < least) continue;
    if (rows[i].draw) rows[i].draw(state, canvas, row);
    row++;
  }
  return row;
}

void screen_draw(const ScreenState *state, Canvas *canvas) {
  const int bottom = canvas->rows - 1, message = bottom - 1;
  int row = 0;
  if (message > row) draw_title(state, canvas, row++);
  if (message > row + 6) row++;
  for (uint32_t channel = 0; channel < state->play.channels && row < message; channel++) {
    draw_meter(state, canvas, row++, channel);
  }
  if (state->help) {
    draw_help(state, canvas, row + (message - row > 13), message - 1);
  } else if (state->panel) {
    parameter_panel_draw(state->panel, state->def, canvas, row + (message - row > 13), message - 1);
  } else {
    draw_rows(state, canvas, row, message - row);
  }
  if (message >= 0) draw_message(state, canvas, message);
  draw_bottom(state, canvas, bottom);
}
