// SPDX-License-Identifier: MIT
// The drum that sounds: a worker builds it, the audio thread plays it.

export const RATE = 48000; // [Hz]; the browser converts to the device's
export const CHANNELS = 2;
const SPECTRUM_FRAMES = 4096;
const FADE = 0.01; // of a tone [s]
export const QUALITIES = ["", "draft", "live", "studio"]; // by the engine's numbers

export class Sound extends EventTarget {
  #bytes;
  #worker = null;
  #built = null; // a drum that the audio thread does not have yet
  #context = null;
  #connecting = null; // a promise, until it fails
  #node = null;
  #analyser = null;
  #waiting = null; // the stroke that came before the audio thread
  #song = null; // likewise
  #strainer = null; // where the snares were put before
  #films = false;
  #tone = null; // a sine beside the drum

  constructor(bytes) {
    super();
    this.#bytes = bytes;
  }

  /** Builds a drum beside the one that sounds. Events: "progress", then "built" or "failed". Of the sound itself: "started", or
   * "silent" with a reason. */
  build(preset, settings, quality) {
    this.cancel();
    this.#worker = new Worker(new URL("build_worker.js", import.meta.url), { type: "module" });
    this.#worker.onmessage = ({ data }) => this.#hear(data);
    const number = QUALITIES.indexOf(quality);
    this.#worker.postMessage({ bytes: this.#bytes, preset, settings, quality: number, rate: RATE });
  }

  /** Ends what is being built. */
  cancel() {
    this.#worker?.terminate();
    this.#worker = null;
  }

  /** Plays the drum that was built last. */
  play() {
    if (this.#built) this.#strainer = null;
    this.#sendDrum();
  }

  #sendDrum() {
    if (!this.#node || !this.#built) return;
    const { instrument, memory } = this.#built;
    this.#built = null;
    this.#send({ type: "instrument", instrument, memory }, [memory]);
  }

  /** Call in a gesture: browsers refuse sound before one. A sound that could not be connected is tried anew. */
  start() {
    if (!isSecureContext) {
      return this.#tell("silent", "browsers play it only from an address that begins with https:// or http://localhost");
    }
    if (!globalThis.AudioWorkletNode) return this.#tell("silent", "this browser has no AudioWorklet");
    this.#connecting ??= this.#connect().catch((error) => {
      this.#connecting = null;
      this.#context?.close(); // it would not load a module that has failed again
      this.#context = null;
      this.#tell("silent", error.message);
    });
    this.resume();
  }

  /** Goes on after a phone call, another tab or whatever else has stopped the sound: "suspended", on iOS "interrupted". */
  resume() {
    if (!this.#context || this.#context.state === "running") return;
    this.#context.resume().catch(() => {}); // refused before a gesture: the next one tries again
  }

  strike(stroke) {
    if (this.#node) this.#send({ type: "strike", ...stroke });
    else this.#waiting = stroke;
  }

  setStrainer(value) {
    if (this.#node) this.#send({ type: "strainer", value });
    else this.#strainer = value;
  }

  /** Plays what a MIDI file does, instead of what another one does; none ends it. Event: "sung" at its end. */
  playSong(actions) {
    if (this.#node) this.#send({ type: "song", actions });
    else this.#song = actions;
  }

  /** Whether strokes are filmed: "filmed" then tells the pictures. */
  film(on) {
    this.#films = on;
    if (this.#node) this.#send({ type: "film", on });
  }

  /** What hears the sound: an AnalyserNode, or null before the first gesture. */
  get analyser() {
    return this.#analyser;
  }

  /** Gaps in the sound so far; undefined where the browser does not count them. */
  get gaps() {
    return this.#context?.playbackStats?.underrunEvents;
  }

  /** A sine beside the drum [Hz], which falls by 60 dB in `time` [s]; infinite: it stays. Instead of the one before. */
  playTone(frequency, amplitude, time) {
    this.start();
    this.endTone();
    if (!this.#context) return;
    const now = this.#context.currentTime, end = now + (time < Infinity ? time : 0);
    const gain = new GainNode(this.#context, { gain: amplitude });
    const source = new OscillatorNode(this.#context, { frequency });
    if (end > now) gain.gain.setValueAtTime(amplitude, now).exponentialRampToValueAtTime(amplitude / 1000, end);
    source.connect(gain).connect(this.#context.destination);
    source.start();
    if (end > now) source.stop(end);
    this.#tone = { source, gain };
  }

  /** Fades it out, so that it does not click. */
  endTone() {
    if (!this.#tone) return;
    const { source, gain } = this.#tone;
    const now = this.#context.currentTime;
    this.#tone = null;
    gain.gain.cancelScheduledValues(now).setTargetAtTime(0, now, FADE);
    source.stop(now + 8 * FADE);
  }

  record(on) {
    this.#send({ type: "record", on });
  }

  async #connect() {
    this.#context = new AudioContext({ sampleRate: RATE, latencyHint: "interactive" });
    await this.#context.audioWorklet.addModule(new URL("drum_worklet.js", import.meta.url));
    this.#node = new AudioWorkletNode(this.#context, "tabor-drum", {
      numberOfInputs: 0,
      outputChannelCount: [CHANNELS],
    });
    this.#node.port.onmessage = ({ data }) => this.#tell(data.type, data);
    this.#node.onprocessorerror = () => this.#tell("silent", "the audio thread has stopped");
    this.#node.connect(this.#context.destination);
    this.#analyser = new AnalyserNode(this.#context, { fftSize: SPECTRUM_FRAMES, smoothingTimeConstant: 0.5 });
    this.#node.connect(this.#analyser);
    this.#send({ type: "engine", bytes: this.#bytes });
    this.film(this.#films);
    this.#sendDrum();
    if (this.#strainer !== null) this.setStrainer(this.#strainer);
    if (this.#waiting) this.strike(this.#waiting);
    if (this.#song) this.playSong(this.#song);
    this.#tell("started");
  }

  #hear(data) {
    if ("progress" in data) return this.#tell("progress", data.progress);
    this.cancel(); // it has done its work
    if (data.error) return this.#tell("failed", data.error);
    this.#built = data;
    this.#tell("built", data.facts);
  }

  #send(message, transfer = []) {
    this.#node.port.postMessage(message, transfer);
  }

  #tell(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}
