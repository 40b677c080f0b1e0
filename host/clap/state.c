/* SPDX-License-Identifier: MIT */
#include "clap/state.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/host_calls.h"
#include "clap/stream_text.h"

#define NAME_LINE "name "
#define HEAD_LIMIT 16384u /* bytes in front of the text */
#define LIMIT (HEAD_LIMIT + TABOR_TEXT_LIMIT)

/* ---- words ---------------------------------------------------------------------------------- */

static bool has_names(const InstrumentKind *kind) { return kind->calls->name != NULL; }

static const char *first_line(const InstrumentKind *kind) {
  return has_names(kind) ? "tabor-kit-state 1\n" : "tabor-state 1\n";
}

/* What stands before the text. */
static const char *text_line(const InstrumentKind *kind) {
  return has_names(kind) ? "kit-file\n" : "definition\n";
}

static bool begins_with(const char *text, const char *with) {
  return strncmp(text, with, strlen(with)) == 0;
}

/* ---- saving --------------------------------------------------------------------------------- */

/* Those of a drum stand with a second value. */
static bool has_seconds(const InstrumentKind *kind) { return kind->seen_count > 0; }

static size_t write_head(const InstrumentKind *kind, const InstrumentSetting *setting, char *text) {
  char digits[9], second[9];
  size_t length = (size_t)snprintf(text, HEAD_LIMIT, "%s", first_line(kind));
  if (has_names(kind)) {
    length += (size_t)snprintf(text + length, HEAD_LIMIT - length, NAME_LINE "%s\n",
                               kind->calls->name(setting->values[kind->main_knob]));
  }
  for (uint32_t i = 0; i < kind->knob_count; i++) {
    stream_float_digits(setting->values[i], digits);
    stream_float_digits(i < kind->seen_count ? setting->seen[i] : setting->values[i], second);
    length += (size_t)snprintf(text + length, HEAD_LIMIT - length,
                               has_seconds(kind) ? "%s %s %s\n" : "%s %s\n", kind->knobs[i].symbol,
                               digits, second);
  }
  return length;
}

static bool save(const clap_plugin_t *plugin, const clap_ostream_t *stream) {
  Instrument *const instrument = instrument_of(plugin);
  const InstrumentKind *const kind = instrument->kind;
  char head[HEAD_LIMIT];
  InstrumentSetting setting;
  instrument_note(instrument, &setting);
  const size_t length = write_head(kind, &setting, head);
  char *const text = kind->calls->text(instrument, &setting);
  const bool is_whole = text || has_names(kind); /* a drum has a definition */
  const bool is_written =
    is_whole && stream_write(stream, head, length) &&
    (!text || (stream_write(stream, text_line(kind), strlen(text_line(kind))) &&
               stream_write(stream, text, strlen(text))));
  free(text);
  return is_written;
}

/* ---- restoring ------------------------------------------------------------------------------ */

/* The line of one knob, which is cut. */
static bool read_knob(const InstrumentKind *kind, char *line, InstrumentSetting *setting) {
  char *const value = strchr(line, ' ');
  char *const second = value ? strchr(value + 1, ' ') : NULL;
  float one, other = 0;
  if (!value || (second != NULL) != has_seconds(kind)) return false;
  *value = '\0';
  if (second) *second = '\0';
  if (!stream_float(value + 1, &one)) return false;
  if (second && !stream_float(second + 1, &other)) return false;
  for (uint32_t i = 0; i < kind->knob_count; i++) {
    if (strcmp(kind->knobs[i].symbol, line) != 0) continue;
    setting->values[i] = one;
    setting->seen[i] = other;
  }
  return true;
}

/* Its name counts, not its number. */
static bool read_name(const InstrumentKind *kind, const char *name, InstrumentSetting *setting) {
  float value;
  if (!kind->calls->find(name, &value)) return false;
  setting->values[kind->main_knob] = value;
  return true;
}

/* Reads what stands before the text, which goes to *text, or NULL if there is none. Returns what is
 * wrong, or NULL. */
static const char *read_head(const InstrumentKind *kind, char *head, InstrumentSetting *setting,
                             char **text) {
  const char *name = NULL;
  char *line = head;
  while (*line && !begins_with(line, text_line(kind))) {
    char *const end = strchr(line, '\n');
    if (!end) return "its last line does not end";
    *end = '\0';
    if (has_names(kind) && begins_with(line, NAME_LINE)) {
      name = line + strlen(NAME_LINE);
    } else if (!read_knob(kind, line, setting)) {
      return "a control in it is no number";
    }
    line = end + 1;
  }
  *text = *line ? line + strlen(text_line(kind)) : NULL;
  return !name || read_name(kind, name, setting) ? NULL : "there is no such kit";
}

/* Returns what is wrong, or NULL; a reason of the text goes to @p message. */
static const char *read_state(Instrument *instrument, char *state, InstrumentSetting *setting,
                              char *message) {
  const InstrumentKind *const kind = instrument->kind;
  char *text;
  kind->calls->blank(instrument, setting);
  if (!begins_with(state, first_line(kind))) return "it is not one of this version of Tabor";
  const char *const wrong = read_head(kind, state + strlen(first_line(kind)), setting, &text);
  if (wrong) return wrong;
  if (!text) return has_names(kind) ? NULL : "it has no definition of a drum";
  return kind->calls->read(instrument, text, strlen(text), setting, message) ? NULL : message;
}

static bool refuse(const Instrument *instrument, const char *why) {
  char line[INSTRUMENT_MESSAGE + 32];
  (void)snprintf(line, sizeof line, "the state is not restored: %s", why);
  instrument_say(instrument, line);
  return false;
}

/* Knobs of the player's stay where they are. */
static void keep_players_knobs(const Instrument *instrument, InstrumentSetting *setting) {
  for (uint32_t i = 0; i < instrument->kind->knob_count; i++)
    if (instrument->kind->knobs[i].is_of_player)
      setting->values[i] = atomic_load(&instrument->values[i]);
}

static bool load_in(const clap_plugin_t *plugin, const clap_istream_t *stream, uint32_t context) {
  Instance *const instance = instance_of(plugin);
  char message[INSTRUMENT_MESSAGE];
  InstrumentSetting setting;
  char *const state = stream_read(stream, LIMIT);
  if (!state) return refuse(instance->instrument, "it cannot be read");
  const char *const wrong = read_state(instance->instrument, state, &setting, message);
  free(state);
  if (wrong) return refuse(instance->instrument, wrong);
  if (context == CLAP_STATE_CONTEXT_FOR_PRESET) keep_players_knobs(instance->instrument, &setting);
  host_use(instance, &setting);
  return true;
}

static bool load(const clap_plugin_t *plugin, const clap_istream_t *stream) {
  return load_in(plugin, stream, CLAP_STATE_CONTEXT_FOR_PROJECT);
}

static bool save_in(const clap_plugin_t *plugin, const clap_ostream_t *stream, uint32_t context) {
  (void)context;
  return save(plugin, stream);
}

const clap_plugin_state_t state_extension = {.save = save, .load = load};
const clap_plugin_state_context_t state_context_extension = {.save = save_in, .load = load_in};
