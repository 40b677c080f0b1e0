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

/* A drum of the piece, as its events know it. */
typedef struct Listener {
  const TaborKit *kit;
  uint32_t drum;
} Listener;

static bool is_choked(const Listener *by, const TaborKitEvent *event) {
  const TbKitVoice *const voices = by->kit->voices;
  if (event->event.type != TABOR_EVENT_STRIKE || event->drum >= by->kit->def.drum_count) {
    return false;
  }
  return voices[by->drum].choke != 0 && voices[by->drum].choke == voices[event->drum].choke;
}

/* A TbEventAddress. A stroke silences the other drums of its group. */
static const TaborEvent *address(const void *context, uint32_t index) {
  static const TaborEvent SILENCE = {.type = TABOR_EVENT_SILENCE};
  const Listener *const to = context;
  const TaborKitEvent *const event = &to->kit->now.events[index];
  if (event->drum == to->drum || event->drum == TABOR_KIT_ALL) return &event->event;
  return is_choked(to, event) ? &SILENCE : NULL;
}

static TbEventList events_for(const Listener *listener) {
  const TbKitPiece *const piece = &listener->kit->now;
  return (TbEventList){.first = piece->events ? &piece->events->event : NULL,
                       .stride = sizeof *piece->events,
                       .next = piece->next,
                       .count = piece->count,
                       .start = piece->start,
                       .last = piece->last,
                       .address = address,
                       .context = listener};
}

/* The note for whose sound the event is, or TABOR_KIT_NOTES. */
static uint32_t note_of(const TaborKitEvent *event) {
  const uint32_t note = event->drum - TABOR_KIT_NOTE;
  return note < TABOR_KIT_NOTES ? note : TABOR_KIT_NOTES;
}

/* Passes over the piece's events once the drums have played them; counts those that are for none.
 */
static void pass_events(TaborKit *kit) {
  TbKitPiece *const piece = &kit->now;
  const uint32_t end = piece->start + piece->frames;
  for (; piece->next < piece->count; piece->next++) {
    const TaborKitEvent *const event = &piece->events[piece->next];
    if (!piece->last && event->event.frame >= end) return;
    const bool is_kits = event->drum == TABOR_KIT_ALL || event->drum == TABOR_KIT_MIX ||
                         note_of(event) < TABOR_KIT_NOTES;
    kit->dropped += event->drum >= kit->def.drum_count && !is_kits;
  }
}

/* ---- live values ----------------------------------------------------------------------------- */

static void move_to(const TaborKit *kit, TbLiveParam *live, double target) {
  tb_live_move(live, target, kit->frame == 0 ? 0 : kit->ramp); /* at once: nothing was heard yet */
}

/* False: the event is dropped. */
static bool set_value(TaborKit *kit, const TaborEvent *event) {
  const double value = event->value;
  if (event->type != TABOR_EVENT_PARAMETER || !(value >= -120.0 && value <= 24.0)) return false;
  if (event->parameter == TABOR_KIT_OVERHEADS) {
    move_to(kit, &kit->overheads, tb_kit_factor(value));
    return true;
  }
  if (event->parameter == TABOR_KIT_SAMPLES) {
    move_to(kit, &kit->samples.shots.gain, tb_kit_factor(value));
    return true;
  }
  const bool is_coupling = event->parameter == TABOR_KIT_COUPLING && kit->def.coupled;
  if (!is_coupling || (value < -60.0 && value > -120.0)) return false;
  move_to(kit, &kit->coupling, tb_kit_factor(value) / tb_kit_factor(kit->def.coupling));
  return true;
}

/* The kit's own part of an event: values and sounds of notes. `offset` is its frame of the
 * piece. */
static void act(TaborKit *kit, const TaborKitEvent *event, uint32_t offset) {
  const uint32_t note = note_of(event), type = event->event.type;
  const bool ends = type == TABOR_EVENT_SILENCE || type == TABOR_EVENT_RESET;
  if (event->drum == TABOR_KIT_MIX) {
    kit->dropped += !set_value(kit, &event->event);
  } else if (note < TABOR_KIT_NOTES) {
    const bool acts = tb_kit_samples_act(&kit->samples, note, &event->event, offset);
    kit->dropped += !acts && !(kit->def.note[note].sample[0] && !kit->samples.notes[note].sound[0]);
  } else if (event->drum == TABOR_KIT_ALL && ends) {
    tb_kit_samples_silence(&kit->samples, offset);
  }
}

