/* SPDX-License-Identifier: MIT */
#include "midi/midi_clock.h"

static const double DRIFT = 1e-3; /* of the port's clock against ours at most */
static const double JUMP = 0.05;  /* [s]: later than that, the port's clock did not tell */

double midi_clock_take(MidiClock *clock, double later, double now) {
  if (!clock->is_running || !(later >= 0)) later = 0;
  clock->port += later;
  const double shift = now - clock->port, most = clock->shift + DRIFT * later;
  const bool follows = clock->is_running && shift > most && shift < most + JUMP;
  clock->shift = follows ? most : shift;
  clock->is_running = true;
  return clock->port + clock->shift;
}
