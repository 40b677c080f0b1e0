/* SPDX-License-Identifier: MIT */
/**
 * @file kit_window.h
 * The window of a plugin with a kit: the kit from above, whose drums are struck where they are clicked and light up when
 * they are played, level and tuning of each, the levels of all, kits, two settings to compare, undo and meters.
 *
 * It knows nothing of plugin formats: a shell tells it what to show, and is told what was done. All functions are for the
 * main thread.
 */
#ifndef TABOR_WINDOW_KIT_WINDOW_H
#define TABOR_WINDOW_KIT_WINDOW_H

#include "plugin/kit_knobs.h"
#include "window/painting.h"

/** A drum as it stands: the place of its batter head, seen from above, y away from the player [m]; angles [deg]. */
typedef struct KitWindowDrum {
  char name[TABOR_NAME_SIZE];
  double x, y, height, radius, depth, tilt, facing;
  double struck; /**< speed of the fastest stroke since the last scene [m/s], 0: none */
} KitWindowDrum;

/** What a shell has to show at one moment. */
typedef struct KitWindowScene {
  char title[TABOR_NAME_SIZE]; /**< name of the kit */
  bool is_second;              /**< of the two settings to compare the second plays */
  bool can_undo;
  float peaks[2]; /**< largest sample of each side since the last scene, 1: full scale */
  uint32_t drum_count;
  KitWindowDrum drums[TABOR_KIT_DRUMS];
} KitWindowScene;

/** The shell. A position is a part of a control's way, 0 to 1. */
typedef struct KitWindowShell {
  void *context;
  void (*scene)(void *context, KitWindowScene *scene);
  /** Value of a control as a text, and its position. */
  void (*control)(void *context, KitKnobId knob, char *value, double *position);
  void (*begin)(void *context, KitKnobId knob); /**< a hand takes the control */
  void (*move)(void *context, KitKnobId knob, double position);
  void (*end)(void *context, KitKnobId knob);
  /** @p velocity [m/s], @p radius a part of the head's or negative: the drum's own stroke, @p angle [deg]. */
  void (*strike)(void *context, uint32_t drum, double velocity, double radius, double angle);
  void (*step_kit)(void *context, int steps); /**< to the next one, 1, or the one before, -1 */
  void (*compare)(void *context);             /**< the other of two settings plays */
  void (*undo)(void *context);
} KitWindowShell;

typedef struct KitWindow KitWindow;

/** Creates a hidden window of @p width by @p height pixels inside @p parent, an id of X11. NULL if there is no server, or
 * memory is short. */
KitWindow *kit_window_create(unsigned long parent, uint32_t width, uint32_t height,
                             const KitWindowShell *shell);
/** Ignores NULL. */
void kit_window_destroy(KitWindow *window);
void kit_window_show(KitWindow *window, bool shown);
/** The picture fills the window, in its own proportions. */
void kit_window_resize(KitWindow *window, uint32_t width, uint32_t height);
/** Its id on X11. */
unsigned long kit_window_id(const KitWindow *window);
/** Takes what the mouse has done, and draws. To be called some 30 times a second. */
void kit_window_update(KitWindow *window);

#endif
