// SPDX-License-Identifier: MIT
// Drums computed from physics. index.d.ts describes every function.
import { connectNode } from "./audio_node.js";
import { Drum } from "./drum.js";
import { startEngine, textAt } from "./engine.js";
import { TaborError, bytesOf, inRange, startWith } from "./instrument.js";
import { Kit } from "./kit.js";

const BLOCK = 256; // frames between two looks whether the sound is over, as in `tabor render`
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

async function list(of) {
  const engine = await startEngine(await loaded());
  return Array.from({ length: engine[`${of}_count`]() }, (_, i) => ({
    name: textAt(engine, engine[`${of}_name`](i)),
    comment: textAt(engine, engine[`${of}_comment`](i)),
  }));
}

export const presets = () => list("preset");

export const kits = () => list("kit");

export async function version() {
  const engine = await startEngine(await loaded());
  return textAt(engine, engine.version());
}

/* ---- a whole sound ---- */

function frameOf(name, seconds, least, rate) {
  return Math.round(inRange(name, seconds, least, LATEST, "s") * rate);
}

/** Parts of a sound, until it has died away as `tabor render` has it. */
function ringOut(instrument, last) {
  const parts = [];
  instrument.call("instrument_ring_out", last);
  do parts.push(instrument.process(BLOCK));
  while (!instrument.call("instrument_is_over"));
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

/** Gives the instrument strokes, or the events of a MIDI file; returns the last frame that has one. */
function give(instrument, events, warn) {
  if (bytesOf(events)) {
    const { last, warnings } = instrument.midiFile(events);
    warnings.forEach((line) => warn(line));
    return last;
  }
  if (!Array.isArray(events)) throw new TypeError("events are an array of strokes, or the bytes of a MIDI file");
  let last = 0;
  for (const { time = 0, ...stroke } of events) {
    const frame = frameOf("time", time, 0, instrument.sampleRate);
    instrument.strike({ ...stroke, frame });
    last = Math.max(last, frame);
  }
  return last;
}

function play(instrument, events, duration, warn = console.warn) {
  const last = give(instrument, events, warn);
  if (duration !== undefined) return instrument.process(frameOf("duration", duration, 0.01, instrument.sampleRate));
  return join(ringOut(instrument, last), instrument.channelCount, instrument.frame);
}

export async function render(preset, events = [{}], { duration, warn, ...options } = {}) {
  return play(await Drum.create(preset, options), events, duration, warn);
}

export async function renderKit(kit, events, { duration, warn, ...options } = {}) {
  return play(await Kit.create(kit, options), events, duration, warn);
}

export const createNode = async (context, instrument) => connectNode(context, instrument, await loaded());

export { Drum, Kit, TaborError };
