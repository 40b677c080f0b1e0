/* SPDX-License-Identifier: MIT */
/* The window of an instance (window/plugin_window.h) as an LV2 UI for X11. It needs instance access: strokes and the look of
 * the drum pass between the window and the instance; knobs are ports of the host. The binary has its own copy of what it
 * shares with the plugin, so it opens for an instance of its own build alone. */
#include <lv2/instance-access/instance-access.h>
#include <lv2/options/options.h>
#include <lv2/ui/ui.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lv2/instrument.h"
#include "lv2/uris.h"
#include "window/plugin_window.h"

typedef struct Ui {
  Instrument *instrument;
  LV2UI_Write_Function write;
  LV2UI_Controller controller;
  const LV2UI_Touch *touch; /* or NULL */
  uint32_t ports[KNOB_COUNT];
  float values[KNOB_COUNT]; /* of the ports */
  PluginWindow *window;
} Ui;

/* What the host offers. */
typedef struct Features {
  void *parent;
  Instrument *instrument;
  LV2UI_Touch *touch;
  LV2UI_Resize *resize;
  LV2_URID_Map *map;
  const LV2_Options_Option *options;
} Features;

/* ---- what the window asks of the instance ---------------------------------------------------- */

static ModelWorker *worker(void *instance) { return &((Ui *)instance)->instrument->worker; }

static float value(void *instance, KnobId id) { return ((Ui *)instance)->values[id]; }

static void grab(const Ui *ui, KnobId id, bool grabbed) {
  if (ui->touch) ui->touch->touch(ui->touch->handle, ui->ports[id], grabbed);
}

static void begin(void *instance, KnobId id) { grab(instance, id, true); }
static void end(void *instance, KnobId id) { grab(instance, id, false); }

static void turn(void *instance, KnobId id, double to) {
  Ui *const ui = instance;
  const KnobRange *const range = &ui->instrument->ranges[id];
  ui->values[id] = fminf(fmaxf((float)knob_decimal((float)to), range->minimum), range->maximum);
  ui->write(ui->controller, ui->ports[id], sizeof ui->values[id], 0, &ui->values[id]);
}

static void save(void *instance, SavedState *saved) { model_worker_save(worker(instance), saved); }

/* The ports first: they turn no knob if they stand where they stood with the drum. */
static void use(void *instance, const PluginDrum *drum) {
  Ui *const ui = instance;
  KnobId id;
  for (uint32_t i = 0; (id = knob_at(ui->instrument->set, i)) < KNOB_COUNT; i++) {
    turn(ui, id, (double)drum->values[id]);
  }
  model_worker_restore(worker(ui), &drum->saved);
}

/* Knobs of parts that the drum lacks stay where they are. */
static void choose(void *instance, const char *preset) {
  Ui *const ui = instance;
  PluginDrum drum;
  memcpy(drum.values, ui->values, sizeof drum.values);
  if (tabor_drum_def_preset(&drum.saved.def, preset, NULL) != TABOR_OK) return;
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    const double shown = knob_shown(&drum.saved.def, (KnobId)i);
    if (!isnan(shown)) drum.values[i] = (float)knob_decimal((float)shown);
  }
  memcpy(drum.saved.seen, drum.values, sizeof drum.saved.seen);
  use(ui, &drum);
}

static void play(void *instance) { (void)instance; } /* the host runs the plugin anyway */

/* ---- beginning and end ---------------------------------------------------------------------- */

static Features find_features(const LV2_Feature *const *list) {
  Features found = {0};
  const struct {
    const char *uri;
    void **place;
  } wanted[] = {
    {LV2_UI__parent, &found.parent},        {LV2_INSTANCE_ACCESS_URI, (void **)&found.instrument},
    {LV2_UI__touch, (void **)&found.touch}, {LV2_UI__resize, (void **)&found.resize},
    {LV2_URID__map, (void **)&found.map},   {LV2_OPTIONS__options, (void **)&found.options},
  };
  for (; list && *list; list++) {
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
      if (strcmp((*list)->URI, wanted[i].uri) == 0) *wanted[i].place = (*list)->data;
    }
  }
  return found;
}

static double scale_of(const Features *features) {
  const LV2_Options_Option *option = features->options;
  if (!option || !features->map) return 1;
  const LV2_URID key = features->map->map(features->map->handle, LV2_UI__scaleFactor);
  const LV2_URID type = features->map->map(features->map->handle, LV2_ATOM__Float);
  for (; option->key || option->value; option++) {
    if (option->key != key || option->type != type || option->size != sizeof(float)) continue;
    const float scale = *(const float *)option->value;
    return scale > 0 ? (double)scale : 1;
  }
  return 1;
}

