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

/* `what` it is, and by whom it is written, unless that is NULL, stand in its first line. */
static char *write_text(WriteFn *write, const void *def, TaborTextForm form, const char *what,
                        const char *by, TaborError *error) {
  char first[160] = "";
  size_t length;
  TaborError own;
  if (!error) error = &own;
  if (write(def, form, NULL, 0, &length, error) != TABOR_OK) return NULL;
  if (by) {
    (void)snprintf(first, sizeof first,
                   "; A Tabor %s, written by %s. SI units, angles in degrees.\n\n", what, by);
  }
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
  return write_text(write_drum, def, form, "preset", by, error);
}

static TaborStatus write_kit(const void *def, uint32_t form, char *text, size_t size,
                             size_t *length, TaborError *error) {
  return tabor_kit_def_write(def, form, text, size, length, error);
}

char *definition_write_kit(const TaborKitDef *def, TaborTextForm form, const char *by,
                           TaborError *error) {
  return write_text(write_kit, def, form, "kit", by, error);
}

/* ---- reading --------------------------------------------------------------------------------- */

/* A TaborTextTake. */
static TaborStatus take_line(void *def, const TaborTextLine *line, TaborError *error) {
  const TaborStatus status = line->key ? tabor_drum_def_set(def, line->full, line->value, error)
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
