// SPDX-License-Identifier: MIT
// The lowest modes of a drum, one button each. A mode that is chosen moves alone: its shape stands and swings on the head, slowly,
// and its tone is heard, with the decay that it has on the drum or for as long as it is driven.

const SWING = 0.8; // of a shape that stands there [Hz]
const TONE = 0.2; // amplitude at the beginning, full scale is 1
const PARTS = ["batter head", "resonant head", "both heads", "air between the heads", "hoop and shell", "plate", "lower plate"];
const TURN = 2 * Math.PI;
const plural = (count, one) => `${count} ${one}${count === 1 ? "" : "s"}`;

/** Of the batter head, unless that hardly moves. */
function shapeOf({ shapes, most }) {
  return shapes[0].some((value) => Math.abs(value) > 0.05 * most) ? shapes[0] : shapes.at(-1);
}

/** Circles at rest inside the edge: where the shape changes its sign. */
function nodalCircles(mode) {
  const moving = shapeOf(mode).filter((value) => Math.abs(value) > 0.02 * mode.most);
  return moving.slice(1).filter((value, i) => value * moving[i] < 0).length;
}

function wordsOf(mode) {
  const together = mode.phase > 0 ? ", together" : mode.phase < 0 ? ", against each other" : "";
  return `${mode.frequency.toFixed(1)} Hz: ${plural(mode.m, "nodal diameter")}, ${plural(nodalCircles(mode), "nodal circle")}; ` +
    `${PARTS[mode.part]}${together}; dies away by 60 dB in ${mode.time.toFixed(2)} s`;
}

export class ModesView {
  #list;
  #text;
  #drive;
  #setHeights; // of a head that is seen from above
  #sound;
  #drum = 0;
  #facts = null;
  #mode = null; // that is isolated
  #began = 0; // [ms]
  #asked = false; // a picture is to come

  /** Elements: where the buttons go, what is said of a mode, the button that drives it. */
  constructor(list, text, drive, setHeights, sound) {
    this.#list = list;
    this.#text = text;
    this.#drive = drive;
    this.#setHeights = setHeights;
    this.#sound = sound;
    drive.addEventListener("click", () => this.#setDriven(drive.getAttribute("aria-pressed") !== "true"));
  }

  /** The modes of another drum, which is number `drum` of its kit. */
  show(facts, drum) {
    this.end();
    if (facts === this.#facts) return;
    this.#facts = facts;
    this.#drum = drum;
    this.#list.replaceChildren(...facts.lowModes.map((mode) => this.#buttonOf(mode)));
  }

  /** The drum moves as a whole again. */
  end() {
    this.#choose(null);
  }

  #buttonOf(mode) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = `${mode.frequency.toFixed(0)} Hz`;
    button.title = wordsOf(mode);
    button.setAttribute("aria-pressed", "false");
    button.addEventListener("click", () => this.#choose(this.#mode === mode ? null : mode));
    return button;
  }

  #choose(mode) {
    const moved = this.#mode !== null;
    this.#mode = mode;
    [...this.#list.children].forEach((button, i) =>
      button.setAttribute("aria-pressed", String(this.#facts.lowModes[i] === mode)));
    this.#drive.disabled = mode === null;
    this.#drive.setAttribute("aria-pressed", "false");
    this.#text.textContent = mode ? wordsOf(mode) : "Choose a frequency: that mode moves and sounds alone";
    this.#sound.endTone();
    if (!mode) return moved ? this.#setHeights(null) : undefined;
    this.#sound.playTone(mode.frequency, TONE, mode.time);
    this.#began = performance.now();
    if (!this.#asked) this.#swing();
  }

  #setDriven(on) {
    this.#drive.setAttribute("aria-pressed", String(on));
    this.#sound.endTone();
    if (on) this.#sound.playTone(this.#mode.frequency, TONE, Infinity);
  }

  #swing() {
    this.#asked = this.#mode !== null;
    if (!this.#asked) return;
    const { circles, angles } = this.#facts.picture;
    const axis = (this.#facts.angle * TURN) / 360; // of the cosines
    const { most, m } = this.#mode;
    const swing = Math.cos((TURN * SWING * (performance.now() - this.#began)) / 1000);
    const shape = shapeOf(this.#mode);
    const of = Float32Array.from({ length: circles * angles }, (_, i) =>
      swing * shape[Math.floor(i / angles)] * Math.cos(m * ((TURN * (i % angles)) / angles - axis)));
    this.#setHeights({ drum: this.#drum, circles, angles, of, most });
    requestAnimationFrame(() => this.#swing());
  }
}
