// SPDX-License-Identifier: MIT
// A standard MIDI file of notes. Its ticks are the blocks at whose beginnings strokes act, so that it keeps their times.

const BLOCK = 128; // frames
const DIVISION = 3; // ticks of a quarter
const CHANNEL = 9; // of percussion
const NOTE_ON = 0x90;

const text = (letters) => Array.from(letters, (letter) => letter.charCodeAt(0));
const bigEndian = (value, bytes) => Array.from({ length: bytes }, (_, i) => (value >>> (8 * (bytes - 1 - i))) & 0xff);
const chunk = (name, data) => [...text(name), ...bigEndian(data.length, 4), ...data];

/** Seven bits in each byte, the top bit set in all but the last. */
function variable(value) {
  const bytes = [value & 0x7f];
  while ((value >>>= 7) > 0) bytes.unshift((value & 0x7f) | 0x80);
  return bytes;
}

/** `notes` are { frame, note, velocity }, in ascending order. */
export function midiFile(notes, rate) {
  const tempo = Math.round((DIVISION * BLOCK * 1e6) / rate); // [us] of a quarter; exact at 48 kHz
  const track = [0, 0xff, 0x51, 3, ...bigEndian(tempo, 3)];
  let last = 0; // tick
  for (const { frame, note, velocity } of notes) {
    const tick = frame / BLOCK;
    track.push(...variable(tick - last), NOTE_ON | CHANNEL, note, velocity, 0, NOTE_ON | CHANNEL, note, 0);
    last = tick;
  }
  track.push(0, 0xff, 0x2f, 0);
  const header = [...bigEndian(0, 2), ...bigEndian(1, 2), ...bigEndian(DIVISION, 2)];
  return new Blob([new Uint8Array([...chunk("MThd", header), ...chunk("MTrk", track)])], { type: "audio/midi" });
}
