/* SPDX-License-Identifier: MIT */
/* Which modes a place on a head moves. */
#include "physics.h"

#include "drum/drum.h"
#include "model/model.h"

/* Largest displacement of the head at a mode of unit modal mass, over the radius. */
static void largest_on(const TaborModel *model, uint32_t head, double *most) {
  enum { PLACES = 200 };
  double *radial = calloc(model->body.row_count, sizeof *radial);
  for (uint32_t place = 0; place < PLACES; place++) {
    tb_body_radial(&model->body, head, model->body.radius * place / PLACES, NULL, radial);
    for (uint32_t row = 0; row < model->body.row_count; row++) {
      most[row] = fmax(most[row], fabs(radial[row]));
    }
  }
  free(radial);
}

static bool is_left_out(TbModeRanges kept, uint32_t mode) {
  return mode >= kept.first && !(mode >= kept.from && mode < kept.from + kept.size);
}

static void a_head_leaves_out_what_moves_it_by_less_than_a_fiftieth(void **state) {
  (void)state;
  static const char *const PRESETS[] = {"bass-drum-22", "tom-12", "snare-14x5.5"};
  for (size_t p = 0; p < sizeof PRESETS / sizeof PRESETS[0]; p++) {
    const TaborDrumDef def = physics_preset(PRESETS[p]);
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    double *most[TB_HEADS];
    for (uint32_t h = 0; h < TB_HEADS; h++) {
      most[h] = calloc(model->body.row_count, sizeof *most[h]);
      largest_on(model, h, most[h]);
    }
    uint32_t out = 0;
    for (uint32_t h = 0; h < TB_HEADS; h++) {
      const TbModeRanges kept = tb_modes_of_head(&model->modes, h);
      for (uint32_t i = 0; i < model->modes.padded; i++) {
        const uint32_t row = model->modes.row[i];
        if (!is_left_out(kept, i) || row == TB_NO_MODE) continue;
        out++;
        assert_true(most[h][row] < 0.02 * most[1 - h][row]);
      }
    }
    print_message("%s: %u of %u modes left out\n", PRESETS[p], out, model->modes.count);
    assert_true(out > model->modes.count / 8);
    for (uint32_t h = 0; h < TB_HEADS; h++) free(most[h]);
    tabor_model_release(model);
  }
}

static void a_drum_with_one_head_leaves_out_none(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const TbModeRanges kept = tb_modes_of_head(&model->modes, TABOR_HEAD_BATTER);
  assert_int_equal(kept.first, model->modes.padded);
  assert_int_equal(kept.size, 0);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_head_leaves_out_what_moves_it_by_less_than_a_fiftieth),
    cmocka_unit_test(a_drum_with_one_head_leaves_out_none),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
