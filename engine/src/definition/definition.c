/* SPDX-License-Identifier: MIT */
#include "definition/definition.h"
#include "definition/def_key.h"
#include "definition/def_text.h"
#include "definition/def_value.h"
#include "definition/error.h"
#include "math/draw.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Sets the fields of one element of a group to their defaults. */
static void set_defaults(TaborDrumDef *def, TbGroup group, uint32_t element) {
  for (uint32_t i = 0; i < tb_param_count; i++) {
    const TbParam *const param = &tb_params[i];
    if (param->group != group) continue;
    const TbValue value = tb_def_value_default(param);
    tb_def_value_store(param, tb_param_field(param, def, element), &value);
  }
}

/* Takes the next element of a group that has room. @p name is valid. */
static uint32_t add_element(TaborDrumDef *def, TbGroup group, const char *name) {
  if (group == TB_GROUP_RESONANT) {
    def->two_headed = 1;
    set_defaults(def, group, 0);
    return 0;
  }
  if (group == TB_GROUP_PLATE || group == TB_GROUP_HIHAT) {
    def->body.kind = group == TB_GROUP_PLATE ? TABOR_BODY_PLATE : TABOR_BODY_HIHAT;
    return 0;
  }
  const bool is_mic = group == TB_GROUP_MIC;
  uint32_t *const count = is_mic ? &def->mic_count : &def->striker_count;
  const uint32_t element = (*count)++;
  char *const to = is_mic ? def->mic[element].name : def->striker[element].name;
  memset(to, 0, TABOR_NAME_SIZE);
  memcpy(to, name, strlen(name));
  set_defaults(def, group, element);
  return element;
}

void tabor_drum_def_clear(TaborDrumDef *def) {
  if (!def) return;
  memset(def, 0, sizeof *def); /* padding too: equal definitions are equal bytes */
  def->struct_size = (uint32_t)sizeof *def;
  set_defaults(def, TB_GROUP_SINGLE, 0);
  set_defaults(def, TB_GROUP_RESONANT, 0); /* for who sets two_headed by hand */
  set_defaults(def, TB_GROUP_PLATE, 0);
  set_defaults(def, TB_GROUP_HIHAT, 0);
  for (uint32_t i = 0; i < TABOR_MAX_WIRES; i++) set_defaults(def, TB_GROUP_WIRE, i);
}

void tabor_drum_def_default(TaborDrumDef *def) {
  if (!def) return;
  tabor_drum_def_clear(def);
  (void)add_element(def, TB_GROUP_STRIKER, "stick");
  (void)add_element(def, TB_GROUP_MIC, "top");
}

static const char *group_word(TbGroup group) {
  return group == TB_GROUP_MIC ? "microphone" : "striker";
}

TaborStatus tb_check_struct(const TaborDrumDef *def, TaborError *error) {
  if (!def) return tb_error_null(error, "definition");
  if (def->struct_size != sizeof *def) {
    return tb_error_set(error, TABOR_ERROR_ARGUMENT, NULL, NULL, NAN, NAN,
                        "the definition's struct_size %u is not that of this library, %zu",
                        (unsigned)def->struct_size, sizeof *def);
  }
  return TABOR_OK;
}

static TaborStatus check_arguments(const TaborDrumDef *def, const char *key, const char *text,
                                   TaborError *error) {
  const TaborStatus status = tb_check_struct(def, error);
  if (status != TABOR_OK || (key && text)) return status;
  return tb_error_set(error, TABOR_ERROR_ARGUMENT, key, NULL, NAN, NAN, "the %s is NULL",
                      key ? "text" : "key");
}

/* A key or section @p text, as @p what says, whose element has a name or number that is none. */
static TaborStatus refuse_element(TbKeyStatus status, const char *what, const char *text,
                                  TaborError *error) {
  if (status == TB_DEF_KEY_BAD_NUMBER) {
    return tb_error_set(error, TABOR_ERROR_KEY, text, NULL, 1, TABOR_MAX_WIRES,
                        "unknown %s '%s': wires are numbered 1 to %d", what, text, TABOR_MAX_WIRES);
  }
  return tb_error_set(error, TABOR_ERROR_KEY, text, NULL, NAN, NAN,
                      "unknown %s '%s': a name has 1 to %d letters, digits, '-' and '_'", what,
                      text, TABOR_NAME_LENGTH);
}

static TaborStatus refuse_unknown(const char *what, const char *text, const char *nearest,
                                  TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_KEY, text, NULL, NAN, NAN, "unknown %s '%s'%s%s%s", what,
                      text, *nearest ? "; did you mean '" : "", nearest, *nearest ? "'?" : "");
}

