/* SPDX-License-Identifier: MIT */
/**
 * @file describe_parts.h
 * What the descriptions of all plugins share.
 */
#ifndef TABOR_LV2_DESCRIBE_PARTS_H
#define TABOR_LV2_DESCRIBE_PARTS_H

typedef struct PluginWords {
  const char *uri, *name;
  const char *kind; /**< class of plugins that LV2 sorts it among */
  const char *brief, *comment;
} PluginWords;

/** The beginning of a plugin: everything that a host shows in its list, and what the plugin
 * requires. */
void put_plugin_words(const PluginWords *words);

/* Lines of a port. */

void put_range(double fallback, double minimum, double maximum);
/** @p unit may be empty. */
void put_unit(const char *unit);
/** A value with a name, @p length bytes of @p label. */
void put_point(const char *label, int length, double value);
/** Words separated by '|', for 0, 1, ... */
void put_choices(const char *choices);
/** The side of a stereo pair, 0: left. */
void put_side(unsigned side);

/* All lines of a port. */

void put_events(void);
void put_freewheel(void);
void put_ready(void);

#endif
