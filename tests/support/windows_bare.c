/* SPDX-License-Identifier: MIT */
/* A program for Microsoft's target without a C runtime: it plays a stroke with tabor.dll, and ends with status 0 if the
 * sound's bits have the hash HASH, a macro. Elsewhere it prints that hash. */
#include <tabor/tabor.h>

enum { FRAMES = 4800 };

static TaborDrumDef def; /* too large for a stack that nobody probes */
static TaborModelOptions options;
static TaborError error;
static float sound[FRAMES];

static unsigned hash_of_sound(void) {
  const unsigned char *bytes = (const unsigned char *)sound;
  unsigned hash = 2166136261u; /* FNV-1a */
  for (unsigned i = 0; i < sizeof sound; i++) hash = (hash ^ bytes[i]) * 16777619u;
  return hash;
}

/* 0, or the status of what failed. */
static unsigned play(void) {
  TaborModel *model;
  TaborDrum *drum;
  static TaborEvent strike;
  static float *outputs[TABOR_MAX_MICS];
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_LIVE;
  if (tabor_drum_def_preset(&def, "tabor", &error) != TABOR_OK) return 2;
  if (tabor_model_create(&def, &options, &model, &error) != TABOR_OK) return 3;
  if (tabor_drum_create(model, &drum, &error) != TABOR_OK) return 4;
  strike.type = TABOR_EVENT_STRIKE;
  strike.velocity = 2.5;
  strike.radius = 0.05;
  outputs[0] = sound;
  tabor_drum_process(drum, &strike, 1, outputs, FRAMES);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return 0;
}

#ifdef _WIN32
int _fltused; /* Microsoft's compilers refer to it where numbers have points */
__declspec(dllimport) void __stdcall ExitProcess(unsigned status);

void start(void) {
  const unsigned status = play();
  ExitProcess(status == 0 && hash_of_sound() != HASH ? 1 : status);
}
#else
#  include <stdio.h>

int main(void) {
  const unsigned status = play();
  printf("0x%xu\n", hash_of_sound());
  return (int)status;
}
#endif
