/* SPDX-License-Identifier: MIT */
#include "render/variations.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tabor/tabor.h>

#include "base/random.h"
#include "drums/pitch_text.h"
#include "plugin/key_name.h"
#include "strokes/humanize_options.h"

enum { LONGEST_VALUE = 64 };

/* ---- ranges --------------------------------------------------------------------------------- */

static bool read_end(const TaborParameter *row, const char *text, double *value) {
  char *end = NULL;
  if (row && strcmp(row->key, "pitch") == 0) return pitch_read(text, value);
  *value = strtod(text, &end);
  return end != text && *end == '\0' && isfinite(*value);
}

/* "2000..4000": both ends, the lower one first. */
static bool read_range(const TaborParameter *row, const char *text, Varied *varied) {
  char low[LONGEST_VALUE];
  const char *const dots = strstr(text, "..");
  if (!dots || (size_t)(dots - text) >= sizeof low) return false;
  (void)snprintf(low, sizeof low, "%.*s", (int)(dots - text), text);
  return read_end(row, low, &varied->low) && read_end(row, dots + 2, &varied->high) &&
         varied->low <= varied->high;
}

static Outcome read_varied(const char *text, Varied *varied) {
  char key[2 * TABOR_NAME_SIZE];
  const char *const equals = strchr(text, '=');
  *varied = (Varied){.text = text, .key = equals ? (size_t)(equals - text) : 0};
  if (varied->key == 0 || varied->key >= sizeof key)
    return refuse("--vary '%.80s': not of the form KEY=RANGE", text);
  (void)snprintf(key, sizeof key, "%.*s", (int)varied->key, text);
  const TaborParameter *const row = key_parameter(key);
  if (read_range(row, equals + 1, varied)) {
    varied->is_bent = row && row->logarithmic && varied->low > 0;
    return OUTCOME_OK;
  }
  varied->words = strchr(equals, ',') ? equals + 1 : NULL;
  if (varied->words) return OUTCOME_OK;
  return refuse("--vary '%.80s': a range is LOW..HIGH, as %s=2000..4000, or a list, as "
                "strike.striker=stick,mallet",
                text, row ? key : "batter.tension");
}

/* ---- values --------------------------------------------------------------------------------- */

/* One from each part, in an order that is drawn (Fisher and Yates). */
static Outcome draw_shares(size_t count, uint64_t *state, double **shares) {
  double *const drawn = *shares = malloc(count * sizeof *drawn);
  if (!drawn) return fail_memory();
  for (size_t i = 0; i < count; i++) drawn[i] = ((double)i + random_share(state)) / (double)count;
  for (size_t i = count; i > 1; i--) {
    const size_t other = (size_t)(random_share(state) * (double)i);
    const double moved = drawn[i - 1];
    drawn[i - 1] = drawn[other];
    drawn[other] = moved;
  }
  return OUTCOME_OK;
}

static void write_word(const char *words, double share, char *text, size_t size) {
  size_t count = 1, number;
  for (const char *comma = words; (comma = strchr(comma, ',')); comma++) count++;
  for (number = (size_t)(share * (double)count); number > 0; number--)
    words = strchr(words, ',') + 1;
  (void)snprintf(text, size, "%.*s", (int)strcspn(words, ","), words);
}

/* A whole number has the same chance as its neighbours, up to both ends. */
static double number_at(const Varied *varied, double share, bool is_whole) {
  const double low = varied->low, high = varied->high;
  if (is_whole) return fmin(floor(low + share * (high - low + 1)), high);
  if (varied->is_bent) return low * pow(high / low, share);
  return low + share * (high - low);
}

void variations_value(const Variations *variations, size_t key, size_t number, char *text,
                      size_t size) {
  const Varied *const varied = &variations->varied[key];
  char name[2 * TABOR_NAME_SIZE];
  (void)snprintf(name, sizeof name, "%.*s", (int)varied->key, varied->text);
  const TaborParameter *const row = key_parameter(name);
  if (varied->words) {
    write_word(varied->words, varied->shares[number], text, size);
  } else {
    const bool is_whole = row && row->type == TABOR_TYPE_WHOLE;
    (void)snprintf(text, size, "%.6g", number_at(varied, varied->shares[number], is_whole));
  }
}

/* ---- all ------------------------------------------------------------------------------------ */

static Outcome read_count(const Arguments *arguments, Variations *variations) {
  static const NumberField field = {"--count", 1, VARIATIONS_MOST, true};
  const bool varies = arguments_has(arguments, "vary");
  double count = 0;
  if (varies && !arguments_has(arguments, "count"))
    return refuse("--vary needs --count: how many sounds");
  if (!varies && arguments_has(arguments, "count"))
    return refuse("--count needs --vary KEY=RANGE: what differs");
  if (varies && arguments_has(arguments, "replay"))
    return refuse("--replay and --vary: the log has the drum");
  const Outcome outcome = arguments_number(arguments, &field, &count);
  variations->count = (size_t)count;
  return outcome;
}

Outcome variations_read(const Arguments *arguments, Variations *variations) {
  const char *text;
  size_t position = 0;
  Humanizer seeded;
  *variations = (Variations){0};
  Outcome outcome = read_count(arguments, variations);
  if (outcome == OUTCOME_OK) outcome = humanize_read(arguments, 0, &seeded);
  while (outcome == OUTCOME_OK && (text = arguments_next(arguments, "vary", &position))) {
    Varied *const varied = &variations->varied[variations->key_count];
    if (variations->key_count == VARIED_MOST)
      return refuse("--vary: too many; allowed: up to %d", VARIED_MOST);
    outcome = read_varied(text, varied);
    if (outcome != OUTCOME_OK) return outcome;
    variations->key_count++;
    outcome = draw_shares(variations->count, &seeded.state, &varied->shares);
  }
  return outcome;
}

void variations_free(Variations *variations) {
  for (size_t i = 0; i < variations->key_count; i++) free(variations->varied[i].shares);
}

static const Option *set_option(const Option *options) {
  while (strcmp(options->name, "set") != 0) options++;
  return options;
}

Outcome variations_apply(const Variations *variations, size_t number, const Option *options,
                         Arguments *arguments, char **texts) {
  const size_t size = 2 * TABOR_NAME_SIZE + TABOR_TEXT_SIZE; /* of a text */
  char *const all = *texts = malloc(variations->key_count * size + 1);
  size_t key = 0;
  if (!all) return fail_memory();
  for (size_t i = 0; i < arguments->use_count; i++) {
    OptionUse *const use = &arguments->uses[i];
    if (strcmp(use->option->name, "vary") != 0) continue;
    const Varied *const varied = &variations->varied[key];
    char *const text = all + key * size;
    (void)snprintf(text, size, "%.*s=", (int)varied->key, varied->text);
    variations_value(variations, key, number, text + varied->key + 1, size - varied->key - 1);
    *use = (OptionUse){set_option(options), text};
    key++;
  }
  return OUTCOME_OK;
}
