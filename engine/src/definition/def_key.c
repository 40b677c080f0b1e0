/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* strnlen */
#include "definition/def_key.h"
#include "definition/def_text.h"

#include <stdio.h>
#include <string.h>

/* The middle of "section.middle.key" once "section." matched; NULL if there is none. */
static const char *middle_end(const char *middle) {
  const char *const end = strrchr(middle, '.');
  return end && end > middle ? end : NULL;
}

static bool matches(const TbParam *param, const char *text) {
  const size_t length = strlen(param->info.section);
  if (strncmp(text, param->info.section, length) != 0) return false;
  text += length;
  if (!tb_group_is_array(param->group)) {
    return *text == '.' && strcmp(text + 1, param->info.key) == 0;
  }
  const char *const end = middle_end(text);
  return end && strcmp(end + 1, param->info.key) == 0;
}

static const TbParam *find_row(const char *text) {
  for (uint32_t i = 0; i < tb_param_count; i++) {
    if (matches(&tb_params[i], text)) return &tb_params[i];
  }
  return NULL;
}

/* "1" to "40", without leading zeros: one wire has one key. */
static bool parse_wire(const char *name, uint32_t *wire) {
  uint32_t number;
  if (*name == '0' || tb_whole_parse(name, &number) != TB_PARSE_OK) return false;
  if (number < 1 || number > TABOR_MAX_WIRES) return false;
  *wire = number - 1;
  return true;
}

/* The name or number of the element, once key->param is known. */
static TbKeyStatus parse_element(const char *text, size_t length, TbKey *key) {
  const bool is_wire = key->param->group == TB_GROUP_WIRE;
  const TbKeyStatus bad = is_wire ? TB_DEF_KEY_BAD_NUMBER : TB_DEF_KEY_BAD_NAME;
  char name[TABOR_NAME_SIZE] = "";
  if (length > TABOR_NAME_LENGTH) return bad;
  memcpy(name, text, length);
  if (is_wire) return parse_wire(name, &key->wire) ? TB_DEF_KEY_OK : bad;
  if (!tb_name_is_valid(name, sizeof name)) return bad;
  memcpy(key->name, name, sizeof name);
  return TB_DEF_KEY_OK;
}

TbKeyStatus tb_def_key_parse(const char *text, TbKey *key) {
  memset(key, 0, sizeof *key);
  key->param = find_row(text);
  if (!key->param) return TB_DEF_KEY_UNKNOWN;
  if (!tb_group_is_array(key->param->group)) return TB_DEF_KEY_OK;

  const char *const middle = text + strlen(key->param->info.section);
  return parse_element(middle, (size_t)(middle_end(middle) - middle), key);
}

static bool matches_section(const TbParam *param, const char *text) {
  const char *const section = param->info.section;
  if (!tb_group_is_array(param->group)) return strcmp(text, section) == 0;
  return strncmp(text, section, strlen(section)) == 0; /* it ends with the dot */
}

TbKeyStatus tb_section_parse(const char *text, TbKey *key) {
  memset(key, 0, sizeof *key);
  for (uint32_t i = 0; i < tb_param_count && !key->param; i++) {
    if (matches_section(&tb_params[i], text)) key->param = &tb_params[i];
  }
  if (!key->param) return TB_DEF_KEY_UNKNOWN;
  if (!tb_group_is_array(key->param->group)) return TB_DEF_KEY_OK;
  const char *const name = text + strlen(key->param->info.section);
  return parse_element(name, strlen(name), key);
}

const TaborParameter *tabor_parameter_find(const char *key) {
  TbKey parsed;
  return key && tb_def_key_parse(key, &parsed) == TB_DEF_KEY_OK ? &parsed.param->info : NULL;
}

uint32_t tb_group_count(const TaborDrumDef *def, TbGroup group) {
  const uint32_t capacity = tb_group_capacity(group);
  uint32_t count = capacity;
  if (group == TB_GROUP_RESONANT) count = def->two_headed;
  if (group == TB_GROUP_PLATE) count = def->body.kind != TABOR_BODY_DRUM;
  if (group == TB_GROUP_HIHAT) count = def->body.kind == TABOR_BODY_HIHAT;
  if (group == TB_GROUP_STRIKER) count = def->striker_count;
  if (group == TB_GROUP_MIC) count = def->mic_count;
  return count < capacity ? count : capacity;
}

void tb_element_name(const TaborDrumDef *def, TbGroup group, uint32_t element,
                     char name[TABOR_NAME_SIZE]) {
  memset(name, 0, TABOR_NAME_SIZE);
  const char *from = NULL;
  if (group == TB_GROUP_STRIKER) from = def->striker[element].name;
  if (group == TB_GROUP_MIC) from = def->mic[element].name;
  if (from) memcpy(name, from, strnlen(from, TABOR_NAME_SIZE - 1));
}

int tb_element_find(const TaborDrumDef *def, TbGroup group, const char *name) {
  const uint32_t count = tb_group_count(def, group);
  for (uint32_t i = 0; i < count; i++) {
    char candidate[TABOR_NAME_SIZE];
    tb_element_name(def, group, i, candidate);
    if (strcmp(candidate, name) == 0) return (int)i;
  }
  return -1;
}

