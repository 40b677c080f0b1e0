/* SPDX-License-Identifier: MIT */
/**
 * @file drum_window.h
 * The window of a plugin with one drum: the drum from above, which is struck where it is clicked, head and wires as they
 * move, microphones that can be dragged, pages of controls, presets, two drums to compare, undo and meters.
 *
 * It knows nothing of plugin formats: a shell tells it what to show, and is told what was done. All functions are for the
 * main thread.
 */
#ifndef TABOR_WINDOW_DRUM_WINDOW_H
#define TABOR_WINDOW_DRUM_WINDOW_H

#include <tabor/tabor.h>

#include "window/painting.h"

#define DRUM_WINDOW_CONTROLS 8 /**< most controls of a page */

/** A microphone: distance from the axis, height above the batter head [m], and angle [deg]. */
typedef struct DrumMic {
  char name[TABOR_NAME_SIZE];
  double radius, angle, height;
} DrumMic;

/** What a shell has to show at one moment. */
typedef struct DrumWindowScene {
  char title[WINDOW_TEXT]; /**< name of the drum */
  bool is_second;          /**< of the two drums to compare the second plays */
  bool can_undo;
  char page[WINDOW_TEXT]; /**< name of the page of controls */
  float peaks[2];         /**< largest sample of each side since the last scene, 1: full scale */
  const TaborView *view;  /**< NULL: the head and the wires are not seen */
  double radius, depth;   /**< of the drum [m]; depth 0: it has one head */
  uint32_t mic_count;
  DrumMic mics[TABOR_MAX_MICS];
} DrumWindowScene;

typedef struct DrumControl {
  char name[WINDOW_TEXT], value[WINDOW_TEXT];
  double position;
  bool is_idle; /**< of a part that the drum lacks: it cannot be turned */
} DrumControl;

/** The shell. A position is a part of a control's way, 0 to 1. */
typedef struct DrumWindowShell {
  void *context;
  void (*scene)(void *context, DrumWindowScene *scene);
  /** Fills @p shown. False: the page has no such control. */
  bool (*control)(void *context, uint32_t control, DrumControl *shown);
  void (*turn_page)(void *context); /**< to the next page of controls, after the last the first */
  void (*begin)(void *context, uint32_t control); /**< a hand takes the control */
  void (*move)(void *context, uint32_t control, double position);
  void (*end)(void *context, uint32_t control);
  /** @p velocity [m/s], @p radius a part of the head's, @p angle [deg]. */
  void (*strike)(void *context, double velocity, double radius, double angle);
  void (*move_mic)(void *context, uint32_t mic, const DrumMic *to); /**< once it is let go of */
  void (*step_preset)(void *context, int steps); /**< to the next one, 1, or the one before, -1 */
  void (*compare)(void *context);                /**< the other of two drums plays */
  void (*undo)(void *context);
} DrumWindowShell;

typedef struct DrumWindow DrumWindow;

/** Creates a hidden window of @p width by @p height pixels inside @p parent, an id of X11. NULL if there is no server, or
 * memory is short. */
DrumWindow *drum_window_create(unsigned long parent, uint32_t width, uint32_t height,
                               const DrumWindowShell *shell);
/** Ignores NULL. */
void drum_window_destroy(DrumWindow *window);
void drum_window_show(DrumWindow *window, bool shown);
/** The picture fills the window, in its own proportions. */
void drum_window_resize(DrumWindow *window, uint32_t width, uint32_t height);
/** Its id on X11. */
unsigned long drum_window_id(const DrumWindow *window);
/** Takes what the mouse has done, and draws. To be called some 30 times a second. */
void drum_window_update(DrumWindow *window);

#endif
