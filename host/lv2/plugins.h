/* SPDX-License-Identifier: MIT */
/**
 * @file plugins.h
 * The plugins by their URIs.
 */
#ifndef TABOR_LV2_PLUGINS_H
#define TABOR_LV2_PLUGINS_H

#include "lv2/uris.h"
#include "plugin/instrument.h"

typedef struct Lv2Plugin {
  const char *uri;
  InstrumentKindId kind;
  const char *type;   /**< class of plugins that LV2 sorts it among */
  const char *window; /**< URI of its window */
  const char *group;  /**< what URIs of its groups begin with */
  const char *file;   /**< property that a host sets to the path of a drum's or kit's file */
  const char *text;   /**< property of a state: what Instrument's calls->text() writes */
  bool needs_text;    /**< no state is without it, nor without a version */
} Lv2Plugin;

/** In the order of the binary. */
extern const Lv2Plugin lv2_plugins[INSTRUMENT_KINDS];

/** NULL if there is none. */
const Lv2Plugin *lv2_plugin_find(const char *uri);

#endif
