/* SPDX-License-Identifier: MIT */
/**
 * @file host_features.h
 * What a plugin asks of its host. SET-UP: all functions.
 */
#ifndef TABOR_LV2_HOST_FEATURES_H
#define TABOR_LV2_HOST_FEATURES_H

#include <lv2/log/logger.h>
#include <lv2/urid/urid.h>
#include <lv2/worker/worker.h>
#include <stdbool.h>

typedef struct HostFeatures {
  LV2_URID_Map *map;
  LV2_Log_Logger logger;               /**< silent if the host has no log */
  const LV2_Worker_Schedule *schedule; /**< or NULL */
} HostFeatures;

/**
 * Finds what @p list has. False, and an error in the host's log after the plugin's @p name:
 * something that is needed is not there, or there are no models for the sample rate @p rate [Hz].
 */
bool host_features_find(const LV2_Feature *const *list, double rate, const char *name,
                        HostFeatures *features);

#endif
