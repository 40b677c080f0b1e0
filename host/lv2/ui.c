/* SPDX-License-Identifier: MIT */
/* The binary has its own copy of what it shares with the plugins, so a window opens for an instance
 * of its own build alone. */
#include <lv2/atom/atom.h>
#include <lv2/instance-access/instance-access.h>
#include <lv2/options/options.h>
#include <lv2/ui/ui.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lv2/instance.h"
#include "window/plugin_window.h"

/* What the host offers. */
typedef struct Features {
  void *parent;
  void *instance;
  LV2UI_Touch *touch;
  LV2UI_Resize *resize;
  LV2_URID_Map *map;
  const LV2_Options_Option *options;
} Features;

typedef struct Ui {
  Instance *instance;
  PluginWindow *window;
  LV2UI_Write_Function write;
  LV2UI_Controller controller;
  const LV2UI_Touch *touch;         /* or NULL */
  uint32_t ports[INSTRUMENT_KNOBS]; /* numbers */
  float values[INSTRUMENT_KNOBS];   /* of the ports */
} Ui;

static Instrument *instrument_of(const Ui *ui) { return ui->instance->instrument; }

/* ---- what the window asks of the instance ---------------------------------------------------- */

static float value(void *shell, uint32_t id) {
  const Ui *const ui = shell;
  return port_to_knob(&instrument_of(ui)->ranges[id], ui->values[id]);
}

static void grab(const Ui *ui, uint32_t knob, bool grabbed) {
  if (ui->touch) ui->touch->touch(ui->touch->handle, ui->ports[knob], grabbed);
}

static void begin(void *shell, uint32_t id) { grab(shell, id, true); }
static void end(void *shell, uint32_t id) { grab(shell, id, false); }

static void turn(void *shell, uint32_t id, double to) {
  Ui *const ui = shell;
  const Instrument *const instrument = instrument_of(ui);
  const KnobRange *const range = &instrument->ranges[id];
  ui->values[id] = port_of_knob(range, knob_limited(&instrument->kind->knobs[id], range, to));
  ui->write(ui->controller, ui->ports[id], sizeof(float), 0, &ui->values[id]);
}

/* The ports first: they turn no knob if they stand where they stood with the drum. */
static void use(void *shell, const InstrumentSetting *setting) {
  const Ui *const ui = shell;
  Instrument *const instrument = instrument_of(ui);
  const InstrumentKind *const kind = instrument->kind;
  uint32_t id;
  for (uint32_t i = 0; (id = instrument_knob_at(kind, i)) < kind->knob_count; i++)
    turn(shell, id, (double)setting->values[id]);
  kind->calls->use(instrument, setting);
}

/* Knobs of parts that the drum lacks stay where they are. */
static void choose(void *shell, const char *name, bool is_file) {
  const Ui *const ui = shell;
  Instrument *const instrument = instrument_of(ui);
  char message[INSTRUMENT_MESSAGE];
  InstrumentSetting setting;
  instrument_note(instrument, &setting);
  for (uint32_t i = 0; i < instrument->kind->knob_count; i++) setting.values[i] = value(shell, i);
  if (instrument->kind->calls->load(instrument, name, is_file, &setting, message))
    use(shell, &setting);
}

static void play(void *shell) { (void)shell; } /* the host runs the plugin anyway */

/* ---- beginning and end ---------------------------------------------------------------------- */

