// SPDX-License-Identifier: MIT
// The MIDI files that judge_midi_files.py has judged, as the page of tools/web reads them: judge_midi_files.mjs PAGE FOLDER
// VERDICTS.JSON. Status 1 if it says something else of a file, or makes other strokes of it. For test_midi_files.sh.
import { readFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [page, folder, verdicts] = process.argv.slice(2);
const load = (file) => import(pathToFileURL(join(resolve(page), file)));
const { startEngine } = await load("engine.js");
const { MidiMap } = await load("midi.js");

const TECHNIQUES = ["normal", "buzz", "rimshot", "cross-stick", "rim"]; // by the engine's numbers
const { drum, kit, rate, files } = JSON.parse(await readFile(verdicts));
const engine = await startEngine(await readFile(join(page, "tabor.wasm")));

/** What the page plays of Python's events. */
const strokesOf = (events) => events.filter(({ kind }) => kind === "strike")
  .map(({ frame, drum, velocity, radius, angle, technique }) => ({ frame, drum, velocity, radius, angle, technique }));

async function judge(midi, bytes) {
  const { said, actions } = await midi.readSong(new Blob([bytes]), rate);
  const strokes = actions?.filter(({ kind }) => kind === "stroke").map((action) => (
    { ...action, kind: "strike", technique: TECHNIQUES[action.technique] }));
  return { said, strokes: actions && strokesOf(strokes) };
}

for (const [name, preset] of [["drum", drum], ["kit", `kit:${kit}`]]) {
  const midi = new MidiMap(engine);
  midi.follow(preset, []);
  for (const [file, verdict] of Object.entries(files)) {
    const { said, events } = verdict[name];
    const lines = said.map((line) => line.replace("warning: ", ""));
    const theirs = JSON.stringify({ said: lines, strokes: events && strokesOf(events) });
    const ours = JSON.stringify(await judge(midi, await readFile(join(folder, file))));
    if (ours === theirs) continue;
    console.error(`FAILED: ${file}, ${name}: the page says ${ours}, Python says ${theirs}`);
    process.exitCode = 1;
  }
}
