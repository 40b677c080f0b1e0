/* SPDX-License-Identifier: MIT */
/**
 * @file model_builder.h
 * Changes the drum that is played, or one drum of a kit, during play.
 *
 * A live parameter changes at once. Any other parameter, and another preset, needs a new model,
 * which the builder's thread builds in some tenths of a second. Until then the old model plays on.
 * Then the ringing drum is swapped to the new model; another preset replaces the drum, and the old
 * one rings out beside it. One build runs at a time. After it the latest request is built; requests
 * between are skipped. If sound waits (--backend file), the change is built in the caller's thread
 * and acts at its frame.
 *
 * Any thread but the audio thread may call these functions. A function that fails prints why
 * (message.h).
 */
#ifndef TABOR_HOST_MODEL_BUILDER_H
#define TABOR_HOST_MODEL_BUILDER_H

#include <pthread.h>

#include "play/drum_history.h"
#include "play/log_writer.h"
#include "sound/player.h"

typedef struct ModelBuilder ModelBuilder;

/** The drum to start with. */
typedef struct ModelBuilderSetup {
  const char *preset; /**< a name or a file; copied */
  bool is_listed;     /**< the preset is built in and def is its definition */
  const TaborDrumDef *def;
  TaborModelOptions options;
  TaborModel *model; /**< of def, or of the drum as it stands in the kit; retained */
  /** Kit of which it is drum number `drum`, copied; NULL: it is no kit's. */
  const TaborKitDef *kit;
  uint32_t drum;
  /** Held while a message is sent: of a kit the same for all builders, since a player's sources are
   * one thread each; outlives them. NULL: nobody else sends. */
  pthread_mutex_t *sending;
  bool waits; /**< sound waits for changes */
} ModelBuilderSetup;

/** *builder is valid or NULL, whatever the outcome. */
Outcome model_builder_create(const ModelBuilderSetup *setup, ModelBuilder **builder);
/** Adds every new model to @p log, which may be NULL. Call before the first change. */
void model_builder_log(ModelBuilder *builder, LogWriter *log);
/** Enables changes and sends them to @p player. */
Outcome model_builder_start(ModelBuilder *builder, Player *player);
/** Disables changes. Call before the player is destroyed and the log is finished; NULL is allowed.
 */
void model_builder_stop(ModelBuilder *builder);
/** Frees everything. Call after the drum or kit was destroyed. NULL is allowed. */
void model_builder_destroy(ModelBuilder *builder);

/**
 * Sets the parameter @p key, such as "wires.tension", to @p value at @p frame, or later, once the
 * model is built. An error message starts with @p what, such as "--set".
 */
Outcome model_builder_set(ModelBuilder *builder, uint64_t frame, const char *what, const char *key,
                          const char *value);
/**
 * Takes the newest change by model_builder_set() since the drum was chosen back, or makes one again
 * that was taken back. Writes its key to @p key. Refuses if there is none.
 */
Outcome model_builder_undo(ModelBuilder *builder, uint64_t frame, char key[DRUM_KEY_SIZE]);
Outcome model_builder_redo(ModelBuilder *builder, uint64_t frame, char key[DRUM_KEY_SIZE]);
/** Changes to a preset, by name or from a file. Discards all earlier settings. */
Outcome model_builder_preset(ModelBuilder *builder, uint64_t frame, const char *preset);
/** Changes to a built-in preset by a MIDI program change; does nothing if it plays already,
 * unmodified. */
Outcome model_builder_program(ModelBuilder *builder, uint64_t frame, const char *preset);
/** Changes to the built-in preset @p step places further in the list, which wraps around. */
Outcome model_builder_step_preset(ModelBuilder *builder, uint64_t frame, int step);

/** Gives the definition of the drum as requested last, built or not. */
void model_builder_definition(ModelBuilder *builder, TaborDrumDef *def);
/** Fills in preset and building. */
void model_builder_status(ModelBuilder *builder, PlayStatus *status);

#endif
