// SPDX-License-Identifier: MIT
// A drum in an engine of its own, whose memory goes with it. index.d.ts describes it.
import { LEDGER, change, textAt, withText } from "./engine.js";

const BLOCK = 128; // frames that the engine computes at once at most (web/glue.c)
const OWN_STRIKER = -1; // of the definition
const MOST_EVENTS = 63; // of a block, beside the drum's own (web/glue.h)
const QUALITIES = ["draft", "live", "studio", "reference"]; // the engine counts from 1
// By the engine's numbers; "buzz" and "sweep" need a hand that lifts the stick again.
const TECHNIQUES = { normal: 0, rimshot: 2, "cross-stick": 3, rim: 4 };
// What building a model may take by the engine's estimate: all presets do with less, at "reference" up to 15 s and 0.9 GB.
const MOST_SECONDS = 30;
const MOST_BYTES = 2e9;
const MOST_MEMORY = 2 ** 32 - 1; // of WebAssembly [bytes]
const SPEEDS = [0.01, 30]; // [m/s]

export class TaborError extends RangeError {
  constructor(message, key = "", value = "", minimum = NaN, maximum = NaN) {
    super(message);
    this.name = "TaborError";
    Object.assign(this, { key, value: String(value), minimum, maximum });
  }
}

/** What WebAssembly would refuse, or convert, only once the event is due. */
function needNumber(key, value) {
  if (typeof value !== "number") throw new TypeError(`${key} = ${String(value)}: its type is ${typeof value}, not number`);
}

function wholeFrom(key, value, minimum) {
  needNumber(key, value);
  if (Number.isInteger(value) && value >= minimum) return;
  throw new TaborError(`${key} = ${value}: allowed: whole numbers from ${minimum} on`, key, value, minimum, Infinity);
}

let start = null;

/** How index.js starts an engine. */
export function startWith(starter) {
  start = starter;
}

function oneOf(key, value, allowed) {
  if (allowed.includes(value)) return value;
  throw new TaborError(`${key} = '${value}': allowed: ${allowed.join(", ")}`, key, value);
}

export function inRange(key, value, minimum, maximum, unit) {
  needNumber(key, value);
  if (value >= minimum && value <= maximum) return value;
  const range = `${minimum} to ${maximum}${unit && ` ${unit}`}`;
  throw new TaborError(`${key} = ${value}: allowed: ${range}`, key, value, minimum, maximum);
}

export class Drum {
  #engine;
  #drum; // its address
  #events = []; // { frame, send }, in the order in which they act
  #frame = 0;

  static async create(preset, { quality = "live", sampleRate = 48000, set = {}, mics = [], progress,
    mostSeconds = MOST_SECONDS, mostBytes = MOST_BYTES } = {}) {
    const number = 1 + QUALITIES.indexOf(oneOf("quality", quality, QUALITIES));
    needNumber("sampleRate", sampleRate);
    inRange("mostSeconds", mostSeconds, 0, Infinity, "s");
    inRange("mostBytes", mostBytes, 0, MOST_MEMORY, "");
    const drum = new Drum(await start(progress), preset);
    for (const [key, value] of Object.entries(set)) drum.#set(key, value);
    for (const name of mics) drum.#addMic(name);
    drum.#build(number, sampleRate, mostSeconds, mostBytes);
    return drum;
  }

