/* SPDX-License-Identifier: MIT */
/* Rooms: decay, level and echoes as asked; no tone that rings; the same bits whatever the blocks;
 * saved states. */
#include "room/room.h"

#include "physics.h"

static const double PI = 3.14159265358979323846;
static const double LN10 = 2.30258509299404568402;

enum { LEFT, RIGHT, FAR, NEAR, SIDE, CORNER, CLOSE, LOW, MICS };

/* A drum of one head with eight microphones, of which the first two are the feeds. */
static TaborDrumDef drum_in(uint32_t kind) {
  static const TaborMicDef places[MICS] = {
    {.name = "left", .radius = 0.5, .angle = 180, .height = 0.8, .gain = 1},
    {.name = "right", .radius = 0.5, .angle = 0, .height = 0.8, .gain = 1},
    {.name = "far", .radius = 1.5, .angle = 80, .height = 0.8, .gain = 1},
    {.name = "near", .radius = 0.35, .angle = 270, .height = 0.45, .gain = 1},
    {.name = "side", .radius = 2, .angle = 0, .height = 0.5, .gain = 1},
    {.name = "corner", .radius = 1, .angle = 40, .height = 1, .gain = 1},
    {.name = "close", .radius = 0.1, .angle = 110, .height = 0.06, .gain = 1},
    {.name = "low", .radius = 0.1, .angle = 200, .height = -0.2, .gain = 1},
  };
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.mic_count = MICS;
  memcpy(def.mic, places, sizeof places);
  def.room.kind = kind;
  return def;
}

static TaborRoom *room_of(const TaborDrumDef *def, double rate) {
  TaborRoom *room;
  TaborError error;
  if (tabor_room_create(def, rate, NULL, &room, &error) != TABOR_OK) fail_msg("%s", error.message);
  return room;
}

static float *zeros(size_t count) {
  float *const values = calloc(count, sizeof *values);
  assert_non_null(values);
  return values;
}

/* Feeds two channels of dry sound, each NULL or `frames` long, in blocks of `block`; what each
 * microphone hears of the room alone, one after the other. The caller frees it. */
static float *wet_of(TaborRoom *room, const float *left, const float *right, uint32_t frames,
                     uint32_t block) {
  float *const wet = zeros((size_t)MICS * frames);
  for (uint32_t from = 0; from < frames; from += block) {
    const uint32_t count = frames - from < block ? frames - from : block;
    const float *dry[MICS] = {left ? left + from : NULL, right ? right + from : NULL};
    float *outputs[MICS];
    for (uint32_t mic = 0; mic < MICS; mic++) outputs[mic] = wet + (size_t)mic * frames + from;
    tabor_room_process(room, dry, outputs, count);
  }
  return wet;
}

/* Responses of all microphones to an impulse in one feed. */
static float *response_of(TaborRoom *room, uint32_t feed, uint32_t frames) {
  float *const impulse = zeros(frames);
  impulse[0] = 1.0f;
  tabor_room_reset(room);
  float *const wet = wet_of(room, feed ? NULL : impulse, feed ? impulse : NULL, frames, frames);
  free(impulse);
  return wet;
}

/* The first reflections alone, or the late sound alone. */
static void keep_images(TaborRoom *room) {
  for (uint32_t mic = 0; mic < MICS; mic++)
    memset(room->mic[mic].late, 0, sizeof room->mic[mic].late);
}

static void keep_late(TaborRoom *room) {
  for (uint32_t mic = 0; mic < MICS; mic++) {
    for (int wall = 0; wall < TB_ROOM_IMAGES; wall++) room->mic[mic].image[wall].gain = 0.0f;
  }
}

static double volume_of(const TaborRoomInfo *info) {
  return info->length * info->width * info->height;
}

/* 60 dB decay time that was asked for at a frequency: room.h. */
static double asked_decay(const TaborRoomInfo *info, double frequency, double rate) {
  const double share = sin(PI * frequency / rate) / sin(PI * 8000.0 / rate);
  return 1.0 / (1.0 / info->decay + (1.0 / info->decay_8k - 1.0 / info->decay) * share * share);
}

/* ---- bands ----------------------------------------------------------------------------------- */

/* Three resonances in a row, each with zeros at 0 Hz and at half the rate: about an octave for
 * quality 1, a sixth of one for 6. */
static void filter_band(const float *from, double *to, uint32_t frames, double frequency,
                        double quality, double rate) {
  const double w = 2.0 * PI * frequency / rate, alpha = sin(w) / (2.0 * quality);
  for (uint32_t i = 0; i < frames; i++) to[i] = from[i];
  for (int stage = 0; stage < 3; stage++) {
    double x1 = 0.0, x2 = 0.0, y1 = 0.0, y2 = 0.0;
    for (uint32_t i = 0; i < frames; i++) {
      const double x = to[i];
      const double y = (alpha * (x - x2) + 2.0 * cos(w) * y1 - (1.0 - alpha) * y2) / (1.0 + alpha);
      x2 = x1;
      x1 = x;
      y2 = y1;
      y1 = y;
      to[i] = y;
    }
  }
}

