/* SPDX-License-Identifier: MIT */
/**
 * @file kit_build.h
 * Builds the models of a kit's drums on several threads.
 */
#ifndef TABOR_HOST_KIT_BUILD_H
#define TABOR_HOST_KIT_BUILD_H

#include <tabor/kit.h>

#include "base/message.h"

/** Builds the models of @p def with @p options on at most @p threads threads; the caller owns one
 * reference to each. On an error all of them are NULL. */
Outcome kit_models_build(const TaborKitDef *def, const TaborModelOptions *options, uint32_t threads,
                         TaborModel *models[TABOR_KIT_DRUMS]);
/** Lets a drum that lacks its close microphone, as one that another preset has replaced, be heard
 * by its first. */
void kit_fit_mic(TaborKitDrumDef *drum);
/** Releases models, which may be NULL. */
void kit_models_release(TaborModel *models[TABOR_KIT_DRUMS]);

#endif
