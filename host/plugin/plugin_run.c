/* SPDX-License-Identifier: MIT */
#include "plugin/plugin_run.h"

#include <time.h>

#define PAUSE 1000000 /* [ns] for another thread that is at work already */

static void play_until(PluginRun *run, uint32_t end) {
  while (run->at < end) {
    run->at += plugin_player_play(run->player, run->outputs, run->at, end - run->at);
  }
}

static void turn_at(PluginRun *run, uint32_t frame) {
  if (!run->events->note_knobs(run->shell, frame)) return;
  play_until(run, frame);
  run->events->turn(run->shell);
}

static void take_at(PluginRun *run, uint32_t frame) {
  plugin_player_begin_frame(run->player);
  run->events->take(run->shell, frame, frame - run->at);
  if (!plugin_player_has_choice(run->player)) return;
  play_until(run, frame);
  plugin_player_choose(run->player);
}

static bool has_to_wait(const PluginRun *run) {
  return run->waits && !plugin_player_is_settled(run->player);
}

/* Plays with everything that comes. False where the run has to wait for another model; then it is to be called
 * again. */
static bool go_on(PluginRun *run) {
  uint32_t frame = run->at;
  while (run->events->find(run->shell, run->frames, &frame)) {
    if (plugin_player_is_full(run->player)) play_until(run, frame);
    if (!run->has_turned) turn_at(run, frame);
    run->has_turned = has_to_wait(run);
    if (run->has_turned) return false;
    take_at(run, frame);
    if (has_to_wait(run)) return false;
  }
  play_until(run, run->frames);
  return true;
}

/* Knobs are read once a restored drum has landed: it brings what they said. True if somebody has to work. */
static bool keep_up(const PluginRun *run) {
  plugin_player_receive(run->player);
  run->events->turn(run->shell);
  return plugin_player_ask(run->player);
}

bool plugin_run_live(PluginRun *run) {
  plugin_player_export(run->player, false);
  const bool asks = keep_up(run);
  (void)go_on(run);
  return asks;
}

void plugin_run_wait(const PluginRun *run) {
  const struct timespec moment = {.tv_nsec = PAUSE};
  ModelWorker *const worker = run->player->worker;
  for (;;) {
    (void)keep_up(run);
    if (plugin_player_is_settled(run->player)) return;
    model_worker_work(worker);
    if (!model_worker_reply(worker)) (void)nanosleep(&moment, NULL); /* another thread is at it */
  }
}

void plugin_run_waiting(PluginRun *run) {
  plugin_player_export(run->player, true);
  do {
    plugin_run_wait(run);
  } while (!go_on(run));
}
