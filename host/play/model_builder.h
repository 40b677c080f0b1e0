/* SPDX-License-Identifier: MIT */
/**
 * @file model_builder.h
 * The drum that is played, and how it changes meanwhile.
 *
 * Live keys act at once. For every other key, and for another preset, a thread of its own builds a model, which
 * takes some tenths of a second. Until then the old one plays on; then the ringing drum is swapped to it, or, if it
 * is another preset, a new drum takes its place, and the old one rings out beside it (leaving.h). At most
 * one build is under way; when it is done the latest request is next, and those between are skipped.
 * Where sound waits (--backend file), the change is built on the spot and acts at its frame.
 *
 * Functions may be called by any thread but the audio thread; those that may go wrong say so (message.h).
 */
#ifndef TABOR_HOST_DRUM_CHANGES_H
#define TABOR_HOST_DRUM_CHANGES_H

#include "sound/player.h"

typedef struct DrumChanges DrumChanges;

/** What there is to begin with. */
typedef struct DrumChangesSetup {
  const char *preset; /**< a name or a file; copied */
  bool is_listed;     /**< def is the preset's, which is built in */
  const TaborDrumDef *def;
  TaborModelOptions options;
  uint32_t channels;
  uint32_t mics[TABOR_MAX_MICS]; /**< of each channel */
  bool waits;                    /**< sound waits for changes */
} DrumChangesSetup;

/** Builds the drum. *changes is valid, if not NULL, whatever the outcome. */
Outcome drum_changes_create(const DrumChangesSetup *setup, DrumChanges **changes);
/** The newest drum, at first the one for player_create(). Belongs to @p changes. */
TaborDrum *drum_changes_drum(const DrumChanges *changes);
/** From now on changes are possible: they go to @p player. */
Outcome drum_changes_start(DrumChanges *changes, Player *player);
/** No change acts any more. To be called before the player is destroyed; NULL is allowed. */
void drum_changes_stop(DrumChanges *changes);
/** Frees the drums, too; the player is destroyed by then. NULL is allowed. */
void drum_changes_destroy(DrumChanges *changes);

/**
 * Sets the parameter @p key, as "wires.tension", to @p value at @p frame, or as soon after as it is
 * built; @p what, as "--set", begins the message if that is wrong.
 */
Outcome drum_changes_set(DrumChanges *changes, uint64_t frame, const char *what, const char *key,
                         const char *value);
/** Changes to a preset, by name or from a file. Nothing of what was set before remains. */
Outcome drum_changes_preset(DrumChanges *changes, uint64_t frame, const char *preset);
/** The same for a built-in preset by a program change of MIDI; does nothing if it is there already, as listed. */
Outcome drum_changes_program(DrumChanges *changes, uint64_t frame, const char *preset);
/** Changes to the built-in preset that is @p step places further in the list, which is a circle. */
Outcome drum_changes_step_preset(DrumChanges *changes, uint64_t frame, int step);

/** The drum as it is wished for now. */
void drum_changes_definition(DrumChanges *changes, TaborDrumDef *def);
/** Fills in preset and building. */
void drum_changes_status(DrumChanges *changes, PlayStatus *status);

#endif