/* Events from `next` on that act by frame `until` of the block; returns the first that does not. */
static uint32_t act_until(TaborKit *kit, uint32_t next, uint32_t until, uint32_t offset) {
  const TbKitPiece *const piece = &kit->now;
  for (; next < piece->count && piece->events[next].event.frame <= until; next++) {
    act(kit, &piece->events[next], offset);
  }
  return next;
}

/* Factors of each frame of the piece; what comes past the block's end acts at its last frame, as in
 * a drum. */
static void follow_values(TaborKit *kit) {
  TbKitPiece *const piece = &kit->now;
  uint32_t next = piece->next;
  for (uint32_t i = 0; i < piece->frames; i++) {
    const bool is_last = piece->last && i + 1 == piece->frames;
    next = act_until(kit, next, is_last ? UINT32_MAX : piece->start + i, i);
    piece->overheads[i] = tb_live_next(&kit->overheads);
    piece->coupling[i] = (float)tb_live_next(&kit->coupling);
    piece->sounds[i] = (float)tb_live_next(&kit->samples.shots.gain);
  }
  if (piece->last) (void)act_until(kit, next, UINT32_MAX, piece->frames);
}

static void reset_values(TaborKit *kit) {
  tb_live_move(&kit->overheads, tb_kit_factor(kit->def.overheads), 0);
  tb_live_move(&kit->coupling, 1.0, 0);
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
    heard[i] += strength * kit->now.coupling[i] * source->said[(uint32_t)(start + i) & mask];
  }
}

