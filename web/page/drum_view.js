// SPDX-License-Identifier: MIT
// Drums from above: heads, hoops, lugs and wires to scale, and where they were struck. Of a kit the higher drums hide the
// lower ones. A bass drum's head is shown as if it lay.

const HEAD_SHARE = 0.86; // the head's radius in the half width of the picture
const MARK_TIME = 900; // how long a stroke stays visible [ms]
const FLOOR = -60; // level that no longer lights the head [dBFS]
const TURN = 2 * Math.PI;
const radians = (degrees) => (degrees * Math.PI) / 180;

const SINGLE = { x: 0, y: 0, size: 1 }; // of what HEAD_SHARE is a share of
const HOOP = 1.12; // what a drum takes, in radii: a pointer out to here strikes its rim

/** Places of a kit's drums: { x, y, size }, which fill the square from -1 to 1. */
function placesOf(drums) {
  const sides = (middleOf) => {
    const from = Math.min(...drums.map((drum) => middleOf(drum) - HOOP * drum.radius));
    const to = Math.max(...drums.map((drum) => middleOf(drum) + HOOP * drum.radius));
    return { middle: (from + to) / 2, half: (to - from) / 2 };
  };
  const across = sides(({ x }) => x);
  const along = sides(({ y }) => y);
  const scale = 1 / Math.max(across.half, along.half) / HEAD_SHARE;
  return drums.map(({ x, y, radius }) => (
    { x: (x - across.middle) * scale, y: (y - along.middle) * scale, size: radius * scale }));
}

export class DrumView {
  #canvas;
  #drums = [{ radius: 0.18, lugs: 10, wires: { count: 0 } }];
  #places = [SINGLE];
  #order = [0]; // from the lowest drum to the highest
  #snaresOff = false;
  #marks = []; // { drum, x, y, velocity, time }, x and y as shares of the radius
  #level = FLOOR;
  #heights = null; // of the head of a drum, { drum, circles, angles, of, most }
  #asked = false; // a picture is to come

  constructor(canvas) {
    this.#canvas = canvas;
    new ResizeObserver(() => this.#ask()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#ask());
  }

  /** Shows the drums of a kit, or the only one. */
  show(drums) {
    this.#drums = drums;
    this.#places = drums.length > 1 ? placesOf(drums) : [SINGLE];
    this.#order = [...drums.keys()].sort((i, j) => drums[i].height - drums[j].height);
    this.#heights = null;
    this.#marks = [];
    this.#ask();
  }

  setSnares(on) {
    this.#snaresOff = !on;
    this.#ask();
  }

  /** Colours the head of a drum by its heights, of[circle * angles + angle], which are at most `most`; null: no more. */
  setHeights(heights) {
    this.#heights = heights;
    this.#ask();
  }

  setLevel(level) {
    if (level <= FLOOR && this.#level <= FLOOR) return;
    this.#level = Math.max(level, FLOOR);
    this.#ask();
  }

  /** Marks a stroke on a drum at a share of its radius and an angle [deg]. */
  mark(drum, share, angle, velocity) {
    const [x, y] = [share * Math.cos(radians(angle)), -share * Math.sin(radians(angle))];
    this.#marks.push({ drum, x, y, velocity, time: performance.now() });
    this.#ask();
  }

  /** The place under a pointer: { drum, share of its radius, angle [deg] }; the angle runs counter-clockwise. null where
   * no drum is. */
  placeAt({ clientX, clientY }) {
    const box = this.#canvas.getBoundingClientRect();
    const half = (HEAD_SHARE * box.width) / 2;
    const x = (clientX - box.left - box.width / 2) / half;
    const y = (box.top + box.height / 2 - clientY) / half;
    for (const drum of this.#order.toReversed()) {
      const at = this.#places[drum];
      const [right, up] = [(x - at.x) / at.size, (y - at.y) / at.size];
      const share = Math.hypot(right, up);
      if (share <= HOOP) return { drum, share, angle: (Math.atan2(up, right) * 180) / Math.PI };
    }
    return null;
  }

  #ask() {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    this.#asked = false;
    const canvas = this.#canvas;
    const size = Math.round(canvas.clientWidth * devicePixelRatio);
    if (canvas.width !== size) canvas.width = canvas.height = size;
    const context = canvas.getContext("2d");
    const half = (HEAD_SHARE * size) / 2;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, size, size);
    const style = getComputedStyle(canvas);
    const color = (name) => style.getPropertyValue(`--${name}`);
    const now = performance.now();
    this.#marks = this.#marks.filter((mark) => now - mark.time < MARK_TIME);
    for (const i of this.#order) {
      const { x, y, size: share } = this.#places[i];
      const radius = half * share;
      context.setTransform(radius, 0, 0, radius, size / 2 + half * x, size / 2 - half * y); // the head has the radius 1
      this.#drawHoop(context, color, this.#drums[i]);
      this.#drawHead(context, color, i);
      this.#drawWires(context, color, this.#drums[i]);
      if (this.#drums.length > 1) this.#drawName(context, color, this.#drums[i].name);
      this.#drawMarks(context, color, i, now);
    }
    if (this.#marks.length > 0) this.#ask();
  }

  #drawHoop(context, color, { lugs }) {
    context.fillStyle = color("lug");
    for (let j = 0; j < lugs; j++) {
      const angle = ((j + 0.5) * TURN) / lugs;
      context.beginPath();
      context.arc(1.08 * Math.cos(angle), -1.08 * Math.sin(angle), 0.035, 0, TURN);
      context.fill();
    }
    context.strokeStyle = color("hoop");
    context.lineWidth = 0.06;
    context.beginPath();
    context.arc(0, 0, 1.03, 0, TURN);
    context.stroke();
  }

  /** A cymbal's middle. */
  #drawBell(context, color) {
    context.strokeStyle = color("hoop");
    context.lineWidth = 0.02;
    context.stroke(new Path2D(`M 0.22 0 A 0.22 0.22 0 1 0 0.22 0.0001`));
  }

