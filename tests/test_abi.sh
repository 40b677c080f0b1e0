#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Programs that were built against the last release run with this library: nothing that its interface had
# is gone or means something else, unless the library has another name. abi/README.md says how the record
# is renewed.
# shellcheck source=tests/embed_checks.sh
. "$(dirname "$0")/embed_checks.sh"
needs abidiff
record=$SOURCE/tests/abi

# abidiff takes a file that is not there for one without a difference.
for file in "$record/libtabor.abi" "$record/libtabor.abignore" "$SHARED_BUILD/engine/libtabor.so"; do
  [ -s "$file" ] || complain "there is no $file"
done

compare() {
  abidiff --headers-dir1 "$SOURCE/engine/include" --headers-dir2 "$SOURCE/engine/include" \
    --suppressions "$record/libtabor.abignore" --no-added-syms "$@"
}

# A library without a function of the record has to be noticed, or the test is worth nothing.
sed "s/tabor_drum_process/tabor_drum_of_old/g" "$record/libtabor.abi" >other.abi
if compare other.abi "$SHARED_BUILD/engine/libtabor.so" >/dev/null; then
  complain "a function that is gone was not noticed"
fi

soname() { grep -oE "soname='[^']*'" | head -n 1; }
was=$(soname <"$record/libtabor.abi")
is="soname='$(readelf -d "$SHARED_BUILD/engine/libtabor.so" | sed -nE 's/.*\(SONAME\).*\[(.*)\]/\1/p')'"
if [ "$was" != "$is" ]; then
  echo "the library has a new name, $is: it may differ from the one of $was"
  exit 0
fi
compare "$record/libtabor.abi" "$SHARED_BUILD/engine/libtabor.so" >difference || {
  cat difference >&2
  complain "programs built against the last release would break; tests/abi/README.md says what to do"
}
