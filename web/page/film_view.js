// SPDX-License-Identifier: MIT
// Heads, wires and sticks in the first 40 ms after a stroke, or 120 ms on a drum with one wire, in slow motion: as a net of circles and rays seen from the
// side, a little from above. A picture consists of the numbers that web_picture_size() of picture_glue.c lists.
import { RATE } from "./sound.js";

const PICTURE_FRAMES = 32; // from picture to picture
const TILT = 0.22; // height of what is as far behind the middle as the picture's unit
const RADIUS = 0.44; // of the heads, as a share of the width
const PLACES = [0.29, 0.72]; // of the heads' planes, as a share of the picture's height
const RISE = 0.12; // of the highest place above its plane, as a share of the width
const MOST_ENLARGED = 2000; // times
const MOST_RISE = 0.5; // what is higher is drawn there; sticks are not drawn
const RAY = 6; // angles from ray to ray
const TURN = 2 * Math.PI;
const radians = (degrees) => (degrees * Math.PI) / 180;

export class FilmView {
  #canvas;
  #text;
  #setHeights; // of the batter head, which is seen from above
  #curves; // of its heights
  #isHeld = false;
  #drums = []; // facts of each
  #facts = null; // of the drum that is shown
  #pictures = null; // Float32Array
  #isAwaited = false; // a stroke is being filmed
  #most = 1e-3; // height in the film [m]
  #slowness = 100;
  #time = 0; // of the film [s]
  #before = 0; // when the last picture was drawn [ms]
  #asked = false;

  constructor(canvas, text, curves, setHeights) {
    this.#canvas = canvas;
    this.#curves = curves;
    this.#text = text;
    this.#setHeights = setHeights;
    new ResizeObserver(() => this.#ask()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#ask());
  }

  /** The drums of another kit, or another drum alone; the first is seen until one is filmed. */
  show(drums) {
    this.#drums = drums;
    this.#facts = drums[0];
    this.#isAwaited = false;
    this.#end();
  }

  setOn(on) {
    this.#canvas.parentElement.hidden = !on;
    this.#isAwaited = false;
    this.#end();
  }

  /** A stroke is being filmed. False if it is part of a film that has begun. */
  expect() {
    const begins = !this.#isAwaited;
    this.#isAwaited = true;
    return begins;
  }

  /** A film is being shown or made. */
  get isOn() {
    return this.#isAwaited || this.#pictures !== null;
  }

  /** From now on. */
  setSlowness(times) {
    this.#slowness = times;
  }

  /** Its time stands still. */
  setHeld(held) {
    this.#isHeld = held;
    this.#before = performance.now();
  }

  play({ drum, pictures }) {
    this.#isAwaited = false;
    const facts = this.#drums[drum];
    if (!facts || pictures.length % facts.picture.size) return; // of the drum before
    this.#facts = facts;
    this.#pictures = pictures;
    this.#most = this.#highest();
    this.#time = 0;
    this.#curves.show(pictures, facts.picture, this.#seconds);
    this.#before = performance.now();
    this.#ask();
  }

  #end() {
    this.#pictures = null;
    this.#setHeights(null);
    this.#text.textContent = "Slow motion of the next stroke";
    this.#ask();
  }

