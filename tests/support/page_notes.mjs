// SPDX-License-Identifier: MIT
// Every MIDI note at several velocities, as the page of tools/web plays it: page_notes.mjs PAGE FOLDER. FOLDER gets notes.mid, and
// notes.csv with the strokes that the page makes of it. Status 1 if the controllers for the place do not act. For test_web.sh.
import { readFile, writeFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [page, folder] = process.argv.slice(2);
const load = (file) => import(pathToFileURL(join(resolve(page), file)));
const { startEngine } = await load("engine.js");
const { MidiMap } = await load("midi.js");
const { midiFile } = await load("midi_file.js");
const { Recorder } = await load("recorder.js");

const RATE = 48000;
const STEP = 512; // frames from note to note
const VELOCITIES = [1, 19, 20, 64, 100, 127];
const NOTES = 128;
const RIM = 0.98; // where the greatest value of controller 16 strikes, as a share of the radius (docs/midi.md)

const midi = new MidiMap(await startEngine(await readFile(join(page, "tabor.wasm"))));
midi.follow("snare-14x5.5", [["shell.radius", "0.17"]]);

const notes = VELOCITIES.flatMap((velocity) => Array.from({ length: NOTES }, (_, note) => ({ note, velocity })));
notes.forEach((note, i) => { note.frame = i * STEP; });
const recorder = new Recorder(2, RATE, "");
recorder.add({ sound: new Float32Array(2), frame: 0 });
for (const { frame, note, velocity } of notes) {
  const stroke = midi.take([0x99, note, velocity]);
  if (stroke) recorder.addStroke({ ...stroke, frame });
}
await writeFile(join(folder, "notes.csv"), await recorder.strokes().text());
await writeFile(join(folder, "notes.mid"), Buffer.from(await midiFile(notes, RATE).arrayBuffer()));

midi.take([0xb0, 16, 127]);
midi.take([0xb0, 17, 32]);
const { radius, angle } = midi.take([0x90, 38, 64]);
if (Math.abs(radius / 0.17 - RIM) > 1e-12 || angle !== 90) {
  console.error(`FAILED: controllers 16 and 17 strike at ${radius} m, ${angle} degrees`);
  process.exitCode = 1;
}
