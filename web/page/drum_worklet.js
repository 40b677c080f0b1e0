// SPDX-License-Identifier: MIT
// Plays the drum, on the audio thread. Messages to it:
//
//   { type: "engine", bytes }            the engine; before everything else
//   { type: "instrument", instrument, memory }    another drum or kit, as build_worker.js makes it; the former fades out
//   { type: "strike", drum, velocity, radius, angle, technique }    drum: of a kit
//   { type: "strainer", value }          1: the snares are on, 0: off
//   { type: "song", actions }            what a MIDI file does from now on, in order of frames: { kind: "stroke" or "strainer", frame, ... }
//   { type: "record", on }
//   { type: "film", on }                 pictures of the drum that is struck
//
// Messages from it: { type: "playing" } for each new drum; { type: "strained", value } and { type: "sung" }, of a MIDI file: the snares,
// and its end; { type: "struck", frame, ... } for each stroke;
// { type: "level", peak } some fifty times a second; { type: "ledger", injected, ... } some six times; { type: "recorded", sound, frame, last };
// { type: "filmed", drum, pictures } of the 40 ms from a stroke on, of a drum with one wire 120, one each PICTURE_FRAMES frames: film_view.js has what they consist of.
import { ContinuedEngine, LEDGER } from "./engine.js";

const BLOCK = 128; // frames
const CHANNELS = 2;
const DRUMS_OWN = -1; // the striker
const FADE = 0.03; // of the drum that another one replaces [s]
const COPIED = 1 << 20; // of the memory of a new drum, in the time of a block [bytes]
const LEVEL_BLOCKS = 8; // blocks of one level
const LEDGER_LEVELS = 8; // levels between two ledgers
const PIECE_BLOCKS = 32; // blocks of one piece of a recording
const FILM_BLOCKS = 15; // blocks of a film
const LONG_FILM_BLOCKS = 45; // of a drum with one wire: it bounces slowly
const BLOCK_PICTURES = 4; // of each filmed block

/** A drum or a kit in an engine of its own. */
class Voice {
  constructor(module, { instrument, memory }) {
    this.continued = new ContinuedEngine(module, memory);
    this.engine = this.continued.exports;
    this.instrument = instrument;
    this.left = Math.round(FADE * sampleRate); // frames of the fade, once it fades
  }

  /** Call until it is true; only then there is a drum. */
  arrive(most) {
    return this.continued.copy(most);
  }

  strike({ drum = 0, velocity, radius, angle, technique, striker = DRUMS_OWN }) {
    return this.engine.instrument_strike(this.instrument, drum, 0, velocity, radius, angle, technique, striker);
  }

  setStrainer(value) {
    this.engine.instrument_set_strainer(this.instrument, value);
  }

  /** The channels of the next block, until the next call. They stay in their place: memory grows no more. */
  process(film = null) {
    const { buffer } = this.engine.memory;
    const address = film
      ? this.engine.instrument_film(this.instrument, film.drum)
      : this.engine.instrument_play(this.instrument, BLOCK);
    this.block ??= Array.from({ length: CHANNELS }, (_, i) => new Float32Array(buffer, address + 4 * BLOCK * i, BLOCK));
    return this.block;
  }

  wires(drum) {
    return this.engine.picture_shape(this.instrument, drum, 3);
  }

  /** The numbers of the pictures of a filmed block of a drum. */
  picturesSize(drum) {
    return BLOCK_PICTURES * this.engine.picture_size(this.instrument, drum);
  }

  /** The pictures of the last block, if a drum was filmed. */
  pictures(drum) {
    return new Float32Array(this.engine.memory.buffer, this.engine.instrument_pictures(this.instrument), this.picturesSize(drum));
  }

  /** The energy account [J]. */
  ledger() {
    const values = new Float64Array(this.engine.memory.buffer, this.engine.instrument_ledger(this.instrument), LEDGER.length);
    return Object.fromEntries(LEDGER.map((name, i) => [name, values[i]]));
  }

  /** Adds the next block of the fade to the outputs; false once it is over. */
  addFade(outputs) {
    const whole = FADE * sampleRate;
    const block = this.process();
    for (let n = 0; n < BLOCK && this.left > 0; n++, this.left--) {
      for (let i = 0; i < CHANNELS; i++) outputs[i][n] += (block[i][n] * this.left) / whole;
    }
    return this.left > 0;
  }
}

