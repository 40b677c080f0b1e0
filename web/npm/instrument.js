// SPDX-License-Identifier: MIT
// What a drum and a kit have in common: an engine of its own, whose memory goes with it, and events in order of time.
// index.d.ts describes it.
import { LEDGER, change, textAt, withBytes, withText } from "./engine.js";
import { send } from "./events.js";

const BLOCK = 128; // frames that the engine computes at once at most (web/glue.h)
const OWN_STRIKER = -1; // of the definition
const OF_DEFINITION = 0; // a quality by the engine's numbers
const QUALITIES = ["draft", "live", "studio", "reference"]; // from 1 on
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

function wholeFrom(key, value, minimum, maximum = Infinity) {
  needNumber(key, value);
  if (Number.isInteger(value) && value >= minimum && value <= maximum) return;
  const bounds = maximum === Infinity ? `from ${minimum} on` : `${minimum} to ${maximum}`;
  throw new TaborError(`${key} = ${value}: allowed: whole numbers ${bounds}`, key, value, minimum, maximum);
}

/** A stroke is an object: a text would be one without properties. */
export function needObject(name, value) {
  if (typeof value !== "object" || value === null) throw new TypeError(`${name}: ${String(value)} is no object`);
}

let start = null;

/** How index.js starts an engine. */
export function startWith(starter) {
  start = starter;
}

export function oneOf(key, value, allowed) {
  if (allowed.includes(value)) return value;
  throw new TaborError(`${key} = '${value}': allowed: ${allowed.join(", ")}`, key, value);
}

export function inRange(key, value, minimum, maximum, unit) {
  needNumber(key, value);
  if (value >= minimum && value <= maximum) return value;
  const range = `${minimum} to ${maximum}${unit && ` ${unit}`}`;
  throw new TaborError(`${key} = ${value}: allowed: ${range}`, key, value, minimum, maximum);
}

/** The bytes of a MIDI file, or null for something else. */
export function bytesOf(file) {
  if (file instanceof ArrayBuffer) return new Uint8Array(file);
  return ArrayBuffer.isView(file) ? new Uint8Array(file.buffer, file.byteOffset, file.byteLength) : null;
}

export class Instrument {
  #engine;
  #address;
  #events = []; // of events.js, in the order in which they act
  #frame = 0;
  #hearsMidi = false;
  #port = null; // of the audio node in which it plays

  /** `make` gets an engine, and sets what it plays. */
  static async build(make, outputs, { quality, sampleRate = 48000, set = {}, progress, mostSeconds = MOST_SECONDS,
    mostBytes = MOST_BYTES } = {}) {
    const isSet = quality === undefined && Object.hasOwn(set, "quality.level");
    const number = isSet ? OF_DEFINITION : 1 + QUALITIES.indexOf(oneOf("quality", quality ?? "live", QUALITIES));
    needNumber("sampleRate", sampleRate);
    inRange("mostSeconds", mostSeconds, 0, Infinity, "s");
    inRange("mostBytes", mostBytes, 0, MOST_MEMORY, "");
    const instrument = make(await start(progress));
    for (const [key, value] of Object.entries(set)) instrument.#set(key, value);
    for (const name of outputs) instrument.#addOutput(name);
    instrument.#engine.instrument_build(instrument.#address, number, sampleRate, mostSeconds, mostBytes);
    instrument.#check();
    instrument.sampleRate = sampleRate;
    instrument.describe();
    return instrument;
  }

