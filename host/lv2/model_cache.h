/* SPDX-License-Identifier: MIT */
/**
 * @file model_cache.h
 * Models that the plugin's instances share: those with the same sound, rate and quality have one, and one that
 * is being built for an instance is waited for by the others.
 *
 * The one thing that instances have in common, under a lock of its own. SET-UP: any thread but the audio
 * thread.
 */
#ifndef TABOR_LV2_MODEL_CACHE_H
#define TABOR_LV2_MODEL_CACHE_H

#include <tabor/tabor.h>

/** A model for @p def, to be given back with model_cache_give_back(). On an error *model is NULL. */
TaborStatus model_cache_take(const TaborDrumDef *def, const TaborModelOptions *options,
                             TaborModel **model, TaborError *error);
/** NULL is allowed. */
void model_cache_give_back(TaborModel *model);
/** Models that are in use now. */
uint32_t model_cache_count(void);

#endif