/* Sum over microphones and both feeds of squares in a band, frame by frame. */
static double *energies(TaborRoom *room, uint32_t frames, double frequency, double quality,
                        double rate) {
  double *const sum = calloc(frames, sizeof *sum), *const band = calloc(frames, sizeof *band);
  assert_true(sum && band);
  for (uint32_t feed = 0; feed < 2; feed++) {
    float *const wet = response_of(room, feed, frames);
    for (uint32_t mic = 0; mic < MICS; mic++) {
      filter_band(wet + (size_t)mic * frames, band, frames, frequency, quality, rate);
      for (uint32_t i = 0; i < frames; i++) sum[i] += band[i] * band[i];
    }
    free(wet);
  }
  free(band);
  return sum;
}

static double total(const double *values, uint32_t count) {
  double sum = 0.0;
  for (uint32_t i = 0; i < count; i++) sum += values[i];
  return sum;
}

/* 60 dB time by least squares of the backward integral between -5 and -35 dB. */
static double measured_decay(const double *energy, uint32_t frames, double rate) {
  const double whole = total(energy, frames);
  double left = whole, n = 0.0, t1 = 0.0, t2 = 0.0, y1 = 0.0, ty = 0.0;
  for (uint32_t i = 0; i < frames && left > 0.0; left -= energy[i++]) {
    const double level = 10.0 * log10(left / whole), time = i / rate;
    if (level > -5.0 || level < -35.0) continue;
    n += 1.0;
    t1 += time;
    t2 += time * time;
    y1 += level;
    ty += time * level;
  }
  return -60.0 * (n * t2 - t1 * t1) / (n * ty - t1 * y1);
}

/* ---- decay and level ------------------------------------------------------------------------- */

/* Each octave up to 8 kHz within 5 %. There the decay changes within an octave: a sixth of one is
 * measured. At 16 kHz one pole a line loses less than the law: the longer the line, the less. */
static const double DECAY_ERROR = 0.05, DECAY_ERROR_16K = 0.15;

static void check_decay(const TaborDrumDef *def, double rate, double highest) {
  TaborRoom *const room = room_of(def, rate);
  keep_late(room);
  TaborRoomInfo info;
  tabor_room_info(room, &info);
  const uint32_t frames = (uint32_t)(1.2 * info.decay * rate);
  for (double frequency = 62.5; frequency <= highest; frequency *= 2.0) {
    double *const energy = energies(room, frames, frequency, frequency > 5000.0 ? 6.0 : 1.0, rate);
    const double found = measured_decay(energy, frames, rate);
    const double asked = asked_decay(&info, frequency, rate);
    const double most = frequency > 10000.0 ? DECAY_ERROR_16K : DECAY_ERROR;
    if (!(fabs(found / asked - 1.0) < most)) {
      fail_msg("kind %u, %g Hz: %g s instead of %g s", info.kind, frequency, found, asked);
    }
    free(energy);
  }
  tabor_room_destroy(room);
}

static void every_octave_decays_as_asked(void **state) {
  (void)state;
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_HALL; kind++) {
    const TaborDrumDef def = drum_in(kind);
    check_decay(&def, 48000.0, 16000.0);
  }
  TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  check_decay(&def, 96000.0, 16000.0);
  check_decay(&def, 22050.0, 8000.0);
  def.room = (TaborRoomDef){TABOR_ROOM_STUDIO, .size = 9.0, .decay = 1.0, .tilt = 0.5, .level = 1};
  check_decay(&def, 44100.0, 16000.0);
  def.room = (TaborRoomDef){TABOR_ROOM_BOOTH, .size = 2.0, .decay = 2.0, .tilt = 1.0, .level = 1};
  check_decay(&def, 48000.0, 16000.0);
}

/* Energy of a band at 1 m, of the same impulse, all microphones and both feeds. A feed hears the
 * drum from sqrt(0.5^2 + 0.8^2) m. */
static double direct_energy(uint32_t frames, double frequency, double quality, double rate) {
  float *const impulse = zeros(frames);
  double *const band = calloc(frames, sizeof *band);
  impulse[0] = 1.0f;
  filter_band(impulse, band, frames, frequency, quality, rate);
  double sum = 0.0;
  for (uint32_t i = 0; i < frames; i++) sum += band[i] * band[i];
  free(band);
  free(impulse);
  return sum * 0.89 * MICS;
}

/* Late over direct energy at 1 m in dB against (16 pi/A) exp(-A/S), or without the exponential
 * against all that a diffuse field has. */
static double level_error(TaborRoom *room, double frequency, double rate, bool late) {
  TaborRoomInfo info;
  tabor_room_info(room, &info);
  const uint32_t frames = (uint32_t)(1.5 * info.decay * rate);
  double *const energy = energies(room, frames, frequency, 1.0, rate);
  const double found = total(energy, frames) / direct_energy(frames, frequency, 1.0, rate);
  free(energy);
  const double decay = asked_decay(&info, frequency, rate);
  const double absorption = 24.0 * LN10 * volume_of(&info) / (343.0 * decay);
  const double surface =
    2.0 * (info.length * info.width + info.width * info.height + info.height * info.length);
  const double field = 16.0 * PI / absorption * (late ? exp(-absorption / surface) : 1.0);
  return 10.0 * log10(found / field);
}

