// SPDX-License-Identifier: MIT
// Builds drums beside the page. A message { bytes, preset, settings, quality, rate } is answered by { progress }s and then by
// { drum, memory, facts } or { error }. `memory` holds the drum, at the address `drum`.
// `settings` are keys and values as [["batter.pitch", "A3"]]. A pitch that a head cannot have becomes the nearest one that it can:
// `facts.limited` has such settings. A preset may be a kit (kits.js); its facts have `drums`.
import { change, startEngine, textAt, withText } from "./engine.js";
import { kitOf } from "./kits.js";
import { noteText } from "./note.js";

// What building a model may take by the engine's estimate. All presets do with half of it at `studio`; a browser takes several
// times as long as the estimate says.
const MOST_SECONDS = 5;
const MOST_BYTES = 5e8;
const TRIALS = 2; // the first is dearer: the engine is still being compiled
const TRIAL_LENGTH = 0.15; // [s]
const TRIAL_SPEED = 4.5; // [m/s]
const BLOCK = 128; // frames
const HEADS = ["batter", "resonant"]; // in the engine's order

/** Plays a stroke; returns the computing time as a share of its duration. */
function trial({ strike, process, reset }, rate) {
  const blocks = Math.ceil((TRIAL_LENGTH * rate) / BLOCK);
  const began = performance.now();
  strike(TRIAL_SPEED);
  for (let i = 0; i < blocks; i++) process();
  reset();
  return (performance.now() - began) / 1000 / ((blocks * BLOCK) / rate);
}

function measureLoad(instrument, rate) {
  const loads = Array.from({ length: TRIALS }, () => trial(instrument, rate));
  return Math.min(...loads);
}

/** What a picture of the drum consists of (glue.c). */
function pictureOf(engine, drum) {
  const [heads, circles, angles, wires, points, sticks, values, wiresHead] =
    Array.from({ length: 8 }, (_, i) => engine.picture_shape(drum, i));
  const places = Array.from(new Float64Array(engine.memory.buffer, engine.wire_places(drum), 4 * wires)); // [m]
  return { heads, circles, angles, wires, points, sticks, values, wiresHead, places, size: engine.picture_size(drum) };
}

/** Asks a definition, of drum_definition() or kit_definition(), for numbers, pitches of heads and names of strikers. */
function definitionOf(engine, definition) {
  return {
    number: (key) => withText(engine, key, (address) => engine.definition_number(definition, address)),
    pitch: (head) => engine.definition_pitch(definition, head), // [Hz]
    pitchLimits: (head) => [0, 1].map((which) => engine.definition_pitch_limit(definition, head, which)), // [Hz]
    strikers: () => {
      const names = [];
      for (let name; (name = engine.definition_striker(definition, names.length)); ) names.push(textAt(engine, name));
      return names;
    },
    ownStriker: () => engine.definition_own_striker(definition),
  };
}

const definitionOfDrum = (engine, drum) => definitionOf(engine, engine.drum_definition(drum));
const definitionInKit = (engine, kit, drum) => definitionOf(engine, engine.kit_definition(kit, drum));

/** What the controls are about. Of two heads the batter is the first; what a head lacks is 0. */
function controlsOf(definition) {
  const ofHeads = (key) => HEADS.map((head) => definition.number(`${head}.${key}`));
  const strikers = definition.strikers();
  return {
    pitch: [0, 1].map(definition.pitch), // [Hz]
    tension: ofHeads("tension"), // [N/m]
    muffling: ofHeads("muffle_strength"), // [N s/m]
    strikers,
    striker: strikers[definition.ownStriker()],
    strainer: definition.number("wires.strainer"),
  };
}

/** What a drum looks like and where it is struck. */
function looksOf({ number }) {
  return {
    radius: number("shell.radius"), // [m]
    lugs: number("batter.lug_count"),
    wires: {
      count: number("wires.count"),
      length: number("wires.length"), // [m]
      spacing: number("wires.spacing"), // [m]
      angle: number("wires.angle"), // [deg]
      strainer: number("wires.strainer"),
    },
    place: number("strike.radius"), // [m]
    angle: number("strike.angle"), // [deg]
    velocity: number("strike.velocity"), // [m/s]
  };
}

/** Of the pitches that were set, those beyond what their heads can have, as keys and the nearest notes within. */
function limitPitches(definition, prefix, settings) {
  return HEADS.flatMap((name, head) => {
    const key = `${prefix}${name}.pitch`;
    if (!settings.some(([set]) => set === key)) return [];
    const wanted = definition.pitch(head);
    const [least, most] = definition.pitchLimits(head);
    if (wanted > most) return [[key, noteText(most, Math.floor)]];
    return wanted < least ? [[key, noteText(least, Math.ceil)]] : [];
  });
}

