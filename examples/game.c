/* SPDX-License-Identifier: MIT */
/**
 * @file game.c
 * A game: balls fall on a drum, and each collision is a stroke with its speed. miniaudio.h (one
 * file, https://miniaud.io) brings the sound out: game [null]; `null` plays to no device.
 */
#define MINIAUDIO_IMPLEMENTATION
#include <miniaudio.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <tabor/tabor.h>

enum { BALLS = 3, STROKES = 64 };

/* The game's thread writes strokes, the audio thread reads them. */
static TaborEvent strokes[STROKES];
static atomic_uint written, read_so_far;
static atomic_uint loudest; /* sample so far, in millionths */

static void collide(double speed, double radius) { /* the game's thread */
  const unsigned at = atomic_load(&written);
  if (at - atomic_load(&read_so_far) == STROKES) return; /* too many at once */
  strokes[at % STROKES] =
    (TaborEvent){.type = TABOR_EVENT_STRIKE, .velocity = speed, .radius = radius};
  atomic_store(&written, at + 1);
}

static void play(ma_device *device, void *out, const void *in, ma_uint32 frames) {
  TaborEvent events[STROKES];
  const unsigned from = atomic_load(&read_so_far), to = atomic_load(&written);
  float *outputs[TABOR_MAX_MICS] = {out}; /* the first microphone; the others are not asked for */
  (void)in;
  for (unsigned i = from; i != to; i++) events[i - from] = strokes[i % STROKES];
  atomic_store(&read_so_far, to);
  tabor_drum_process(device->pUserData, events, to - from, outputs, frames);
  for (ma_uint32 i = 0; i < frames; i++) {
    const unsigned level = (unsigned)(1e6f * (outputs[0][i] < 0 ? -outputs[0][i] : outputs[0][i]));
    if (level > atomic_load(&loudest)) atomic_store(&loudest, level);
  }
}

/* Two seconds at 120 pictures a second. */
static unsigned run_game(void) {
  double height[BALLS] = {0.4, 0.8, 1.2}, speed[BALLS] = {0}; /* [m], [m/s] upwards */
  unsigned collisions = 0;
  for (int picture = 0; picture < 240; picture++, ma_sleep(1000 / 120)) {
    for (int i = 0; i < BALLS; i++) {
      speed[i] -= 9.81 / 120;
      height[i] += speed[i] / 120;
      if (height[i] > 0 || speed[i] > -0.1) continue;
      collide(-speed[i], 0.03 * (i + 1)); /* each ball at its own place */
      collisions++;
      speed[i] *= -0.7;
      height[i] = 0;
    }
  }
  return collisions;
}

int main(int argc, char **argv) {
  const ma_backend none[] = {ma_backend_null};
  const bool is_silent = argc > 1 && strcmp(argv[1], "null") == 0;
  TaborDrumDef def;
  TaborModel *model = NULL;
  TaborDrum *drum = NULL;
  TaborModelOptions options;
  ma_device device;
  ma_device_config config = ma_device_config_init(ma_device_type_playback);
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  options.sample_rate = config.sampleRate = 48000;
  if (tabor_drum_def_preset(&def, "tom-12", NULL) != TABOR_OK ||
      tabor_model_create(&def, &options, &model, NULL) != TABOR_OK ||
      tabor_drum_create(model, &drum, NULL) != TABOR_OK)
    return 1;
  config.playback.format = ma_format_f32;
  config.playback.channels = 1;
  config.dataCallback = play;
  config.pUserData = drum;
  if (ma_device_init_ex(is_silent ? none : NULL, is_silent, NULL, &config, &device) != MA_SUCCESS ||
      ma_device_start(&device) != MA_SUCCESS)
    return (void)fprintf(stderr, "game: there is no sound output\n"), 1;
  const unsigned collisions = run_game();
  ma_device_uninit(&device);
  printf("%u collisions, peak %.3f\n", collisions, 1e-6 * atomic_load(&loudest));
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return 0;
}
