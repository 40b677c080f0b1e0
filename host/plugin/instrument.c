/* SPDX-License-Identifier: MIT */
#include "plugin/instrument.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- beginning and end ---------------------------------------------------------------------- */

Instrument *instrument_create(const InstrumentKind *kind) {
  Instrument *const instrument = calloc(1, kind->calls->size);
  if (!instrument) return NULL;
  instrument->kind = kind;
  if (kind->calls->begin(instrument) && window_link_begin(&instrument->window)) {
    for (uint32_t i = 0; i < kind->knob_count; i++)
      atomic_store(&instrument->values[i], instrument->ranges[i].fallback);
    return instrument;
  }
  instrument_destroy(instrument);
  return NULL;
}

void instrument_destroy(Instrument *instrument) {
  if (!instrument) return;
  instrument_close(instrument);
  window_link_end(&instrument->window);
  instrument->kind->calls->end(instrument);
  free(instrument);
}

void instrument_close(Instrument *instrument) {
  if (!instrument->is_open) return;
  instrument->kind->calls->close(instrument);
  instrument->is_open = false;
}

bool instrument_open(Instrument *instrument, double rate) {
  char line[96];
  instrument_close(instrument);
  instrument->rate = rate;
  if (rate >= INSTRUMENT_LEAST_RATE && rate <= INSTRUMENT_MOST_RATE) {
    instrument->is_open = instrument->kind->calls->open(instrument, rate);
    return instrument->is_open;
  }
  (void)snprintf(line, sizeof line, "silent at a sample rate of %g Hz; from %d to %d Hz it sounds",
                 rate, INSTRUMENT_LEAST_RATE, INSTRUMENT_MOST_RATE);
  instrument_say(instrument, line);
  return true;
}

void instrument_say(const Instrument *instrument, const char *line) {
  if (instrument->say) instrument->say(instrument->context, line);
}

/* ---- knobs ---------------------------------------------------------------------------------- */

uint32_t instrument_knob(const InstrumentKind *kind, uint32_t number) {
  if (number >= kind->knob_count) return kind->knob_count;
  const uint32_t id = kind->order ? kind->order[number] : number;
  return kind->calls->has_knob(kind, id) ? id : kind->knob_count;
}

uint32_t instrument_knob_at(const InstrumentKind *kind, uint32_t place) {
  for (uint32_t number = 0; number < kind->knob_count; number++) {
    const uint32_t id = instrument_knob(kind, number);
    if (id < kind->knob_count && place-- == 0) return id;
  }
  return kind->knob_count;
}

uint32_t instrument_number(const InstrumentKind *kind, uint32_t id) {
  uint32_t number = 0;
  while (instrument_knob(kind, number) != id) number++;
  return number;
}

uint32_t instrument_knob_count(const InstrumentKind *kind) {
  uint32_t count = 0;
  while (instrument_knob_at(kind, count) < kind->knob_count) count++;
  return count;
}

const KnobPage *instrument_page(const InstrumentKind *kind, uint32_t place) {
  for (uint32_t i = 0; i < kind->page_count; i++) {
    if (kind->calls->has_knob(kind, kind->pages[i].knobs[0]) && place-- == 0)
      return &kind->pages[i];
  }
  return NULL;
}

uint32_t instrument_knob_on_page(const InstrumentKind *kind, const KnobPage *page, uint32_t place) {
  for (uint32_t i = 0; i < page->count; i++) {
    if (kind->calls->has_knob(kind, page->knobs[i]) && place-- == 0) return page->knobs[i];
  }
  return kind->knob_count;
}

const char *instrument_group_name(const InstrumentKind *kind, uint32_t id) {
  for (uint32_t i = 0; i < kind->group_count; i++) {
    if (strcmp(kind->knobs[id].group, kind->groups[i].symbol) == 0) return kind->groups[i].name;
  }
  return "";
}

void instrument_set(Instrument *instrument, uint32_t id, double value) {
  if (!isfinite(value)) return;
  const Knob *const knob = &instrument->kind->knobs[id];
  atomic_store(&instrument->values[id], knob_limited(knob, &instrument->ranges[id], value));
}

void instrument_set_all(Instrument *instrument, const float values[INSTRUMENT_KNOBS]) {
  for (uint32_t i = 0; i < instrument->kind->knob_count; i++)
    instrument_set(instrument, i, (double)values[i]);
}

