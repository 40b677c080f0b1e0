/* SPDX-License-Identifier: MIT */
#include "plugin/builder.h"

#include <stdio.h>
#include <string.h>

#include "plugin/model_cache.h"

/* What is nearly done is finished: a knob that turns all the time would never be heard otherwise.
 */
static const double NEARLY = 0.5; /* [s] */

/* Also called by threads that wait for a model that another instance builds. */
static bool goes_on(double done, void *context) {
  const Builder *const builder = context;
  if (atomic_load(&builder->is_cancelled)) return false;
  return !(atomic_load(&builder->is_outdated) && (1.0 - done) * builder->seconds > NEARLY);
}

void builder_begin(Builder *builder, double rate, BuilderSayFn *say, void *context) {
  memset(builder, 0, sizeof *builder);
  tabor_model_options_default(&builder->options);
  builder->options.sample_rate = rate;
  builder->options.most_seconds = BUILDER_MOST_SECONDS;
  builder->options.most_bytes = BUILDER_MOST_BYTES;
  builder->options.progress = goes_on;
  builder->options.progress_context = builder;
  builder->say = say;
  builder->context = context;
}

void builder_cancel(Builder *builder) { atomic_store(&builder->is_cancelled, true); }

void builder_resume(Builder *builder) { atomic_store(&builder->is_cancelled, false); }

bool builder_take(Builder *builder) {
  unsigned asked = BUILDER_ASKED;
  return atomic_compare_exchange_strong(&builder->phase, &asked, BUILDER_BUILDING);
}

void builder_answer(Builder *builder) { atomic_store(&builder->phase, BUILDER_ANSWERED); }

TaborStatus builder_model(Builder *builder, const TaborDrumDef *def, uint32_t quality,
                          TaborModel **model, TaborError *error) {
  TaborModelOptions options = builder->options;
  TaborModelEstimate estimate;
  for (options.quality = quality;; options.quality--) {
    TaborStatus status = tabor_model_estimate(def, &options, &estimate, error);
    if (status != TABOR_OK) return status;
    builder->seconds = estimate.seconds;
    status = model_cache_take(def, &options, model, error);
    if (status != TABOR_ERROR_LIMIT || options.quality <= TABOR_QUALITY_DRAFT) return status;
    builder_say(builder, "the next lower quality plays", error);
  }
}

void builder_say_line(const Builder *builder, const char *line) {
  if (builder->say) builder->say(builder->context, line);
}

void builder_say(const Builder *builder, const char *what, const TaborError *error) {
  char line[2 * TABOR_TEXT_SIZE];
  (void)snprintf(line, sizeof line, "%s: %s", what, error->message);
  builder_say_line(builder, line);
}

void builder_say_held(Builder *builder) {
  if (builder->has_said_held) return;
  builder->has_said_held = true;
  builder_say_line(builder,
                   "studio and reference are for export; in real time the quality is live");
}

TaborStatus builder_out_of_memory(TaborError *error) {
  *error = (TaborError){.status = TABOR_ERROR_MEMORY, .message = "out of memory"};
  return TABOR_ERROR_MEMORY;
}
