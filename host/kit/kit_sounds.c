/* SPDX-License-Identifier: MIT */
#include "kit/kit_sounds.h"

#include <stdlib.h>

static TaborStatus load(TaborKit *kit, uint32_t note, KitSoundFn *read, void *context,
                        TaborError *error) {
  KitSound sound = {{NULL, NULL}, 0, 0};
  const char *const name = tabor_kit_definition(kit)->note[note].sample;
  TaborStatus status = read(context, name, &sound) ? TABOR_OK : TABOR_ERROR_CANCELLED;
  if (status == TABOR_OK && sound.side[0]) {
    status = tabor_kit_set_sample(kit, note, sound.side[0], sound.side[1], sound.frames, sound.rate,
                                  error);
  }
  free(sound.side[0]);
  free(sound.side[1]);
  return status;
}

TaborStatus kit_samples_load(TaborKit *kit, KitSoundFn *read, void *context, TaborError *error) {
  TaborStatus status = TABOR_OK;
  for (uint32_t note = 0; note < TABOR_KIT_NOTES && status == TABOR_OK; note++) {
    if (tabor_kit_definition(kit)->note[note].sample[0]) {
      status = load(kit, note, read, context, error);
    }
  }
  return status;
}
