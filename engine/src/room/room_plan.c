/* SPDX-License-Identifier: MIT */
/* From a definition to the delays and factors of its room. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "math/checksum.h"
#include "math/portable_math.h"
#include "room/room.h"

static const double PI = 3.14159265358979323846;
static const double LN10 = 2.30258509299404568402;
static const double TILT_FREQUENCY = 8000.0; /* [Hz] */
/* Part of a microphone's distance from any wall, and height of the drum [m]. */
static const double MARGIN = 0.05, DRUM_HEIGHT = 0.7;
static const double SHORTEST = 0.55, LONGEST = 1.8; /* lines, in mean free paths */
static const double MODES_PER_HERTZ = 0.45;         /* for each second of decay */
static const double POWER_TIME = 0.02;              /* over which the power is smoothed [s] */
/* Signs that keep the rows of feeds and microphones from being rows of the matrix. */
static const uint32_t SIGNS = 0x3A6C65B1u;

static const struct {
  double size[3], decay, tilt;
} KINDS[] = {
  [TABOR_ROOM_BOOTH] = {{2.4, 2.2, 2.3}, 0.30, 0.20 / 0.30},
  [TABOR_ROOM_STUDIO] = {{6.0, 5.0, 3.0}, 0.60, 0.45 / 0.60},
  [TABOR_ROOM_HALL] = {{20.0, 15.0, 9.0}, 1.5, 0.9 / 1.5},
};

/* Values that follow from the definition alone. */
typedef struct Hall {
  double size[3], drum[3]; /* [m] */
  double rate, sound_speed;
  double decay, decay_8k;       /* [s] */
  double free_path, absorption; /* 4 V/S [m]; A of low notes [m2] */
  double kept, kept_8k;         /* 1 - alpha */
} Hall;

static double or_own(double value, double own) { return value > 0.0 ? value : own; }

static Hall hall_of(const TaborDrumDef *def, double rate) {
  Hall hall = {.rate = rate, .sound_speed = def->air.sound_speed};
  const double *size = KINDS[def->room.kind].size;
  const double scale = or_own(def->room.size, size[0]) / size[0];
  for (int axis = 0; axis < 3; axis++) hall.size[axis] = scale * size[axis];
  hall.decay = or_own(def->room.decay, KINDS[def->room.kind].decay);
  hall.decay_8k = hall.decay * or_own(def->room.tilt, KINDS[def->room.kind].tilt);
  hall.drum[0] = 0.43 * hall.size[0];
  hall.drum[1] = 0.37 * hall.size[1];
  hall.drum[2] = fmin(DRUM_HEIGHT, 0.4 * hall.size[2]);
  const double volume = hall.size[0] * hall.size[1] * hall.size[2];
  const double surface =
    2.0 * (hall.size[0] * hall.size[1] + hall.size[1] * hall.size[2] + hall.size[2] * hall.size[0]);
  hall.free_path = 4.0 * volume / surface;
  hall.absorption = 24.0 * LN10 * volume / (hall.sound_speed * hall.decay);
  hall.kept = tb_exp(-hall.absorption / surface);
  hall.kept_8k = tb_exp(-hall.absorption / surface * hall.decay / hall.decay_8k);
  return hall;
}

/* gain/(1 - pole/z) has the size `low` at 0 Hz and `high` <= low at 8 kHz. */
static void one_pole(const Hall *hall, double low, double high, float *gain, float *pole) {
  const double ratio = high / low, square = ratio * ratio;
  double b = 0.0;
  if (square < 1.0) {
    const double turn = tb_cos(2.0 * PI * TILT_FREQUENCY / hall->rate);
    const double q = (1.0 - square * turn) / (1.0 - square);
    b = q - sqrt(q * q - 1.0);
  }
  *pole = (float)b;
  *gain = (float)(low * (1.0 - b));
}

/* ---- late sound ------------------------------------------------------------------------------ */

static bool is_prime(uint32_t n) {
  for (uint32_t i = 2; i * i <= n; i++) {
    if (n % i == 0) return false;
  }
  return n > 1;
}

/* The part that a line of `frames` keeps of an amplitude that falls by 60 dB in `decay`. */
static double kept_by(const Hall *hall, uint32_t frames, double decay) {
  return tb_exp(-3.0 * LN10 * frames / (hall->rate * decay));
}

static void plan_lines(TaborRoom *room, const Hall *hall) {
  const double mean =
    fmax(hall->free_path / hall->sound_speed, MODES_PER_HERTZ * hall->decay / TB_ROOM_LINES) *
    hall->rate;
  const double step = tb_exp(tb_log(LONGEST / SHORTEST) / (TB_ROOM_LINES - 1));
  double wanted = SHORTEST * mean;
  uint32_t start = 0, length = 1;
  for (uint32_t i = 0; i < TB_ROOM_LINES; i++, wanted *= step) {
    length = (uint32_t)fmax(wanted, length + 1.0);
    while (!is_prime(length)) length++;
    room->length[i] = length;
    room->start[i] = start;
    start += length;
    one_pole(hall, kept_by(hall, length, hall->decay), kept_by(hall, length, hall->decay_8k),
             &room->gain[i], &room->pole[i]);
  }
  room->memory_count = start;
  room->piece = room->length[0] < TB_ROOM_PIECE ? room->length[0] : TB_ROOM_PIECE;
  room->longest = length;
}

