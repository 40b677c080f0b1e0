/* SPDX-License-Identifier: MIT */
#include "kit/kit_args.h"

#include <stdio.h>
#include <string.h>

#include "drums/drum_args.h"
#include "kit/kit_file.h"

static Outcome load_file(const char *path, TaborKitDef *def) {
  char message[2 * TABOR_TEXT_SIZE];
  switch (kit_file_read(path, def, message, sizeof message)) {
  case PRESET_FILE_OK: return OUTCOME_OK;
  case PRESET_FILE_UNREADABLE: return fail("%s", message);
  case PRESET_FILE_INVALID: break;
  }
  return refuse("%s", message);
}

static Outcome load_builtin(const char *name, TaborKitDef *def) {
  TaborError error;
  if (tabor_kit_def_preset(def, name, &error) == TABOR_OK) return OUTCOME_OK;
  if (strstr(error.message, "did you mean")) return report_engine_error(&error);
  return refuse("%s; 'tabor presets --kits' lists them, and files end in .ini", error.message);
}

bool kit_is_builtin(const char *name) {
  uint32_t i = 0;
  while (i < tabor_kit_count() && strcmp(tabor_kit(i)->name, name) != 0) i++;
  return i < tabor_kit_count();
}

/* By name the built-in kits come before the user's. */
static Outcome load(const char *kit, TaborKitDef *def) {
  char room[USER_PRESET_PATH];
  const char *file = preset_is_file(kit) ? kit : NULL;
  if (!file && !kit_is_builtin(kit)) file = user_preset_find(kit, room);
  return file ? load_file(file, def) : load_builtin(kit, def);
}

/* A drum that is not there is a mistake, unless its preset is given. */
static Outcome check_drum(const TaborKitDef *def, const char *key) {
  static const char prefix[] = "drum.";
  char name[TABOR_NAME_SIZE] = "";
  if (strncmp(key, prefix, sizeof prefix - 1) != 0) return OUTCOME_OK;
  const char *const start = key + sizeof prefix - 1;
  const size_t length = strcspn(start, ".");
  if (length >= sizeof name || strcmp(start + length, ".preset") == 0) return OUTCOME_OK;
  memcpy(name, start, length);
  if (tabor_kit_def_find(def, name) >= 0) return OUTCOME_OK;
  return refuse("--set '%.80s': the kit has no drum '%.63s'; --set drum.%.63s.preset=NAME adds it",
                key, name, name);
}

static Outcome apply_setting(const char *setting, TaborKitDef *def) {
  const char *const equals = strchr(setting, '=');
  char key[4 * TABOR_NAME_SIZE];
  const size_t length = equals ? (size_t)(equals - setting) : 0;
  if (length == 0) return refuse("--set '%.80s': not of the form KEY=VALUE", setting);
  if (length >= sizeof key) return refuse("--set '%.80s...': no key is so long", setting);
  memcpy(key, setting, length);
  key[length] = '\0';
  const Outcome outcome = check_drum(def, key);
  TaborError error;
  if (outcome != OUTCOME_OK) return outcome;
  if (kit_file_set(def, key, equals + 1, &error) == TABOR_OK) return OUTCOME_OK;
  return report_engine_error(&error);
}

Outcome kit_refuse_options(const Arguments *arguments, const char *const *excluded, size_t count,
                           const char *reason) {
  for (size_t i = 0; i < count; i++) {
    if (!arguments_has(arguments, excluded[i])) continue;
    return refuse("--kit and --%s: %s", excluded[i], reason);
  }
  if (!arguments->operand) return OUTCOME_OK;
  return refuse("--kit and '%.80s': the kit has the drums", arguments->operand);
}

Outcome kit_load(const Arguments *arguments, TaborKitDef *def) {
  const char *const kit = arguments_value(arguments, "kit");
  const char *setting;
  size_t position = 0;
  char message[2 * TABOR_TEXT_SIZE];
  if (!*kit) return refuse("--kit needs the name of a kit");
  Outcome outcome = load(kit, def);
  if (outcome == OUTCOME_OK && !*def->name) kit_name_after(def, kit);
  while (outcome == OUTCOME_OK && (setting = arguments_next(arguments, "set", &position))) {
    outcome = apply_setting(setting, def);
  }
  if (outcome != OUTCOME_OK) return outcome;
  return kit_file_check(kit, def, message, sizeof message) ? OUTCOME_OK : refuse("%s", message);
}
