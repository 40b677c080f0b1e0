/* SPDX-License-Identifier: MIT */
/* The binary has its own copy of what it shares with the plugins, so a window opens for an instance of its own build alone. */
#include "lv2/ui.h"

#include <lv2/atom/atom.h>
#include <lv2/instance-access/instance-access.h>
#include <lv2/options/options.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lv2/uris.h"

/* What the host offers. */
typedef struct Features {
  void *parent;
  void *instance;
  LV2UI_Touch *touch;
  LV2UI_Resize *resize;
  LV2_URID_Map *map;
  const LV2_Options_Option *options;
} Features;

/* ---- the host's ports ----------------------------------------------------------------------- */

void ui_grab(const Ui *ui, uint32_t knob, bool grabbed) {
  if (ui->touch) ui->touch->touch(ui->touch->handle, ui->ports[knob], grabbed);
}

void ui_turn(Ui *ui, uint32_t knob, float value) {
  ui->values[knob] = value;
  ui->write(ui->controller, ui->ports[knob], sizeof value, 0, &ui->values[knob]);
}

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
  Port port;
  for (uint32_t i = 0; (port = ui->kind->port_at(ui, i)).kind != PORT_NONE; i++) {
    if (port.kind != PORT_KNOB) continue;
    ui->ports[port.index] = i;
    ui->values[port.index] = ui->kind->fallback(ui, port.index);
  }
}

static bool open(Ui *ui, const Features *features, LV2UI_Widget *widget) {
  const WindowKind *const kind = ui->kind->window;
  uint32_t width, height;
  ui->window = ui->kind->create(ui);
  if (!ui->window) return false;
  window_scale(kind, ui->window, scale_of(features));
  if (!kind->open(ui->window, (unsigned long)(uintptr_t)features->parent)) return false;
  kind->size(ui->window, &width, &height);
  if (features->resize)
    features->resize->ui_resize(features->resize->handle, (int)width, (int)height);
  kind->show(ui->window, true);
  *widget = (LV2UI_Widget)(uintptr_t)kind->id(ui->window);
  return true;
}

static void cleanup(LV2UI_Handle handle) {
  Ui *const ui = handle;
  ui->kind->window->destroy(ui->window);
  free(ui);
}

static LV2UI_Handle instantiate(const LV2UI_Descriptor *descriptor, const char *plugin,
                                const char *bundle, LV2UI_Write_Function write,
                                LV2UI_Controller controller, LV2UI_Widget *widget,
                                const LV2_Feature *const *list) {
  (void)bundle;
  const Features features = find_features(list);
  const bool is_kit = strcmp(plugin, URI_KIT) == 0;
  const UiKind *const kind = is_kit ? &ui_kit : &ui_drum;
  if (strcmp(descriptor->URI, is_kit ? URI_KIT_WINDOW : URI_WINDOW) != 0) return NULL;
  if (!features.parent || !features.instance || !kind->is_of_this_build(features.instance)) {
    return NULL;
  }
  Ui *const ui = calloc(1, sizeof *ui);
  if (!ui) return NULL;
  *ui = (Ui){.kind = kind,
             .instance = features.instance,
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
  const Port port = ui->kind->port_at(ui, number);
  float to;
  if (format != 0 || size != sizeof to || port.kind != PORT_KNOB) return;
  memcpy(&to, buffer, sizeof to);
  if (isfinite(to)) ui->values[port.index] = to;
}

static int idle(LV2UI_Handle handle) {
  Ui *const ui = handle;
  ui->kind->window->update(ui->window);
  return 0;
}

static int resize(LV2UI_Feature_Handle handle, int width, int height) {
  if (width <= 0 || height <= 0 || width > INT16_MAX || height > INT16_MAX) return 1;
  Ui *const ui = handle;
  ui->kind->window->resize(ui->window, (uint32_t)width, (uint32_t)height);
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
