/* SPDX-License-Identifier: MIT */
/**
 * @file screen.h
 * What a player sees: from plain numbers to a picture of characters. Knows nothing of terminals.
 *
 * From the top: the drum and the device, a meter for each channel, computing, the drum's state, what was last
 * played, the settings, a line for messages and one for commands. A terminal that is too low loses the rows
 * that matter least, first; one that is too narrow the ends of its rows.
 */
#ifndef TABOR_HOST_SCREEN_H
#define TABOR_HOST_SCREEN_H

#include "sound/play_status.h"
#include "ui/canvas.h"
#include "ui/keymap.h"
#include "ui/line_editor.h"
#include "ui/meter.h"

#define SCREEN_MESSAGE_SIZE 512 /**< bytes, with the terminator */

typedef struct ScreenState {
  PlayStatus play;
  const char *quality;                        /**< "live" */
  char mics[TABOR_MAX_MICS][TABOR_NAME_SIZE]; /**< of each channel, its microphone */
  Meter meters[TABOR_MAX_MICS];               /**< of each channel */
  LoadMeter load;
  double head_radius; /**< [m] */
  double speed;       /**< of the next stroke [m/s] */
  double humanize;    /**< 0 to 1 */
  bool has_snares, snares_on, is_muffled;
  char message[SCREEN_MESSAGE_SIZE]; /**< "" for none */
  bool is_trouble;                   /**< the message is of something wrong */
  const LineEditor *line;            /**< the command line, or NULL while it is closed */
  const Keymap *help;                /**< the keys to explain, or NULL while nobody asks */
} ScreenState;

void screen_draw(const ScreenState *state, Canvas *canvas);

#define SCREEN_HELP_SIZE 120
/** Writes line @p index of what there is to know about the keys; false past the last. */
bool screen_help(const Keymap *keymap, size_t index, char *text, size_t size);

/** "stroke at 45 % of the radius, 30 degrees, 2.5 m/s"; "" for no event. Returns @p text. */
const char *screen_event(const TaborEvent *event, double head_radius, char *text, size_t size);

#endif
