// SPDX-License-Identifier: MIT
// What a picture of the page must not show. For page_picture.mjs.

/** Where a head's pitch stands in the last line of `tabor modes`: "... batter 270.30 Hz (C#4-44), resonant ...". */
const PITCH = { batter: /batter ([\d.]+) Hz/, resonant: /resonant ([\d.]+) Hz/ };

/**
 * Why a page that shows this must not be in the manual, as a list of sentences. `shown` has the text about gaps, the level [dBFS], the
 * number of points of the spectrum that are drawn, and the texts of both pitches; `tuning` is the last line of `tabor modes`.
 */
export function refusals(shown, tuning) {
  const reasons = [];
  if (shown.gaps !== "No gaps in the sound") reasons.push(`the sound had gaps: ${shown.gaps}`);
  if (!(shown.level > -40)) reasons.push(`the level is ${shown.level} dB`);
  if (!(shown.points > 0)) reasons.push("the spectrum is empty");
  for (const [head, pattern] of Object.entries(PITCH)) {
    const own = tuning.match(pattern)?.[1];
    if (!shown[head].endsWith(`, ${Math.round(Number(own))} Hz`)) reasons.push(`the ${head} head has ${shown[head]}, its preset ${own} Hz`);
  }
  return reasons;
}
