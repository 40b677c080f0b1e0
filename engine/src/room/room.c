/* SPDX-License-Identifier: MIT */
/* The public functions of a room. All functions here but create and destroy are audio-safe. */
#include "room/room.h"

#include <math.h>
#include <string.h>

#include "definition/error.h"
#include "kernels/flush_denormals.h"
#include "math/arena.h"
#include "math/checksum.h"

static const double LOWEST_RATE = 22050.0, HIGHEST_RATE = 192000.0; /* [Hz] */

static TaborStatus check(const TaborDrumDef *def, double sample_rate, TaborError *error) {
  if (!def) return tb_error_null(error, "definition");
  if (!(sample_rate >= LOWEST_RATE && sample_rate <= HIGHEST_RATE)) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "sample_rate", NULL, LOWEST_RATE, HIGHEST_RATE,
                        "a room at %g Hz; allowed: %g to %g Hz", sample_rate, LOWEST_RATE,
                        HIGHEST_RATE);
  }
  return tabor_drum_def_validate(def, error);
}

TaborStatus tabor_room_create(const TaborDrumDef *def, double sample_rate,
                              const TaborAllocator *allocator, TaborRoom **out, TaborError *error) {
  if (!out) return tb_error_null(error, "place for the room");
  *out = NULL;
  const TaborStatus status = check(def, sample_rate, error);
  if (status != TABOR_OK) return status;
  const TaborAllocator own = tb_allocator_resolve(allocator);
  TaborRoom *room = own.allocate(sizeof *room, own.context);
  if (room) {
    memset(room, 0, sizeof *room);
    room->allocator = own;
    tb_room_plan(room, def, sample_rate);
    room->state = own.allocate(tb_room_state_bytes(room), own.context);
  }
  if (!room || !room->state) {
    tabor_room_destroy(room);
    return tb_error_set(error, TABOR_ERROR_MEMORY, NULL, NULL, NAN, NAN,
                        "out of memory while creating a room");
  }
  tabor_room_reset(room);
  *out = room;
  return tb_error_clear(error);
}

void tabor_room_destroy(TaborRoom *room) {
  if (!room) return;
  const TaborAllocator allocator = room->allocator;
  if (room->state) allocator.release(room->state, allocator.context);
  allocator.release(room, allocator.context);
}

void tabor_room_info(const TaborRoom *room, TaborRoomInfo *info) { *info = room->info; }

void tabor_room_process(TaborRoom *room, const float *const *dry, float *const *outputs,
                        uint32_t frames) {
  if (room->info.kind == TABOR_ROOM_NONE) return;
  const TbFpMode mode = tb_fp_enter();
  for (uint32_t from = 0; from < frames; from += room->piece) {
    const uint32_t left = frames - from;
    tb_room_step(room, dry, outputs, from, left < room->piece ? left : room->piece);
  }
  tb_fp_leave(mode);
}

bool tabor_room_is_silent(const TaborRoom *room) { return room->state->asleep; }

double tabor_room_energy(const TaborRoom *room) {
  return room->power_gain * (double)room->state->power;
}

void tabor_room_reset(TaborRoom *room) {
  memset(room->state, 0, tb_room_state_bytes(room));
  room->state->fingerprint = room->fingerprint;
  room->state->asleep = 1;
}

/* ---- saved states ---------------------------------------------------------------------------- */

size_t tabor_room_state_size(const TaborRoom *room) {
  return tb_room_state_bytes(room) + sizeof(uint64_t);
}

void tabor_room_state_save(const TaborRoom *room, void *bytes) {
  const size_t size = tb_room_state_bytes(room);
  const uint64_t sum = tb_checksum(room->state, size);
  memcpy(bytes, room->state, size);
  memcpy((char *)bytes + size, &sum, sizeof sum);
}

/* The loudest that a state may be, in full scales: products and sums of such numbers stay finite.
 */
static const float LOUDEST = 1e15f;

static bool is_sound(const void *values, size_t count) {
  for (size_t i = 0; i < count; i++) {
    float value;
    memcpy(&value, (const char *)values + i * sizeof value, sizeof value);
    if (!(fabsf(value) <= LOUDEST)) return false;
  }
  return true;
}

static bool is_memory(const void *values, size_t count) {
  for (size_t i = 0; i < count; i++) {
    double value;
    memcpy(&value, (const char *)values + i * sizeof value, sizeof value);
    if (!(fabs(value) <= (double)LOUDEST)) return false;
  }
  return true;
}

/* Positions within their rings, and numbers of a sound throughout. */
static bool is_state(const TaborRoom *room, const void *bytes) {
  TbRoomState head;
  memcpy(&head, bytes, sizeof head);
  if (head.fingerprint != room->fingerprint || head.asleep > 1) return false;
  if (room->info.kind == TABOR_ROOM_NONE) return true;
  for (uint32_t line = 0; line < TB_ROOM_LINES; line++) {
    if (head.position[line] >= room->length[line]) return false;
  }
  if (head.early_position >= room->early_length || head.quiet >= room->longest) return false;
  if (!(head.power >= 0.0f && isfinite(head.power))) return false;
  return is_sound(head.filter, TB_ROOM_LINES) && is_sound(head.reflected, TB_ROOM_FEEDS) &&
         is_memory(head.undone, sizeof head.undone / sizeof(double)) &&
         is_memory(head.response, sizeof head.response / sizeof(double)) &&
         is_sound((const char *)bytes + offsetof(TbRoomState, memory), room->memory_count);
}

TaborStatus tabor_room_state_load(TaborRoom *room, const void *bytes, size_t size) {
  const size_t expected = tb_room_state_bytes(room);
  uint64_t sum;
  if (!bytes || size != expected + sizeof sum) return TABOR_ERROR_STATE;
  memcpy(&sum, (const char *)bytes + expected, sizeof sum);
  if (sum != tb_checksum(bytes, expected) || !is_state(room, bytes)) return TABOR_ERROR_STATE;
  memcpy(room->state, bytes, expected);
  return TABOR_OK;
}
