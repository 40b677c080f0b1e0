// SPDX-License-Identifier: MIT
// A recording under way: its sound, and its strokes for `tabor render --events`.
import { wavFile } from "./wav.js";

const MOST_SECONDS = 600;
const TECHNIQUE_NAMES = ["normal", "buzz", "rimshot", "cross-stick", "rim"]; // by the engine's numbers

export class Recorder {
  #rate;
  #channels;
  #pieces = [];
  #strokes = [];
  #start = null; // frame of the first sample
  #frames = 0;

  /** `command` is what makes the same sound again of the strokes. */
  constructor(channels, rate, command) {
    this.command = command;
    this.#channels = channels;
    this.#rate = rate;
  }

  add({ sound, frame }) {
    this.#start ??= frame;
    this.#pieces.push(sound);
    this.#frames += sound.length / this.#channels;
  }

  addStroke(stroke) {
    this.#strokes.push(stroke);
  }

  get isFull() {
    return this.#frames >= MOST_SECONDS * this.#rate;
  }

  get seconds() {
    return this.#frames / this.#rate;
  }

  sound() {
    return wavFile(this.#pieces, this.#channels, this.#rate);
  }

  #row({ frame, velocity, radius, angle, technique }) {
    const time = (frame - this.#start) / this.#rate;
    return [time, velocity, radius, angle, TECHNIQUE_NAMES[technique]].join(",");
  }

  /** The strokes as a table, or null if there was none. */
  strokes() {
    const heard = this.#strokes.filter(({ frame }) => frame >= this.#start);
    if (heard.length === 0) return null;
    const rows = heard.map((stroke) => this.#row(stroke));
    const text = ["time,velocity,radius,angle,technique", ...rows, ""].join("\n");
    return new Blob([text], { type: "text/csv" });
  }
}
