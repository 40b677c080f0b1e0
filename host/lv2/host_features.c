/* SPDX-License-Identifier: MIT */
#include "lv2/host_features.h"

#include <lv2/core/lv2_util.h>
#include <string.h>

#include "plugin/instrument.h"

bool host_features_find(const LV2_Feature *const *list, double rate, const char *name,
                        HostFeatures *features) {
  memset(features, 0, sizeof *features);
  const char *const missing = lv2_features_query(
    list, LV2_LOG__log, &features->logger.log, false, LV2_URID__map, &features->map, true,
    LV2_WORKER__schedule, &features->schedule, false, NULL);
  lv2_log_logger_set_map(&features->logger, features->map);
  const bool has_rate = rate >= INSTRUMENT_LEAST_RATE && rate <= INSTRUMENT_MOST_RATE;
  if (missing) {
    (void)lv2_log_error(&features->logger, "%s: the host lacks %s\n", name, missing);
  } else if (!has_rate) {
    (void)lv2_log_error(&features->logger, "%s: a sample rate of %g Hz; allowed: %d to %d\n", name,
                        rate, INSTRUMENT_LEAST_RATE, INSTRUMENT_MOST_RATE);
  }
  return !missing && has_rate;
}
