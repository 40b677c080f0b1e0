/* SPDX-License-Identifier: MIT */
/**
 * @file def_value.h
 * One parameter's value: conversion from and to text, and checks against the parameter's row of the
 * table.
 */
#ifndef TABOR_SRC_VALUE_H
#define TABOR_SRC_VALUE_H

#include "definition/params.h"

/** A value of any type. Only the member for the row's type is used. */
typedef struct TbValue {
  double number;
  uint32_t whole;   /**< whole numbers and choices, as stored */
  const char *text; /**< points at the source, which may lack a terminator until checked */
} TbValue;

/** The default of @p param; texts are empty. */
TbValue tb_def_value_default(const TbParam *param);

/** Reads and writes a field. A text must have been checked before it is stored. */
TbValue tb_def_value_load(const TbParam *param, const void *field);
void tb_def_value_store(const TbParam *param, void *field, const TbValue *value);

/** True for an unset value: a wire's value that follows [wires], or a lug's that is drawn at
 * random. */
bool tb_def_value_follows(const TbParam *param, const TbValue *value);

/** Reads and checks @p text. "" is allowed for a wire's own value. @p key is used in the
 * message. */
TaborStatus tb_def_value_parse(const TbParam *param, const char *key, const char *text,
                               TbValue *value, TaborError *error);

/** Checks a value of any origin against the table. */
TaborStatus tb_def_value_check(const TbParam *param, const char *key, const TbValue *value,
                               TaborError *error);

/** Writes a checked value as text; false if it does not fit. */
bool tb_def_value_print(const TbParam *param, const TbValue *value, char *text, size_t size);

#endif /* TABOR_SRC_VALUE_H */