/* Within 1 dB: an octave at 250 Hz has some hundred modes of the network in it. */
static void late_sound_has_the_energy_of_a_diffuse_field(void **state) {
  (void)state;
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_HALL; kind++) {
    TaborDrumDef def = drum_in(kind);
    TaborRoom *room = room_of(&def, 48000.0);
    keep_late(room);
    for (double frequency = 250.0; frequency < 5000.0; frequency *= 2.0) {
      const double error = level_error(room, frequency, 48000.0, true);
      if (!(fabs(error) < 1.0)) fail_msg("kind %u, %g Hz: %+.2f dB", kind, frequency, error);
    }
    tabor_room_destroy(room);
  }
}

/* In a hall the floor is much nearer than a mean free path, and its reflection comes on top. */
static void all_that_comes_back_is_a_diffuse_field(void **state) {
  (void)state;
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_STUDIO; kind++) {
    TaborDrumDef def = drum_in(kind);
    TaborRoom *room = room_of(&def, 48000.0);
    const double error = level_error(room, 1000.0, 48000.0, false);
    if (!(fabs(error) < 1.0)) fail_msg("kind %u: %+.2f dB", kind, error);
    tabor_room_destroy(room);
  }
}

/* Twice the level is 6 dB more, and a microphone of half the gain hears 6 dB less. */
static void levels_and_gains_scale_the_room(void **state) {
  (void)state;
  enum { FRAMES = 9600 };
  TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  TaborRoom *plain = room_of(&def, 48000.0);
  def.room.level = 2.0;
  def.mic[FAR].gain = 0.5;
  def.mic[NEAR].gain = 0.0;
  TaborRoom *other = room_of(&def, 48000.0);
  float *a = response_of(plain, 0, FRAMES), *b = response_of(other, 0, FRAMES);
  for (uint32_t i = 0; i < FRAMES; i++) {
    assert_true(b[LEFT * FRAMES + i] == 2.0f * a[LEFT * FRAMES + i]);
    assert_true(b[FAR * FRAMES + i] == a[FAR * FRAMES + i]);
    assert_true(b[NEAR * FRAMES + i] == 0.0f);
  }
  free(a);
  free(b);
  tabor_room_destroy(plain);
  tabor_room_destroy(other);
}

/* A pad on a feed is taken off again: the room is as loud as before. */
static void a_feed_counts_as_the_drum_at_a_metre(void **state) {
  (void)state;
  TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  TaborRoom *plain = room_of(&def, 48000.0);
  def.mic[LEFT].gain = 0.25;
  TaborRoom *padded = room_of(&def, 48000.0);
  assert_true(padded->feed_gain[0] == 4.0f * plain->feed_gain[0]);
  assert_true(fabs((double)plain->feed_gain[0] - sqrt(0.89)) < 1e-6);
  tabor_room_destroy(plain);
  tabor_room_destroy(padded);
}

static void microphones_inside_a_drum_hear_no_room(void **state) {
  (void)state;
  enum { FRAMES = 4800 };
  TaborDrumDef def = drum_in(TABOR_ROOM_HALL);
  def.two_headed = 1;
  def.mic[CLOSE].height = -0.05;
  TaborRoom *room = room_of(&def, 48000.0);
  float *wet = response_of(room, 0, FRAMES);
  double inside = 0.0, below = 0.0;
  for (uint32_t i = 0; i < FRAMES; i++) {
    inside += fabs((double)wet[CLOSE * FRAMES + i]);
    below += fabs((double)wet[LOW * FRAMES + i]);
  }
  assert_true(inside == 0.0 && below > 0.0);
  free(wet);
  tabor_room_destroy(room);
}

/* ---- echoes ---------------------------------------------------------------------------------- */

/* Six images, with delays and sizes from positions in the room that are written down here once
 * more. */
