// SPDX-License-Identifier: MIT
// What messages of MIDI inputs do. The engine decides by the program's own map (web/midi_glue.c).
import { change, withText } from "./engine.js";
import { kitOf } from "./kits.js";

const KINDS = [null, "stroke", "strainer"]; // WebMidiKind
const NUMBERS = 6; // of WebMidiAction

/** Plays MIDI on the definition of a drum or a kit. It makes no sound. */
export class MidiMap {
  #engine;
  #kind = "drum"; // or "kit": the engine has the same functions for both
  #instrument = 0; // its address; 0: none yet

  constructor(engine) {
    this.#engine = engine;
  }

  #call(name, ...values) {
    return this.#engine[`${this.#kind}_${name}`](this.#instrument, ...values);
  }

  /** Another drum or kit, which the engine has built before: nothing in it is refused. */
  follow(preset, settings) {
    if (this.#instrument) this.#call("destroy");
    const kit = kitOf(preset);
    this.#kind = kit === null ? "drum" : "kit";
    this.#instrument = withText(this.#engine, kit ?? preset, this.#engine[`${this.#kind}_create`]);
    for (const setting of settings) change(this.#engine, this.#engine[`${this.#kind}_set`], this.#instrument, setting);
    this.#call("begin_midi");
  }

  /** What a message does: { kind: "stroke", drum, velocity, radius, angle, technique }, { kind: "strainer", value } or null. */
  take([status, first = 0, second = 0]) {
    const address = this.#call("take_midi", status, first, second);
    const [kind, drum, value, radius, angle, technique] = new Float64Array(this.#engine.memory.buffer, address, NUMBERS);
    if (KINDS[kind] === "stroke") return { kind: "stroke", drum, velocity: value, radius, angle, technique };
    return KINDS[kind] === "strainer" ? { kind: "strainer", value } : null;
  }

  /** The velocity at which a note of a kit plays nearest to a speed [m/s]. */
  velocityOf(note, speed) {
    return this.#call("velocity", note, speed);
  }
}

/** Hears all inputs, also those that come later. `tell` gets their number whenever it changes. */
export async function listenToMidi(hear, tell) {
  const access = await navigator.requestMIDIAccess();
  const connect = () => {
    for (const input of access.inputs.values()) input.onmidimessage = ({ data }) => hear(data);
    tell(access.inputs.size);
  };
  access.onstatechange = connect;
  connect();
}