/* Where the head could not have the pitch that was asked for, or MIDI has chosen another drum, the
 * knob goes where the drum is. */
static void follow_drum(Instrument *instrument, uint32_t id) REALTIME;
static void follow_drum(Instrument *instrument, uint32_t id) {
  float asked, given;
  if (!instrument->kind->calls->take_given(instrument, id, &asked, &given)) return;
  if (!atomic_compare_exchange_strong(&instrument->values[id], &asked, given)) return;
  atomic_store(&instrument->has_moved, true);
}

/* How far the modulation is from the value, in the knob's own unit. */
static float offset_of(const Instrument *instrument, uint32_t id, float value) REALTIME;
static float offset_of(const Instrument *instrument, uint32_t id, float value) {
  const KnobRange *const range = &instrument->ranges[id];
  const double amount = (double)atomic_load(&instrument->offsets[id]);
  if (amount == 0 || !knob_is_bent(range)) return (float)amount;
  const double to = knob_at_position(range, knob_position(range, (double)value) + amount);
  return knob_single(to - (double)value);
}

/* That of the drum or kit comes first, since the others turn what it takes. */
void instrument_turn_knobs(Instrument *instrument) {
  const InstrumentKind *const kind = instrument->kind;
  const InstrumentCalls *const calls = kind->calls;
  if (calls->take_given && instrument->has_movable_knobs) {
    for (uint32_t i = 0; i < kind->seen_count; i++) follow_drum(instrument, i);
  }
  calls->turn(instrument, kind->main_knob, atomic_load(&instrument->values[kind->main_knob]));
  for (uint32_t i = 0; i < kind->knob_count; i++) {
    const uint32_t id = instrument_knob(kind, i);
    if (id == kind->knob_count) continue;
    const float value = atomic_load(&instrument->values[id]);
    calls->turn(instrument, id, value);
    if (calls->modulate) calls->modulate(instrument, id, offset_of(instrument, id, value));
  }
}

/* ---- settings ------------------------------------------------------------------------------- */

void instrument_note(Instrument *instrument, InstrumentSetting *setting) {
  const InstrumentKind *const kind = instrument->kind;
  for (uint32_t i = 0; i < kind->knob_count; i++)
    setting->values[i] = atomic_load(&instrument->values[i]);
  kind->calls->note(instrument, setting);
  for (uint32_t i = 0; i < kind->seen_count; i++) {
    if (isnan(setting->seen[i])) setting->seen[i] = setting->values[i];
  }
}

/* ---- files ---------------------------------------------------------------------------------- */

enum { FILE_IDLE, FILE_ASKED, FILE_LOADING };

bool instrument_ask_file(Instrument *instrument, const char *path, size_t length) {
  if (length >= INSTRUMENT_PATH || atomic_load(&instrument->file_phase) != FILE_IDLE) return false;
  memcpy(instrument->file, path, length);
  instrument->file[length] = '\0';
  atomic_store(&instrument->file_phase, FILE_ASKED);
  return true;
}

/* Knobs of the host stay where they are: the drum is noted as one that has them there. */
static void load_file(Instrument *instrument) {
  const InstrumentCalls *const calls = instrument->kind->calls;
  char message[INSTRUMENT_MESSAGE];
  InstrumentSetting setting;
  unsigned asked = FILE_ASKED;
  if (!atomic_compare_exchange_strong(&instrument->file_phase, &asked, FILE_LOADING)) return;
  calls->blank(instrument, &setting);
  if (calls->load(instrument, instrument->file, true, &setting, message)) {
    for (uint32_t i = 0; i < instrument->kind->seen_count; i++) setting.seen[i] = NAN;
    calls->use(instrument, &setting);
  } else {
    instrument_say(instrument, message);
  }
  atomic_store(&instrument->file_phase, FILE_IDLE);
}

void instrument_work(void *worked) {
  Instrument *const instrument = worked;
  load_file(instrument);
  instrument->kind->calls->work(instrument);
}

/* ---- blocks --------------------------------------------------------------------------------- */

void instrument_begin_block(Instrument *instrument) {
  const InstrumentCalls *const calls = instrument->kind->calls;
  instrument->at = 0;
  if (calls->begin_block) calls->begin_block(instrument);
}

bool instrument_is_settled(const Instrument *instrument) {
  return atomic_load(&instrument->file_phase) == FILE_IDLE &&
         instrument->kind->calls->is_settled(instrument);
}
