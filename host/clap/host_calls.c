/* SPDX-License-Identifier: MIT */
#include "clap/host_calls.h"

void host_rescan(const Instance *instance) {
  if (instance->params) instance->params->rescan(instance->host, CLAP_PARAM_RESCAN_VALUES);
}

void host_wake(const Instance *instance) {
  if (instance->instrument->is_open) instance->host->request_process(instance->host);
}

void host_use(const Instance *instance, const InstrumentSetting *setting) {
  instrument_set_all(instance->instrument, setting->values);
  instance->instrument->kind->calls->use(instance->instrument, setting);
  host_rescan(instance);
  host_wake(instance);
}
