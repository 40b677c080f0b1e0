// SPDX-License-Identifier: MIT
/// <reference lib="dom" />
/** Units are SI: seconds, metres, metres per second; angles are in degrees, counter-clockwise seen from above. */

/** A drum or a kit that comes with the package. */
export interface Preset {
  /** for `create()` and `render()` */
  name: string;
  /** one line for a person */
  comment: string;
}

/** Accuracy against cost. A model takes a quarter of a second at "live", two seconds at "studio". */
export type Quality = "draft" | "live" | "studio" | "reference";

export type Technique = "normal" | "rimshot" | "cross-stick" | "rim";

export interface Options {
  /** "live" unless given here or, for a drum, as "quality.level" in `set` */
  quality?: Quality;
  /** 22,050 to 192,000 Hz, 48,000 unless given */
  sampleRate?: number;
  /**
   * Keys of preset files and their values, as `{ "batter.pitch": "A3", "wires.tension": 8 }`; of kit files for a kit, as
   * `{ "kit.overheads": -6, "drum.snare.batter.pitch": "A3" }`.
   */
  set?: Record<string, string | number>;
  /** Hears how far the models are, 0 to 1. If it returns false, the build ends with a TaborError. */
  progress?: (done: number) => unknown;
  /**
   * What building a model may take by the engine's estimate, on one core of a server of 2024: 30 s unless given; 0 is no limit.
   * A model that takes more is refused with a TaborError whose key is the parameter to lower.
   */
  mostSeconds?: number;
  /** most memory in the same way, 2e9 bytes unless given */
  mostBytes?: number;
}

export interface DrumOptions extends Options {
  /**
   * Microphones, a channel each, in the drum's own room, as `tabor render --mic` has them. Without them there are two
   * channels, left and right, 12 dB louder, in the drum's room or a studio, as with `--stereo`.
   */
  mics?: readonly string[];
}

export interface KitOptions extends Options {
  /** Drums whose parts of the mix, without the room, are further channels, two for each, as `tabor render --kit --split` has them. */
  outputs?: readonly string[];
}

/** What is missing is as in the drum's own stroke. */
export interface Stroke {
  /** 0.01 to 30 m/s */
  velocity?: number;
  /** distance from the centre, 0 to the shell's radius [m] */
  radius?: number;
  /** -360 to 360 degrees */
  angle?: number;
  technique?: Technique;
  /** one of `drum.strikers`, as "mallet" */
  striker?: string;
}

export interface KitStroke extends Stroke {
  /** one of `kit.drums` */
  drum: string;
}

/** The energy account [J], since the drum was created or reset. */
export interface Ledger {
  injected: number;
  control: number;
  stored: number;
  head_loss: number;
  wire_loss: number;
  contact_loss: number;
  damper_loss: number;
  shell_loss: number;
  radiated: number;
  removed: number;
  high_band: number;
  residual: number;
}

/** A value that is refused. Nothing was changed. A number of another type, as `3n` or `"3"`, is a TypeError instead. */
export class TaborError extends RangeError {
  /** the key that is wrong, "" if there is none */
  readonly key: string;
  /** its value */
  readonly value: string;
  /** least allowed value; NaN where no range applies */
  readonly minimum: number;
  /** greatest allowed value; NaN where no range applies */
  readonly maximum: number;
}

/** What a drum and a kit have in common. Each has memory of its own, which goes when nothing refers to it any more. */
export interface Instrument {
  /** [Hz] */
  readonly sampleRate: number;
  /** the first of the next `process()` */
  readonly frame: number;
  /** of the definition, in the order of preset or kit files */
  readonly keys: readonly string[];
  /** the value of a key, as these files have it */
  get(key: string): string;

  /** A MIDI message, [status, first, second], at a frame, as `tabor render --midi-file` plays it. Program changes do nothing. */
  midi(message: readonly number[] | Uint8Array, frame?: number): void;
  /**
   * The events of a MIDI file, its bytes, from a frame on. Gives the last frame that has one, and lines that say what was passed over.
   * A file that is refused is a TaborError.
   */
  midiFile(file: ArrayBuffer | ArrayBufferView, frame?: number): { last: number; warnings: string[] };
  /** As if it had just been created: at rest, without coming events, at frame 0. */
  reset(): void;

