/* SPDX-License-Identifier: MIT */
#include "drum_source.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "preset_file.h"
#include "suggest.h"

const char *preset_argument(const Arguments *arguments) {
  return arguments->operand ? arguments->operand : DEFAULT_PRESET;
}

bool preset_is_file(const char *preset) {
  const size_t length = strlen(preset);
  return strchr(preset, '/') || (length >= 4 && strcmp(preset + length - 4, ".ini") == 0);
}

/* A PresetPairFn: one "key = value" of a preset file into the definition. */
static bool set_pair(void *def, const char *section, const char *key, const char *value,
                     unsigned line, char *message, size_t size) {
  (void)line;
  char full[2 * TABOR_NAME_SIZE + 256];
  (void)snprintf(full, sizeof full, "%s.%s", section, key);
  TaborError error;
  if (tabor_drum_def_set(def, full, value, &error) == TABOR_OK) return true;
  (void)snprintf(message, size, "%s", error.message);
  return false;
}

static Outcome load_file(const char *path, TaborDrumDef *def) {
  char message[2 * TABOR_TEXT_SIZE];
  tabor_drum_def_clear(def);
  switch (preset_file_read(path, set_pair, def, message, sizeof message)) {
  case PRESET_FILE_OK: return OUTCOME_OK;
  case PRESET_FILE_UNREADABLE: return fail("%s", message);
  case PRESET_FILE_INVALID: break;
  }
  return refuse("%s", message);
}

static Outcome load_builtin(const char *name, TaborDrumDef *def) {
  TaborError error;
  if (tabor_drum_def_preset(def, name, &error) == TABOR_OK) return OUTCOME_OK;
  return report_engine_error(&error);
}

/* One KEY=VALUE. */
static Outcome apply_setting(const char *setting, TaborDrumDef *def) {
  const char *const equals = strchr(setting, '=');
  char key[2 * TABOR_NAME_SIZE];
  const size_t length = equals ? (size_t)(equals - setting) : 0;
  if (length == 0) return refuse("--set '%.80s': not of the form KEY=VALUE", setting);
  if (length >= sizeof key)
    return refuse("--set '%.80s...': no parameter has so long a key", setting);
  memcpy(key, setting, length);
  key[length] = '\0';
  TaborError error;
  if (tabor_drum_def_set(def, key, equals + 1, &error) == TABOR_OK) return OUTCOME_OK;
  return report_engine_error(&error);
}

Outcome drum_load(const Arguments *arguments, TaborDrumDef *def) {
  const char *const preset = preset_argument(arguments);
  Outcome outcome = preset_is_file(preset) ? load_file(preset, def) : load_builtin(preset, def);
  const char *setting;
  size_t position = 0;
  while (outcome == OUTCOME_OK && (setting = arguments_next(arguments, "set", &position))) {
    outcome = apply_setting(setting, def);
  }
  if (outcome != OUTCOME_OK) return outcome;
  TaborError error;
  if (tabor_drum_def_validate(def, &error) == TABOR_OK) return OUTCOME_OK;
  return report_engine_error(&error);
}

static const char *const quality_names[] = {"draft", "live", "studio", "reference", NULL};

static const char *quality_name_at(const void *names, size_t index) {
  return ((const char *const *)names)[index];
}

static Outcome quality_read(const char *text, uint32_t *quality) {
  for (uint32_t i = 0; quality_names[i]; i++) {
    if (strcmp(text, quality_names[i]) == 0) {
      *quality = TABOR_QUALITY_DRAFT + i;
      return OUTCOME_OK;
    }
  }
  char hint[96];
  suggest_hint(hint, sizeof hint, text, "", quality_name_at, quality_names);
  return refuse("--quality '%.80s': unknown; allowed: draft, live, studio, reference%s", text,
                hint);
}

Outcome model_options_read(const Arguments *arguments, TaborModelOptions *options) {
  static const NumberField rate = {"--rate", 22050, 192000, true};
  tabor_model_options_default(options);
  options->quality = TABOR_QUALITY_DEFAULT; /* what the definition says */
  const char *const rate_text = arguments_value(arguments, "rate");
  const char *const quality_text = arguments_value(arguments, "quality");
  Outcome outcome = OUTCOME_OK;
  if (rate_text) outcome = number_read(&rate, rate_text, &options->sample_rate);
  if (outcome == OUTCOME_OK && quality_text) {
    outcome = quality_read(quality_text, &options->quality);
  }
  return outcome;
}
