/* SPDX-License-Identifier: MIT */
/* Frequency responses of microphones: their curves, minimum phase at every rate, no latency; and a
 * drum whose microphone has one is heard as the flat microphone hears it, through these sections.
 */
#include "model/mic_response.h"

#include <complex.h>

#include "physics.h"

static const double PI = 3.14159265358979323846;
static const double RATES[] = {44100.0, 48000.0, 88200.0, 96000.0, 192000.0};
/* What the header promises up to 16 kHz [dB]. */
static const double CURVE_TOLERANCE = 0.2;
/* Of a fit by four sections to points drawn by hand [dB]. */
static const double POINT_TOLERANCE = 0.5;
/* Outputs are rounded to float, before the sections here and after the drum's. */
static const double ROUNDING = 1e-6;

enum { KINDS = 5, BANDS = 30, FRAMES = 4800 };

static bool brief; /* under sanitizers: at draft alone */

static const double THIRD_OCTAVES[BANDS] = {
  20,  25,  31.5, 40,   50,   63,   80,   100,  125,  160,  200,  250,  315,   400,   500,
  630, 800, 1000, 1250, 1600, 2000, 2500, 3150, 4000, 5000, 6300, 8000, 10000, 12500, 16000};

/* The analogue sections by scipy.signal.freqs, over their value at 1 kHz [dB]. */
static const double CURVES[KINDS][BANDS] = {
  [TABOR_RESPONSE_DYNAMIC] = {-13.51, -12.43, -11.11, -9.60, -8.10, -6.53, -4.95, -3.59,
                              -2.40,  -1.34,  -0.64,  -0.18, 0.06,  0.10,  0.03,  -0.06,
                              -0.08,  0.00,   0.16,   0.43,  0.77,  1.26,  2.03,  3.22,
                              4.76,   6.00,   4.85,   2.42,  -0.96, -9.95},
  [TABOR_RESPONSE_LARGE_DYNAMIC] = {-3.68, -2.22, -0.44, 1.60,  3.49,  4.91,  5.09,  4.10,
                                    2.58,  0.75,  -0.97, -2.65, -3.99, -4.25, -3.44, -2.22,
                                    -1.01, 0.00,  0.97,  2.14,  3.39,  4.86,  6.44,  7.37,
                                    6.74,  4.84,  2.25,  -0.82, -4.80, -10.00},
  [TABOR_RESPONSE_CONDENSER] = {-3.95, -3.02, -2.15, -1.42, -0.91, -0.55, -0.32, -0.19,
                                -0.12, -0.07, -0.04, -0.02, -0.01, -0.01, 0.00,  0.00,
                                0.00,  0.00,  0.00,  0.00,  0.01,  0.02,  0.06,  0.17,
                                0.42,  1.00,  2.02,  2.67,  2.19,  -0.60},
  [TABOR_RESPONSE_EVEN_DYNAMIC] = {-22.89, -19.74, -16.73, -14.00, -11.88, -10.07, -8.50, -7.12,
                                   -5.71,  -4.06,  -2.58,  -1.32,  -0.45,  -0.02,  0.10,  0.09,
                                   0.04,   0.00,   -0.03,  -0.04,  -0.03,  -0.01,  0.03,  0.05,
                                   0.03,   -0.15,  -0.90,  -3.49,  -9.56,  -18.42}};

/* Points that the curves were to meet [Hz], [dB]. */
static const struct {
  uint32_t kind;
  double frequency, level;
} POINTS[] = {
  {TABOR_RESPONSE_DYNAMIC, 100.0, -4.0},      {TABOR_RESPONSE_DYNAMIC, 300.0, 0.0},
  {TABOR_RESPONSE_DYNAMIC, 4000.0, 3.0},      {TABOR_RESPONSE_DYNAMIC, 6000.0, 6.0},
  {TABOR_RESPONSE_DYNAMIC, 12000.0, 0.0},     {TABOR_RESPONSE_DYNAMIC, 16000.0, -10.0},
  {TABOR_RESPONSE_LARGE_DYNAMIC, 80.0, 5.0},  {TABOR_RESPONSE_LARGE_DYNAMIC, 400.0, -4.1},
  {TABOR_RESPONSE_LARGE_DYNAMIC, 4e3, 7.4},   {TABOR_RESPONSE_LARGE_DYNAMIC, 16e3, -10.0},
  {TABOR_RESPONSE_CONDENSER, 40.0, -1.4},     {TABOR_RESPONSE_CONDENSER, 3000.0, 0.0},
  {TABOR_RESPONSE_CONDENSER, 10000.0, 2.7},   {TABOR_RESPONSE_CONDENSER, 16000.0, -0.6},
  {TABOR_RESPONSE_EVEN_DYNAMIC, 150.0, -4.5}, {TABOR_RESPONSE_EVEN_DYNAMIC, 6e3, 0.0},
  {TABOR_RESPONSE_EVEN_DYNAMIC, 10e3, -3.5},  {TABOR_RESPONSE_EVEN_DYNAMIC, 16e3, -18.5}};