static void find_ports(Ui *ui) {
  Port port;
  for (uint32_t i = 0; (port = port_at(ui->instrument->set, i)).kind != PORT_NONE; i++) {
    if (port.kind == PORT_KNOB) ui->ports[port.index] = i;
  }
  for (uint32_t i = 0; i < KNOB_COUNT; i++) ui->values[i] = ui->instrument->ranges[i].fallback;
}

static bool open(Ui *ui, const Features *features, LV2UI_Widget *widget) {
  const PluginWindowShell shell = {.instance = ui,
                                   .link = &ui->instrument->window,
                                   .set = ui->instrument->set,
                                   .ranges = ui->instrument->ranges,
                                   .worker = worker,
                                   .value = value,
                                   .begin = begin,
                                   .turn = turn,
                                   .end = end,
                                   .save = save,
                                   .use = use,
                                   .choose = choose,
                                   .play = play};
  uint32_t width, height;
  ui->window = plugin_window_create(&shell);
  if (!ui->window) return false;
  plugin_window_scale(ui->window, scale_of(features));
  if (!plugin_window_open(ui->window, (unsigned long)(uintptr_t)features->parent)) return false;
  plugin_window_size(ui->window, &width, &height);
  if (features->resize)
    features->resize->ui_resize(features->resize->handle, (int)width, (int)height);
  plugin_window_show(ui->window, true);
  *widget = (LV2UI_Widget)(uintptr_t)plugin_window_id(ui->window);
  return true;
}

static void cleanup(LV2UI_Handle handle) {
  Ui *const ui = handle;
  plugin_window_destroy(ui->window);
  free(ui);
}

static bool is_of_this_build(const Instrument *instrument) {
  return instrument->size == sizeof *instrument &&
         strcmp(instrument->version, tabor_version()) == 0;
}

static LV2UI_Handle instantiate(const LV2UI_Descriptor *descriptor, const char *plugin,
                                const char *bundle, LV2UI_Write_Function write,
                                LV2UI_Controller controller, LV2UI_Widget *widget,
                                const LV2_Feature *const *list) {
  (void)descriptor;
  (void)bundle;
  const Features features = find_features(list);
  if (strcmp(plugin, URI_KIT) == 0) return NULL;
  if (!features.parent || !features.instrument || !is_of_this_build(features.instrument)) {
    return NULL;
  }
  Ui *const ui = calloc(1, sizeof *ui);
  if (!ui) return NULL;
  ui->instrument = features.instrument;
  ui->write = write;
  ui->controller = controller;
  ui->touch = features.touch;
  find_ports(ui);
  if (open(ui, &features, widget)) return ui;
  cleanup(ui);
  return NULL;
}

/* ---- while it is open ----------------------------------------------------------------------- */

static void port_event(LV2UI_Handle handle, uint32_t number, uint32_t size, uint32_t format,
                       const void *buffer) {
  Ui *const ui = handle;
  const Port port = port_at(ui->instrument->set, number);
  float to;
  if (format != 0 || size != sizeof to || port.kind != PORT_KNOB) return;
  memcpy(&to, buffer, sizeof to);
  if (isfinite(to)) ui->values[port.index] = to;
}

static int idle(LV2UI_Handle handle) {
  plugin_window_update(((Ui *)handle)->window);
  return 0;
}

static int resize(LV2UI_Feature_Handle handle, int width, int height) {
  if (width <= 0 || height <= 0 || width > INT16_MAX || height > INT16_MAX) return 1;
  plugin_window_resize(((Ui *)handle)->window, (uint32_t)width, (uint32_t)height);
  return 0;
}

static const void *extension_data(const char *uri) {
  static const LV2UI_Idle_Interface idles = {.idle = idle};
  static const LV2UI_Resize resizes = {.ui_resize = resize};
  if (strcmp(uri, LV2_UI__idleInterface) == 0) return &idles;
  return strcmp(uri, LV2_UI__resize) == 0 ? &resizes : NULL;
}

LV2_SYMBOL_EXPORT const LV2UI_Descriptor *lv2ui_descriptor(uint32_t index) {
  static const LV2UI_Descriptor window = {.URI = URI_WINDOW,
                                          .instantiate = instantiate,
                                          .cleanup = cleanup,
                                          .port_event = port_event,
                                          .extension_data = extension_data};
  return index == 0 ? &window : NULL;
}
