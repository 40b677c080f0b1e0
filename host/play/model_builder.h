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
#ifndef TABOR_HOST_MODEL_BUILDER_H
#define TABOR_HOST_MODEL_BUILDER_H

#include "sound/player.h"

typedef struct ModelBuilder ModelBuilder;

/** What there is to begin with. */
typedef struct ModelBuilderSetup {
  const char *preset; /**< a name or a file; copied */
  bool is_listed;     /**< def is the preset's, which is built in */
  const TaborDrumDef *def;
  TaborModelOptions options;
  uint32_t channels;
  uint32_t mics[TABOR_MAX_MICS]; /**< of each channel */
  bool waits;                    /**< sound waits for changes */
} ModelBuilderSetup;

/** Builds the drum. *changes is valid, if not NULL, whatever the outcome. */
Outcome model_builder_create(const ModelBuilderSetup *setup, ModelBuilder **builder);
/** The newest drum, at first the one for player_create(). Belongs to @p builder. */
TaborDrum *model_builder_drum(const ModelBuilder *builder);
/** From now on changes are possible: they go to @p player. */
Outcome model_builder_start(ModelBuilder *builder, Player *player);
/** No change acts any more. To be called before the player is destroyed; NULL is allowed. */
void model_builder_stop(ModelBuilder *builder);
/** Frees the drums, too; the player is destroyed by then. NULL is allowed. */
void model_builder_destroy(ModelBuilder *builder);

/**
 * Sets the parameter @p key, as "wires.tension", to @p value at @p frame, or as soon after as it is
 * built; @p what, as "--set", begins the message if that is wrong.
 */
Outcome model_builder_set(ModelBuilder *builder, uint64_t frame, const char *what, const char *key,
                          const char *value);
/** Changes to a preset, by name or from a file. Nothing of what was set before remains. */
Outcome model_builder_preset(ModelBuilder *builder, uint64_t frame, const char *preset);
/** The same for a built-in preset by a program change of MIDI; does nothing if it is there already, as listed. */
Outcome model_builder_program(ModelBuilder *builder, uint64_t frame, const char *preset);
/** Changes to the built-in preset that is @p step places further in the list, which is a circle. */
Outcome model_builder_step_preset(ModelBuilder *builder, uint64_t frame, int step);

/** The drum as it is wished for now. */
void model_builder_definition(ModelBuilder *builder, TaborDrumDef *def);
/** Fills in preset and building. */
void model_builder_status(ModelBuilder *builder, PlayStatus *status);

#endif
