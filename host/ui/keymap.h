/* SPDX-License-Identifier: MIT */
/**
 * @file keymap.h
 * The action of each key of the computer keyboard during play: the default map, and changes to it
 * from a file (docs/keyboard.md):
 *
 *     [keys]
 *     a = stroke 0%        ; the head's centre
 *     f1 = :preset tom-12  ; a command
 *
 * Escape (twice) and Ctrl-C always quit.
 */
#ifndef TABOR_HOST_KEYMAP_H
#define TABOR_HOST_KEYMAP_H

#include "base/keys.h"
#include "base/message.h"

typedef enum ActionKind {
  ACTION_NONE,
  ACTION_STROKE,    /**< value: radius of the stroke, as a fraction of the head's */
  ACTION_GHOST,     /**< the same at a third of the speed */
  ACTION_REPEAT,    /**< repeats the last stroke */
  ACTION_TECHNIQUE, /**< a stroke; text: "rimshot", "cross-stick", "rim", "buzz", "sweep" */
  ACTION_SPEED,     /**< value: speed of later strokes [m/s] */
  ACTION_SNARES,    /**< on or off */
  ACTION_MUFFLE,    /**< on or off */
  ACTION_PRESET,    /**< value: 1: the next, -1: the previous */
  ACTION_DRUM,      /**< value: 1: the kit's next drum, -1: the previous */
  ACTION_GAIN,      /**< value: change of the gain [dB] */
  ACTION_COMMAND,   /**< opens the command line */
  ACTION_RUN,       /**< text: a command, as on the command line */
  ACTION_HELP,
  ACTION_QUIT
} ActionKind;

#define ACTION_TEXT_SIZE 200  /**< size of a line of a key file, with its terminator */
#define MOST_KEYS 256         /**< most keys with an action */
#define GHOST_SPEED (1.0 / 3) /**< of a ghost note, as a fraction of the speed of strokes */

/** The action of a key. */
typedef struct Action {
  ActionKind kind;
  double value;
  const char *text; /**< text of the kinds that have one, else ""; owned by the keymap */
} Action;

typedef struct KeyBinding {
  Key key;
  ActionKind kind;
  double value;
  char text[ACTION_TEXT_SIZE];
} KeyBinding;

/** All keys with an action, in the order of the help. */
typedef struct Keymap {
  KeyBinding bindings[MOST_KEYS];
  size_t count;
} Keymap;

/** Initialises @p keymap with the default map. */
void keymap_default(Keymap *keymap);
/** Applies the file to @p keymap. Refuses an invalid file; fails if it cannot be read. */
Outcome keymap_read(const char *path, Keymap *keymap);
/** The action of @p key; ACTION_NONE for keys without an action. */
Action keymap_find(const Keymap *keymap, Key key);
/** Writes the names of the keys whose action is of this kind, "a s space"; returns their number. */
size_t keymap_list(const Keymap *keymap, ActionKind kind, char *text, size_t size);

#endif