/* ---- a drum ---- */

function factsOf(engine, drum) {
  return { ...looksOf(definitionOfDrum(engine, drum)), picture: pictureOf(engine, drum), modes: engine.drum_mode_count(drum) };
}

function buildDrum(engine, { preset, settings, quality, rate }) {
  const drum = withText(engine, preset, engine.drum_create);
  if (!drum) return { error: "there is not enough memory" };
  const error = () => textAt(engine, engine.drum_error(drum));
  if (error()) return { error: error() };
  const own = controlsOf(definitionOfDrum(engine, drum));
  for (const setting of settings) if (!change(engine, engine.drum_set, drum, setting)) return { error: error() };
  const limited = limitPitches(definitionOfDrum(engine, drum), "", settings);
  for (const setting of limited) change(engine, engine.drum_set, drum, setting);
  const now = settings.length > 0 ? controlsOf(definitionOfDrum(engine, drum)) : own;
  if (!engine.drum_build(drum, quality, rate, MOST_SECONDS, MOST_BYTES)) return { error: error() };
  const instrument = {
    strike: (speed) => engine.drum_strike(drum, 0, speed, 0, 0, 0, -1),
    process: () => engine.drum_process(drum, 0),
    reset: () => engine.drum_reset(drum),
  };
  return { drum, facts: { ...factsOf(engine, drum), preset: own, now, limited }, instrument };
}

/* ---- a kit ---- */

const NOTES = 128;

function drumOfKit(engine, kit, preset, drum) {
  const definition = definitionInKit(engine, kit, drum);
  const [x, y, height] = [0, 1, 2].map((axis) => engine.kit_drum_place(kit, drum, axis)); // [m]
  return {
    ...looksOf(definition),
    preset, now: controlsOf(definition),
    name: textAt(engine, engine.kit_drum_name(kit, drum)),
    x, y, height,
    strokes: Array.from({ length: NOTES }, (_, note) => engine.kit_stroke(kit, drum, note)),
  };
}

function buildKit(engine, name, { settings, quality, rate }) {
  const kit = withText(engine, name, engine.kit_create);
  if (!kit) return { error: "there is not enough memory" };
  const error = () => textAt(engine, engine.kit_error(kit));
  if (error()) return { error: error() };
  const count = engine.kit_drum_count(kit);
  const own = Array.from({ length: count }, (_, i) => controlsOf(definitionInKit(engine, kit, i)));
  for (const setting of settings) if (!change(engine, engine.kit_set, kit, setting)) return { error: error() };
  if (engine.kit_drum_count(kit) > count) {
    return { error: `the kit has no drum '${textAt(engine, engine.kit_drum_name(kit, count))}'` };
  }
  const limited = own.flatMap((_, i) => {
    const prefix = `drum.${textAt(engine, engine.kit_drum_name(kit, i))}.`;
    return limitPitches(definitionInKit(engine, kit, i), prefix, settings);
  });
  for (const setting of limited) change(engine, engine.kit_set, kit, setting);
  if (!engine.kit_build(kit, quality, rate, MOST_SECONDS, MOST_BYTES)) return { error: error() };
  const drums = own.map((preset, i) => drumOfKit(engine, kit, preset, i));
  const instrument = {
    strike: (speed) => drums.forEach((_, i) => engine.kit_strike(kit, i, speed, 0, 0, 0)), // all at once
    process: () => engine.kit_process(kit),
    reset: () => engine.kit_reset(kit),
  };
  const snares = drums.find(({ wires }) => wires.count > 0)?.wires ?? { count: 0, strainer: 0 };
  const facts = { drums, wires: snares, preset: { strainer: snares.strainer }, velocity: drums[0].velocity,
    modes: engine.kit_mode_count(kit), limited };
  return { drum: kit, facts, instrument };
}

async function build(request) {
  const engine = await startEngine(request.bytes, (progress) => postMessage({ progress }));
  const began = performance.now();
  const kit = kitOf(request.preset);
  const { error, drum, facts, instrument } =
    kit === null ? buildDrum(engine, request) : buildKit(engine, kit, request);
  if (error) return { error };
  facts.seconds = (performance.now() - began) / 1000;
  facts.load = measureLoad(instrument, request.rate);
  return { drum, facts, memory: engine.memory.buffer.slice(0) };
}

addEventListener("message", async ({ data }) => {
  try {
    const built = await build(data);
    postMessage(built, built.memory ? [built.memory] : []);
  } catch (error) {
    postMessage({ error: String(error) });
  }
});
