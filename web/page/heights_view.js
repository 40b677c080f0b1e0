// SPDX-License-Identifier: MIT
// How high the middle of a head stands in the film of a stroke, and above it the middle of its middle wire: curves over the
// time, as in figure 4 of the paper that Tabor grows from.
import { fitCanvas } from "./canvas_size.js";

const MARGIN = 0.1; // of the height, above and below
const LETTERS = 11; // height [px]
const STEPS = [1, 2, 5]; // of marks on the time's axis, times a power of ten

export class HeightsView {
  #canvas;
  #curves = []; // { values [m], color }
  #seconds = 0; // of the film
  #at = 0; // part of it that has been shown

  constructor(canvas) {
    this.#canvas = canvas;
    new ResizeObserver(() => this.#draw()).observe(canvas);
  }

  /** The curves of a film: of the head that the wires lie on, or the first. */
  show(pictures, { heads, circles, angles, wires, points, wiresHead, size }, seconds) {
    const places = [{ index: (wires > 0 ? wiresHead : 0) * circles * angles, color: "--mesh" }];
    const middle = heads * circles * angles + (Math.floor(wires / 2) + 0.5) * points;
    if (wires > 0) places.push({ index: Math.floor(middle), color: "--touch" });
    const count = pictures.length / size;
    this.#curves = places.map(({ index, color }) => ({ color, values: Array.from({ length: count }, (_, i) => pictures[i * size + index]) }));
    this.#seconds = seconds;
    this.setTime(0);
  }

  clear() {
    this.#curves = [];
    this.#draw();
  }

  /** What the film shows [s]. */
  setTime(seconds) {
    this.#at = seconds / this.#seconds;
    this.#draw();
  }

  #draw() {
    const canvas = this.#canvas;
    const ratio = devicePixelRatio;
    const { width, height } = fitCanvas(canvas);
    if (!width || !height || this.#curves.length === 0) return;
    const context = canvas.getContext("2d");
    const style = getComputedStyle(canvas);
    const color = (name) => style.getPropertyValue(name);
    const all = this.#curves.flatMap(({ values }) => values);
    const [least, most] = [Math.min(0, ...all), Math.max(0, ...all)];
    const y = (value) => height * (1 - MARGIN - (1 - 2 * MARGIN) * ((value - least) / (most - least || 1)));
    context.font = `${LETTERS * ratio}px system-ui, sans-serif`;
    context.fillStyle = color("--quiet");
    context.fillText(`${(1000 * most).toFixed(1)} mm`, 4 * ratio, LETTERS * ratio);
    for (const { at, text } of this.#marks()) context.fillText(text, at * width + 4, height - 3);
    context.fillStyle = color("--line");
    context.fillRect(0, y(0), width, ratio);
    for (const { at } of this.#marks()) context.fillRect(at * width, 0, ratio, height);
    context.lineWidth = 1.5 * ratio;
    for (const { values, color: name } of this.#curves) {
      context.strokeStyle = color(name);
      context.beginPath();
      values.forEach((value, i) => context.lineTo((i * width) / (values.length - 1), y(value)));
      context.stroke();
    }
    context.fillStyle = color("--accent");
    context.fillRect(this.#at * width, 0, ratio, height);
  }

  /** About five, in round milliseconds. */
  #marks() {
    const milliseconds = 1000 * this.#seconds;
    const power = 10 ** Math.floor(Math.log10(milliseconds / 5));
    const step = power * STEPS.find((step) => step * power >= milliseconds / 7);
    const marks = [];
    for (let time = step; time < milliseconds; time += step) marks.push({ at: time / milliseconds, text: `${time} ms` });
    return marks;
  }
}
