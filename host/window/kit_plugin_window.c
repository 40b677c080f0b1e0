/* SPDX-License-Identifier: MIT */
#include "window/kit_plugin_window.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "window/history.h"
#include "window/kit_window.h"
#include "window/window_size.h"

static const double TUNE_STEP = 0.1; /* [semitones] */

/* All knobs. */
typedef struct Setting {
  float values[KIT_KNOB_COUNT];
} Setting;

struct KitPluginWindow {
  KitPluginWindowShell shell;
  uint32_t width, height;
  KitWindow *window; /* NULL while it is closed */
  TaborKitDef *kit;  /* that is shown */
  float shown;       /* value of its knob */
  unsigned version;  /* of the user's own kit then */
  History history;   /* of Setting */
};

static float value_of(const KitPluginWindow *window, KitKnobId id) {
  return window->shell.value(window->shell.instance, id);
}

/* ---- settings ------------------------------------------------------------------------------- */

static void note_setting(void *context, void *noted) {
  const KitPluginWindow *const window = context;
  Setting *const setting = noted;
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) setting->values[i] = value_of(window, (KitKnobId)i);
}

static void use_setting(void *context, const void *used) {
  const KitPluginWindow *const window = context;
  const Setting *const setting = used;
  window->shell.use(window->shell.instance, setting->values);
}

/* Where drums stand depends on the kit alone. */
static void follow_kit(KitPluginWindow *window) {
  const float kit = value_of(window, KIT_KNOB_KIT);
  const unsigned version = own_kit_version(window->shell.own);
  if (kit == window->shown && version == window->version) return;
  window->shown = kit;
  window->version = version;
  (void)kit_knob_kit(kit, window->shell.own, window->kit, NULL); /* built-in ones are there */
}

/* ---- what the window shows and does --------------------------------------------------------- */

static void show_drum(KitPluginWindow *window, uint32_t number, KitWindowDrum *shown) {
  const TaborKitDrumDef *const drum = &window->kit->drum[number];
  *shown = (KitWindowDrum){.x = drum->x,
                           .y = drum->y,
                           .height = drum->height,
                           .radius = drum->def.shell.radius,
                           .depth = drum->def.shell.depth,
                           .tilt = drum->tilt,
                           .facing = drum->facing};
  memcpy(shown->name, drum->name, sizeof shown->name);
  shown->struck = (double)atomic_exchange(&window->shell.link->struck[number], 0);
}

static void scene(void *context, KitWindowScene *shown) {
  KitPluginWindow *const window = context;
  follow_kit(window);
  memcpy(shown->title, window->kit->name, sizeof shown->title);
  shown->is_second = window->history.is_second;
  shown->can_undo = window->history.count > 0;
  for (uint32_t side = 0; side < 2; side++)
    shown->peaks[side] = atomic_exchange(&window->shell.link->peaks[side], 0);
  shown->drum_count = window->kit->drum_count;
  for (uint32_t i = 0; i < shown->drum_count; i++) show_drum(window, i, &shown->drums[i]);
}

static void control(void *context, KitKnobId knob, char *value, double *position) {
  const KitPluginWindow *const window = context;
  const float now = value_of(window, knob), least = kit_knobs[knob].minimum;
  (void)kit_knob_text(knob, (float)(0.1 * round(10 * (double)now)), value, WINDOW_TEXT);
  *position = (double)((now - least) / (kit_knobs[knob].maximum - least));
}

static void begin(void *context, KitKnobId knob) {
  KitPluginWindow *const window = context;
  history_keep(&window->history);
  window->shell.begin(window->shell.instance, knob);
}

static void move(void *context, KitKnobId knob, double position) {
  KitPluginWindow *const window = context;
  const double least = (double)kit_knobs[knob].minimum, most = (double)kit_knobs[knob].maximum;
  const double to = least + position * (most - least);
  window->shell.turn(window->shell.instance, knob,
                     knob < KIT_KNOB_TUNE ? to : TUNE_STEP * round(to / TUNE_STEP));
}

static void end(void *context, KitKnobId knob) {
  KitPluginWindow *const window = context;
  window->shell.end(window->shell.instance, knob);
}