static TaborStatus parse_key(const TaborDrumDef *def, const char *text, TbKey *key,
                             TaborError *error) {
  const TbKeyStatus status = tb_def_key_parse(text, key);
  if (status == TB_DEF_KEY_OK) return TABOR_OK;
  if (status != TB_DEF_KEY_UNKNOWN) return refuse_element(status, "key", text, error);
  char nearest[TB_DEF_KEY_SIZE];
  tb_def_key_nearest(def, text, nearest);
  return refuse_unknown("key", text, nearest, error);
}

static TaborStatus parse_section(const char *text, TbKey *key, TaborError *error) {
  const TbKeyStatus status = tb_section_parse(text, key);
  if (status == TB_DEF_KEY_OK) return TABOR_OK;
  if (status != TB_DEF_KEY_UNKNOWN) return refuse_element(status, "section", text, error);
  char nearest[TB_DEF_KEY_SIZE];
  tb_section_nearest(text, nearest);
  return refuse_unknown("section", text, nearest, error);
}

/* Index of the element that the key names; of one that is not there, where it would go. */
static uint32_t find_element(const TaborDrumDef *def, const TbKey *key, bool *is_new) {
  *is_new = false;
  const TbGroup group = key->param->group;
  if (!tb_group_is_array(group)) *is_new = tb_group_count(def, group) == 0;
  if (group != TB_GROUP_STRIKER && group != TB_GROUP_MIC) return key->wire;
  const int found = tb_element_find(def, group, key->name);
  *is_new = found < 0;
  return *is_new ? tb_group_count(def, group) : (uint32_t)found;
}

static TaborStatus refuse_full(TbGroup group, const char *key, TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_FULL, key, NULL, NAN, NAN, "%s: a drum has at most %u %ss",
                      key, (unsigned)tb_group_capacity(group), group_word(group));
}

TaborStatus tabor_drum_def_section(TaborDrumDef *def, const char *section, TaborError *error) {
  TbKey parsed;
  bool is_new;
  TaborStatus status = check_arguments(def, section, "", error);
  if (status == TABOR_OK) status = parse_section(section, &parsed, error);
  if (status != TABOR_OK) return status;
  const TbGroup group = parsed.param->group;
  const uint32_t element = find_element(def, &parsed, &is_new);
  if (element >= tb_group_capacity(group)) return refuse_full(group, section, error);
  if (is_new) (void)add_element(def, group, parsed.name);
  return tb_error_clear(error);
}

/* The later one of a head's tension and pitch counts. */
static void forget_pitch(TaborDrumDef *def, uint32_t id) {
  if (id == TB_PARAM_BATTER + TB_HEAD_TENSION) def->batter.pitch = 0;
  if (id == TB_PARAM_RESONANT + TB_HEAD_TENSION) def->resonant.pitch = 0;
}

TaborStatus tabor_drum_def_set(TaborDrumDef *def, const char *key, const char *value,
                               TaborError *error) {
  TbKey parsed;
  TaborStatus status = check_arguments(def, key, value, error);
  if (status == TABOR_OK) status = parse_key(def, key, &parsed, error);
  if (status != TABOR_OK) return status;

  bool is_new;
  const TbGroup group = parsed.param->group;
  uint32_t element = find_element(def, &parsed, &is_new);
  if (element >= tb_group_capacity(group)) return refuse_full(group, key, error);
  TbValue converted;
  status = tb_def_value_parse(parsed.param, key, value, &converted, error);
  if (status != TABOR_OK) return status;

  if (is_new) element = add_element(def, group, parsed.name);
  tb_def_value_store(parsed.param, tb_param_field(parsed.param, def, element), &converted);
  forget_pitch(def, parsed.param->info.id);
  return tb_error_clear(error);
}

/* The name of the group's elements that is nearest to @p name, "" if none is near. */
static void nearest_element(const TaborDrumDef *def, TbGroup group, const char *name,
                            char nearest[TABOR_NAME_SIZE]) {
  size_t smallest = SIZE_MAX;
  nearest[0] = '\0';
  for (uint32_t i = 0; i < tb_group_count(def, group); i++) {
    char candidate[TABOR_NAME_SIZE];
    tb_element_name(def, group, i, candidate);
    if (tb_word_is_nearer(name, candidate, &smallest)) memcpy(nearest, candidate, sizeof candidate);
  }
}

