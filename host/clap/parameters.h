/* SPDX-License-Identifier: MIT */
/**
 * @file parameters.h
 * Knobs as CLAP's parameters. The id of a parameter is the place of its knob in knob_ports and never changes. The
 * value of a parameter is that of the knob; of a knob with a logarithmic scale it is the position, 0 to 1.
 */
#ifndef TABOR_CLAP_PARAMETERS_H
#define TABOR_CLAP_PARAMETERS_H

#include "clap/instance.h"

extern const clap_plugin_params_t instance_params;
extern const clap_plugin_remote_controls_t instance_remote_controls;

/** Notes the value or modulation that @p event brings. False: it brings none. */
bool parameters_take(Instance *instance, const clap_event_header_t *event) REALTIME;
/** AUDIO. Sets the knobs of the player to the values that were noted. @p shell is an Instance. */
void parameters_turn(void *shell) REALTIME;
/** Sets a knob to @p value, within its range; what is no number does nothing. */
void parameters_set(Instance *instance, KnobId id, double value) REALTIME;

/** MAIN. Tells the host that knobs have moved of which it does not know. */
void parameters_tell(Instance *instance);
/** The id of a knob's parameter, and its value as the host sees it. */
clap_id parameters_id(KnobId id);
double parameters_value(const Instance *instance, KnobId id);

#endif
