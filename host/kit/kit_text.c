/* SPDX-License-Identifier: MIT */
#include "kit/kit_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/preset_file.h"
#include "midi/midi_map.h"

/* Where the text goes, and what became of it. */
typedef struct Text {
  KitTextKind kind;
  PresetSink *sink;
  void *context;
  Outcome outcome;
} Text;

PRINTF_AT(2, 3) static void give(Text *text, const char *format, ...) {
  char line[3 * TABOR_TEXT_SIZE];
  va_list values;
  va_start(values, format);
  const int size = vsnprintf(line, sizeof line, format, values);
  va_end(values);
  if (text->outcome != OUTCOME_OK) return;
  if (size < 0 || (size_t)size >= sizeof line || strlen(line) > PRESET_LINE_LIMIT + 2) {
    text->outcome = refuse("'%.40s...': a kit file's lines hold %d bytes", line, PRESET_LINE_LIMIT);
    return;
  }
  text->outcome = text->sink(text->context, line, (size_t)size);
}

/* With as many digits as it takes to read the same number. */
static void give_number(Text *text, const char *key, double value, const char *unit) {
  char digits[32];
  for (int precision = 6; precision <= 17; precision++) {
    (void)snprintf(digits, sizeof digits, "%.*g", precision, value);
    if (strtod(digits, NULL) == value) break;
  }
  if (*unit) {
    give(text, "%s = %s ; [%s]\n", key, digits, unit);
  } else {
    give(text, "%s = %s\n", key, digits);
  }
}

static void give_value(Text *text, const char *key, const char *value) {
  if (text->outcome == OUTCOME_OK && !preset_text_survives(value)) {
    text->outcome = refuse("%s: a kit file cannot hold this text: '%.80s'", key, value);
  }
  give(text, "%s = %s\n", key, value);
}

static void give_words(Text *text, const char *key, const char *words) {
  if (*words) give_value(text, key, words);
}

/* ---- the kit and its room -------------------------------------------------------------------- */

static void give_kit(Text *text, const TaborKitDef *def) {
  give(text, "\n[kit]\n");
  give_words(text, "name", def->name);
  give_words(text, "comment", def->comment);
  give_words(text, "license", def->license);
  if (def->coupled) {
    give_number(text, "coupling", def->coupling, "dB");
  } else {
    give(text, "coupling = off\n");
  }
  give_number(text, "overheads", def->overheads, "dB");
  give_number(text, "full_scale", def->full_scale, "Pa");
  give_number(text, "overhead_spacing", def->overhead_spacing, "m");
  give_number(text, "overhead_x", def->overhead_x, "m");
  give_number(text, "overhead_y", def->overhead_y, "m");
  give_number(text, "overhead_height", def->overhead_height, "m");
}

/* Entries of a drum that @p base has otherwise or not at all; those that begin with @p prefix, without it. */
static void give_changes(Text *text, const TaborDrumDef *def, const TaborDrumDef *base,
                         const char *prefix) {
  PresetEntry entry;
  TaborError error;
  char before[TABOR_TEXT_SIZE];
  const size_t length = strlen(prefix);
  for (uint32_t i = 0; preset_entry_read(def, i, &entry, &text->outcome); i++) {
    if (strncmp(entry.key, prefix, length) != 0) continue;
    const bool known =
      base && tabor_drum_def_get(base, entry.key, before, sizeof before, &error) == TABOR_OK;
    if (known && strcmp(before, entry.value) == 0) continue;
    give_value(text, entry.key + length, entry.value);
  }
}

static void give_room(Text *text, const TaborKitDef *def) {
  TaborDrumDef carrier;
  tabor_drum_def_default(&carrier);
  carrier.room = def->room;
  give(text, "\n[room]\n");
  give_changes(text, &carrier, NULL, "room.");
}

/* ---- a drum ---------------------------------------------------------------------------------- */

static void give_notes(Text *text, const TaborKitDrumDef *drum, uint8_t stroke) {
  char list[TABOR_KIT_NOTES * 5] = "";
  size_t used = 0;
  for (unsigned note = 0; note < TABOR_KIT_NOTES; note++) {
    if (drum->notes[note] != stroke) continue;
    used += (size_t)snprintf(list + used, sizeof list - used, "%s%u", used ? "," : "", note);
  }
  give_words(text, midi_stroke_names[stroke], list);
}

/* A drum may have the name of a preset and lack parts of it. */
static bool has_all_of(const TaborDrumDef *def, const TaborDrumDef *preset) {
  char key[2 * TABOR_NAME_SIZE], value[TABOR_TEXT_SIZE];
  TaborError error;
  for (uint32_t i = 0; tabor_drum_def_key(preset, i, key, sizeof key); i++) {
    if (tabor_drum_def_get(def, key, value, sizeof value, &error) != TABOR_OK) return false;
  }
  return true;
}

static void give_drum(Text *text, const TaborKitDrumDef *drum) {
  TaborDrumDef preset;
  TaborError error;
  const bool known = text->kind == KIT_TEXT_SHORT &&
                     tabor_drum_def_preset(&preset, drum->def.name, &error) == TABOR_OK &&
                     has_all_of(&drum->def, &preset);
  give(text, "\n[drum.%s]\n", drum->name);
  give(text, "preset = %s\n", known ? drum->def.name : "none");
  give_number(text, "x", drum->x, "m");
  give_number(text, "y", drum->y, "m");
  give_number(text, "height", drum->height, "m");
  give_number(text, "tilt", drum->tilt, "deg");
  give_number(text, "facing", drum->facing, "deg");
  give_number(text, "gain", drum->gain, "dB");
  give_number(text, "pan", drum->pan, "");
  give_number(text, "wake", drum->wake, "Pa");
  give_number(text, "choke", drum->choke, "");
  give_words(text, "mic", drum->mic);
  for (uint8_t stroke = TABOR_KIT_STROKE_HEAD; midi_stroke_names[stroke]; stroke++) {
    give_notes(text, drum, stroke);
  }
  if (!known) tabor_drum_def_clear(&preset);
  give_changes(text, &drum->def, &preset, "");
}

/* ---- all of it ------------------------------------------------------------------------------- */

static void give_samples(Text *text, const KitSamples *samples) {
  for (unsigned note = 0; note < MIDI_VALUES; note++) {
    const KitSample *const sample = &samples->notes[note];
    if (!sample->path) continue;
    give(text, "\n[note.%u]\n", note);
    give_words(text, "sample", sample->path);
    give_number(text, "gain", sample->gain_db, "dB");
    give_number(text, "choke", sample->choke, "");
  }
}

static void give_all(Text *text, const TaborKitDef *def, const KitSamples *samples,
                     const char *by) {
  give(text, "; A Tabor kit, written by %s. SI units, angles in degrees.\n", by);
  give_kit(text, def);
  give_room(text, def);
  for (uint32_t i = 0; i < def->drum_count; i++) give_drum(text, &def->drum[i]);
  give_samples(text, samples);
}

/* A PresetSink. */
static Outcome drop(void *context, const char *text, size_t size) {
  (void)context, (void)text, (void)size;
  return OUTCOME_OK;
}

/* Twice: what no kit file can hold is refused before the first line is given. */
Outcome kit_text_write(const TaborKitDef *def, const KitSamples *samples, KitTextKind kind,
                       const char *by, PresetSink *sink, void *context) {
  Text check = {.kind = kind, .sink = drop},
       text = {.kind = kind, .sink = sink, .context = context};
  give_all(&check, def, samples, by);
  if (check.outcome != OUTCOME_OK) return check.outcome;
  give_all(&text, def, samples, by);
  return text.outcome;
}
