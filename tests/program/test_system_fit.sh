#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tabor fit: it starts the Python package's module with the same options, or says how to install that.

. "$(dirname "$0")/../support/host_checks.sh"
module=$(cd "$(dirname "$0")/../.." && pwd)/python/src/tabor/fit/__main__.py

# A Python that has what fitting takes and does as it is told, or one that has not.
mkdir bin
cat >bin/python3 <<'END'
#!/bin/sh
case $1 in
  -c) exit "$HAS" ;;
  *) printf '%s\n' "$@"; exit "$STATUS" ;;
esac
END
chmod +x bin/python3
ln -s python3 bin/python
export PATH=$work/bin:$PATH HAS=0 STATUS=0

run fit drum.toml -o "a folder" --rounds=30,20 -q
same "status" 0 "$status"
same "words" "-m tabor.fit --output a folder --rounds 30,20 --quiet -- drum.toml" "$(tr '\n' ' ' <"$out" | sed 's/ $//')"
STATUS=1 run fit drum.toml
same "the module's status" 1 "$status"
HAS=1 run fit drum.toml
expect_error 1 "pip install 'tabor\[fit\]'"
run fit
expect_error 2 "no request"
run fit drum.toml --round 3
expect_error 2 "did you mean"

# Each option of the help is one of the module's, and the other way round.
run fit --help
same "the module's options" "$(grep -oE '"--[a-z]+"' "$module" | tr -d '"' | sort -u)" \
  "$(grep -oE -- '--[a-z]+' "$out" | sort -u | grep -vE -- '--(help|version)')"
same "and defaults" "$(grep -oE 'default: [0-9,]+' "$module" | sort -u)" "$(grep -oE 'default: [0-9,]+' "$out" | sort -u)"
finish
