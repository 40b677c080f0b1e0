// SPDX-License-Identifier: MIT
// A recording under way: its sound, and its strokes for `tabor render`: of a drum for --events, of a kit for --midi-file.
import { noteOf } from "./kits.js";
import { midiFile } from "./midi_file.js";
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
  #drums; // of a kit
  #midi; // the kit's MidiMap

  /** `command` is what makes the same sound again of the strokes; `drums` are those of a kit, `midi` its MidiMap. */
  constructor(channels, rate, command, drums = null, midi = null) {
    this.command = command;
    this.#drums = drums;
    this.#midi = midi;
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

  get isOfKit() {
    return this.#drums !== null;
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

  /** Their notes strike where the drums' own strokes do, at the nearest velocity. A stroke without a note is left out. */
  #midiOf(strokes) {
    const notes = strokes.map((stroke) => ({ ...stroke, note: noteOf(this.#drums, stroke) })).filter(({ note }) => note >= 0);
    return midiFile(notes.map(({ frame, note, velocity }) => (
      { frame: frame - this.#start, note, velocity: this.#midi.velocityOf(note, velocity) })), this.#rate);
  }

  #tableOf(strokes) {
    const rows = strokes.map((stroke) => this.#row(stroke));
    const text = ["time,velocity,radius,angle,technique", ...rows, ""].join("\n");
    return new Blob([text], { type: "text/csv" });
  }

  /** The strokes as a file, or null if there was none. */
  strokes() {
    const heard = this.#strokes.filter(({ frame }) => frame >= this.#start);
    if (heard.length === 0) return null;
    return this.isOfKit ? this.#midiOf(heard) : this.#tableOf(heard);
  }
}
