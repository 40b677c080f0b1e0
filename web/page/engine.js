// SPDX-License-Identifier: MIT
// The engine as WebAssembly, instantiated by hand: Emscripten's own JavaScript does not run in an AudioWorklet
// without shared memory. web/glue.h says which functions it exports.

const PAGE_SIZE = 65536; // of WebAssembly's memory [bytes]
const NOT_SUPPORTED = 52; // of WASI

/** Of TaborLedger, in its order. */
export const LEDGER = ["injected", "control", "stored", "head_loss", "wire_loss", "contact_loss", "damper_loss", "shell_loss",
  "radiated", "removed", "high_band", "residual"];

/** What the engine imports. It asks for the clock while it builds, to know when to tell its progress, and not while it plays. */
function importsOf(progress, tellTime = () => NOT_SUPPORTED) {
  return {
    tabor: { progress: (done) => Number(progress(done) !== false) },
    env: { emscripten_notify_memory_growth() {} },
    wasi_snapshot_preview1: { clock_time_get: (clock, precision, address) => tellTime(address) },
  };
}

/** An engine that begins from nothing, of a module or its bytes. `progress` hears how far a model is, 0 to 1; if it
 * returns false, the build ends. */
export async function startEngine(source, progress = () => {}) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  const tellTime = (address) => {
    const time = BigInt(Math.round(1e6 * performance.now())); // [ns]
    new DataView(instance.exports.memory.buffer).setBigUint64(address, time, true);
    return 0;
  };
  const instance = await WebAssembly.instantiate(module, importsOf(progress, tellTime));
  instance.exports._initialize();
  return instance.exports;
}

/** An engine that goes on from the memory of another one; its drums have the same addresses. */
export class ContinuedEngine {
  #memory;
  #copied = 0; // bytes

  constructor(module, memory) {
    this.exports = new WebAssembly.Instance(module, importsOf(() => {})).exports;
    const missing = (memory.byteLength - this.exports.memory.buffer.byteLength) / PAGE_SIZE;
    if (missing > 0) this.exports.memory.grow(missing);
    this.#memory = memory;
  }

  /** Copies at most `most` bytes more of the memory. True once all of it is there. */
  copy(most) {
    const count = Math.min(most, this.#memory.byteLength - this.#copied);
    const part = new Uint8Array(this.#memory, this.#copied, count);
    new Uint8Array(this.exports.memory.buffer).set(part, this.#copied);
    this.#copied += count;
    return this.#copied === this.#memory.byteLength;
  }
}

/** The text at an address. Not for the audio thread, which has no decoder. */
export function textAt(engine, address) {
  const bytes = new Uint8Array(engine.memory.buffer, address);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

/** Changes the definition of an instrument; false with an error. */
export function change(engine, instrument, [key, value]) {
  return withText(engine, key, (keyAt) => withText(engine, value, (valueAt) => engine.instrument_set(instrument, keyAt, valueAt)));
}

/** Calls `use` with the address of a text. */
export const withText = (engine, text, use) => withBytes(engine, new TextEncoder().encode(`${text}\0`), use);

/** Calls `use` with the address of a copy of these bytes. */
export function withBytes(engine, bytes, use) {
  const address = engine.malloc(bytes.length);
  new Uint8Array(engine.memory.buffer).set(bytes, address);
  const result = use(address);
  engine.free(address);
  return result;
}
