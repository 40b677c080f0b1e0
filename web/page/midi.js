// SPDX-License-Identifier: MIT
// What MIDI inputs and files do. The engine decides by the program's own map (web/midi_glue.c).
import { change, textAt, withBytes, withText } from "./engine.js";
import { kitOf } from "./kits.js";

const KINDS = [null, "stroke", "strainer"]; // WebMidiKind
const NUMBERS = 8; // of WebMidiAction
const NO_MEMORY = "there is not enough memory";

/** Plays MIDI on the definition of a drum or a kit. It makes no sound. */
export class MidiMap {
  #engine;
  #instrument = 0; // its address; 0: none yet

  constructor(engine) {
    this.#engine = engine;
  }

  /** Another drum or kit, which the engine has built before: nothing in it is refused. */
  follow(preset, settings) {
    const engine = this.#engine;
    engine.instrument_destroy(this.#instrument);
    const kit = kitOf(preset);
    this.#instrument = withText(engine, kit ?? preset, (name) => engine.instrument_create(name, Number(kit !== null)));
    for (const setting of settings) change(engine, this.#instrument, setting);
    engine.instrument_begin_midi(this.#instrument);
  }

  /** What a message does: { kind: "stroke", drum, velocity, radius, angle, technique }, { kind: "strainer", value } or null. */
  take([status, first = 0, second = 0]) {
    return this.#actionAt(this.#engine.instrument_take_midi(this.#instrument, status, first, second));
  }

  #actionAt(address) {
    const [kind, drum, value, radius, angle, technique, frame, striker] = new Float64Array(this.#engine.memory.buffer, address, NUMBERS);
    if (KINDS[kind] === "stroke") return { kind: "stroke", drum, velocity: value, radius, angle, technique, striker, frame };
    return KINDS[kind] === "strainer" ? { kind: "strainer", value, frame } : null;
  }

  /** What a MIDI file (a Blob) does at a rate: { said, actions }, each action as of take(), with its frame; no actions: null, if the
   * file is refused. What is said, a list of lines, are the words of `tabor render --midi-file`. */
  async readSong(file, rate) {
    const engine = this.#engine;
    const bytes = new Uint8Array(await file.slice(0, engine.song_most_bytes() + 1).arrayBuffer());
    const song = withBytes(engine, bytes, (address) => engine.song_read(address, bytes.length));
    if (!song) return { said: [NO_MEMORY], actions: null };
    const isPlayed = engine.song_compose(song, this.#instrument, rate);
    const list = (count, item) => Array.from({ length: count }, (_, i) => item(i));
    const said = list(engine.song_warning_count(song), (i) => textAt(engine, engine.song_warning(song, i)));
    if (!isPlayed) said.push(textAt(engine, engine.song_error(song)) || NO_MEMORY);
    const actions = list(isPlayed ? engine.song_count(song) : 0, (i) => this.#actionAt(engine.song_action(song, i)));
    engine.song_free(song);
    return { said, actions: isPlayed ? actions.filter(Boolean) : null };
  }

  /** The velocity at which a note of a kit plays nearest to a speed [m/s]. */
  velocityOf(note, speed) {
    return this.#engine.instrument_velocity(this.#instrument, note, speed);
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
