/* SPDX-License-Identifier: MIT */
/* The audio path of a kit: events, pieces, the mix, saved states. */
#include "kit/kit.h"

#include <math.h>
#include <string.h>

#include "air/incident_sound.h"
#include "definition/definition.h"
#include "kernels/flush_denormals.h"
#include "math/checksum.h"
#include "model/model.h"

/* ---- events ---------------------------------------------------------------------------------- */

static void give(TaborKit *kit, uint32_t drum, const TaborEvent *event, uint32_t frame) {
  TbKitVoice *const voice = &kit->voices[drum];
  if (voice->count == TB_KIT_EVENTS) {
    kit->dropped++;
    return;
  }
  voice->events[voice->count] = *event;
  voice->events[voice->count++].frame = frame;
}

/* A stroke silences the other drums of its group. */
static void choke_others(TaborKit *kit, uint32_t drum, uint32_t frame) {
  const TaborEvent silence = {.type = TABOR_EVENT_SILENCE};
  const uint32_t group = kit->voices[drum].choke;
  for (uint32_t i = 0; group != 0 && i < kit->def.drum_count; i++) {
    if (i != drum && kit->voices[i].choke == group) give(kit, i, &silence, frame);
  }
}

static void address(TaborKit *kit, const TaborKitEvent *event, uint32_t frame) {
  if (event->drum == TABOR_KIT_ALL) {
    for (uint32_t i = 0; i < kit->def.drum_count; i++) give(kit, i, &event->event, frame);
  } else if (event->drum >= kit->def.drum_count) {
    kit->dropped++;
  } else {
    if (event->event.type == TABOR_EVENT_STRIKE) choke_others(kit, event->drum, frame);
    give(kit, event->drum, &event->event, frame);
  }
}

/* Hands out the events that act before frame `end` of the block; returns the next one. */
static uint32_t hand_out(TaborKit *kit, const TaborKitEvent *events, uint32_t count, uint32_t next,
                         uint32_t from, uint32_t end, bool last) {
  for (uint32_t i = 0; i < kit->def.drum_count; i++) kit->voices[i].count = 0;
  for (; next < count && (last || events[next].event.frame < end); next++) {
    const uint32_t frame = events[next].event.frame;
    address(kit, &events[next], frame > from ? frame - from : 0);
  }
  return next;
}

/* ---- the air between drums ------------------------------------------------------------------- */

/* Adds what drum `from` said to what another one hears. */
static void hear(const TaborKit *kit, uint32_t from, const TbKitVoice *by, uint32_t frames,
                 float *heard) {
  const TbKitVoice *const source = &kit->voices[from];
  const uint32_t mask = kit->ring - 1;
  const uint64_t start = kit->frame - by->delay[from];
  const float strength = (float)by->strength[from];
  for (uint32_t i = 0; i < frames; i++) {
    heard[i] += strength * source->said[(uint32_t)(start + i) & mask];
  }
}

/* What reaches a drum in this piece; NULL: nothing. */
static const float *listen(const TaborKit *kit, uint32_t drum, uint32_t frames) {
  TbKitVoice *const voice = &kit->voices[drum];
  bool hears = false;
  for (uint32_t i = 0; !kit->muffled && i < kit->def.drum_count; i++) {
    if (i == drum || kit->voices[i].quiet >= kit->ring) continue;
    if (!hears) memset(voice->heard, 0, frames * sizeof(float));
    hear(kit, i, voice, frames, voice->heard);
    hears = true;
  }
  for (uint32_t i = 0; hears && i < frames; i++) {
    if (!(voice->heard[i] > -TB_KIT_LOUDEST)) voice->heard[i] = -TB_KIT_LOUDEST;
    if (voice->heard[i] > TB_KIT_LOUDEST) voice->heard[i] = TB_KIT_LOUDEST;
  }
  return hears ? voice->heard : NULL;
}

