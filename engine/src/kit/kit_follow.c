/* SPDX-License-Identifier: MIT */
/* A kit that goes on with the drums of another one while they ring.
 *
 * Both kits are whole. The follower exchanges drums with the one before: a drum of the same model
 * goes on as it is, one of another model swaps (drum/swap.c). Drums that are left and a room that
 * is another one ring on in the former kit. Sound on its way in the air goes on as far as the
 * shorter of both rings reaches. */
#include <math.h>
#include <string.h>

#include "definition/error.h"
#include "kit/kit.h"
#include "model/model.h"
#include "room/room.h"

/* ---- set-up ---------------------------------------------------------------------------------- */

static TaborStatus refuse(TaborError *error, const char *what) {
  return tb_error_set(error, TABOR_ERROR_ARGUMENT, NULL, NULL, NAN, NAN, "%s", what);
}

static TaborStatus check(const TaborKit *kit, const TaborKit *from, const uint8_t *drums,
                         TaborError *error) {
  bool taken[TABOR_KIT_DRUMS] = {false};
  if (!kit || !from || !drums) return tb_error_null(error, "kit, or its list of drums,");
  if (kit == from || kit->follows) return refuse(error, "the kit follows one other, once");
  if (kit->voices[0].model->sample_rate != from->voices[0].model->sample_rate) {
    return refuse(error, "the kits have two sample rates");
  }
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    if (drums[i] == TABOR_KIT_NEW) continue;
    if (drums[i] >= from->def.drum_count || taken[drums[i]]) {
      return refuse(error, "a drum goes on with one that is not there, or that another one has");
    }
    taken[drums[i]] = true;
  }
  return TABOR_OK;
}

static TaborStatus prepare(TbKitVoice *voice, const TbKitVoice *from, TaborError *error) {
  TaborModel *const before = (TaborModel *)from->model, *const after = (TaborModel *)voice->model;
  return before == after ? TABOR_OK : tabor_swap_create(before, after, &voice->swaps[0], error);
}

static void forget(TaborKit *kit) {
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    tabor_swap_destroy(kit->voices[i].swaps[0]);
    kit->voices[i].swaps[0] = NULL;
    kit->voices[i].before = TABOR_KIT_NEW;
  }
}

TaborStatus tabor_kit_follow(TaborKit *kit, const TaborKit *from, const uint8_t *drums,
                             TaborError *error) {
  TaborStatus status = check(kit, from, drums, error);
  if (status != TABOR_OK) return status;
  for (uint32_t i = 0; i < kit->def.drum_count && status == TABOR_OK; i++) {
    kit->voices[i].before = drums[i];
    if (drums[i] != TABOR_KIT_NEW) {
      status = prepare(&kit->voices[i], &from->voices[drums[i]], error);
    }
  }
  if (status != TABOR_OK) {
    forget(kit);
    return status;
  }
  kit->follows = from;
  kit->has_sounds = memcmp(kit->def.note, from->def.note, sizeof kit->def.note) == 0;
  return tb_error_clear(error);
}

/* ---- on the audio thread --------------------------------------------------------------------- */

/* The sound of drum `from`, as far as it may still be heard. */
static void take_sound(TaborKit *kit, TbKitVoice *voice, const TaborKit *other,
                       const TbKitVoice *from) {
  const uint32_t reach = kit->ring < other->ring ? kit->ring : other->ring;
  for (uint32_t i = 1; i <= reach; i++) {
    const uint32_t frame = (uint32_t)(kit->frame - i);
    voice->said[frame & (kit->ring - 1)] = from->said[frame & (other->ring - 1)];
  }
  memcpy(voice->passed, from->passed, sizeof voice->passed);
  voice->quiet = from->quiet < reach ? from->quiet : kit->ring;
}

/* Swaps whose sound the drum still has go with it; the others are left to be destroyed. */
static void take_swaps(TbKitVoice *voice, TbKitVoice *from) {
  uint32_t place = 1;
  for (uint32_t i = 0; i < TB_KIT_SWAPS && place < TB_KIT_SWAPS; i++) {
    if (!from->swaps[i] || tabor_swap_done(from->swaps[i])) continue;
    voice->swaps[place++] = from->swaps[i];
    from->swaps[i] = NULL;
  }
}

static void take_drum(TaborKit *kit, uint32_t drum, TaborKit *from) {
  TbKitVoice *const voice = &kit->voices[drum], *const other = &from->voices[voice->before];
  TaborDrum *const rings = other->drum;
  other->drum = voice->drum;
  other->gone = true;
  voice->drum = rings;
  take_sound(kit, voice, from, other);
  take_swaps(voice, other);
  if (voice->swaps[0]) {
    const TaborEvent swap = {.type = TABOR_EVENT_SWAP, .swap = voice->swaps[0]};
    tabor_drum_process(voice->drum, &swap, 1, NULL, 0);
  }
  tb_kit_voice_bind(kit, drum);
  tb_kit_voice_bind(from, voice->before);
}

/* The air's account has all that its drums were given and gave. */
static void leave_drums(TaborKit *kit, const TaborKit *from) {
  bool stays[TABOR_KIT_DRUMS] = {false};
  kit->left = from->left;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    if (kit->voices[i].before != TABOR_KIT_NEW) stays[kit->voices[i].before] = true;
  }
  for (uint32_t i = 0; i < from->def.drum_count; i++) {
    const TbAirEnergy energy = tb_drum_air_energy(from->voices[i].drum);
    if (stays[i]) continue;
    kit->left.radiated += energy.radiated;
    kit->left.work += energy.work;
  }
}

/* From where they are to what this kit's definition says; the coupling's factor is beside the
 * definition's. */
static void take_values(TaborKit *kit, const TaborKit *from) {
  const double ratio = tb_kit_factor(from->def.coupling) / tb_kit_factor(kit->def.coupling);
  kit->overheads.now = from->overheads.now;
  kit->coupling.now = from->coupling.now * ratio;
  tb_live_move(&kit->overheads, kit->overheads.target, kit->frame == 0 ? 0 : kit->ramp);
  tb_live_move(&kit->coupling, 1.0, kit->frame == 0 ? 0 : kit->ramp);
}

static void take_sounds(TaborKit *kit, TaborKit *from) {
  const TbKitSamples own = kit->samples;
  kit->samples.shots.gain = from->samples.shots.gain;
  if (!kit->has_sounds) return;
  kit->samples = from->samples;
  from->samples = own;
}

void tabor_kit_take_over(TaborKit *kit, TaborKit *from) {
  if (!kit->follows || kit->follows != from) return;
  kit->frame = from->frame;
  kit->dropped = from->dropped;
  kit->muffled = from->muffled;
  leave_drums(kit, from);
  take_values(kit, from);
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    if (kit->voices[i].before != TABOR_KIT_NEW) take_drum(kit, i, from);
  }
  take_sounds(kit, from);
  if (tb_room_is_same(kit->room, from->room)) {
    TaborRoom *const room = kit->room;
    kit->room = from->room;
    from->room = room;
  }
  kit->follows = NULL;
}
