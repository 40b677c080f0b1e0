// SPDX-License-Identifier: MIT
// The wave form of what sounds: the newest tenth of a second or so, from where it rises through zero.
import { fitCanvas } from "./canvas_size.js";

const peakOf = (samples) => samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);

export class WaveView {
  #canvas;
  #samples = null; // what is shown
  #now = null;

  constructor(canvas) {
    this.#canvas = canvas;
  }

  /** Draws what an AnalyserNode hears; its largest sample reaches the edge. If `isHeld`, the loudest that it has heard since the last
   * time that it was not. */
  show(analyser, isHeld) {
    this.#now ??= new Float32Array(analyser.fftSize);
    this.#samples ??= new Float32Array(analyser.fftSize);
    analyser.getFloatTimeDomainData(this.#now);
    if (!isHeld || peakOf(this.#now) > peakOf(this.#samples)) [this.#now, this.#samples] = [this.#samples, this.#now];
    const canvas = this.#canvas;
    fitCanvas(canvas);
    const context = canvas.getContext("2d");
    const style = getComputedStyle(canvas);
    const middle = canvas.height / 2;
    context.fillStyle = style.getPropertyValue("--line");
    context.fillRect(0, middle, canvas.width, 1);
    context.strokeStyle = style.getPropertyValue("--accent");
    context.beginPath();
    const most = peakOf(this.#samples) || 1;
    const from = this.#start();
    const count = this.#samples.length / 2;
    for (let i = 0; i < count; i++) {
      context.lineTo((i * canvas.width) / count, middle * (1 - this.#samples[from + i] / most));
    }
    context.stroke();
  }

  /** Where it rises through zero in the first half; else its beginning. */
  #start() {
    const half = this.#samples.length / 2;
    for (let i = 1; i < half; i++) {
      if (this.#samples[i - 1] < 0 && this.#samples[i] >= 0) return i;
    }
    return 0;
  }
}
