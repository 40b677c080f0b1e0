// SPDX-License-Identifier: MIT
// Builds drums beside the page. A message { bytes, preset, settings, quality, rate } is answered by { progress }s and then by
// { instrument, memory, facts } or { error }. `memory` holds the drum or kit, at the address `instrument`.
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
const DRUMS_OWN = -1; // striker
const HEADS = ["batter", "resonant"]; // in the engine's order
const MOST_MODES = 24; // that the page lists
const RIM = 4; // a TaborModePart

/** Plays a stroke on all drums at once; returns the computing time as a share of its duration. */
function trial(engine, instrument, drums, rate) {
  const blocks = Math.ceil((TRIAL_LENGTH * rate) / BLOCK);
  const began = performance.now();
  for (let drum = 0; drum < drums; drum++) engine.instrument_strike(instrument, drum, 0, TRIAL_SPEED, 0, 0, 0, DRUMS_OWN);
  for (let i = 0; i < blocks; i++) engine.instrument_play(instrument, BLOCK);
  engine.instrument_reset(instrument);
  return (performance.now() - began) / 1000 / ((blocks * BLOCK) / rate);
}

function measureLoad(engine, instrument, drums, rate) {
  return Math.min(...Array.from({ length: TRIALS }, () => trial(engine, instrument, drums, rate)));
}

/** What a picture of a drum consists of (picture_glue.c). */
function pictureOf(engine, instrument, drum) {
  const [heads, circles, angles, wires, points, sticks, values, wiresHead] =
    Array.from({ length: 8 }, (_, i) => engine.picture_shape(instrument, drum, i));
  const places = Array.from(new Float64Array(engine.memory.buffer, engine.wire_places(instrument, drum), 4 * wires)); // [m]
  return { heads, circles, angles, wires, points, sticks, values, wiresHead, places, size: engine.picture_size(instrument, drum) };
}

/** The lowest modes of a drum, and their shapes along a radius. Left out are those of hoop and shell, and those that hardly move
 * where a stick lands. */
function modesOf(engine, instrument, drum, { radius, place }, { heads, circles }) {
  const modes = [];
  for (let row = 0; modes.length < MOST_MODES; row++) {
    const [frequency, time, m, part, phase] = Array.from({ length: 5 }, (_, i) => engine.mode_value(instrument, drum, row, i));
    if (!frequency) break;
    if (part === RIM) continue;
    const shapes = Array.from({ length: heads }, (_, head) =>
      Array.from({ length: circles }, (_, i) => engine.mode_shape(instrument, drum, row, head, (radius * i) / (circles - 1))));
    const most = Math.max(...shapes.flat().map(Math.abs));
    const struck = Math.abs(engine.mode_shape(instrument, drum, row, 0, place));
    if (struck > 0.02 * most) modes.push({ frequency, time, m, part, phase, shapes, most });
  }
  return modes;
}

/** Asks the definition of a drum for numbers, pitches of heads and names of strikers. */
function definitionOf(engine, instrument, drum) {
  const definition = engine.instrument_definition(instrument, drum);
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
    isPlate: number("plate.thickness") > 0, // a cymbal
    lugs: number("plate.thickness") > 0 ? 0 : number("batter.lug_count"),
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

/* ---- a drum or a kit ---- */

const NOTES = 128;

/** Where a drum of a kit stands, and what notes do to it. */
function standOf(engine, kit, drum) {
  const [x, y, height] = [0, 1, 2].map((axis) => engine.instrument_drum_place(kit, drum, axis)); // [m]
  const strokes = Array.from({ length: NOTES }, (_, note) => engine.instrument_stroke(kit, drum, note));
  return { name: textAt(engine, engine.instrument_drum_name(kit, drum)), x, y, height, strokes };
}

/** `preset` and `now` are what the controls are about, of the preset and of what was built. */
function factsOf(engine, instrument, drum, isKit, preset) {
  const definition = definitionOf(engine, instrument, drum);
  const stand = isKit ? standOf(engine, instrument, drum) : {};
  const looks = looksOf(definition), picture = pictureOf(engine, instrument, drum);
  const lowModes = modesOf(engine, instrument, drum, looks, picture);
  return { ...looks, ...stand, preset, now: controlsOf(definition), picture, lowModes };
}

/** Facts of a whole kit. */
function ofKit(drums) {
  const snares = drums.find(({ wires }) => wires.count > 0)?.wires ?? { count: 0, strainer: 0 };
  return { drums, wires: snares, preset: { strainer: snares.strainer }, velocity: drums[0].velocity };
}

function buildInstrument(engine, { preset: listed, settings, quality, rate }) {
  const kit = kitOf(listed);
  const isKit = kit !== null;
  const instrument = withText(engine, kit ?? listed, (name) => engine.instrument_create(name, Number(isKit)));
  if (!instrument) return { error: "there is not enough memory" };
  const error = () => textAt(engine, engine.instrument_error(instrument));
  if (error()) return { error: error() };
  const count = engine.instrument_drum_count(instrument);
  const numbers = Array.from({ length: count }, (_, drum) => drum);
  const nameOf = (drum) => textAt(engine, engine.instrument_drum_name(instrument, drum));
  const own = numbers.map((drum) => controlsOf(definitionOf(engine, instrument, drum)));
  for (const setting of settings) if (!change(engine, instrument, setting)) return { error: error() };
  if (engine.instrument_drum_count(instrument) > count) return { error: `the kit has no drum '${nameOf(count)}'` };
  const limited = numbers.flatMap((drum) =>
    limitPitches(definitionOf(engine, instrument, drum), isKit ? `drum.${nameOf(drum)}.` : "", settings));
  for (const setting of limited) change(engine, instrument, setting);
  if (!engine.instrument_build(instrument, quality, rate, MOST_SECONDS, MOST_BYTES)) return { error: error() };
  const drums = numbers.map((drum) => factsOf(engine, instrument, drum, isKit, own[drum]));
  const facts = { ...(isKit ? ofKit(drums) : drums[0]), modes: engine.instrument_mode_count(instrument), limited };
  return { instrument, count, facts };
}

async function build(request) {
  const engine = await startEngine(request.bytes, (progress) => postMessage({ progress }));
  const began = performance.now();
  const { error, instrument, count, facts } = buildInstrument(engine, request);
  if (error) return { error };
  facts.seconds = (performance.now() - began) / 1000;
  facts.load = measureLoad(engine, instrument, count, request.rate);
  return { instrument, facts, memory: engine.memory.buffer.slice(0) };
}

addEventListener("message", async ({ data }) => {
  try {
    const built = await build(data);
    postMessage(built, built.memory ? [built.memory] : []);
  } catch (error) {
    postMessage({ error: String(error) });
  }
});
