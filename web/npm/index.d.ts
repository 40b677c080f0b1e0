// SPDX-License-Identifier: MIT
/** Units are SI: seconds, metres, metres per second; angles are in degrees, counter-clockwise seen from above. */

/** A drum that comes with the package. */
export interface Preset {
  /** for `Drum.create()` and `render()` */
  name: string;
  /** one line for a person */
  comment: string;
}

/** Accuracy against cost. A model takes a quarter of a second at "live", two seconds at "studio". */
export type Quality = "draft" | "live" | "studio" | "reference";

export type Technique = "normal" | "rimshot" | "cross-stick" | "rim";

export interface DrumOptions {
  /** "live" unless given */
  quality?: Quality;
  /** 22,050 to 192,000 Hz, 48,000 unless given */
  sampleRate?: number;
  /** Keys of preset files and their values, as `{ "batter.pitch": "A3", "wires.tension": 8 }`. */
  set?: Record<string, string | number>;
  /**
   * Microphones, a channel each, in the drum's own room, as `tabor render --mic` has them. Without them there are two
   * channels, left and right, 12 dB louder, in the drum's room or a studio, as with `--stereo`.
   */
  mics?: readonly string[];
  /** Hears how far the model is, 0 to 1. If it returns false, the build ends with a TaborError. */
  progress?: (done: number) => unknown;
  /**
   * What building the model may take by the engine's estimate, on one core of a server of 2024: 30 s unless given; 0 is no limit.
   * A model that takes more is refused with a TaborError whose key is the parameter to lower.
   */
  mostSeconds?: number;
  /** most memory in the same way, 2e9 bytes unless given */
  mostBytes?: number;
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

/** A drum that sounds. It has memory of its own, 10 to 30 MB, which goes when nothing refers to it any more. */
export class Drum {
  private constructor();

  /** Computes a drum. This takes the thread's time: in a page, do it in a worker. */
  static create(preset: string, options?: DrumOptions): Promise<Drum>;

  /** [Hz] */
  readonly sampleRate: number;
  /** the microphone of each channel */
  readonly mics: readonly string[];
  readonly strikers: readonly string[];
  /** the first of the next `process()` */
  readonly frame: number;
  /** of the drum's definition, in the order of preset files */
  readonly keys: readonly string[];
  /** the value of a key, as preset files have it */
  get(key: string): string;
  /** What a tuner reads at a lug [Hz]; 0 if the drum has no such head. */
  pitch(head?: "batter" | "resonant"): number;

  /** A stroke at a frame, the next one unless given. Strokes may be given in any order before they are due. */
  strike(stroke?: Stroke & { frame?: number }): void;
  /** Moves a parameter that may change while the drum rings, as "wires.strainer" or "batter.muffle_strength". */
  change(key: string, value: number, frame?: number): void;
  /** As if the drum had just been created: at rest, without coming events, at frame 0. */
  reset(): void;

  /** The next frames, an array for each channel; 1 is full scale. The sound does not depend on the division. */
  process(frames: number): Float32Array[];

  ledger(): Ledger;
  /**
   * Strokes and changes that were not carried out, since the drum was created or reset: there are 8 sticks, and each is free
   * again once its stroke has ended.
   */
  readonly droppedEvents: number;
  /** Everything has died away. */
  readonly isSilent: boolean;
  /** Energy of what the room holds, of no unit. */
  readonly roomEnergy: number;
}

/**
 * Strokes on a fresh drum; the drum's own stroke unless given. Without a duration [s] the sound ends when it has died
 * away. An array for each channel.
 */
export function render(
  preset: string,
  strokes?: readonly (Stroke & { time?: number })[],
  options?: DrumOptions & { duration?: number },
): Promise<Float32Array[]>;

/** The drums that come with the package. */
export function presets(): Promise<Preset[]>;

/** Of the engine. */
export function version(): Promise<string>;

/**
 * Loads the engine from another place than beside the package's files, or from its bytes. Call it before everything
 * else, and only if your bundler moves files without saying so.
 */
export function load(source?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module): Promise<void>;
