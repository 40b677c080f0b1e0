/* SPDX-License-Identifier: MIT */
/**
 * @file def_value.h
 * One parameter's value: from text, to text, against its row of the table.
 */
#ifndef TABOR_SRC_VALUE_H
#define TABOR_SRC_VALUE_H

#include "definition/params.h"

/** A value of any type; only the member of the row's type counts. */
typedef struct TbValue {
  double number;
  uint32_t whole;   /**< whole numbers and choices, as stored */
  const char *text; /**< points at the source, which may lack its terminator until checked */
} TbValue;

/** The default of @p param; texts are empty. */
TbValue tb_def_value_default(const TbParam *param);

/** Reads and writes a field. A text that is stored must have been checked. */
TbValue tb_def_value_load(const TbParam *param, const void *field);
void tb_def_value_store(const TbParam *param, void *field, const TbValue *value);

/** True for an unset value: a wire's that follows [wires], a lug's that is as drawn. */
bool tb_def_value_follows(const TbParam *param, const TbValue *value);

/** Reads @p text, an own value of a wire also from "", and checks it. @p key is for the message. */
TaborStatus tb_def_value_parse(const TbParam *param, const char *key, const char *text,
                               TbValue *value, TaborError *error);

/** Checks a value of any origin against the table. */
TaborStatus tb_def_value_check(const TbParam *param, const char *key, const TbValue *value,
                               TaborError *error);

/** Writes a checked value as text; false if it does not fit. */
bool tb_def_value_print(const TbParam *param, const TbValue *value, char *text, size_t size);

#endif /* TABOR_SRC_VALUE_H */
