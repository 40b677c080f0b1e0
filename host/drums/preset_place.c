/* SPDX-License-Identifier: MIT */
#include "drums/preset_place.h"

#include <string.h>

#include "tabor/tabor.h"

int preset_place(const char *name) {
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    if (strcmp(tabor_preset(i)->name, name) == 0) return (int)i;
  }
  return -1;
}
