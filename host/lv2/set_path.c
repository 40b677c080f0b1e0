/* SPDX-License-Identifier: MIT */
#include "lv2/set_path.h"

#include <lv2/patch/patch.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

SetPathUrids set_path_urids(LV2_URID_Map *map) {
  return (SetPathUrids){.object = map->map(map->handle, LV2_ATOM__Object),
                        .set = map->map(map->handle, LV2_PATCH__Set),
                        .property = map->map(map->handle, LV2_PATCH__property),
                        .value = map->map(map->handle, LV2_PATCH__value),
                        .path = map->map(map->handle, LV2_ATOM__Path),
                        .urid = map->map(map->handle, LV2_ATOM__URID)};
}

/* What an object says. */
typedef struct Said {
  const LV2_Atom *property, *value; /* or NULL */
} Said;

/* Properties one after another, each padded to 8 bytes. */
static Said read_object(const uint8_t *next, size_t left, const SetPathUrids *urids) REALTIME;
static Said read_object(const uint8_t *next, size_t left, const SetPathUrids *urids) {
  Said said = {NULL, NULL};
  while (left >= sizeof(LV2_Atom_Property_Body)) {
    const LV2_Atom_Property_Body *const body = (const LV2_Atom_Property_Body *)next;
    const size_t size = sizeof *body + body->value.size;
    if (size > left) break;
    if (body->key == urids->property) said.property = &body->value;
    if (body->key == urids->value) said.value = &body->value;
    const size_t step = (size + 7u) & ~(size_t)7u;
    if (step >= left) break;
    next += step;
    left -= step;
  }
  return said;
}

static bool is_urid(const LV2_Atom *atom, LV2_URID type, LV2_URID urid) REALTIME;
static bool is_urid(const LV2_Atom *atom, LV2_URID type, LV2_URID urid) {
  return atom && atom->type == type && atom->size >= sizeof urid &&
         memcmp(atom + 1, &urid, sizeof urid) == 0;
}

const char *set_path_read(const LV2_Atom_Event *event, const SetPathUrids *urids, LV2_URID property,
                          size_t *length) {
  const LV2_Atom_Object_Body *const object = (const LV2_Atom_Object_Body *)(event + 1);
  if (event->body.type != urids->object || event->body.size < sizeof *object) return NULL;
  if (object->otype != urids->set) return NULL;
  const Said said =
    read_object((const uint8_t *)(object + 1), event->body.size - sizeof *object, urids);
  if (!is_urid(said.property, urids->urid, property)) return NULL;
  if (!said.value || said.value->type != urids->path) return NULL;
  const char *const path = (const char *)(said.value + 1);
  const char *const end = memchr(path, '\0', said.value->size);
  *length = end ? (size_t)(end - path) : said.value->size;
  return path;
}
