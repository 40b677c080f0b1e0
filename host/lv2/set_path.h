/* SPDX-License-Identifier: MIT */
/**
 * @file set_path.h
 * Reads the message by which a host gives a property a file: a patch:Set of an atom:Path. It may be
 * malformed; nothing beyond its end is read.
 */
#ifndef TABOR_LV2_SET_PATH_H
#define TABOR_LV2_SET_PATH_H

#include <lv2/atom/atom.h>
#include <lv2/urid/urid.h>
#include <stddef.h>

#include "base/realtime.h"

typedef struct SetPathUrids {
  LV2_URID object, set, property, value, path, urid;
} SetPathUrids;

/** SET-UP. */
SetPathUrids set_path_urids(LV2_URID_Map *map);
/** AUDIO. The path that @p event gives @p property, of *length bytes, not terminated; NULL if it
 * gives none. */
const char *set_path_read(const LV2_Atom_Event *event, const SetPathUrids *urids, LV2_URID property,
                          size_t *length) REALTIME;

#endif
