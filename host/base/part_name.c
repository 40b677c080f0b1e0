/* SPDX-License-Identifier: MIT */
#include "base/part_name.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/paths.h"

char *part_name(const char *target, unsigned number) {
  const char *const base = path_base(target), *const dot = strrchr(base, '.');
  const size_t stem = dot && dot > base ? (size_t)(dot - target) : strlen(target);
  const size_t size = strlen(target) + sizeof ".part-4294967295";
  char *const name = malloc(size), count[16] = "";
  if (number > 1) (void)snprintf(count, sizeof count, "-%u", number);
  if (name) (void)snprintf(name, size, "%.*s.part%s%s", (int)stem, target, count, target + stem);
  return name;
}
