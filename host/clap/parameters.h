/* SPDX-License-Identifier: MIT */
/**
 * @file parameters.h
 * Knobs as CLAP's parameters. The id of a parameter is the number of its knob in the order of ports
 * and never changes. The value of a parameter is that of the knob; of a knob whose way is bent it
 * is the position, 0 to 1; of one that enables, whether it bypasses.
 */
#ifndef TABOR_CLAP_PARAMETERS_H
#define TABOR_CLAP_PARAMETERS_H

#include "clap/instance.h"

extern const clap_plugin_params_t parameters_extension;
extern const clap_plugin_remote_controls_t parameters_remote_controls;

/** Notes the value or modulation that @p event brings. False: it brings none. */
bool parameters_take(Instance *instance, const clap_event_header_t *event) REALTIME;

/** The value of a knob's parameter as the host sees it. */
double parameters_value(const Instrument *instrument, uint32_t knob);

#endif