static Features find_features(const LV2_Feature *const *list) {
  Features found = {0};
  const struct {
    const char *uri;
    void **place;
  } wanted[] = {
    {LV2_UI__parent, &found.parent},        {LV2_INSTANCE_ACCESS_URI, &found.instance},
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
  const Instrument *const instrument = instrument_of(ui);
  Port port;
  for (uint32_t i = 0; (port = port_at(instrument->kind, i)).kind != PORT_NONE; i++) {
    if (port.kind != PORT_KNOB) continue;
    ui->ports[port.index] = i;
    ui->values[port.index] = instrument->ranges[port.index].fallback;
  }
}

static bool make_window(Ui *ui) {
  const PluginWindowShell shell = {.shell = ui,
                                   .instrument = instrument_of(ui),
                                   .value = value,
                                   .begin = begin,
                                   .turn = turn,
                                   .end = end,
                                   .use = use,
                                   .choose = choose,
                                   .play = play};
  ui->window = plugin_window_create(&shell);
  return ui->window != NULL;
}

static bool open(Ui *ui, const Features *features, LV2UI_Widget *widget) {
  uint32_t width, height;
  if (!make_window(ui)) return false;
  plugin_window_scale(ui->window, scale_of(features));
  if (!plugin_window_open(ui->window, (uintptr_t)features->parent)) return false;
  plugin_window_size(ui->window, &width, &height);
  if (features->resize)
    features->resize->ui_resize(features->resize->handle, (int)width, (int)height);
  plugin_window_show(ui->window, true);
  *widget = (LV2UI_Widget)plugin_window_id(ui->window);
  return true;
}

static void cleanup(LV2UI_Handle handle) {
  Ui *const ui = handle;
  plugin_window_destroy(ui->window);
  free(ui);
}

/* So that what the window looks into is what it takes it for. */
static bool is_of_this_build(const Instance *instance) {
  return instance && instance->size == sizeof *instance &&
         strcmp(instance->version, tabor_version()) == 0;
}

static LV2UI_Handle instantiate(const LV2UI_Descriptor *descriptor, const char *plugin,
                                const char *bundle, LV2UI_Write_Function write,
                                LV2UI_Controller controller, LV2UI_Widget *widget,
                                const LV2_Feature *const *list) {
  (void)bundle;
  const Features features = find_features(list);
  const Instance *const instance = features.instance;
  if (!features.parent || !is_of_this_build(instance)) return NULL;
  const Lv2Plugin *const shown = instance->plugin;
  if (strcmp(plugin, shown->uri) != 0 || strcmp(descriptor->URI, shown->window) != 0) return NULL;
  Ui *const ui = calloc(1, sizeof *ui);
  if (!ui) return NULL;
  *ui = (Ui){.instance = features.instance,
             .write = write,
             .controller = controller,
             .touch = features.touch};
  find_ports(ui);
  if (open(ui, &features, widget)) return ui;
  cleanup(ui);
  return NULL;
}

/* ---- while it is open ----------------------------------------------------------------------- */

static void port_event(LV2UI_Handle handle, uint32_t number, uint32_t size, uint32_t format,
                       const void *buffer) {
  Ui *const ui = handle;
  const Port port = port_at(instrument_of(ui)->kind, number);
  float to;
  if (format != 0 || size != sizeof to || port.kind != PORT_KNOB) return;
  memcpy(&to, buffer, sizeof to);
  if (isfinite(to)) ui->values[port.index] = to;
}

static int idle(LV2UI_Handle handle) {
  Ui *const ui = handle;
  plugin_window_update(ui->window);
  return 0;
}

static int resize(LV2UI_Feature_Handle handle, int width, int height) {
  if (width <= 0 || height <= 0 || width > INT16_MAX || height > INT16_MAX) return 1;
  Ui *const ui = handle;
  plugin_window_resize(ui->window, (uint32_t)width, (uint32_t)height);
  return 0;
}

static const void *extension_data(const char *uri) {
  static const LV2UI_Idle_Interface idles = {.idle = idle};
  static const LV2UI_Resize resizes = {.ui_resize = resize};
  if (strcmp(uri, LV2_UI__idleInterface) == 0) return &idles;
  return strcmp(uri, LV2_UI__resize) == 0 ? &resizes : NULL;
}

#define WINDOW(uri)                                                                                \
  {                                                                                                \
    .URI = (uri), .instantiate = instantiate, .cleanup = cleanup, .port_event = port_event,        \
    .extension_data = extension_data                                                               \
  }

LV2_SYMBOL_EXPORT const LV2UI_Descriptor *lv2ui_descriptor(uint32_t index) {
  static const LV2UI_Descriptor windows[] = {WINDOW(URI_WINDOW), WINDOW(URI_KIT_WINDOW)};
  return index < sizeof windows / sizeof *windows ? &windows[index] : NULL;
}
