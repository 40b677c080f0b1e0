/* SPDX-License-Identifier: MIT */
/* The state of Tabor Kit is a text: a line for each knob, with its value's bits, and the name of the kit, whose number
 * a later version may change. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/kit_instance.h"
#include "clap/stream_text.h"

#define FIRST_LINE "tabor-kit-state 1\n"
#define KIT_LINE "name "
#define LIMIT 16384u /* bytes of a state */

static bool save(const clap_plugin_t *plugin, const clap_ostream_t *stream) {
  const KitInstance *const instance = kit_instance_of(plugin);
  const TaborKitInfo *const kit = tabor_kit((uint32_t)atomic_load(&instance->values[KIT_KNOB_KIT]));
  char text[LIMIT], digits[9];
  size_t length = (size_t)snprintf(text, sizeof text, FIRST_LINE KIT_LINE "%s\n", kit->name);
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    stream_float_digits(atomic_load(&instance->values[i]), digits);
    length +=
      (size_t)snprintf(text + length, sizeof text - length, "%s %s\n", kit_knobs[i].symbol, digits);
  }
  return stream_write(stream, text, length);
}

static bool refuse(KitInstance *instance, const char *why) {
  char line[128];
  (void)snprintf(line, sizeof line, "the state is not restored: %s", why);
  kit_instance_say(instance, line);
  return false;
}

static bool find_kit(const char *name, float *value) {
  for (uint32_t i = 0; i < tabor_kit_count(); i++) {
    if (strcmp(tabor_kit(i)->name, name) != 0) continue;
    *value = (float)i;
    return true;
  }
  return false;
}

/* A knob that this version does not have is passed over. */
static bool read_knob(char *line, float values[KIT_KNOB_COUNT]) {
  char *const digits = strchr(line, ' ');
  float value;
  if (!digits || !stream_float(digits + 1, &value)) return false;
  *digits = '\0';
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    if (strcmp(kit_knobs[i].symbol, line) == 0) {
      values[i] = kit_knob_clamp((KitKnobId)i, (double)value);
    }
  }
  return true;
}

static const char *read_lines(char *text, float values[KIT_KNOB_COUNT]) {
  float kit = kit_knobs[KIT_KNOB_KIT].fallback;
  while (*text) {
    char *const end = strchr(text, '\n');
    if (!end) return "its last line does not end";
    *end = '\0';
    if (strncmp(text, KIT_LINE, strlen(KIT_LINE)) == 0) {
      if (!find_kit(text + strlen(KIT_LINE), &kit)) return "there is no such kit";
    } else if (!read_knob(text, values)) {
      return "a control in it is no number";
    }
    text = end + 1;
  }
  values[KIT_KNOB_KIT] = kit;
  return NULL;
}

static bool read_state(KitInstance *instance, char *text) {
  float values[KIT_KNOB_COUNT];
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) values[i] = kit_knobs[i].fallback;
  if (strncmp(text, FIRST_LINE, strlen(FIRST_LINE)) != 0) {
    return refuse(instance, "it is not one of this version of Tabor Kit");
  }
  const char *const wrong = read_lines(text + strlen(FIRST_LINE), values);
  if (wrong) return refuse(instance, wrong);
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) atomic_store(&instance->values[i], values[i]);
  return true;
}

static bool load(const clap_plugin_t *plugin, const clap_istream_t *stream) {
  KitInstance *const instance = kit_instance_of(plugin);
  char *const text = stream_read(stream, LIMIT);
  if (!text) return refuse(instance, "it cannot be read");
  const bool is_read = read_state(instance, text);
  free(text);
  if (!is_read) return false;
  if (instance->params) instance->params->rescan(instance->host, CLAP_PARAM_RESCAN_VALUES);
  if (instance->is_open) instance->host->request_process(instance->host);
  return true;
}

const clap_plugin_state_t kit_state = {.save = save, .load = load};