/* Two poles and a zero at half the rate, twice; what has died away is exactly 0. */
static double low_pass(const double low[3], double memory[2], double in) {
  static const double VANISHED = 1e-9; /* [Pa] */
  const double kept = in - low[1] * memory[0] - low[2] * memory[1];
  const double out = low[0] * (kept + 2.0 * memory[0] + memory[1]);
  memory[1] = memory[0];
  memory[0] = kept;
  if (in == 0.0 && fabs(kept) < VANISHED && fabs(memory[1]) < VANISHED) {
    memory[0] = memory[1] = 0.0;
    return 0.0;
  }
  return out;
}

/* Keeps what a drum says for the others. */
static void say(TaborKit *kit, TbKitVoice *voice, const float *said, uint32_t frames) {
  for (uint32_t i = 0; i < frames; i++) {
    const float passed = (float)low_pass(kit->low, voice->passed, (double)said[i]);
    voice->quiet = passed != 0.0f ? 0 : voice->quiet + (voice->quiet < kit->ring);
    voice->said[(uint32_t)(kit->frame + i) & (kit->ring - 1)] = passed;
  }
}

/* True if the air has given drums no more than what it may have caught of their sound. */
static bool air_is_passive(const TaborKit *kit) {
  double radiated = 0.0, work = 0.0;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    const TbState *const state = kit->voices[i].drum->state;
    radiated += state->ledger.sums.radiated - state->ledger.radiated_beyond;
    work += state->ledger.sound_work;
  }
  return work <= TB_KIT_CAUGHT * radiated;
}

/* ---- one piece ------------------------------------------------------------------------------- */

/* The mix needs three of the microphones. */
static bool is_wanted(const TbKitVoice *voice, uint32_t mic, float *const *mics) {
  if (mic == voice->air) return false;
  if (mic == voice->left || mic == voice->right || mic == voice->close) return true;
  return mics && mics[mic];
}

/* A TaborKitJob: the drum's part of the piece, on any thread. It writes to nothing but its voice. */
static void play(void *context, uint32_t drum) {
  TaborKit *const kit = context;
  const TbFpMode mode = tb_fp_enter();
  TbKitVoice *const voice = &kit->voices[drum];
  const TaborKitOutputs *const to = kit->outputs;
  const uint32_t frames = kit->frames;
  float said[TB_KIT_PIECE];
  float *outputs[TABOR_MAX_MICS];
  const bool coupled = kit->def.coupled && voice->air != TB_NO_MIC;
  const TbDrumAir air = {.mic = coupled ? voice->air : 0,
                         .low = true,
                         .incident = coupled ? listen(kit, drum, frames) : NULL,
                         .wake = voice->wake,
                         .tap = voice->air,
                         .tapped = coupled ? said : NULL};
  memset(said, 0, frames * sizeof *said);
  for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) {
    outputs[mic] = is_wanted(voice, mic, to ? to->mic[drum] : NULL) ? voice->sound[mic] : NULL;
    memset(voice->sound[mic], 0, frames * sizeof(float));
  }
  tb_drum_process(voice->drum, voice->events, voice->count, &air, outputs, frames);
  memcpy(voice->heard, said, frames * sizeof *said); /* only said once all drums have heard */
  if (tabor_drum_model(voice->drum) != voice->model) tb_kit_voice_bind(kit, drum);
  tb_fp_leave(mode);
}

static double sample_of(const TbKitVoice *voice, uint32_t mic, uint32_t frame) {
  return mic == TB_NO_MIC ? 0.0 : (double)voice->sound[mic][frame];
}

static void play_all(TaborKit *kit, const TaborKitOutputs *outputs, uint32_t frames) {
  kit->outputs = outputs;
  kit->frames = frames;
  if (kit->run) {
    kit->run(kit->run_context, play, kit, kit->def.drum_count);
    return;
  }
  for (uint32_t i = 0; i < kit->def.drum_count; i++) play(kit, i);
}

typedef struct Mix {
  float overheads[2][TB_KIT_PIECE]; /* which the room hears */
  float close[2][TB_KIT_PIECE];
} Mix;

