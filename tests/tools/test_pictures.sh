#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The pictures of windows, page and screen show what was there: all colours, every blank; and the picture of the page is
# refused with gaps in the sound, without level or spectrum, or with another tuning than the drum has.
#
# test_pictures.sh SOURCE-FOLDER
tests=$(cd "$(dirname "$0")/.." && pwd)
source=$1
. "$tests/support/host_checks.sh"

# A browser makes one blank of several.
same "texts of the screen with two blanks in a row" 0 "$(grep -cE '<text[^>]*>[^<]*  ' "$source/docs/playing/screen.svg")"

for picture in clap/window clap/kit-window lv2/jalv web/page; do
  # Of a PNG's header: 2 is RGB, 3 a palette.
  same "docs/$picture.png: colours" 2 "$(od -An -tu1 -j25 -N1 "$source/docs/$picture.png" | tr -d ' ')"
done

if command -v node >/dev/null; then
  cat >refuse.mjs <<'END'
import { pathToFileURL } from "node:url";
const [folder, tuning] = process.argv.slice(2);
const { refusals } = await import(pathToFileURL(`${folder}/tools/docs/page_refusals.mjs`));
const pitch = (head) => `C4, ${Math.round(tuning.match(`${head} ([0-9.]+) Hz`)[1])} Hz`;
const good = { gaps: "No gaps in the sound", level: -18, points: 99, batter: pitch("batter"), resonant: pitch("resonant") };
const bad = { gaps: "Gaps in the sound: 28. A lower quality helps.", level: -60, points: 0, batter: "D4 −42 cents, 9287 Hz",
  resonant: "E4 +4 cents, 9330 Hz" };
console.log(refusals(good, tuning).length, ...Object.keys(bad).map((key) => refusals({ ...good, [key]: bad[key] }, tuning).length),
  refusals(bad, tuning).length);
END
  same "pages that are refused" "0 1 1 1 1 1 5" "$(node refuse.mjs "$source" "$("$TABOR" modes snare-14x5.5 --quality draft | tail -n 1)")"
else
  skip_part "there is no node: needs nodejs"
fi

finish
