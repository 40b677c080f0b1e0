// SPDX-License-Identifier: MIT
// Notes of MIDI inputs as strokes, by the map of docs/midi.md.

const HEAD_NOTES = [36, 38, 41, 43, 45, 47, 48, 50];
const CENTRE_NOTE = 36;
const TECHNIQUES = { 37: 3, 39: 4, 40: 2 }; // cross-stick, rim, rimshot, by the engine's numbers
const STRAINER = 20; // controller
const GHOST = { from: 1, to: 20, slowest: 0.3, fastest: 1 }; // velocities and their speeds [m/s]
const NORMAL = { from: 20, to: 127, slowest: 1, fastest: 10 };

/** Speed of a velocity [m/s]; equal steps are equal ratios. */
function speedOf(velocity) {
  const span = velocity < NORMAL.from ? GHOST : NORMAL;
  const x = (velocity - span.from) / (span.to - span.from);
  return span.slowest * (span.fastest / span.slowest) ** x;
}

/** Velocity of a speed [m/s], rounded and within what MIDI has. */
export function velocityOf(speed) {
  const span = speed < NORMAL.slowest ? GHOST : NORMAL;
  const x = Math.log(speed / span.slowest) / Math.log(span.fastest / span.slowest);
  return Math.min(Math.max(Math.round(span.from + x * (span.to - span.from)), 1), 127);
}

/** What a message does: { note, velocity, technique, isCentre }, { snares }, or null. A technique of null: no note of a drum
 * that plays alone. */
export function actionOf([status, number, value]) {
  const kind = status & 0xf0;
  if (kind === 0xb0 && number === STRAINER) return { snares: value >= 64 };
  if (kind !== 0x90 || value === 0) return null;
  const technique = TECHNIQUES[number] ?? (HEAD_NOTES.includes(number) ? 0 : null);
  return { note: number, velocity: speedOf(value), technique, isCentre: number === CENTRE_NOTE };
}

/** Hears all inputs, also those that come later. `tell` gets their number whenever it changes. */
export async function listenToMidi(act, tell) {
  const access = await navigator.requestMIDIAccess();
  const hear = ({ data }) => {
    const action = actionOf(data);
    if (action) act(action);
  };
  const connect = () => {
    for (const input of access.inputs.values()) input.onmidimessage = hear;
    tell(access.inputs.size);
  };
  access.onstatechange = connect;
  connect();
}
