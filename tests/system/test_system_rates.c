/* SPDX-License-Identifier: MIT */
/* The same drum at every sample rate: levels per tenth of a decade up to 16 kHz, and the first
 * modes.
 *
 * usage: test_system_rates [brief]: the modes alone, at 44.1 kHz. */
#include "physics.h"

static const double PI = 3.14159265358979323846;
static const double RATES[4] = {44100.0, 48000.0, 96000.0, 192000.0};

enum { BANDS = 23 }; /* 100 Hz to 16 kHz */

static bool brief;

static double band_middle(int band) { return 1000.0 * pow(10.0, 0.1 * (band - 10)); }

typedef struct Stroke {
  uint32_t count;
  double *sound, *force; /* at the first microphone, on the head */
  double step_rate;
} Stroke;

static Stroke play_at(const TaborDrumDef *def, uint32_t quality, double rate, double seconds) {
  TaborModel *model = physics_model(def, rate, quality);
  TaborDrum *drum = physics_drum(model);
  const uint32_t count = (uint32_t)(seconds * rate);
  TaborModelInfo info;
  tabor_model_info(model, &info);
  Stroke stroke = {count, malloc(count * sizeof(double)), malloc(count * sizeof(double)),
                   info.step_rate};
  TaborEvent strike = physics_strike(def);
  float sample = 0.0f;
  float *outputs[TABOR_MAX_MICS] = {&sample};
  for (uint32_t i = 0; i < count; i++) {
    TaborProbe probe;
    tabor_drum_process(drum, &strike, i == 0 ? 1 : 0, outputs, 1);
    tabor_drum_probe(drum, &probe);
    stroke.sound[i] = (double)sample;
    stroke.force[i] = isnan(probe.striker_force) ? 0.0 : probe.striker_force;
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return stroke;
}

static Stroke play(const TaborDrumDef *def, double rate, double seconds) {
  return play_at(def, TABOR_QUALITY_STUDIO, rate, seconds);
}

/* Where two steps make a sample, a probe sees one of two forces. A model at twice the rate has the
 * same steps. */
static void force_of_steps(const TaborDrumDef *def, Stroke *stroke, double rate) {
  if (stroke->step_rate == rate) return;
  Stroke twice = play(def, stroke->step_rate, stroke->count / rate);
  assert_int_equal(twice.count, 2 * stroke->count);
  free(twice.sound);
  free(stroke->force);
  stroke->force = twice.force;
}

/* Fades the second half: a tone that is cut off would sound at all frequencies. */
static void fade(Stroke *stroke) {
  const uint32_t half = stroke->count / 2;
  for (uint32_t i = half; i < stroke->count; i++) {
    stroke->sound[i] *= 0.5 + 0.5 * cos(PI * (i - half) / (stroke->count - half));
  }
}

static void stroke_free(Stroke *stroke) {
  free(stroke->sound);
  free(stroke->force);
}

/* |Fourier integral|^2 of count samples at f. */
static double power_at(const double *x, uint32_t count, double f, double rate) {
  const double turn = 2.0 * PI * f / rate, c = cos(turn), s = sin(turn);
  double re = 0.0, im = 0.0, wr = 1.0, wi = 0.0;
  for (uint32_t i = 0; i < count; i++) {
    re += x[i] * wr;
    im -= x[i] * wi;
    const double next = wr * c - wi * s;
    wi = wr * s + wi * c;
    wr = next;
  }
  return (re * re + im * im) / (rate * rate);
}

typedef struct Levels {
  double sound[BANDS], response[BANDS]; /* [dB]; response: per force */
} Levels;

static void band_levels(const Stroke *stroke, double rate, Levels *levels) {
  const double step = rate / stroke->count;
  const uint32_t per_sample = (uint32_t)lround(stroke->step_rate / rate);
  for (int band = 0; band < BANDS; band++) {
    const double low = band_middle(band) * pow(10.0, -0.05), high = low * pow(10.0, 0.1);
    double sound = 0.0, force = 0.0;
    for (double f = ceil(low / step) * step; f < high; f += step) {
      sound += power_at(stroke->sound, stroke->count, f, rate);
      force += power_at(stroke->force, per_sample * stroke->count, f, stroke->step_rate);
    }
    levels->sound[band] = 10.0 * log10(sound);
    levels->response[band] = 10.0 * log10(sound / force);
  }
}

static double compare(const char *what, double levels[4][BANDS], double top) {
  double worst = 0.0;
  print_message("%s: 44.1, 48, 96 against 192 kHz [dB]\n", what);
  for (int band = 0; band < BANDS; band++) {
    print_message("%6.0f Hz:", band_middle(band));
    for (int r = 0; r < 3; r++) {
      const double off = levels[r][band] - levels[3][band];
      print_message(" %+6.2f", off);
      if (band_middle(band) < 1.01 * top) worst = fmax(worst, fabs(off));
    }
    print_message(" of %+7.2f\n", levels[3][band]);
  }
  return worst;
}

/* What a force makes of sound depends on no rate. The force itself is the solver's: with two steps
 * per sample below 88.2 kHz, and with its loss of treble made good, the sound of a medium and of a
 * hard stroke agrees too. */
static void levels_agree_from_44_to_192_kHz(void **state) {
  (void)state;
  if (brief) return;
  static const double SPEEDS[2] = {2.0, 10.0};
  for (int speed = 0; speed < 2; speed++) {
    TaborDrumDef def = physics_preset("frame-drum");
    def.strike.velocity = SPEEDS[speed];
    double sound[4][BANDS], response[4][BANDS];
    for (int r = 0; r < 4; r++) {
      Stroke stroke = play(&def, RATES[r], 0.1);
      Levels levels;
      force_of_steps(&def, &stroke, RATES[r]);
      fade(&stroke);
      band_levels(&stroke, RATES[r], &levels);
      memcpy(sound[r], levels.sound, sizeof sound[r]);
      memcpy(response[r], levels.response, sizeof response[r]);
      stroke_free(&stroke);
    }
    print_message("%g m/s\n", SPEEDS[speed]);
    assert_true(compare("sound per force", response, 16000.0) < 0.5);
    assert_true(compare("sound", sound, 16000.0) < 0.5);
  }
}

/* Levels of one stroke [dB]. */
static void live_levels(const TaborDrumDef *def, double rate, double *levels) {
  Stroke stroke = play_at(def, TABOR_QUALITY_LIVE, rate, 0.1);
  Levels found;
  fade(&stroke);
  band_levels(&stroke, rate, &found);
  memcpy(levels, found.sound, sizeof found.sound);
  stroke_free(&stroke);
}

/* Live steps once per sample: means over strokes at three places and speeds, against 96 kHz. What
 * is left of the error of a mean of two instants grows with the square of the frequency: see
 * force_equalizer.h. */
static void live_toms_agree_from_44_to_96_kHz(void **state) {
  (void)state;
  static const char *const TOMS[] = {"tom-12", "floor-tom-16"};
  static const double STROKES[3][2] = {
    {1.0, 0.1}, {4.5, 0.75}, {8.0, 0.5}}; /* [m/s], of the radius */
  if (brief) return;
  for (int tom = 0; tom < 2; tom++) {
    double off[2][BANDS] = {{0.0}};
    for (int i = 0; i < 3; i++) {
      TaborDrumDef def = physics_preset(TOMS[tom]);
      double levels[3][BANDS];
      def.strike.velocity = STROKES[i][0];
      def.strike.radius = STROKES[i][1] * def.shell.radius;
      for (int r = 0; r < 3; r++) live_levels(&def, RATES[r], levels[r]);
      for (int r = 0; r < 2; r++) {
        for (int band = 0; band < BANDS; band++)
          off[r][band] += (levels[r][band] - levels[2][band]) / 3.0;
      }
    }
    for (int band = 0; band < BANDS; band++) {
      print_message("%s, %6.0f Hz: %+.2f %+.2f dB\n", TOMS[tom], band_middle(band), off[0][band],
                    off[1][band]);
      const double most = band_middle(band) < 13000.0 ? 3.0 : 6.0;
      assert_true(fabs(off[0][band]) < most && fabs(off[1][band]) < most);
    }
  }
}

/* Of a decaying mode, from the phase that it gains between two Hann windows. */
static double frequency_near(const double *x, uint32_t count, double guess, double rate) {
  const uint32_t length = (uint32_t)(0.5 * rate), gap = (uint32_t)(0.05 * rate);
  double phase[2];
  for (int w = 0; w < 2; w++) {
    double re = 0.0, im = 0.0;
    for (uint32_t i = 0; i < length; i++) {
      const uint32_t at = i + (w ? gap : 0);
      assert_true(at < count);
      const double window = 0.5 - 0.5 * cos(2.0 * PI * (i + 0.5) / length);
      re += window * x[at] * cos(2.0 * PI * guess * at / rate);
      im -= window * x[at] * sin(2.0 * PI * guess * at / rate);
    }
    phase[w] = atan2(im, re);
  }
  return guess + remainder(phase[1] - phase[0], 2.0 * PI) * rate / (2.0 * PI * gap);
}

static void the_first_modes_agree_from_44_to_192_kHz(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("frame-drum");
  def.batter.damping_0 = 3.0; /* rings long enough to tell neighbours apart */
  def.strike.radius = 0.11;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  double listed[8];
  for (uint32_t row = 0; row < 8; row++) {
    TaborModeInfo mode;
    assert_true(tabor_model_mode(model, row, &mode));
    listed[row] = mode.frequency;
  }
  tabor_model_release(model);
  for (int r = 0; r < 4; r++) {
    Stroke stroke = play(&def, RATES[r], 0.6);
    const uint32_t skip = (uint32_t)(0.02 * RATES[r]);
    for (int row = 0; row < 8; row++) {
      const double seen =
        frequency_near(stroke.sound + skip, stroke.count - skip, listed[row], RATES[r]);
      const double cents = 1200.0 * log2(seen / listed[row]);
      print_message("%6.0f Hz: %9.3f Hz listed, heard %+.3f cent off\n", RATES[r], listed[row],
                    cents);
      assert_true(fabs(cents) < 2.0);
    }
    stroke_free(&stroke);
    if (brief) break;
  }
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(levels_agree_from_44_to_192_kHz),
    cmocka_unit_test(live_toms_agree_from_44_to_96_kHz),
    cmocka_unit_test(the_first_modes_agree_from_44_to_192_kHz),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
