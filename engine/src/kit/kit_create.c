/* SPDX-License-Identifier: MIT */
/* Set-up of kits: drums, ways between them, the room. */
#include <math.h>
#include <string.h>

#include "air/incident_sound.h"
#include "definition/definition.h"
#include "definition/error.h"
#include "kit/kit.h"
#include "kit/kit_def.h"
#include "kit/kit_place.h"
#include "math/arena.h"
#include "math/portable_math.h"
#include "model/model.h"

/* ---- the mix --------------------------------------------------------------------------------- */

static void prepare_mix(TbKitVoice *voice, const TaborKitDrumDef *def) {
  const double gain = tb_kit_factor(def->gain);
  double right, left;
  tb_sin_cos_degrees(45.0 * (1.0 + def->pan), &right, &left);
  voice->pan[0] = gain * left;
  voice->pan[1] = gain * right;
  voice->choke = def->choke;
}

/* ---- ways between drums ---------------------------------------------------------------------- */

/* From the drum's centre to the nearest point of a head, towards the others [frames]. */
static double head_start(const TbKitVoice *voice) {
  const TaborModel *const model = voice->model;
  if (voice->air == TB_NO_MIC) return 0.0;
  const TaborMicDef *const mic = &model->def.mic[voice->air];
  const double way = tb_hypot(mic->radius, mic->height) / model->def.air.sound_speed;
  return way * model->sample_rate - (double)model->mics[voice->air].travel / model->steps;
}

/* The shortest way between heads [s], 11 cm: what is nearer is heard this much late, so that the
 * drums of a kit are computed many samples at once, and seldom wait for each other on several
 * threads. */
static const double LEAST_WAY = 1.0 / 3000.0;

/* At the distance of the kit's microphone a drum's pressure is what it says; it falls with the
 * distance. */
static void prepare_way(TaborKit *kit, uint32_t to, uint32_t from) {
  TbKitVoice *const voice = &kit->voices[to];
  const TaborDrumDef *const def = &kit->voices[from].model->def;
  const double distance =
    tb_kit_distance(tb_kit_drum_place(&kit->def.drum[to]), tb_kit_drum_place(&kit->def.drum[from]));
  const double frames = distance / def->air.sound_speed * voice->model->sample_rate -
                        head_start(voice) - head_start(&kit->voices[from]);
  const double least = ceil(LEAST_WAY * voice->model->sample_rate);
  voice->delay[from] = (uint32_t)(frames < least ? least : frames);
  if (kit->voices[from].air == TB_NO_MIC || voice->air == TB_NO_MIC) return;
  const TaborMicDef *const mic = &def->mic[kit->voices[from].air];
  const double near = distance > 0.05 ? distance : 0.05; /* [m] */
  voice->strength[from] =
    tb_kit_factor(kit->def.coupling) * tb_hypot(mic->radius, mic->height) / near;
}

/* A low-pass of Butterworth's of second order by the bilinear rule: g (1 + 1/z)^2/(1 + low[1]/z +
 * low[2]/z^2), with t = tan(pi f/rate). */
static void prepare_low_pass(TaborKit *kit, double rate) {
  double sine, cosine;
  tb_sin_cos_degrees(180.0 * TB_KIT_HIGHEST / rate, &sine, &cosine);
  const double t = sine / cosine, root = 1.4142135623730951 * t;
  const double bottom = 1.0 + root + t * t;
  kit->low[0] = t * t / bottom;
  kit->low[1] = 2.0 * (t * t - 1.0) / bottom;
  kit->low[2] = (1.0 - root + t * t) / bottom;
}

static void prepare_ways(TaborKit *kit) {
  uint32_t longest = 1, shortest = TB_KIT_PIECE;
  for (uint32_t to = 0; to < kit->def.drum_count; to++) {
    for (uint32_t from = 0; from < kit->def.drum_count; from++) {
      if (to == from || !kit->def.coupled) continue;
      prepare_way(kit, to, from);
      const uint32_t delay = kit->voices[to].delay[from];
      if (delay > longest) longest = delay;
      if (delay < shortest) shortest = delay;
    }
  }
  kit->piece = shortest;
  kit->ring = 1;
  while (kit->ring < longest + TB_KIT_PIECE) kit->ring *= 2;
}

/* ---- the room -------------------------------------------------------------------------------- */

/* The room asks for a drum: one of no importance 0.7 m above the floor, in the middle under the
 * overheads. */
static TaborStatus create_room(TaborKit *kit, double rate, TaborError *error) {
  static const double DRUM_HEIGHT = 0.7; /* [m], as in room/room.h */
  static const char *const NAMES[2] = {TABOR_KIT_LEFT, TABOR_KIT_RIGHT};
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.room = kit->def.room;
  def.mic_count = 2;
  for (int side = 0; side < 2; side++) {
    const TbPoint place = tb_kit_overhead(&kit->def, side);
    const double height = place.z - DRUM_HEIGHT;
    def.mic[side] = (TaborMicDef){.radius = tb_hypot(place.x, place.y),
                                  .angle = tb_arc_degrees(place.y, place.x),
                                  .height = fabs(height) < 0.01 ? 0.01 : height,
                                  .gain = 1.0};
    memcpy(def.mic[side].name, NAMES[side], strlen(NAMES[side]) + 1);
  }
  return tabor_room_create(&def, rate, &kit->allocator, &kit->room, error);
}

