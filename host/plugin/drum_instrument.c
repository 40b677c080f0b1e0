/* SPDX-License-Identifier: MIT */
#include "plugin/drum_instrument.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drums/definition_text.h"
#include "drums/drum_file.h"
#include "plugin/plugin_player.h"

#define LONGEST_RING 12.0 /* [s] within which a drum has died away */
#define FALL 1.5          /* times the 60 dB decay of a room until it has fallen by 90 dB */

typedef struct DrumInstrument {
  Instrument base;
  SavedState saved;         /* the drum, while it is not open */
  bool is_saved;            /* it is not the default one */
  _Atomic float room_decay; /* of the drum's definition [s], 0: by kind */
  ModelWorker worker;
  PluginPlayer player;
} DrumInstrument;

static DrumInstrument *drum_of(Instrument *instrument) REALTIME {
  return (DrumInstrument *)instrument;
}

static PluginPlayer *player_of(Instrument *instrument) REALTIME {
  return &drum_of(instrument)->player;
}

static const DrumInstrument *read_only(const Instrument *instrument) REALTIME {
  return (const DrumInstrument *)instrument;
}

/* ---- knobs ---------------------------------------------------------------------------------- */

static bool has_knob(const InstrumentKind *kind, uint32_t id) REALTIME {
  return knob_is_in((KnobSet)kind->variant, (KnobId)id);
}

static bool is_modulated(uint32_t id) REALTIME { return knob_is_modulated((KnobId)id); }

static bool has_part(const InstrumentSetting *setting, uint32_t id) {
  TaborDrumDef def = setting->def;
  return knob_has_part(&def, (KnobId)id);
}

/* ---- beginning and end ---------------------------------------------------------------------- */

static bool begin(Instrument *instrument) {
  DrumInstrument *const drum = drum_of(instrument);
  instrument->builder = &drum->worker.builder;
  const KnobSet set = (KnobSet)instrument->kind->variant;
  if (tabor_drum_def_preset(&drum->saved.def, DEFAULT_PRESET, NULL) != TABOR_OK) return false;
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    instrument->ranges[i] = knob_range_in(set, (KnobId)i, &drum->saved.def);
    if (i < KNOB_SEEN) drum->saved.seen[i] = instrument->ranges[i].fallback;
  }
  return true;
}

static void end(Instrument *instrument) { (void)instrument; }

static void free_all(DrumInstrument *drum) {
  plugin_player_end(&drum->player);
  model_worker_end(&drum->worker);
}

static void say(void *context, const char *line) { instrument_say(context, line); }

static bool open(Instrument *instrument, double rate) {
  DrumInstrument *const drum = drum_of(instrument);
  const bool stereo = instrument->kind->variant != KNOBS_MULTI;
  memset(&drum->worker, 0, sizeof drum->worker);
  memset(&drum->player, 0, sizeof drum->player);
  if (!model_worker_begin(&drum->worker, rate, stereo, say, instrument)) return false;
  if (drum->is_saved) model_worker_restore(&drum->worker, &drum->saved);
  if (plugin_player_begin(&drum->player, &drum->worker, rate, stereo)) return true;
  free_all(drum);
  return false;
}

static void close(Instrument *instrument) {
  DrumInstrument *const drum = drum_of(instrument);
  model_worker_save(&drum->worker, &drum->saved);
  drum->is_saved = true;
  free_all(drum);
}

static void work(Instrument *instrument) { model_worker_work(&drum_of(instrument)->worker); }

TaborModel *drum_instrument_model(Instrument *instrument) {
  return instrument->is_open ? model_worker_model(&drum_of(instrument)->worker) : NULL;
}

/* ---- drums ---------------------------------------------------------------------------------- */

static void note(Instrument *instrument, InstrumentSetting *setting) {
  DrumInstrument *const drum = drum_of(instrument);
  SavedState saved = drum->saved;
  if (instrument->is_open) model_worker_save(&drum->worker, &saved);
  setting->def = saved.def;
  memcpy(setting->seen, saved.seen, sizeof saved.seen);
}

static void use(Instrument *instrument, const InstrumentSetting *setting) {
  DrumInstrument *const drum = drum_of(instrument);
  SavedState saved = {.def = setting->def};
  memcpy(saved.seen, setting->seen, sizeof saved.seen);
  atomic_store(&drum->room_decay, (float)saved.def.room.decay);
  if (instrument->is_open) {
    model_worker_restore(&drum->worker, &saved);
  } else {
    drum->saved = saved;
    drum->is_saved = true;
  }
}

/* Without a pitch in it, the tension leads; without a drum's number, the drum stays wherever the
 * host puts the knob first. */
