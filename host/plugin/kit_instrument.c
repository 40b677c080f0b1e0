/* SPDX-License-Identifier: MIT */
#include "plugin/kit_instrument.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/definition_text.h"
#include "plugin/kit_plugin_player.h"

#define LONGEST_RING 20.0 /* [s] within which all drums and a hall have died away */
#define OWN "own"         /* name of the user's own kit in sessions */

typedef struct KitInstrument {
  Instrument base;
  OwnKit own;
  TaborKitDef *named;  /* the kit whose notes have names, or NULL */
  float named_kit;     /* value of its knob */
  unsigned named_own;  /* version of the own kit, if that is it */
  KitThreads *threads; /* while it is open, or NULL */
  KitWorker worker;
  KitPluginPlayer player;
} KitInstrument;

static KitInstrument *kit_of(Instrument *instrument) REALTIME {
  return (KitInstrument *)instrument;
}

static KitPluginPlayer *player_of(Instrument *instrument) REALTIME {
  return &kit_of(instrument)->player;
}

static const KitInstrument *read_only(const Instrument *instrument) REALTIME {
  return (const KitInstrument *)instrument;
}

static bool has_knob(const InstrumentKind *kind, uint32_t id) REALTIME {
  (void)kind;
  return id < KIT_KNOB_COUNT;
}

/* ---- beginning and end ---------------------------------------------------------------------- */

static bool begin(Instrument *instrument) {
  instrument->builder = &kit_of(instrument)->worker.builder;
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++)
    instrument->ranges[i] = kit_knob_range((KitKnobId)i);
  return own_kit_begin(&kit_of(instrument)->own);
}

static void end(Instrument *instrument) {
  KitInstrument *const kit = kit_of(instrument);
  own_kit_end(&kit->own);
  free(kit->named);
}

static void say(void *context, const char *line) { instrument_say(context, line); }

static bool open(Instrument *instrument, double rate) {
  KitInstrument *const kit = kit_of(instrument);
  kit->threads = kit_threads_begin(kit_threads_usual(), true, instrument->pool);
  kit_worker_begin(&kit->worker, rate, &kit->own, kit->threads, say, instrument);
  kit_plugin_player_begin(&kit->player, &kit->worker);
  return true;
}

static void close(Instrument *instrument) {
  kit_plugin_player_end(player_of(instrument));
  kit_worker_end(&kit_of(instrument)->worker);
  kit_threads_end(kit_of(instrument)->threads);
}

static void work(Instrument *instrument) { kit_worker_work(&kit_of(instrument)->worker); }

OwnKit *kit_instrument_own(Instrument *instrument) { return &kit_of(instrument)->own; }

/* ---- kits ----------------------------------------------------------------------------------- */

/* A kit is what its knobs say. */
static void note(Instrument *instrument, InstrumentSetting *setting) {
  (void)instrument;
  (void)setting;
}

static void use(Instrument *instrument, const InstrumentSetting *setting) {
  (void)setting;
  atomic_store(&instrument->is_renamed, true);
}

static void blank(Instrument *instrument, InstrumentSetting *setting) {
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) setting->values[i] = instrument->ranges[i].fallback;
}

static char *text(Instrument *instrument, const InstrumentSetting *setting) {
  (void)setting;
  return own_kit_text(&kit_of(instrument)->own);
}

static bool read(Instrument *instrument, const char *text, size_t length,
                 InstrumentSetting *setting, char *message) {
  (void)setting;
  return own_kit_set(&kit_of(instrument)->own, text, length, message, INSTRUMENT_MESSAGE);
}

static const char *name(float value) {
  return kit_knob_is_own(value) ? OWN : tabor_kit((uint32_t)value)->name;
}

static bool find(const char *name, float *value) {
  *value = (float)kit_knobs[KIT_KNOB_KIT].maximum;
  if (strcmp(name, OWN) == 0) return true;
  for (uint32_t i = 0; i < tabor_kit_count(); i++) {
    if (strcmp(tabor_kit(i)->name, name) != 0) continue;
    *value = (float)i;
    return true;
  }
  return false;
}

static bool load(Instrument *instrument, const char *place, bool is_file,
                 InstrumentSetting *setting, char *message) {
  float *const value = &setting->values[KIT_KNOB_KIT];
  if (is_file) {
    *value = (float)kit_knobs[KIT_KNOB_KIT].maximum;
    return own_kit_load(&kit_of(instrument)->own, place, message, INSTRUMENT_MESSAGE);
  }
  if (strcmp(place, OWN) != 0 && find(place, value)) return true;
  (void)snprintf(message, INSTRUMENT_MESSAGE, "there is no kit '%.80s'", place);
  return false;
}

static bool define(Instrument *instrument, const InstrumentSetting *setting,
                   Definition *definition) {
  definition->is_kit = true;
  return kit_knobs_define(setting->values, &kit_of(instrument)->own, &definition->kit, NULL) ==
         TABOR_OK;
}

/* It becomes the user's own kit, which has the tunings and the room that knobs added. */
static bool redefine(Instrument *instrument, const Definition *definition,
                     InstrumentSetting *setting, char *message) {
  TaborError error;
  char *const text = definition_write_kit(&definition->kit, TABOR_TEXT_KEEP, NULL, &error);
  if (!text) (void)snprintf(message, INSTRUMENT_MESSAGE, "%s", error.message);
  const bool is_read = text && read(instrument, text, strlen(text), setting, message);
  free(text);
  if (!is_read) return false;
  for (uint32_t i = 0; i < KIT_KNOB_DRUMS; i++) setting->values[KIT_KNOB_TUNE + i] = 0;
  setting->values[KIT_KNOB_ROOM] = 0;
  setting->values[KIT_KNOB_KIT] = (float)kit_knobs[KIT_KNOB_KIT].maximum;
  return true;
}

