/* SPDX-License-Identifier: MIT */
/* What a kit's sound costs is counted in processor time, whatever else the machine does meanwhile:
 * here the clocks of the system are the test's own. */
#include "render/offline_player.h" /* before cmocka, whose fail() is a macro */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <time.h>

#include <cmocka.h>

enum { BLOCKS = 3 };

int __wrap_clock_gettime(clockid_t clock, struct timespec *time);

/* At each look a second of processor time has passed, and an hour of the day. */
int __wrap_clock_gettime(clockid_t clock, struct timespec *time) {
  static time_t looks;
  looks++;
  *time = (struct timespec){.tv_sec = clock == CLOCK_PROCESS_CPUTIME_ID ? looks : 3600 * looks};
  return 0;
}

static void the_cost_is_processor_time(void **state) {
  (void)state;
  static OfflinePlayer player;
  static RenderRequest request;
  static TaborKitDef kit;
  render_request_clear(&request);
  assert_int_equal(tabor_kit_def_preset(&kit, "standard", NULL), TABOR_OK);
  kit.drum_count = 1;
  render_request_set_kit(&request, &kit);
  tabor_model_options_default(&request.model);
  request.model.quality = TABOR_QUALITY_DRAFT;
  request.threads = 1;
  request.channels = 2;
  request.mics[1] = 1;
  request.gain = 1;
  assert_int_equal(offline_player_open(&player, &request), OUTCOME_OK);
  for (int i = 0; i < BLOCKS; i++) {
    assert_int_equal(offline_player_play(&player, OFFLINE_BLOCK), OUTCOME_OK);
  }
  assert_int_equal(player.position, BLOCKS * OFFLINE_BLOCK);
  assert_float_equal(player.computing, BLOCKS, 1e-9);
  offline_player_free(&player);
  render_request_free(&request);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(the_cost_is_processor_time)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
