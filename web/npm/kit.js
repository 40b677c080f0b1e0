// SPDX-License-Identifier: MIT
// A kit, whose drums stand in one room and hear each other. index.d.ts describes it.
import { Instrument, TaborError, inRange, needObject, oneOf } from "./instrument.js";

// Values of the mix that move while it plays, by the engine's numbers, and their ranges [dB].
const MIX = { "kit.overheads": [0, -120, 24], "kit.coupling": [1, -60, 24] };
const OFF = -120; // [dB]

export class Kit extends Instrument {
  static create(name, { outputs = [], ...options } = {}) {
    return Instrument.build((engine) => new Kit(engine, name, true), outputs, options);
  }

  get outputKey() {
    return "outputs";
  }

  get outputNames() {
    return this.texts((i) => this.call("instrument_drum_name", i));
  }

  describe() {
    const names = this.outputNames;
    const sides = ["left", "right"];
    this.drums = names;
    this.channels = Array.from({ length: this.channelCount }, (_, i) =>
      i < 2 ? sides[i] : `${names[this.call("instrument_channel", i)]} ${sides[i % 2]}`);
  }

  #number(drum) {
    return this.drums.indexOf(oneOf("drum", drum, this.drums));
  }

  strikers(drum) {
    return this.strikersOf(this.#number(drum));
  }

  pitch(drum, head = "batter") {
    return this.pitchOf(this.#number(drum), head);
  }

  strike(given = {}) {
    needObject("a stroke", given);
    const { drum, ...stroke } = given;
    const number = this.#number(drum);
    this.strikeDrum(number, (key) => this.get(`drum.${drum}.strike.${key}`), stroke);
  }

  change(key, value, frame) {
    if (Object.hasOwn(MIX, key)) return this.#changeMix(key, value, frame);
    const [part, drum, ...rest] = key.split(".");
    if (part !== "drum") {
      this.get(key); // there may be none
      throw new TaborError(`${key}: this does not change while the kit rings`, key, value);
    }
    this.changeDrum(this.#number(drum), rest.join("."), key, value, 0, frame);
  }

  #changeMix(key, value, frame) {
    const [parameter, least, most] = MIX[key];
    if (value !== "off") inRange(key, value, least, most, "dB");
    this.changeMix(parameter, value === "off" ? OFF : value, frame);
  }
}
