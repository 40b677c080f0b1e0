/* SPDX-License-Identifier: MIT */
/* The window of Tabor, Tabor Multi and Tabor Rattle. */
#include <math.h>
#include <string.h>

#include "lv2/instrument.h"
#include "lv2/ui.h"
#include "window/plugin_window.h"

static Instrument *instrument_of(const Ui *ui) { return ui->instance; }

/* ---- what the window asks of the instance ---------------------------------------------------- */

static ModelWorker *worker(void *ui) { return &instrument_of(ui)->worker; }

static float value(void *ui, KnobId id) {
  return port_to_knob(&instrument_of(ui)->ranges[id], ((Ui *)ui)->values[id]);
}

static void begin(void *ui, KnobId id) { ui_grab(ui, id, true); }
static void end(void *ui, KnobId id) { ui_grab(ui, id, false); }

static void turn(void *ui, KnobId id, double to) {
  const float exact = (float)knob_decimal((float)to);
  ui_turn(ui, id, port_of_knob(&instrument_of(ui)->ranges[id], exact));
}

static void save(void *ui, SavedState *saved) { model_worker_save(worker(ui), saved); }

/* The ports first: they turn no knob if they stand where they stood with the drum. */
static void use(void *ui, const PluginDrum *drum) {
  KnobId id;
  for (uint32_t i = 0; (id = knob_at(instrument_of(ui)->set, i)) < KNOB_COUNT; i++) {
    turn(ui, id, (double)drum->values[id]);
  }
  model_worker_restore(worker(ui), &drum->saved);
}

/* Knobs of parts that the drum lacks stay where they are. */
static void choose(void *shell, const char *preset) {
  PluginDrum drum;
  for (uint32_t i = 0; i < KNOB_COUNT; i++) drum.values[i] = value(shell, (KnobId)i);
  if (tabor_drum_def_preset(&drum.saved.def, preset, NULL) != TABOR_OK) return;
  for (uint32_t i = 0; i < KNOB_SEEN; i++) {
    const double shown = knob_shown(&drum.saved.def, (KnobId)i);
    if (!isnan(shown)) drum.values[i] = (float)knob_decimal((float)shown);
  }
  memcpy(drum.saved.seen, drum.values, sizeof drum.saved.seen);
  use(shell, &drum);
}

static void play(void *ui) { (void)ui; } /* the host runs the plugin anyway */

/* ---- the window ----------------------------------------------------------------------------- */

static bool is_of_this_build(const void *instance) {
  const Instrument *const instrument = instance;
  return instrument->size == sizeof *instrument &&
         strcmp(instrument->version, tabor_version()) == 0;
}

static Port port(const Ui *ui, uint32_t number) { return port_at(instrument_of(ui)->set, number); }

static float fallback(const Ui *ui, uint32_t knob) {
  return instrument_of(ui)->ranges[knob].fallback;
}

static void *create(Ui *ui) {
  Instrument *const instrument = ui->instance;
  const PluginWindowShell shell = {.instance = ui,
                                   .link = &instrument->window,
                                   .set = instrument->set,
                                   .ranges = instrument->ranges,
                                   .worker = worker,
                                   .value = value,
                                   .begin = begin,
                                   .turn = turn,
                                   .end = end,
                                   .save = save,
                                   .use = use,
                                   .choose = choose,
                                   .play = play};
  return plugin_window_create(&shell);
}

const UiKind ui_drum = {.window = &plugin_window_kind,
                        .is_of_this_build = is_of_this_build,
                        .port_at = port,
                        .fallback = fallback,
                        .create = create};
