/* SPDX-License-Identifier: MIT */
/*
 * Checks of a whole definition, which may come from anywhere: no field is trusted until it was
 * looked at. First every field alone, against the table; then what must hold between fields.
 */
#include "definition/def_key.h"
#include "definition/def_text.h"
#include "definition/def_value.h"
#include "definition/definition.h"
#include "definition/error.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct Check {
  const TaborDrumDef *def;
  TaborError *error;
  TaborStatus status;
} Check;

static bool check_field(void *context, const TbParam *param, uint32_t element) {
  Check *const check = context;
  const TbValue value = tb_def_value_load(param, tb_param_field_const(param, check->def, element));
  char key[TB_DEF_KEY_SIZE];
  tb_def_key_write(check->def, param, element, key);
  check->status = tb_def_value_check(param, key, &value, check->error);
  return check->status == TABOR_OK;
}

static TaborStatus check_count(const char *key, const char *what, uint32_t count, uint32_t capacity,
                               TaborError *error) {
  if (count >= 1 && count <= capacity) return TABOR_OK;
  char value[TB_NUMBER_SIZE];
  tb_number_print(count, value);
  return tb_error_set(error, TABOR_ERROR_RANGE, key, value, 1, capacity,
                      "the drum has %s %ss; it needs 1 to %u", value, what, (unsigned)capacity);
}

/* Names of strikers or microphones: valid, and each only once. */
static TaborStatus check_names(const TaborDrumDef *def, TbGroup group, const char *section,
                               TaborError *error) {
  const uint32_t count = tb_group_count(def, group);
  for (uint32_t i = 0; i < count; i++) {
    const char *const stored = group == TB_GROUP_MIC ? def->mic[i].name : def->striker[i].name;
    char name[TABOR_NAME_SIZE];
    tb_element_name(def, group, i, name);
    if (!tb_name_is_valid(stored, TABOR_NAME_LENGTH + 1)) {
      return tb_error_set(error, TABOR_ERROR_VALUE, section, name, NAN, NAN,
                          "%s number %u: its name '%s' is not 1 to %d letters, digits, '-' and '_'",
                          section, (unsigned)i + 1u, name, TABOR_NAME_LENGTH);
    }
    if (tb_element_find(def, group, name) != (int)i) {
      return tb_error_set(error, TABOR_ERROR_VALUE, section, name, NAN, NAN,
                          "two of the drum's %ss are called '%s'", section, name);
    }
  }
  return TABOR_OK;
}

static TaborStatus check_two_headed(const TaborDrumDef *def, TaborError *error) {
  if (def->two_headed <= 1) return TABOR_OK;
  char value[TB_NUMBER_SIZE];
  tb_number_print(def->two_headed, value);
  return tb_error_set(error, TABOR_ERROR_RANGE, "resonant", value, 0, 1,
                      "two_headed is %s; it needs to be 0 or 1", value);
}

static TaborStatus check_fields(const TaborDrumDef *def, TaborError *error) {
  TaborStatus status =
    check_count("striker", "striker", def->striker_count, TABOR_MAX_STRIKERS, error);
  if (status == TABOR_OK) {
    status = check_count("mic", "microphone", def->mic_count, TABOR_MAX_MICS, error);
  }
  if (status == TABOR_OK) status = check_two_headed(def, error);
  if (status == TABOR_OK) status = check_names(def, TB_GROUP_STRIKER, "striker", error);
  if (status == TABOR_OK) status = check_names(def, TB_GROUP_MIC, "mic", error);
  if (status != TABOR_OK) return status;
  Check check = {def, error, TABOR_OK};
  (void)tb_walk(def, check_field, &check);
  return check.status;
}

/* A damper's place on a head: @p radius from its centre, as @p key says. */
static TaborStatus check_place(const TaborDrumDef *def, const char *key, double radius,
                               TaborError *error) {
  if (radius < def->shell.radius) return TABOR_OK;
  char value[TB_NUMBER_SIZE];
  tb_number_print(radius, value);
  return tb_error_set(error, TABOR_ERROR_RANGE, key, value, 0, def->shell.radius,
                      "%s = %s is not below shell.radius, %g m", key, value, def->shell.radius);
}

/* A lug that the head has not got. */
static TaborStatus check_lugs(const TaborHeadDef *head, const char *section, TaborError *error) {
  for (uint32_t j = head->lug_count; j < TABOR_MAX_LUGS; j++) {
    if (isnan(head->lug[j])) continue;
    char key[TB_DEF_KEY_SIZE], value[TB_NUMBER_SIZE];
    (void)snprintf(key, sizeof key, "%s.lug_%u", section, (unsigned)j + 1u);
    tb_number_print(head->lug[j], value);
    return tb_error_set(error, TABOR_ERROR_RANGE, key, value, NAN, NAN,
                        "%s = %s: the head has %u lugs", key, value, (unsigned)head->lug_count);
  }
  return TABOR_OK;
}

