#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the CLAP plugins' binary exports, its size, the controls in the documentation, and what clap-validator says of
# the plugins: nothing.
#
# test_clap_validate.sh [long]
#
# It gets $CLAP, the binary, and $SOURCE. clap-validator is looked for in $CLAP_VALIDATOR and in $PATH. With `long` it
# runs all of its tests, which takes minutes.
. "$(dirname "$0")/../../support/host_checks.sh"
: "${CLAP:?the binary}" "${SOURCE:?the source}"

# ---- the binary ----

same "what it exports" clap_entry "$(nm -D --defined-only "$CLAP" | awk '{ print $3 }')"
same "libraries of other builds that it needs" "" "$(readelf -d "$CLAP" | grep NEEDED | grep -i libtabor)"
holds "it is below 3 MB" "$(stat -c %s "$CLAP") < 3000000"

# ---- the documentation ----

symbols=$(sed -n 's/.*\.symbol = "\([a-z_]*\)".*/\1/p' "$SOURCE"/host/plugin/{,kit_}knobs.c)
holds "there are controls" "$(wc -w <<<"$symbols") > 20"
for symbol in $symbols; do
  check "docs/plugins.md has $symbol" grep -q "\`${symbol}[0-9\`]" "$SOURCE/docs/plugins.md"
done

# What it says of installing, where no plugin has been installed yet.
mkdir build home && ln -s "${CLAP%/clap/*}" build/release
command=$(grep -oE 'mkdir[^`]*cp build/release/clap/tabor\.clap [^`]*/' "$SOURCE/docs/plugins.md")
check "'$command'" env HOME="$work/home" bash -c "$command"
check "the plugin is there" cmp -s "$CLAP" "$work/home/.clap/tabor.clap"

# ---- clap-validator ----

validator=${CLAP_VALIDATOR:-$(command -v clap-validator || true)}
if [ -z "$validator" ]; then
  skip_part "clap-validator is not installed (github.com/free-audio/clap-validator)"
  finish
  exit
fi
# Two tests of preset discovery lock a mutex of version 0.4.1 twice as soon as a plugin has a second preset;
# test_clap_presets is in their place.
excluded='preset-discovery-(crawl|load)'
[ "${1:-}" = long ] || excluded+='|fuzz|varying|random-block|sleep|wildcard|out-of-place'
# In its own process it sets no time limit.
"$validator" validate --in-process --exclude "$excluded" "$CLAP" >"$out" 2>&1
same "clap-validator's status" 0 $?
sed -i 's/\x1b\[[0-9;]*m//g' "$out"
check "it finds neither failure nor warning" grep -qE '^[0-9]+ tests run, [0-9]+ passed, 0 failed, 0 warnings' "$out"
holds "it tests both plugins" "$(tail -1 "$out" | awk '{ print $4 }') > 30"
grep -E 'FAILED|CRASHED|WARNING' -B 12 "$out"

finish
