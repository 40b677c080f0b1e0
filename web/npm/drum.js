// SPDX-License-Identifier: MIT
// A drum in its room. index.d.ts describes it.
import { Instrument, needObject } from "./instrument.js";

const ALONE = 0; // number of the only drum

export class Drum extends Instrument {
  static create(preset, { mics = [], ...options } = {}) {
    return Instrument.build((engine) => new Drum(engine, preset, false), mics, options);
  }

  get outputKey() {
    return "mics";
  }

  get outputNames() {
    return this.texts((i) => this.call("mic_name", i));
  }

  describe() {
    const names = this.outputNames;
    this.strikers = this.strikersOf(ALONE);
    this.mics = Array.from({ length: this.channelCount }, (_, i) => names[this.call("instrument_channel", i)]);
  }

  pitch(head = "batter") {
    return this.pitchOf(ALONE, head);
  }

  strike(stroke = {}) {
    needObject("a stroke", stroke);
    this.strikeDrum(ALONE, (key) => this.get(`strike.${key}`), stroke);
  }

  change(key, value, frame) {
    const mic = Math.max(0, this.outputNames.indexOf(key.split(".")[1]));
    this.changeDrum(ALONE, key, key, value, mic, frame);
  }
}