static void mix_drum(const TbKitVoice *voice, uint32_t at, uint32_t frames, float *const part[2],
                     Mix *mix) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double close = sample_of(voice, voice->close, frame);
    const double pair[2] = {sample_of(voice, voice->left, frame),
                            sample_of(voice, voice->right, frame)};
    for (int side = 0; side < 2; side++) {
      const float far_part = (float)(voice->overhead * pair[side]);
      const float close_part = (float)(voice->pan[side] * close);
      mix->overheads[side][frame] += far_part;
      mix->close[side][frame] += close_part;
      if (part[side]) part[side][at + frame] = far_part + close_part;
    }
  }
}

static void give_mics(const TbKitVoice *voice, uint32_t at, uint32_t frames,
                      float *const mics[TABOR_MAX_MICS]) {
  for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) {
    if (mics[mic]) memcpy(mics[mic] + at, voice->sound[mic], frames * sizeof(float));
  }
}

static void play_piece(TaborKit *kit, const TaborKitOutputs *outputs, uint32_t at,
                       uint32_t frames) {
  Mix mix;
  float *none[2] = {NULL, NULL};
  memset(&mix, 0, sizeof mix);
  play_all(kit, outputs, frames);
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    TbKitVoice *const voice = &kit->voices[i];
    if (kit->def.coupled) say(kit, voice, voice->heard, frames);
    mix_drum(voice, at, frames, outputs ? outputs->drum[i] : none, &mix);
    if (outputs) give_mics(voice, at, frames, outputs->mic[i]);
  }
  for (int side = 0; side < 2; side++) {
    for (uint32_t i = 0; i < frames; i++) mix.close[side][i] += mix.overheads[side][i];
  }
  const float *const dry[2] = {mix.overheads[0], mix.overheads[1]};
  float *const wet[2] = {mix.close[0], mix.close[1]};
  tabor_room_process(kit->room, dry, wet, frames);
  for (int side = 0; outputs && side < 2; side++) {
    if (outputs->stereo[side]) {
      memcpy(outputs->stereo[side] + at, mix.close[side], frames * sizeof(float));
    }
  }
  kit->frame += frames;
  if (kit->def.coupled && kit->frame % TB_KIT_PIECE == 0) kit->muffled = !air_is_passive(kit);
}

/* Pieces end where the air is judged, whatever the blocks. */
static uint32_t next_piece(const TaborKit *kit, uint32_t left) {
  const uint32_t until = TB_KIT_PIECE - (uint32_t)(kit->frame % TB_KIT_PIECE);
  const uint32_t most = kit->piece < until ? kit->piece : until;
  return left < most ? left : most;
}

void tabor_kit_process(TaborKit *kit, const TaborKitEvent *events, uint32_t count,
                       const TaborKitOutputs *outputs, uint32_t frames) {
  const TbFpMode mode = tb_fp_enter();
  uint32_t next = 0, at = 0;
  do {
    const uint32_t part = next_piece(kit, frames - at);
    next = hand_out(kit, events, count, next, at, at + part, at + part == frames);
    play_piece(kit, outputs, at, part);
    at += part;
  } while (at < frames);
  tb_fp_leave(mode);
}

/* ---- the kit as a whole ---------------------------------------------------------------------- */

bool tabor_kit_is_silent(const TaborKit *kit) {
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    if (!tabor_drum_is_silent(kit->voices[i].drum)) return false;
  }
  return tabor_room_is_silent(kit->room);
}

void tabor_kit_reset(TaborKit *kit) {
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    TbKitVoice *const voice = &kit->voices[i];
    tabor_drum_reset(voice->drum);
    memset(voice->said, 0, kit->ring * sizeof *voice->said);
    voice->quiet = kit->ring;
    voice->passed[0] = voice->passed[1] = 0.0;
  }
  kit->muffled = false;
  tabor_room_reset(kit->room);
  kit->frame = kit->dropped = 0;
}

void tabor_kit_set_runner(TaborKit *kit, TaborKitRun *run, void *context) {
  kit->run = run;
  kit->run_context = context;
}

uint64_t tabor_kit_dropped(const TaborKit *kit) { return kit->dropped; }

const TaborDrum *tabor_kit_drum(const TaborKit *kit, uint32_t drum) {
  return drum < kit->def.drum_count ? kit->voices[drum].drum : NULL;
}

