#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What validators say of the plugins' description, nothing; what the binary exports, one symbol; and that
# lv2bench runs them.
#
# It gets $BUNDLE, $SOURCE, and $INSPECT for host_checks.sh.
. "$(dirname "$0")/../../support/host_checks.sh"
needs lv2-dev lv2_validate
needs sordi sord_validate
needs lilv-utils lv2bench lv2ls lv2info
: "${BUNDLE:?the bundle}"
export LV2_PATH=/usr/lib/lv2:${BUNDLE%/*}

# ---- the description ----

# clean FILE...: what the validator says but that it has found nothing.
clean() { lv2_validate "$@" 2>&1 | grep -vE '^(Found 0 errors among|Skipping file)'; }
same "lv2_validate" "" "$(clean "$BUNDLE"/*.ttl)"
mapfile -t schemas < <(find /usr/lib/lv2 -name '*.ttl' ! -path '*/eg-*')
same "sord_validate" "" \
  "$(sord_validate "${schemas[@]}" "$BUNDLE"/*.ttl 2>&1 | grep -vE '^(Found 0 errors among|Skipping file)')"

# A validator that finds nothing anywhere would be worth nothing.
sed 's/lv2:symbol "gain"/lv2:symbol "5 gain"/' "$BUNDLE/tabor.ttl" >tabor.ttl
check "it finds a bad symbol" test -n "$(clean "$BUNDLE/manifest.ttl" tabor.ttl)"

same "hosts find all plugins" "urn:tabor:drum urn:tabor:drum-multi urn:tabor:effect urn:tabor:kit" \
  "$(lv2ls 2>"$err" | grep '^urn:tabor' | sort | tr '\n' ' ' | sed 's/ $//')"
same "and say nothing about them" "" "$(grep -i tabor "$err")"

# Every control is in the documentation.
for symbol in $(sed -n 's/^\t\tlv2:symbol "\([a-z_1-8]*\)" ;$/\1/p' "$BUNDLE/tabor.ttl" | sort -u); do
  case $symbol in events | freewheel | out_* | *_[2-7]) continue ;; esac # from `level_1` to `level_8`
  check "docs/plugins.md has $symbol" grep -q "\`$symbol\`" "$SOURCE/docs/plugins.md"
done

# ---- installing ----

# What the README and the documentation say, where no plugin has been installed yet.
mkdir build && ln -s "${BUNDLE%/lv2/*}" build/release
for page in README.md docs/plugins.md; do
  command=$(grep -oE '(mkdir[^`]*)?cp -r build/release/lv2/tabor\.lv2 [^`]*/' "$SOURCE/$page")
  home=$work/home-${page##*/}
  mkdir "$home"
  check "$page: '$command'" env HOME="$home" bash -c "$command"
  same "$page: the bundle" "" "$(diff -r "$BUNDLE" "$home/.lv2/tabor.lv2" 2>&1)"
done

# In a prefix of one's own it is found with the path that is said there.
local=$work/home/.local/lib/lv2
mkdir -p "$local" && cp -r "$BUNDLE" "$local"
path=$(grep -o 'export LV2_PATH=.*' "$SOURCE/docs/plugins.md")
check "found with '$path'" grep -qF "$local/tabor.lv2" \
  <(HOME=$work/home bash -c "$path; lv2info urn:tabor:drum" 2>&1)

# ---- the binary ----

same "what it exports" lv2_descriptor "$(nm -D --defined-only "$BUNDLE/tabor.so" | awk '{ print $3 }')"
same "libraries of other builds that it needs" "" "$(readelf -d "$BUNDLE/tabor.so" | grep NEEDED | grep -i libtabor)"

# ---- a host that measures ----

for plugin in urn:tabor:drum urn:tabor:drum-multi urn:tabor:effect urn:tabor:kit; do
  lv2bench -n 48000 "$plugin" >"$out" 2>"$err"
  same "lv2bench of $plugin" 0 $?
  holds "it measures something: $(cat "$out")" "$(awk '{ print $1 }' "$out") > 0"
done

finish
