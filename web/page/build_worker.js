// SPDX-License-Identifier: MIT
// Builds drums beside the page. A message { bytes, preset, quality, rate } is answered by { progress }s and then by
// { drum, memory, facts } or { error }. `memory` holds the drum, at the address `drum`.
import { startEngine, textAt, withText } from "./engine.js";

const TRIAL = 0.5; // sound that is computed to see how fast that goes [s]
const TRIAL_SPEED = 4.5; // [m/s]
const BLOCK = 128; // frames

/** Computing time of a stroke as a share of its duration. */
function measureLoad(engine, drum, rate) {
  const blocks = Math.ceil((TRIAL * rate) / BLOCK);
  const began = performance.now();
  engine.drum_strike(drum, TRIAL_SPEED, 0, 0, 0);
  for (let i = 0; i < blocks; i++) engine.drum_process(drum);
  engine.drum_reset(drum);
  return (performance.now() - began) / 1000 / ((blocks * BLOCK) / rate);
}

function factsOf(engine, drum) {
  return {
    radius: engine.drum_radius(drum),
    angle: engine.drum_stroke_angle(drum),
    velocity: engine.drum_stroke_velocity(drum),
    wires: engine.drum_wire_count(drum),
    modes: engine.drum_mode_count(drum),
  };
}

async function build({ bytes, preset, quality, rate }) {
  const engine = await startEngine(bytes, (progress) => postMessage({ progress }));
  const began = performance.now();
  const drum = withText(engine, preset, (name) => engine.drum_create(name, quality, rate));
  const error = drum ? textAt(engine, engine.drum_error(drum)) : "there is not enough memory";
  if (error) return { error };
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
