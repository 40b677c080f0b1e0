# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by tools/check after build.sh: runs tests, counts what passed, failed and was skipped, and says so.
#
# In continuous integration (CI=true) a skip is a failure if packages of this system would have prevented it, or
# if the test does not say why it skips.

# shellcheck source=tools/packages.sh
. "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

passed=0
failed=0
failures=()
skips=()

pass() { passed=$((passed + 1)); }
fail() { failed=$((failed + 1)); failures+=("$1"); }

# skip NAME REASON
skip() {
  if [ "${CI-}" = true ] && ! is_excused "$2"; then
    fail "$1 (skipped: ${2:-it does not say why})"
  else
    skips+=("$1${2:+ ($2)}")
  fi
}

# is_excused REASON: it names something else than missing packages, or a package that this system does not have.
is_excused() {
  local package pattern='(^| )needs ([a-z0-9.+ -]+)$'
  if [ -z "$1" ]; then return 1; fi
  if ! [[ $1 =~ $pattern ]]; then return 0; fi
  for package in ${BASH_REMATCH[2]}; do
    if ! is_installed "$package" && ! is_available "$package"; then return 0; fi
  done
  return 1
}

# run_tests LABEL FOLDER: runs the tests of a build and counts them.
run_tests() {
  local label=$1 folder=$2
  rm -f "$folder/Testing/Temporary/LastTest.log"
  # ctest's status says what its lines say; those are counted.
  (cd "$folder" && ctest --output-on-failure --parallel "$jobs" --no-tests=error) 2>&1 |
    tee "$folder/tests.txt" || true
  count_tests "$label" "$folder"
}

# Counts what ctest reported.
count_tests() {
  local label=$1 folder=$2 line name reason ran=0
  local -A explained=()
  while IFS=$'\t' read -r name reason; do
    explained[${name%%:*}]=yes
    skip "$name ($label)" "$reason"
  done < <(skipped_parts "$folder/Testing/Temporary/LastTest.log")

  while IFS= read -r line; do
    name=$(sed -E 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: ([^ ]+) .*/\1/' <<<"$line")
    ran=$((ran + 1))
    case $line in
      *" Passed "*) pass ;;
      *"***Skipped"*) if [ -z "${explained[$name]-}" ]; then skip "$name ($label)" ""; fi ;;
      *) fail "$name ($label)" ;;
    esac
  done < <(grep -E '^ *[0-9]+/[0-9]+ Test +#[0-9]+: ' "$folder/tests.txt")
  if [ "$ran" -eq 0 ]; then fail "ctest ($label)"; fi
}

# Reads ctest's log. Prints "TEST<tab>REASON" for each "SKIPPED: REASON", and "TEST: CASE<tab>REASON" for each case
# that cmocka skipped, whose reason stands before it. cmocka lists its skipped cases twice.
skipped_parts() {
  if [ ! -e "$1" ]; then return 0; fi
  awk '
    function flush() { if (reason != "") print test "\t" reason; reason = "" }
    /^[0-9]+\/[0-9]+ Testing: / { flush(); test = $3 }
    /^SKIPPED: / { flush(); reason = substr($0, 10) }
    /^\[  SKIPPED \] [A-Za-z_][A-Za-z0-9_]*$/ && !seen[test, $4]++ {
      print test ": " $4 "\t" reason
      reason = ""
    }
    END { flush() }' "$1"
}

join() {
  local separator=$1 text=$2
  shift 2
  printf '%s' "$text" "${@/#/$separator}"
}

# The last line has the counts. Fails if a test has failed.
summary() {
  echo
  if [ "$failed" -gt 0 ]; then echo "Failed: $(join ', ' "${failures[@]}")"; fi
  local line="$passed passed, $failed failed, ${#skips[@]} skipped"
  if [ ${#skips[@]} -gt 0 ]; then line+=": $(join ', ' "${skips[@]}")"; fi
  echo "$line"
  [ "$failed" -eq 0 ]
}
