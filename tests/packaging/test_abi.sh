#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Programs that were built against the last release run with this library: nothing that its interface had
# is gone or means something else, unless the library has another name. abi/README.md says how the record
# is renewed.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
needs abigail-tools abidiff
record=$SOURCE/tests/packaging/abi

# abidiff takes a file that is not there for one without a difference.
for file in "$record/libtabor.abi" "$record/libtabor.abignore" "$SHARED_BUILD/engine/libtabor.so"; do
  [ -s "$file" ] || complain "there is no $file"
done

# compare SUPPRESSIONS RECORD: without the headers, for the record has no locations, and abidiff takes types
# without a location in them for private ones, of which nobody may hear.
compare() {
  abidiff --suppressions "$1" --no-added-syms "$2" "$SHARED_BUILD/engine/libtabor.so"
}

# A library without a function of the record has to be noticed, or the test is worth nothing.
sed "s/tabor_drum_process/tabor_drum_of_old/g" "$record/libtabor.abi" >other.abi
if compare "$record/libtabor.abignore" other.abi >/dev/null; then
  complain "a function that is gone was not noticed"
fi

# So has a struct of another size, once there has been a release.
sed '/^# Until the first release/,$d' "$record/libtabor.abignore" >released.abignore
sed -E "s/(<class-decl name='TaborEvent' size-in-bits=')[0-9]+/\11024/" "$record/libtabor.abi" >other.abi
status=0
compare released.abignore other.abi >difference || status=$?
if [ $((status & 4)) = 0 ] || ! grep -q "'struct TaborEvent' changed" difference; then
  cat difference >&2
  complain "a struct of another size was not noticed: abidiff ended with $status, without 4"
fi

soname() { grep -oE "soname='[^']*'" | head -n 1; }
was=$(soname <"$record/libtabor.abi")
is="soname='$(readelf -d "$SHARED_BUILD/engine/libtabor.so" | sed -nE 's/.*\(SONAME\).*\[(.*)\]/\1/p')'"
if [ "$was" != "$is" ]; then
  echo "the library has a new name, $is: it may differ from the one of $was"
  exit 0
fi
compare "$record/libtabor.abignore" "$record/libtabor.abi" >difference || {
  cat difference >&2
  complain "programs built against the last release would break; tests/packaging/abi/README.md says what to do"
}
