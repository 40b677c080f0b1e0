/* SPDX-License-Identifier: MIT */
#include "clap/instance_state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/instance_drum.h"
#include "clap/parameters.h"
#include "clap/stream_text.h"
#include "drums/definition_text.h"

#define FIRST_LINE "tabor-state 1\n"
#define DEFINITION "definition\n"
#define HEAD_LIMIT 16384u /* bytes in front of the definition */
#define STATE_LIMIT (HEAD_LIMIT + TABOR_TEXT_LIMIT)

/* ---- saving --------------------------------------------------------------------------------- */

static size_t write_head(const Instance *instance, const SavedState *saved, char *text) {
  char digits[2][9];
  size_t length = (size_t)snprintf(text, HEAD_LIMIT, FIRST_LINE);
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    const float value = atomic_load(&instance->values[i]);
    const float seen = i < KNOB_SEEN ? saved->seen[i] : value;
    stream_float_digits(value, digits[0]);
    stream_float_digits(seen, digits[1]);
    length += (size_t)snprintf(text + length, HEAD_LIMIT - length, "%s %s %s\n", knobs[i].symbol,
                               digits[0], digits[1]);
  }
  return length + (size_t)snprintf(text + length, HEAD_LIMIT - length, DEFINITION);
}

static bool save(const clap_plugin_t *plugin, const clap_ostream_t *stream) {
  Instance *const instance = instance_of(plugin);
  char head[HEAD_LIMIT];
  SavedState saved;
  instance_save(instance, &saved);
  char *const text = definition_write(&saved.def, TABOR_TEXT_KEEP, NULL, NULL);
  if (!text) return false;
  const size_t length = write_head(instance, &saved, head);
  const bool is_written =
    stream_write(stream, head, length) && stream_write(stream, text, strlen(text));
  free(text);
  return is_written;
}

/* ---- restoring ------------------------------------------------------------------------------ */

static bool refuse(Instance *instance, const char *why) {
  char line[TABOR_TEXT_SIZE + 64];
  (void)snprintf(line, sizeof line, "the state is not restored: %s", why);
  instance_say(instance, line);
  return false;
}

/* What a state says of the knobs. */
typedef struct KnobValues {
  float values[KNOB_COUNT], seen[KNOB_COUNT];
} KnobValues;

/* The line of one knob, which is cut. */
static bool read_knob(char *line, KnobValues *read) {
  char *const value = strchr(line, ' ');
  float one, other;
  if (!value || strlen(value) != 18 || value[9] != ' ') return false;
  *value = '\0';
  if (!stream_float(value + 1, &one) || !stream_float(value + 10, &other)) return false;
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    if (strcmp(knobs[i].symbol, line) != 0) continue;
    read->values[i] = one;
    read->seen[i] = other;
  }
  return true;
}

/* Returns the definition, behind the knobs; NULL if a line is wrong. */
static char *read_knobs(char *text, KnobValues *read) {
  while (strncmp(text, DEFINITION, strlen(DEFINITION)) != 0) {
    char *const end = strchr(text, '\n');
    if (!end) return NULL;
    *end = '\0';
    if (!read_knob(text, read)) return NULL;
    text = end + 1;
  }
  return text + strlen(DEFINITION);
}

/* What a state does not say. Without a pitch in it, the tension leads; without a drum's number, the drum stays wherever the
 * host puts the knob first. */
static void use_fallbacks(const Instance *instance, KnobValues *read) {
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    const bool is_pitch = i == KNOB_BATTER_PITCH || i == KNOB_RESONANT_PITCH;
    read->values[i] = read->seen[i] = is_pitch ? 0 : instance->ranges[i].fallback;
  }
  read->seen[KNOB_DRUM] = NAN;
}

/* Earlier versions passed over a pitch that the head cannot have. The drum stays as it was, and the knob shows its pitch. */
static void settle_pitches(SavedState *saved, KnobValues *read) {
  TaborDrumDef tuned = saved->def;
  TaborError error;
  while (tabor_drum_def_tune(&tuned, &error) != TABOR_OK) {
    const KnobId id = knob_of_refused_pitch(&error);
    if (id == KNOB_COUNT) return;
    *knob_field(&tuned, id) = *knob_field(&saved->def, id) = 0;
    const float shown = (float)knob_decimal((float)knob_shown(&saved->def, id));
    if (read->values[id] == read->seen[id]) read->values[id] = shown;
    read->seen[id] = shown;
  }
}

static bool read_state(Instance *instance, char *text) {
  KnobValues read;
  SavedState saved;
  TaborError error;
  use_fallbacks(instance, &read);
  if (strncmp(text, FIRST_LINE, strlen(FIRST_LINE)) != 0)
    return refuse(instance, "it is not one of this version of Tabor");
  char *const definition = read_knobs(text + strlen(FIRST_LINE), &read);
  if (!definition) return refuse(instance, "a control in it is no number");
  if (!definition_read(definition, strlen(definition), &saved.def, &error))
    return refuse(instance, error.message);
  settle_pitches(&saved, &read);
  memcpy(saved.seen, read.seen, sizeof saved.seen);
  for (uint32_t i = 0; i < KNOB_COUNT; i++)
    parameters_set(instance, (KnobId)i, (double)read.values[i]);
  instance_restore(instance, &saved);
  return true;
}

static bool load(const clap_plugin_t *plugin, const clap_istream_t *stream) {
  Instance *const instance = instance_of(plugin);
  char *const text = stream_read(stream, STATE_LIMIT);
  if (!text) return refuse(instance, "it cannot be read");
  const bool is_read = read_state(instance, text);
  free(text);
  if (is_read) parameters_tell(instance);
  return is_read;
}

const clap_plugin_state_t instance_state = {.save = save, .load = load};