/* "stick, mallet" */
static void list_elements(const TaborDrumDef *def, TbGroup group, char list[TABOR_TEXT_SIZE]) {
  size_t length = 0;
  list[0] = '\0';
  for (uint32_t i = 0; i < tb_group_count(def, group) && length < TABOR_TEXT_SIZE; i++) {
    char name[TABOR_NAME_SIZE];
    tb_element_name(def, group, i, name);
    length +=
      (size_t)snprintf(list + length, TABOR_TEXT_SIZE - length, "%s%s", i > 0 ? ", " : "", name);
  }
}

TaborStatus tb_refuse_name(const TaborDrumDef *def, bool is_mic, const char *key, const char *name,
                           TaborError *error) {
  const TbGroup group = is_mic ? TB_GROUP_MIC : TB_GROUP_STRIKER;
  char nearest[TABOR_NAME_SIZE], list[TABOR_TEXT_SIZE];
  nearest_element(def, group, name, nearest);
  if (*nearest) {
    return tb_error_set(error, TABOR_ERROR_NAME, key, name, NAN, NAN,
                        "%s: the drum has no %s '%s'; did you mean '%s'?", key, group_word(group),
                        name, nearest);
  }
  list_elements(def, group, list);
  return tb_error_set(error, TABOR_ERROR_NAME, key, name, NAN, NAN,
                      "%s: the drum has no %s '%s'; it has: %s", key, group_word(group), name,
                      list);
}

static TaborStatus refuse_absent(const TaborDrumDef *def, const TbKey *parsed, const char *key,
                                 TaborError *error) {
  const TbGroup group = parsed->param->group;
  if (tb_group_is_array(group)) {
    return tb_refuse_name(def, group == TB_GROUP_MIC, key, parsed->name, error);
  }
  const char *why = "the drum has no resonant head";
  if (group == TB_GROUP_PLATE) why = "body.kind is not plate";
  if (group == TB_GROUP_HIHAT) why = "body.kind is not hihat";
  return tb_error_set(error, TABOR_ERROR_NAME, key, NULL, NAN, NAN, "%s: %s", key, why);
}

TaborStatus tabor_drum_def_get(const TaborDrumDef *def, const char *key, char *text, size_t size,
                               TaborError *error) {
  TbKey parsed;
  if (text && size > 0) text[0] = '\0';
  TaborStatus status = check_arguments(def, key, text, error);
  if (status == TABOR_OK) status = parse_key(def, key, &parsed, error);
  if (status != TABOR_OK) return status;

  bool is_new;
  const TbParam *const param = parsed.param;
  const uint32_t element = find_element(def, &parsed, &is_new);
  if (is_new) return refuse_absent(def, &parsed, key, error);
  const TbValue value = tb_def_value_load(param, tb_param_field_const(param, def, element));
  if (tb_def_value_print(param, &value, text, size)) return tb_error_clear(error);
  status = tb_def_value_check(param, key, &value, error);
  if (status != TABOR_OK) return status;
  return tb_error_set(error, TABOR_ERROR_ARGUMENT, key, NULL, NAN, NAN,
                      "%s: the value does not fit into %zu bytes", key, size);
}

/* A walk over the keys that have values. */
typedef struct KeyWalk {
  const TaborDrumDef *def;
  uint32_t skip; /* that many first */
  TbKeyVisit *visit;
  void *context;
} KeyWalk;

/* A TbVisit. */
static bool visit_key(void *context, const TbParam *param, uint32_t element) {
  KeyWalk *const walk = context;
  const TbValue value = tb_def_value_load(param, tb_param_field_const(param, walk->def, element));
  char key[TB_DEF_KEY_SIZE];
  if (tb_def_value_follows(param, &value)) return true;
  if (walk->skip > 0) {
    walk->skip--;
    return true;
  }
  tb_def_key_write(walk->def, param, element, key);
  return walk->visit(walk->context, key);
}

bool tb_def_walk_keys(const TaborDrumDef *def, TbKeyVisit *visit, void *context) {
  KeyWalk walk = {.def = def, .visit = visit, .context = context};
  return tb_walk(def, visit_key, &walk);
}

bool tb_count_key(void *context, const char *key) {
  TbKeySearch *const search = context;
  if (search->left-- > 0) return true;
  search->fits = strlen(key) < search->size;
  if (search->fits) memcpy(search->key, key, strlen(key) + 1);
  return false;
}

bool tabor_drum_def_key(const TaborDrumDef *def, uint32_t index, char *key, size_t size) {
  if (!def || !key) return false;
  TbKeySearch search = {.key = key, .size = size};
  KeyWalk walk = {.def = def, .skip = index, .visit = tb_count_key, .context = &search};
  (void)tb_walk(def, visit_key, &walk);
  return search.fits;
}

