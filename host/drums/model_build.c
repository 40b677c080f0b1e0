/* SPDX-License-Identifier: MIT */
#include "drums/model_build.h"

#include <stdatomic.h>
#include <stdio.h>
#include <unistd.h>

#include "platform/clock.h"

/* [s]: shorter builds need no announcement. A build that takes 5 s is announced although estimates
 * are right within a factor of 3 alone. */
static const double LONG = 5.0 / 3.0;
static const double GLANCE = 0.25; /* [s] between two looks at the progress */

static atomic_int shown; /* announced builds that go on */

typedef struct Watch {
  double next; /* time of the next look [s] */
  bool on_terminal;
} Watch;

static bool show(double done, void *context) {
  Watch *const watch = context;
  const double now = stopwatch_seconds(CLOCK_MONOTONIC);
  char text[64];
  if (!watch->on_terminal || now < watch->next) return true;
  watch->next = now + GLANCE;
  (void)snprintf(text, sizeof text, "building the drum, %d %%", (int)(100.0 * done));
  status_line(text);
  return true;
}

bool model_build_is_shown(void) { return atomic_load(&shown) > 0; }

Outcome model_build_quietly(const TaborDrumDef *def, const TaborModelOptions *options,
                            TaborModel **model) {
  TaborError error;
  const TaborStatus status = tabor_model_create(def, options, model, &error);
  return status == TABOR_OK ? OUTCOME_OK : report_engine_error(&error);
}

static Outcome build_shown(const TaborDrumDef *def, const TaborModelOptions *options,
                           TaborModel **model) {
  TaborModelOptions watched = *options;
  Watch watch = {.on_terminal = isatty(STDERR_FILENO)};
  watched.progress = show;
  watched.progress_context = &watch;
  atomic_fetch_add(&shown, 1);
  const Outcome outcome = model_build_quietly(def, &watched, model);
  if (atomic_fetch_sub(&shown, 1) == 1 && watch.on_terminal) status_line("");
  return outcome;
}

Outcome model_build(const TaborDrumDef *def, const TaborModelOptions *options, TaborModel **model) {
  TaborModelEstimate estimate;
  const TaborStatus status = tabor_model_estimate(def, options, &estimate, NULL);
  if (status != TABOR_OK || estimate.seconds < LONG) {
    return model_build_quietly(def, options, model);
  }
  note("tabor: building '%s' takes some %.0f s and %.0f MB of memory; %s costs the most", def->name,
       estimate.seconds, 1e-6 * (double)estimate.bytes, estimate.key);
  return build_shown(def, options, model);
}