/* A felt ring that reaches beyond the edge of its head. */
static TaborStatus check_ring(const TaborDrumDef *def, const TaborHeadDef *head,
                              const char *section, TaborError *error) {
  const double outer = head->ring_radius + 0.5 * head->ring_width;
  if (head->ring_strength == 0.0 || outer <= def->shell.radius) return TABOR_OK;
  char key[TB_DEF_KEY_SIZE], value[TB_NUMBER_SIZE];
  (void)snprintf(key, sizeof key, "%s.ring_radius", section);
  tb_number_print(head->ring_radius, value);
  return tb_error_set(error, TABOR_ERROR_RANGE, key, value, 0,
                      fmax(0.0, def->shell.radius - 0.5 * head->ring_width),
                      "%s = %s: with ring_width %g m the ring reaches beyond shell.radius, %g m",
                      key, value, head->ring_width, def->shell.radius);
}

/* A drum with two heads encloses its air; the boundary says what surrounds a single head. The
 * damper's strength is live: its place counts even where it does nothing yet. */
static TaborStatus check_heads(const TaborDrumDef *def, TaborError *error) {
  const bool two_headed = def->two_headed == 1;
  if (two_headed && def->shell.boundary != TABOR_BOUNDARY_OPEN) {
    const char *const value = def->shell.boundary == TABOR_BOUNDARY_CLOSED ? "closed" : "baffled";
    return tb_error_set(error, TABOR_ERROR_RANGE, "shell.boundary", value, NAN, NAN,
                        "shell.boundary = %s is for a single head; with a resonant head it has to "
                        "be open",
                        value);
  }
  if (!two_headed && def->wires.head == TABOR_HEAD_RESONANT) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "wires.head", "resonant", NAN, NAN,
                        "wires.head = resonant: the drum has no resonant head");
  }
  TaborStatus status = check_place(def, "batter.muffle_radius", def->batter.muffle_radius, error);
  if (status == TABOR_OK) status = check_lugs(&def->batter, "batter", error);
  if (status == TABOR_OK) status = check_ring(def, &def->batter, "batter", error);
  if (status == TABOR_OK && two_headed) status = check_lugs(&def->resonant, "resonant", error);
  if (status == TABOR_OK && two_headed) {
    status = check_ring(def, &def->resonant, "resonant", error);
  }
  if (status != TABOR_OK || !two_headed) return status;
  return check_place(def, "resonant.muffle_radius", def->resonant.muffle_radius, error);
}

static TaborStatus check_flange(const TaborDrumDef *def, const TaborPlateDef *plate,
                                const char *key, TaborError *error) {
  const double width = plate->flange_width, radius = def->shell.radius;
  if (plate->flange_slope == 0.0 || width <= radius) return TABOR_OK;
  char value[TB_NUMBER_SIZE];
  tb_number_print(width, value);
  return tb_error_set(error, TABOR_ERROR_RANGE, key, value, 0.005, radius,
                      "%s = %s is more than shell.radius, %g m", key, value, radius);
}

static TaborStatus check_flanges(const TaborDrumDef *def, TaborError *error) {
  const TaborStatus status = check_flange(def, &def->plate, "plate.flange_width", error);
  if (status != TABOR_OK || def->body.kind != TABOR_BODY_HIHAT) return status;
  return check_flange(def, &def->bottom, "bottom.flange_width", error);
}

/* Refuses what a plate has not got. */
static TaborStatus check_plate(const TaborDrumDef *def, TaborError *error) {
  if (def->body.kind == TABOR_BODY_DRUM) return TABOR_OK;
  const char *const kind = def->body.kind == TABOR_BODY_PLATE ? "plate" : "hihat";
  if (def->two_headed == 1) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "resonant", NULL, NAN, NAN,
                        "body.kind = %s: a plate has no resonant head", kind);
  }
  if (def->shell.boundary != TABOR_BOUNDARY_OPEN) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "shell.boundary", NULL, NAN, NAN,
                        "body.kind = %s: shell.boundary has to be open", kind);
  }
  if (def->wires.count == 0) return check_flanges(def, error);
  char value[TB_NUMBER_SIZE];
  tb_number_print(def->wires.count, value);
  return tb_error_set(error, TABOR_ERROR_RANGE, "wires.count", value, 0, 0,
                      "wires.count = %s: a plate has no wires, so it has to be 0", value);
}

