/* SPDX-License-Identifier: MIT */
#include "lv2_window.h"

#include <lv2/instance-access/instance-access.h>
#include <lv2/options/options.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "window_checks.h"

Desktop server;

PluginHost *open_plugin(const char *uri) {
  const LV2_Descriptor *descriptor = NULL;
  for (uint32_t i = 0; !descriptor || strcmp(descriptor->URI, uri) != 0; i++) {
    descriptor = lv2_descriptor(i);
    assert_non_null(descriptor);
  }
  return host_open(descriptor, HOST_WITHOUT_WORKER);
}

/* A control port changes before the next run, as hosts do it. */
void write_port(LV2UI_Controller controller, uint32_t port, uint32_t size, uint32_t format,
                const void *buffer) {
  Opened *const opened = controller;
  const Port to = host_port(opened->host, port);
  assert_int_equal(format, 0);
  assert_int_equal(size, sizeof(float));
  assert_int_equal(to.kind, PORT_KNOB);
  memcpy(host_knob(opened->host, to.index), buffer, size);
  opened->writes++;
}

static void touch(LV2UI_Feature_Handle handle, uint32_t port, bool grabbed) {
  Opened *const opened = handle;
  (void)port;
  *(grabbed ? &opened->grabs : &opened->releases) += 1;
}

static int ask_size(LV2UI_Feature_Handle handle, int width, int height) {
  Opened *const opened = handle;
  opened->width = width;
  opened->height = height;
  return 0;
}

void tell_ports(const Opened *opened) {
  Port port;
  for (uint32_t i = 0; (port = host_port(opened->host, i)).kind != PORT_NONE; i++) {
    if (port.kind != PORT_KNOB) continue;
    opened->descriptor->port_event(opened->ui, i, sizeof(float), 0,
                                   host_knob(opened->host, port.index));
  }
}

void open_window(Opened *opened, float scale) {
  LV2_URID_Map map = {NULL, host_map_feature};
  const LV2_Options_Option options[] = {{LV2_OPTIONS_INSTANCE, 0, host_map(LV2_UI__scaleFactor),
                                         sizeof scale, host_map(LV2_ATOM__Float), &scale},
                                        {0}};
  LV2UI_Widget widget = NULL;
  opened->outer = desktop_window(&server, (uint16_t)(scale * WIDTH), (uint16_t)(scale * HEIGHT));
  const LV2_Feature features[] = {{LV2_UI__parent, (void *)(uintptr_t)opened->outer},
                                  {LV2_INSTANCE_ACCESS_URI, opened->host->handle},
                                  {LV2_UI__touch, &opened->touch},
                                  {LV2_UI__resize, &opened->resize},
                                  {LV2_URID__map, &map},
                                  {LV2_OPTIONS__options, (void *)(uintptr_t)options}};
  const LV2_Feature *list[sizeof features / sizeof *features + 1] = {NULL};
  for (size_t i = 0; i < sizeof features / sizeof *features; i++) list[i] = &features[i];
  opened->descriptor = lv2ui_descriptor(opened->host->is_kit ? 1 : 0);
  opened->touch = (LV2UI_Touch){opened, touch};
  opened->resize = (LV2UI_Resize){opened, ask_size};
  opened->ui = opened->descriptor->instantiate(opened->descriptor, opened->host->descriptor->URI,
                                               "", write_port, opened, &widget, list);
  assert_non_null(opened->ui);
  opened->inner = (DesktopWindow)(uintptr_t)widget;
  assert_int_equal(opened->inner, desktop_inner(&server, opened->outer));
  tell_ports(opened);
}

void close_window(const Opened *opened) {
  opened->descriptor->cleanup(opened->ui);
  desktop_close(&server, opened->outer);
}

void close_host(const Opened *opened) {
  close_window(opened);
  host_close(opened->host);
}

/* Connections to the server are files. Whoever destroys the outer window first does no harm. */
void check_openings(PluginHost *host) {
  const int openings = getenv("OPENINGS") ? atoi(getenv("OPENINGS")) : 50;
  Opened opened = {.host = host};
  const long before = open_files();
  for (int i = 0; i < openings; i++) {
    open_window(&opened, 1);
    tick(&opened);
    if (i % 2 == 0) host_run(opened.host, 64);
    tick(&opened);
    if (i % 5 == 0) desktop_close(&server, opened.outer);
    close_window(&opened);
  }
  print_message("%d windows: %ld files open before, %ld after\n", openings, before, open_files());
  assert_int_equal(open_files(), before);
  host_close(opened.host);
}

void tick(const Opened *opened) {
  const LV2UI_Idle_Interface *const idles =
    opened->descriptor->extension_data(LV2_UI__idleInterface);
  assert_int_equal(idles->idle(opened->ui), 0);
}

void click(const Opened *opened, int x, int y) {
  desktop_click(&server, opened->inner, x, y);
  tick(opened);
}

void wheel(const Opened *opened, int x, int y, int steps) {
  desktop_wheel(&server, opened->inner, x, y, steps);
  tick(opened);
}

void drag(const Opened *opened, int x, int y, int to_x, int to_y) {
  desktop_drag(&server, opened->inner, x, y, to_x, to_y);
  tick(opened);
}