/* Row of orthogonal signs. */
static float sign_of(uint32_t row, uint32_t line) {
  uint32_t bits = (row & line) ^ ((SIGNS >> line) & 1u);
  bits ^= bits >> 4;
  bits ^= bits >> 2;
  bits ^= bits >> 1;
  return bits & 1u ? -1.0f : 1.0f;
}

/* Factor of each line at a microphone of gain 1 that gives the late sound its energy. */
static double late_factor(TaborRoom *room, const Hall *hall) {
  double pass = 0.0;
  for (uint32_t i = 0; i < TB_ROOM_LINES; i++) {
    const double kept = kept_by(hall, room->length[i], hall->decay);
    pass += kept * kept / TB_ROOM_LINES;
  }
  room->info.loudness = 16.0 * PI / hall->absorption * hall->kept;
  return sqrt(room->info.loudness * (1.0 - pass) / pass);
}

/* ---- microphones ----------------------------------------------------------------------------- */

static double distance_of(const TaborMicDef *mic) { return tb_hypot(mic->radius, mic->height); }

/* Between the ends of a shell that is closed or has two heads. */
static bool is_inside(const TaborDrumDef *def, const TaborMicDef *mic) {
  const bool encloses = def->two_headed || def->shell.boundary == TABOR_BOUNDARY_CLOSED;
  return encloses && mic->height < 0.0 && mic->height > -def->shell.depth &&
         mic->radius < def->shell.radius;
}

/* The farthest microphone, outside the drum if there is one. */
static uint32_t farthest(const TaborDrumDef *def) {
  uint32_t found = 0;
  double most = -1.0;
  for (uint32_t i = 0; i < def->mic_count; i++) {
    const double distance = is_inside(def, &def->mic[i]) ? 0.0 : distance_of(&def->mic[i]);
    if (distance > most) {
      most = distance;
      found = i;
    }
  }
  return found;
}

static void choose_feeds(TaborRoom *room, const TaborDrumDef *def, double sample_rate) {
  const int left = tabor_drum_def_find_mic(def, "left");
  const int right = tabor_drum_def_find_mic(def, "right");
  const bool pair = left >= 0 && right >= 0;
  room->info.feed[0] = pair ? (uint32_t)left : farthest(def);
  room->info.feed[1] = pair ? (uint32_t)right : room->info.feed[0];
  for (uint32_t i = 0; i < TB_ROOM_FEEDS; i++) {
    const TaborMicDef *mic = &def->mic[room->info.feed[i]];
    room->feed_gain[i] = mic->gain > 0.0 ? (float)(distance_of(mic) / mic->gain) : 0.0f;
    tb_mic_response_prepare(&room->undo[i], mic->response, sample_rate);
    tb_mic_response_invert(&room->undo[i]);
  }
}

/* From the drum's centre. */
static void direction_of(const TaborMicDef *mic, double *direction) {
  double sine, cosine;
  tb_sin_cos_degrees(mic->angle, &sine, &cosine);
  direction[0] = mic->radius * cosine;
  direction[1] = mic->radius * sine;
  direction[2] = mic->height;
}

/* The feed in the direction of the ray; where none is nearer, they take turns. */
static uint32_t nearest_feed(const TaborRoom *room, const TaborDrumDef *def, const double *ray,
                             uint32_t wall) {
  double first[3], second[3], difference = 0.0;
  direction_of(&def->mic[room->info.feed[0]], first);
  direction_of(&def->mic[room->info.feed[1]], second);
  for (int axis = 0; axis < 3; axis++) difference += ray[axis] * (second[axis] - first[axis]);
  if (fabs(difference) > 0.1) return difference > 0.0;
  return (wall ^ (wall >> 1)) & 1u;
}

static void plan_image(const TaborRoom *room, const TaborDrumDef *def, const Hall *hall,
                       const double *place, uint32_t wall, TbRoomImage *image) {
  const uint32_t axis = wall / 2;
  double ray[3], square = 0.0;
  for (uint32_t i = 0; i < 3; i++) ray[i] = place[i] - hall->drum[i];
  ray[axis] = (wall & 1u ? 2.0 * hall->size[axis] : 0.0) - place[axis] - hall->drum[axis];
  for (uint32_t i = 0; i < 3; i++) square += ray[i] * ray[i];
  const double distance = sqrt(square);
  for (uint32_t i = 0; i < 3; i++) ray[i] /= distance;
  image->feed = nearest_feed(room, def, ray, wall);
  const double before = distance_of(&def->mic[room->info.feed[image->feed]]);
  const double path = fmax(0.0, distance - before);
  image->delay = (uint32_t)(path / hall->sound_speed * hall->rate + 0.5);
  image->gain = (float)(1.0 / distance);
}

