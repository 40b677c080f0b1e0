// SPDX-License-Identifier: MIT
// Drums computed from physics. index.d.ts describes every function.
import { Drum, TaborError, inRange, startWith } from "./drum.js";
import { startEngine, textAt } from "./engine.js";

const BLOCK = 256; // frames between two looks at the energy: the length of the sound depends on it
const FALL = 1e-9; // 90 dB
const LEAST_TIME = 0.5; // after the last event [s]
const MOST_TIME = 20; // after the last event [s]
const LATEST = 3600; // [s]

let read = async (url) => {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return response.arrayBuffer();
};
let module = null; // a promise of it

/** For node.js, where fetch() reads no files. */
export function readWith(reader) {
  read = reader;
}

const compile = async (source) => {
  if (source instanceof WebAssembly.Module) return source;
  const isPlace = typeof source === "string" || source instanceof URL;
  return WebAssembly.compile(isPlace ? await read(new URL(source, import.meta.url)) : source);
};

export async function load(source = new URL("tabor.wasm", import.meta.url)) {
  const compiled = compile(source);
  module = compiled;
  compiled.catch(() => { if (module === compiled) module = null; }); // the next call tries again
  await compiled;
}

async function loaded() {
  if (!module) await load();
  return module;
}

startWith(async (progress) => startEngine(await loaded(), progress));

export async function presets() {
  const engine = await startEngine(await loaded());
  return Array.from({ length: engine.preset_count() }, (_, i) => ({
    name: textAt(engine, engine.preset_name(i)),
    comment: textAt(engine, engine.preset_comment(i)),
  }));
}

export async function version() {
  const engine = await startEngine(await loaded());
  return textAt(engine, engine.version());
}

/* ---- a whole sound ---- */

function frameOf(name, seconds, least, rate) {
  return Math.round(inRange(name, seconds, least, LATEST, "s") * rate);
}

/** Parts of a sound, until it has died away as `tabor render` has it (host/sound/ring_out.h). */
function ringOut(drum, last) {
  const least = last + Math.ceil(LEAST_TIME * drum.sampleRate);
  const most = last + Math.ceil(MOST_TIME * drum.sampleRate);
  const parts = [];
  let loudest = 0;
  let loudestRoom = 0;
  while (drum.frame < most) {
    parts.push(drum.process(Math.min(BLOCK, most - drum.frame)));
    const room = drum.roomEnergy;
    loudestRoom = Math.max(loudestRoom, room);
    if (drum.frame <= last) continue;
    const { stored } = drum.ledger();
    loudest = Math.max(loudest, stored);
    const isSilent = room <= FALL * loudestRoom && (drum.isSilent || stored <= FALL * loudest);
    if (drum.frame >= least && isSilent) break;
  }
  return parts;
}

/** The parts of each channel, one after the other. */
function join(parts, channels, frames) {
  return Array.from({ length: channels }, (_, i) => {
    const channel = new Float32Array(frames);
    let frame = 0;
    for (const part of parts) {
      channel.set(part[i], frame);
      frame += part[i].length;
    }
    return channel;
  });
}

export async function render(preset, strokes = [{}], { duration, ...options } = {}) {
  const drum = await Drum.create(preset, options);
  const rate = drum.sampleRate;
  let last = 0;
  for (const { time = 0, ...stroke } of strokes) {
    const frame = frameOf("time", time, 0, rate);
    drum.strike({ ...stroke, frame });
    last = Math.max(last, frame);
  }
  if (duration !== undefined) return drum.process(frameOf("duration", duration, 0.01, rate));
  const parts = ringOut(drum, last);
  return join(parts, drum.mics.length, drum.frame);
}

export { Drum, TaborError };
