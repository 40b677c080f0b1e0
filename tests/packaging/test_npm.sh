#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The package for npm under node: packed and installed into an empty project, it plays what `tabor render` plays, to the
# bit; refuses what the engine refuses, in its words; its types are right; and Chromium plays it, too.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/serve_folder.sh
. "$SOURCE/tests/support/serve_folder.sh"

web_tools=$SOURCE/build/web-tools
for tool in emcc node npm; do
  command -v "$tool" >/dev/null || skip "there is no $tool: tools/setup --web brings it"
done
[ -e "$web_tools/node_modules" ] || skip "there are no packages of npm: tools/setup --web brings them"

quietly "$SOURCE/tools/web" --npm
export npm_config_offline=true npm_config_cache=$scratch/cache npm_config_update_notifier=false
quietly npm pack --silent "$SOURCE/build/web/npm"
packed=$(echo tabor-*.tgz)
echo "The package: $(wc -c <"$packed") bytes"
says_size "$SOURCE/docs/web.md" 'The package is' "$(wc -c <"$packed")"
tar -tzf "$packed" | sort >files
printf 'package/%s\n' LICENSE README.md audio_node.js drum.js engine.js events.js index.d.ts index.js instrument.js kit.js node.js package.json \
  tabor.wasm worklet.js | sort |
  diff - files || complain "the package has other files"

# What publint would suggest, too.
if [ -e "$web_tools/node_modules/publint" ]; then
  quietly node "$web_tools/node_modules/publint/src/cli.js" "$packed" --strict
  grep -q 'All good' log || complain "publint: $(cat log)"
else
  skip_part "what publint says: tools/setup --web brings it"
fi

mkdir project takes
(cd project && quietly npm init -y && quietly npm install --no-audit --no-fund "../$packed")
for program in npm_strokes.mjs float_wav.mjs npm_types.ts; do cp "$SOURCE/tests/support/$program" project; done

# Each line: NAME, then what `tabor render` is told.
(cd project && node npm_strokes.mjs ../takes) >log || { cat log; complain "the package"; }
grep '^#' log || true
count=0
while read -r name options; do
  read -ra told <<<"$options"
  events=()
  if [ -e "takes/$name.csv" ]; then events=(--events "takes/$name.csv"); fi
  quietly "$TABOR" render "${told[@]}" -q --format float "${events[@]}" -o native.wav
  [ "$("$INSPECT" peak native.wav)" != 0 ] || complain "$name: there is no sound"
  "$INSPECT" equal "takes/$name.wav" native.wav || complain "$name: $options has other bits"
  count=$((count + 1))
done < <(grep '^take' log)
[ $count -eq $((7 + 2 * ${SONGS-4})) ] || complain "$count sounds"

# In a browser as it is.
export CHROMIUM=${CHROMIUM-$(command -v chromium || true)}
if [ -n "$CHROMIUM" ] && [ -e "$web_tools/node_modules/playwright-core" ]; then
  serve_folder "$SOURCE/build/web/npm"
  quietly node "$SOURCE/tests/support/npm_in_browser.mjs" "$address" "$web_tools" browser.wav node.wav
  quietly "$TABOR" render tom-12 -q --format float --stereo --duration 0.2 -o native.wav
  "$INSPECT" equal browser.wav native.wav || complain "the package has other bits in a browser"
  "$INSPECT" equal node.wav native.wav || complain "an audio node has other bits"
else
  skip_part "there is no chromium or no playwright-core: tools/setup --web brings them"
fi

version=$("$TABOR" --version | head -n 1)
[[ $version == *"$(sed -n 's/^version //p' log)"* ]] || complain "the package is $(grep ^version log), the program $version"

tsc=$web_tools/node_modules/typescript/bin/tsc
if [ -e "$tsc" ]; then
  (cd project && quietly node "$tsc" --noEmit --strict --target es2022 --module nodenext npm_types.ts)
else
  skip_part "there is no typescript: tools/setup --web brings it"
fi
