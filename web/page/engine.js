// SPDX-License-Identifier: MIT
// The engine as WebAssembly, instantiated by hand: Emscripten's own JavaScript does not run in an AudioWorklet
// without shared memory. web/glue.c has the functions that it exports.

const PAGE_SIZE = 65536; // of WebAssembly's memory [bytes]
const NOT_SUPPORTED = 52; // of WASI

/** What the engine imports. It asks for no clock while it plays. */
function importsOf(progress) {
  return {
    tabor: { progress },
    env: { emscripten_notify_memory_growth() {} },
    wasi_snapshot_preview1: { clock_time_get: () => NOT_SUPPORTED },
  };
}

/** An engine that begins from nothing. `progress` hears how far a model is, 0 to 1. */
export async function startEngine(bytes, progress = () => {}) {
  const { instance } = await WebAssembly.instantiate(bytes, importsOf(progress));
  instance.exports._initialize();
  return instance.exports;
}

/** An engine that goes on from the memory of another one; its drums have the same addresses. */
export function continueEngine(module, memory) {
  const { exports } = new WebAssembly.Instance(module, importsOf(() => {}));
  const missing = (memory.byteLength - exports.memory.buffer.byteLength) / PAGE_SIZE;
  if (missing > 0) exports.memory.grow(missing);
  new Uint8Array(exports.memory.buffer).set(new Uint8Array(memory));
  return exports;
}

/** The text at an address. Not for the audio thread, which has no decoder. */
export function textAt(engine, address) {
  const bytes = new Uint8Array(engine.memory.buffer, address);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

/** Calls `use` with the address of a text. */
export function withText(engine, text, use) {
  const bytes = new TextEncoder().encode(`${text}\0`);
  const address = engine.malloc(bytes.length);
  new Uint8Array(engine.memory.buffer).set(bytes, address);
  const result = use(address);
  engine.free(address);
  return result;
}
