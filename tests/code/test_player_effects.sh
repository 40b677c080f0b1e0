#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks the calls in the sources of the program's and the plugins' audio threads with clang's -Wfunction-effects.
# test_player_sanitizer watches the calls while they play.
#
# test_player_effects.sh SOURCE [CLAP-HEADERS]
set -eu
source=$1 clap=${2:-}
# shellcheck source=tests/support/find_clang.sh
. "$source/tests/support/find_clang.sh"
# shellcheck source=tests/support/skips.sh
. "$source/tests/support/skips.sh"
compiler=$(find_clang) || skip "needs clang-22"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}

# The engine's functions and the system's that are safe: test_realtime_symbols looks into them.
headers=$source/engine/include/tabor
{
  echo '#include <pthread.h>'
  echo '#include <time.h>'
  echo '#include <tabor/kit.h>'
  awk '/^ \* [A-Z-]+: / { audio = $2 == "AUDIO:" || $2 == "ANY:" } /^\/\*\* @} \*\/$/ { audio = 0 }
    audio && /^TABOR_API/, audio && /;/ { sub(/;/, " __attribute__((nonblocking));"); print }' "$headers/tabor.h" "$headers/kit.h"
  echo 'int clock_gettime(clockid_t, struct timespec *) __attribute__((nonblocking));'
  echo 'pthread_t pthread_self(void) __attribute__((nonblocking));'
} >"$work/safe.h"

# effects FILE: what the compiler says of it.
effects() {
  "$compiler" -std=c11 -D_XOPEN_SOURCE=700 -I"$source/engine/include" -I"$source/host" ${clap:+-isystem "$clap"} \
    -include "$work/safe.h" -Wfunction-effects -Werror -fsyntax-only "$1" 2>&1
}
plugins="plugin/drum_instrument plugin/instrument plugin/kit_instrument plugin/kit_plugin_player plugin/knob plugin/knobs plugin/model_worker plugin/plugin_run plugin/plugin_player plugin/plugin_player_input
  plugin/plugin_player_model plugin/plugin_player_sound plugin/window_link"
if pkg-config --exists lv2; then
  plugins+=" lv2/instance lv2/midi_sequence lv2/sequence"
else
  skip_part "the LV2 plugins: needs lv2-dev"
fi
if [ -n "$clap" ]; then
  plugins+=" clap/instance clap/note_events clap/parameters clap/ports"
else
  skip_part "the CLAP plugins: there are no CLAP headers (tools/setup --plugins brings them)"
fi
names="sound/player sound/drum_player base/spsc_queue sound/frame_clock sound/ring_out strokes/humanize
  midi/midi_to_events midi/midi_speed midi/midi_stream"
for name in $names $plugins; do
  effects "$source/host/$name.c" || fail "-Wfunction-effects: $name.c"
done
# A check that finds nothing anywhere would be worth nothing.
sed 's/^  introduce_thread(player);$/&/; s/^    introduce_thread(player);$/&\n    player->record = realloc(player->record, 1);/' \
  "$source/host/sound/player.c" | sed '1i #include <stdlib.h>' >"$work/wrong.c"
if cmp -s "$source/host/sound/player.c" "$work/wrong.c" || effects "$work/wrong.c" >"$work/said"; then
  fail "-Wfunction-effects does not see realloc()"
fi
grep -q realloc "$work/said" || fail "-Wfunction-effects names something else"

[ $failures = 0 ]