/* The sound that reaches a drum in this piece; NULL: nothing. */
static const float *listen(const TaborKit *kit, uint32_t drum, uint32_t frames) {
  TbKitVoice *const voice = &kit->voices[drum];
  bool hears = false;
  const bool deaf = kit->muffled || voice->gone;
  for (uint32_t i = 0; !deaf && i < kit->def.drum_count; i++) {
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
  double radiated = kit->left.radiated, work = kit->left.work;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    const TbAirEnergy energy = tb_drum_air_energy(kit->voices[i].drum);
    radiated += energy.radiated;
    work += energy.work;
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

/* A TaborKitJob: the drum's part of the piece, on any thread. It writes to nothing but its voice.
 */
static void play(void *context, uint32_t drum) {
  TaborKit *const kit = context;
  const TbFpMode mode = tb_fp_enter();
  TbKitVoice *const voice = &kit->voices[drum];
  const TaborKitOutputs *const to = kit->now.outputs;
  const uint32_t frames = kit->now.frames;
  const Listener listener = {.kit = kit, .drum = drum};
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
  tb_drum_process(voice->drum, events_for(&listener), &air, outputs, frames);
  memcpy(voice->heard, said, frames * sizeof *said); /* only said once all drums have heard */
  if (tabor_drum_model(voice->drum) != voice->model) tb_kit_voice_bind(kit, drum);
  tb_fp_leave(mode);
}

static double sample_of(const TbKitVoice *voice, uint32_t mic, uint32_t frame) {
  return mic == TB_NO_MIC ? 0.0 : (double)voice->sound[mic][frame];
}

static void play_all(TaborKit *kit) {
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

static void mix_drum(const TaborKit *kit, const TbKitVoice *voice, float *const part[2], Mix *mix) {
  const uint32_t at = kit->now.start, frames = kit->now.frames;
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double overhead = kit->now.overheads[frame] * voice->full_scale / kit->def.full_scale;
    const double close = sample_of(voice, voice->close, frame);
    const double pair[2] = {sample_of(voice, voice->left, frame),
                            sample_of(voice, voice->right, frame)};
    for (int side = 0; side < 2; side++) {
      const float far_part = (float)(overhead * pair[side]);
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

static void play_piece(TaborKit *kit) {
  const TaborKitOutputs *const outputs = kit->now.outputs;
  const uint32_t at = kit->now.start, frames = kit->now.frames;
  Mix mix;
  float *none[2] = {NULL, NULL};
  memset(&mix, 0, sizeof mix);
  follow_values(kit);
  play_all(kit);
  pass_events(kit);
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    TbKitVoice *const voice = &kit->voices[i];
    if (kit->def.coupled) say(kit, voice, voice->heard, frames);
    mix_drum(kit, voice, outputs ? outputs->drum[i] : none, &mix);
    if (outputs) give_mics(voice, at, frames, outputs->mic[i]);
  }
  for (int side = 0; side < 2; side++) {
    for (uint32_t i = 0; i < frames; i++) mix.close[side][i] += mix.overheads[side][i];
  }
  const float *const dry[2] = {mix.overheads[0], mix.overheads[1]};
  float *const wet[2] = {mix.close[0], mix.close[1]};
  tabor_room_process(kit->room, dry, wet, frames);
  tb_kit_samples_add(&kit->samples, kit->now.sounds, wet[0], wet[1], frames);
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
  kit->now = (TbKitPiece){.events = events, .count = count, .outputs = outputs};
  do {
    TbKitPiece *const piece = &kit->now;
    piece->frames = next_piece(kit, frames - piece->start);
    piece->last = piece->start + piece->frames == frames;
    play_piece(kit);
    piece->start += piece->frames;
  } while (kit->now.start < frames);
  kit->now = (TbKitPiece){.events = NULL};
  tb_fp_leave(mode);
}

/* ---- the kit as a whole ---------------------------------------------------------------------- */

uint32_t tabor_kit_sounds(const TaborKit *kit) { return tb_kit_shots_count(&kit->samples.shots); }

bool tabor_kit_is_silent(const TaborKit *kit) {
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    if (!tabor_drum_is_silent(kit->voices[i].drum)) return false;
  }
  return tabor_room_is_silent(kit->room) && tabor_kit_sounds(kit) == 0;
}

void tabor_kit_reset(TaborKit *kit) {
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    TbKitVoice *const voice = &kit->voices[i];
    tabor_drum_reset(voice->drum);
    memset(voice->said, 0, kit->ring * sizeof *voice->said);
    voice->quiet = kit->ring;
    voice->gone = false;
    voice->passed[0] = voice->passed[1] = 0.0;
  }
  kit->muffled = false;
  kit->left = (TbAirEnergy){.radiated = 0.0};
  tabor_room_reset(kit->room);
  tb_kit_samples_reset(&kit->samples);
  reset_values(kit);
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

/* The beginning of a saved state. Each drum's sound in the air and its own state follow, then the
 * room's state, then a checksum of all these bytes. */
typedef struct StateHead {
  uint64_t size, frame, dropped, muffled;
  double passed[TABOR_KIT_DRUMS][2];
  TbAirEnergy forgotten[TABOR_KIT_DRUMS], left;
  TbLiveParam overheads, coupling;
  TbKitShots shots;
} StateHead;

static size_t ring_bytes(const TaborKit *kit) { return kit->ring * sizeof(float); }

size_t tabor_kit_state_size(const TaborKit *kit) {
  size_t size = sizeof(StateHead) + tabor_room_state_size(kit->room) + sizeof(uint64_t);
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    size += tabor_drum_state_size(kit->voices[i].drum) + ring_bytes(kit);
  }
  return size;
}

static StateHead head_of(const TaborKit *kit) {
  StateHead head = {.size = tabor_kit_state_size(kit),
                    .frame = kit->frame,
                    .dropped = kit->dropped,
                    .muffled = kit->muffled,
                    .left = kit->left,
                    .overheads = kit->overheads,
                    .coupling = kit->coupling,
                    .shots = kit->samples.shots};
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    memcpy(head.passed[i], kit->voices[i].passed, sizeof head.passed[i]);
    head.forgotten[i] = kit->voices[i].drum->forgotten;
  }
  return head;
}

void tabor_kit_state_save(const TaborKit *kit, void *bytes) {
  const StateHead head = head_of(kit);
  char *at = bytes;
  memcpy(at, &head, sizeof head);
  at += sizeof head;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    const TbKitVoice *const voice = &kit->voices[i];
    memcpy(at, voice->said, ring_bytes(kit));
    at += ring_bytes(kit);
    tabor_drum_state_save(voice->drum, at);
    at += tabor_drum_state_size(voice->drum);
  }
  tabor_room_state_save(kit->room, at);
  const uint64_t sum = tb_checksum(bytes, head.size - sizeof sum);
  memcpy((char *)bytes + head.size - sizeof sum, &sum, sizeof sum);
}