static void first_reflections_come_from_six_images(void **state) {
  (void)state;
  enum { FRAMES = 4800 };
  const double size[3] = {6.0, 5.0, 3.0}, drum[3] = {2.58, 1.85, 0.7};
  const double mic[3] = {2.58 + 1.5 * cos(80 * PI / 180), 1.85 + 1.5 * sin(80 * PI / 180), 1.5};
  TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  def.room.tilt = 1.0; /* the same at all frequencies: a reflection is one sample */
  TaborRoom *room = room_of(&def, 48000.0);
  keep_images(room);
  float *first = response_of(room, 0, FRAMES), *second = response_of(room, 1, FRAMES);
  const double absorption = 24.0 * LN10 * 90.0 / (343.0 * 0.6);
  const double wall = exp(-absorption / 126.0 / 2.0);
  double expected = 0.0, found = 0.0;
  for (int image = 0; image < 6; image++) {
    double square = 0.0;
    for (int axis = 0; axis < 3; axis++) {
      const bool mirrored = axis == image / 2;
      const double x = mirrored ? (image % 2 ? 2.0 * size[axis] : 0.0) - drum[axis] : drum[axis];
      square += (x - mic[axis]) * (x - mic[axis]);
    }
    const double distance = sqrt(square);
    const long delay = lround((distance - sqrt(0.89)) / 343.0 * 48000.0);
    const double size_at_mic = wall * sqrt(0.89) / distance;
    const double heard = (double)first[FAR * FRAMES + delay] + (double)second[FAR * FRAMES + delay];
    if (!(fabs(heard / size_at_mic - 1.0) < 1e-5)) {
      fail_msg("image %d: %g instead of %g", image, heard, size_at_mic);
    }
    expected += size_at_mic;
  }
  for (uint32_t i = 0; i < FRAMES; i++) {
    found += (double)first[FAR * FRAMES + i] + (double)second[FAR * FRAMES + i];
  }
  assert_true(fabs(found / expected - 1.0) < 1e-5); /* and nothing else */
  free(first);
  free(second);
  tabor_room_destroy(room);
}

/* Part of the samples that lie outside of the standard deviation, over that of Gaussian noise, in
 * 20 ms: small for single echoes, 1 once they are dense. */
static double echo_density(const float *wet, uint32_t center, uint32_t half) {
  double square = 0.0;
  uint32_t outside = 0;
  for (uint32_t i = center - half; i < center + half; i++) {
    square += (double)wet[i] * (double)wet[i];
  }
  const double deviation = sqrt(square / (2.0 * half));
  for (uint32_t i = center - half; i < center + half; i++) {
    outside += fabs((double)wet[i]) > deviation;
  }
  return outside / (2.0 * half) / 0.3173;
}

/* Dense within 2 mean free times of the lines in booth and studio, 4 in a hall, and dense from
 * there on. */
static void echoes_become_dense(void **state) {
  (void)state;
  static const double dense_after[] = {[TABOR_ROOM_BOOTH] = 0.025, 0.04, 0.11}; /* [s] */
  const uint32_t half = 480;
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_HALL; kind++) {
    const TaborDrumDef def = drum_in(kind);
    TaborRoom *room = room_of(&def, 48000.0);
    TaborRoomInfo info;
    tabor_room_info(room, &info);
    const uint32_t frames = (uint32_t)(info.decay * 48000.0);
    float *wet = response_of(room, 0, frames);
    for (uint32_t mic = 0; mic < MICS; mic++) {
      for (uint32_t at = (uint32_t)(dense_after[kind] * 48000.0); at + half < frames; at += half) {
        const double density = echo_density(wet + (size_t)mic * frames, at, half);
        if (!(density > 0.7)) {
          fail_msg("kind %u, microphone %u: %g after %g s", kind, mic, density, at / 48000.0);
        }
      }
    }
    free(wet);
    tabor_room_destroy(room);
  }
}

/* ---- tones ----------------------------------------------------------------------------------- */

/* Largest bin of a Hann window's spectrum from 200 Hz to 4 kHz, in dB over the mean of the third
 * octave around it. Of noise with n bins this is about 10 log(ln n), 8 to 9 dB. */
static double highest_tone(const float *wet, uint32_t frames, double rate) {
  const uint32_t low = (uint32_t)(150.0 * frames / rate), high = (uint32_t)(5100.0 * frames / rate);
  double *const power = calloc(high, sizeof *power), *const windowed =
                                                       calloc(frames, sizeof *power);
  assert_true(power && windowed);
  for (uint32_t i = 0; i < frames; i++) {
    windowed[i] = (double)wet[i] * (0.5 - 0.5 * cos(2.0 * PI * i / frames));
  }
  for (uint32_t bin = low; bin < high; bin++) {
    const double turn = 2.0 * cos(2.0 * PI * bin / frames);
    double s1 = 0.0, s2 = 0.0; /* Goertzel */
    for (uint32_t i = 0; i < frames; i++) {
      const double s = windowed[i] + turn * s1 - s2;
      s2 = s1;
      s1 = s;
    }
    power[bin] = s1 * s1 + s2 * s2 - turn * s1 * s2;
  }
  double most = 0.0;
  for (uint32_t bin = (uint32_t)(200.0 * frames / rate); bin * rate / frames < 4000.0; bin++) {
    const uint32_t from = (uint32_t)(bin / 1.1225), until = (uint32_t)(bin * 1.1225);
    const double mean = total(power + from, until - from) / (until - from);
    most = fmax(most, power[bin] / mean);
  }
  free(power);
  free(windowed);
  return 10.0 * log10(most);
}

/* Modes of the network overlap and decay alike: late in the decay no bin stands out more than this.
 */
static const double TONE = 15.0;

