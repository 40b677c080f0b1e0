/* SPDX-License-Identifier: MIT */
/**
 * @file model_cache.h
 * Models shared by the plugins' instances. Instances with the same sound, rate and quality share
 * one model. If one instance is building that model, the others wait for it.
 *
 * The cache is the only state that instances share; its own lock protects it. SET-UP: any thread
 * but the audio thread.
 */
#ifndef TABOR_PLUGIN_MODEL_CACHE_H
#define TABOR_PLUGIN_MODEL_CACHE_H

#include <tabor/tabor.h>

/** Takes a model for @p def; return it with model_cache_give_back(). On an error *model is NULL. */
TaborStatus model_cache_take(const TaborDrumDef *def, const TaborModelOptions *options,
                             TaborModel **model, TaborError *error);
/** Returns a model to the cache. NULL is allowed. */
void model_cache_give_back(TaborModel *model);
/** Number of models in use. */
uint32_t model_cache_count(void);

#endif
