/* SPDX-License-Identifier: MIT */
#include "definition/def_value.h"
#include "definition/def_text.h"
#include "definition/error.h"
#include "definition/note.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Word @p index of "a|b|c", false past the last. */
static bool choice_word(const char *choices, uint32_t index, char word[TABOR_NAME_SIZE]) {
  for (; index > 0; index--) {
    choices = strchr(choices, '|');
    if (!choices) return false;
    choices++;
  }
  const size_t length = strcspn(choices, "|");
  memcpy(word, choices, length);
  word[length] = '\0';
  return true;
}

static bool choice_index(const char *choices, const char *wanted, uint32_t *index) {
  char word[TABOR_NAME_SIZE];
  for (*index = 0; choice_word(choices, *index, word); (*index)++) {
    if (strcmp(word, wanted) == 0) return true;
  }
  return false;
}

/* "a|b|c" as "a, b, c" */
static void list_choices(const char *choices, char text[TABOR_TEXT_SIZE]) {
  size_t length = 0;
  for (; *choices && length + 3 < TABOR_TEXT_SIZE; choices++) {
    if (*choices == '|') {
      text[length++] = ',';
      text[length++] = ' ';
    } else {
      text[length++] = *choices;
    }
  }
  text[length] = '\0';
}

TbValue tb_def_value_default(const TbParam *param) {
  TbValue value = {.number = param->info.fallback, .text = ""};
  if (param->info.type == TABOR_TYPE_WHOLE || param->info.type == TABOR_TYPE_CHOICE) {
    value.whole = (uint32_t)param->info.fallback + param->base;
  }
  return value;
}

TbValue tb_def_value_load(const TbParam *param, const void *field) {
  TbValue value = {.text = ""};
  switch (param->info.type) {
  case TABOR_TYPE_NUMBER: memcpy(&value.number, field, sizeof value.number); break;
  case TABOR_TYPE_WHOLE:
  case TABOR_TYPE_CHOICE: memcpy(&value.whole, field, sizeof value.whole); break;
  case TABOR_TYPE_TEXT: value.text = field; break;
  }
  return value;
}

void tb_def_value_store(const TbParam *param, void *field, const TbValue *value) {
  switch (param->info.type) {
  case TABOR_TYPE_NUMBER: memcpy(field, &value->number, sizeof value->number); break;
  case TABOR_TYPE_WHOLE:
  case TABOR_TYPE_CHOICE: memcpy(field, &value->whole, sizeof value->whole); break;
  case TABOR_TYPE_TEXT: {
    const size_t length = strlen(value->text); /* the text may lie in the field itself */
    memmove(field, value->text, length);
    memset((char *)field + length, 0, param->size - length);
    break;
  }
  }
}

/* A number that may be left unset. */
static bool can_follow(const TbParam *param) {
  return param->info.type == TABOR_TYPE_NUMBER && isnan(param->info.fallback);
}

bool tb_def_value_follows(const TbParam *param, const TbValue *value) {
  return can_follow(param) && isnan(value->number);
}

/* " m" after a number; nothing for a pure number. */
static void write_unit(const TbParam *param, char text[TABOR_NAME_SIZE]) {
  (void)snprintf(text, TABOR_NAME_SIZE, "%s%s", *param->info.unit ? " " : "", param->info.unit);
}

static TaborStatus refuse_range(const TbParam *param, const char *key, const char *text,
                                TaborError *error) {
  const double low = param->info.minimum, high = param->info.maximum;
  char unit[TABOR_NAME_SIZE];
  write_unit(param, unit);
  if (param->zero) {
    return tb_error_set(error, TABOR_ERROR_RANGE, key, text, low, high,
                        "%s = %s is neither 0 nor in %g to %g%s", key, text, param->least, high,
                        unit);
  }
  if (param->least > 0) {
    return tb_error_set(error, TABOR_ERROR_RANGE, key, text, low, high,
                        "%s = %s is outside %g to %g%s or within %g%s of 0", key, text, low, high,
                        unit, param->least, unit);
  }
  return tb_error_set(error, TABOR_ERROR_RANGE, key, text, low, high,
                      "%s = %s is outside %g to %g%s", key, text, low, high, unit);
}

static TaborStatus refuse_choice(const TbParam *param, TaborStatus status, const char *key,
                                 const char *text, TaborError *error) {
  char list[TABOR_TEXT_SIZE];
  list_choices(param->info.choices, list);
  return tb_error_set(error, status, key, text, NAN, NAN, "%s = '%s' is none of: %s", key, text,
                      list);
}

static TaborStatus refuse_text(const char *key, const char *text, const char *reason,
                               TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_VALUE, key, text, NAN, NAN, "%s: %s", key, reason);
}

static bool in_range(const TbParam *param, double value) {
  if (!(value >= param->info.minimum && value <= param->info.maximum)) return false; /* or NaN */
  return fabs(value) >= param->least || (param->zero && value == 0);
}

static TaborStatus check_number(const TbParam *param, const char *key, double number,
                                TaborError *error) {
  if (in_range(param, number)) return TABOR_OK;
  char text[TB_NUMBER_SIZE];
  tb_number_print(number, text);
  return refuse_range(param, key, text, error);
}

