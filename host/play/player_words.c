/* SPDX-License-Identifier: MIT */
#include "play/player_words.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/pitch_text.h"
#include "plugin/key_text.h"
#include "plugin/knob_text.h"
#include "plugin/knobs.h"

/* KNOB_COUNT if there is none. The stick's hardness is that of the usual striker, which may be
 * another one. */
static KnobId knob_of(const TaborDrumDef *def, const char *key) {
  uint32_t id = 0;
  while (id < KNOB_KEYS && strcmp(knobs[id].key, key) != 0) id++;
  const bool is_other = id == KNOB_STICK_HARDNESS && strcmp(def->strike.striker, "stick") != 0;
  return id < KNOB_KEYS && !is_other ? (KnobId)id : KNOB_COUNT;
}

static KnobId shown_for(KnobId id) {
  if (id == KNOB_BATTER_TENSION) return KNOB_BATTER_PITCH;
  return id == KNOB_RESONANT_TENSION ? KNOB_RESONANT_PITCH : id;
}

static void write_value(const TaborDrumDef *def, KnobId id, double value, char *text, size_t size) {
  if (knobs[id].scale == KNOB_IN_NOTES) {
    (void)pitch_text(value, text, size);
  } else {
    const KnobRange range = knob_range(id, def);
    (void)knob_text(&knobs[id], &range, value, text, size);
  }
}

void player_words_write(const TaborDrumDef *def, const char *key, char *text, size_t size) {
  const KnobId id = shown_for(knob_of(def, key));
  char words[64];
  *text = '\0';
  if (id == KNOB_COUNT || knobs[id].scale == KNOB_IN_UNITS) return;
  const double value = knob_shown(def, id);
  if (isnan(value)) return;
  write_value(def, id, value, words, sizeof words);
  (void)snprintf(text, size, " (%s %s)", knobs[id].name, words);
}

/* The engine reads plain numbers and notes without blanks, and says what is wrong with them. */
static bool is_plain(KnobId id, const char *text) {
  if (knobs[id].scale == KNOB_IN_NOTES) return !strchr(text, ' ');
  return !strchr(text, '%') && !isalpha((unsigned char)*text);
}

/* A number with a unit; without one it is in the table's, as everywhere in the program. */
static const char *read_unit(const char *key, const char *text, char room[PLAYER_WORD_SIZE]) {
  const TaborParameter *const parameter = tabor_parameter_find(key);
  char *end = NULL;
  (void)strtod(text, &end);
  if (!parameter || end == text || *end == '\0') return text;
  return key_text_read(parameter, "", text, room, PLAYER_WORD_SIZE) ? room : text;
}

const char *player_words_read(const TaborDrumDef *def, const char *key, const char *text,
                              char room[PLAYER_WORD_SIZE]) {
  const KnobId id = knob_of(def, key);
  double value;
  if (id == KNOB_COUNT || knobs[id].scale == KNOB_IN_UNITS) return read_unit(key, text, room);
  if (is_plain(id, text)) return text;
  if (knobs[id].scale == KNOB_IN_NOTES) {
    if (!pitch_read(text, &value)) return text;
  } else {
    const KnobRange range = knob_range(id, def);
    if (!knob_text_read(&knobs[id], &range, text, &value)) return text;
  }
  (void)snprintf(room, PLAYER_WORD_SIZE, "%.9g", value);
  return room;
}
