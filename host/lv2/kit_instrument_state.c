/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lv2/kit_instrument.h"

#define PLAIN (LV2_STATE_IS_POD | LV2_STATE_IS_PORTABLE)

/* Without a kit of the user's there is nothing to say. */
static LV2_State_Status save(LV2_Handle handle, LV2_State_Store_Function store,
                             LV2_State_Handle state, uint32_t flags,
                             const LV2_Feature *const *features) {
  (void)flags;
  (void)features;
  KitInstrument *const kit = handle;
  if (own_kit_version(&kit->own) == 0) return LV2_STATE_SUCCESS;
  char *const text = own_kit_text(&kit->own);
  if (!text) return LV2_STATE_ERR_NO_SPACE;
  const LV2_State_Status status =
    store(state, kit->state, text, strlen(text) + 1, kit->atom_string, PLAIN);
  free(text);
  return status;
}

static LV2_State_Status refuse(KitInstrument *kit, LV2_State_Status status, const char *why) {
  char line[2 * TABOR_TEXT_SIZE];
  (void)snprintf(line, sizeof line, "the state is not restored: %s", why);
  kit_instrument_say(kit, line);
  return status;
}

static LV2_State_Status restore(LV2_Handle handle, LV2_State_Retrieve_Function retrieve,
                                LV2_State_Handle state, uint32_t flags,
                                const LV2_Feature *const *features) {
  (void)features;
  KitInstrument *const kit = handle;
  char message[TABOR_TEXT_SIZE];
  uint32_t type = 0;
  size_t size = 0;
  const char *const text = retrieve(state, kit->state, &size, &type, &flags);
  if (!text) return LV2_STATE_SUCCESS;
  if (type != kit->atom_string) {
    return refuse(kit, LV2_STATE_ERR_BAD_TYPE, "its kit file is no text");
  }
  const char *const end = memchr(text, '\0', size);
  const size_t length = end ? (size_t)(end - text) : size;
  if (own_kit_set(&kit->own, text, length, message, sizeof message)) return LV2_STATE_SUCCESS;
  return refuse(kit, LV2_STATE_ERR_UNKNOWN, message);
}

const LV2_State_Interface kit_instrument_state = {.save = save, .restore = restore};