  /** The next frames, an array for each channel; 1 is full scale. The sound does not depend on the division. */
  process(frames: number): Float32Array[];

  /** of all drums together */
  ledger(): Ledger;
  /**
   * Strokes and changes that were not carried out, since it was created or reset: a drum has 8 sticks, and each is free
   * again once its stroke has ended.
   */
  readonly droppedEvents: number;
  /** Everything has died away. */
  readonly isSilent: boolean;
}

/** A drum that sounds, in its room. It has 10 to 30 MB. */
export class Drum {
  private constructor();

  /** Computes a drum. This takes the thread's time: in a page, do it in a worker. */
  static create(preset: string, options?: DrumOptions): Promise<Drum>;

  /** the microphone of each channel */
  readonly mics: readonly string[];
  readonly strikers: readonly string[];
  /** What a tuner reads at a lug [Hz]; 0 if the drum has no such head. */
  pitch(head?: "batter" | "resonant"): number;

  /** A stroke at a frame, the next one unless given. Strokes may be given in any order before they are due. */
  strike(stroke?: Stroke & { frame?: number }): void;
  /** Moves a parameter that may change while the drum rings, as "wires.strainer" or "batter.muffle_strength". */
  change(key: string, value: number, frame?: number): void;
  /** Energy of what the room holds, of no unit. */
  readonly roomEnergy: number;
}
export interface Drum extends Instrument {}

/** A kit: drums that stand in one room and hear each other. It has 20 to 80 MB. */
export class Kit {
  private constructor();

  /** Computes a kit. This takes the thread's time, some seconds: in a page, do it in a worker. */
  static create(kit: string, options?: KitOptions): Promise<Kit>;

  /** names, in the kit's order */
  readonly drums: readonly string[];
  /** "left", "right" of the mix, then those of `outputs`, as "snare left" */
  readonly channels: readonly string[];
  strikers(drum: string): string[];
  /** What a tuner reads at a lug of a drum [Hz]; 0 if it has no such head. */
  pitch(drum: string, head?: "batter" | "resonant"): number;

  /** A stroke on a drum at a frame, the next one unless given. */
  strike(stroke: KitStroke & { frame?: number }): void;
  /** Moves what may change while the kit rings: "kit.overheads" and "kit.coupling" [dB], or "drum.snare.wires.strainer". */
  change(key: string, value: number | "off", frame?: number): void;
}
export interface Kit extends Instrument {}

/** What `render()` and `renderKit()` add to the options of an instrument. */
export interface RenderOptions {
  /** [s]; without it the sound ends when it has died away */
  duration?: number;
  /** Hears lines that say what of a MIDI file was passed over, as notes that play no drum; `console.warn` unless given. */
  warn?: (line: string) => unknown;
}

/**
 * Strokes on a fresh drum, or the bytes of a MIDI file; the drum's own stroke unless given. An array for each channel.
 */
export function render(
  preset: string,
  events?: readonly (Stroke & { time?: number })[] | ArrayBuffer | ArrayBufferView,
  options?: DrumOptions & RenderOptions,
): Promise<Float32Array[]>;

/** The same on a kit. */
export function renderKit(
  kit: string,
  events: readonly (KitStroke & { time?: number })[] | ArrayBuffer | ArrayBufferView,
  options?: KitOptions & RenderOptions,
): Promise<Float32Array[]>;

/**
 * A node of Web Audio that plays a drum or a kit, with a channel for each of its own; connect it as any other. The context has the
 * instrument's sample rate. From then on strokes, changes and MIDI act in the node, at once unless a frame is given, which counts from the
 * first one that the node has played; its sound and its account are the node's. Bundlers have to keep worklet.js, engine.js and events.js
 * as files beside each other.
 */
export function createNode(context: BaseAudioContext, instrument: Drum | Kit): Promise<AudioWorkletNode>;

/** The kits that come with the package. */
export function kits(): Promise<Preset[]>;

/** The drums that come with the package. */
export function presets(): Promise<Preset[]>;

/** Of the engine. */
export function version(): Promise<string>;

/**
 * Loads the engine from another place than beside the package's files, or from its bytes. Call it before everything
 * else, and only if your bundler moves files without saying so.
 */
export function load(source?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module): Promise<void>;
