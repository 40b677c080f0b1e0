// SPDX-License-Identifier: MIT
// What users of the package for npm write, as TypeScript sees it. For test_npm.sh.
import {
  Drum, Kit, TaborError, createNode, kits, load, presets, render, renderKit, version, type DrumOptions, type Instrument, type KitOptions, type Ledger, type Stroke,
} from "tabor";

const options: DrumOptions = { quality: "live", sampleRate: 48000, set: { "batter.pitch": "A3", "wires.tension": 8 } };
const stroke: Stroke = { velocity: 3, radius: 0.05, angle: 90, technique: "rimshot", striker: "stick" };

export async function play(): Promise<[Float32Array[], Ledger]> {
  await load(new Uint8Array());
  const name: string = (await presets())[0].name + (await version());
  const drum: Drum = await Drum.create(name, { ...options, mics: ["top"], mostSeconds: 5, mostBytes: 1e9, progress: (done: number) => done < 1 });
  drum.strike({ ...stroke, frame: drum.frame + 10 });
  drum.change("wires.strainer", 0);
  drum.strike();
  const channels: Float32Array[] = [...drum.process(128), ...(await render(name, [{ ...stroke, time: 1 }], { duration: 2 }))];
  drum.reset();
  const dropped: number = drum.droppedEvents;
  return [dropped > 0 ? [] : channels, drum.ledger()];
}

export async function playKit(file: ArrayBuffer): Promise<Float32Array[]> {
  const options: KitOptions = { set: { "kit.overheads": -6 }, outputs: ["snare"] };
  const kit: Kit = await Kit.create((await kits())[0].name, options);
  kit.strike({ drum: kit.drums[0], velocity: 2 });
  kit.change("kit.coupling", "off", 100);
  const instrument: Instrument = kit;
  instrument.midi([0x99, 38, 100]);
  const { last, warnings } = instrument.midiFile(file);
  return warnings.length > 0 ? kit.process(last) : renderKit("jazz", file, { duration: 2 });
}

export async function connect(context: AudioContext): Promise<void> {
  const node: AudioWorkletNode = await createNode(context, await Kit.create("jazz"));
  node.connect(context.destination);
}

export const told = (error: unknown): string => (error instanceof TaborError ? `${error.key} ${error.minimum}` : "");

// @ts-expect-error there is no such quality
export const wrong: DrumOptions = { quality: "best" };
// @ts-expect-error Drum.create() makes drums
new Drum();
// @ts-expect-error a frame is the drum's own business
(await Drum.create("tom-12")).frame = 3;