static void write_key(const TbParam *param, const char *name, char text[TB_DEF_KEY_SIZE]) {
  (void)snprintf(text, TB_DEF_KEY_SIZE, "%s%s.%s", param->info.section, name, param->info.key);
}

void tb_def_key_write(const TaborDrumDef *def, const TbParam *param, uint32_t element,
                      char text[TB_DEF_KEY_SIZE]) {
  char name[TABOR_NAME_SIZE];
  tb_element_name(def, param->group, element, name);
  if (param->group == TB_GROUP_WIRE) (void)snprintf(name, sizeof name, "%u", element + 1u);
  write_key(param, name, text);
}

static uint32_t section_end(uint32_t row) {
  const char *const section = tb_params[row].info.section;
  while (row < tb_param_count && strcmp(tb_params[row].info.section, section) == 0) row++;
  return row;
}

static bool walk_element(uint32_t row, uint32_t end, uint32_t element, TbVisit *visit,
                         void *context) {
  for (; row < end; row++) {
    if (!visit(context, &tb_params[row], element)) return false;
  }
  return true;
}

bool tb_walk(const TaborDrumDef *def, TbVisit *visit, void *context) {
  for (uint32_t row = 0, end; row < tb_param_count; row = end) {
    end = section_end(row);
    const uint32_t elements = tb_group_count(def, tb_params[row].group);
    for (uint32_t element = 0; element < elements; element++) {
      if (!walk_element(row, end, element, visit, context)) return false;
    }
  }
  return true;
}

/* The search for the nearest key. */
typedef struct Search {
  const TaborDrumDef *def;
  const char *wanted;
  bool bare; /* no section was given: compare the last part alone */
  char *nearest;
  size_t distance;
} Search;

static void consider(Search *search, const TbParam *param, const char *candidate) {
  const char *const compared = search->bare ? param->info.key : candidate;
  if (!tb_word_is_nearer(search->wanted, compared, &search->distance)) return;
  (void)snprintf(search->nearest, TB_DEF_KEY_SIZE, "%s", candidate);
}

static bool consider_field(void *context, const TbParam *param, uint32_t element) {
  Search *const search = context;
  char candidate[TB_DEF_KEY_SIZE];
  tb_def_key_write(search->def, param, element, candidate);
  consider(search, param, candidate);
  return true;
}

/* Keys that would give a definition what it has not got: a second head, a plate,
 * another plate. */
static void consider_absent(Search *search) {
  for (uint32_t i = 0; i < tb_param_count; i++) {
    const TbGroup group = tb_params[i].group;
    const bool absent = !tb_group_is_array(group) && tb_group_count(search->def, group) == 0;
    if (absent) (void)consider_field(search, &tb_params[i], 0);
  }
}

/* Keys of strikers and microphones that the definition has not got: their name is the user's. */
static void consider_new_names(Search *search) {
  const char *const first = strchr(search->wanted, '.'), *const last = strrchr(search->wanted, '.');
  if (!first || last - first < 2 || last - first > TABOR_NAME_LENGTH + 1) return;
  char name[TABOR_NAME_SIZE] = "", candidate[TB_DEF_KEY_SIZE];
  memcpy(name, first + 1, (size_t)(last - first - 1));
  if (!tb_name_is_valid(name, sizeof name)) return;
  for (uint32_t i = 0; i < tb_param_count; i++) {
    const TbParam *const param = &tb_params[i];
    if (param->group != TB_GROUP_STRIKER && param->group != TB_GROUP_MIC) continue;
    write_key(param, name, candidate);
    consider(search, param, candidate);
  }
}

void tb_def_key_nearest(const TaborDrumDef *def, const char *text, char nearest[TB_DEF_KEY_SIZE]) {
  Search search = {def, text, strchr(text, '.') == NULL, nearest, SIZE_MAX};
  nearest[0] = '\0';
  (void)tb_walk(def, consider_field, &search);
  if (search.bare) return;
  consider_absent(&search);
  consider_new_names(&search);
}

/* The name of a section in a message: an element's name is @p element or, if that is NULL, left
 * to the user. */
static void write_section(const TbParam *param, const char *element, char text[TB_DEF_KEY_SIZE]) {
  const bool is_array = tb_group_is_array(param->group);
  if (!element) element = param->group == TB_GROUP_WIRE ? "N" : "NAME";
  (void)snprintf(text, TB_DEF_KEY_SIZE, "%s%s", param->info.section, is_array ? element : "");
}

/* The text up to the first dot, dot included, is compared if elements have names. */
void tb_section_nearest(const char *text, char nearest[TB_DEF_KEY_SIZE]) {
  const char *const dot = strchr(text, '.');
  char family[TABOR_NAME_SIZE] = "";
  if (dot && dot - text < TABOR_NAME_SIZE - 1) memcpy(family, text, (size_t)(dot - text) + 1);
  size_t smallest = SIZE_MAX;
  nearest[0] = '\0';
  for (uint32_t row = 0; row < tb_param_count; row = section_end(row)) {
    const TbParam *const param = &tb_params[row];
    const char *const word = dot && tb_group_is_array(param->group) ? family : text;
    if (!tb_word_is_nearer(word, param->info.section, &smallest)) continue;
    write_section(param, dot && tb_name_is_valid(dot + 1, TABOR_NAME_SIZE) ? dot + 1 : NULL,
                  nearest);
  }
}