/* ---- create and destroy ---------------------------------------------------------------------- */

static TaborStatus memory_error(TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_MEMORY, NULL, NULL, NAN, NAN,
                      "out of memory while creating a kit");
}

static TaborStatus check_models(const TaborKitDef *def, TaborModel *const *models,
                                TaborError *error) {
  if (!models) return tb_error_null(error, "array of models");
  if (def->drum_count == 0) {
    return tb_error_set(error, TABOR_ERROR_ARGUMENT, "drum", NULL, NAN, NAN, "the kit has no drum");
  }
  for (uint32_t i = 0; i < def->drum_count; i++) {
    if (!models[i]) return tb_error_null(error, "model of a drum");
    if (models[i]->sample_rate == models[0]->sample_rate) continue;
    return tb_error_set(error, TABOR_ERROR_ARGUMENT, "sample_rate", NULL, models[0]->sample_rate,
                        models[0]->sample_rate,
                        "%s: its model is for %g Hz, the first one's for %g", def->drum[i].name,
                        models[i]->sample_rate, models[0]->sample_rate);
  }
  return TABOR_OK;
}

static TaborStatus create_voices(TaborKit *kit, TaborModel *const *models, TaborError *error) {
  const size_t size = kit->def.drum_count * sizeof *kit->voices;
  kit->voices = kit->allocator.allocate(size, kit->allocator.context);
  if (!kit->voices) return memory_error(error);
  memset(kit->voices, 0, size);
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    TbKitVoice *const voice = &kit->voices[i];
    voice->before = TABOR_KIT_NEW;
    const TaborStatus status = tabor_drum_create(models[i], &voice->drum, error);
    if (status != TABOR_OK) return status;
    tb_kit_voice_bind(kit, i);
    prepare_mix(voice, &kit->def.drum[i]);
  }
  prepare_ways(kit);
  prepare_low_pass(kit, models[0]->sample_rate);
  kit->ramp = (uint32_t)(TB_LIVE_TIME * models[0]->sample_rate);
  kit->samples.fade = (uint32_t)(TB_KIT_SAMPLE_FADE * models[0]->sample_rate);
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    kit->voices[i].said =
      kit->allocator.allocate(kit->ring * sizeof(float), kit->allocator.context);
    if (!kit->voices[i].said) return memory_error(error);
  }
  return TABOR_OK;
}

TaborStatus tabor_kit_create(const TaborKitDef *def, TaborModel *const *models, TaborKit **out,
                             TaborError *error) {
  if (!out) return tb_error_null(error, "place for the kit");
  *out = NULL;
  TaborStatus status = tabor_kit_def_validate(def, error);
  if (status == TABOR_OK) status = check_models(def, models, error);
  if (status != TABOR_OK) return status;
  const TaborAllocator allocator = models[0]->arena.allocator;
  TaborKit *const kit = allocator.allocate(sizeof *kit, allocator.context);
  if (!kit) return memory_error(error);
  memset(kit, 0, sizeof *kit);
  kit->allocator = allocator;
  kit->def = *def;
  status = create_voices(kit, models, error);
  if (status == TABOR_OK) status = create_room(kit, models[0]->sample_rate, error);
  if (status != TABOR_OK) {
    tabor_kit_destroy(kit);
    return status;
  }
  tabor_kit_reset(kit);
  *out = kit;
  return tb_error_clear(error);
}

void tabor_kit_destroy(TaborKit *kit) {
  if (!kit) return;
  const TaborAllocator allocator = kit->allocator;
  for (uint32_t i = 0; kit->voices && i < kit->def.drum_count; i++) {
    tabor_drum_destroy(kit->voices[i].drum);
    for (uint32_t k = 0; k < TB_KIT_SWAPS; k++) tabor_swap_destroy(kit->voices[i].swaps[k]);
    if (kit->voices[i].said) allocator.release(kit->voices[i].said, allocator.context);
  }
  if (kit->voices) allocator.release(kit->voices, allocator.context);
  tabor_room_destroy(kit->room);
  tb_kit_samples_free(&kit->samples, &allocator);
  allocator.release(kit, allocator.context);
}

/* ---- sounds of notes ------------------------------------------------------------------------- */

TaborStatus tabor_kit_set_sample(TaborKit *kit, uint32_t note, const float *left,
                                 const float *right, uint32_t frames, double rate,
                                 TaborError *error) {
  static const double LEAST = 1e3, MOST = 1e6; /* [Hz] */
  if (!kit) return tb_error_null(error, "kit");
  if (!left) return tb_error_null(error, "left side");
  if (note >= TABOR_KIT_NOTES) {
    return tb_error_set(error, TABOR_ERROR_ARGUMENT, "note", NULL, 0.0, TABOR_KIT_NOTES - 1,
                        "note %u; allowed: 0 to %d", (unsigned)note, TABOR_KIT_NOTES - 1);
  }
  if (!(rate >= LEAST && rate <= MOST)) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "rate", NULL, LEAST, MOST,
                        "a sample rate of %g Hz; allowed: %g to %g", rate, LEAST, MOST);
  }
  const double own = kit->voices[0].model->sample_rate;
  const bool is_set = tb_kit_sample_set(&kit->samples.notes[note], &kit->def.note[note], left,
                                        right, frames, rate, own, &kit->allocator);
  return is_set ? tb_error_clear(error) : memory_error(error);
}
