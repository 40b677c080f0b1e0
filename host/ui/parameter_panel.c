/* SPDX-License-Identifier: MIT */
#include "ui/parameter_panel.h"

#include <stdio.h>
#include <string.h>

#include "plugin/key_name.h"
#include "plugin/key_text.h"
#include "plugin/key_way.h"
#include "plugin/knob.h"

enum { KEY_SIZE = 2 * TABOR_NAME_SIZE, VALUE_SIZE = 2 * TABOR_TEXT_SIZE };
enum { VALUE_COLUMN = 34, TEXT_COLUMN = 52 };

static const char FIRST[] = "batter.tension"; /* that is chosen at first */

/* ---- keys of the definition ----------------------------------------------------------------- */

static bool key_at(const TaborDrumDef *def, int64_t number, char key[KEY_SIZE]) {
  return number >= 0 && tabor_drum_def_key(def, (uint32_t)number, key, KEY_SIZE);
}

/* Another drum may have fewer. */
static uint32_t chosen(const ParameterPanel *panel, const TaborDrumDef *def) {
  char key[KEY_SIZE];
  uint32_t at = panel->at;
  while (at > 0 && !key_at(def, at, key)) at--;
  return at;
}

/* ---- keys of the keyboard ------------------------------------------------------------------- */

static void move(ParameterPanel *panel, const TaborDrumDef *def, int step) {
  char key[KEY_SIZE];
  const int64_t to = (int64_t)chosen(panel, def) + step;
  if (key_at(def, to, key)) panel->at = (uint32_t)to;
}

/* To the first parameter of another section. */
static void move_section(ParameterPanel *panel, const TaborDrumDef *def, int step) {
  char here[KEY_SIZE], there[KEY_SIZE];
  int64_t to = chosen(panel, def);
  if (!key_at(def, to, here)) return;
  do to += step;
  while (key_at(def, to, there) && key_is_same_section(here, there));
  if (!key_at(def, to, there)) return;
  memcpy(here, there, sizeof here);
  while (step < 0 && key_at(def, to - 1, there) && key_is_same_section(here, there)) to--;
  panel->at = (uint32_t)to;
}

/* False: it has no way. */
static bool write_turned(const TaborDrumDef *def, const char *key, int step, char *command) {
  char value[VALUE_SIZE], turned[VALUE_SIZE];
  const TaborParameter *const parameter = tabor_parameter_find(key);
  if (!parameter || tabor_drum_def_get(def, key, value, sizeof value, NULL) != TABOR_OK)
    return false;
  const double from = key_position(parameter, value);
  if (from < 0) return false;
  const double to = knob_stepped(from, step * KNOB_STEP, key_choices(parameter));
  key_at_position(parameter, to, turned, sizeof turned);
  (void)snprintf(command, PANEL_COMMAND_SIZE, "set %s %s", key, turned);
  return true;
}

/* As it is shown, which ':set' reads. */
static void write_shown(const TaborDrumDef *def, const char *key, char *text, size_t size) {
  char value[VALUE_SIZE] = "";
  const TaborParameter *const parameter = tabor_parameter_find(key);
  (void)tabor_drum_def_get(def, key, value, sizeof value, NULL);
  if (parameter) {
    (void)key_text(parameter, value, text, size);
  } else {
    (void)snprintf(text, size, "%s", value);
  }
}

static void open_at_tuning(ParameterPanel *panel, const TaborDrumDef *def) {
  char key[KEY_SIZE];
  panel->is_open = true;
  if (panel->at > 0) return; /* where it was left */
  for (int64_t i = 0; key_at(def, i, key); i++)
    if (strcmp(key, FIRST) == 0) panel->at = (uint32_t)i;
}

static PanelWish take_open(ParameterPanel *panel, const TaborDrumDef *def, Key pressed,
                           char *command) {
  char key[KEY_SIZE];
  panel->at = chosen(panel, def);
  if (!key_at(def, panel->at, key)) return PANEL_NOTHING;
  switch (pressed) {
  case KEY_UP: move(panel, def, -1); return PANEL_DONE;
  case KEY_DOWN: move(panel, def, 1); return PANEL_DONE;
  case KEY_PAGE_UP: move_section(panel, def, -1); return PANEL_DONE;
  case KEY_PAGE_DOWN: move_section(panel, def, 1); return PANEL_DONE;
  case KEY_LEFT: return write_turned(def, key, -1, command) ? PANEL_RUN : PANEL_DONE;
  case KEY_RIGHT: return write_turned(def, key, 1, command) ? PANEL_RUN : PANEL_DONE;
  case KEY_ENTER: (void)snprintf(command, PANEL_COMMAND_SIZE, "set %s ", key); return PANEL_TYPE;
  default: return PANEL_NOTHING;
  }
}

PanelWish parameter_panel_take(ParameterPanel *panel, const TaborDrumDef *def, Key key,
                               char *command) {
  if (key != KEY_TAB) return panel->is_open ? take_open(panel, def, key, command) : PANEL_NOTHING;
  if (panel->is_open) {
    panel->is_open = false;
  } else {
    open_at_tuning(panel, def);
  }
  return PANEL_DONE;
}

/* ---- drawing -------------------------------------------------------------------------------- */

static void draw_line(const TaborDrumDef *def, Canvas *canvas, int row, const char *key,
                      bool is_chosen) {
  char text[VALUE_SIZE];
  const TaborParameter *const parameter = tabor_parameter_find(key);
  const Style style = is_chosen ? STYLE_REVERSE : STYLE_PLAIN;
  write_shown(def, key, text, sizeof text);
  for (int column = 0; is_chosen && column < canvas->columns; column++)
    canvas_put(canvas, row, column, style, ' ');
  canvas_text(canvas, row, 1, style, key);
  const int column = canvas_text(canvas, row, VALUE_COLUMN, style, text) + 2;
  if (parameter)
    canvas_text(canvas, row, column > TEXT_COLUMN ? column : TEXT_COLUMN,
                is_chosen ? style : STYLE_FAINT, parameter->text);
}

/* The chosen one stands in the middle, as far as there are lines on both sides. */
void parameter_panel_draw(const ParameterPanel *panel, const TaborDrumDef *def, Canvas *canvas,
                          int row, int last) {
  char key[KEY_SIZE];
  const int64_t at = chosen(panel, def), room = last - row + 1;
  int64_t first = at - room / 2;
  while (first > 0 && !key_at(def, first + room - 1, key)) first--;
  if (first < 0) first = 0;
  for (int64_t i = first; row <= last && key_at(def, i, key); i++)
    draw_line(def, canvas, row++, key, i == at);
}
