/* SPDX-License-Identifier: MIT */
/* Response of a room to a piece of sound. Loops run over frames within a line, so that compilers
 * can use vectors without changing the order of any sum. */
#include <math.h>
#include <string.h>

#include "room/room.h"

/* Values below -180 dBFS are written to rings as zeros. After the longest ring everything is zero.
 */
static const float INAUDIBLE = 1e-9f;
/* Less is zero in a filter's memory: products with it stay above 1e-38, where denormals begin,
 * which not all machines flush. */
static const float NOTHING = 1e-34f;
static const float MIX = 0.17677669f; /* 1/sqrt(TB_ROOM_LINES): the mixing matrix is orthogonal */
static const float LARGEST = 1e6f;    /* of a feed; what is larger or not a number counts as 0 */

typedef float Piece[TB_ROOM_PIECE];

static float cleared(float x) { return fabsf(x) < NOTHING ? 0.0f : x; }

/* ---- rings ----------------------------------------------------------------------------------- */

static uint32_t until_end(uint32_t position, uint32_t length, uint32_t frames) {
  return length - position < frames ? length - position : frames;
}

static void read_ring(const float *ring, uint32_t position, uint32_t length, uint32_t frames,
                      float *values) {
  const uint32_t first = until_end(position, length, frames);
  memcpy(values, ring + position, first * sizeof *values);
  memcpy(values + first, ring, (frames - first) * sizeof *values);
}

/* Returns the new position. */
static uint32_t write_ring(float *ring, uint32_t position, uint32_t length, uint32_t frames,
                           const float *values) {
  const uint32_t first = until_end(position, length, frames);
  memcpy(ring + position, values, first * sizeof *values);
  memcpy(ring, values + first, (frames - first) * sizeof *values);
  return position + frames < length ? position + frames : position + frames - length;
}

/* ---- feeds ----------------------------------------------------------------------------------- */

/* `values` through the filter, if there is any. */
static void respond(const TbMicResponse *response, TbResponseMemory memory, uint32_t frames,
                    float *values) {
  if (response->count == 0) return;
  for (uint32_t i = 0; i < frames; i++) {
    values[i] = cleared((float)tb_mic_respond(response, memory, (double)values[i]));
  }
}

static void take_feeds(const TaborRoom *room, const float *const *dry, uint32_t from,
                       uint32_t frames, Piece *feeds) {
  for (uint32_t feed = 0; feed < TB_ROOM_FEEDS; feed++) {
    const float *const samples = dry ? dry[room->info.feed[feed]] : NULL;
    for (uint32_t i = 0; i < frames; i++) {
      const float x = samples ? samples[from + i] : 0.0f;
      feeds[feed][i] = fabsf(x) <= LARGEST ? room->feed_gain[feed] * x : 0.0f;
    }
    respond(&room->undo[feed], room->state->undone[feed], frames, feeds[feed]);
  }
}

static uint32_t first_sound(Piece *feeds, uint32_t frames) {
  uint32_t i = 0;
  while (i < frames && feeds[0][i] == 0.0f && feeds[1][i] == 0.0f) i++;
  return i;
}

/* ---- late sound ------------------------------------------------------------------------------ */

static void read_lines(const TaborRoom *room, uint32_t frames, Piece *lines) {
  const TbRoomState *const state = room->state;
  for (uint32_t line = 0; line < TB_ROOM_LINES; line++) {
    read_ring(state->memory + room->start[line], state->position[line], room->length[line], frames,
              lines[line]);
  }
}

/* Four lines at a time: each waits for its own last value only. */
static void filter_lines(const TaborRoom *room, uint32_t frames, Piece *lines) {
  for (uint32_t line = 0; line < TB_ROOM_LINES; line += 4) {
    const float *const gain = room->gain + line, *const pole = room->pole + line;
    float s[4];
    memcpy(s, room->state->filter + line, sizeof s);
    for (uint32_t i = 0; i < frames; i++) {
      for (uint32_t k = 0; k < 4; k++) {
        s[k] = cleared(pole[k] * s[k] + gain[k] * lines[line + k][i]);
        lines[line + k][i] = s[k];
      }
    }
    memcpy(room->state->filter + line, s, sizeof s);
  }
}

/* The Hadamard matrix, by its four factors. */
static void mix(uint32_t frames, Piece *lines) {
  for (uint32_t half = 1; half < TB_ROOM_LINES; half *= 2) {
    for (uint32_t line = 0; line < TB_ROOM_LINES; line++) {
      if (line & half) continue;
      float *const restrict a = lines[line], *const restrict b = lines[line + half];
      for (uint32_t i = 0; i < frames; i++) {
        const float sum = a[i] + b[i], difference = a[i] - b[i];
        a[i] = sum;
        b[i] = difference;
      }
    }
  }
}

/* Input of each line; adds its power. */
static void inject(const TaborRoom *room, Piece *feeds, uint32_t frames, Piece *lines,
                   float *power) {
  for (uint32_t line = 0; line < TB_ROOM_LINES; line++) {
    const float first = room->inject[0][line], second = room->inject[1][line];
    float *const restrict x = lines[line];
    for (uint32_t i = 0; i < frames; i++) {
      x[i] = MIX * x[i] + first * feeds[0][i] + second * feeds[1][i];
      power[i] += x[i] * x[i];
    }
  }
}

static void write_lines(const TaborRoom *room, uint32_t frames, Piece *lines) {
  TbRoomState *const state = room->state;
  for (uint32_t line = 0; line < TB_ROOM_LINES; line++) {
    state->position[line] = write_ring(state->memory + room->start[line], state->position[line],
                                       room->length[line], frames, lines[line]);
  }
}

