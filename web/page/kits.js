// SPDX-License-Identifier: MIT
// Kits among drums: in the list and in links a kit has the name "kit:standard".

const PREFIX = "kit:";
// What a note does in a kit, by the technique of a stroke: both by the engine's numbers. A hi-hat has notes for a closed one.
const STROKES = [[1, 10], [], [2], [3], [4], [], [12]];

/** The name in the list for a kit. */
export const listedKit = (name) => PREFIX + name;

/** The kit's own name, or null for a drum. */
export const kitOf = (listed) => (listed.startsWith(PREFIX) ? listed.slice(PREFIX.length) : null);

/** Keys and values that a kit takes; snares are switched while it plays. */
export const settingsOfKit = (settings) => settings.filter(([key]) => !key.startsWith("wires."));

/** The note that played a drum, or one that plays it so, or -1. */
export const noteOf = (drums, { drum, technique, note }) => {
  const notes = STROKES[technique].map((stroke) => drums[drum].strokes.indexOf(stroke));
  return note ?? notes.find((found) => found >= 0) ?? -1;
};
