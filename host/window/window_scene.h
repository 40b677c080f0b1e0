/* SPDX-License-Identifier: MIT */
/**
 * @file window_scene.h
 * What a window shows at one moment: a page of controls, and one drum from above, or the drums of a
 * kit where they stand.
 */
#ifndef TABOR_WINDOW_WINDOW_SCENE_H
#define TABOR_WINDOW_WINDOW_SCENE_H

#include "base/line_editor.h"
#include "plugin/definition.h"
#include "plugin/knob.h"
#include "window/list_view.h"
#include "window/painting.h"

#include <tabor/kit.h>

#define WINDOW_NO_MIC UINT32_MAX
#define WINDOW_NO_CONTROL UINT32_MAX
#define WINDOW_MESSAGE 512 /**< bytes of a message */

/** A row: a knob of the instrument, or a parameter of its definition. */
typedef struct WindowControl {
  bool is_key;                     /**< a parameter */
  uint32_t knob;                   /**< unless it is one */
  char key[DEFINITION_KEY];        /**< of a parameter */
  const TaborParameter *parameter; /**< its row, or NULL */
  char name[WINDOW_TEXT], value[WINDOW_TEXT];
  const char *comment;             /**< what it does */
  double position;                 /**< part of its way, 0 to 1; negative: it has none, as a text */
  bool is_idle;                    /**< of a part that is not there: it cannot be turned */
  bool is_level, is_mute, is_solo; /**< of a mixer */
  bool is_quiet;                   /**< the mixer has turned it off: it stands where it will be */
} WindowControl;

/** A microphone: distance from the axis, height above the batter head [m], and angle [deg]. */
typedef struct WindowMic {
  char name[TABOR_NAME_SIZE];
  double radius, angle, height;
} WindowMic;

/** A drum of a kit: the place of its batter head, seen from above, y away from the player [m];
 * angles [deg]. */
typedef struct WindowDrum {
  char name[TABOR_NAME_SIZE];
  double x, y, height, radius, depth, tilt, facing;
  bool is_plate; /**< a cymbal */
} WindowDrum;

typedef struct WindowScene {
  char title[TABOR_NAME_SIZE]; /**< name of the drum or kit */
  bool is_second;              /**< of two settings to compare the second plays */
  bool can_undo, can_redo;
  const ListView *list;    /**< in place of the controls; NULL: it is closed */
  const char *marked;      /**< name of the marked entry of the list */
  const char *page;        /**< name of the page of controls */
  uint32_t focus;          /**< the control on which keys act, or WINDOW_NO_CONTROL */
  uint32_t typed_at;       /**< the control whose value is typed, or WINDOW_NO_CONTROL */
  const LineEditor *typed; /**< what is typed: a value, or the answer to `message`; NULL: nothing */
  char message[WINDOW_MESSAGE]; /**< a line for the user */
  bool is_alarm;                /**< it says what is wrong */
  uint32_t control_count;
  WindowControl controls[KNOB_PAGE];
  double meters[2];             /**< of each side, 1: full scale */
  double load;                  /**< largest of the last blocks, a share of their length; 0: none */
  bool is_draft;                /**< no quality takes less */
  double speed;                 /**< of the next stroke [m/s] */
  double struck_speed;          /**< of the newest one, by whomever [m/s]; 0: none yet */
  uint32_t struck_drum;         /**< of a kit: where it fell */
  double glow[TABOR_KIT_DRUMS]; /**< of each drum: 1 when a fast stroke falls, then less */

  bool is_kit;
  /* one drum */
  const TaborView *view; /**< NULL: the head and the wires are not seen */
  double radius, depth;  /**< [m]; depth 0: it has one head */
  uint32_t mic_count;
  WindowMic mics[TABOR_MAX_MICS];
  uint32_t mic; /**< whose place is written, or WINDOW_NO_MIC */
  double
    struck[2]; /**< place of the newest stroke, a part of the head's radius, and its angle [deg] */
  /* a kit */
  uint32_t drum_count;
  WindowDrum drums[TABOR_KIT_DRUMS];
} WindowScene;

typedef enum WindowPart {
  WINDOW_NOTHING,
  WINDOW_DRUM,
  WINDOW_MIC,
  WINDOW_BUTTON,
  WINDOW_LIST,
  WINDOW_CONTROL, /**< its way, or its name */
  WINDOW_VALUE,   /**< a control's value, which can be typed */
  WINDOW_MUTE,
  WINDOW_SOLO
} WindowPart;

/** What lies at a pixel. */
typedef struct WindowPlace {
  WindowPart part;
  Button button;
  uint32_t number;      /**< of the drum, the microphone, or the control */
  const ListLine *line; /**< in the list; NULL: none */
  bool is_star;         /**< of the line */
  double radius,
    angle; /**< on a drum: a part of the head's, or negative where no head is seen; [deg] */
} WindowPlace;

#endif
