/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kit/user_sounds.h"
#include "window/plugin_window_state.h"
#include "window/sound_list.h"

/* ---- choosing ------------------------------------------------------------------------------- */

/* A built-in kit is a value of its knob, so that the host can record it. Levels and tunings stay
 * with the numbers of drums, as in the host's own list. */
static void choose_place(PluginWindow *window, const PresetPlace *place, const char *name) {
  const PluginWindowShell *const shell = &window->shell;
  const uint32_t knob = shell->instrument->kind->main_knob;
  *window->turned = '\0';
  history_keep(&window->history, name);
  if (window->scene.is_kit && !place->is_file) {
    shell->begin(shell->shell, knob);
    shell->turn(shell->shell, knob, (double)place->number);
    shell->end(shell->shell, knob);
  } else {
    shell->choose(shell->shell, place->name, place->is_file);
  }
  plugin_window_note_looks(window);
  preset_steps_note(&window->steps, window->scene.title);
}

void plugin_window_step(PluginWindow *window, int steps) {
  plugin_window_note_looks(window);
  const PresetPlace place =
    preset_steps_take(&window->steps, window->shell.instrument->kind, window->scene.title, steps);
  choose_place(window, &place, "another sound");
}

/* The list stays open, so that one sound after the other can be tried. */
static void choose_sound(PluginWindow *window, const ListLine *line) {
  PresetPlace place;
  if (line->is_action) {
    if (line->number == SOUND_LIST_SAVE) {
      plugin_window_ask_name(window);
    } else {
      plugin_window_ask_file(window);
    }
    return;
  }
  if (!sound_list_place(line, &place)) return;
  preset_steps_choose(&window->steps, line->is_file ? line->name : "");
  choose_place(window, &place, line->name);
}

/* ---- lists ---------------------------------------------------------------------------------- */

static void list_keys(ListView *list) {
  static const char *const keys[][2] = {
    {"space, 1 to 9", "strikes the drum, or a drum of the kit"},
    {"+ -", "faster and slower strokes"},
    {"Tab, up, down", "the next control, and the one before"},
    {"left, right", "turn it; with Shift by small steps"},
    {"Enter", "types its value; Escape leaves it"},
    {"Delete", "its default, as a double click does"},
    {"M, S", "mute and solo of a level"},
    {"Page up, page down", "other pages of controls; P lists them"},
    {", .", "the sound before and after; L lists all"},
    {"F", "in that list: a favourite, or none any more"},
    {"W, O", "saves the sound under a name of your own; opens a file by its path"},
    {"Ctrl-Z, Ctrl-Y", "takes a change back, and makes it again"},
    {"C", "compares A and B"},
    {"Escape", "closes this list"}};
  list_view_clear(list);
  list_view_add_category(list, "keys, once the window has been clicked");
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
    (void)list_view_add(list, keys[i][0], keys[i][1]);
}

static void fill_list(PluginWindow *window) {
  const InstrumentKind *const kind = window->shell.instrument->kind;
  switch (window->listed) {
  case LIST_SOUNDS:
    favourites_read(&window->favourites);
    sound_list_fill(&window->list, kind, &window->favourites);
    list_view_show(&window->list, window->scene.title);
    break;
  case LIST_PAGES:
    control_pages_list(&window->pages, &window->list);
    list_view_show(&window->list, control_pages_name(&window->pages));
    break;
  case LIST_KEYS: list_keys(&window->list); break;
  case LIST_NONE: break;
  }
}

void plugin_window_list(PluginWindow *window, WindowList list) {
  window->listed = window->listed == list ? LIST_NONE : list;
  window->scene.list = window->listed == LIST_NONE ? NULL : &window->list;
  window->scene.focus = WINDOW_NO_CONTROL;
  plugin_window_note_looks(window);
  fill_list(window);
}

void plugin_window_choose(PluginWindow *window, const ListLine *line) {
  if (window->listed == LIST_SOUNDS) choose_sound(window, line);
  if (window->listed != LIST_PAGES) return;
  window->pages.at = line->number;
  plugin_window_list(window, LIST_NONE);
}

/* What was in view stays there, though favourites stand before it. */
void plugin_window_star(PluginWindow *window, const ListLine *line) {
  const ListView before = {.first = window->list.first, .cursor = window->list.cursor};
  const uint32_t count = window->list.count;
  if (window->listed != LIST_SOUNDS || line->is_action) return;
  if (!favourites_change(&window->favourites, line->name))
    plugin_window_say(window, true, "the file of favourites cannot be written");
  sound_list_fill(&window->list, window->shell.instrument->kind, &window->favourites);
  const uint32_t more = window->list.count - count; /* fewer: modulo 2^32 */
  window->list.first = before.first + more;
  if (before.cursor != LIST_NO_CURSOR) window->list.cursor = before.cursor + more;
  list_view_scroll(&window->list, 0);
}