/* [dB] */
static double level_at(const TbMicResponse *response, double frequency, double rate) {
  const double complex back = cexp(-2.0 * I * PI * frequency / rate);
  double complex gain = 1.0;
  for (uint32_t i = 0; i < response->count; i++) {
    const TbSection *s = &response->section[i];
    gain *= (s->b0 + back * (s->b1 + back * s->b2)) / (1.0 + back * (s->a1 + back * s->a2));
  }
  return 20.0 * log10(cabs(gain));
}

static void curves_are_the_same_at_every_rate(void **state) {
  (void)state;
  for (size_t r = 0; r < sizeof RATES / sizeof *RATES; r++) {
    double worst = 0.0;
    for (uint32_t kind = 1; kind < KINDS; kind++) {
      TbMicResponse response;
      tb_mic_response_prepare(&response, kind, RATES[r]);
      assert_true(fabs(level_at(&response, 1000.0, RATES[r])) < 1e-9);
      for (int band = 0; band < BANDS; band++) {
        const double level = level_at(&response, THIRD_OCTAVES[band], RATES[r]);
        worst = fmax(worst, fabs(level - CURVES[kind][band]));
      }
    }
    print_message("%g Hz: off by %.3f dB at most\n", RATES[r], worst);
    assert_true(worst < CURVE_TOLERANCE);
  }
}

static void curves_meet_their_points(void **state) {
  (void)state;
  for (size_t i = 0; i < sizeof POINTS / sizeof *POINTS; i++) {
    TbMicResponse response;
    tb_mic_response_prepare(&response, POINTS[i].kind, 96000.0);
    const double level = level_at(&response, POINTS[i].frequency, 96000.0);
    assert_true(fabs(level - POINTS[i].level) < POINT_TOLERANCE);
  }
}

/* p0 z^2 + p1 z + p2 has its zeros inside the unit circle; false for NaN. */
static bool is_inside(double p0, double p1, double p2) {
  return fabs(p2) < p0 && fabs(p1) < p0 + p2;
}

static void every_rate_has_minimum_phase(void **state) {
  (void)state;
  for (uint32_t kind = 1; kind < KINDS; kind++) {
    for (double rate = 22050.0; rate <= 192000.0; rate += 25.0) {
      TbMicResponse response;
      tb_mic_response_prepare(&response, kind, rate);
      assert_int_equal(response.count, TB_RESPONSE_SECTIONS);
      for (uint32_t i = 0; i < response.count; i++) {
        const TbSection *s = &response.section[i];
        assert_true(is_inside(1.0, s->a1, s->a2) && is_inside(s->b0, s->b1, s->b2));
      }
    }
  }
}

static void an_impulse_is_heard_at_once(void **state) {
  (void)state;
  for (uint32_t kind = 0; kind < KINDS; kind++) {
    TbMicResponse response;
    TbResponseMemory memory = {{0.0}};
    tb_mic_response_prepare(&response, kind, 48000.0);
    double product = 1.0;
    for (uint32_t i = 0; i < response.count; i++) product *= response.section[i].b0;
    assert_true(tb_mic_respond(&response, memory, 1.0) == product && product > 0.1);
  }
}

static void flat_has_no_sections(void **state) {
  (void)state;
  TbMicResponse response;
  TbResponseMemory memory = {{0.0}};
  tb_mic_response_prepare(&response, TABOR_RESPONSE_FLAT, 48000.0);
  assert_int_equal(response.count, 0);
  assert_true(tb_mic_respond(&response, memory, 0.123) == 0.123);
}

/* ---- drums ---------------------------------------------------------------------------------- */

static TaborDrumDef small_def(uint32_t response) {
  const TaborDrumDef preset = physics_preset("snare-14x5.5");
  TaborDrumDef def = physics_small(&preset);
  def.mic[0].response = response;
  return def;
}

/* What the first two microphones hear of a stroke. */
static void play(TaborDrum *drum, const TaborEvent *event, uint32_t frames, float *first,
                 float *second) {
  float *outputs[TABOR_MAX_MICS] = {first, second};
  tabor_drum_process(drum, event, event ? 1 : 0, outputs, frames);
}

