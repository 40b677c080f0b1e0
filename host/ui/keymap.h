/* SPDX-License-Identifier: MIT */
/**
 * @file keymap.h
 * What each key of the keyboard does while somebody plays: the usual map, and changes to it from a
 * file (docs/keyboard.md):
 *
 *     [keys]
 *     a = stroke 0%        ; the head's centre
 *     f1 = :preset tom-12  ; a command
 *
 * Escape (twice) and Ctrl-C always quit.
 */
#ifndef TABOR_HOST_KEYMAP_H
#define TABOR_HOST_KEYMAP_H

#include "base/message.h"
#include "ui/keys.h"

typedef enum ActionKind {
  ACTION_NONE,
  ACTION_STROKE,    /**< value: the place, as a share of the head's radius */
  ACTION_GHOST,     /**< the same at a third of the speed */
  ACTION_REPEAT,    /**< the last stroke once more */
  ACTION_TECHNIQUE, /**< text: "rimshot", "cross-stick", "rim", "buzz", "sweep": such a stroke */
  ACTION_SPEED,     /**< value: of the strokes to come [m/s] */
  ACTION_SNARES,    /**< on or off */
  ACTION_MUFFLE,    /**< on or off */
  ACTION_PRESET,    /**< value: 1 the next, -1 the one before */
  ACTION_GAIN,      /**< value: by how much [dB] */
  ACTION_COMMAND,   /**< opens the command line */
  ACTION_RUN,       /**< text: a command, as typed on the command line */
  ACTION_HELP,
  ACTION_QUIT
} ActionKind;

#define ACTION_TEXT_SIZE 200  /**< a line of a file of keys, with its terminator */
#define MOST_KEYS 256         /**< that have an action */
#define GHOST_SPEED (1.0 / 3) /**< of a ghost note, as a share of the speed of strokes */

/** What a key does. */
typedef struct Action {
  ActionKind kind;
  double value;
  const char *text; /**< of those kinds that have one, else ""; lies in the keymap */
} Action;

typedef struct KeyBinding {
  Key key;
  ActionKind kind;
  double value;
  char text[ACTION_TEXT_SIZE];
} KeyBinding;

/** All keys that do something, in the order in which they are explained. */
typedef struct Keymap {
  KeyBinding bindings[MOST_KEYS];
  size_t count;
} Keymap;

/** The usual map. */
void keymap_default(Keymap *keymap);
/** Changes @p keymap as the file says. Refuses a file that is wrong, fails if it cannot be read. */
Outcome keymap_read(const char *path, Keymap *keymap);
/** What @p key does; ACTION_NONE for keys without an action. */
Action keymap_find(const Keymap *keymap, Key key);
/** Writes the keys whose action is of this kind, as people know them, "a s space"; returns how many there are. */
size_t keymap_list(const Keymap *keymap, ActionKind kind, char *text, size_t size);

#endif
