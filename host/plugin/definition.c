/* SPDX-License-Identifier: MIT */
#include "plugin/definition.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/definition_text.h"
#include "kit/kit_file.h"

static const char BY[] = "a window of Tabor's plugins";

typedef struct Visit {
  void (*visit)(void *context, const char *key);
  void *context;
} Visit;

static TaborStatus take_line(void *context, const TaborTextLine *line, TaborError *error) {
  const Visit *const visit = context;
  (void)error;
  if (line->key) visit->visit(visit->context, line->full);
  return TABOR_OK;
}

/* The text has them all, in a time in proportion to their number; by their numbers it would be
 * their square. */
bool definition_visit(const Definition *definition, void (*visit)(void *context, const char *key),
                      void *context) {
  Visit visited = {visit, context};
  char *const text = definition->is_kit
                       ? definition_write_kit(&definition->kit, TABOR_TEXT_KEEP, NULL, NULL)
                       : definition_write(&definition->drum, TABOR_TEXT_KEEP, NULL, NULL);
  const bool is_read =
    text && tabor_text_read(text, strlen(text), take_line, &visited, NULL) == TABOR_OK;
  free(text);
  return is_read;
}

bool definition_get(const Definition *definition, const char *key, char value[DEFINITION_VALUE]) {
  const TaborStatus status =
    definition->is_kit ? tabor_kit_def_get(&definition->kit, key, value, DEFINITION_VALUE, NULL)
                       : tabor_drum_def_get(&definition->drum, key, value, DEFINITION_VALUE, NULL);
  return status == TABOR_OK;
}

static TaborStatus set_in_drum(TaborDrumDef *drum, const char *key, const char *value,
                               TaborError *error) {
  TaborDrumDef changed = *drum;
  TaborStatus status = tabor_drum_def_set(&changed, key, value, error);
  if (status == TABOR_OK) status = tabor_drum_def_validate(&changed, error);
  if (status == TABOR_OK) *drum = changed;
  return status;
}

static TaborStatus set_in_kit(TaborKitDef *kit, const char *key, const char *value,
                              TaborError *error) {
  TaborKitDef *const changed = malloc(sizeof *changed);
  if (!changed) return TABOR_ERROR_MEMORY;
  *changed = *kit;
  TaborStatus status = tabor_kit_def_set(changed, key, value, error);
  if (status == TABOR_OK) status = tabor_kit_def_validate(changed, error);
  if (status == TABOR_OK) *kit = *changed;
  free(changed);
  return status;
}

bool definition_set(Definition *definition, const char *key, const char *value, TaborError *error) {
  *error = (TaborError){.message = "out of memory"};
  const TaborStatus status = definition->is_kit ? set_in_kit(&definition->kit, key, value, error)
                                                : set_in_drum(&definition->drum, key, value, error);
  return status == TABOR_OK;
}

bool definition_find_built_in(const Definition *named, Definition *definition) {
  const char *const name = definition_name(named);
  definition->is_kit = named->is_kit;
  const TaborStatus status = named->is_kit ? tabor_kit_def_preset(&definition->kit, name, NULL)
                                           : tabor_drum_def_preset(&definition->drum, name, NULL);
  return status == TABOR_OK;
}

const char *definition_name(const Definition *definition) {
  return definition->is_kit ? definition->kit.name : definition->drum.name;
}

void definition_rename(Definition *definition, const char *name) {
  char *const place = definition->is_kit ? definition->kit.name : definition->drum.name;
  (void)snprintf(place, TABOR_NAME_SIZE, "%s", name);
}

/* Sound files have names that lead to them from any folder. */
char *definition_text(Definition *definition, TaborError *error) {
  if (!definition->is_kit) return definition_write(&definition->drum, TABOR_TEXT_EDIT, BY, error);
  kit_file_root_samples(&definition->kit);
  return definition_write_kit(&definition->kit, TABOR_TEXT_EDIT, BY, error);
}