class DrumProcessor extends AudioWorkletProcessor {
  frame = 0; // the first of the next block
  voice = null;
  former = null; // fades
  coming = null; // is being copied
  waiting = []; // strokes that came before the first drum
  strainer = null; // where the snares were put since the drum was chosen
  song = null; // { actions, next, start: the frame of its beginning }
  module = null;
  peak = 0;
  levelBlocks = 0;
  levels = 0;
  recording = null; // { sound, blocks }
  films = false; // a stroke begins a film
  film = null; // { pictures, blocks }

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
      case "instrument": return this.change(message);
      case "strike": return this.strike(message);
      case "strainer": return this.setStrainer(message.value);
      case "song": return this.beginSong(message.actions);
      case "film": return this.setFilms(message.on);
      case "record": return message.on ? this.beginRecording() : this.sendRecording(true);
    }
  }

  change(message) {
    this.coming = new Voice(this.module, message);
    this.strainer = null;
  }

  setStrainer(value) {
    this.strainer = value;
    if (!this.coming) this.voice?.setStrainer(value);
  }

  /** A little at a time while another drum sounds. */
  bringDrum() {
    if (!this.coming.arrive(this.voice ? COPIED : Infinity)) return;
    this.former = this.voice;
    this.voice = this.coming;
    this.coming = null;
    this.film = null;
    if (this.strainer !== null) this.voice.setStrainer(this.strainer);
    for (const stroke of this.waiting.splice(0)) this.strike(stroke);
    this.port.postMessage({ type: "playing" });
  }

  strike(message) {
    if (!this.voice) this.waiting.push(message);
    else if (this.voice.strike(message)) {
      this.port.postMessage({ ...message, type: "struck", frame: this.frame });
      if (this.films) this.beginFilm(message.drum ?? 0);
    }
  }

  /** Of a drum, unless there is one. */
  beginFilm(drum) {
    const size = this.voice.picturesSize(drum);
    const length = this.voice.wires(drum) === 1 ? LONG_FILM_BLOCKS : FILM_BLOCKS;
    this.film ??= { drum, pictures: new Float32Array(length * size), blocks: 0, length };
  }

  /** It begins with the next block that a drum plays. */
  beginSong(actions) {
    this.song = { actions, next: 0, start: null };
  }

  /** What is due in the next block. */
  playSong() {
    const { song } = this;
    song.start ??= this.frame;
    while (song.next < song.actions.length && song.start + song.actions[song.next].frame < this.frame + BLOCK) {
      this.actOfSong(song.actions[song.next++]);
    }
    if (song.next < song.actions.length) return;
    this.song = null;
    this.port.postMessage({ type: "sung" });
  }

  actOfSong({ kind, ...action }) {
    if (kind === "stroke") return this.strike(action);
    this.setStrainer(action.value);
    this.port.postMessage({ type: "strained", value: action.value });
  }

  setFilms(on) {
    this.films = on;
    if (!on) this.film = null;
  }

  /** Adds the last block. Strokes that fall into a film are part of it. */
  addPictures() {
    const { film } = this;
    film.pictures.set(this.voice.pictures(film.drum), film.blocks * this.voice.picturesSize(film.drum));
    if (++film.blocks < film.length) return;
    this.film = null;
    this.port.postMessage({ type: "filmed", drum: film.drum, pictures: film.pictures }, [film.pictures.buffer]);
  }

  beginRecording() {
    this.recording = { sound: new Float32Array(PIECE_BLOCKS * BLOCK * CHANNELS), blocks: 0, frame: this.frame };
  }

  /** Sends what has been recorded since the last time. */
  sendRecording(last) {
    if (!this.recording) return;
    const { sound, blocks, frame } = this.recording;
    const piece = sound.slice(0, blocks * BLOCK * CHANNELS);
    this.port.postMessage({ type: "recorded", sound: piece, frame, last }, [piece.buffer]);
    if (last) this.recording = null;
    else this.beginRecording();
  }

  /** Frame by frame, the channels of each side by side. */
  record(outputs) {
    const { sound, blocks } = this.recording;
    const start = blocks * BLOCK * CHANNELS;
    for (let i = 0; i < CHANNELS; i++) {
      for (let n = 0; n < BLOCK; n++) sound[start + n * CHANNELS + i] = outputs[i][n];
    }
    this.recording.blocks++;
  }

  report() {
    this.port.postMessage({ type: "level", peak: this.peak });
    this.peak = this.levelBlocks = 0;
    if (++this.levels % LEDGER_LEVELS > 0 || !this.voice) return;
    this.port.postMessage({ type: "ledger", ...this.voice.ledger() });
  }

  /** A recording goes on with the block after this one. */
  finishBlock(outputs) {
    for (const output of outputs) {
      for (const sample of output) this.peak = Math.max(this.peak, Math.abs(sample));
    }
    if (++this.levelBlocks === LEVEL_BLOCKS) this.report();
    if (this.recording) this.record(outputs);
    this.frame += BLOCK;
    if (this.recording?.blocks === PIECE_BLOCKS) this.sendRecording(false);
  }

  process(_, [outputs]) {
    if (this.coming) this.bringDrum();
    if (this.song && this.voice) this.playSong();
    if (this.voice) this.voice.process(this.film).forEach((channel, i) => outputs[i].set(channel));
    if (this.film) this.addPictures();
    if (this.former && !this.former.addFade(outputs)) this.former = null;
    this.finishBlock(outputs);
    return true;
  }
}

registerProcessor("tabor-drum", DrumProcessor);
