// SPDX-License-Identifier: MIT
// The package for npm in headless Chromium, as it is, without a bundler: npm_in_browser.mjs ADDRESS TOOLS FILE. ADDRESS serves
// the package; TOOLS is the folder into which tools/setup --web installs; FILE gets a stroke on tom-12. For test_npm.sh.
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { floatWav } from "./float_wav.mjs";

const [address, tools, file] = process.argv.slice(2);
const { chromium } = createRequire(resolve(tools, "package.json"))("playwright-core");

async function play(address) {
  const { render } = await import(`${address}index.js`);
  return (await render("tom-12", [{}], { duration: 0.2 })).map((channel) => [...channel]);
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM,
  args: ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"],
});
try {
  const page = await browser.newPage();
  page.setDefaultTimeout(120_000); // nothing here fails because a machine is slow
  await page.goto(`${address}index.js`);
  writeFileSync(file, floatWav(await page.evaluate(play, address), 48000));
} finally {
  await browser.close();
}