static TaborStatus check_strike(const TaborDrumDef *def, TaborError *error) {
  if (!(def->strike.radius <= def->shell.radius)) { /* at the rim a stroke meets what cannot move */
    char value[TB_NUMBER_SIZE];
    tb_number_print(def->strike.radius, value);
    return tb_error_set(error, TABOR_ERROR_RANGE, "strike.radius", value, 0, def->shell.radius,
                        "strike.radius = %s is beyond shell.radius, %g m", value,
                        def->shell.radius);
  }
  const int striker = tb_strike_striker(def);
  if (striker < 0) {
    return tb_refuse_name(def, false, "strike.striker", def->strike.striker, error);
  }
  if (def->strike.technique == TABOR_TECHNIQUE_PEDAL && def->body.kind != TABOR_BODY_HIHAT) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "strike.technique", "pedal", NAN, NAN,
                        "strike.technique = pedal: the drum has no pedal");
  }
  const bool sweeps = def->strike.technique == TABOR_TECHNIQUE_SWEEP;
  if (!sweeps || def->striker[striker].kind == TABOR_STRIKER_BRUSH) return TABOR_OK;
  return tb_error_set(error, TABOR_ERROR_RANGE, "strike.technique", "sweep", NAN, NAN,
                      "strike.technique = sweep: striker %s is no brush",
                      def->striker[striker].name);
}

/* Every wire crosses the head. It may be longer than its chord: what lies beyond touches
 * nothing. */
static TaborStatus check_wire(const TaborDrumDef *def, uint32_t index, TaborError *error) {
  TaborWireDef wire;
  tb_wire_resolve(def, index, &wire);
  if (fabs(wire.offset) < def->shell.radius) return TABOR_OK;
  char key[TB_DEF_KEY_SIZE] = "wires.spacing", value[TB_NUMBER_SIZE];
  if (!isnan(def->wire[index].offset)) {
    (void)snprintf(key, sizeof key, "wire.%u.offset", (unsigned)index + 1u);
  } else if (fabs(def->wires.offset) >= def->shell.radius) {
    (void)snprintf(key, sizeof key, "wires.offset");
  }
  TbKey parsed;
  (void)tb_def_key_parse(key, &parsed);
  const TbValue own =
    tb_def_value_load(parsed.param, tb_param_field_const(parsed.param, def, parsed.wire));
  tb_number_print(own.number, value);
  return tb_error_set(
    error, TABOR_ERROR_RANGE, key, value, parsed.param->info.minimum, parsed.param->info.maximum,
    "%s = %s: wire %u would lie %g m from the centre, not within shell.radius, %g m", key, value,
    (unsigned)index + 1u, wire.offset, def->shell.radius);
}

/* Microphones stand as far from the resonant head's plane as the table asks for the batter's. */
static TaborStatus check_mic(const TaborDrumDef *def, uint32_t index, TaborError *error) {
  const TaborMicDef *const mic = &def->mic[index];
  const double rounding = 1e-9; /* -0.15 m is 0.01 m below a shell of 0.14 m */
  const double least = tb_param_by_id(TB_PARAM_MIC_HEIGHT)->least * (1 - rounding);
  if (def->two_headed != 1 || fabs(mic->height + def->shell.depth) >= least) return TABOR_OK;
  char key[TB_DEF_KEY_SIZE], value[TB_NUMBER_SIZE];
  (void)snprintf(key, sizeof key, "mic.%s.height", mic->name);
  tb_number_print(mic->height, value);
  return tb_error_set(
    error, TABOR_ERROR_RANGE, key, value, NAN, NAN,
    "%s = %s: the microphone would be within 0.01 m of the resonant head's plane, "
    "%g m below the batter head",
    key, value, def->shell.depth);
}

TaborStatus tabor_drum_def_validate(const TaborDrumDef *def, TaborError *error) {
  TaborStatus status = tb_check_struct(def, error);
  if (status == TABOR_OK) status = check_fields(def, error);
  if (status == TABOR_OK) status = check_heads(def, error);
  if (status == TABOR_OK) status = check_plate(def, error);
  if (status == TABOR_OK) status = check_strike(def, error);
  for (uint32_t i = 0; status == TABOR_OK && i < def->wires.count; i++) {
    status = check_wire(def, i, error);
  }
  for (uint32_t i = 0; status == TABOR_OK && i < def->mic_count; i++) {
    status = check_mic(def, i, error);
  }
  return status == TABOR_OK ? tb_error_clear(error) : status;
}