static void blank(Instrument *instrument, InstrumentSetting *setting) {
  for (uint32_t i = 0; i < KNOB_COUNT; i++) {
    const bool is_pitch = i == KNOB_BATTER_PITCH || i == KNOB_RESONANT_PITCH;
    setting->values[i] = setting->seen[i] = is_pitch ? 0 : instrument->ranges[i].fallback;
  }
  setting->seen[KNOB_DRUM] = NAN;
}

static char *text(Instrument *instrument, const InstrumentSetting *setting) {
  (void)instrument;
  return definition_write(&setting->def, TABOR_TEXT_KEEP, NULL, NULL);
}

/* Earlier versions passed over a pitch that the head cannot have. The drum stays as it was, and the
 * knob shows its pitch. */
static void settle_pitches(InstrumentSetting *setting) {
  TaborDrumDef tuned = setting->def;
  TaborError error;
  while (tabor_drum_def_tune(&tuned, &error) != TABOR_OK) {
    const KnobId id = knob_of_refused_pitch(&error);
    if (id == KNOB_COUNT) return;
    *knob_field(&tuned, id) = *knob_field(&setting->def, id) = 0;
    const float shown = (float)knob_decimal((float)knob_shown(&setting->def, id));
    if (setting->values[id] == setting->seen[id]) setting->values[id] = shown;
    setting->seen[id] = shown;
  }
}

static bool refuse(char *message, const TaborError *error) {
  (void)snprintf(message, INSTRUMENT_MESSAGE, "%s", error->message);
  return false;
}

static bool read(Instrument *instrument, const char *text, size_t length,
                 InstrumentSetting *setting, char *message) {
  TaborError error;
  if (!definition_read(text, length, &setting->def, &error)) return refuse(message, &error);
  if (instrument->has_movable_knobs) settle_pitches(setting);
  return true;
}

static bool load_built_in(const char *name, TaborDrumDef *def, char *message) {
  TaborError error;
  return tabor_drum_def_preset(def, name, &error) == TABOR_OK || refuse(message, &error);
}

static bool load_file(const char *path, TaborDrumDef *def, char *message) {
  TaborError error;
  if (drum_file_read(path, def, message, INSTRUMENT_MESSAGE) != PRESET_FILE_OK) return false;
  if (tabor_drum_def_validate(def, &error) == TABOR_OK) return true;
  (void)snprintf(message, INSTRUMENT_MESSAGE, "%s: %s", path, error.message);
  return false;
}

/* Knobs stand where the drum is; of parts that it lacks, where they stood. So does KNOB_DRUM with a
 * drum of the user's. */
static void follow_drum(const Instrument *instrument, InstrumentSetting *setting) {
  for (uint32_t i = 0; i < KNOB_SEEN; i++) {
    const double shown = knob_shown(&setting->def, (KnobId)i);
    if (isfinite(shown))
      setting->values[i] = knob_limited(&knobs[i], &instrument->ranges[i], shown);
    setting->seen[i] = setting->values[i];
  }
}

static bool load(Instrument *instrument, const char *name, bool is_file, InstrumentSetting *setting,
                 char *message) {
  if (!(is_file ? load_file : load_built_in)(name, &setting->def, message)) return false;
  follow_drum(instrument, setting);
  return true;
}

/* A knob that stands elsewhere than where it stood with the drum was turned. */
static bool define(Instrument *instrument, const InstrumentSetting *setting,
                   Definition *definition) {
  (void)instrument;
  definition->is_kit = false;
  definition->drum = setting->def;
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    if (isfinite(setting->seen[i]) && setting->values[i] != setting->seen[i])
      knob_give(&definition->drum, (KnobId)i, knob_decimal(setting->values[i]));
  }
  return true;
}

/* A pitch that the head cannot have is refused here: later only the log would say so. */
static bool redefine(Instrument *instrument, const Definition *definition,
                     InstrumentSetting *setting, char *message) {
  TaborDrumDef tuned = definition->drum;
  TaborError error;
  if (tabor_drum_def_tune(&tuned, &error) != TABOR_OK) return refuse(message, &error);
  setting->def = definition->drum;
  follow_drum(instrument, setting);
  return true;
}

static double tail(const Instrument *instrument) {
  static const double decays[] = {0, 0.3, 0.6, 1.5}; /* of a TaborRoomKind [s] */
  const uint32_t kind = (uint32_t)atomic_load(&instrument->values[KNOB_ROOM]);
  const double own = (double)atomic_load(&read_only(instrument)->room_decay);
  return LONGEST_RING + FALL * (kind > 0 && own > 0 ? own : decays[kind]);
}

/* ---- AUDIO ---------------------------------------------------------------------------------- */

static void rest(Instrument *instrument) REALTIME { plugin_player_rest(player_of(instrument)); }

static void export_sound(Instrument *instrument, bool exports) REALTIME {
  plugin_player_export(player_of(instrument), exports);
}

