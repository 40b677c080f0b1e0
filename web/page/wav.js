// SPDX-License-Identifier: MIT
// A sound file of one channel of floats, with the samples as they are.

const HEADER = 58; // bytes before the samples
const IEEE_FLOAT = 3;

function writeText(view, at, text) {
  for (let i = 0; i < text.length; i++) view.setUint8(at + i, text.charCodeAt(i));
}

/** The header of a file of `frames` frames; floats take the chunk `fact`. */
function header(frames, rate) {
  const view = new DataView(new ArrayBuffer(HEADER));
  writeText(view, 0, "RIFF");
  view.setUint32(4, HEADER - 8 + 4 * frames, true);
  writeText(view, 8, "WAVEfmt ");
  view.setUint32(16, 18, true); // bytes of fmt
  view.setUint16(20, IEEE_FLOAT, true);
  view.setUint16(22, 1, true); // channels
  view.setUint32(24, rate, true);
  view.setUint32(28, 4 * rate, true); // bytes per second
  view.setUint16(32, 4, true); // bytes of a frame
  view.setUint16(34, 32, true); // bits of a sample
  writeText(view, 38, "fact");
  view.setUint32(42, 4, true);
  view.setUint32(46, frames, true);
  writeText(view, 50, "data");
  view.setUint32(54, 4 * frames, true);
  return view;
}

/** A WAV file of `pieces`, arrays of floats. */
export function wavFile(pieces, rate) {
  const frames = pieces.reduce((sum, piece) => sum + piece.length, 0);
  return new Blob([header(frames, rate), ...pieces], { type: "audio/wav" });
}
