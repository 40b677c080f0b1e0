/* SPDX-License-Identifier: MIT */
#include "tabor/tabor.h"

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

const char *tabor_version(void) {
  return TEXT(TABOR_VERSION_MAJOR) "." TEXT(TABOR_VERSION_MINOR) "." TEXT(TABOR_VERSION_PATCH)
    TABOR_VERSION_SUFFIX;
}