  /** Of the drums of a kit, below their middle. */
  #drawName(context, color, name) {
    context.fillStyle = color("text");
    context.font = "0.2px system-ui, sans-serif";
    context.textAlign = "center";
    context.fillText(name, 0, 0.55, 1.7);
  }

  /** The louder it sounds, the brighter. */
  #drawHead(context, color, drum) {
    context.beginPath();
    context.arc(0, 0, 1, 0, TURN);
    context.fillStyle = color(this.#drums[drum].isPlate ? "brass" : "head");
    context.fill();
    if (this.#drums[drum].isPlate) this.#drawBell(context, color);
    if (this.#heights?.drum === drum) return this.#drawHeights(context, color);
    context.globalAlpha = 0.5 * (1 - this.#level / FLOOR);
    context.fillStyle = color("glow");
    context.fill();
    context.globalAlpha = 1;
  }

  /** One colour above the head's plane, one below; half as strong a quarter as high. */
  #drawHeights(context, color) {
    const { circles, angles, of, most } = this.#heights;
    const [up, down] = [color("up"), color("down")];
    const step = TURN / angles;
    for (let i = 0; i < circles; i++) {
      const [inner, outer] = [Math.max(i - 0.5, 0), Math.min(i + 0.5, circles - 1)].map((r) => r / (circles - 1));
      for (let j = 0; j < angles; j++) {
        const height = of[i * angles + j] / most;
        context.globalAlpha = Math.min(Math.sqrt(Math.abs(height)), 1);
        context.fillStyle = height > 0 ? up : down;
        context.beginPath();
        context.arc(0, 0, outer, -(j + 0.5) * step, -(j - 0.5) * step);
        context.arc(0, 0, inner, -(j - 0.5) * step, -(j + 0.5) * step, true);
        context.fill();
      }
    }
    context.globalAlpha = 1;
  }

  #drawWires(context, color, { radius, wires }) {
    context.save();
    context.rotate(-radians(wires.angle ?? 0));
    context.strokeStyle = color("wire");
    context.lineWidth = 0.004;
    context.globalAlpha = this.#snaresOff ? 0.25 : 1;
    for (let i = 0; i < wires.count; i++) {
      const y = ((i - (wires.count - 1) / 2) * wires.spacing) / radius;
      const half = Math.min(wires.length / 2 / radius, Math.sqrt(1 - y * y));
      context.beginPath();
      context.moveTo(-half, y);
      context.lineTo(half, y);
      context.stroke();
    }
    context.restore();
  }

  #drawMarks(context, color, drum, now) {
    context.fillStyle = color("mark");
    for (const { x, y, velocity, time } of this.#marks.filter((mark) => mark.drum === drum)) {
      context.globalAlpha = 1 - (now - time) / MARK_TIME;
      context.beginPath();
      context.arc(x, y, 0.02 + 0.012 * Math.sqrt(velocity), 0, TURN);
      context.fill();
    }
    context.globalAlpha = 1;
  }
}
