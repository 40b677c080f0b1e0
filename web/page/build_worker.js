// SPDX-License-Identifier: MIT
// Builds drums beside the page. A message { bytes, preset, quality, rate } is answered by { progress }s and then by
// { drum, memory, facts } or { error }. `memory` holds the drum, at the address `drum`.
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

function factsOf(engine, drum) {
  const number = (key) => withText(engine, key, (address) => engine.drum_number(drum, address));
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

async function build({ bytes, preset, quality, rate }) {
  const engine = await startEngine(bytes, (progress) => postMessage({ progress }));
  const began = performance.now();
  const drum = withText(engine, preset, engine.drum_create);
  if (!drum) return { error: "there is not enough memory" };
  const error = textAt(engine, engine.drum_error(drum));
  if (error) return { error };
  if (!engine.drum_build(drum, quality, rate)) return { error: textAt(engine, engine.drum_error(drum)) };
  const facts = { ...factsOf(engine, drum), seconds: (performance.now() - began) / 1000 };
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