/* ---- first reflections ----------------------------------------------------------------------- */

/* The feeds as a wall reflects them; adds their power. */
static void reflect(const TaborRoom *room, uint32_t frames, Piece *feeds, float *power) {
  for (uint32_t feed = 0; feed < TB_ROOM_FEEDS; feed++) {
    float s = room->state->reflected[feed];
    for (uint32_t i = 0; i < frames; i++) {
      s = cleared(room->wall_pole * s + room->wall_gain * feeds[feed][i]);
      feeds[feed][i] = s;
      power[i] += s * s;
    }
    room->state->reflected[feed] = s;
  }
}

static void write_reflections(const TaborRoom *room, uint32_t frames, Piece *feeds) {
  TbRoomState *const state = room->state;
  for (uint32_t feed = 0; feed < TB_ROOM_FEEDS; feed++) {
    (void)write_ring(state->memory + room->early_start[feed], state->early_position,
                     room->early_length, frames, feeds[feed]);
  }
  state->early_position = (state->early_position + frames) & (room->early_length - 1);
}

/* Adds the images; the ring already holds this piece. */
static void add_images(const TaborRoom *room, const TbRoomMic *mic, uint32_t frames, float *sum) {
  const TbRoomState *const state = room->state;
  for (uint32_t wall = 0; wall < TB_ROOM_IMAGES; wall++) {
    const TbRoomImage *const image = &mic->image[wall];
    const uint32_t position =
      (state->early_position - frames - image->delay) & (room->early_length - 1);
    Piece values;
    read_ring(state->memory + room->early_start[image->feed], position, room->early_length, frames,
              values);
    for (uint32_t i = 0; i < frames; i++) sum[i] += image->gain * values[i];
  }
}

/* ---- a piece --------------------------------------------------------------------------------- */

static void hear(const TaborRoom *room, Piece *lines, uint32_t mic, uint32_t frames, Piece *heard) {
  float *const restrict sum = heard[mic];
  for (uint32_t i = 0; i < frames; i++) sum[i] = 0.0f;
  for (uint32_t line = 0; line < TB_ROOM_LINES; line++) {
    const float factor = room->mic[mic].late[line];
    for (uint32_t i = 0; i < frames; i++) sum[i] += factor * lines[line][i];
  }
}

/* Writes zeros for frames that cannot be heard, and counts them. */
static void still(const TaborRoom *room, const float *power, uint32_t frames, Piece *lines,
                  Piece *feeds) {
  TbRoomState *const state = room->state;
  for (uint32_t i = 0; i < frames; i++) {
    state->power += room->power_rate * (power[i] - state->power);
    if (power[i] >= INAUDIBLE * INAUDIBLE) {
      state->quiet = 0;
      continue;
    }
    state->quiet++;
    for (uint32_t line = 0; line < TB_ROOM_LINES; line++) lines[line][i] = 0.0f;
    for (uint32_t feed = 0; feed < TB_ROOM_FEEDS; feed++) feeds[feed][i] = 0.0f;
  }
}

static void fall_asleep(TbRoomState *state) {
  state->asleep = 1;
  state->quiet = 0;
  state->power = 0.0f;
  memset(state->filter, 0, sizeof state->filter);
  memset(state->reflected, 0, sizeof state->reflected);
  memset(state->undone, 0, sizeof state->undone);
  memset(state->response, 0, sizeof state->response);
}

/* Awake, and for no more frames than are left until it may fall asleep. */
static void play(TaborRoom *room, Piece *feeds, float *const *outputs, uint32_t from,
                 uint32_t frames) {
  Piece lines[TB_ROOM_LINES], heard[TABOR_MAX_MICS], power = {0.0f};
  read_lines(room, frames, lines);
  filter_lines(room, frames, lines);
  for (uint32_t mic = 0; outputs && mic < room->mic_count; mic++) {
    if (outputs[mic]) hear(room, lines, mic, frames, heard);
  }
  mix(frames, lines);
  inject(room, feeds, frames, lines, power);
  reflect(room, frames, feeds, power);
  still(room, power, frames, lines, feeds);
  write_lines(room, frames, lines);
  write_reflections(room, frames, feeds);
  for (uint32_t mic = 0; outputs && mic < room->mic_count; mic++) {
    if (!outputs[mic]) continue;
    add_images(room, &room->mic[mic], frames, heard[mic]);
    respond(&room->mic[mic].response, room->state->response[mic], frames, heard[mic]);
    for (uint32_t i = 0; i < frames; i++) outputs[mic][from + i] += heard[mic][i];
  }
  if (room->state->quiet == room->longest) fall_asleep(room->state);
}

void tb_room_step(TaborRoom *room, const float *const *dry, float *const *outputs, uint32_t from,
                  uint32_t frames) {
  TbRoomState *const state = room->state;
  Piece feeds[TB_ROOM_FEEDS];
  for (uint32_t done = 0; done < frames;) {
    uint32_t count = frames - done;
    if (!state->asleep && count > room->longest - state->quiet) {
      count = room->longest - state->quiet;
    }
    take_feeds(room, dry, from + done, count, feeds);
    if (state->asleep) {
      const uint32_t silent = first_sound(feeds, count);
      done += silent;
      state->asleep = silent == count;
      memset(state->undone, 0, sizeof state->undone); /* sound is taken again, from its start */
      continue;
    }
    play(room, feeds, outputs, from + done, count);
    done += count;
  }
}
