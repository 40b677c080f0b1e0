// SPDX-License-Identifier: MIT
// A sound file of floats, with the samples as they are.

const HEADER = 58; // bytes before the samples
const IEEE_FLOAT = 3;

function writeText(view, at, text) {
  for (let i = 0; i < text.length; i++) view.setUint8(at + i, text.charCodeAt(i));
}

/** The header of a file of `frames` frames; floats take the chunk `fact`. */
function header(frames, channels, rate) {
  const frameBytes = 4 * channels;
  const view = new DataView(new ArrayBuffer(HEADER));
  writeText(view, 0, "RIFF");
  view.setUint32(4, HEADER - 8 + frameBytes * frames, true);
  writeText(view, 8, "WAVEfmt ");
  view.setUint32(16, 18, true); // bytes of fmt
  view.setUint16(20, IEEE_FLOAT, true);
  view.setUint16(22, channels, true);
  view.setUint32(24, rate, true);
  view.setUint32(28, frameBytes * rate, true); // bytes per second
  view.setUint16(32, frameBytes, true);
  view.setUint16(34, 32, true); // bits of a sample
  writeText(view, 38, "fact");
  view.setUint32(42, 4, true);
  view.setUint32(46, frames, true);
  writeText(view, 50, "data");
  view.setUint32(54, frameBytes * frames, true);
  return view;
}

/** A WAV file of `pieces`, arrays of floats, the channels of a frame side by side. */
export function wavFile(pieces, channels, rate) {
  const samples = pieces.reduce((sum, piece) => sum + piece.length, 0);
  return new Blob([header(samples / channels, channels, rate), ...pieces], { type: "audio/wav" });
}
