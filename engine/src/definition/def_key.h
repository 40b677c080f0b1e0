/* SPDX-License-Identifier: MIT */
/**
 * @file def_key.h
 * Full keys such as "batter.tension", "wire.3.length" and "mic.top.gain".
 */
#ifndef TABOR_SRC_KEY_H
#define TABOR_SRC_KEY_H

#include "definition/params.h"

/** Bytes that every full key fits into, with its terminator. */
#define TB_DEF_KEY_SIZE 128

typedef enum TbKeyStatus {
  TB_DEF_KEY_OK,
  TB_DEF_KEY_UNKNOWN,   /**< no such section, or no such key in it */
  TB_DEF_KEY_BAD_NAME,  /**< not a valid name of a striker or microphone */
  TB_DEF_KEY_BAD_NUMBER /**< the wire's number is not in 1 to 40 */
} TbKeyStatus;

/** The parts of a full key. */
typedef struct TbKey {
  const TbParam *param;
  char name[TABOR_NAME_SIZE]; /**< name of the striker or microphone, "" otherwise */
  uint32_t wire;              /**< index of the wire, from 0; 0 otherwise */
} TbKey;

TbKeyStatus tb_def_key_parse(const char *text, TbKey *key);

/** Parses a section alone, such as "batter", "wire.3" and "mic.top". param becomes one of its rows
 * of the table. */
TbKeyStatus tb_section_parse(const char *text, TbKey *key);

/** Number of elements of @p group in @p def, never more than its arrays hold. All wires count;
 * resonant heads are 0 or 1. */
uint32_t tb_group_count(const TaborDrumDef *def, TbGroup group);

/** The name of a striker or microphone, always terminated, "" for the other groups. */
void tb_element_name(const TaborDrumDef *def, TbGroup group, uint32_t element,
                     char name[TABOR_NAME_SIZE]);

/** Index of the striker or microphone called @p name, or -1. */
int tb_element_find(const TaborDrumDef *def, TbGroup group, const char *name);

/** Writes the full key of @p param in element @p element. */
void tb_def_key_write(const TaborDrumDef *def, const TbParam *param, uint32_t element,
                      char text[TB_DEF_KEY_SIZE]);

/** Called for a field. Returning false ends the walk. */
typedef bool TbVisit(void *context, const TbParam *param, uint32_t element);

/**
 * Visits every field of @p def in preset order: section after section, element after element.
 * Returns false if a visit returned false.
 */
bool tb_walk(const TaborDrumDef *def, TbVisit *visit, void *context);

/** Called for a full key. Returning false ends the walk. */
typedef bool TbKeyVisit(void *context, const char *key);

/** Visits the keys of tabor_drum_def_key(), in order. Returns false if a visit returned false. */
bool tb_def_walk_keys(const TaborDrumDef *def, TbKeyVisit *visit, void *context);

/** The walk to key number `left`, which goes to `key`. */
typedef struct TbKeySearch {
  uint32_t left;
  char *key;
  size_t size; /**< bytes of key */
  bool fits;   /**< it was found and fits */
} TbKeySearch;

/** A TbKeyVisit, whose context is a TbKeySearch. */
bool tb_count_key(void *context, const char *key);

/** Writes the existing or possible full key nearest to @p text, "" if none is near. */
void tb_def_key_nearest(const TaborDrumDef *def, const char *text, char nearest[TB_DEF_KEY_SIZE]);

/** Writes the section nearest to @p text, "" if none is near. */
void tb_section_nearest(const char *text, char nearest[TB_DEF_KEY_SIZE]);

#endif /* TABOR_SRC_KEY_H */
