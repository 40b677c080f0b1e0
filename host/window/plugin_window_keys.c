/* SPDX-License-Identifier: MIT */
#include "window/plugin_window_state.h"

enum { PAGE_LINES = 8 }; /* of a list */

/* ---- typing --------------------------------------------------------------------------------- */

static void end_typing(PluginWindow *window, bool is_taken) {
  const WindowTyping typing = window->typing;
  const uint32_t at = window->scene.typed_at;
  window->typing = TYPING_NOTHING;
  plugin_window_say(window, false, "%s", "");
  if (!is_taken) return;
  if (typing == TYPING_VALUE) plugin_window_take_typed(window, at, window->editor.text);
  if (typing == TYPING_NAME) plugin_window_save(window, window->editor.text);
  if (typing == TYPING_FILE) plugin_window_open_file(window, window->editor.text);
}

static void type(PluginWindow *window, Key key) {
  const bool is_letter = key >= ' ' && key < KEY_UNKNOWN;
  if (window->is_offered && is_letter) line_editor_begin(&window->editor);
  window->is_offered = false;
  const LineOutcome outcome = line_editor_take(&window->editor, key);
  if (outcome != LINE_EDITING) end_typing(window, outcome == LINE_DONE);
}

/* ---- lists ---------------------------------------------------------------------------------- */

/* True: the key was the list's. */
static bool move_in_list(PluginWindow *window, Key key) {
  ListView *const list = &window->list;
  const char *const marked = window->scene.marked;
  switch (key) {
  case KEY_TAB:
  case KEY_DOWN: list_view_move(list, list->cursor == LIST_NO_CURSOR ? 0 : 1, marked); return true;
  case KEY_UP: list_view_move(list, list->cursor == LIST_NO_CURSOR ? 0 : -1, marked); return true;
  case KEY_PAGE_DOWN: list_view_move(list, PAGE_LINES, marked); return true;
  case KEY_PAGE_UP: list_view_move(list, -PAGE_LINES, marked); return true;
  case KEY_HOME: list_view_move(list, -LIST_MOST, marked); return true;
  case KEY_END: list_view_move(list, LIST_MOST, marked); return true;
  default: return false;
  }
}

static bool act_in_list(PluginWindow *window, Key key) {
  const ListLine *const line = list_view_chosen(&window->list);
  if (key == KEY_ESCAPE) {
    plugin_window_list(window, LIST_NONE);
  } else if (key == KEY_ENTER && line) {
    plugin_window_choose(window, line);
  } else if ((key == 'f' || key == 'F') && line) {
    plugin_window_star(window, line);
  } else {
    return move_in_list(window, key);
  }
  return true;
}

/* ---- controls ------------------------------------------------------------------------------- */

static void move_focus(PluginWindow *window, int steps) {
  WindowScene *const scene = &window->scene;
  const uint32_t count = scene->control_count;
  if (count == 0) return;
  if (scene->focus >= count) {
    scene->focus = steps > 0 ? 0 : count - 1;
  } else {
    scene->focus = (uint32_t)((int)(scene->focus + count) + steps) % count;
  }
  if (scene->controls[scene->focus].comment)
    plugin_window_say(window, false, "%s", scene->controls[scene->focus].comment);
}

static bool act_on_control(PluginWindow *window, Key key, bool has_shift) {
  const uint32_t focus = window->scene.focus;
  switch (key) {
  case KEY_TAB:
  case KEY_DOWN: move_focus(window, 1); return true;
  case KEY_UP: move_focus(window, -1); return true;
  case KEY_LEFT: plugin_window_turn_control(window, focus, -1, has_shift); return true;
  case KEY_RIGHT: plugin_window_turn_control(window, focus, 1, has_shift); return true;
  case KEY_ENTER: plugin_window_type_control(window, focus); return true;
  case KEY_BACKSPACE:
  case KEY_DELETE: plugin_window_reset_control(window, focus); return true;
  case 'm':
  case 'M': plugin_window_switch(window, focus, false); return true;
  case 's':
  case 'S': plugin_window_switch(window, focus, true); return true;
  case KEY_ESCAPE: window->scene.focus = WINDOW_NO_CONTROL; return true;
  default: return false;
  }
}

/* ---- all ------------------------------------------------------------------------------------ */

static void turn_page(PluginWindow *window, int steps) {
  control_pages_turn(&window->pages, steps);
  window->scene.focus = WINDOW_NO_CONTROL;
}

/* One drum is struck in its middle, of a kit the drum of the number at its own place. */
static void strike(PluginWindow *window, uint32_t number) {
  const WindowScene *const scene = &window->scene;
  if (number >= (scene->is_kit ? scene->drum_count : 1)) return;
  plugin_window_strike(window, &(WindowPlace){.part = WINDOW_DRUM, .number = number, .radius = -1});
}

static void act(PluginWindow *window, Key key, bool has_shift) {
  switch (key) {
  case ' ': strike(window, 0); break;
  case '+':
  case '=': plugin_window_change_speed(window, 1); break;
  case '-': plugin_window_change_speed(window, -1); break;
  case ',': plugin_window_step(window, -1); break;
  case '.': plugin_window_step(window, 1); break;
  case KEY_PAGE_UP: turn_page(window, -1); break;
  case KEY_PAGE_DOWN: turn_page(window, 1); break;
  case KEY_CTRL('y'): history_redo(&window->history); break;
  case KEY_CTRL('z'):
    if (has_shift) {
      history_redo(&window->history);
    } else {
      history_undo(&window->history);
    }
    break;
  case 'c':
  case 'C': history_compare(&window->history); break;
  case 'l':
  case 'L': plugin_window_list(window, LIST_SOUNDS); break;
  case 'p':
  case 'P': plugin_window_list(window, LIST_PAGES); break;
  case 'o':
  case 'O': plugin_window_ask_file(window); break;
  case 'w':
  case 'W': plugin_window_ask_name(window); break;
  case '?': plugin_window_list(window, LIST_KEYS); break;
  default:
    if (key >= '1' && key <= '9') strike(window, key - '1');
  }
}

void plugin_window_key(void *context, Key key, bool has_shift) {
  PluginWindow *const window = context;
  if (window->typing != TYPING_NOTHING) {
    type(window, key);
    return;
  }
  plugin_window_say(window, false, "%s", "");
  const bool is_taken =
    window->scene.list ? act_in_list(window, key) : act_on_control(window, key, has_shift);
  if (!is_taken) act(window, key, has_shift);
}