static bool is_sound(double value) { return fabs(value) <= LOUDEST; }

static bool is_factor(const TaborKit *kit, const TbLiveParam *live) {
  return tb_live_is_gain(live) && live->left <= kit->ramp;
}

static bool check_head(const TaborKit *kit, const StateHead *head) {
  bool sound = head->size == tabor_kit_state_size(kit) && head->muffled <= 1 &&
               is_factor(kit, &head->overheads) && is_factor(kit, &head->coupling) &&
               is_sound(head->left.radiated) && is_sound(head->left.work) &&
               tb_kit_shots_fit(&head->shots, &kit->samples);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    sound &= is_sound(head->passed[i][0]) && is_sound(head->passed[i][1]) &&
             is_sound(head->forgotten[i].radiated) && is_sound(head->forgotten[i].work);
  }
  return sound;
}

static void load_head(TaborKit *kit, const StateHead *head) {
  kit->frame = head->frame;
  kit->dropped = head->dropped;
  kit->muffled = head->muffled != 0;
  kit->left = head->left;
  kit->overheads = head->overheads;
  kit->coupling = head->coupling;
  kit->samples.shots = head->shots;
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    memcpy(kit->voices[i].passed, head->passed[i], sizeof head->passed[i]);
    kit->voices[i].drum->forgotten = head->forgotten[i];
  }
}

/* How long a drum has been silent before the kit's frame. */
static uint32_t quiet_frames(const TaborKit *kit, const TbKitVoice *voice) {
  uint32_t quiet = 0;
  while (quiet < kit->ring &&
         voice->said[(uint32_t)(kit->frame - 1 - quiet) & (kit->ring - 1)] == 0.0f) {
    quiet++;
  }
  return quiet;
}

static bool load_ring(TaborKit *kit, TbKitVoice *voice, const char *bytes) {
  memcpy(voice->said, bytes, ring_bytes(kit));
  bool sound = true;
  for (uint32_t i = 0; i < kit->ring; i++) sound &= is_sound((double)voice->said[i]);
  voice->quiet = quiet_frames(kit, voice);
  return sound;
}

static bool load_parts(TaborKit *kit, const char *at) {
  for (uint32_t i = 0; i < kit->def.drum_count; i++) {
    TbKitVoice *const voice = &kit->voices[i];
    const size_t size = tabor_drum_state_size(voice->drum);
    if (!load_ring(kit, voice, at)) return false;
    at += ring_bytes(kit);
    if (tabor_drum_state_load(voice->drum, at, size) != TABOR_OK) return false;
    at += size;
  }
  return tabor_room_state_load(kit->room, at, tabor_room_state_size(kit->room)) == TABOR_OK;
}

TaborStatus tabor_kit_state_load(TaborKit *kit, const void *bytes, size_t size) {
  StateHead head;
  uint64_t sum;
  if (!bytes || size != tabor_kit_state_size(kit)) return TABOR_ERROR_STATE;
  memcpy(&head, bytes, sizeof head);
  memcpy(&sum, (const char *)bytes + size - sizeof sum, sizeof sum);
  if (sum != tb_checksum(bytes, size - sizeof sum) || !check_head(kit, &head)) {
    return TABOR_ERROR_STATE;
  }
  load_head(kit, &head);
  if (load_parts(kit, (const char *)bytes + sizeof head)) return TABOR_OK;
  tabor_kit_reset(kit);
  return TABOR_ERROR_STATE;
}
