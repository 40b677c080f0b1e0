// SPDX-License-Identifier: MIT
// Sounds as WAV files of floats, for the tests of the package for npm.

/** The bytes of a file with these channels. */
export function floatWav(channels, rate) {
  const frames = channels[0].length;
  const size = frames * channels.length * 4;
  const file = Buffer.alloc(44 + size);
  file.write("RIFF");
  file.writeUInt32LE(36 + size, 4);
  file.write("WAVEfmt ", 8);
  const format = [[16, 4], [3, 2], [channels.length, 2], [rate, 4], [rate * channels.length * 4, 4], [channels.length * 4, 2], [32, 2]];
  format.reduce((at, [value, bytes]) => file.writeUIntLE(value, at, bytes), 16);
  file.write("data", 36);
  file.writeUInt32LE(size, 40);
  for (let n = 0; n < frames; n++) {
    channels.forEach((channel, i) => file.writeFloatLE(channel[n], 44 + 4 * (n * channels.length + i)));
  }
  return file;
}