static void plan_mic(TaborRoom *room, const TaborDrumDef *def, const Hall *hall, double late,
                     uint32_t index) {
  const TaborMicDef *mic = &def->mic[index];
  const double gain = is_inside(def, mic) ? 0.0 : mic->gain * def->room.level;
  TbRoomMic *heard = &room->mic[index];
  double place[3];
  tb_mic_response_prepare(&heard->response, mic->response, hall->rate);
  direction_of(mic, place);
  for (int axis = 0; axis < 3; axis++) {
    const double edge = MARGIN * hall->size[axis];
    place[axis] = fmin(fmax(place[axis] + hall->drum[axis], edge), hall->size[axis] - edge);
  }
  for (uint32_t wall = 0; wall < TB_ROOM_IMAGES; wall++) {
    TbRoomImage *image = &heard->image[wall];
    plan_image(room, def, hall, place, wall, image);
    image->gain = (float)(gain * (double)image->gain);
    if (image->delay >= room->longest) room->longest = image->delay + 1;
  }
  for (uint32_t i = 0; i < TB_ROOM_LINES; i++) {
    heard->late[i] = (float)(gain * late) * sign_of(TB_ROOM_FEEDS + index, i);
  }
}

/* The rings of the reflected feeds follow those of the lines. */
static void plan_early(TaborRoom *room, const Hall *hall) {
  one_pole(hall, sqrt(hall->kept), sqrt(hall->kept_8k), &room->wall_gain, &room->wall_pole);
  room->early_length = 1;
  while (room->early_length < room->longest + TB_ROOM_PIECE) room->early_length *= 2;
  for (uint32_t i = 0; i < TB_ROOM_FEEDS; i++) {
    room->early_start[i] = room->memory_count;
    room->memory_count += room->early_length;
  }
}

/* ---- the whole ------------------------------------------------------------------------------- */

/* The loudest that feeds at full scale can make the lines, then 180 dB at the slowest decay. */
static uint32_t tail_of(const TaborRoom *room, const Hall *hall) {
  const double feeds = (double)room->feed_gain[0] + (double)room->feed_gain[1];
  const double kept = kept_by(hall, room->length[0], hall->decay);
  const double fall = 9.0 + fmax(0.0, tb_log(feeds / (1.0 - kept)) / LN10);
  return (uint32_t)ceil(fall / 3.0 * hall->decay * hall->rate) + 2 * room->longest;
}

size_t tb_room_state_bytes(const TaborRoom *room) {
  const size_t bytes = sizeof(TbRoomState) + room->memory_count * sizeof(float);
  return (bytes + 7u) & ~(size_t)7u;
}

static uint64_t fingerprint_of(const TaborRoom *room) {
  const size_t from = offsetof(TaborRoom, mic_count), until = offsetof(TaborRoom, state);
  return tb_checksum((const char *)room + from, until - from);
}

bool tb_room_is_same(const TaborRoom *a, const TaborRoom *b) {
  return a->info.kind == b->info.kind && a->fingerprint == b->fingerprint;
}

void tb_room_plan(TaborRoom *room, const TaborDrumDef *def, double sample_rate) {
  room->info.kind = def->room.kind;
  if (def->room.kind != TABOR_ROOM_NONE) {
    const Hall hall = hall_of(def, sample_rate);
    plan_lines(room, &hall);
    choose_feeds(room, def, sample_rate);
    const double late = late_factor(room, &hall);
    room->mic_count = def->mic_count;
    for (uint32_t i = 0; i < room->mic_count; i++) plan_mic(room, def, &hall, late, i);
    plan_early(room, &hall);
    for (uint32_t feed = 0; feed < TB_ROOM_FEEDS; feed++) {
      for (uint32_t i = 0; i < TB_ROOM_LINES; i++) { /* of length 1, times sqrt(1/2) */
        room->inject[feed][i] = (float)sqrt(0.5 / TB_ROOM_LINES) * sign_of(feed, i);
      }
    }
    room->power_rate = (float)(1.0 - tb_exp(-1.0 / (POWER_TIME * sample_rate)));
    room->power_gain = late * late;
    room->info.length = hall.size[0];
    room->info.width = hall.size[1];
    room->info.height = hall.size[2];
    room->info.decay = hall.decay;
    room->info.decay_8k = hall.decay_8k;
    room->info.tail = tail_of(room, &hall);
  }
  room->info.bytes = sizeof *room + tb_room_state_bytes(room);
  room->fingerprint = fingerprint_of(room);
}