static void receive(Instrument *instrument) REALTIME {
  plugin_player_receive(player_of(instrument));
}

static bool ask(Instrument *instrument) REALTIME {
  return plugin_player_ask(player_of(instrument));
}

static void turn(Instrument *instrument, uint32_t id, float value) REALTIME {
  plugin_player_turn(player_of(instrument), (KnobId)id, value);
}

static void modulate(Instrument *instrument, uint32_t id, float offset) REALTIME {
  plugin_player_modulate(player_of(instrument), (KnobId)id, offset);
}

static bool take_given(Instrument *instrument, uint32_t id, float *asked, float *given) REALTIME {
  return plugin_player_take_given(player_of(instrument), (KnobId)id, asked, given);
}

static void begin_frame(Instrument *instrument) REALTIME {
  plugin_player_begin_frame(player_of(instrument));
}

static void take(Instrument *instrument, const MidiMessage *message, uint32_t frame) REALTIME {
  plugin_player_take(player_of(instrument), message, frame - instrument->at);
}

/* A drum falls silent with any of its keys. */
static void choke(Instrument *instrument, int key, uint32_t frame) REALTIME {
  enum { ALL_SOUND_OFF = 120 };
  (void)key;
  take(instrument, &(MidiMessage){MIDI_CONTROL, {ALL_SOUND_OFF, 0}}, frame);
}

static void play(Instrument *instrument, uint32_t end) REALTIME {
  while (instrument->at < end) {
    instrument->at += plugin_player_play(player_of(instrument), &instrument->buffers,
                                         instrument->at, end - instrument->at);
  }
}

static void end_frame(Instrument *instrument, uint32_t frame) REALTIME {
  if (!plugin_player_has_choice(player_of(instrument))) return;
  play(instrument, frame);
  plugin_player_choose(player_of(instrument));
}

static bool is_full(const Instrument *instrument) REALTIME {
  return plugin_player_is_full(&read_only(instrument)->player);
}

static void strike(Instrument *instrument, const WindowStroke *stroke) REALTIME {
  plugin_player_strike(player_of(instrument), stroke->velocity, stroke->radius, stroke->angle);
}

static void show_stroke(Instrument *instrument) REALTIME;
static void show_stroke(Instrument *instrument) {
  WindowLink *const link = &instrument->window;
  TaborEvent stroke;
  if (!plugin_player_take_struck(player_of(instrument), &stroke)) return;
  atomic_store(&link->place[0], (float)stroke.radius);
  atomic_store(&link->place[1], (float)stroke.angle);
  atomic_store(&link->struck[0], (float)stroke.velocity);
}

static void show(Instrument *instrument) REALTIME {
  WindowLink *const link = &instrument->window;
  if (!atomic_load(&link->is_shown)) return;
  show_stroke(instrument);
  TaborView *const view = atomic_exchange(&link->asked, NULL);
  if (!view) return;
  const TaborDrum *const drum = player_of(instrument)->core.drum;
  if (!drum || !tabor_drum_view(drum, view)) atomic_store(&link->is_stale, true);
  atomic_store(&link->seen, view);
}

static bool is_ready(const Instrument *instrument) REALTIME {
  return plugin_player_is_ready(&read_only(instrument)->player);
}

static bool is_there(const Instrument *instrument) REALTIME {
  return plugin_player_is_restored(&read_only(instrument)->player);
}

static bool is_settled(const Instrument *instrument) REALTIME {
  return plugin_player_is_settled(&read_only(instrument)->player);
}

static bool is_silent(const Instrument *instrument) REALTIME {
  return plugin_player_is_silent(&read_only(instrument)->player);
}

const InstrumentCalls drum_instrument = {.size = sizeof(DrumInstrument),
                                         .has_knob = has_knob,
                                         .is_modulated = is_modulated,
                                         .has_part = has_part,
                                         .begin = begin,
                                         .end = end,
                                         .open = open,
                                         .close = close,
                                         .work = work,
                                         .note = note,
                                         .use = use,
                                         .blank = blank,
                                         .text = text,
                                         .read = read,
                                         .load = load,
                                         .define = define,
                                         .redefine = redefine,
                                         .tail = tail,
                                         .rest = rest,
                                         .export_sound = export_sound,
                                         .receive = receive,
                                         .ask = ask,
                                         .turn = turn,
                                         .modulate = modulate,
                                         .take_given = take_given,
                                         .begin_frame = begin_frame,
                                         .choke = choke,
                                         .take = take,
                                         .end_frame = end_frame,
                                         .is_full = is_full,
                                         .play = play,
                                         .strike = strike,
                                         .show = show,
                                         .is_ready = is_ready,
                                         .is_there = is_there,
                                         .is_settled = is_settled,
                                         .is_silent = is_silent};
