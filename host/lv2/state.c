/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lv2/instance.h"

#define PLAIN (LV2_STATE_IS_POD | LV2_STATE_IS_PORTABLE)

/* ---- saving --------------------------------------------------------------------------------- */

/* What is not known is not said. */
static LV2_State_Status store_controls(const Instance *instance, const InstrumentSetting *setting,
                                       LV2_State_Store_Function store, LV2_State_Handle state) {
  const Urids *const urids = &instance->urids;
  LV2_State_Status status = LV2_STATE_SUCCESS;
  for (uint32_t i = 0; i < instance->instrument->kind->seen_count; i++) {
    const float *const value = &setting->seen[i];
    if (isnan(*value)) continue;
    status = store(state, urids->controls[i], value, sizeof *value, urids->atom_float, PLAIN);
    if (status != LV2_STATE_SUCCESS) break;
  }
  return status;
}

static LV2_State_Status store_all(const Instance *instance, const InstrumentSetting *setting,
                                  const char *text, LV2_State_Store_Function store,
                                  LV2_State_Handle state) {
  const Urids *const urids = &instance->urids;
  const int32_t version = STATE_VERSION;
  LV2_State_Status status =
    store(state, urids->version, &version, sizeof version, urids->atom_int, PLAIN);
  if (status != LV2_STATE_SUCCESS) return status;
  status = store(state, urids->text, text, strlen(text) + 1, urids->atom_string, PLAIN);
  if (status != LV2_STATE_SUCCESS) return status;
  return store_controls(instance, setting, store, state);
}

/* A kit that is built in is what its ports say. */
static LV2_State_Status save(LV2_Handle handle, LV2_State_Store_Function store,
                             LV2_State_Handle state, uint32_t flags,
                             const LV2_Feature *const *features) {
  (void)flags;
  (void)features;
  Instance *const instance = handle;
  const InstrumentCalls *const calls = instance->instrument->kind->calls;
  InstrumentSetting setting;
  calls->note(instance->instrument, &setting);
  char *const text = calls->text(instance->instrument, &setting);
  if (!text) return instance->plugin->needs_text ? LV2_STATE_ERR_NO_SPACE : LV2_STATE_SUCCESS;
  const LV2_State_Status status = store_all(instance, &setting, text, store, state);
  free(text);
  return status;
}

/* ---- restoring ------------------------------------------------------------------------------ */

/* Where a state is read from. */
typedef struct Source {
  Instance *instance;
  LV2_State_Retrieve_Function retrieve;
  LV2_State_Handle state;
} Source;

static LV2_State_Status refuse(const Source *source, LV2_State_Status status, const char *why) {
  char line[INSTRUMENT_MESSAGE + 32];
  (void)snprintf(line, sizeof line, "the state is not restored: %s", why);
  instance_say(source->instance, line);
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

/* Earlier states of kits have none. */
static LV2_State_Status check_version(const Source *source) {
  const Urids *const urids = &source->instance->urids;
  LV2_State_Status status;
  size_t size = 0;
  int32_t version;
  const void *const value = find(source, urids->version, urids->atom_int, &size, &status);
  if (status == LV2_STATE_ERR_NO_PROPERTY && !source->instance->plugin->needs_text)
    return LV2_STATE_SUCCESS;
  if (!value) return refuse(source, status, "it has no version");
  if (size != sizeof version) return refuse(source, LV2_STATE_ERR_BAD_TYPE, "its version is none");
  memcpy(&version, value, sizeof version);
  if (version == STATE_VERSION) return LV2_STATE_SUCCESS;
  if (version > STATE_VERSION) {
    return refuse(source, LV2_STATE_ERR_UNKNOWN, "it is of a later version of Tabor");
  }
  return refuse(source, LV2_STATE_ERR_UNKNOWN, "its version is not one of Tabor's");
}

static LV2_State_Status read_text(const Source *source, InstrumentSetting *setting) {
  const Urids *const urids = &source->instance->urids;
  Instrument *const instrument = source->instance->instrument;
  char message[INSTRUMENT_MESSAGE];
  LV2_State_Status status;
  size_t size = 0;
  const char *const text = find(source, urids->text, urids->atom_string, &size, &status);
  if (!text) return refuse(source, status, "it has no definition");
  const char *const end = memchr(text, '\0', size);
  const size_t length = end ? (size_t)(end - text) : size;
  if (instrument->kind->calls->read(instrument, text, length, setting, message))
    return LV2_STATE_SUCCESS;
  return refuse(source, LV2_STATE_ERR_UNKNOWN, message);
}

static LV2_State_Status read_control(const Source *source, uint32_t id, float *seen) {
  const Urids *const urids = &source->instance->urids;
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

/* Hosts restore such states, too, as that of a plugin that has no other: then all stays. */
static bool is_empty(const Source *source) {
  const Urids *const urids = &source->instance->urids;
  uint32_t type, flags;
  size_t size;
  return !source->retrieve(source->state, urids->version, &size, &type, &flags) &&
         !source->retrieve(source->state, urids->text, &size, &type, &flags);
}

static LV2_State_Status restore(LV2_Handle handle, LV2_State_Retrieve_Function retrieve,
                                LV2_State_Handle state, uint32_t flags,
                                const LV2_Feature *const *features) {
  (void)flags;
  (void)features;
  Instance *const instance = handle;
  Instrument *const instrument = instance->instrument;
  const Source source = {instance, retrieve, state};
  InstrumentSetting setting;
  if (is_empty(&source)) return LV2_STATE_SUCCESS;
  instrument->kind->calls->blank(instrument, &setting);
  LV2_State_Status status = check_version(&source);
  for (uint32_t i = 0; i < instrument->kind->seen_count && status == LV2_STATE_SUCCESS; i++)
    status = read_control(&source, i, &setting.seen[i]);
  if (status == LV2_STATE_SUCCESS) status = read_text(&source, &setting);
  if (status == LV2_STATE_SUCCESS) instrument->kind->calls->use(instrument, &setting);
  return status;
}

const LV2_State_Interface instance_state = {.save = save, .restore = restore};
