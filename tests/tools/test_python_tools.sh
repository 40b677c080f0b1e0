#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The tools in Python tell what they do without any package that Python does not bring along, and then name the
# packages that they lack; with these, plot-trace draws.
#
# test_python_tools.sh SOURCE-FOLDER
tests=$(cd "$(dirname "$0")/.." && pwd)
source=$1
. "$tests/support/host_checks.sh"
. "$tests/support/find_python.sh"
needs python3 python3
export PYTHONDONTWRITEBYTECODE=1

# bare ARGUMENT...: runs a Python that finds nothing but its own library.
bare() {
  python3 -S -E "$@" >"$out" 2>"$err"
  status=$?
}
bare -c 'import numpy'
same "a Python without NumPy" 1 "$status"

mapfile -t tools < <(grep -lx '#!/usr/bin/env python3' "$source"/tools/* "$source"/tools/docs/* 2>/dev/null)
holds "tools in Python" "${#tools[@]} >= 16"
for tool in "${tools[@]}"; do
  bare "$tool" --help
  same "${tool##*/} --help" "0 0" "$status $(wc -c <"$err")"
  check "${tool##*/}: its usage" grep -q '^usage: ' "$out"
done

# asks_for PACKAGES TOOL ARGUMENT...: ends with one line that tells to install exactly these.
asks_for() {
  local packages=$1 tool=$2
  shift 2
  bare "$source/tools/$tool" "$@"
  same "$tool $* without packages" "1 1 apt install $packages, and start it with /usr/bin/python3" \
    "$status $(wc -l <"$err") $(grep -o 'apt install .*' "$err")"
}
sounds="python3-numpy python3-scipy python3-matplotlib"
asks_for "python3-numpy python3-matplotlib" plot-trace strike.csv
asks_for "python3-numpy python3-matplotlib python3-scipy" plot-trace strike.csv --wav strike.wav
asks_for "python3-numpy python3-matplotlib" bench
for tool in make-reference.py radiation_reference.py; do asks_for "python3-numpy python3-scipy" $tool; done
asks_for "$sounds python3-soundfile" compare-recordings
asks_for "python3-numpy python3-scipy python3-soundfile" compare-takes
asks_for "python3-numpy python3-scipy python3-soundfile python3-cmaes python3-matplotlib python3-threadpoolctl" recover-drums drums
for tool in render-examples rudiments docs/{compare-qualities,make-playing,make-validation,room-picture}; do
  asks_for "$sounds" $tool
done

if python=$(find_python numpy,matplotlib); then
  done_quietly render tabor --quality draft --duration 0.1 -q -o strike.wav --trace strike.csv
  check "plot-trace draws a trace" "$python" "$source/tools/plot-trace" strike.csv --energy -o trace.png
  same "a picture" PNG "$(head -c 4 trace.png | tail -c 3)"
else
  skip_part "drawing: needs python3-numpy python3-matplotlib"
fi
if python=$(find_python numpy,matplotlib,scipy); then
  check "and a sound" "$python" "$source/tools/plot-trace" --wav strike.wav -o sound.png
  same "its picture" PNG "$(head -c 4 sound.png | tail -c 3)"
fi
finish
