/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drums/definition_text.h"
#include "lv2/instrument.h"
#include "lv2/uris.h"

#define PLAIN (LV2_STATE_IS_POD | LV2_STATE_IS_PORTABLE)

/* ---- saving --------------------------------------------------------------------------------- */

/* What is not known is not said. */
static LV2_State_Status store_controls(const Urids *urids, const SavedState *saved,
                                       LV2_State_Store_Function store, LV2_State_Handle state) {
  LV2_State_Status status = LV2_STATE_SUCCESS;
  for (uint32_t i = 0; i < KNOB_SEEN && status == LV2_STATE_SUCCESS; i++) {
    const float *const value = &saved->seen[i];
    if (isnan(*value)) continue;
    status = store(state, urids->controls[i], value, sizeof *value, urids->atom_float, PLAIN);
  }
  return status;
}

static LV2_State_Status store_all(const Urids *urids, const SavedState *saved, const char *text,
                                  LV2_State_Store_Function store, LV2_State_Handle state) {
  const int32_t version = STATE_VERSION;
  LV2_State_Status status =
    store(state, urids->version, &version, sizeof version, urids->atom_int, PLAIN);
  if (status != LV2_STATE_SUCCESS) return status;
  status = store(state, urids->definition, text, strlen(text) + 1, urids->atom_string, PLAIN);
  if (status != LV2_STATE_SUCCESS) return status;
  return store_controls(urids, saved, store, state);
}

static LV2_State_Status save(LV2_Handle handle, LV2_State_Store_Function store,
                             LV2_State_Handle state, uint32_t flags,
                             const LV2_Feature *const *features) {
  (void)flags;
  (void)features;
  Instrument *const instrument = handle;
  SavedState saved;
  model_worker_save(&instrument->worker, &saved);
  char *const text = definition_write(&saved.def, TABOR_TEXT_KEEP, NULL, NULL);
  if (!text) return LV2_STATE_ERR_NO_SPACE;
  const LV2_State_Status status = store_all(&instrument->urids, &saved, text, store, state);
  free(text);
  return status;
}

/* ---- restoring ------------------------------------------------------------------------------ */

/* Where a state is read from. */
typedef struct Source {
  Instrument *instrument;
  LV2_State_Retrieve_Function retrieve;
  LV2_State_Handle state;
} Source;

static LV2_State_Status refuse(const Source *source, LV2_State_Status status, const char *why) {
  (void)lv2_log_error(&source->instrument->host.logger, "Tabor: the state is not restored: %s\n",
                      why);
  return status;
}

/* NULL if there is none or it is of another type, which *status tells. */
static const void *find(const Source *source, LV2_URID key, LV2_URID type, size_t *size,
                        LV2_State_Status *status) {
  uint32_t found_type = 0, flags = 0;
  const void *const value = source->retrieve(source->state, key, size, &found_type, &flags);
  *status = LV2_STATE_SUCCESS;
  if (!value) *status = LV2_STATE_ERR_NO_PROPERTY;
  if (value && found_type != type) *status = LV2_STATE_ERR_BAD_TYPE;
  return *status == LV2_STATE_SUCCESS ? value : NULL;
}

static LV2_State_Status check_version(const Source *source) {
  const Urids *const urids = &source->instrument->urids;
  LV2_State_Status status;
  size_t size = 0;
  int32_t version;
  const void *const value = find(source, urids->version, urids->atom_int, &size, &status);
  if (!value) return refuse(source, status, "it has no version");
  if (size != sizeof version) return refuse(source, LV2_STATE_ERR_BAD_TYPE, "its version is none");
  memcpy(&version, value, sizeof version);
  if (version == STATE_VERSION) return LV2_STATE_SUCCESS;
  if (version > STATE_VERSION) {
    return refuse(source, LV2_STATE_ERR_UNKNOWN, "it is of a later version of Tabor");
  }
  return refuse(source, LV2_STATE_ERR_UNKNOWN, "its version is not one of Tabor's");
}

static LV2_State_Status read_definition(const Source *source, TaborDrumDef *def) {
  const Urids *const urids = &source->instrument->urids;
  LV2_State_Status status;
  TaborError error;
  size_t size = 0;
  const char *const text = find(source, urids->definition, urids->atom_string, &size, &status);
  if (!text) return refuse(source, status, "it has no definition of a drum");
  if (definition_read(text, size, def, &error)) return LV2_STATE_SUCCESS;
  return refuse(source, LV2_STATE_ERR_UNKNOWN, error.message);
}

static LV2_State_Status read_control(const Source *source, KnobId id, float *seen) {
  const Urids *const urids = &source->instrument->urids;
  LV2_State_Status status;
  size_t size = 0;
  const void *const value = find(source, urids->controls[id], urids->atom_float, &size, &status);
  *seen = NAN;
  if (status == LV2_STATE_ERR_NO_PROPERTY) return LV2_STATE_SUCCESS;
  if (status == LV2_STATE_SUCCESS && size != sizeof *seen) status = LV2_STATE_ERR_BAD_TYPE;
  if (status != LV2_STATE_SUCCESS) return refuse(source, status, "a control in it is no number");
  memcpy(seen, value, sizeof *seen);
  return LV2_STATE_SUCCESS;
}

/* Hosts restore such states, too, as that of a plugin that has no other: then the drum stays. */
static bool is_empty(const Source *source) {
  const Urids *const urids = &source->instrument->urids;
  uint32_t type, flags;
  size_t size;
  return !source->retrieve(source->state, urids->version, &size, &type, &flags) &&
         !source->retrieve(source->state, urids->definition, &size, &type, &flags);
}

static LV2_State_Status restore(LV2_Handle handle, LV2_State_Retrieve_Function retrieve,
                                LV2_State_Handle state, uint32_t flags,
                                const LV2_Feature *const *features) {
  (void)flags;
  (void)features;
  Instrument *const instrument = handle;
  const Source source = {instrument, retrieve, state};
  SavedState saved;
  if (is_empty(&source)) return LV2_STATE_SUCCESS;
  LV2_State_Status status = check_version(&source);
  if (status == LV2_STATE_SUCCESS) status = read_definition(&source, &saved.def);
  for (uint32_t i = 0; i < KNOB_SEEN && status == LV2_STATE_SUCCESS; i++) {
    status = read_control(&source, (KnobId)i, &saved.seen[i]);
  }
  if (status == LV2_STATE_SUCCESS) model_worker_restore(&instrument->worker, &saved);
  return status;
}

const LV2_State_Interface instrument_state = {.save = save, .restore = restore};