const TaborKitDef *tabor_kit_definition(const TaborKit *kit) { return &kit->def; }

/* ---- saved states ---------------------------------------------------------------------------- */

static const double LOUDEST = 1e15; /* as of a drum's state */

/* Before the drums' states, each with its ring, and the room's. */
typedef struct StateHead {
  uint64_t size, frame, dropped, muffled, sum; /* sum: of all rings */
  double passed[TABOR_KIT_DRUMS][2];
} StateHead;

static size_t ring_bytes(const TaborKit *kit) { return kit->ring * sizeof(float); }

size_t tabor_kit_state_size(const TaborKit *kit) {
  size_t size = sizeof(StateHead) + tabor_room_state_size(kit->room);
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    size += tabor_drum_state_size(kit->voices[i].drum) + ring_bytes(kit);
  }
  return size;
}

void tabor_kit_state_save(const TaborKit *kit, void *bytes) {
  StateHead head = {.size = tabor_kit_state_size(kit),
                    .frame = kit->frame,
                    .dropped = kit->dropped,
                    .muffled = kit->muffled};
  char *at = (char *)bytes + sizeof head;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    const TbKitVoice *const voice = &kit->voices[i];
    memcpy(at, voice->said, ring_bytes(kit));
    head.sum = head.sum * 31u + tb_checksum(at, ring_bytes(kit));
    memcpy(head.passed[i], voice->passed, sizeof voice->passed);
    tabor_drum_state_save(voice->drum, at + ring_bytes(kit));
    at += ring_bytes(kit) + tabor_drum_state_size(voice->drum);
  }
  tabor_room_state_save(kit->room, at);
  memcpy(bytes, &head, sizeof head);
}

/* Of the rings' frames those count that come before the kit's. */
static uint32_t quiet_frames(const TaborKit *kit, const TbKitVoice *voice) {
  uint32_t quiet = 0;
  while (quiet < kit->ring &&
         voice->said[(uint32_t)(kit->frame - 1 - quiet) & (kit->ring - 1)] == 0.0f) {
    quiet++;
  }
  return quiet;
}

static bool load_ring(TaborKit *kit, TbKitVoice *voice, const char *bytes, uint64_t *sum) {
  memcpy(voice->said, bytes, ring_bytes(kit));
  *sum = *sum * 31u + tb_checksum(bytes, ring_bytes(kit));
  bool sounds = true;
  for (uint32_t i = 0; i < kit->ring; i++) sounds &= fabs((double)voice->said[i]) <= LOUDEST;
  voice->quiet = quiet_frames(kit, voice);
  return sounds;
}

static bool load(TaborKit *kit, const char *at, const StateHead *head) {
  uint64_t sum = 0;
  kit->frame = head->frame;
  kit->dropped = head->dropped;
  kit->muffled = head->muffled != 0;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    TbKitVoice *const voice = &kit->voices[i];
    const size_t size = tabor_drum_state_size(voice->drum);
    if (!load_ring(kit, voice, at, &sum)) return false;
    for (int k = 0; k < 2; k++) {
      if (!(fabs(head->passed[i][k]) <= LOUDEST)) return false;
      voice->passed[k] = head->passed[i][k];
    }
    if (tabor_drum_state_load(voice->drum, at + ring_bytes(kit), size) != TABOR_OK) return false;
    at += ring_bytes(kit) + size;
  }
  return sum == head->sum &&
         tabor_room_state_load(kit->room, at, tabor_room_state_size(kit->room)) == TABOR_OK;
}

TaborStatus tabor_kit_state_load(TaborKit *kit, const void *bytes, size_t size) {
  StateHead head;
  if (!bytes || size != tabor_kit_state_size(kit)) return TABOR_ERROR_STATE;
  memcpy(&head, bytes, sizeof head);
  if (head.size != size) return TABOR_ERROR_STATE;
  if (load(kit, (const char *)bytes + sizeof head, &head)) return TABOR_OK;
  tabor_kit_reset(kit);
  return TABOR_ERROR_STATE;
}