static void render(uint32_t response, uint32_t quality, float *first, float *second) {
  const TaborDrumDef def = small_def(response);
  TaborModel *model = physics_model(&def, 48000.0, quality);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(&def);
  play(drum, &strike, FRAMES, first, second);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

static double peak_of(const float *sound) {
  double peak = 0.0;
  for (int i = 0; i < FRAMES; i++) peak = fmax(peak, fabs((double)sound[i]));
  return peak;
}

static uint32_t first_of(const float *sound) {
  uint32_t i = 0;
  while (i < FRAMES && sound[i] == 0.0f) i++;
  return i;
}

static float flat[2][FRAMES], heard[2][FRAMES];

static void drums_are_heard_through_the_sections(void **state) {
  (void)state;
  const uint32_t qualities[] = {TABOR_QUALITY_DRAFT,
                                TABOR_QUALITY_STUDIO}; /* one step a frame, two */
  for (int q = 0; q < (brief ? 1 : 2); q++) {
    render(TABOR_RESPONSE_FLAT, qualities[q], flat[0], flat[1]);
    const double peak = peak_of(flat[0]);
    assert_true(peak > 0.01);
    for (uint32_t kind = 1; kind < KINDS; kind++) {
      TbMicResponse response;
      TbResponseMemory memory = {{0.0}};
      tb_mic_response_prepare(&response, kind, 48000.0);
      render(kind, qualities[q], heard[0], heard[1]);
      for (int i = 0; i < FRAMES; i++) {
        const double wanted = tb_mic_respond(&response, memory, (double)flat[0][i]);
        assert_true(fabs((double)heard[0][i] - wanted) < ROUNDING * peak);
      }
      assert_int_equal(first_of(heard[0]), first_of(flat[0]));
      assert_memory_equal(heard[1], flat[1], sizeof flat[1]); /* the other is flat */
    }
  }
}

/* A swap to the same model goes on to the bit; one to another response fades over. */
static void swapped(uint32_t from, uint32_t to, float *first, float *second) {
  const TaborDrumDef def = small_def(from), other = small_def(to);
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborModel *next = physics_model(&other, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  TaborSwap *swap;
  assert_int_equal(tabor_swap_create(model, next, &swap, NULL), TABOR_OK);
  const TaborEvent strike = physics_strike(&def), event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  play(drum, &strike, FRAMES / 2, first, second);
  play(drum, &event, FRAMES / 2, first + FRAMES / 2, second + FRAMES / 2);
  assert_true(tabor_swap_done(swap));
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  tabor_model_release(model);
  tabor_model_release(next);
}

static void the_same_response_goes_on_after_a_swap(void **state) {
  (void)state;
  render(TABOR_RESPONSE_DYNAMIC, TABOR_QUALITY_DRAFT, flat[0], flat[1]);
  swapped(TABOR_RESPONSE_DYNAMIC, TABOR_RESPONSE_DYNAMIC, heard[0], heard[1]);
  assert_memory_equal(heard, flat, sizeof flat);
}

/* For 8 ms the former response is heard alone; the new one has then settled, and fades in over 8
 * ms. */
static void another_response_fades_in_after_a_swap(void **state) {
  (void)state;
  static float after[2][FRAMES];
  const int hold = FRAMES / 2 + 384, end = hold + 385;
  render(TABOR_RESPONSE_FLAT, TABOR_QUALITY_DRAFT, flat[0], flat[1]);
  render(TABOR_RESPONSE_DYNAMIC, TABOR_QUALITY_DRAFT, after[0], after[1]);
  swapped(TABOR_RESPONSE_FLAT, TABOR_RESPONSE_DYNAMIC, heard[0], heard[1]);
  for (int i = 0; i < hold; i++) assert_true(heard[0][i] == flat[0][i]);
  const double peak = peak_of(flat[0]);
  double most = 0.0;
  for (int i = end; i < FRAMES; i++) {
    most = fmax(most, fabs((double)heard[0][i] - (double)after[0][i]));
  }
  print_message("what the new response has not heard: %.1e of the peak\n", most / peak);
  assert_true(most < 1e-5 * peak); /* its slowest pole falls by 120 dB in 16 ms */
}

/* ---- definitions ---------------------------------------------------------------------------- */

static void a_definition_names_the_response(void **state) {
  (void)state;
  TaborDrumDef def;
  TaborError error = {0};
  char text[32];
  tabor_drum_def_default(&def);
  assert_int_equal(def.mic[0].response, TABOR_RESPONSE_FLAT);
  const char *const words[KINDS] = {"flat", "dynamic", "large-dynamic", "condenser",
                                    "even-dynamic"};
  for (uint32_t kind = 0; kind < KINDS; kind++) {
    assert_int_equal(tabor_drum_def_set(&def, "mic.top.response", words[kind], NULL), TABOR_OK);
    assert_int_equal(def.mic[0].response, kind);
    assert_int_equal(tabor_drum_def_get(&def, "mic.top.response", text, sizeof text, NULL),
                     TABOR_OK);
    assert_string_equal(text, words[kind]);
  }
  assert_int_equal(tabor_drum_def_set(&def, "mic.top.response", "ribbon", &error),
                   TABOR_ERROR_VALUE);
  assert_non_null(strstr(error.message, "ribbon"));
  assert_non_null(strstr(error.message, "large-dynamic"));
  def.mic[0].response = KINDS;
  assert_int_equal(tabor_drum_def_validate(&def, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, "mic.top.response");
}

int main(int argc, char **argv) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(curves_are_the_same_at_every_rate),
    cmocka_unit_test(curves_meet_their_points),
    cmocka_unit_test(every_rate_has_minimum_phase),
    cmocka_unit_test(an_impulse_is_heard_at_once),
    cmocka_unit_test(flat_has_no_sections),
    cmocka_unit_test(drums_are_heard_through_the_sections),
    cmocka_unit_test(the_same_response_goes_on_after_a_swap),
    cmocka_unit_test(another_response_fades_in_after_a_swap),
    cmocka_unit_test(a_definition_names_the_response),
  };
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  return cmocka_run_group_tests(tests, NULL, NULL);
}