/* ---- files ---------------------------------------------------------------------------------- */

void plugin_window_ask_file(PluginWindow *window) {
  line_editor_begin(&window->editor);
  window->typing = TYPING_FILE;
  window->scene.typed_at = WINDOW_NO_CONTROL;
  plugin_window_say(window, false, "open the file:");
}

/* A path in quotation marks, as file managers copy it, or after file://. */
static void clean_path(const char *typed, char *path, size_t size) {
  static const char SCHEME[] = "file://";
  if (strncmp(typed, SCHEME, sizeof SCHEME - 1) == 0) typed += sizeof SCHEME - 1;
  const size_t length = strlen(typed);
  const bool is_quoted =
    length > 1 && typed[0] == typed[length - 1] && (typed[0] == '"' || typed[0] == '\'');
  (void)snprintf(path, size, "%.*s", (int)(is_quoted ? length - 2 : length), typed + is_quoted);
}

/* Read here first, since not every shell says what is wrong. */
void plugin_window_open_file(PluginWindow *window, const char *typed) {
  PresetPlace place = {.is_file = true};
  char message[WINDOW_MESSAGE];
  UserSound sound;
  clean_path(typed, place.name, sizeof place.name);
  if (!user_sound_read(place.name, &sound, message, sizeof message)) {
    plugin_window_say(window, true, "%s", message);
  } else if (sound.is_kit != window->scene.is_kit) {
    plugin_window_say(window, true, "'%.80s' is a %s", place.name, sound.is_kit ? "kit" : "drum");
  } else {
    choose_place(window, &place, sound.name);
  }
}

/* ---- saving --------------------------------------------------------------------------------- */

void plugin_window_ask_name(PluginWindow *window) {
  plugin_window_note_looks(window);
  line_editor_begin(&window->editor);
  line_editor_replace(&window->editor, 0, window->scene.title);
  window->typing = TYPING_NAME;
  window->is_offered = true;
  window->scene.typed_at = WINDOW_NO_CONTROL;
  *window->overwritten = '\0';
  plugin_window_say(window, false, "save as:");
}

static bool is_built_in(const InstrumentKind *kind, const char *name) {
  for (uint32_t i = 0; i < kind->preset_count(); i++)
    if (strcmp(kind->preset(i)->name, name) == 0) return true;
  return false;
}

/* A name that a file can have on every system. */
static bool is_fit(const char *name) {
  static const char letters[] =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_. ";
  const size_t length = strlen(name);
  return length > 0 && length < TABOR_NAME_SIZE && !strchr(". ", name[0]) &&
         strspn(name, letters) == length;
}

static bool may_save(PluginWindow *window, const char *name) {
  char path[USER_PRESET_PATH];
  const bool is_there = user_preset_find(name, path) != NULL;
  if (!is_fit(name)) {
    plugin_window_say(window, true, "'%.40s': a name has letters, digits, '-', '_', '.' and spaces",
                      name);
  } else if (is_built_in(window->shell.instrument->kind, name)) {
    plugin_window_say(window, true, "'%s' is a built-in sound: take a name of your own", name);
  } else if (is_there && strcmp(name, window->overwritten) != 0) {
    (void)snprintf(window->overwritten, sizeof window->overwritten, "%s", name);
    plugin_window_say(window, true,
                      "'%s' is there already; the same name again replaces it:", name);
  } else {
    return true;
  }
  window->typing = TYPING_NAME; /* asks again */
  return false;
}

static bool write_sound(PluginWindow *window, const char *name) {
  char file[TABOR_NAME_SIZE + 4], message[WINDOW_MESSAGE];
  TaborError error = {.message = "out of memory"};
  definition_rename(window->definition, name);
  char *const text = definition_text(window->definition, &error);
  (void)snprintf(file, sizeof file, "%s.ini", name);
  (void)snprintf(message, sizeof message, "%s", error.message);
  const bool is_written = text && user_folder_write(file, text, message, sizeof message);
  free(text);
  if (!is_written) plugin_window_say(window, true, "%s", message);
  return is_written;
}

/* What plays is from now on the saved sound. */
void plugin_window_save(PluginWindow *window, const char *name) {
  if (!may_save(window, name)) return;
  plugin_window_note_looks(window);
  if (!write_sound(window, name)) return;
  plugin_window_redefine(window, "its name");
  preset_steps_choose(&window->steps, name);
  preset_steps_note(&window->steps, window->scene.title);
  plugin_window_say(window, false, "saved as '%s', in the list under 'your own'", name);
  fill_list(window);
}
