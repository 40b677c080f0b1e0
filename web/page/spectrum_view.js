// SPDX-License-Identifier: MIT
// The spectrum of what sounds, over a logarithmic frequency.
import { fitCanvas } from "./canvas_size.js";

const LOWEST = 50; // [Hz]
const HIGHEST = 20000; // [Hz]
const FLOOR = -130; // [dB]
const CEILING = -10; // [dB]
const MARKS = [[100, "100 Hz"], [1000, "1 kHz"], [10000, "10 kHz"]];
const LETTERS = 11; // height [px]

export class SpectrumView {
  #canvas;
  #decibels = null; // what is shown
  #now = null;

  constructor(canvas) {
    this.#canvas = canvas;
  }

  /** Draws what an AnalyserNode hears; if `isHeld`, the greatest that it has heard since the last time that it was not. */
  show(analyser, isHeld) {
    this.#now ??= new Float32Array(analyser.frequencyBinCount);
    this.#decibels ??= new Float32Array(analyser.frequencyBinCount).fill(-Infinity);
    analyser.getFloatFrequencyData(this.#now);
    this.#now.forEach((now, i) => { this.#decibels[i] = isHeld ? Math.max(now, this.#decibels[i]) : now; });
    const canvas = this.#canvas;
    fitCanvas(canvas);
    const context = canvas.getContext("2d");
    const style = getComputedStyle(canvas);
    this.#drawMarks(context, style);
    context.strokeStyle = style.getPropertyValue("--accent");
    this.#drawCurve(context, analyser.context.sampleRate / analyser.fftSize);
  }

  #x(frequency) {
    return (this.#canvas.width * Math.log(frequency / LOWEST)) / Math.log(HIGHEST / LOWEST);
  }

  #y(decibels) {
    const share = (decibels - FLOOR) / (CEILING - FLOOR);
    return this.#canvas.height * (1 - Math.min(Math.max(share, 0), 1));
  }

  #drawMarks(context, style) {
    const height = LETTERS * devicePixelRatio;
    context.font = `${height}px system-ui, sans-serif`;
    for (const [frequency, text] of MARKS) {
      context.fillStyle = style.getPropertyValue("--line");
      context.fillRect(this.#x(frequency), 0, 1, this.#canvas.height);
      context.fillStyle = style.getPropertyValue("--quiet");
      context.fillText(text, this.#x(frequency) + height / 3, height);
    }
  }

  #drawCurve(context, step) {
    context.lineWidth = 1.5 * devicePixelRatio;
    context.beginPath();
    for (let i = Math.ceil(LOWEST / step); i * step < HIGHEST; i++) {
      context.lineTo(this.#x(i * step), this.#y(this.#decibels[i]));
    }
    context.stroke();
  }
}