static void no_tone_rings(void **state) {
  (void)state;
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_HALL; kind++) {
    const TaborDrumDef def = drum_in(kind);
    TaborRoom *room = room_of(&def, 48000.0);
    TaborRoomInfo info;
    tabor_room_info(room, &info);
    const uint32_t frames = (uint32_t)(1.75 * info.decay * 48000.0);
    const uint32_t window = (uint32_t)(0.75 * info.decay * 48000.0);
    float *wet = response_of(room, 0, frames);
    for (uint32_t mic = 0; mic < 2; mic++) {
      const float *heard = wet + (size_t)mic * frames;
      const double early = highest_tone(heard + window / 3, window, 48000.0);
      const double late = highest_tone(heard + frames - window, window, 48000.0);
      if (!(early < TONE && late < TONE)) {
        fail_msg("kind %u, microphone %u: %g dB, later %g dB", kind, mic, early, late);
      }
    }
    free(wet);
    tabor_room_destroy(room);
  }
}

/* A tone 40 dB below the beginning that takes twice as long to decay. */
static void a_ringing_tone_would_be_found(void **state) {
  (void)state;
  const TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  TaborRoom *room = room_of(&def, 48000.0);
  const uint32_t frames = (uint32_t)(1.05 * 48000.0), window = (uint32_t)(0.45 * 48000.0);
  float *wet = response_of(room, 0, frames);
  double first = 0.0;
  for (uint32_t i = 0; i < 4800; i++) first = fmax(first, fabs((double)wet[i]));
  for (uint32_t i = 0; i < frames; i++) {
    const double time = i / 48000.0;
    wet[i] += (float)(0.01 * first * exp(-3.0 * LN10 * time / 1.2) * sin(2.0 * PI * 700.0 * time));
  }
  assert_true(highest_tone(wet + frames - window, window, 48000.0) > TONE);
  free(wet);
  tabor_room_destroy(room);
}

/* ---- blocks, states, silence ----------------------------------------------------------------- */

enum { SOUND = 30000 };

/* Bursts of noise with silence between them, and values that are no sound. */
static float *bursts(uint64_t seed) {
  float *const sound = zeros(SOUND);
  for (uint32_t i = 0; i < SOUND; i++) {
    if (i / 2000 % 3 == 0) sound[i] = (float)physics_uniform(&seed, -1.0, 1.0);
  }
  sound[700] = NAN;
  sound[701] = INFINITY;
  sound[702] = -1e30f;
  return sound;
}

static void blocks_change_no_bit(void **state) {
  (void)state;
  static const uint32_t blocks[] = {1, 7, 31, 32, 33, 64, 1000, 8192};
  float *left = bursts(1), *right = bursts(2);
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_HALL; kind++) {
    TaborDrumDef def = drum_in(kind);
    def.room.decay = 0.05;                                    /* falls asleep between bursts */
    def.mic[RIGHT].response = def.mic[CLOSE].response = kind; /* each response once */
    TaborRoom *room = room_of(&def, 44100.0);
    float *whole = wet_of(room, left, right, SOUND, SOUND);
    for (uint32_t i = 0; i < MICS * SOUND; i++) assert_true(fabsf(whole[i]) < 1e3f);
    for (size_t i = 0; i < sizeof blocks / sizeof *blocks; i++) {
      tabor_room_reset(room);
      float *parts = wet_of(room, left, right, SOUND, blocks[i]);
      assert_memory_equal(parts, whole, MICS * SOUND * sizeof *whole);
      free(parts);
    }
    free(whole);
    tabor_room_destroy(room);
  }
  free(left);
  free(right);
}

/* The sound that a microphone of this response hears instead of `flat`. The caller frees it. */
static float *heard_as(uint32_t kind, const float *flat) {
  TbMicResponse response;
  TbResponseMemory memory = {{0.0}};
  float *const sound = zeros(SOUND);
  tb_mic_response_prepare(&response, kind, 48000.0);
  for (uint32_t i = 0; i < SOUND; i++) {
    sound[i] = (float)tb_mic_respond(&response, memory, (double)flat[i]);
  }
  return sound;
}

/* The largest difference, over the largest of the first. */
static double difference(const float *a, const float *b) {
  double most = 0.0, peak = 0.0;
  for (uint32_t i = 0; i < SOUND; i++) {
    peak = fmax(peak, fabs((double)a[i]));
    most = fmax(most, fabs((double)a[i] - (double)b[i]));
  }
  return most / peak;
}

/* Feeds are rounded to float. The inverse raises that by up to 30 dB near half the rate. */
static const double RESPONSE_ROUNDING = 1e-5;

/* A room hears the same by feeds of any response; what it sends back is heard by each microphone's
 * own. */
