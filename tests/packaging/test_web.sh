#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The page of tools/web in headless Chromium and Firefox: strokes by mouse, touch, keys and MIDI files on drums as they come and with every
# control moved, recorded there, have the same bits as the command that the page shows makes; no error, no request to anybody else, nothing that axe objects to, at most 335 KB compressed.
# PICTURES=FOLDER keeps pictures of the page. PLAY_SECONDS=60 also plays for so long, and prints how many gaps the sound had.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/serve_folder.sh
. "$SOURCE/tests/support/serve_folder.sh"

most_bytes=335000 # of the page, compressed
web_tools=$SOURCE/build/web-tools
CHROMIUM=${CHROMIUM-$(command -v chromium || true)}
export CHROMIUM
for tool in emcc node "$CHROMIUM"; do
  command -v "$tool" >/dev/null || skip "there is no ${tool:-chromium}: tools/setup --web brings it"
done
FIREFOX=${FIREFOX-$(command -v firefox-esr || command -v firefox || true)}
for tool in "$FIREFOX" pulseaudio; do
  command -v "$tool" >/dev/null || skip "there is no ${tool:-firefox}: tools/setup --web brings it"
done
for package in playwright-core puppeteer-core; do
  [ -e "$web_tools/node_modules/$package" ] || skip "there is no $package: tools/setup --web brings it"
done

quietly "$SOURCE/tools/web" --build
bytes=$(tar -C "$SOURCE/build/web/page" -cf - . | gzip -9 | wc -c)
echo "The page: $bytes bytes compressed"
[ "$bytes" -le $most_bytes ] || complain "the page has more than $most_bytes bytes"
says_size "$SOURCE/docs/web.md" 'Its files are' "$bytes"

serve_folder "$SOURCE/build/web/page"
mkdir takes

# The page plays all notes of MIDI as the program does.
quietly node "$SOURCE/tests/support/page_notes.mjs" "$SOURCE/build/web/page" takes
for notes in "--events takes/notes.csv" "--midi-file takes/notes.mid"; do
  read -ra told <<<"$notes"
  quietly "$TABOR" render snare-14x5.5 --set shell.radius=0.17 -q --stereo --quality draft --duration 9 --format float "${told[@]}" \
    -o "${told[0]#--}.wav"
done
[ "$("$INSPECT" peak events.wav)" != 0 ] || complain "the notes make no sound"
"$INSPECT" equal events.wav midi-file.wav || complain "the page makes other strokes of notes than the program"

node "$SOURCE/tests/support/strike_web_page.mjs" "$address" "$web_tools" takes ${PLAY_SECONDS:+"$PLAY_SECONDS"} >log || { cat log; complain "the page"; }
grep '^#' log

# Firefox plays nothing without a sound server: one that nobody hears.
strike_in_firefox() {
  local server status=0
  mkdir -m 700 firefox-home
  export HOME=$PWD/firefox-home XDG_RUNTIME_DIR=$PWD/firefox-home
  pulseaudio -n --daemonize=no --exit-idle-time=-1 -L "module-null-sink rate=48000" -L module-native-protocol-unix >pulse-log 2>&1 &
  server=$!
  node "$SOURCE/tests/support/strike_in_firefox.mjs" "$address" "$web_tools" takes "$FIREFOX" || status=1
  kill $server
  wait $server || true
  return $status
}
(strike_in_firefox) >>log || { cat log; complain "the page in Firefox"; }
if [ -n "${PICTURES-}" ]; then cp takes/*.png "$PICTURES"; fi

count=0
# The command is the one that the page shows: tabor render ... --events strokes.csv ... -o again.wav, and of a kit
# --midi-file strokes.mid.
while read -r name seconds command; do
  [[ $command == "tabor render "* ]] || complain "$name: the page shows the command '$command'"
  read -ra words <<<"$command"
  rm -f again.wav strokes.*
  cp "takes/$name."[cm]* strokes.csv
  cp strokes.csv strokes.mid
  quietly "$TABOR" "${words[@]:1}" -q --duration "$seconds"
  [ "$("$INSPECT" peak again.wav)" != 0 ] || complain "$command: there is no sound"
  "$INSPECT" equal "takes/$name.wav" again.wav || complain "$command: the page has other bits"
  count=$((count + 1))
done < <(grep '^take' log)
[ $count -eq 10 ] || complain "$count recordings"
