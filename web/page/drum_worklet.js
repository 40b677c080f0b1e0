// SPDX-License-Identifier: MIT
// Plays the drum, on the audio thread. Messages to it:
//
//   { type: "engine", bytes }            the engine; before everything else
//   { type: "drum", drum, memory }       another drum, as build_worker.js makes it; the former fades out
//   { type: "strike", velocity, radius, angle, technique }
//   { type: "strainer", value }          1: the snares are on, 0: off
//   { type: "record", on }
//
// Messages from it: { type: "playing" } for each new drum; { type: "struck", frame, ... } for each stroke;
// { type: "level", peak } some fifty times a second; { type: "recorded", sound, frame, last }.
import { continueEngine } from "./engine.js";

const BLOCK = 128; // frames
const FADE = 0.03; // of the drum that another one replaces [s]
const LEVEL_BLOCKS = 8; // blocks of one level
const PIECE_BLOCKS = 32; // blocks of one piece of a recording

/** A drum in an engine of its own. */
class Voice {
  constructor(module, { drum, memory }) {
    this.engine = continueEngine(module, memory);
    this.drum = drum;
    this.left = Math.round(FADE * sampleRate); // frames of the fade, once it fades
  }

  strike({ velocity, radius, angle, technique }) {
    return this.engine.drum_strike(this.drum, velocity, radius, angle, technique);
  }

  setStrainer(value) {
    this.engine.drum_set_strainer(this.drum, value);
  }

  /** The next block; it is overwritten by the next call. */
  process() {
    return new Float32Array(this.engine.memory.buffer, this.engine.drum_process(this.drum), BLOCK);
  }

  /** Adds the next block of the fade to `output`; false once it is over. */
  addFade(output) {
    const whole = FADE * sampleRate;
    const block = this.process();
    for (let i = 0; i < BLOCK && this.left > 0; i++, this.left--) {
      output[i] += (block[i] * this.left) / whole;
    }
    return this.left > 0;
  }
}

class DrumProcessor extends AudioWorkletProcessor {
  frame = 0; // the first of the next block
  voice = null;
  former = null;
  module = null;
  peak = 0;
  levelBlocks = 0;
  recording = null; // { sound, blocks }

  constructor() {
    super();
    this.pending = Promise.resolve(); // messages act one after the other
    this.port.onmessage = ({ data }) => this.receive(data);
  }

  async compile(bytes) {
    this.module = await WebAssembly.compile(bytes);
  }

  receive(message) {
    if (message.type === "engine") this.pending = this.compile(message.bytes);
    else if (this.module) this.act(message);
    else this.pending = this.pending.then(() => this.act(message));
  }

  act(message) {
    switch (message.type) {
      case "drum": return this.change(message);
      case "strike": return this.strike(message);
      case "strainer": return this.voice?.setStrainer(message.value);
      case "record": return message.on ? this.beginRecording() : this.sendRecording(true);
    }
  }

  change(message) {
    this.former = this.voice;
    this.voice = new Voice(this.module, message);
    this.port.postMessage({ type: "playing" });
  }

  strike(message) {
    if (!this.voice?.strike(message)) return;
    this.port.postMessage({ ...message, type: "struck", frame: this.frame });
  }

  beginRecording() {
    this.recording = { sound: new Float32Array(PIECE_BLOCKS * BLOCK), blocks: 0, frame: this.frame };
  }

  /** Sends what has been recorded since the last time. */
  sendRecording(last) {
    if (!this.recording) return;
    const { sound, blocks, frame } = this.recording;
    const piece = sound.slice(0, blocks * BLOCK);
    this.port.postMessage({ type: "recorded", sound: piece, frame, last }, [piece.buffer]);
    if (last) this.recording = null;
    else this.beginRecording();
  }

  record(output) {
    const recording = this.recording;
    recording.sound.set(output, recording.blocks * BLOCK);
    recording.blocks++;
  }

  /** A recording goes on with the block after this one. */
  finishBlock(output) {
    for (const sample of output) this.peak = Math.max(this.peak, Math.abs(sample));
    if (++this.levelBlocks === LEVEL_BLOCKS) {
      this.port.postMessage({ type: "level", peak: this.peak });
      this.peak = this.levelBlocks = 0;
    }
    if (this.recording) this.record(output);
    this.frame += BLOCK;
    if (this.recording?.blocks === PIECE_BLOCKS) this.sendRecording(false);
  }

  process(_, [[output]]) {
    if (this.voice) output.set(this.voice.process());
    if (this.former && !this.former.addFade(output)) this.former = null;
    this.finishBlock(output);
    return true;
  }
}

registerProcessor("tabor-drum", DrumProcessor);
