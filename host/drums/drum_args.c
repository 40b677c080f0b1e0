/* SPDX-License-Identifier: MIT */
#include "drums/drum_args.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/suggest.h"
#include "drums/drum_file.h"
#include "platform/paths.h"

const char *preset_argument(const Arguments *arguments) {
  return arguments->operand ? arguments->operand : DEFAULT_PRESET;
}

static Outcome load_file(const char *path, TaborDrumDef *def) {
  char message[2 * TABOR_TEXT_SIZE];
  switch (drum_file_read(path, def, message, sizeof message)) {
  case PRESET_FILE_OK: return OUTCOME_OK;
  case PRESET_FILE_UNREADABLE: return fail("%s", message);
  case PRESET_FILE_INVALID: break;
  }
  return refuse("%s", message);
}

static Outcome load_builtin(const char *name, TaborDrumDef *def) {
  TaborError error;
  if (tabor_drum_def_preset(def, name, &error) == TABOR_OK) return OUTCOME_OK;
  if (error.status != TABOR_ERROR_NAME || strstr(error.message, "did you mean")) {
    return report_engine_error(&error);
  }
  return refuse("%s; 'tabor presets' lists them, and files end in .ini", error.message);
}

/* The room stays when the drum changes. */
static bool changes_drum(const char *setting) { return strncmp(setting, "room.", 5) != 0; }

int drum_listed_preset(const Arguments *arguments) {
  const char *setting;
  size_t position = 0;
  while ((setting = arguments_next(arguments, "set", &position)) != NULL) {
    if (changes_drum(setting)) return -1;
  }
  return preset_place(preset_argument(arguments));
}

const char *drum_mic_name(const void *def, size_t index) {
  const TaborDrumDef *const drum = def;
  return index < drum->mic_count ? drum->mic[index].name : NULL;
}

const char *kit_drum_name(const void *kit, size_t index) {
  const TaborKitDef *const def = kit;
  return index < def->drum_count ? def->drum[index].name : NULL;
}

const char *drum_striker_name(const void *def, size_t index) {
  const TaborDrumDef *const drum = def;
  return index < drum->striker_count ? drum->striker[index].name : NULL;
}

static uint32_t same_mic(const TaborDrumDef *from, uint32_t mic, const TaborDrumDef *to) {
  const int named = tabor_drum_def_find_mic(to, from->mic[mic].name);
  if (named >= 0) return (uint32_t)named;
  return mic < to->mic_count ? mic : 0;
}

void drum_keep_mics(const TaborDrumDef *first, const TaborModel *model, TaborSwap *swap) {
  const TaborDrumDef *const def = tabor_model_definition(model);
  uint8_t mics[TABOR_MAX_MICS];
  for (uint32_t i = 0; i < first->mic_count; i++) mics[i] = (uint8_t)same_mic(first, i, def);
  tabor_swap_route(swap, mics, first->mic_count);
}

/* Kinds of things with names of their own. */
static const struct Family {
  const char *prefix, *what;
  NameAt *name_at;
  int (*find)(const TaborDrumDef *def, const char *name);
} families[] = {
  {"mic.", "microphone", drum_mic_name, tabor_drum_def_find_mic},
  {"striker.", "striker", drum_striker_name, tabor_drum_def_find_striker},
};

/* Refuses the key of a microphone or striker that the drum has not got. */
static Outcome check_member(const struct Family *family, const char *what, const char *key,
                            const TaborDrumDef *def) {
  const size_t prefix = strlen(family->prefix);
  const char *const dot = strrchr(key, '.');
  if (strncmp(key, family->prefix, prefix) != 0 || dot < key + prefix) return OUTCOME_OK;
  char name[2 * TABOR_NAME_SIZE], hint[512];
  memcpy(name, key + prefix, (size_t)(dot - key) - prefix);
  name[(size_t)(dot - key) - prefix] = '\0';
  if (family->find(def, name) >= 0) return OUTCOME_OK;
  suggest_choice(hint, sizeof hint, name, family->prefix, family->name_at, def);
  return refuse("%s '%.80s': the drum has no %s '%.63s'%s", what, key, family->what, name, hint);
}