  constructor(engine, name, isKit) {
    this.#engine = engine;
    this.#address = withText(engine, String(name), (text) => engine.instrument_create(text, Number(isKit)));
    if (!this.#address) throw new Error("there is not enough memory");
    this.#check();
  }

  /* ---- before it is built ---- */

  /** Throws what the engine has to say. */
  #check() {
    const read = (what) => textAt(this.#engine, this.#engine[`instrument_${what}`](this.#address));
    const [message, key, value] = ["error", "error_key", "error_value"].map(read);
    const bound = (which) => this.#engine.instrument_error_bound(this.#address, which);
    if (message) throw new TaborError(message, key, value, bound(0), bound(1));
  }

  /** A drum that is not there is a mistake, unless its preset is given. */
  #set(key, value) {
    const count = this.call("instrument_drum_count");
    change(this.#engine, this.#address, [key, String(value)]);
    this.#check();
    if (this.call("instrument_drum_count") === count || key.endsWith(".preset")) return;
    const drum = key.split(".")[1];
    throw new TaborError(`${key}: the kit has no drum '${drum}'; 'drum.${drum}.preset' adds it`, key, value);
  }

  #addOutput(name) {
    oneOf(this.outputKey, name, this.outputNames);
    if (!withText(this.#engine, name, (address) => this.#engine.instrument_add_output(this.#address, address))) {
      throw new TaborError(`${this.outputKey} = '${name}': given twice`, this.outputKey, name);
    }
  }

  /* ---- facts ---- */

  /** Calls a function of the engine for this instrument. */
  call(name, ...values) {
    return this.#engine[name](this.#address, ...values);
  }

  /** Texts at the addresses that a function of the engine has for 0, 1, ... */
  texts(addressOf) {
    const found = [];
    for (let address; (address = addressOf(found.length)); ) found.push(textAt(this.#engine, address));
    return found;
  }

  get channelCount() {
    return this.call("instrument_channels");
  }

  /** Names of the strikers of a drum. */
  strikersOf(drum) {
    const definition = this.call("instrument_definition", drum);
    return this.texts((i) => this.#engine.definition_striker(definition, i));
  }

  get frame() {
    return this.#frame;
  }

  get keys() {
    const keys = [];
    for (let key; (key = textAt(this.#engine, this.call("instrument_key", keys.length))); ) keys.push(key);
    return keys;
  }

  get(key) {
    const value = textAt(this.#engine, withText(this.#engine, key, (text) => this.call("instrument_text", text)));
    this.#check();
    return value;
  }

  pitchOf(drum, head) {
    const index = oneOf("head", head, ["batter", "resonant"]) === "batter" ? 0 : 1;
    return this.#engine.definition_pitch(this.call("instrument_definition", drum), index);
  }

  ledger() {
    this.#own();
    const values = new Float64Array(this.#engine.memory.buffer, this.call("instrument_ledger"), LEDGER.length);
    return Object.fromEntries(LEDGER.map((name, i) => [name, values[i]]));
  }

  get isSilent() {
    return Boolean(this.call("instrument_is_silent"));
  }

  get droppedEvents() {
    return this.call("instrument_dropped_events");
  }

  get roomEnergy() {
    return this.call("room_energy");
  }

  /* ---- what happens to it ---- */

  /** Events at one frame act in the order in which they were given. */
  #add(event) {
    wholeFrom("frame", event.frame, this.#frame);
    if (this.#port) return this.#port.postMessage(event);
    let place = this.#events.length;
    while (place > 0 && this.#events[place - 1].frame > event.frame) place--;
    this.#events.splice(place, 0, event);
  }

  /** `own` has the numbers of the drum's default stroke: own("velocity"). */
  strikeDrum(drum, own, { velocity = Number(own("velocity")), radius = Number(own("radius")), angle = Number(own("angle")),
    technique = own("technique"), striker, frame = this.#frame }) {
    const strikers = this.strikersOf(drum);
    const most = withText(this.#engine, "shell.radius", (key) =>
      this.#engine.definition_number(this.call("instrument_definition", drum), key));
    inRange("velocity", velocity, ...SPEEDS, "m/s");
    inRange("radius", radius, 0, most, "m");
    inRange("angle", angle, -360, 360, "degrees");
    const number = TECHNIQUES[oneOf("technique", technique, Object.keys(TECHNIQUES))];
    const which = striker === undefined ? OWN_STRIKER : strikers.indexOf(oneOf("striker", striker, strikers));
    this.#add({ frame, name: "instrument_strike", before: [drum], after: [velocity, radius, angle, number, which] });
  }

  /** `key` is one of the drum's, `full` what the instrument calls it. */
  changeDrum(drum, key, full, value, mic, frame = this.#frame) {
    const parameter = withText(this.#engine, key, this.#engine.live_parameter);
    this.get(full); // the drum may lack it
    if (!parameter) throw new TaborError(`${full}: this does not change while the drum rings`, full, value);
    const bound = (which) => this.#engine.parameter_bound(parameter, which);
    inRange(full, value, bound(0), bound(1), "");
    this.#add({ frame, name: "instrument_change", before: [drum], after: [parameter, mic, value] });
  }

  changeMix(parameter, value, frame = this.#frame) {
    this.#add({ frame, name: "instrument_mix", before: [], after: [parameter, value] });
  }

  /** A message of MIDI, [status, first, second], as `tabor render --midi-file` plays it. */
  midi(message, frame = this.#frame) {
    const [status, first = 0, second = 0] = message;
    wholeFrom("the status of a message", status, 128, 255);
    for (const byte of [first, second]) wholeFrom("a byte of a message", byte, 0, 127);
    this.#hearMidi();
    this.#add({ frame, name: "instrument_send_midi", before: [], after: [status, first, second] });
  }

  #hearMidi() {
    if (!this.#hearsMidi && !this.call("instrument_begin_midi")) throw new Error("there is not enough memory");
    this.#hearsMidi = true;
  }

  /** The events of a MIDI file, its bytes, from a frame on. Returns the last frame that has one, and lines that say what was passed
   * over. */
  midiFile(file, frame = this.#frame) {
    const engine = this.#engine;
    const bytes = bytesOf(file);
    if (!bytes) throw new TypeError("a MIDI file is an ArrayBuffer or an array of bytes");
    wholeFrom("frame", frame, this.#frame);
    const song = withBytes(engine, bytes, (address) => engine.song_read(address, bytes.length));
    if (!song) throw new Error("there is not enough memory");
    if (!engine.song_compose(song, this.#address, this.sampleRate)) {
      const message = textAt(engine, engine.song_error(song)) || "there is not enough memory";
      engine.song_free(song);
      throw new TaborError(message, "midiFile");
    }
    const warnings = Array.from({ length: engine.song_warning_count(song) }, (_, i) => textAt(engine, engine.song_warning(song, i)));
    const count = engine.song_count(song);
    let last = frame;
    for (let i = 0; i < count; i++) {
      last = frame + engine.song_frame(song, i);
      const message = engine.song_message(song, i, this.#address);
      this.#add({ frame: last, message: new Uint8Array(engine.memory.buffer, message, engine.message_size()).slice() });
    }
    engine.song_free(song);
    return { last, warnings };
  }

  /** What an audio node begins with, which plays on instead: its memory, and the events that are due. */
  async leaveTo(connect) {
    this.#own();
    this.#hearMidi();
    const memory = this.#engine.memory.buffer.slice(0);
    this.#port = await connect({ address: this.#address, memory, events: this.#events });
    this.#events = [];
  }

  #own() {
    if (this.#port) throw new Error("it plays in an audio node, which has its sound and its account");
  }

  reset() {
    this.#own();
    this.#events = [];
    this.#frame = 0;
    this.#hearsMidi = false;
    this.call("instrument_reset");
  }

  /* ---- sound ---- */

  process(frames) {
    wholeFrom("frames", frames, 0);
    this.#own();
    const channels = Array.from({ length: this.channelCount }, () => new Float32Array(frames));
    for (let done = 0; done < frames; ) {
      const count = Math.min(BLOCK, frames - done);
      send(this.#engine, this.#address, this.#events, this.#frame, count);
      const address = this.call("instrument_play", count);
      const { buffer } = this.#engine.memory;
      channels.forEach((channel, i) => channel.set(new Float32Array(buffer, address + 4 * BLOCK * i, count), done));
      done += count;
      this.#frame += count;
    }
    return channels;
  }
}