static void responses_of_feeds_are_undone(void **state) {
  (void)state;
  float *left = zeros(SOUND), *right = zeros(SOUND);
  uint64_t seed = 5;
  for (uint32_t i = 0; i < SOUND / 4; i++) {
    left[i] = (float)physics_uniform(&seed, -1.0, 1.0);
    right[i] = (float)physics_uniform(&seed, -1.0, 1.0);
  }
  TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  TaborRoom *room = room_of(&def, 48000.0);
  def.mic[LEFT].response = TABOR_RESPONSE_DYNAMIC;
  def.mic[RIGHT].response = TABOR_RESPONSE_CONDENSER;
  def.mic[FAR].response = TABOR_RESPONSE_LARGE_DYNAMIC;
  TaborRoom *coloured = room_of(&def, 48000.0);
  float *dynamic = heard_as(TABOR_RESPONSE_DYNAMIC, left);
  float *condenser = heard_as(TABOR_RESPONSE_CONDENSER, right);
  float *wet = wet_of(room, left, right, SOUND, 256);
  float *other = wet_of(coloured, dynamic, condenser, SOUND, 256);
  float *far = heard_as(TABOR_RESPONSE_LARGE_DYNAMIC, wet + FAR * SOUND);
  assert_true(difference(wet + NEAR * SOUND, other + NEAR * SOUND) < RESPONSE_ROUNDING);
  assert_true(difference(far, other + FAR * SOUND) < RESPONSE_ROUNDING);
  float *const all[] = {left, right, dynamic, condenser, wet, other, far};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++) free(all[i]);
  tabor_room_destroy(room);
  tabor_room_destroy(coloured);
}

/* The pair's own channels: dry sound in, dry and wet out. Channels that nobody hears change
 * nothing. */
static void channels_may_be_the_feeds_themselves(void **state) {
  (void)state;
  float *left = bursts(1), *right = bursts(2);
  const TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  TaborRoom *room = room_of(&def, 48000.0);
  float *wet = wet_of(room, left, right, SOUND, 256), *channels[MICS] = {NULL};
  float *const first = zeros(SOUND), *const second = zeros(SOUND);
  memcpy(first, left, SOUND * sizeof *left);
  memcpy(second, right, SOUND * sizeof *right);
  channels[LEFT] = first;
  channels[RIGHT] = second;
  tabor_room_reset(room);
  tabor_room_process(room, (const float *const *)channels, channels, SOUND);
  for (uint32_t i = 0; i < SOUND; i++) {
    if (!isfinite(left[i])) continue;
    assert_true(first[i] == left[i] + wet[LEFT * SOUND + i]);
    if (isfinite(right[i])) assert_true(second[i] == right[i] + wet[RIGHT * SOUND + i]);
  }
  free(first);
  free(second);
  free(wet);
  free(left);
  free(right);
  tabor_room_destroy(room);
}

static void no_room_changes_no_bit(void **state) {
  (void)state;
  const TaborDrumDef def = drum_in(TABOR_ROOM_NONE);
  TaborRoom *room = room_of(&def, 48000.0);
  float *sound = bursts(1), *copy = bursts(1), *channels[MICS] = {sound};
  tabor_room_process(room, (const float *const *)channels, channels, SOUND);
  assert_memory_equal(sound, copy, SOUND * sizeof *sound);
  assert_true(tabor_room_is_silent(room));
  assert_true(tabor_room_energy(room) == 0.0);
  void *saved = malloc(tabor_room_state_size(room));
  tabor_room_state_save(room, saved);
  assert_int_equal(tabor_room_state_load(room, saved, tabor_room_state_size(room)), TABOR_OK);
  free(saved);
  free(sound);
  free(copy);
  tabor_room_destroy(room);
}

static void a_saved_state_continues_to_the_same_bit(void **state) {
  (void)state;
  const TaborDrumDef def = drum_in(TABOR_ROOM_HALL);
  float *left = bursts(3);
  TaborRoom *room = room_of(&def, 48000.0), *twin = room_of(&def, 48000.0);
  free(wet_of(room, left, NULL, 5000, 100));
  const size_t size = tabor_room_state_size(room);
  unsigned char *saved = malloc(size);
  assert_non_null(saved);
  tabor_room_state_save(room, saved);
  assert_int_equal(tabor_room_state_load(twin, saved, size), TABOR_OK);
  float *a = wet_of(room, left + 5000, NULL, 8000, 64),
        *b = wet_of(twin, left + 5000, NULL, 8000, 999);
  assert_memory_equal(a, b, MICS * 8000 * sizeof *a);
  free(a);
  free(b);
  free(saved);
  free(left);
  tabor_room_destroy(room);
  tabor_room_destroy(twin);
}

/* The bytes with a right checksum, as a forger would write them. */
static void assert_refused(TaborRoom *room, const unsigned char *bytes, size_t size) {
  const size_t body = size - sizeof(uint64_t);
  unsigned char *copy = malloc(size);
  assert_non_null(copy);
  memcpy(copy, bytes, size);
  uint64_t hash = 14695981039346656037u;
  for (size_t i = 0; i + 8 <= body; i += 8) {
    uint64_t word;
    memcpy(&word, copy + i, 8);
    hash = (hash ^ word) * 1099511628211u;
  }
  memcpy(copy + body, &hash, sizeof hash);
  assert_int_equal(tabor_room_state_load(room, copy, size), TABOR_ERROR_STATE);
  free(copy);
}

