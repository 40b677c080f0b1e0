// SPDX-License-Identifier: MIT
// Frequencies as notes, as the engine reads them: "A3", or "A3+12", twelve cents sharp; A4 = 440 Hz, C4 is middle C.

const NAMES = ["C", "C#", "D", "D#", "E", "F", "F#", "G", "G#", "A", "A#", "B"];
const A4 = { frequency: 440, number: 69 };

/** The nearest note to a frequency [Hz], and how many cents that is sharp of it, -50 to 50; `round` makes whole cents. */
export function nearestNote(frequency, round = Math.round) {
  const cents = round(100 * (A4.number + 12 * Math.log2(frequency / A4.frequency)));
  const number = Math.round(cents / 100);
  return { name: `${NAMES[number % 12]}${Math.floor(number / 12) - 1}`, cents: cents - 100 * number };
}

/** As text for the engine. To stay below a limit, round by Math.floor, above by Math.ceil. */
export function noteText(frequency, round = Math.round) {
  const { name, cents } = nearestNote(frequency, round);
  return cents === 0 ? name : `${name}${cents > 0 ? "+" : ""}${cents}`;
}
