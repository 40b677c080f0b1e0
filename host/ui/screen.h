/* SPDX-License-Identifier: MIT */
/**
 * @file screen.h
 * Draws the screen of `tabor play` on a canvas, from plain numbers. It does not access the
 * terminal.
 *
 * From the top: the drum and the device, a meter per channel, the load, the drum's state, the last
 * event, the settings, a line for messages and one for commands. If the terminal is too low, the
 * least important rows are left out first; if it is too narrow, rows are cut at the end.
 */
#ifndef TABOR_HOST_SCREEN_H
#define TABOR_HOST_SCREEN_H

#include "base/line_editor.h"
#include "sound/play_status.h"
#include "ui/canvas.h"
#include "ui/keymap.h"
#include "ui/meter.h"
#include "ui/parameter_panel.h"

#define SCREEN_MESSAGE_SIZE 512 /**< bytes, with the terminator */

/** What a drum is tuned to. */
typedef struct ScreenTuning {
  double heads[2];   /**< tensions [N/m]; 0 of a plate, and of a head that is not there */
  double wires;      /**< tension [N] */
  double pitches[2]; /**< of the heads at a lug [Hz]; 0: unknown */
} ScreenTuning;

typedef struct ScreenState {
  PlayStatus play;
  const char *quality;                        /**< "live" */
  char mics[TABOR_MAX_MICS][TABOR_NAME_SIZE]; /**< microphone of each channel */
  Meter meters[TABOR_MAX_MICS];               /**< of each channel */
  LoadMeter load;
  char drum[2 * TABOR_NAME_SIZE + 4]; /**< of a kit, which the keys play, and its preset; "" */
  double head_radius;                 /**< of that drum, or the only one [m] */
  double speed;                       /**< of the next stroke [m/s] */
  double humanize;                    /**< 0 to 1 */
  bool has_snares, snares_on, is_muffled;
  ScreenTuning tuning;
  char heard[TABOR_TEXT_SIZE];       /**< microphones and room, "left, right in a studio" */
  const ParameterPanel *panel;       /**< open in place of all else */
  const TaborDrumDef *def;           /**< of the drum that it shows */
  char message[SCREEN_MESSAGE_SIZE]; /**< "" for none */
  bool is_trouble;                   /**< the message is an error or warning */
  const LineEditor *line;            /**< the command line, or NULL while it is closed */
  const Keymap *help;                /**< keys for the help, or NULL while it is closed */
} ScreenState;

void screen_draw(const ScreenState *state, Canvas *canvas);

#define SCREEN_HELP_SIZE 120
/** Writes line @p index of the help on the keys; false past the last. */
bool screen_help(const Keymap *keymap, size_t index, char *text, size_t size);

/** "stroke at 45 % of the radius, 30 degrees, 2.5 m/s"; "" for no event. Returns @p text. */
const char *screen_event(const TaborEvent *event, double head_radius, char *text, size_t size);

#endif