int tabor_drum_def_find_striker(const TaborDrumDef *def, const char *name) {
  return def && name ? tb_element_find(def, TB_GROUP_STRIKER, name) : -1;
}

int tabor_drum_def_find_mic(const TaborDrumDef *def, const char *name) {
  return def && name ? tb_element_find(def, TB_GROUP_MIC, name) : -1;
}

bool tb_mic_is_inside(const TaborDrumDef *def, const TaborMicDef *mic) {
  const bool encloses = def->two_headed == 1 || def->shell.boundary == TABOR_BOUNDARY_CLOSED;
  return encloses && mic->radius < def->shell.radius && mic->height < 0 &&
         mic->height > -def->shell.depth;
}

uint32_t tb_mics_outside(const TaborDrumDef *def, uint32_t *mics) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < def->mic_count; i++) {
    if (!tb_mic_is_inside(def, &def->mic[i])) mics[count++] = i;
  }
  return count;
}

int tb_strike_striker(const TaborDrumDef *def) {
  if (!memchr(def->strike.striker, '\0', sizeof def->strike.striker)) return -1;
  if (!*def->strike.striker) return tb_group_count(def, TB_GROUP_STRIKER) > 0 ? 0 : -1;
  return tabor_drum_def_find_striker(def, def->strike.striker);
}

double tb_deviate(uint32_t seed, uint32_t index) {
  const uint64_t bits = tb_draw_bits((uint64_t)seed << 32 | index, 0);
  const double whole = (double)(bits >> 12); /* 52 bits: 2 whole + 1 below is exact */
  return (2 * whole + 1) * 0x1p-52 - 1;
}

/* Place of a wire between the lowest, -1, and the highest, 1: evenly spaced, in an order that is
 * drawn. The generator's numbers up to here are those of tensions. */
static double rest_place(const TaborWiresDef *wires, uint32_t index) {
  enum { FIRST_DRAW = 1 << 16 };
  if (wires->count < 2) return 0;
  const double own = tb_deviate(wires->seed, FIRST_DRAW + index);
  int rank = 0;
  for (uint32_t w = 0; w < wires->count; w++) {
    const double other = tb_deviate(wires->seed, FIRST_DRAW + w);
    rank += other < own || (other == own && w < index);
  }
  const int steps = (int)wires->count - 1;
  return (double)(2 * rank - steps) / steps;
}

/* The pitch of wires keeps its distance from the head's where their tension is in proportion to its
 * own. */
static double shared_tension(const TaborDrumDef *def) {
  const TaborWiresDef *const wires = &def->wires;
  const bool below = wires->head == TABOR_HEAD_RESONANT;
  const double head = below ? def->resonant.tension : def->batter.tension;
  if (wires->head_tension == 0 || head == wires->head_tension) return wires->tension;
  const TaborParameter *const range = &tb_param_by_id(TB_PARAM_WIRES_TENSION)->info;
  return fmin(fmax(wires->tension * (head / wires->head_tension), range->minimum), range->maximum);
}

static void take_default(double *own, double shared) {
  if (isnan(*own)) *own = shared;
}

void tb_wire_resolve(const TaborDrumDef *def, unsigned index, TaborWireDef *wire) {
  assert(index < TABOR_MAX_WIRES);
  const TaborWiresDef *const wires = &def->wires;
  const double deviation = wires->tension_spread * tb_deviate(wires->seed, index);
  const double place = (double)index - ((double)wires->count - 1) / 2;
  const double lifted = wires->unevenness * wires->rest_spread * rest_place(wires, index);
  *wire = def->wire[index];
  take_default(&wire->length, wires->length);
  take_default(&wire->mass_per_length, wires->mass_per_length);
  take_default(&wire->tension, shared_tension(def) * (1 + deviation));
  take_default(&wire->bending_stiffness, wires->bending_stiffness);
  take_default(&wire->damping_0, wires->damping_0);
  take_default(&wire->damping_1, wires->damping_1);
  take_default(&wire->rest_offset, wires->rest_offset + lifted);
  take_default(&wire->contact_stiffness, wires->contact_stiffness);
  take_default(&wire->contact_exponent, wires->contact_exponent);
  take_default(&wire->contact_loss, wires->contact_loss);
  take_default(&wire->angle, wires->angle);
  take_default(&wire->offset, wires->offset + place * wires->spacing);
}