static Outcome check_members(const char *what, const char *key, const TaborDrumDef *def) {
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < sizeof families / sizeof families[0] && outcome == OUTCOME_OK; i++) {
    outcome = check_member(&families[i], what, key, def);
  }
  return outcome;
}

static Outcome set_key(TaborDrumDef *def, const char *what, const char *key, const char *value) {
  const Outcome outcome = check_members(what, key, def);
  TaborError error;
  if (outcome != OUTCOME_OK) return outcome;
  if (tabor_drum_def_set(def, key, value, &error) == TABOR_OK) return OUTCOME_OK;
  return report_engine_error(&error);
}

Outcome drum_set(TaborDrumDef *def, const char *what, const char *key, const char *value) {
  TaborDrumDef changed = *def;
  TaborError error;
  const Outcome outcome = set_key(&changed, what, key, value);
  if (outcome != OUTCOME_OK) return outcome;
  if (tabor_drum_def_tune(&changed, &error) != TABOR_OK) return report_engine_error(&error);
  *def = changed;
  return OUTCOME_OK;
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
  return set_key(def, "--set", key, equals + 1);
}

const char *preset_file(const char *preset, char room[USER_PRESET_PATH]) {
  if (preset_is_file(preset)) return preset;
  return preset_place(preset) < 0 ? user_preset_find(preset, room) : NULL;
}

static Outcome load_preset(const char *preset, TaborDrumDef *def) {
  char room[USER_PRESET_PATH];
  const char *const file = preset_file(preset, room);
  return file ? load_file(file, def) : load_builtin(preset, def);
}

Outcome drum_load_preset(const char *preset, TaborDrumDef *def) {
  TaborError error;
  const Outcome outcome = load_preset(preset, def);
  if (outcome != OUTCOME_OK) return outcome;
  if (tabor_drum_def_tune(def, &error) == TABOR_OK) return OUTCOME_OK;
  return refuse("%s: %s", preset, error.message);
}

Outcome drum_load(const Arguments *arguments, TaborDrumDef *def) {
  const char *const preset = preset_argument(arguments);
  Outcome outcome = load_preset(preset, def);
  const char *setting;
  size_t position = 0;
  while (outcome == OUTCOME_OK && (setting = arguments_next(arguments, "set", &position))) {
    outcome = apply_setting(setting, def);
  }
  if (outcome != OUTCOME_OK) return outcome;
  TaborError error;
  if (tabor_drum_def_tune(def, &error) == TABOR_OK) return OUTCOME_OK;
  if (!preset_is_file(preset)) return report_engine_error(&error);
  return refuse("%s%s: %s", preset, arguments_has(arguments, "set") ? " with --set" : "",
                error.message);
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

const char *quality_name(uint32_t quality) { return quality_names[quality - TABOR_QUALITY_DRAFT]; }

static bool sets_level(const Arguments *arguments) {
  static const char start[] = "quality.level=";
  const char *setting;
  size_t position = 0;
  while ((setting = arguments_next(arguments, "set", &position))) {
    if (strncmp(setting, start, sizeof start - 1) == 0) return true;
  }
  return false;
}

Outcome model_options_read(const Arguments *arguments, const TaborDrumDef *def,
                           TaborModelOptions *options) {
  static const NumberField rate = {"--rate", 22050, 192000, true};
  tabor_model_options_default(options);
  options->quality = sets_level(arguments) ? def->quality.level : (uint32_t)TABOR_QUALITY_LIVE;
  const char *const quality_text = arguments_value(arguments, "quality");
  Outcome outcome = arguments_number(arguments, &rate, &options->sample_rate);
  if (outcome == OUTCOME_OK && quality_text) {
    outcome = quality_read(quality_text, &options->quality);
  }
  return outcome;
}

Outcome drum_create(const TaborDrumDef *def, const TaborModelOptions *options, SharedModels *shared,
                    TaborDrum **drum) {
  TaborModel *model = NULL;
  TaborError error;
  *drum = NULL;
  const Outcome outcome = shared_models_take(shared, def, options, &model);
  if (outcome != OUTCOME_OK) return outcome;
  const TaborStatus status = tabor_drum_create(model, drum, &error);
  tabor_model_release(model); /* the drum keeps its own reference */
  return status == TABOR_OK ? OUTCOME_OK : report_engine_error(&error);
}
