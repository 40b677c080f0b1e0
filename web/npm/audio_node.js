// SPDX-License-Identifier: MIT
// An instrument as a node of Web Audio. index.d.ts describes it.
import { TaborError } from "./instrument.js";

const added = new WeakMap(); // contexts, and promises that they know the processor

function addProcessor(context) {
  if (!added.has(context)) {
    const adding = context.audioWorklet.addModule(new URL("worklet.js", import.meta.url));
    added.set(context, adding);
    adding.catch(() => added.delete(context)); // the next call tries again
  }
  return added.get(context);
}

export async function connectNode(context, instrument, module) {
  const { sampleRate: rate } = context;
  if (rate !== instrument.sampleRate) {
    throw new TaborError(`sampleRate = ${instrument.sampleRate}: the context has ${rate} Hz`, "sampleRate", instrument.sampleRate, rate, rate);
  }
  await addProcessor(context);
  let node = null;
  await instrument.leaveTo((begin) => {
    node = new AudioWorkletNode(context, "tabor", {
      numberOfInputs: 0,
      outputChannelCount: [instrument.channelCount],
      processorOptions: { module, ...begin },
    });
    return node.port;
  });
  return node;
}
