// SPDX-License-Identifier: MIT
// page_picture.mjs ADDRESS TOOLS PRESET TUNING FILE.png: strikes the page at ADDRESS and takes a picture, for page-picture. TOOLS is the
// folder into which tools/setup --web installs, TUNING the last line of `tabor modes PRESET`. Status 1: no picture is as it should be.
import { createRequire } from "node:module";
import { resolve } from "node:path";

import { refusals } from "./page_refusals.mjs";

const [address, tools, preset, tuning, file] = process.argv.slice(2);
const { chromium } = createRequire(resolve(tools, "package.json"))("playwright-core");

const TRIES = 5; // a machine that does something else has gaps
const WIDTH = 1100, HEIGHT = 800; // [px]
const SLOW = 60_000; // [ms]; the longest wait for anything
const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];

/** What the page shows, for refusals(). The lower half of the spectrum has lines of its own. */
const look = (page) => page.evaluate(() => {
  const text = (id) => document.getElementById(id).textContent;
  const spectrum = document.getElementById("spectrum");
  const half = new OffscreenCanvas(spectrum.width, Math.round(spectrum.height / 2)).getContext("2d");
  half.drawImage(spectrum, 0, 0);
  const { data } = half.getImageData(0, 0, half.canvas.width, half.canvas.height);
  return {
    gaps: text("gaps"), level: document.getElementById("level").value, points: data.filter((value, i) => i % 4 === 3 && value > 0).length,
    batter: text("batter-pitch-text"), resonant: text("resonant-pitch-text"),
  };
});

async function strike(page) {
  await page.goto("about:blank");
  await page.goto(`${address}#drum=${preset}`);
  await page.locator("#status", { hasText: "Ready" }).waitFor();
  await page.getByRole("heading", { level: 1 }).click(); // a gesture without a stroke: the sound starts
  await page.getByRole("button", { name: "Record", disabled: false }).waitFor();
  await page.waitForTimeout(1000);
  const box = await page.locator("#drum").boundingBox();
  await page.mouse.click(box.x + 0.63 * box.width, box.y + 0.33 * box.height);
  await page.mouse.move(box.x + box.width, box.y);
  await page.locator("#motion-text", { hasText: /^([89]|1\d)[.].* ms/ }).waitFor();
}

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: flags });
let reasons = [];
try {
  const page = await browser.newPage({ colorScheme: "light", viewport: { width: WIDTH, height: HEIGHT } });
  page.setDefaultTimeout(SLOW);
  for (let i = 0; i < TRIES; i++) {
    await strike(page);
    await page.screenshot({ fullPage: true, path: file });
    reasons = refusals(await look(page), tuning);
    if (reasons.length === 0) break;
  }
} catch (error) {
  reasons = [error.message];
} finally {
  await browser.close();
}
for (const reason of reasons) console.error(`page-picture: ${reason}`);
process.exitCode = reasons.length > 0 ? 1 : 0;
