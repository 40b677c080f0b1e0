/* SPDX-License-Identifier: MIT */
/**
 * @file ui.h
 * The window of an instance as an LV2 UI for X11. It needs instance access: strokes and looks pass between the window and
 * the instance; knobs are ports of the host. ui.c has what all windows share, drum_ui.c and kit_ui.c what the window of a
 * kind of plugin asks of its instance. All is for the main thread.
 */
#ifndef TABOR_LV2_UI_H
#define TABOR_LV2_UI_H

#include <lv2/ui/ui.h>

#include "lv2/kit_ports.h"
#include "window/window_kind.h"

#define UI_KNOBS ((uint32_t)KNOB_COUNT > KIT_KNOB_COUNT ? (uint32_t)KNOB_COUNT : KIT_KNOB_COUNT)

typedef struct Ui Ui;

typedef struct UiKind {
  const WindowKind *window;
  bool (*is_of_this_build)(
    const void *instance); /**< so that what the window looks into is what it takes it for */
  Port (*port_at)(const Ui *ui, uint32_t number);
  float (*fallback)(const Ui *ui, uint32_t knob);
  void *(*create)(Ui *ui); /**< NULL if memory is short */
} UiKind;

struct Ui {
  const UiKind *kind;
  void *instance;
  LV2UI_Write_Function write;
  LV2UI_Controller controller;
  const LV2UI_Touch *touch; /**< or NULL */
  uint32_t ports[UI_KNOBS]; /**< numbers */
  float values[UI_KNOBS];   /**< of the ports */
  void *window;
};

extern const UiKind ui_drum, ui_kit;

/** Tells the host that a hand takes the knob or lets it go. */
void ui_grab(const Ui *ui, uint32_t knob, bool grabbed);
/** Turns the knob's port. */
void ui_turn(Ui *ui, uint32_t knob, float value);

#endif