static double tail(const Instrument *instrument) {
  (void)instrument;
  return LONGEST_RING;
}

/* The kit of the knob; NULL if memory is short. */
static const TaborKitDef *named_kit(KitInstrument *kit) {
  const float value = atomic_load(&kit->base.values[KIT_KNOB_KIT]);
  const unsigned own = own_kit_version(&kit->own);
  if (kit->named && kit->named_kit == value && kit->named_own == own) return kit->named;
  if (!kit->named) kit->named = malloc(sizeof *kit->named);
  kit->named_kit = value;
  kit->named_own = own;
  if (kit->named) (void)kit_knob_kit(value, &kit->own, kit->named, NULL);
  return kit->named;
}

/* By the map of the knob. */
static bool name_note(Instrument *instrument, uint32_t note, char *name, size_t size) {
  const uint32_t map = (uint32_t)atomic_load(&instrument->values[KIT_KNOB_NOTES]);
  const TaborKitDef *const kit = named_kit(kit_of(instrument));
  KitMapNote table[MIDI_VALUES];
  kit_map_table(map > 0 ? &kit_maps[map - 1u] : NULL, table);
  for (uint32_t i = 0; kit && i < kit->drum_count; i++) {
    const MidiStroke stroke = kit_midi_stroke(&kit->drum[i], &table[note]);
    if (stroke == MIDI_STROKE_NONE) continue;
    const bool plain = stroke == MIDI_STROKE_HEAD;
    (void)snprintf(name, size, "%s%s%s", kit->drum[i].name, plain ? "" : " ",
                   plain ? "" : midi_stroke_names[stroke]);
    return true;
  }
  return false;
}

/* ---- AUDIO ---------------------------------------------------------------------------------- */

static void rest(Instrument *instrument) REALTIME { kit_plugin_player_rest(player_of(instrument)); }

static void begin_block(Instrument *instrument) REALTIME {
  kit_plugin_player_begin_block(player_of(instrument), &instrument->buffers);
}

static void export_sound(Instrument *instrument, bool exports) REALTIME {
  kit_plugin_player_export(player_of(instrument), exports);
}

static void receive(Instrument *instrument) REALTIME {
  kit_plugin_player_receive(player_of(instrument));
}

static bool ask(Instrument *instrument) REALTIME {
  return kit_plugin_player_ask(player_of(instrument));
}

static void end_leaving(Instrument *instrument) REALTIME {
  kit_plugin_player_end_leaving(player_of(instrument));
}

/* With another kit, or another map of notes, notes have other names. */
static void turn(Instrument *instrument, uint32_t id, float value) REALTIME {
  const bool moves = player_of(instrument)->values[id] != value;
  if (moves && (id == KIT_KNOB_KIT || id == KIT_KNOB_NOTES))
    atomic_store(&instrument->is_renamed, true);
  kit_plugin_player_turn(player_of(instrument), (KitKnobId)id, value);
}

static void take(Instrument *instrument, const MidiMessage *message, uint32_t frame) REALTIME {
  kit_plugin_player_take(player_of(instrument), message, frame);
}

static void choke(Instrument *instrument, int key, uint32_t frame) REALTIME {
  kit_plugin_player_choke(player_of(instrument), key, frame);
}

static void play(Instrument *instrument, uint32_t end) REALTIME {
  kit_plugin_player_play(player_of(instrument), end);
  instrument->at = player_of(instrument)->at;
}

static void play_part(Instrument *instrument, uint32_t part) {
  kit_threads_part(kit_of(instrument)->threads, part);
}

static void strike(Instrument *instrument, const WindowStroke *stroke) REALTIME {
  kit_plugin_player_strike(player_of(instrument), stroke);
}

static void show(Instrument *instrument) REALTIME {
  WindowLink *const link = &instrument->window;
  float struck[TABOR_KIT_DRUMS];
  kit_plugin_player_struck(player_of(instrument), struck);
  if (!atomic_load(&link->is_shown)) return;
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    if (struck[i] > atomic_load(&link->struck[i])) atomic_store(&link->struck[i], struck[i]);
  }
}

static bool is_settled(const Instrument *instrument) REALTIME {
  return kit_plugin_player_is_settled(&read_only(instrument)->player);
}

static bool is_there(const Instrument *instrument) REALTIME { return is_settled(instrument); }

static bool is_silent(const Instrument *instrument) REALTIME {
  return kit_plugin_player_is_silent(&read_only(instrument)->player);
}

const InstrumentCalls kit_instrument = {.size = sizeof(KitInstrument),
                                        .has_knob = has_knob,
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
                                        .name = name,
                                        .find = find,
                                        .tail = tail,
                                        .name_note = name_note,
                                        .rest = rest,
                                        .begin_block = begin_block,
                                        .export_sound = export_sound,
                                        .receive = receive,
                                        .ask = ask,
                                        .end_leaving = end_leaving,
                                        .turn = turn,
                                        .choke = choke,
                                        .take = take,
                                        .play = play,
                                        .play_part = play_part,
                                        .strike = strike,
                                        .show = show,
                                        .is_ready = is_settled,
                                        .is_there = is_there,
                                        .is_settled = is_settled,
                                        .is_silent = is_silent};
