// SPDX-License-Identifier: MIT
// What keys do, as in `tabor play` (docs/keyboard.md).

const OUTERMOST = 0.92; // a stick that hits closer to the rim hits the rim
const ZONES = 9;
const SPEEDS = [0.5, 0.71, 1, 1.41, 2, 2.83, 4, 5.66, 8]; // [m/s]
const TECHNIQUES = { z: 2, x: 3, c: 4 }; // rimshot, cross-stick, rim, by the engine's numbers

const zone = (i) => (OUTERMOST * Math.min(i, ZONES - 1)) / (ZONES - 1);

/** A stroke of a row's keys: the number of the key, and the place, as a share of the radius. */
const strokeOf = (i) => ({ zone: i, share: zone(i) });

/** What a key does: { stroke: { zone, share } }, { ghost }, { technique }, { speed }, { preset } and so on. */
export function actionOf(key) {
  const stroke = "asdfghjkl".indexOf(key);
  if (stroke >= 0) return { stroke: strokeOf(stroke) };
  const ghost = "qwertyuiop".indexOf(key);
  if (ghost >= 0) return { ghost: strokeOf(ghost) };
  if (key in TECHNIQUES) return { technique: TECHNIQUES[key] };
  if (key >= "1" && key <= "9") return { speed: SPEEDS[key - 1] };
  if (key === "[" || key === "]") return { preset: key === "[" ? -1 : 1 };
  return { " ": { repeat: true }, enter: { repeat: true }, b: { snares: true }, ".": { hold: true } }[key] ?? null;
}
