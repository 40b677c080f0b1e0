#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The VST3 bundle: its files, what its binary exports and needs, what its description says, and how the documentation
# installs it.
#
# It gets $BUNDLE and $SOURCE.
. "$(dirname "$0")/../../support/host_checks.sh"
: "${BUNDLE:?the bundle}" "${SOURCE:?the source}"

contents=$BUNDLE/Contents
binary=$contents/$(uname -m | sed 's/^i.86$/i386/')-linux/Tabor.so

# ---- the files ----

same "the bundle's files" "./Resources/licenses.txt ./Resources/moduleinfo.json .${binary#"$contents"}" \
  "$(cd "$contents" && find . -type f | LC_ALL=C sort | xargs)"
for owner in "Steinberg Media Technologies" "defiantnerd\|Timo Kaluza" "Alexandre BIQUE"; do
  check "licenses.txt names $owner" grep -q "$owner" "$contents/Resources/licenses.txt"
done

# ---- the binary ----

same "what it exports" "GetPluginFactory ModuleEntry ModuleExit" \
  "$(nm -D --defined-only "$binary" | awk '{ print $3 }' | sort | xargs)"
same "libraries that it needs beyond C's and those of its window" "" \
  "$(readelf -d "$binary" | sed -nE 's/.*\(NEEDED\).*\[(.*)\]/\1/p' | grep -vE '^(libc|libm|ld-linux.*|libdl|libpthread|libcairo|libxcb|libxkbcommon|libxkbcommon-x11)\.so')"
holds "it is below 4 MB" "$(stat -c %s "$binary") < 4000000"

# ---- the description ----

field() { sed -nE "s/^ *\"$1\": \"(.*)\",\$/\1/p" "$contents/Resources/moduleinfo.json"; }
same "the plugins" $'Tabor\nTabor\nTabor Multi\nTabor Kit\nTabor Rattle' "$(field Name)"
version=$("$TABOR" --version | cut -d ' ' -f 2)
same "their version" "$version"$'\n'"$version"$'\n'"$version"$'\n'"$version"$'\n'"$version" "$(field Version)"
# Sessions find the plugins by these. They follow from the identities of the CLAP plugins.
same "their identities" $'C86E4CCAD0C951CFBEC9BC84A948AAD2\n4DFA43F7834C5514AFB9115F37AC4D11\n7877BE08BB6E5A618CF6D77615924476\n6DFDBE4F31225462BABE153EE3EAE4A7' "$(field CID)"

# ---- the documentation ----

# What it says of installing, where no plugin has been installed yet.
mkdir build home && ln -s "${BUNDLE%/vst3/*}" build/release
command=$(grep -oE 'mkdir[^`]*cp -r build/release/vst3/Tabor\.vst3 [^`]*/' "$SOURCE/docs/plugins.md")
check "'$command'" env HOME="$work/home" bash -c "$command"
check "the bundle is there" diff -r "$BUNDLE" "$work/home/.vst3/Tabor.vst3"

finish
