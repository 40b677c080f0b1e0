/* SPDX-License-Identifier: MIT */
/* The state of Tabor Kit is a text: the name of the kit, whose number a later version may change, a line for each knob, with
 * its value's bits, and at last the text of the user's own kit, if there is one. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/kit_instance.h"
#include "clap/stream_text.h"

#define FIRST_LINE "tabor-kit-state 1\n"
#define KIT_LINE "name "
#define OWN "own" /* name of the user's own kit */
#define OWN_LINE "kit-file\n"
#define HEAD_LIMIT 16384u /* bytes in front of the user's own kit */
#define LIMIT (HEAD_LIMIT + TABOR_TEXT_LIMIT)

static const char *kit_name(float kit) {
  return kit_knob_is_own(kit) ? OWN : tabor_kit((uint32_t)kit)->name;
}

static size_t write_head(const KitInstance *instance, char *text) {
  char digits[9];
  size_t length = (size_t)snprintf(text, HEAD_LIMIT, FIRST_LINE KIT_LINE "%s\n",
                                   kit_name(atomic_load(&instance->values[KIT_KNOB_KIT])));
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    stream_float_digits(atomic_load(&instance->values[i]), digits);
    length +=
      (size_t)snprintf(text + length, HEAD_LIMIT - length, "%s %s\n", kit_knobs[i].symbol, digits);
  }
  return length;
}

static bool save(const clap_plugin_t *plugin, const clap_ostream_t *stream) {
  KitInstance *const instance = kit_instance_of(plugin);
  char head[HEAD_LIMIT];
  const size_t length = write_head(instance, head);
  char *const own = own_kit_text(&instance->own);
  const bool is_written = stream_write(stream, head, length) &&
                          (!own || (stream_write(stream, OWN_LINE, strlen(OWN_LINE)) &&
                                    stream_write(stream, own, strlen(own))));
  free(own);
  return is_written;
}

static bool refuse(KitInstance *instance, const char *why) {
  char line[2 * TABOR_TEXT_SIZE];
  (void)snprintf(line, sizeof line, "the state is not restored: %s", why);
  kit_instance_say(instance, line);
  return false;
}

static bool find_kit(const char *name, float *value) {
  *value = kit_knobs[KIT_KNOB_KIT].maximum;
  if (strcmp(name, OWN) == 0) return true;
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

/* Reads the lines of knobs. The text of the user's own kit goes to *own. */
static const char *read_lines(char *text, float values[KIT_KNOB_COUNT], const char **own) {
  float kit = kit_knobs[KIT_KNOB_KIT].fallback;
  *own = NULL;
  while (*text && strncmp(text, OWN_LINE, strlen(OWN_LINE)) != 0) {
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
  if (*text) *own = text + strlen(OWN_LINE);
  values[KIT_KNOB_KIT] = kit;
  return NULL;
}

static bool read_state(KitInstance *instance, char *text) {
  float values[KIT_KNOB_COUNT];
  char message[TABOR_TEXT_SIZE];
  const char *own;
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) values[i] = kit_knobs[i].fallback;
  if (strncmp(text, FIRST_LINE, strlen(FIRST_LINE)) != 0) {
    return refuse(instance, "it is not one of this version of Tabor Kit");
  }
  const char *const wrong = read_lines(text + strlen(FIRST_LINE), values, &own);
  if (wrong) return refuse(instance, wrong);
  if (own && !own_kit_set(&instance->own, own, strlen(own), message, sizeof message)) {
    return refuse(instance, message);
  }
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) atomic_store(&instance->values[i], values[i]);
  return true;
}

static bool load(const clap_plugin_t *plugin, const clap_istream_t *stream) {
  KitInstance *const instance = kit_instance_of(plugin);
  char *const text = stream_read(stream, LIMIT);
  if (!text) return refuse(instance, "it cannot be read");
  const bool is_read = read_state(instance, text);
  free(text);
  if (is_read) kit_parameters_tell(instance);
  return is_read;
}

const clap_plugin_state_t kit_state = {.save = save, .load = load};
