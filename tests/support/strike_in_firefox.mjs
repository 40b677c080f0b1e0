// SPDX-License-Identifier: MIT
// Somebody at the page of tools/web, in headless Firefox by WebDriver BiDi: strikes a drum, isolates a mode, and records. For
// test_web.sh, which has started a sound server, without which Firefox plays nothing.
//
//     strike_in_firefox.mjs ADDRESS TOOLS FOLDER FIREFOX
//
// FOLDER gets take-firefox.wav and take-firefox.csv. Prints a line "take-firefox SECONDS COMMAND" with the command that the page
// shows for it. Status 1 if something is wrong.
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

import { takeSeconds } from "./take_seconds.mjs";

const [address, tools, folder, executablePath] = process.argv.slice(2);
const require = createRequire(resolve(tools, "package.json"));
const puppeteer = require("puppeteer-core");

const WAIT = 120_000; // [ms]; nothing here fails because a machine is slow

let wrong = 0;
function complain(text) {
  console.error(`FAILED: in Firefox: ${text}`);
  wrong++;
}

function watch(page) {
  page.on("console", (message) => { if (message.type() === "error") complain(`the console says: ${message.text()}`); });
  page.on("pageerror", (error) => complain(`an error: ${error.message}`));
  page.on("request", (request) => {
    const url = request.url();
    if (![address, "blob:", "data:"].some((start) => url.startsWith(start))) complain(`a request to ${url}`);
  });
}

const status = (page, text) =>
  page.waitForFunction((text) => document.getElementById("status").textContent.startsWith(text), { timeout: WAIT }, text);

async function strike(page, share) {
  const { x, y, width, height } = await (await page.$("#drum")).boundingBox();
  await page.mouse.click(x + width * (0.5 + 0.43 * share), y + height / 2);
}

async function isolateMode(page) {
  const mode = await page.$("#modes button");
  await mode.click();
  const words = await page.$eval("#mode-text", (element) => element.textContent);
  if (!/ Hz: 0 nodal diameters, /.test(words)) complain(`a mode is said to be '${words}'`);
  await mode.click();
}

/** What the page offers, in window.blobs by address: its own policy lets nobody fetch that. */
function keepBlobs() {
  globalThis.blobs = {};
  const { createObjectURL } = URL;
  URL.createObjectURL = (blob) => {
    const address = createObjectURL.call(URL, blob);
    globalThis.blobs[address] = blob;
    return address;
  };
}

/** What a link of the page offers, as bytes. */
async function offered(page, selector) {
  const text = await page.$eval(selector, async (anchor) => {
    const bytes = new Uint8Array(await globalThis.blobs[anchor.href].arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  });
  return Buffer.from(text, "base64");
}

async function record(page) {
  await page.click("#record");
  for (const share of [0.1, 0.5]) {
    await strike(page, share);
    await new Promise((done) => setTimeout(done, 400));
  }
  await page.click("#record");
  await status(page, "Recorded");
  const sound = join(folder, "take-firefox.wav");
  writeFileSync(sound, await offered(page, "#sound-file"));
  writeFileSync(join(folder, "take-firefox.csv"), await offered(page, "#strokes-file"));
  const command = await page.$eval("#command-text", (element) => element.textContent);
  console.log(`take-firefox ${takeSeconds(sound)} ${command}`);
}

const browser = await puppeteer.launch({ browser: "firefox", executablePath, headless: true });
try {
  const page = await browser.newPage();
  await page.setViewport({ width: 1100, height: 1500 });
  await page.evaluateOnNewDocument(keepBlobs);
  watch(page);
  await page.goto(`${address}#drum=tom-12&quality=draft`);
  await status(page, "Ready");
  await isolateMode(page); // a gesture without a stroke: the sound starts
  await page.waitForFunction(() => !document.getElementById("record").disabled, { timeout: WAIT });
  await record(page);
  await page.waitForFunction(() => /sound (?!0[.]0)/.test(document.getElementById("energy-bar").ariaLabel), { timeout: WAIT });
} catch (error) {
  complain(error.message);
} finally {
  await browser.close();
}
process.exitCode = wrong > 0 ? 1 : 0;
