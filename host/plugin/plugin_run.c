/* SPDX-License-Identifier: MIT */
#include "plugin/plugin_run.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "platform/clock.h"

#define PAUSE 1000000 /* [ns] for another thread that is at work already */

static const InstrumentCalls *calls_of(const PluginRun *run) REALTIME;
static const InstrumentCalls *calls_of(const PluginRun *run) {
  return run->instrument->kind->calls;
}

static void turn_at(PluginRun *run, uint32_t frame) REALTIME;
static void turn_at(PluginRun *run, uint32_t frame) {
  if (!run->events->note_knobs || !run->events->note_knobs(run->shell, frame)) return;
  calls_of(run)->play(run->instrument, frame);
  instrument_turn_knobs(run->instrument);
}

static void take_at(PluginRun *run, uint32_t frame) REALTIME;
static void take_at(PluginRun *run, uint32_t frame) {
  const InstrumentCalls *const calls = calls_of(run);
  if (calls->begin_frame) calls->begin_frame(run->instrument);
  run->events->take(run->shell, frame);
  if (calls->end_frame) calls->end_frame(run->instrument, frame);
}

static bool has_to_wait(const PluginRun *run) REALTIME;
static bool has_to_wait(const PluginRun *run) {
  return run->waits && !instrument_is_settled(run->instrument) &&
         !atomic_load(&run->instrument->builder->is_cancelled);
}

/* Plays with everything that comes. False where the run has to wait for another model; then it is
 * to be called again. */
static bool go_on(PluginRun *run) REALTIME;
static bool go_on(PluginRun *run) {
  const InstrumentCalls *const calls = calls_of(run);
  uint32_t frame = run->instrument->at;
  while (run->events->find(run->shell, &frame)) {
    if (calls->is_full && calls->is_full(run->instrument)) calls->play(run->instrument, frame);
    if (!run->has_turned) turn_at(run, frame);
    run->has_turned = has_to_wait(run);
    if (run->has_turned) return false;
    take_at(run, frame);
    if (has_to_wait(run)) return false;
  }
  calls->play(run->instrument, run->frames);
  return true;
}

/* Knobs are read once a restored drum has landed: it brings what they said. True if somebody has to
 * work. */
static bool keep_up(Instrument *instrument) REALTIME;
static bool keep_up(Instrument *instrument) {
  instrument->kind->calls->receive(instrument);
  instrument_turn_knobs(instrument);
  return instrument->kind->calls->ask(instrument);
}

static void wait_for_all(Instrument *instrument) {
  const struct timespec moment = {.tv_nsec = PAUSE};
  const InstrumentCalls *const calls = instrument->kind->calls;
  for (;;) {
    if (calls->end_leaving && builder_is(instrument->builder, BUILDER_ANSWERED))
      calls->end_leaving(instrument);
    (void)keep_up(instrument);
    if (instrument_is_settled(instrument)) return;
    if (atomic_load(&instrument->builder->is_cancelled)) return;
    instrument_work(instrument);
    if (!builder_is(instrument->builder, BUILDER_ANSWERED))
      (void)nanosleep(&moment, NULL); /* another thread is at it */
  }
}

void plugin_run_waiting(PluginRun *run) {
  calls_of(run)->export_sound(run->instrument, true);
  do {
    wait_for_all(run->instrument);
  } while (!go_on(run));
}

static double now(void) REALTIME;
static double now(void) { return stopwatch_seconds(CLOCK_MONOTONIC); }

/* What the block took, for the window. */
static void note_load(const PluginRun *run, double began) REALTIME;
static void note_load(const PluginRun *run, double began) {
  WindowLink *const link = &run->instrument->window;
  if (run->frames == 0 || !atomic_load(&link->is_shown)) return;
  const double load = (now() - began) * run->instrument->rate / run->frames;
  atomic_store(&link->load, fmaxf((float)load, atomic_load(&link->load)));
}

bool plugin_run_live(PluginRun *run) {
  const double began = now();
  calls_of(run)->export_sound(run->instrument, false);
  const bool asks = keep_up(run->instrument);
  (void)go_on(run);
  note_load(run, began);
  return asks;
}

void plugin_run_prepare(Instrument *instrument) {
  memset(&instrument->buffers, 0, sizeof instrument->buffers);
  instrument_begin_block(instrument);
  instrument->kind->calls->export_sound(instrument, atomic_load(&instrument->is_offline));
  wait_for_all(instrument);
}
