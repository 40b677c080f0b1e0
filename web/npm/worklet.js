// SPDX-License-Identifier: MIT
// Plays a drum or a kit on the audio thread of a page: the processor of audio_node.js. Events come as messages.
import { ContinuedEngine } from "./engine.js";
import { send } from "./events.js";

const BLOCK = 128; // frames
const COPIED = 1 << 20; // of the memory of a new instrument, in the time of a block [bytes]

class TaborProcessor extends AudioWorkletProcessor {
  #frame = 0; // of its first block that sounds: 0

  constructor({ processorOptions: { module, address, memory, events } }) {
    super();
    this.coming = new ContinuedEngine(module, memory);
    this.engine = this.coming.exports;
    this.instrument = address;
    this.events = events;
    this.port.onmessage = ({ data }) => this.add(data);
  }

  add(event) {
    let place = this.events.length;
    while (place > 0 && this.events[place - 1].frame > event.frame) place--;
    this.events.splice(place, 0, event);
  }

  /** Silence until all of its memory is there. */
  process(_, [outputs]) {
    if (this.coming) {
      if (this.coming.copy(COPIED)) this.coming = null;
      return true;
    }
    send(this.engine, this.instrument, this.events, this.#frame, BLOCK);
    const address = this.engine.instrument_play(this.instrument, BLOCK);
    const { buffer } = this.engine.memory;
    outputs.forEach((output, i) => output.set(new Float32Array(buffer, address + 4 * BLOCK * i, BLOCK)));
    this.#frame += BLOCK;
    return true;
  }
}

registerProcessor("tabor", TaborProcessor);