static void strike(void *context, uint32_t drum, double velocity, double radius, double angle) {
  KitPluginWindow *const window = context;
  const KitPluginStroke stroke = {drum, velocity, radius, angle};
  (void)spsc_queue_push(&window->shell.link->strokes, &stroke);
  window->shell.play(window->shell.instance);
}

/* Levels and tunings stay with the numbers of drums, as in the host's own list. The user's own kit is the last, if there is
 * one. */
static void step_kit(void *context, int steps) {
  KitPluginWindow *const window = context;
  const bool has_own = own_kit_version(window->shell.own) > 0;
  const int kits = (int)kit_knobs[KIT_KNOB_KIT].maximum + (has_own ? 1 : 0);
  const int at = (int)value_of(window, KIT_KNOB_KIT);
  history_keep(&window->history);
  window->shell.begin(window->shell.instance, KIT_KNOB_KIT);
  window->shell.turn(window->shell.instance, KIT_KNOB_KIT, (at + steps + kits) % kits);
  window->shell.end(window->shell.instance, KIT_KNOB_KIT);
}

static void compare(void *context) { history_compare(&((KitPluginWindow *)context)->history); }

static void undo(void *context) { history_undo(&((KitPluginWindow *)context)->history); }

/* ---- sizes ---------------------------------------------------------------------------------- */

static void resize(void *opened, uint32_t width, uint32_t height) {
  KitPluginWindow *const window = opened;
  window->width = width;
  window->height = height;
  if (window->window) kit_window_resize(window->window, width, height);
}

static void size(const void *opened, uint32_t *width, uint32_t *height) {
  const KitPluginWindow *const window = opened;
  *width = window->width;
  *height = window->height;
}

/* ---- beginning and end ---------------------------------------------------------------------- */

KitPluginWindow *kit_plugin_window_create(const KitPluginWindowShell *shell) {
  KitPluginWindow *const window = calloc(1, sizeof *window);
  if (!window) return NULL;
  window->shell = *shell;
  window->history =
    (History){.size = sizeof(Setting), .context = window, .note = note_setting, .use = use_setting};
  window->kit = calloc(1, sizeof *window->kit);
  if (!window->kit || !history_begin(&window->history)) {
    free(window->kit);
    free(window);
    return NULL;
  }
  window->shown = NAN;
  window_size(1, &window->width, &window->height);
  return window;
}

static bool open(void *opened, unsigned long parent) {
  KitPluginWindow *const window = opened;
  const KitWindowShell shell = {.context = window,
                                .scene = scene,
                                .control = control,
                                .begin = begin,
                                .move = move,
                                .end = end,
                                .strike = strike,
                                .step_kit = step_kit,
                                .compare = compare,
                                .undo = undo};
  if (window->window) return false;
  window->window = kit_window_create(parent, window->width, window->height, &shell);
  return window->window != NULL;
}

static bool is_open(const void *window) {
  return ((const KitPluginWindow *)window)->window != NULL;
}

static void close(void *opened) {
  KitPluginWindow *const window = opened;
  atomic_store(&window->shell.link->is_shown, false);
  kit_window_destroy(window->window);
  window->window = NULL;
}

static void destroy(void *created) {
  KitPluginWindow *const window = created;
  if (!window) return;
  close(window);
  history_end(&window->history);
  free(window->kit);
  free(window);
}

static void show(void *opened, bool shown) {
  const KitPluginWindow *const window = opened;
  atomic_store(&window->shell.link->is_shown, shown);
  kit_window_show(window->window, shown);
}

static unsigned long id(const void *window) {
  return kit_window_id(((const KitPluginWindow *)window)->window);
}

static void update(void *opened) {
  KitPluginWindow *const window = opened;
  if (window->window) kit_window_update(window->window);
}

const WindowKind kit_plugin_window_kind = {.destroy = destroy,
                                           .resize = resize,
                                           .size = size,
                                           .open = open,
                                           .is_open = is_open,
                                           .close = close,
                                           .id = id,
                                           .show = show,
                                           .update = update};
