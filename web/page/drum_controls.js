// SPDX-License-Identifier: MIT
// Pitch, muffling and stick, which change the drum's definition. What is chosen is kept as keys and values of
// `tabor render --set`, among others in the address: entries whose name has a dot.
import { nearestNote, noteText } from "./note.js";

const HEADS = ["batter", "resonant"]; // in the engine's order
const MOST_SEMITONES = 12; // up or down
const TENSIONS = [100, 20000]; // that a head may have [N/m]
const MOST_MUFFLING = 30; // [N s/m]
const MUFFLING_PLACE = 0.7; // of a damper where the preset has none, as a share of the radius

/** Tension grows with the square of the pitch, but for what the air does. */
const semitonesTo = (tension, other) => 6 * Math.log2(other / tension);
const toTenths = (value, round) => round(10 * value) / 10;

/** Light muffling takes most of the way. */
const strengthAt = (position) => Number((MOST_MUFFLING * (position / 100) ** 2).toPrecision(3)); // [N s/m]
const positionOf = (strength) => Math.round(100 * Math.sqrt(strength / MOST_MUFFLING));

function pitchText(frequency) {
  const { name, cents } = nearestNote(frequency);
  const off = cents === 0 ? "" : ` ${cents > 0 ? "+" : "−"}${Math.abs(cents)} cents`;
  return `${name}${off}, ${frequency.toFixed(0)} Hz`;
}

export class DrumControls {
  #fields;
  #settings;
  #preset = null; // what the drum has without settings
  #prefix = ""; // of its keys: of a kit's drum "drum.NAME."
  #kept = []; // settings of what was built last
  #radius = 0; // [m]

  /** `settings` is a URLSearchParams; `change` is called when one of them was moved. */
  constructor(fields, settings, change) {
    this.#fields = fields;
    this.#settings = settings;
    for (const head of [0, 1]) {
      this.#listen(this.#pitch(head), () => this.#showPitch(head), () => this.#setPitch(head), change);
      this.#listen(this.#muffling(head), () => this.#showMuffling(head), () => this.#setMuffling(head), change);
    }
    this.#listen(this.#stick, () => {}, () => this.#put("strike.striker", this.#stick.value, this.#preset.striker), change);
    this.#element("as-preset").addEventListener("click", () => {
      for (const [key] of this.settings) if (key.startsWith(this.#prefix)) this.#settings.delete(key);
      this.#place(this.#preset);
      change();
    });
  }

  /** Keys and values, as [["batter.pitch", "A3"]]. */
  get settings() {
    return [...this.#settings].filter(([key]) => key.includes("."));
  }

  /** Forgets all settings. False if there were none. */
  clear() {
    const keys = this.settings.map(([key]) => key);
    for (const key of keys) this.#settings.delete(key);
    return keys.length > 0;
  }

  /** What was built has other values than were chosen, within what is possible: the controls show them. */
  limit(settings, now) {
    for (const [key, value] of settings) this.#settings.set(key, value);
    this.#place(now);
  }

  /** What was chosen has been built. */
  keep() {
    this.#kept = this.settings;
  }

  /** What was chosen is not built: back to the drum that was built last. */
  revert(drum) {
    this.clear();
    for (const [key, value] of this.#kept) this.#settings.set(key, value);
    if (this.#preset) this.#place(drum.now);
    else this.show(drum); // another one was on its way
  }

  /** Another drum is on its way: there is nothing to move until show(). */
  wait() {
    this.#preset = null;
    this.#fields.disabled = true;
  }

  /** A drum that was built, of a kit with its name. Controls that wait for none are where somebody has put them, and stay
   * there. */
  show({ preset, now, radius, name }) {
    const prefix = name ? `drum.${name}.` : "";
    if (this.#preset && prefix === this.#prefix) return;
    this.#prefix = prefix;
    this.#element("tuned").textContent = name ? `Tuning: ${name}` : "Tuning";
    this.#preset = preset;
    this.#radius = radius;
    this.#fields.disabled = false;
    for (const head of [0, 1]) {
      const slider = this.#pitch(head);
      const has = preset.pitch[head] > 0;
      this.#hide(slider, !has);
      this.#hide(this.#muffling(head), !has);
      const [least, most] = TENSIONS.map((tension) => semitonesTo(preset.tension[head] || 1, tension));
      slider.min = toTenths(Math.max(-MOST_SEMITONES, least), Math.ceil);
      slider.max = toTenths(Math.min(MOST_SEMITONES, most), Math.floor);
    }
    this.#stick.replaceChildren(...preset.strikers.map((name) => new Option(name)));
    this.#hide(this.#stick, preset.strikers.length < 2);
    this.#place(now);
  }

  /** Another drum of the kit that was built, unless another kit is on its way. */
  select(drum) {
    if (this.#preset) this.show(drum);
  }

  /** Remembers a value, unless it is the preset's own. */
  #put(key, value, own) {
    if (value === own) this.#settings.delete(this.#prefix + key);
    else this.#settings.set(this.#prefix + key, value);
  }

  /** Puts all controls where a drum has them. */
  #place(values) {
    for (const head of [0, 1]) {
      const pitch = values.pitch[head];
      this.#pitch(head).value = pitch > 0 ? 12 * Math.log2(pitch / this.#preset.pitch[head]) : 0;
      this.#muffling(head).value = positionOf(values.muffling[head]);
      this.#showPitch(head, pitch); // a link may have one between the slider's places
      this.#showMuffling(head);
    }
    this.#stick.value = values.striker;
  }

  #pitchAt(head) {
    return this.#preset.pitch[head] * 2 ** (this.#pitch(head).value / 12); // [Hz]
  }

  #setPitch(head) {
    const isOwn = Number(this.#pitch(head).value) === 0;
    this.#put(`${HEADS[head]}.pitch`, isOwn ? null : noteText(this.#pitchAt(head)), null);
  }

  #showPitch(head, pitch = this.#pitchAt(head)) {
    if (pitch > 0) this.#tell(this.#pitch(head), pitchText(pitch));
  }

  /** A damper needs a place: one in the centre would leave most modes alone. */
  #setMuffling(head) {
    const own = this.#preset.muffling[head];
    const position = Number(this.#muffling(head).value);
    const isOwn = position === positionOf(own);
    this.#put(`${HEADS[head]}.muffle_strength`, isOwn ? null : String(strengthAt(position)), null);
    const place = isOwn || own > 0 ? null : (MUFFLING_PLACE * this.#radius).toFixed(3);
    this.#put(`${HEADS[head]}.muffle_radius`, place, null);
  }

  #showMuffling(head) {
    const { value } = this.#muffling(head);
    this.#tell(this.#muffling(head), value === "0" ? "none" : `${value} %`);
  }

  /* ---- elements ---- */

  #element(id) {
    return this.#fields.querySelector(`#${id}`);
  }

  #pitch(head) {
    return this.#element(`${HEADS[head]}-pitch`);
  }

  #muffling(head) {
    return this.#element(`${HEADS[head]}-muffling`);
  }

  get #stick() {
    return this.#element("stick");
  }

  #hide(control, isHidden) {
    control.closest(".field").hidden = isHidden;
  }

  #tell(slider, text) {
    slider.closest(".field").querySelector("output").value = text;
    slider.setAttribute("aria-valuetext", text);
  }

  /** A drum is built once a control is let go. */
  #listen(control, show, set, change) {
    control.addEventListener("input", show);
    control.addEventListener("change", () => {
      set();
      change();
    });
  }
}
