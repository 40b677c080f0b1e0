/* SPDX-License-Identifier: MIT */
/**
 * @file parameter_panel.h
 * A list of all parameters of the drum that is played, to walk through: keys choose one and turn
 * it, while the other keys go on playing. It neither draws on the terminal nor changes the drum.
 */
#ifndef TABOR_HOST_PARAMETER_PANEL_H
#define TABOR_HOST_PARAMETER_PANEL_H

#include <tabor/tabor.h>

#include "base/keys.h"
#include "ui/canvas.h"

#define PANEL_COMMAND_SIZE (2 * TABOR_NAME_SIZE + 2 * TABOR_TEXT_SIZE + 8) /**< bytes */

/** Begins with zeros. */
typedef struct ParameterPanel {
  bool is_open;
  uint32_t at; /**< number of the chosen key, as tabor_drum_def_key() counts */
} ParameterPanel;

/** What a key wants. */
typedef enum PanelWish {
  PANEL_NOTHING, /**< the key is not one of the panel's */
  PANEL_DONE,    /**< it chose another parameter, or opened or closed the panel */
  PANEL_RUN,     /**< a command is to be executed */
  PANEL_TYPE     /**< a command is to be typed on */
} PanelWish;

/**
 * Tab opens and closes the panel, at first at the tension of the batter head. While it is open, up
 * and down choose a parameter, Page up and Page down the next section, left and right turn it by
 * 2 % of its way, and Enter begins to type its value. @p command, of PANEL_COMMAND_SIZE bytes, is
 * "set KEY VALUE".
 */
PanelWish parameter_panel_take(ParameterPanel *panel, const TaborDrumDef *def, Key key,
                               char *command);
/** Draws it from row @p row to row @p last. */
void parameter_panel_draw(const ParameterPanel *panel, const TaborDrumDef *def, Canvas *canvas,
                          int row, int last);

#endif
