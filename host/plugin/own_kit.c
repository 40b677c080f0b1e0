/* SPDX-License-Identifier: MIT */
#include "plugin/own_kit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/definition_text.h"
#include "kit/kit_file.h"

bool own_kit_begin(OwnKit *own) {
  memset(own, 0, sizeof *own);
  return pthread_mutex_init(&own->lock, NULL) == 0;
}

void own_kit_end(OwnKit *own) {
  (void)pthread_mutex_destroy(&own->lock);
  free(own->text);
  free(own->def);
}

/* Both are the own kit's from now on. */
static void replace(OwnKit *own, char *text, size_t length, TaborKitDef *def) {
  (void)pthread_mutex_lock(&own->lock);
  free(own->text);
  free(own->def);
  own->text = text;
  own->length = length;
  own->def = def;
  atomic_fetch_add(&own->version, 1);
  (void)pthread_mutex_unlock(&own->lock);
}

static char *copy_of(const char *text, size_t length) {
  char *const copy = malloc(length + 1);
  if (!copy) return NULL;
  memcpy(copy, text, length);
  copy[length] = '\0';
  return copy;
}

static bool has_samples(const TaborKitDef *def) {
  uint32_t note = 0;
  while (note < TABOR_KIT_NOTES && !def->note[note].sample[0]) note++;
  return note < TABOR_KIT_NOTES;
}

/* As it stands in the file, unless that names sound files beside it, which are to be found from a
 * session, too. */
static char *text_of(const char *text, size_t length, TaborKitDef *def) {
  if (!has_samples(def)) return copy_of(text, length);
  kit_file_root_samples(def);
  return definition_write_kit(def, TABOR_TEXT_EDIT, "Tabor Kit", NULL);
}

static bool take(OwnKit *own, const char *name, const char *text, size_t length, char *message,
                 size_t size) {
  TaborKitDef *const def = malloc(sizeof *def);
  if (!def) (void)snprintf(message, size, "%s: out of memory", name);
  const bool is_read = def &&
                       kit_file_parse(name, text, length, def, message, size) == PRESET_FILE_OK &&
                       kit_file_check(name, def, message, size);
  char *const copy = is_read ? text_of(text, length, def) : NULL;
  if (copy) {
    replace(own, copy, strlen(copy), def);
    return true;
  }
  if (is_read) (void)snprintf(message, size, "%s: out of memory", name);
  free(def);
  return false;
}

bool own_kit_load(OwnKit *own, const char *path, char *message, size_t size) {
  char *text;
  size_t length;
  if (preset_file_load(path, &text, &length, message, size) != PRESET_FILE_OK) return false;
  const bool is_taken = take(own, path, text, length, message, size);
  free(text);
  return is_taken;
}

bool own_kit_set(OwnKit *own, const char *text, size_t length, char *message, size_t size) {
  return take(own, "kit", text, length, message, size);
}

char *own_kit_text(OwnKit *own) {
  (void)pthread_mutex_lock(&own->lock);
  char *const text = own->text ? copy_of(own->text, own->length) : NULL;
  (void)pthread_mutex_unlock(&own->lock);
  return text;
}

bool own_kit_copy(OwnKit *own, TaborKitDef *def) {
  (void)pthread_mutex_lock(&own->lock);
  const bool is_there = own->def != NULL;
  if (is_there) *def = *own->def;
  (void)pthread_mutex_unlock(&own->lock);
  return is_there;
}

unsigned own_kit_version(const OwnKit *own) { return atomic_load(&own->version); }
