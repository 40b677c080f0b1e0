#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/bench: a profiling build has timers, which the library as it is released has not (test_timers), and a
# moment's measurement gives all figures.
#
# test_bench_tool.sh SOURCE-FOLDER CMAKE COMPILER

source_dir=$1 cmake=$2 compiler=$3
. "$(dirname "$0")/../support/host_checks.sh"

profile=$private/profile
{
  "$cmake" -S "$source_dir" -B "$profile" -DCMAKE_C_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_C_FLAGS_RELEASE=-O1 -DTABOR_PROFILE=ON -DTABOR_BUILD_PROGRAM=OFF -DTABOR_WARNINGS_AS_ERRORS=ON &&
    "$cmake" --build "$profile" --target profile-stages --parallel 2
} >"$private/log" 2>&1 || { cat "$private/log" && exit 1; }
stages=$profile/tools/profile-stages

timers() { nm "$1" | grep -c tb_profile; }
holds "timers in the profiling library" "$(timers "$profile/engine/libtabor.a") > 0"

"$stages" frame-drum seconds=0.1 repeats=1 quality=draft >"$out"
same "what profile-stages says" "preset rate seconds repeats modes high_modes wires contact_points grid \
model_bytes drum_bytes build_s real_time_factor block_time_us stages sample compiler" "$(json keys)"
holds "it plays" "$(json real_time_factor.smallest) > 0 && $(json stages.modes.ns) > 0"
holds "it counts memory" \
  "$(json sample.bytes) > $(json stages.modes.bytes) && $(json stages.modes.bytes) > 8 * $(json modes)"
"$stages" no-such-drum >"$out" 2>"$err"
same "an unknown preset" "2 1" "$? $(wc -l <"$err")"

if ! command -v python3 >/dev/null; then
  skip_part "tools/bench --quick: needs python3"
  finish
  exit
fi

"$source_dir/tools/bench" --quick --program "$TABOR" --stages "$stages" >"$out" 2>"$err" ||
  complain "tools/bench --quick: $(cat "$err")"
same "its figures" "version machine quality rounds repeats presets instructions qualities wires bandwidths \
stages instances" "$(json keys)"
same "the machine" "processor system cores virtual caches load compiler" "$(json machine.keys)"
row="preset rate instructions quality settings block real_time_factor idle_factor block_time_us modes contacts"
for list in presets instructions qualities wires bandwidths; do
  holds "$list" "$(json $list.size) > 0"
  same "a row of $list" "$row" "$(json $list.0.keys)"
  holds "a factor of $list" "$(json $list.0.real_time_factor.smallest) > 0 && \
    $(json $list.0.real_time_factor.median) >= $(json $list.0.real_time_factor.smallest)"
done
same "stages" "other modes projection wires strikers stretch laws products ledger high_band mics" \
  "$(json stages.0.stages.keys)"
same "instances" "1 2" "$(json instances.0.count) $(json instances.1.count)"
same "folder after it" "" "$(ls -A)"

finish