static TaborStatus check_text(const TbParam *param, const char *key, const char *text,
                              TaborError *error) {
  if (!memchr(text, '\0', param->size)) {
    return tb_error_set(error, TABOR_ERROR_VALUE, key, NULL, NAN, NAN,
                        "%s: the text is longer than %zu bytes", key, param->size - 1);
  }
  if (!tb_text_is_valid(text, param->size)) {
    return refuse_text(key, text, "the text holds control characters or is not UTF-8", error);
  }
  if (param->identifier && *text && !tb_name_is_valid(text, param->size)) {
    return refuse_text(key, text, "a name has letters, digits, '-' and '_' only", error);
  }
  return TABOR_OK;
}

static TaborStatus check_choice(const TbParam *param, const char *key, uint32_t stored,
                                TaborError *error) {
  char word[TABOR_NAME_SIZE];
  if (stored >= param->base && choice_word(param->info.choices, stored - param->base, word)) {
    return TABOR_OK;
  }
  (void)snprintf(word, sizeof word, "%lu", (unsigned long)stored);
  return refuse_choice(param, TABOR_ERROR_RANGE, key, word, error);
}

TaborStatus tb_def_value_check(const TbParam *param, const char *key, const TbValue *value,
                               TaborError *error) {
  switch (param->info.type) {
  case TABOR_TYPE_NUMBER:
    if (tb_def_value_follows(param, value)) return TABOR_OK;
    return check_number(param, key, value->number, error);
  case TABOR_TYPE_WHOLE: return check_number(param, key, value->whole, error);
  case TABOR_TYPE_CHOICE: return check_choice(param, key, value->whole, error);
  case TABOR_TYPE_TEXT: break;
  }
  return check_text(param, key, value->text, error);
}

static TaborStatus parse_number(const TbParam *param, const char *key, const char *text,
                                TbValue *value, TaborError *error) {
  if (can_follow(param) && !*text) {
    value->number = NAN;
    return TABOR_OK;
  }
  if (param->note && tb_note_parse(text, &value->number)) {
    return tb_def_value_check(param, key, value, error);
  }
  const TbParse parse = tb_number_parse(text, &value->number);
  if (parse == TB_PARSE_OVERFLOW) return refuse_range(param, key, text, error);
  if (parse == TB_PARSE_OK) return tb_def_value_check(param, key, value, error);
  char unit[TABOR_NAME_SIZE];
  write_unit(param, unit);
  return tb_error_set(error, TABOR_ERROR_VALUE, key, text, param->info.minimum, param->info.maximum,
                      param->note
                        ? "%s = '%s' is neither a number from %g to %g%s nor a note such as Eb2+30"
                        : "%s = '%s' is not a number from %g to %g%s",
                      key, text, param->info.minimum, param->info.maximum, unit);
}

static TaborStatus parse_whole(const TbParam *param, const char *key, const char *text,
                               TbValue *value, TaborError *error) {
  const TbParse parse = tb_whole_parse(text, &value->whole);
  if (parse == TB_PARSE_OVERFLOW) return refuse_range(param, key, text, error);
  if (parse == TB_PARSE_OK) return tb_def_value_check(param, key, value, error);
  return tb_error_set(error, TABOR_ERROR_VALUE, key, text, param->info.minimum, param->info.maximum,
                      "%s = '%s' is not a whole number from %g to %g", key, text,
                      param->info.minimum, param->info.maximum);
}

static TaborStatus parse_choice(const TbParam *param, const char *key, const char *text,
                                TbValue *value, TaborError *error) {
  uint32_t index;
  if (!choice_index(param->info.choices, text, &index)) {
    return refuse_choice(param, TABOR_ERROR_VALUE, key, text, error);
  }
  value->whole = index + param->base;
  return TABOR_OK;
}

TaborStatus tb_def_value_parse(const TbParam *param, const char *key, const char *text,
                               TbValue *value, TaborError *error) {
  *value = (TbValue){.text = text};
  switch (param->info.type) {
  case TABOR_TYPE_NUMBER: return parse_number(param, key, text, value, error);
  case TABOR_TYPE_WHOLE: return parse_whole(param, key, text, value, error);
  case TABOR_TYPE_CHOICE: return parse_choice(param, key, text, value, error);
  case TABOR_TYPE_TEXT: break;
  }
  return check_text(param, key, text, error);
}

bool tb_def_value_print(const TbParam *param, const TbValue *value, char *text, size_t size) {
  char number[TB_NUMBER_SIZE], word[TABOR_NAME_SIZE];
  const char *from = value->text;
  switch (param->info.type) {
  case TABOR_TYPE_NUMBER:
    tb_number_print(value->number, number);
    from = tb_def_value_follows(param, value) ? "" : number;
    break;
  case TABOR_TYPE_WHOLE:
    (void)snprintf(number, sizeof number, "%lu", (unsigned long)value->whole);
    from = number;
    break;
  case TABOR_TYPE_CHOICE:
    if (value->whole < param->base) return false;
    if (!choice_word(param->info.choices, value->whole - param->base, word)) return false;
    from = word;
    break;
  case TABOR_TYPE_TEXT:
    if (!memchr(from, '\0', param->size)) return false;
    break;
  }
  const size_t bytes = strlen(from) + 1;
  if (bytes > size) return false;
  memcpy(text, from, bytes);
  return true;
}
