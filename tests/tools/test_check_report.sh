#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/check_report.sh: what tools/check counts and says of a run of ctest, and which skips are failures in
# continuous integration.
#
# test_check_report.sh SOURCE-FOLDER
set -euo pipefail
source=$1
jobs=1
# shellcheck source=tools/check_report.sh
. "$source/tools/check_report.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wrong=0

# The system of this test: valgrind can be installed, and lv2-dev is.
is_installed() { [ "$1" = lv2-dev ]; }
is_available() { [ "$1" = valgrind ]; }

# same WHAT EXPECTED ACTUAL
same() {
  if [ "$2" = "$3" ]; then return; fi
  printf '%s: expected\n%s\ngot\n%s\n' "$1" "$2" "$3" | sed 's/^/| /' # no line that tools/check would read
  wrong=$((wrong + 1))
}

# add NAME COMMAND...: a test of the run.
add() {
  local name=$1
  shift
  {
    printf 'add_test("%s"' "$name"
    printf ' [==[%s]==]' "$@"
    printf ')\nset_tests_properties("%s" PROPERTIES SKIP_RETURN_CODE 77)\n' "$name"
  } >>"$work/CTestTestfile.cmake"
}

# report CI: runs these tests; its last lines.
report() {
  (CI=$1 && run_tests build "$work" >"$work/out" 2>&1 && summary | tail -n 2) || true
}

# A folder of tools without valgrind in it.
mkdir "$work/bin"
for tool in bash dirname; do ln -s "$(command -v "$tool")" "$work/bin/$tool"; done
hidden=(env "PATH=$work/bin" bash "$source/tests/code/test_leaks.sh" false 1)

# ---- nothing to complain of ----

add whole true
add root bash -c 'echo "SKIPPED: permissions mean nothing to root"'
same "it is said why, and packages would not help" \
  $'\n2 passed, 0 failed, 1 skipped: root (build) (permissions mean nothing to root)' "$(report true)"

add case bash -c 'echo "SKIPPED: no AVX2"; for i in 1 2; do echo "[  SKIPPED ] a_case"; done; exit 0'
add unknown bash -c 'echo "SKIPPED: needs clang-22"; exit 77'
named="3 skipped: root (build) (permissions mean nothing to root), case: a_case (build) (no AVX2), unknown (build) (needs clang-22)"
same "a case is one skip, and so is a package that is nowhere" \
  $'\n'"3 passed, 0 failed, $named" "$(report true)"

# ---- a tool that is hidden ----

add leaks "${hidden[@]}"
all="$named, leaks (build) (there is no valgrind: needs valgrind)"
same "elsewhere it is a skip" $'\n'"3 passed, 0 failed, 4${all#3}" "$(report "")"
same "in continuous integration it is a failure" \
  $'Failed: leaks (build) (skipped: there is no valgrind: needs valgrind)\n'"3 passed, 1 failed, $named" \
  "$(report true)"
same "which the status says" "1 0" \
  "$(for ci in true ""; do (CI=$ci; run_tests build "$work" >/dev/null; summary >/dev/null) && echo 0 || echo 1; done | xargs)"

# ---- other failures ----

: >"$work/CTestTestfile.cmake"
add silent bash -c 'exit 77'
add parts bash -c 'echo "SKIPPED: C++: needs lv2-dev"; echo "SKIPPED: sound: needs valgrind nothing-like-it"'
add broken bash -c 'exit 1'
same "a skip without a reason, a part, a failure" \
  $'Failed: parts (build) (skipped: C++: needs lv2-dev), silent (build) (skipped: it does not say why), broken (build)
1 passed, 3 failed, 1 skipped: parts (build) (sound: needs valgrind nothing-like-it)' "$(report true)"
same "elsewhere" $'Failed: broken (build)
1 passed, 1 failed, 3 skipped: parts (build) (C++: needs lv2-dev), parts (build) (sound: needs valgrind nothing-like-it), silent (build)' \
  "$(report "")"
: >"$work/CTestTestfile.cmake"
same "no test at all" $'Failed: ctest (build)\n0 passed, 1 failed, 0 skipped' "$(report true)"

exit $((wrong > 0))
