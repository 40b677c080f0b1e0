// SPDX-License-Identifier: MIT
// Builds drums beside the page. A message { bytes, preset, settings, quality, rate } is answered by { progress }s and then by
// { drum, memory, facts } or { error }. `memory` holds the drum, at the address `drum`.
// `settings` are keys and values as [["batter.pitch", "A3"]].
import { startEngine, textAt, withText } from "./engine.js";

const TRIALS = 2; // the first is dearer: the engine is still being compiled
const TRIAL_LENGTH = 0.15; // [s]
const TRIAL_SPEED = 4.5; // [m/s]
const BLOCK = 128; // frames

/** Plays a stroke; returns the computing time as a share of its duration. */
function trial(engine, drum, rate) {
  const blocks = Math.ceil((TRIAL_LENGTH * rate) / BLOCK);
  const began = performance.now();
  engine.drum_strike(drum, 0, TRIAL_SPEED, 0, 0, 0, -1);
  for (let i = 0; i < blocks; i++) engine.drum_process(drum, 0);
  engine.drum_reset(drum);
  return (performance.now() - began) / 1000 / ((blocks * BLOCK) / rate);
}

function measureLoad(engine, drum, rate) {
  const loads = Array.from({ length: TRIALS }, () => trial(engine, drum, rate));
  return Math.min(...loads);
}

/** What a picture of the drum consists of (glue.c). */
function pictureOf(engine, drum) {
  const [heads, circles, angles, wires, points, sticks, values, wiresHead] =
    Array.from({ length: 8 }, (_, i) => engine.picture_shape(drum, i));
  const places = Array.from(new Float64Array(engine.memory.buffer, engine.wire_places(drum), 4 * wires)); // [m]
  return { heads, circles, angles, wires, points, sticks, values, wiresHead, places, size: engine.picture_size(drum) };
}

const numberOf = (engine, drum, key) => withText(engine, key, (address) => engine.drum_number(drum, address));

function strikersOf(engine, drum) {
  const names = [];
  for (let address; (address = engine.striker_name(drum, names.length)); ) names.push(textAt(engine, address));
  return names;
}

/** What the controls are about. Of two heads the batter is the first; what a head lacks is 0. */
function controlsOf(engine, drum) {
  const ofHeads = (key) => ["batter", "resonant"].map((head) => numberOf(engine, drum, `${head}.${key}`));
  const strikers = strikersOf(engine, drum);
  const striker = textAt(engine, withText(engine, "strike.striker", (key) => engine.drum_text(drum, key)));
  return {
    pitch: [0, 1].map((head) => engine.drum_pitch(drum, head)), // [Hz]
    tension: ofHeads("tension"), // [N/m]
    muffling: ofHeads("muffle_strength"), // [N s/m]
    strikers,
    striker: striker || strikers[0],
    strainer: numberOf(engine, drum, "wires.strainer"),
  };
}

function factsOf(engine, drum) {
  const number = (key) => numberOf(engine, drum, key);
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
    picture: pictureOf(engine, drum),
    modes: engine.drum_mode_count(drum),
  };
}

/** Changes the definition; false with an error. */
function set(engine, drum, [key, value]) {
  return withText(engine, key, (keyAt) => withText(engine, value, (valueAt) => engine.drum_set(drum, keyAt, valueAt)));
}

async function build({ bytes, preset, settings, quality, rate }) {
  const engine = await startEngine(bytes, (progress) => postMessage({ progress }));
  const began = performance.now();
  const drum = withText(engine, preset, engine.drum_create);
  if (!drum) return { error: "there is not enough memory" };
  const error = () => textAt(engine, engine.drum_error(drum));
  if (error()) return { error: error() };
  const own = controlsOf(engine, drum);
  for (const setting of settings) if (!set(engine, drum, setting)) return { error: error() };
  const now = settings.length > 0 ? controlsOf(engine, drum) : own;
  if (!engine.drum_build(drum, quality, rate)) return { error: error() };
  const facts = { ...factsOf(engine, drum), preset: own, now, seconds: (performance.now() - began) / 1000 };
  facts.load = measureLoad(engine, drum, rate);
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