  #ask() {
    if (this.#asked || !this.#facts) return;
    this.#asked = true;
    requestAnimationFrame((now) => this.#step(now));
  }

  #step(now) {
    this.#asked = false;
    if (!this.#pictures) return this.#draw(new Float32Array(this.#facts.picture.size));
    if (!this.#isHeld) this.#time += Math.max(now - this.#before, 0) / 1000 / this.#slowness;
    this.#before = now;
    const { circles, angles, size } = this.#facts.picture;
    const at = (this.#time * RATE) / PICTURE_FRAMES;
    if (at >= this.#pictures.length / size - 1) return this.#end();
    const picture = this.#between(at);
    this.#draw(picture);
    this.#setHeights({ drum: this.#drums.indexOf(this.#facts), circles, angles, of: picture, most: this.#most });
    this.#curves.setTime(this.#time);
    this.#tell();
    this.#ask();
  }

  get #seconds() {
    return ((this.#pictures.length / this.#facts.picture.size - 1) * PICTURE_FRAMES) / RATE;
  }

  #tell() {
    const hasWires = this.#facts.picture.wires > 0;
    const touch = hasWires ? "; orange wires touch the head" : "";
    const curves = hasWires ? "its head and, orange, of its middle wire" : "the head";
    this.#text.textContent = `${(1000 * this.#time).toFixed(1)} ms after the stroke; heights ${Math.round(this.#enlarged)} times enlarged${touch}.`
      + ` The curves are the heights of the middle of ${curves}.`;
  }

  /** The picture at a place between two; sticks are those of the earlier one. */
  #between(at) {
    const { size, sticks, values } = this.#facts.picture;
    const start = Math.floor(at) * size;
    const picture = this.#pictures.slice(start, start + size);
    const part = at - Math.floor(at);
    for (let i = 0; i < size - 1 - sticks * values; i++) picture[i] += part * (this.#pictures[start + size + i] - picture[i]);
    return picture;
  }

  /** Of the heads in the film [m]. */
  #highest() {
    const { heads, circles, angles, size } = this.#facts.picture;
    let most = 0;
    for (let start = 0; start < this.#pictures.length; start += size) {
      for (let i = 0; i < heads * circles * angles; i++) most = Math.max(most, Math.abs(this.#pictures[start + i]));
    }
    return most || 1;
  }

  get #enlarged() {
    return Math.min(((RISE / RADIUS) * this.#facts.radius) / this.#most, MOST_ENLARGED);
  }

  /* ---- the picture: the heads have the radius 1 ---- */

  #draw(picture) {
    const canvas = this.#canvas;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((size) => Math.round(size * devicePixelRatio));
    if (!width || !height) return;
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext("2d");
    const unit = RADIUS * width;
    const style = getComputedStyle(canvas);
    const color = (name) => style.getPropertyValue(`--${name}`);
    const { heads, wires, wiresHead } = this.#facts.picture;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    for (let head = heads - 1; head >= 0; head--) {
      context.setTransform(unit, 0, 0, unit, width / 2, height * (heads === 1 ? 0.5 : PLACES[head]));
      if (wires > 0 && wiresHead === head) this.#drawWires(context, color, picture);
      this.#drawNet(context, color, picture, head);
    }
    this.#drawSticks(context, color, picture);
  }

  /** Places in the picture from places on the drum; heights in metres. */
  #put(x, y, height) {
    const scale = this.#enlarged / this.#facts.radius;
    const rise = Math.max(Math.min(height * scale, MOST_RISE), -MOST_RISE);
    return [x, -TILT * y - rise];
  }

  #drawNet(context, color, picture, head) {
    const { circles, angles } = this.#facts.picture;
    const start = head * circles * angles;
    const point = (i, j) => {
      const [r, angle] = [i / (circles - 1), (j * TURN) / angles];
      return this.#put(r * Math.cos(angle), r * Math.sin(angle), picture[start + i * angles + (j % angles)]);
    };
    const line = (points) => {
      context.beginPath();
      for (const [x, y] of points) context.lineTo(x, y);
      context.stroke();
    };
    context.strokeStyle = color("mesh");
    context.lineWidth = 0.003;
    for (let i = 1; i < circles - 1; i++) line(Array.from({ length: angles + 1 }, (_, j) => point(i, j)));
    for (let j = 0; j < angles; j += RAY) line(Array.from({ length: circles }, (_, i) => point(i, j)));
    context.strokeStyle = color("hoop");
    context.lineWidth = 0.02;
    line(Array.from({ length: angles + 1 }, (_, j) => point(circles - 1, j)));
  }

  /** In another colour where they touch the head. */
  #drawWires(context, color, picture) {
    const { heads, circles, angles, wires, points, places } = this.#facts.picture;
    const { radius } = this.#facts;
    const heights = heads * circles * angles;
    const forces = heights + wires * points;
    context.lineWidth = 0.006;
    for (let w = 0; w < wires; w++) {
      const [x0, y0, x1, y1] = places.slice(4 * w, 4 * w + 4).map((place) => place / radius);
      const point = (p) => {
        const part = p / (points - 1);
        return this.#put(x0 + part * (x1 - x0), y0 + part * (y1 - y0), picture[heights + w * points + p]);
      };
      for (let p = 1; p < points; p++) {
        const touches = picture[forces + w * points + p] > 0 || picture[forces + w * points + p - 1] > 0;
        context.strokeStyle = color(touches ? "touch" : "wire");
        context.beginPath();
        context.moveTo(...point(p - 1));
        context.lineTo(...point(p));
        context.stroke();
      }
    }
  }

  /** Of the batter head at the place of the grid that is nearest, r as a share of the radius [m]. */
  #headNear(picture, r, angle) {
    const { circles, angles } = this.#facts.picture;
    const [i, j] = [Math.round(r * (circles - 1)), Math.round((angle / 360) * angles)];
    return picture[Math.min(i, circles - 1) * angles + (((j % angles) + angles) % angles)];
  }

  /** A finger yields as it touches, and is drawn on the head. */
  #drawSticks(context, color, picture) {
    const { size, sticks, values } = this.#facts.picture;
    const start = size - 1 - sticks * values;
    context.fillStyle = color("mark");
    for (let i = 0; i < picture[start]; i++) {
      const [radius, angle, tip] = picture.subarray(start + 1 + i * values);
      const r = radius / this.#facts.radius;
      const height = Math.max(tip, this.#headNear(picture, r, angle));
      if (height * this.#enlarged > MOST_RISE * this.#facts.radius) continue;
      context.beginPath();
      context.arc(...this.#put(r * Math.cos(radians(angle)), r * Math.sin(radians(angle)), height), 0.025, 0, TURN);
      context.fill();
    }
  }
}