static void damaged_and_forged_states_are_refused(void **state) {
  (void)state;
  const TaborDrumDef def = drum_in(TABOR_ROOM_BOOTH), other = drum_in(TABOR_ROOM_STUDIO);
  TaborRoom *room = room_of(&def, 48000.0), *stranger = room_of(&other, 48000.0);
  float *left = bursts(4);
  free(wet_of(room, left, NULL, 3000, 100));
  const size_t size = tabor_room_state_size(room);
  unsigned char *saved = malloc(size), *forged = malloc(size);
  assert_true(saved && forged);
  tabor_room_state_save(room, saved);
  assert_int_equal(tabor_room_state_load(stranger, saved, size), TABOR_ERROR_STATE);
  assert_int_equal(tabor_room_state_load(room, saved, size - 1), TABOR_ERROR_STATE);
  assert_int_equal(tabor_room_state_load(room, NULL, size), TABOR_ERROR_STATE);
  saved[size / 2] ^= 1u;
  assert_int_equal(tabor_room_state_load(room, saved, size), TABOR_ERROR_STATE);
  saved[size / 2] ^= 1u;
  for (int what = 0; what < 6; what++) {
    memcpy(forged, saved, size);
    TbRoomState *const head = (TbRoomState *)(void *)forged;
    if (what == 0) head->position[3] = room->length[3];
    if (what == 1) head->early_position = room->early_length;
    if (what == 2) head->quiet = room->longest;
    if (what == 3) head->asleep = 2;
    if (what == 4) head->filter[5] = NAN;
    if (what == 5) head->memory[77] = INFINITY;
    assert_refused(room, forged, size);
  }
  assert_int_equal(tabor_room_state_load(room, saved, size), TABOR_OK);
  free(saved);
  free(forged);
  free(left);
  tabor_room_destroy(room);
  tabor_room_destroy(stranger);
}

/* Silent within its tail, its energy falling; then exactly 0, and like new when it wakes. */
static void rooms_fall_asleep_and_wake(void **state) {
  (void)state;
  float *left = bursts(5), *right = zeros(SOUND);
  for (uint32_t i = 0; i < SOUND; i++) right[i] = 1.0f;
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_HALL; kind++) {
    const TaborDrumDef def = drum_in(kind);
    TaborRoom *room = room_of(&def, 48000.0);
    TaborRoomInfo info;
    tabor_room_info(room, &info);
    assert_true(tabor_room_is_silent(room));
    float *fresh = wet_of(room, left, right, SOUND, 512);
    assert_false(tabor_room_is_silent(room));
    const double loud = tabor_room_energy(room);
    float *rest = wet_of(room, NULL, NULL, info.tail, 512);
    const uint32_t half = (uint32_t)(info.decay / 2.0 * 48000.0);
    assert_true(tabor_room_is_silent(room) && info.tail > half);
    assert_true(loud > 0.0 && tabor_room_energy(room) == 0.0);
    free(rest);
    rest = wet_of(room, NULL, NULL, 100, 100);
    for (uint32_t i = 0; i < MICS * 100; i++) assert_true(rest[i] == 0.0f);
    free(rest);
    rest = wet_of(room, left, right, SOUND, 511);
    assert_memory_equal(rest, fresh, MICS * SOUND * sizeof *fresh);
    free(rest);
    free(fresh);
    tabor_room_destroy(room);
  }
  free(left);
  free(right);
}

/* Of all that the lines and their filters hold. */
static double total_of_lines(const TaborRoom *room) {
  const uint32_t last = TB_ROOM_LINES - 1, count = room->start[last] + room->length[last];
  double sum = 0.0;
  for (uint32_t i = 0; i < count; i++) {
    sum += (double)room->state->memory[i] * (double)room->state->memory[i];
  }
  return sum;
}

/* The lines take half the energy of a feed: the matrix and the rows of both feeds are orthogonal.
 */
static void lines_take_half_of_a_feeds_energy(void **state) {
  (void)state;
  const double rounding = 1e-6;
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_HALL; kind++) {
    const TaborDrumDef def = drum_in(kind);
    TaborRoom *room = room_of(&def, 48000.0);
    for (uint32_t feed = 0; feed < 2; feed++) {
      free(response_of(room, feed, 1));
      const double expected = 0.5 * 0.89; /* of a microphone whose distance is sqrt(0.89) m */
      assert_true(fabs(total_of_lines(room) / expected - 1.0) < rounding);
    }
    tabor_room_destroy(room);
  }
}

/* The corners of every range, at the lowest and highest rate: nothing grows once the feeds are
 * silent. */
static void no_room_grows(void **state) {
  (void)state;
  for (uint32_t corner = 0; corner < 16; corner++) {
    TaborDrumDef def = drum_in(1 + corner % 3);
    def.room.size = corner & 1 ? 100.0 : 1.0;
    def.room.decay = corner & 2 ? 20.0 : 0.05;
    def.room.tilt = corner & 4 ? 1.0 : 0.25;
    TaborRoom *room = room_of(&def, corner & 8 ? 192000.0 : 22050.0);
    float *left = bursts(corner), *wet = wet_of(room, left, left, SOUND, 4096);
    for (uint32_t i = 0; i < MICS * SOUND; i++) assert_true(isfinite(wet[i]));
    free(wet);
    double before = INFINITY;
    for (int i = 0; i < 8; i++) {
      const double energy = total_of_lines(room);
      assert_true(energy <= before);
      before = energy;
      tabor_room_process(room, NULL, NULL, 4096);
    }
    free(left);
    tabor_room_destroy(room);
  }
}

