/* SPDX-License-Identifier: MIT */
/**
 * @file model_build.h
 * Builds models. A build that takes long is announced, with the parameter that costs the most of
 * it, and its progress stands on the terminal until something else is written there.
 */
#ifndef TABOR_HOST_MODEL_BUILD_H
#define TABOR_HOST_MODEL_BUILD_H

#include "base/message.h"

/** Builds a model; the caller owns one reference to it. On an error *model is NULL. */
Outcome model_build(const TaborDrumDef *def, const TaborModelOptions *options, TaborModel **model);
/** The same without announcements and progress, for the screen of play. */
Outcome model_build_quietly(const TaborDrumDef *def, const TaborModelOptions *options,
                            TaborModel **model);
/** True while an announced build goes on in any thread. */
bool model_build_is_shown(void);

#endif