  /** Not for others: Drum.create() is. */
  constructor(engine, preset) {
    this.#engine = engine;
    this.#drum = withText(engine, String(preset), engine.drum_create);
    if (!this.#drum) throw new Error("there is not enough memory");
    this.#check();
    this.strikers = this.#names((drum, i) => engine.definition_striker(engine.drum_definition(drum), i));
  }

  /* ---- before it is built ---- */

  /** Throws what the engine has to say. */
  #check() {
    const { drum_error, drum_error_key, drum_error_value, drum_error_bound } = this.#engine;
    const [message, key, value] = [drum_error, drum_error_key, drum_error_value].map((read) => this.#text(read(this.#drum)));
    if (message) throw new TaborError(message, key, value, drum_error_bound(this.#drum, 0), drum_error_bound(this.#drum, 1));
  }

  #text(address) {
    return textAt(this.#engine, address);
  }

  #names(nameOf) {
    const names = [];
    for (let address; (address = nameOf(this.#drum, names.length)); ) names.push(this.#text(address));
    return names;
  }

  #set(key, value) {
    change(this.#engine, this.#engine.drum_set, this.#drum, [key, String(value)]);
    this.#check();
  }

  #addMic(name) {
    oneOf("mics", name, this.#names(this.#engine.mic_name));
    if (!withText(this.#engine, name, (address) => this.#engine.drum_add_mic(this.#drum, address))) {
      throw new TaborError(`mics = '${name}': given twice`, "mics", name);
    }
  }

  #build(quality, sampleRate, mostSeconds, mostBytes) {
    this.#engine.drum_build(this.#drum, quality, sampleRate, mostSeconds, mostBytes);
    this.#check();
    this.sampleRate = sampleRate;
    const names = this.#names(this.#engine.mic_name);
    const channels = Array.from({ length: this.#engine.drum_channels(this.#drum) }, (_, i) => i);
    this.mics = channels.map((i) => names[this.#engine.drum_mic(this.#drum, i)]);
  }

  /* ---- facts ---- */

  get frame() {
    return this.#frame;
  }

  get keys() {
    const keys = [];
    for (let key; (key = this.#text(this.#engine.drum_key(this.#drum, keys.length))); ) keys.push(key);
    return keys;
  }

  get(key) {
    const address = withText(this.#engine, key, (text) => this.#engine.drum_text(this.#drum, text));
    const value = this.#text(address);
    this.#check();
    return value;
  }

  pitch(head = "batter") {
    const index = oneOf("head", head, ["batter", "resonant"]) === "batter" ? 0 : 1;
    return this.#engine.definition_pitch(this.#engine.drum_definition(this.#drum), index);
  }

  ledger() {
    const values = new Float64Array(this.#engine.memory.buffer, this.#engine.drum_ledger(this.#drum), LEDGER.length);
    return Object.fromEntries(LEDGER.map((name, i) => [name, values[i]]));
  }

  get isSilent() {
    return Boolean(this.#engine.drum_is_silent(this.#drum));
  }

  get droppedEvents() {
    return this.#engine.drum_dropped_events(this.#drum);
  }

  get roomEnergy() {
    return this.#engine.room_energy(this.#drum);
  }

  /* ---- what happens to it ---- */

  /** Events at one frame act in the order in which they were given. */
  #add(frame, send) {
    wholeFrom("frame", frame, this.#frame);
    let place = this.#events.length;
    while (place > 0 && this.#events[place - 1].frame > frame) place--;
    this.#events.splice(place, 0, { frame, send });
  }

  /** A number of the definition's default stroke. */
  #own(key) {
    return Number(this.get(`strike.${key}`));
  }

  strike({ velocity = this.#own("velocity"), radius = this.#own("radius"), angle = this.#own("angle"),
    technique = this.get("strike.technique"), striker, frame = this.#frame } = {}) {
    inRange("velocity", velocity, ...SPEEDS, "m/s");
    inRange("radius", radius, 0, Number(this.get("shell.radius")), "m");
    inRange("angle", angle, -360, 360, "degrees");
    const number = TECHNIQUES[oneOf("technique", technique, Object.keys(TECHNIQUES))];
    const which = striker === undefined ? OWN_STRIKER : this.strikers.indexOf(oneOf("striker", striker, this.strikers));
    this.#add(frame, (offset) => this.#engine.drum_strike(this.#drum, offset, velocity, radius, angle, number, which));
  }

  change(key, value, frame = this.#frame) {
    const parameter = withText(this.#engine, key, this.#engine.live_parameter);
    this.get(key); // the drum may lack it
    if (!parameter) throw new TaborError(`${key}: this does not change while the drum rings`, key, value);
    const bound = (which) => this.#engine.parameter_bound(parameter, which);
    inRange(key, value, bound(0), bound(1), "");
    const mic = Math.max(0, this.#names(this.#engine.mic_name).indexOf(key.split(".")[1]));
    this.#add(frame, (offset) => this.#engine.drum_change(this.#drum, offset, parameter, mic, value));
  }

  reset() {
    this.#events = [];
    this.#frame = 0;
    this.#engine.drum_reset(this.#drum);
  }

  /* ---- sound ---- */

  /**
   * Hands the engine the events of the next block, and returns its length, at most `most` frames. Where events are too many for
   * one block, it ends before them; where they are at one frame, after 0 frames. The sound does not depend on the division.
   */
  #send(most) {
    const end = Math.min(this.#frame + most, this.#events[MOST_EVENTS]?.frame ?? Infinity);
    const later = this.#events.findIndex(({ frame }) => frame >= end);
    const due = end === this.#frame ? MOST_EVENTS : later < 0 ? this.#events.length : later;
    for (const { frame, send } of this.#events.splice(0, due)) send(frame - this.#frame);
    return end - this.#frame;
  }

  process(frames) {
    wholeFrom("frames", frames, 0);
    const channels = this.mics.map(() => new Float32Array(frames));
    for (let done = 0; done < frames; ) {
      const count = this.#send(Math.min(BLOCK, frames - done));
      const address = this.#engine.drum_play(this.#drum, count);
      const { buffer } = this.#engine.memory;
      channels.forEach((channel, i) => channel.set(new Float32Array(buffer, address + 4 * BLOCK * i, count), done));
      done += count;
      this.#frame += count;
    }
    return channels;
  }
}
