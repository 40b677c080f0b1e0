/* SPDX-License-Identifier: MIT */
/* The window of Tabor Kit. */
#include <string.h>

#include "lv2/kit_instrument.h"
#include "lv2/ui.h"
#include "window/kit_plugin_window.h"

/* ---- what the window asks of the instance ---------------------------------------------------- */

static float value(void *ui, KitKnobId id) { return ((Ui *)ui)->values[id]; }

static void begin(void *ui, KitKnobId id) { ui_grab(ui, id, true); }
static void end(void *ui, KitKnobId id) { ui_grab(ui, id, false); }

static void turn(void *ui, KitKnobId id, double to) { ui_turn(ui, id, kit_knob_clamp(id, to)); }

static void use(void *ui, const float values[KIT_KNOB_COUNT]) {
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) turn(ui, (KitKnobId)i, (double)values[i]);
}

static void play(void *ui) { (void)ui; } /* the host runs the plugin anyway */

/* ---- the window ----------------------------------------------------------------------------- */

static bool is_of_this_build(const void *instance) {
  const KitInstrument *const kit = instance;
  return kit->size == sizeof *kit && strcmp(kit->version, tabor_version()) == 0;
}

static Port port(const Ui *ui, uint32_t number) {
  (void)ui;
  return kit_port_at(number);
}

static float fallback(const Ui *ui, uint32_t knob) {
  (void)ui;
  return kit_knobs[knob].fallback;
}

static void *create(Ui *ui) {
  KitInstrument *const kit = ui->instance;
  const KitPluginWindowShell shell = {.instance = ui,
                                      .link = &kit->window,
                                      .own = &kit->own,
                                      .value = value,
                                      .begin = begin,
                                      .turn = turn,
                                      .end = end,
                                      .use = use,
                                      .play = play};
  return kit_plugin_window_create(&shell);
}

const UiKind ui_kit = {.window = &kit_plugin_window_kind,
                       .is_of_this_build = is_of_this_build,
                       .port_at = port,
                       .fallback = fallback,
                       .create = create};
