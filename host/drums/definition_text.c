/* SPDX-License-Identifier: MIT */
#include "drums/definition_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- writing --------------------------------------------------------------------------------- */

/* tabor_drum_def_write() or tabor_kit_def_write(). */
typedef TaborStatus WriteFn(const void *def, uint32_t form, char *text, size_t size, size_t *length,
                            TaborError *error);

static bool refuse(TaborError *error, TaborStatus status, const char *message) {
  *error = (TaborError){.status = status, .minimum = NAN, .maximum = NAN};
  (void)snprintf(error->message, sizeof error->message, "%s", message);
  return false;
}

static void write_first_line(char *text, size_t size, const char *what, const char *by) {
  text[0] = '\0';
  if (!by) return;
  (void)snprintf(text, size, "; A Tabor %s, written by %s. SI units, angles in degrees.\n\n", what,
                 by);
}

static char *write_text(WriteFn *write, const void *def, TaborTextForm form, const char *first,
                        TaborError *error) {
  size_t length;
  TaborError own;
  if (!error) error = &own;
  if (write(def, form, NULL, 0, &length, error) != TABOR_OK) return NULL;
  const size_t before = strlen(first);
  char *const text = malloc(before + length + 1);
  if (!text) {
    (void)refuse(error, TABOR_ERROR_MEMORY, "out of memory");
    return NULL;
  }
  memcpy(text, first, before);
  (void)write(def, form, text + before, length + 1, NULL, error);
  return text;
}

static TaborStatus write_drum(const void *def, uint32_t form, char *text, size_t size,
                              size_t *length, TaborError *error) {
  return tabor_drum_def_write(def, form, text, size, length, error);
}

char *definition_write(const TaborDrumDef *def, TaborTextForm form, const char *by,
                       TaborError *error) {
  char first[160];
  write_first_line(first, sizeof first, "preset", by);
  return write_text(write_drum, def, form, first, error);
}

static TaborStatus write_kit(const void *def, uint32_t form, char *text, size_t size,
                             size_t *length, TaborError *error) {
  return tabor_kit_def_write(def, form, text, size, length, error);
}

char *definition_write_kit(const TaborKitDef *def, TaborTextForm form, const char *by,
                           TaborError *error) {
  char first[160];
  write_first_line(first, sizeof first, "kit", by);
  return write_text(write_kit, def, form, first, error);
}

/* ---- reading --------------------------------------------------------------------------------- */

/* A TaborTextTake. */
static TaborStatus take_line(void *def, const TaborTextLine *line, TaborError *error) {
  char key[2 * TABOR_TEXT_WORD + 2];
  (void)snprintf(key, sizeof key, "%s%s%s", line->section, *line->section ? "." : "",
                 line->key ? line->key : "");
  const TaborStatus status = line->key ? tabor_drum_def_set(def, key, line->value, error)
                                       : tabor_drum_def_section(def, line->section, error);
  return status == TABOR_ERROR_KEY ? TABOR_OK : status;
}

bool definition_read(const char *text, size_t size, TaborDrumDef *def, TaborError *error) {
  TaborDrumDef read;
  if (size > 0 && text[size - 1] == '\0') size--;
  tabor_drum_def_clear(&read);
  bool is_good = tabor_text_read(text, size, take_line, &read, error) == TABOR_OK;
  if (is_good && read.mic_count == 0) {
    is_good = refuse(error, TABOR_ERROR_VALUE, "the drum has no microphone");
  }
  if (is_good) is_good = tabor_drum_def_validate(&read, error) == TABOR_OK;
  if (is_good) *def = read;
  return is_good;
}
