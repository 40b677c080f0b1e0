/* SPDX-License-Identifier: MIT */
/**
 * @file kit_build.h
 * Builds a kit: the models of its drums on several threads.
 */
#ifndef TABOR_HOST_KIT_BUILD_H
#define TABOR_HOST_KIT_BUILD_H

#include <tabor/kit.h>

#include "base/message.h"

/** Builds the models of @p def with @p options on at most @p threads threads; the caller owns one reference to each. On an
 * error all of them are NULL. */
Outcome kit_models_build(const TaborKitDef *def, const TaborModelOptions *options, uint32_t threads,
                         TaborModel *models[TABOR_KIT_DRUMS]);
/** Releases models, which may be NULL. */
void kit_models_release(TaborModel *models[TABOR_KIT_DRUMS]);
/** Builds the models of @p def with @p options on at most @p threads threads, and the kit. On an error *kit is NULL. */
Outcome kit_build(const TaborKitDef *def, const TaborModelOptions *options, uint32_t threads,
                  TaborKit **kit);

#endif
