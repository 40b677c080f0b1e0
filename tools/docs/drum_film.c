/* SPDX-License-Identifier: MIT */
/* drum-film PRESET SPEED FRAMES EVERY: what a drum looks like at 48 kHz after its own stroke at this
 * speed [m/s], for tools/docs/film-picture: a line of heads, circles, angles, wires, points of a
 * wire, head of the wires, radius [m], then FRAMES pictures, EVERY samples apart, as doubles on
 * standard output: heights of the heads [m], of the wires [m], forces on these [N], places of the
 * wires (x, y of both ends) [m], and of the stick radius [m], angle [deg], height [m]. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <tabor/tabor.h>

enum { RATE = 48000 };

static TaborModel *create_model(const char *preset, double speed, TaborDrumDef *def) {
  TaborModelOptions options;
  TaborModel *model = NULL;
  TaborError error;
  tabor_model_options_default(&options);
  options.sample_rate = RATE;
  options.quality = TABOR_QUALITY_LIVE;
  const bool read = tabor_drum_def_preset(def, preset, &error) == TABOR_OK;
  if (read) def->strike.velocity = speed;
  if (read && tabor_model_create(def, &options, &model, &error) == TABOR_OK) return model;
  (void)fprintf(stderr, "drum-film: %s\n", error.message);
  exit(1);
}

static void put(const double *values, size_t count) {
  (void)fwrite(values, sizeof *values, count, stdout);
}

static void put_picture(const TaborView *view) {
  const size_t points = (size_t)view->wire_count * view->wire_points;
  double stick[] = {NAN, NAN, NAN};
  for (uint32_t h = 0; h < view->heads; h++)
    put(view->displacement[h], (size_t)view->radii * view->angles);
  put(view->wires, points);
  put(view->wire_force, points);
  put(view->wire_place, 4 * (size_t)view->wire_count);
  if (view->stick_count > 0) {
    stick[0] = view->sticks[0].radius;
    stick[1] = view->sticks[0].angle;
    stick[2] = view->sticks[0].height;
  }
  put(stick, 3);
}

static int film(const char *preset, double speed, long frames, uint32_t every) {
  TaborDrumDef def;
  TaborModel *model = create_model(preset, speed, &def);
  TaborView *view = NULL;
  TaborDrum *drum = NULL;
  TaborError error;
  if (tabor_view_create(model, NULL, &view, &error) != TABOR_OK ||
      tabor_drum_create(model, &drum, &error) != TABOR_OK) {
    (void)fprintf(stderr, "drum-film: %s\n", error.message);
    return 1;
  }
  (void)printf("%u %u %u %u %u %u %.17g\n", view->heads, view->radii, view->angles,
               view->wire_count, view->wire_points, def.wires.head, view->radius);
  const TaborEvent strike = {.type = TABOR_EVENT_STRIKE,
                             .velocity = speed,
                             .radius = def.strike.radius,
                             .angle = def.strike.angle};
  for (long i = 0; i < frames; i++) {
    tabor_drum_process(drum, &strike, i == 0, NULL, every);
    (void)tabor_drum_view(drum, view);
    put_picture(view);
  }
  tabor_drum_destroy(drum);
  tabor_view_destroy(view);
  tabor_model_release(model);
  return ferror(stdout) || fflush(stdout) ? 1 : 0;
}

int main(int count, char **arguments) {
  if (count != 5) {
    (void)fputs("usage: drum-film PRESET SPEED FRAMES EVERY\n", stderr);
    return 2;
  }
  return film(arguments[1], strtod(arguments[2], NULL), strtol(arguments[3], NULL, 10),
              (uint32_t)strtoul(arguments[4], NULL, 10));
}
