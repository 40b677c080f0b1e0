/* SPDX-License-Identifier: MIT */
/* What a host gives a CLAP plugin. An input whose first byte is below 128 is a state, behind that
 * byte: it is refused with a reason, or taken, and what is saved then is saved again after it was
 * loaded. Any other input is a list of events and blocks for a plugin that plays: whatever they
 * are, the sound stays finite. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "clap_host.h"
#include "drums/definition_text.h"
#include "fuzz.h"

enum { MOST_EVENTS = 64, MOST_BLOCKS = 24, MOST_FRAMES = 512 };

extern const clap_plugin_entry_t clap_entry;

static ClapState given, saved, again;

/* ---- states --------------------------------------------------------------------------------- */

static void set_state(ClapState *state, const void *bytes, size_t size) {
  state->size = size < CLAP_STATE ? size : CLAP_STATE;
  state->at = 0;
  memcpy(state->bytes, bytes, state->size);
}

/* Inactive: no model is built, however large the drum is. */
static void try_state(const FuzzInput *input) {
  ClapHost *const host = clap_host_open(&clap_entry, ID_DRUM);
  set_state(&given, input->at, input->left);
  clap_host_save(host, &saved);
  if (clap_host_load(host, &given)) {
    clap_host_save(host, &saved);
    fuzz_require(clap_host_load(host, &saved), "what the plugin saves, it loads");
  } else {
    fuzz_require(host->said[0] != '\0', "a refusal has a reason");
  }
  clap_host_save(host, &again);
  const bool same = saved.size == again.size && memcmp(saved.bytes, again.bytes, saved.size) == 0;
  fuzz_require(same, "what is saved, or was there before a refusal, is saved again");
  for (uint32_t knob = 0; knob < KNOB_COUNT; knob++) {
    if (!knob_is_in(KNOBS_STEREO, (KnobId)knob)) continue;
    fuzz_require(isfinite(clap_host_value(host, (KnobId)knob)), "values are finite");
  }
  clap_host_close(host);
}

/* ---- events --------------------------------------------------------------------------------- */

/* A drum with few modes, whose models are built in a moment. */
static void make_small(ClapHost *host) {
  static const char HEAD[] = "tabor-state 1\ndefinition\n";
  TaborDrumDef def;
  fuzz_require(tabor_drum_def_preset(&def, "tabor", NULL) == TABOR_OK, "a preset");
  def.quality.two_way_bandwidth = 500;
  def.quality.bandwidth = 1000;
  def.quality.wire_points = 8;
  char *const text = definition_write(&def, TABOR_TEXT_KEEP, NULL, NULL);
  fuzz_require(text != NULL, "memory");
  set_state(&given, HEAD, sizeof HEAD - 1);
  memcpy(given.bytes + given.size, text, strlen(text));
  given.size += strlen(text);
  free(text);
  fuzz_require(clap_host_load(host, &given), "the small drum's state");
}

static ClapHost *open_plugin(const char *id) {
  ClapHost *const host = clap_host_open(&clap_entry, id);
  make_small(host);
  clap_host_set(host, 0, KNOB_QUALITY, CLAP_QUALITY(TABOR_QUALITY_DRAFT));
  clap_host_flush(host);
  clap_host_activate(host);
  return host;
}

static void fill_value(clap_event_param_value_t *value, FuzzInput *input) {
  value->param_id = fuzz_byte(input) % (KNOB_COUNT + 2);
  value->note_id = value->port_index = value->channel = value->key = -1;
  value->value = fuzz_number(input) * (fuzz_byte(input) % 2 ? 1 : 100);
  /* Models of the other qualities take seconds. */
  if (value->param_id == clap_host_id(KNOB_QUALITY))
    value->value = CLAP_QUALITY(TABOR_QUALITY_DRAFT);
}

static void fill_note(clap_event_note_t *note, FuzzInput *input) {
  note->note_id = (int32_t)(fuzz_byte(input) % 5) - 1;
  note->port_index = (int16_t)(fuzz_byte(input) % 3 - 1);
  note->channel = (int16_t)(fuzz_byte(input) % 18 - 1);
  note->key = (int16_t)(fuzz_byte(input) % 131 - 1);
  note->velocity = fuzz_number(input);
}