/* ---- set-up ---------------------------------------------------------------------------------- */

static void drums_without_a_pair_feed_their_farthest_microphone(void **state) {
  (void)state;
  TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  strcpy(def.mic[RIGHT].name, "other");
  TaborRoom *room = room_of(&def, 48000.0);
  TaborRoomInfo info;
  tabor_room_info(room, &info);
  assert_int_equal(info.feed[0], SIDE);
  assert_int_equal(info.feed[1], SIDE);
  tabor_room_destroy(room);
}

static void kinds_have_the_sizes_and_decays_of_the_header(void **state) {
  (void)state;
  static const double stated[][5] = {
    {2.4, 2.2, 2.3, 0.30, 0.20}, {6, 5, 3, 0.60, 0.45}, {20, 15, 9, 1.5, 0.9}};
  for (uint32_t kind = TABOR_ROOM_BOOTH; kind <= TABOR_ROOM_HALL; kind++) {
    const TaborDrumDef def = drum_in(kind);
    TaborRoom *room = room_of(&def, 48000.0);
    TaborRoomInfo info;
    tabor_room_info(room, &info);
    const double found[] = {info.length, info.width, info.height, info.decay, info.decay_8k};
    for (int i = 0; i < 5; i++) assert_true(fabs(found[i] - stated[kind - 1][i]) < 1e-12);
    tabor_room_destroy(room);
  }
}

static void *no_memory(size_t size, void *context) {
  uint32_t *const left = context;
  return (*left)-- > 0 ? malloc(size) : NULL;
}

static void give_back(void *memory, void *context) {
  (void)context;
  free(memory);
}

static void bad_requests_are_refused(void **state) {
  (void)state;
  TaborDrumDef def = drum_in(TABOR_ROOM_STUDIO);
  TaborRoom *room = (TaborRoom *)&def;
  TaborError error;
  assert_int_equal(tabor_room_create(NULL, 48000, NULL, &room, &error), TABOR_ERROR_ARGUMENT);
  assert_null(room);
  assert_int_equal(tabor_room_create(&def, 48000, NULL, NULL, &error), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_room_create(&def, 8000, NULL, &room, &error), TABOR_ERROR_RANGE);
  assert_int_equal(tabor_room_create(&def, NAN, NULL, &room, &error), TABOR_ERROR_RANGE);
  for (uint32_t left = 0; left < 2; left++) {
    uint32_t count = left;
    const TaborAllocator allocator = {no_memory, give_back, &count};
    assert_int_equal(tabor_room_create(&def, 48000, &allocator, &room, &error), TABOR_ERROR_MEMORY);
    assert_null(room);
  }
  def.room.tilt = 0.01;
  assert_int_equal(tabor_room_create(&def, 48000, NULL, &room, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, "room.tilt");
  tabor_room_destroy(NULL);
}

int main(int argc, char **argv) {
  const struct CMUnitTest sounds[] = {
    cmocka_unit_test(every_octave_decays_as_asked),
    cmocka_unit_test(late_sound_has_the_energy_of_a_diffuse_field),
    cmocka_unit_test(all_that_comes_back_is_a_diffuse_field),
    cmocka_unit_test(echoes_become_dense),
    cmocka_unit_test(no_tone_rings),
    cmocka_unit_test(a_ringing_tone_would_be_found),
  };
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(levels_and_gains_scale_the_room),
    cmocka_unit_test(a_feed_counts_as_the_drum_at_a_metre),
    cmocka_unit_test(microphones_inside_a_drum_hear_no_room),
    cmocka_unit_test(first_reflections_come_from_six_images),
    cmocka_unit_test(blocks_change_no_bit),
    cmocka_unit_test(responses_of_feeds_are_undone),
    cmocka_unit_test(channels_may_be_the_feeds_themselves),
    cmocka_unit_test(no_room_changes_no_bit),
    cmocka_unit_test(a_saved_state_continues_to_the_same_bit),
    cmocka_unit_test(damaged_and_forged_states_are_refused),
    cmocka_unit_test(rooms_fall_asleep_and_wake),
    cmocka_unit_test(lines_take_half_of_a_feeds_energy),
    cmocka_unit_test(no_room_grows),
    cmocka_unit_test(drums_without_a_pair_feed_their_farthest_microphone),
    cmocka_unit_test(kinds_have_the_sizes_and_decays_of_the_header),
    cmocka_unit_test(bad_requests_are_refused),
  };
  const bool brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const int failed = brief ? 0 : cmocka_run_group_tests(sounds, NULL, NULL);
  return failed + cmocka_run_group_tests(tests, NULL, NULL);
}
