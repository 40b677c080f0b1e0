// SPDX-License-Identifier: MIT
// How long a recording of the page lasts: a WAV file of two channels of floats at 48 kHz.
import { statSync } from "node:fs";

const HEADER_BYTES = 58;
const FRAME_BYTES = 8;
const RATE = 48000; // [Hz]

export const takeSeconds = (file) => (statSync(file).size - HEADER_BYTES) / FRAME_BYTES / RATE; // [s]
