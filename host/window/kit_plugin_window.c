/* SPDX-License-Identifier: MIT */
#include "window/kit_plugin_window.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/kit_instrument.h"
#include "plugin/kit_knobs.h"
#include "plugin/knob_text.h"
#include "window/history.h"
#include "window/kit_window.h"
#include "window/preset_steps.h"
#include "window/window_size.h"

struct KitPluginWindow {
  PluginWindowShell shell;
  uint32_t width, height;
  KitWindow *window; /* NULL while it is closed */
  TaborKitDef *kit;  /* that is shown */
  float shown;       /* value of its knob */
  unsigned version;  /* of the user's own kit then */
  PresetSteps steps;
  History history; /* of InstrumentSetting */
};

static float value_of(const KitPluginWindow *window, KitKnobId id) {
  return window->shell.value(window->shell.shell, id);
}

/* ---- settings ------------------------------------------------------------------------------- */

static void note_setting(void *context, void *noted) {
  const KitPluginWindow *const window = context;
  InstrumentSetting *const setting = noted;
  instrument_note(window->shell.instrument, setting);
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) setting->values[i] = value_of(window, (KitKnobId)i);
}

static void use_setting(void *context, const void *used) {
  const KitPluginWindow *const window = context;
  window->shell.use(window->shell.shell, used);
}

static OwnKit *own_of(const KitPluginWindow *window) {
  return kit_instrument_own(window->shell.instrument);
}

/* Where drums stand depends on the kit alone. */
static void follow_kit(KitPluginWindow *window) {
  const float kit = value_of(window, KIT_KNOB_KIT);
  const unsigned version = own_kit_version(own_of(window));
  if (kit == window->shown && version == window->version) return;
  window->shown = kit;
  window->version = version;
  (void)kit_knob_kit(kit, own_of(window), window->kit, NULL); /* built-in ones are there */
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
  shown->struck = (double)atomic_exchange(&window->shell.instrument->window.struck[number], 0);
}

static void scene(void *context, KitWindowScene *shown) {
  KitPluginWindow *const window = context;
  follow_kit(window);
  memcpy(shown->title, window->kit->name, sizeof shown->title);
  shown->is_second = window->history.is_second;
  shown->can_undo = window->history.count > 0;
  for (uint32_t side = 0; side < 2; side++)
    shown->peaks[side] = atomic_exchange(&window->shell.instrument->window.peaks[side], 0);
  shown->drum_count = window->kit->drum_count;
  for (uint32_t i = 0; i < shown->drum_count; i++) show_drum(window, i, &shown->drums[i]);
}

static void control(void *context, KitKnobId id, char *value, double *position) {
  const KitPluginWindow *const window = context;
  const KnobRange *const range = &window->shell.instrument->ranges[id];
  const double now = (double)value_of(window, id);
  (void)knob_label(&kit_knobs[id], range, 0.1 * round(10 * now), value, WINDOW_TEXT);
  *position = knob_position(range, now);
}

static void begin(void *context, KitKnobId knob) {
  KitPluginWindow *const window = context;
  history_keep(&window->history);
  window->shell.begin(window->shell.shell, knob);
}

static void move(void *context, KitKnobId id, double position) {
  KitPluginWindow *const window = context;
  const double to = knob_at_position(&window->shell.instrument->ranges[id], position);
  const double step = kit_knobs[id].step;
  window->shell.turn(window->shell.shell, id, step > 0 ? step * round(to / step) : to);
}

static void end(void *context, KitKnobId knob) {
  KitPluginWindow *const window = context;
  window->shell.end(window->shell.shell, knob);
}

static void strike(void *context, uint32_t drum, double velocity, double radius, double angle) {
  KitPluginWindow *const window = context;
  const WindowStroke stroke = {drum, velocity, radius, angle};
  (void)spsc_queue_push(&window->shell.instrument->window.strokes, &stroke);
  window->shell.play(window->shell.shell);
}

/* Levels and tunings stay with the numbers of drums, as in the host's own list. */
static void step_kit(void *context, int steps) {
  KitPluginWindow *const window = context;
  const PluginWindowShell *const shell = &window->shell;
  follow_kit(window);
  const PresetPlace place =
    preset_steps_take(&window->steps, shell->instrument->kind, window->kit->name, steps);
  history_keep(&window->history);
  if (place.is_file) {
    shell->choose(shell->shell, place.name, true);
  } else {
    shell->begin(shell->shell, KIT_KNOB_KIT);
    shell->turn(shell->shell, KIT_KNOB_KIT, (double)place.number);
    shell->end(shell->shell, KIT_KNOB_KIT);
  }
  follow_kit(window);
  preset_steps_note(&window->steps, window->kit->name);
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

KitPluginWindow *kit_plugin_window_create(const PluginWindowShell *shell) {
  KitPluginWindow *const window = calloc(1, sizeof *window);
  if (!window) return NULL;
  window->shell = *shell;
  window->history = (History){
    .size = sizeof(InstrumentSetting), .context = window, .note = note_setting, .use = use_setting};
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
  atomic_store(&window->shell.instrument->window.is_shown, false);
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
  atomic_store(&window->shell.instrument->window.is_shown, shown);
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
