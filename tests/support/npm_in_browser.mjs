// SPDX-License-Identifier: MIT
// The package for npm in headless Chromium, as it is, without a bundler: npm_in_browser.mjs ADDRESS TOOLS FILE NODE. ADDRESS serves
// the package; TOOLS is the folder into which tools/setup --web installs; FILE gets a stroke on tom-12, NODE the same of an audio node. For test_npm.sh.
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { floatWav } from "./float_wav.mjs";

const [address, tools, file, nodeFile] = process.argv.slice(2);
const { chromium } = createRequire(resolve(tools, "package.json"))("playwright-core");

async function play(address) {
  const { render } = await import(`${address}index.js`);
  return (await render("tom-12", [{}], { duration: 0.2 })).map((channel) => [...channel]);
}

/** A node is silent until all of the drum's memory is there; then it plays the stroke, whose sound takes a while to the microphones. */
async function playNode(address) {
  const { Drum, Kit, createNode, render } = await import(`${address}index.js`);
  const way = (await render("tom-12", [{}], { duration: 0.2 }))[0].findIndex((sample) => sample !== 0);
  const context = new OfflineAudioContext(2, 48000, 48000);
  const drum = await Drum.create("tom-12");
  drum.strike(); // before the node is there
  const node = await createNode(context, drum);
  node.connect(context.destination);
  const refused = [() => drum.process(10), () => drum.ledger(), () => drum.reset()].filter((call) => {
    try {
      call();
      return true;
    } catch (error) {
      return !/audio node/.test(error.message);
    }
  });
  const other = await Kit.create("frame-drums", { quality: "draft", sampleRate: 44100 });
  const said = await createNode(context, other).then(() => "accepted", (error) => error.message);
  const rendered = await context.startRendering();
  const [left, right] = [0, 1].map((i) => rendered.getChannelData(i));
  const start = left.findIndex((sample) => sample !== 0) - way;
  return { start, refused: refused.length, said, channels: [left, right].map((channel) => [...channel.slice(start, start + 9600)]) };
}

/** Strokes on a kit that sounds, in real time: a stroke and a MIDI message later. */
async function playLive(address) {
  const { Kit, createNode } = await import(`${address}index.js`);
  const context = new AudioContext({ sampleRate: 48000 });
  const kit = await Kit.create("frame-drums", { quality: "draft" });
  const node = await createNode(context, kit);
  const analyser = new AnalyserNode(context);
  node.connect(analyser).connect(context.destination);
  await context.resume();
  const samples = new Float32Array(analyser.fftSize);
  const heard = async () => {
    for (let i = 0; i < 2000; i++) {
      analyser.getFloatTimeDomainData(samples);
      if (samples.some((sample) => Math.abs(sample) > 1e-3)) return true;
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    return false;
  };
  kit.strike({ drum: kit.drums[0], velocity: 4 });
  const first = await heard();
  await context.close();
  return first;
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM,
  args: ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
    "--autoplay-policy=no-user-gesture-required"],
});
try {
  const page = await browser.newPage();
  page.setDefaultTimeout(120_000); // nothing here fails because a machine is slow
  await page.goto(`${address}index.js`);
  writeFileSync(file, floatWav(await page.evaluate(play, address), 48000));
  const { start, refused, said, channels } = await page.evaluate(playNode, address);
  console.log(`# the node sounds from frame ${start} on`);
  writeFileSync(nodeFile, floatWav(channels, 48000));
  if (refused > 0) throw new Error("an instrument that plays in a node plays beside it");
  if (!/44100.*48000/.test(said)) throw new Error(`a node of another sample rate: ${said}`);
  if (!(await page.evaluate(playLive, address))) throw new Error("a node is silent");
} finally {
  await browser.close();
}