/* Program changes would build other models. */
static void fill_midi(clap_event_midi_t *midi, FuzzInput *input) {
  midi->port_index = fuzz_byte(input) % 2;
  for (int i = 0; i < 3; i++) midi->data[i] = fuzz_byte(input);
  if (midi->data[0] >> 4 == 0xc) midi->data[0] = 0x99;
}

static void fill_expression(clap_event_note_expression_t *expression, FuzzInput *input) {
  expression->expression_id = fuzz_byte(input) % 9 - 1;
  expression->note_id = (int32_t)(fuzz_byte(input) % 5) - 1;
  expression->port_index = expression->channel = -1;
  expression->key = (int16_t)(fuzz_byte(input) % 131 - 1);
  expression->value = fuzz_number(input);
}

/* Times may lie beyond the block, and before those of earlier events. */
static void add_event(ClapHost *host, FuzzInput *input) {
  static const struct {
    uint16_t type;
    uint32_t size;
  } KINDS[] = {{CLAP_EVENT_NOTE_ON, sizeof(clap_event_note_t)},
               {CLAP_EVENT_NOTE_OFF, sizeof(clap_event_note_t)},
               {CLAP_EVENT_NOTE_CHOKE, sizeof(clap_event_note_t)},
               {CLAP_EVENT_PARAM_VALUE, sizeof(clap_event_param_value_t)},
               {CLAP_EVENT_PARAM_MOD, sizeof(clap_event_param_mod_t)},
               {CLAP_EVENT_MIDI, sizeof(clap_event_midi_t)},
               {CLAP_EVENT_NOTE_EXPRESSION, sizeof(clap_event_note_expression_t)},
               {CLAP_EVENT_TRANSPORT, sizeof(clap_event_header_t)},
               {999, sizeof(clap_event_header_t)}};
  const uint8_t kind = fuzz_byte(input) % (sizeof KINDS / sizeof *KINDS), wild = fuzz_byte(input);
  ClapEvent *const event = &host->events[host->event_count++];
  memset(event, 0, sizeof *event);
  switch (KINDS[kind].type) {
  case CLAP_EVENT_PARAM_VALUE: fill_value(&event->value, input); break;
  case CLAP_EVENT_PARAM_MOD:
    fill_value(&event->value, input);
    event->modulation.amount = event->value.value;
    break;
  case CLAP_EVENT_MIDI: fill_midi(&event->midi, input); break;
  case CLAP_EVENT_NOTE_EXPRESSION: fill_expression(&event->expression, input); break;
  default:
    if (kind < 3) fill_note(&event->note, input);
  }
  event->header = (clap_event_header_t){.size = KINDS[kind].size,
                                        .time = fuzz_byte(input) * (wild & 1u ? 77u : 1u),
                                        .space_id = wild & 2u ? 1 : CLAP_CORE_EVENT_SPACE_ID,
                                        .type = KINDS[kind].type,
                                        .flags = wild >> 2};
}

static void run(ClapHost *host, uint32_t frames) {
  clap_host_run(host, frames);
  for (uint32_t channel = 0; channel < (host->stereo ? 2 : CLAP_CHANNELS); channel++) {
    for (uint32_t i = 0; i < frames; i++) {
      fuzz_require(isfinite(host->sound[channel][i]), "the sound is finite");
    }
  }
}

static void try_events(ClapHost *host, FuzzInput *input) {
  host->plugin->reset(host->plugin);
  for (int block = 0; block < MOST_BLOCKS && input->left > 0; block++) {
    const uint32_t frames = fuzz_byte(input) * 2u % (MOST_FRAMES + 1);
    const uint32_t count = fuzz_byte(input) % MOST_EVENTS;
    for (uint32_t i = 0; i < count && input->left > 0; i++) add_event(host, input);
    if (frames == 0) {
      clap_host_flush(host);
    } else {
      run(host, frames);
    }
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static ClapHost *hosts[2]; /* they stay: to activate takes longer than an input */
  FuzzInput input = {data, size};
  const uint8_t choice = fuzz_byte(&input);
  if (choice < 128) {
    try_state(&input);
    return 0;
  }
  ClapHost **const host = &hosts[choice % 2];
  if (!*host) *host = open_plugin(choice % 2 ? ID_DRUM_MULTI : ID_DRUM);
  try_events(*host, &input);
  return 0;
}
