// SPDX-License-Identifier: MIT
// Somebody at the page of tools/web, in headless Chromium: strikes drums with mouse, touch, keys and MIDI, records them, and
// looks whether the page asks anybody else for anything. For test_web.sh.
//
//     strike_web_page.mjs ADDRESS TOOLS FOLDER [SECONDS]
//
// With SECONDS it also plays some drums and a kit for so long each, and prints how many gaps the sound had.
// TOOLS is the folder into which tools/setup --web installs. FOLDER gets NAME.wav and NAME.csv, of a kit NAME.mid, of each
// recording and pictures of the page. Prints a line "NAME SECONDS COMMAND" for each recording, with the command that the page shows for
// it, and what was measured as "# ..." lines. Status 1 if something is wrong.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

import { takeSeconds } from "./take_seconds.mjs";

const [address, tools, folder, seconds] = process.argv.slice(2);
const require = createRequire(resolve(tools, "package.json"));
const { chromium } = require("playwright-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

const WAIT = 120_000; // [ms]; nothing here fails because a machine is slow
const INSECURE = "insecure.test"; // a name for this machine that browsers do not trust as localhost
const flags = [
  `--host-resolver-rules=MAP ${INSECURE} 127.0.0.1`,
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
];
const DEAREST = "wires.count=40&quality.wire_points=400&quality.two_way_bandwidth=22000"; // more than the page builds
const drums = [["tom-12", "live"], ["snare-14x5.5", "live"], ["snare-14x5.5", "draft"], ["bass-drum-22", "live"]];

let wrong = 0;
let takes = 0;
function complain(text) {
  console.error(`FAILED: ${text}`);
  wrong++;
}

/** Hears errors, and requests to anybody else. */
function watch(page) {
  page.on("console", (message) => {
    if (message.text().endsWith("blocked by Playwright")) return; // as open() has asked for
    if (["error", "warning"].includes(message.type())) complain(`the console says: ${message.text()}`);
  });
  page.on("pageerror", (error) => complain(`an error: ${error.message}`));
  page.on("requestfailed", (request) => {
    const reason = request.failure().errorText;
    if (reason !== "net::ERR_ABORTED") complain(`${reason}: ${request.url()}`); // what a closed page left
  });
  page.on("request", (request) => {
    const url = request.url();
    if (!url.startsWith(address) && !url.startsWith("blob:")) complain(`a request to ${url}`);
  });
}

/** A MIDI input in place of the browser's: window.midiInput. */
function offerMidi() {
  globalThis.midiInput = { onmidimessage: null };
  const access = { inputs: new Map([["pads", globalThis.midiInput]]), onstatechange: null };
  navigator.requestMIDIAccess = async () => access;
}

const sendMidi = (page, ...data) => page.evaluate((data) => globalThis.midiInput.onmidimessage({ data }), data);

const status = (page, text) => page.locator("#status", { hasText: text }).waitFor({ timeout: WAIT });

async function open(browser, options) {
  const context = await browser.newContext({ serviceWorkers: "block", ...options }); // a worker's requests would not be seen here
  await context.addInitScript(offerMidi);
  await context.addInitScript(keepTones);
  const page = await context.newPage();
  page.setDefaultTimeout(WAIT);
  watch(page);
  const began = Date.now();
  await page.goto(address);
  await status(page, "Ready");
  console.log(`# the page is ready after ${Date.now() - began} ms`);
  return page;
}

/** Chooses a drum and waits until it plays. */
async function choose(page, preset, quality) {
  await page.getByRole("combobox", { name: "Drum" }).selectOption(preset);
  await page.getByRole("combobox", { name: "Quality" }).selectOption(quality);
  await status(page, "Ready");
  await page.waitForTimeout(300); // the former drum fades
  console.log(`# ${preset}: ${await page.locator("#facts").textContent()}`);
}

/** The place at a share of the head's radius to the right of and above the centre. */
async function placeOf(page, right, up) {
  await page.locator("#drum").scrollIntoViewIfNeeded();
  const box = await page.locator("#drum").boundingBox();
  const radius = (0.86 * box.width) / 2;
  return [box.x + box.width / 2 + right * radius, box.y + box.height / 2 - up * radius];
}

/** Strokes by mouse, keys, MIDI and, on the rim, by the mouse again. */
async function play(page) {
  await page.mouse.click(...(await placeOf(page, 0.1, 0.2)));
  await page.waitForTimeout(150);
  await page.mouse.click(...(await placeOf(page, -0.5, 0.3)));
  await page.keyboard.press("3");
  for (const key of ["a", "g", "p", " ", "z", "x", "c"]) {
    await page.keyboard.press(key);
    await page.waitForTimeout(60);
  }
  for (const [note, velocity] of [[38, 100], [36, 10], [40, 64], [37, 64], [39, 127], [35, 64], [38, 0]]) {
    await sendMidi(page, 0x99, note, velocity);
    await page.waitForTimeout(60);
  }
  await page.mouse.click(...(await placeOf(page, 1.04, 0)));
  await page.waitForTimeout(800);
}

/** Number of strokes that play() makes. */
const STROKES = 15;

async function save(page, link, file) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByText(link).click()]);
  await download.saveAs(join(folder, file));
}

/** Records what `play` plays, and prints how the program makes it again. */
async function recordTake(page, name, play, strokes, extension) {
  await page.getByRole("button", { name: "Record" }).click();
  await play(page);
  await page.getByRole("button", { name: "Stop" }).click();
  await status(page, "Recorded");
  await save(page, "Sound (WAV)", `${name}.wav`);
  await save(page, strokes, `${name}.${extension}`);
  const command = await page.locator("#command-text").innerText();
  console.log(`${name} ${takeSeconds(join(folder, `${name}.wav`))} ${command}`);
  return join(folder, `${name}.${extension}`);
}

async function record(page) {
  const table = await recordTake(page, `take${++takes}`, play, "Strokes (CSV)", "csv");
  const strokes = readFileSync(table, "utf8").trim().split("\n").length - 1;
  if (strokes !== STROKES) complain(`${table}: ${strokes} of ${STROKES} strokes`);
}

/** Looks for what people with assistive technology miss. */
async function checkAccess(page, where) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  for (const { id, help, nodes } of violations) complain(`${where}: ${id}: ${help}: ${nodes[0].html}`);
}

async function prepareToRecord(page) {
  await page.getByRole("heading", { level: 1 }).click(); // a gesture without a stroke
  await page.getByRole("button", { name: "Record", disabled: false }).waitFor();
  await page.getByRole("button", { name: "MIDI", exact: true }).click();
  await status(page, "1 MIDI input");
}

async function recordDrums(browser) {
  const page = await open(browser, { acceptDownloads: true });
  await prepareToRecord(page);
  for (const [preset, quality] of drums) {
    await choose(page, preset, quality);
    await record(page);
  }
  await page.context().close();
}

/** All notes, among them rimshots, a cross-stick and those that no drum of the kit has. */
async function playNotes(page) {
  for (let note = 0; note < 128; note++) {
    await sendMidi(page, 0x99, note, 1 + ((note * 37) % 127));
    await page.waitForTimeout(30);
  }
  await page.waitForTimeout(800);
}

/** The drum that is struck is filmed: the snare drum has wires, a tom has none. */
async function filmKit(page) {
  const text = page.locator("#motion-text");
  await page.getByRole("combobox", { name: "How many times slower" }).selectOption("20");
  for (const [place, wires] of [[[-0.55, -0.33], true], [[0.05, 0.35], false]]) {
    await page.waitForTimeout(1200); // what was filmed before is over
    await page.mouse.click(...(await placeOf(page, ...place)));
    await text.filter({ hasText: /^[0-9].* ms/ }).waitFor();
    const said = await text.textContent();
    if (said.includes("orange wires") !== wires) complain(`a kit's drum at ${place}: ${said}`);
  }
  await text.filter({ hasText: "next stroke" }).waitFor();
}

/** A kit is played by notes, by keys and by the mouse; each drum is struck where it stands. */
async function playKit(browser) {
  const page = await open(browser, { acceptDownloads: true });
  await prepareToRecord(page);
  await choose(page, "kit:standard", "draft");
  await recordTake(page, `take${++takes}`, playNotes, "Strokes (MIDI)", "mid");
  await filmKit(page);
  const byHand = async () => {
    for (const key of ["a", "s", "d", "f", "g", "w", "z"]) await page.keyboard.press(key);
    await page.mouse.click(...(await placeOf(page, -0.55, -0.33))); // the snare drum
    await page.mouse.click(...(await placeOf(page, -1.1, 1.1))); // the floor
    await page.waitForTimeout(500);
  };
  const notes = readFileSync(await recordTake(page, "by-hand", byHand, "Strokes (MIDI)", "mid"));
  const struck = [...notes.keys()].filter((i) => notes[i] === 0x99 && notes[i + 2] > 0).map((i) => notes[i + 1]);
  const expected = [35, 38, 48, 45, 41, 38, 40, 38];
  if (struck.join() !== expected.join()) complain(`keys and the mouse play the notes ${struck}, not ${expected}`);
  await page.keyboard.press("d");
  await page.getByRole("group", { name: "Tuning: high-tom" }).waitFor();
  await move(page, "slider", /^Batter head/, ["PageDown", "ArrowLeft"]);
  const moved = await controlsOf(page);
  if (!page.url().includes("drum.high-tom.batter.pitch=")) complain(`a tuned tom's link is ${page.url()}`);
  await page.locator("#drum").press("s");
  const snare = await controlsOf(page);
  await page.evaluate(() => { document.getElementById("batter-pitch").max = 36; });
  await page.getByRole("slider", { name: /^Batter head/ }).press("End"); // more than its tension may be
  await status(page, "Ready, the snare batter head goes no further than C5-3");
  if ((await controlsOf(page)) === snare) complain(`a pitch that is too high goes back to ${snare}`);
  if (!page.url().includes("drum.snare.batter.pitch=C5-3")) complain(`a pitch that is too high is in the link: ${page.url()}`);
  await page.locator("#drum").press("g");
  await page.getByRole("group", { name: "Tuning: floor-tom" }).waitFor();
  if ((await controlsOf(page)) === moved) complain("the floor tom has the high tom's controls");
  await page.screenshot({ fullPage: true, path: join(folder, "kit.png") });
  await checkAccess(page, "kit");
  await page.reload();
  await status(page, "Ready");
  const kit = await page.getByRole("combobox", { name: "Drum" }).inputValue();
  if (kit !== "kit:standard") complain(`the link restores ${kit}`);
  await page.locator("#drum").press("d");
  if ((await controlsOf(page)) !== moved) complain(`the link restores ${await controlsOf(page)} and not ${moved}`);
  await page.context().close();
}

/** A MIDI file of one track, whose bytes are these. */
function songOf(name, ...track) {
  const length = [0, 0, 0, track.length + 4];
  const head = [..."MThd"].map((letter) => letter.charCodeAt(0)).concat(0, 0, 0, 6, 0, 0, 0, 1, 0, 96);
  const body = [..."MTrk"].map((letter) => letter.charCodeAt(0)).concat(length, track, 0, 0xff, 0x2f, 0);
  return { name, mimeType: "audio/midi", buffer: Buffer.from([...head, ...body]) };
}

const untilSung = (page) => page.getByRole("button", { name: "MIDI file", pressed: false }).waitFor();

/** Files are chosen and dropped; strokes, warnings and refusals are those of the program. */
async function playFiles(browser) {
  const page = await open(browser, { acceptDownloads: true });
  await prepareToRecord(page);
  const song = songOf("song.mid", 0, 0x99, 36, 100, 24, 38, 80, 24, 0xf8, 24, 0x99, 40, 127);
  const playSong = async () => {
    await page.locator("#song-file").setInputFiles(song);
    await status(page, "Playing song.mid; byte 30, track 1: a system message F8, which no file may hold, is passed over");
    await untilSung(page);
    await page.waitForTimeout(500);
  };
  await choose(page, "tom-12", "draft");
  const table = await recordTake(page, `take${++takes}`, playSong, "Strokes (CSV)", "csv");
  const rows = readFileSync(table, "utf8").trim().split("\n").slice(1).map((row) => row.split(","));
  const blocks = rows.map(([time]) => Math.round(((time - rows[0][0]) * 48000) / 128));
  if (blocks.join() !== "0,46,140") complain(`the strokes of a file come at the blocks ${blocks}`); // of frames 0, 6000, 18000
  await choose(page, "kit:frame-drums", "draft");
  await recordTake(page, `take${++takes}`, playSong, "Strokes (MIDI)", "mid");
  await choose(page, "snare-14x5.5", "draft");
  await page.locator("#song-file").setInputFiles(songOf("off.mid", 0, 0x99, 38, 80, 1, 0xb9, 20, 0));
  await page.getByRole("checkbox", { name: "Snares on", checked: false }).waitFor();
  await untilSung(page);
  await page.locator("#song-file").setInputFiles(songOf("none.mid", 0, 0x99, 100, 80));
  await status(page, "none.mid: no note in it is a stroke: 1 are not in the map");
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File(["RIFF"], "wrong.mid"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  });
  await status(page, "wrong.mid: byte 0: not a Standard MIDI File: it does not begin with a header 'MThd'");
  await page.locator("#song-file").setInputFiles(songOf("long.mid", 0, 0x99, 38, 80, 0xff, 0x7f, 0x99, 38, 80));
  await page.getByRole("button", { name: "Stop file" }).click();
  await untilSung(page);
  await page.context().close();
}

/** Plays for long, four strokes a second; the machine may be too slow, so gaps are no failure. */
async function playLong(browser) {
  for (const [preset, quality] of [["tom-12", "live"], ["bass-drum-22", "live"], ["snare-14x5.5", "draft"], ["kit:standard", "draft"]]) {
    const page = await open(browser, {});
    await page.getByRole("heading", { level: 1 }).click();
    await choose(page, preset, quality);
    const gaps = async () => parseInt((await page.locator("#gaps").textContent()).replace(/^\D*/, "") || "0", 10);
    await page.locator("#drum").press("a");
    await page.waitForTimeout(2000); // the page counts from time to time
    const before = await gaps();
    const keys = preset.startsWith("kit:") ? ["a", "d", "s", "f", "a", "a", "s", "g"] : ["d", "f"];
    for (let i = 0; i < 4 * Number(seconds); i++) {
      await page.keyboard.press(keys[i % keys.length]);
      await page.waitForTimeout(250);
    }
    await page.waitForTimeout(1000);
    console.log(`# ${preset}, ${quality}: ${(await gaps()) - before} gaps in ${seconds} s`);
    await page.context().close();
  }
}

/** What all controls of the drum show. */
async function controlsOf(page) {
  const texts = await page.locator("#drum-controls output").allTextContents();
  const stick = await page.getByRole("combobox", { name: "Stick" }).inputValue();
  return [...texts, stick, await page.getByRole("checkbox", { name: "Snares on" }).isChecked()].join("; ");
}

/** Moves a control by keys, and waits for the drum. */
async function move(page, role, name, keys) {
  const before = await controlsOf(page);
  for (const key of keys) await page.getByRole(role, { name }).press(key);
  await status(page, "Ready");
  if ((await controlsOf(page)) === before) complain(`${keys} do not move ${name}`);
}

/** Every control is moved by keys; the link then gives the same drum, and what is recorded is what its command makes. */
async function tune(browser) {
  const page = await open(browser, { acceptDownloads: true });
  await prepareToRecord(page);
  await choose(page, "snare-14x5.5", "draft");
  const own = await controlsOf(page);
  await move(page, "slider", /^Batter head/, ["PageDown", "ArrowLeft"]);
  await move(page, "slider", /^Resonant head/, ["ArrowRight", "PageUp"]);
  await move(page, "slider", /^Muffling of the batter/, ["PageUp", "PageUp"]);
  await move(page, "slider", /^Muffling of the resonant/, ["ArrowRight", "ArrowRight"]);
  await move(page, "combobox", "Stick", ["ArrowDown"]);
  await page.waitForTimeout(300); // the former drum fades
  await record(page);
  await page.getByRole("checkbox", { name: "Snares on" }).press(" ");
  const moved = await controlsOf(page);
  console.log(`# the controls: ${moved}; the link: ${page.url().replace(address, "")}`);
  await page.reload();
  await status(page, "Ready");
  if ((await controlsOf(page)) !== moved) complain(`the link restores ${await controlsOf(page)} and not ${moved}`);
  await prepareToRecord(page);
  await page.waitForTimeout(300);
  await record(page);
  await checkAccess(page, "controls");
  await page.getByRole("button", { name: "As it came" }).press("Enter");
  await status(page, "Ready");
  if ((await controlsOf(page)) !== own) complain(`as it came, the drum has ${await controlsOf(page)}`);
  if (new URL(page.url()).hash.includes(".pitch")) complain(`as it came, the link is ${page.url()}`);
  await page.context().close();
}

/** A drum with one head has no resonant one to tune; a wrong link says why, and gives the drum as it comes. */
async function followLinks(browser) {
  const page = await open(browser, {});
  await page.goto(`${address}#drum=frame-drum&quality=draft&batter.pitch=F%233-20`);
  await page.locator("#batter-pitch-text", { hasText: "F#3 −20 cents" }).waitFor();
  if (await page.locator("#resonant-pitch").isVisible()) complain("a frame drum has a resonant head to tune");
  await page.goto(`${address}#drum=tom-12&quality=draft&batter.pitch=H3`);
  await status(page, /Ready, but not as the address says: batter.pitch.*H3/);
  await page.locator("#batter-pitch-text", { hasText: "Hz" }).waitFor();
  for (const [pitch, note] of [["A8", "C5-3"], ["C0", "G1-28"]]) { // of 48.2 to 522.5 Hz
    await page.goto("about:blank");
    await page.goto(`${address}#drum=snare-14x5.5&quality=draft&batter.pitch=${pitch}`);
    await status(page, `Ready, the batter head goes no further than ${note}`);
    const shown = (await page.locator("#batter-pitch-text").textContent()).replace("−", "-");
    if (!shown.startsWith(`${note.replace("-", " -")} cents`)) complain(`${note} is shown as ${shown}`);
  }
  for (const [wrong, reason] of [["drum=nosuch&batter.pitch=H3", "there is no drum 'nosuch', this is [a-z0-9.-]+ instead"],
    ["drum=kit:nonesuch", "there is no drum 'kit:nonesuch', this is [a-z0-9.-]+ instead"], ["drum=tom-12&quality=bogus", "bogus"],
    ["drum=tom-12&nonesuch=1", "nonesuch"], ["drum=tom-12&quality.level=studio", "quality.level"],
    ["drum=kit:frame-drums&drum.nobody.batter.pitch=A3", "nobody"]]) {
    await page.goto("about:blank");
    await page.goto(`${address}#${wrong}`);
    await status(page, new RegExp(`Ready, but not as the address says: .*${reason}`));
  }
  await page.context().close();
}

/** A build can be ended, before there is a drum and after. */
async function cancel(browser) {
  const context = await browser.newContext();
  await context.addInitScript(holdWorkers);
  const page = await context.newPage();
  page.setDefaultTimeout(WAIT);
  watch(page);
  const cancel = page.getByRole("button", { name: "Cancel" });
  await page.goto(`${address}#drum=snare-14x8&quality=studio`);
  await cancel.click();
  await status(page, "Cancelled; choose a drum");
  await page.evaluate(() => { globalThis.holdsWorkers = false; });
  await choose(page, "frame-drum", "draft");
  await page.evaluate(() => { globalThis.holdsWorkers = true; });
  const before = [await controlsOf(page), page.url()].join();
  await page.getByRole("combobox", { name: "Drum" }).selectOption("snare-14x8");
  await cancel.click();
  await status(page, "Cancelled; this is the drum before");
  const after = [await controlsOf(page), page.url()].join();
  if (after !== before) complain(`after a cancelled build the page has ${after} instead of ${before}`);
  if (await page.getByRole("combobox", { name: "Drum" }).inputValue() !== "frame-drum") complain("a cancelled drum stays chosen");
  if (await page.getByRole("group", { name: "Tuning" }).isDisabled()) complain("there is nothing to tune after a cancelled build");
  if (await cancel.isEnabled()) complain("there is something to cancel when nothing is being built");
  if (await page.evaluate(() => globalThis.held) !== 2) complain("the workers were not held");
  await context.close();
}

/** A model that would take for ever is not built. */
async function limitBuilds(browser) {
  const page = await open(browser, {});
  await page.goto("about:blank");
  await page.goto(`${address}#drum=frame-drum&quality=studio&${DEAREST}`);
  await status(page, /Ready, but not as the address says: this model would take .* more than the limit of/);
  await page.context().close();
}

/** While window.holdsWorkers is true, workers hear nothing: what they build is never ready. window.held counts these messages. */
function holdWorkers() {
  globalThis.holdsWorkers = true;
  globalThis.held = 0;
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (...message) {
    if (globalThis.holdsWorkers) globalThis.held++;
    else postMessage.apply(this, message);
  };
}

/** Snares off and on by box, key and controller; the energy account adds up. */
async function operate(browser) {
  const page = await open(browser, {});
  await choose(page, "snare-14x5.5", "draft");
  const snares = page.getByRole("checkbox", { name: "Snares on" });
  await page.getByRole("button", { name: "MIDI", exact: true }).click();
  await status(page, "1 MIDI input");
  await snares.uncheck();
  await page.getByRole("heading", { level: 1 }).click();
  await page.keyboard.press("b");
  if (!(await snares.isChecked())) complain("the key b does not put the snares on");
  await sendMidi(page, 0xb0, 20, 0);
  if (await snares.isChecked()) complain("controller 20 does not take the snares off");
  await page.getByRole("slider", { name: "Stick speed" }).fill("3");
  await page.locator("#drum").press("Enter");
  await page.waitForFunction(() => document.getElementById("energy").textContent.includes("sound0.0 %") === false);
  const sum = await page.evaluate(() =>
    [...document.querySelectorAll("#energy td:last-child")].reduce((sum, cell) => sum + parseFloat(cell.textContent), 0));
  if (Math.abs(sum - 100) > 1) complain(`the energy account adds up to ${sum} %`);
  await page.locator("#drum").press("]");
  await status(page, "Building");
  await status(page, "Ready");
  await page.context().close();
}

/** One click isolates a mode: what it is, is said, and it is seen and heard alone until a stroke, or while it is driven. */
async function isolateMode(browser) {
  const page = await open(browser, {});
  await choose(page, "tom-12", "draft");
  const modes = page.getByRole("group", { name: "The lowest modes by frequency" }).getByRole("button");
  if ((await modes.count()) < 10) complain(`${await modes.count()} modes are listed`);
  const fundamental = modes.first();
  const drive = page.getByRole("button", { name: "Drive it" });
  const picture = () => page.locator("#drum").screenshot();
  const still = await picture();
  await fundamental.click();
  const words = await page.locator("#mode-text").textContent();
  if (!/^[\d.]+ Hz: 0 nodal diameters, 0 nodal circles; both heads, together; dies away by 60 dB in [\d.]+ s$/.test(words)) complain(`a mode is said to be '${words}'`);
  const hears = (loud) => page.waitForFunction((loud) => globalThis.tones.some(({ value }) => value > 0.01) === loud, loud);
  await hears(true);
  if (still.equals(await picture())) complain("a mode that is isolated is not seen");
  await drive.click();
  if ((await drive.getAttribute("aria-pressed")) !== "true") complain("a mode is not driven");
  await page.mouse.click(...(await placeOf(page, 0.3, 0.1)));
  if ((await fundamental.getAttribute("aria-pressed")) !== "false" || !(await drive.isDisabled())) complain("a stroke does not end a mode's motion");
  await hears(false);
  await page.context().close();
}

/** The gains of sines in window.tones. */
function keepTones() {
  globalThis.tones = [];
  const Original = globalThis.GainNode;
  globalThis.GainNode = class extends Original {
    constructor(...options) {
      super(...options);
      globalThis.tones.push(this.gain);
    }
  };
}

/** The second time the page opens without a network, and can be installed. */
async function openOffline(browser) {
  const page = await (await browser.newContext()).newPage(); // whose failed requests are meant
  page.setDefaultTimeout(WAIT);
  await page.goto(address);
  await status(page, "Ready");
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.reload();
  await status(page, "Ready");
  const manifest = await page.evaluate(async () => (await fetch(document.querySelector("link[rel=manifest]").href)).json());
  if (manifest.display !== "standalone" || manifest.icons.length === 0) complain("the page cannot be installed");
  await page.context().setOffline(true);
  await page.reload();
  await status(page, "Ready");
  await page.context().close();
}

/** Snares that are off before there is any sound are off at the first stroke; wires then lose next to nothing. */
async function strikeWithoutSnares(browser) {
  const page = await open(browser, {});
  await choose(page, "snare-14x5.5", "draft");
  await page.getByRole("checkbox", { name: "Snares on" }).uncheck();
  await page.mouse.click(...(await placeOf(page, 0.3, 0.1)));
  const share = page.getByRole("row", { name: "lost in the wires" }).getByRole("cell").last();
  await page.getByRole("row", { name: "radiated" }).getByText(/[1-9]/).waitFor();
  const lost = parseFloat(await share.textContent());
  if (lost > 0.2) complain(`snares that are off lose ${lost} % of the energy`);
  await page.context().close();
}

/** Keeps the page's audio contexts in window.contexts. While window.lacksModules is true, their modules are not there. */
function keepContexts() {
  const addModule = globalThis.AudioWorklet?.prototype.addModule; // there is none where browsers do not trust the address
  globalThis.contexts = [];
  const Original = globalThis.AudioContext;
  globalThis.AudioContext = class extends Original {
    constructor(...options) {
      super(...options);
      globalThis.contexts.push(this);
    }
  };
  if (!addModule) return;
  AudioWorklet.prototype.addModule = function (url) {
    return addModule.call(this, globalThis.lacksModules ? new URL("nosuch.js", url) : url);
  };
}

const untilItRuns = (page) => page.waitForFunction(() => globalThis.contexts.at(-1).state === "running");

/** A page whose errors are expected. */
async function openUnwatched(browser, address) {
  const page = await (await browser.newContext()).newPage();
  page.setDefaultTimeout(WAIT);
  await page.addInitScript(keepContexts);
  await page.goto(address);
  await status(page, "Ready");
  return page;
}

/** Sound that was stopped goes on when the page is shown again and at a gesture, also from the state that iOS alone has. */
async function interrupt(browser) {
  const page = await openUnwatched(browser, address);
  await page.getByRole("heading", { level: 1 }).click();
  await untilItRuns(page);
  await page.evaluate(() => globalThis.contexts[0].suspend());
  await page.evaluate(() => document.dispatchEvent(new Event("visibilitychange")));
  await untilItRuns(page);
  await page.evaluate(async () => {
    await globalThis.contexts[0].suspend();
    Object.defineProperty(globalThis.contexts[0], "state", { get: () => "interrupted", configurable: true });
  });
  await page.getByRole("heading", { level: 1 }).click();
  await page.evaluate(() => delete globalThis.contexts[0].state);
  await untilItRuns(page);
  await page.context().close();
}

/** A module that could not be loaded is loaded at the next gesture; where there are no worklets, the page says why. */
async function lackSound(browser) {
  const page = await openUnwatched(browser, address);
  await page.evaluate(() => { globalThis.lacksModules = true; });
  await page.getByRole("heading", { level: 1 }).click();
  await status(page, "There is no sound");
  await page.evaluate(() => { globalThis.lacksModules = false; });
  await page.getByRole("heading", { level: 1 }).click();
  await page.getByRole("button", { name: "Record", disabled: false }).waitFor();
  await page.context().close();
  const insecure = await openUnwatched(browser, address.replace("127.0.0.1", INSECURE));
  await insecure.mouse.click(...(await placeOf(insecure, 0.1, 0.2)));
  await status(insecure, "There is no sound: browsers play it only from an address that begins with https:// or http://localhost");
  await insecure.context().close();
}

const look = (page, canvas) => page.evaluate((id) => document.getElementById(id).toDataURL(), canvas);

/** How many different pictures a canvas shows within a second. */
async function countPictures(page, canvas) {
  const pictures = new Set();
  for (let i = 0; i < 20; i++) {
    pictures.add(await look(page, canvas));
    await page.waitForTimeout(50);
  }
  return pictures.size;
}

/** What level and spectrum show: dBFS, and the points of the picture that are drawn. */
const shownSound = (page) => page.evaluate(() => {
  const spectrum = document.getElementById("spectrum");
  const upperHalf = new OffscreenCanvas(spectrum.width, Math.round(spectrum.height / 2)).getContext("2d", { willReadFrequently: true });
  upperHalf.drawImage(spectrum, 0, 0);
  const { data } = upperHalf.getImageData(0, 0, upperHalf.canvas.width, upperHalf.canvas.height);
  return { level: document.getElementById("level").value, points: data.filter((value, i) => i % 4 === 3 && value > 0).length };
});

/** Level and spectrum of a stroke stay while its film runs. */
async function watchSoundOfFilm(browser) {
  const page = await open(browser, {});
  await choose(page, "frame-drum", "draft"); // it dies away sooner than its film ends
  await page.getByRole("combobox", { name: "How many times slower" }).selectOption("300");
  await page.mouse.click(...(await placeOf(page, 0.3, 0.2)));
  await page.locator("#motion-text", { hasText: /^[1-9].* ms/ }).waitFor();
  const first = await shownSound(page);
  await page.locator("#motion-text", { hasText: /^[12]\d.* ms/ }).waitFor();
  const later = await shownSound(page);
  console.log(`# while the film runs: ${JSON.stringify([first, later])}`);
  if (later.level < first.level) complain(`the level falls from ${first.level} to ${later.level} during the film`);
  if (later.points < 0.9 * first.points) complain(`the spectrum falls from ${first.points} to ${later.points} points during the film`);
  await page.getByRole("checkbox", { name: "Slow motion" }).press(" ");
  await page.waitForFunction((held) => document.getElementById("level").value < held - 10, later.level);
  await page.context().close();
}

/** Slow motion of heads, wires and stick follows a stroke, from the side and from above, and can be switched off. */
async function watchSlowMotion(browser) {
  const page = await open(browser, {});
  const slow = page.getByRole("checkbox", { name: "Slow motion" });
  if (!(await slow.isChecked())) complain("slow motion is off at first");
  if ((await countPictures(page, "motion")) !== 1) complain("a silent drum moves");
  const atRest = await look(page, "motion");
  await page.getByRole("combobox", { name: "How many times slower" }).selectOption("300");
  await page.mouse.click(...(await placeOf(page, 0.3, 0.2)));
  await page.locator("#motion-text", { hasText: /^[1-9].* ms/ }).waitFor();
  for (const [canvas, where] of [["motion", "the side"], ["drum", "above"]]) {
    const count = await countPictures(page, canvas);
    console.log(`# ${count} of 20 pictures from ${where} are different`);
    if (count < 5) complain(`slow motion shows ${count} pictures from ${where} in a second`);
  }
  await page.screenshot({ fullPage: true, path: join(folder, "slow-motion.png") });
  await page.getByRole("combobox", { name: "How many times slower" }).selectOption("20");
  await page.locator("#motion-text", { hasText: "next stroke" }).waitFor();
  if ((await look(page, "motion")) !== atRest) complain("the drum does not come to rest after the film");
  await slow.press(" ");
  await page.locator("#motion").waitFor({ state: "hidden" });
  await page.locator("#drum").press("a");
  await page.waitForFunction(() => document.getElementById("level").value > -40);
  await page.waitForTimeout(300);
  await slow.press(" ");
  await page.locator("#motion").waitFor();
  if ((await countPictures(page, "motion")) !== 1) complain("a stroke without slow motion was filmed");
  await page.context().close();
}

/** Points of a canvas in a colour of the style, within 40 of each part. */
const countColored = (page, canvas, name) => page.evaluate(([id, name]) => {
  const shown = document.getElementById(id);
  const copy = new OffscreenCanvas(shown.width, shown.height).getContext("2d");
  copy.drawImage(shown, 0, 0);
  const probe = new OffscreenCanvas(1, 1).getContext("2d");
  probe.fillStyle = getComputedStyle(shown).getPropertyValue(name);
  probe.fillRect(0, 0, 1, 1);
  const [r, g, b] = probe.getImageData(0, 0, 1, 1).data;
  const { data } = copy.getImageData(0, 0, shown.width, shown.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 200 && Math.max(Math.abs(data[i] - r), Math.abs(data[i + 1] - g), Math.abs(data[i + 2] - b)) < 40) count++;
  }
  return count;
}, [canvas, name]);

/** On the paper's drum string and skin leave curves over 120 ms. Hold stops the film, the wave form and the spectrum. */
async function watchPapersDrum(browser) {
  const page = await open(browser, {});
  await choose(page, "bodhran-d-string", "draft");
  if ((await countColored(page, "heights", "--touch")) > 0) complain("there are curves before a stroke");
  await page.getByRole("combobox", { name: "How many times slower" }).selectOption("50");
  await page.mouse.click(...(await placeOf(page, 0.3, 0.2)));
  await page.locator("#motion-text", { hasText: /^4\d[.].* ms/ }).waitFor(); // a film of 40 ms would be over soon
  const curves = [await countColored(page, "heights", "--touch"), await countColored(page, "heights", "--mesh")];
  console.log(`# points of string and skin: ${curves}`);
  if (curves[0] < 300 || curves[1] < 300) complain("string and skin have no curves");
  await page.keyboard.press(".");
  await page.waitForTimeout(200);
  const held = await Promise.all(["motion", "heights", "wave", "spectrum"].map((canvas) => look(page, canvas)));
  await page.screenshot({ fullPage: true, path: join(folder, "held.png") });
  await page.waitForTimeout(1000);
  const later = await Promise.all(["motion", "heights", "wave", "spectrum"].map((canvas) => look(page, canvas)));
  if (held.some((picture, i) => picture !== later[i])) complain("Hold does not hold");
  await page.getByRole("button", { name: "Hold" }).click();
  await page.locator("#motion-text", { hasText: /^11\d[.].* ms/ }).waitFor();
  await page.locator("#motion-text", { hasText: "next stroke" }).waitFor();
  await page.context().close();
}

/** The page opens on a cheap drum. Somebody who wants little motion gets none unasked. */
async function openFirst(browser) {
  const page = await open(browser, { reducedMotion: "reduce" });
  const drum = await page.getByRole("combobox", { name: "Drum" }).inputValue();
  if (drum !== "tom-12") complain(`the page opens on ${drum}, which may cost more than the machine has`);
  if (await page.getByRole("checkbox", { name: "Slow motion" }).isChecked()) complain("reduced motion is not heeded");
  await page.context().close();
}

/** A finger strikes at once, and the link names the drum. */
async function touch(browser) {
  const page = await open(browser, { hasTouch: true, isMobile: true, viewport: { width: 360, height: 740 } });
  await choose(page, "frame-drum", "live");
  await page.touchscreen.tap(...(await placeOf(page, 0.2, 0.2)));
  await page.waitForFunction(() => document.getElementById("level").value > -40);
  await page.reload();
  await status(page, "Ready");
  const drum = await page.getByRole("combobox", { name: "Drum" }).inputValue();
  if (drum !== "frame-drum") complain(`the link restores ${drum}`);
  await page.context().close();
}

async function picture(browser, colorScheme, width) {
  const viewport = { width, height: width > 600 ? 800 : 740 };
  const page = await open(browser, { colorScheme, viewport });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  if (wide > width) complain(`the page is ${wide} wide on ${width}`);
  await page.mouse.click(...(await placeOf(page, 0.3, 0.4)));
  await page.waitForFunction(() => document.getElementById("level").value > -40);
  await page.locator("#motion-text", { hasText: /^([6-9]|..)[.].* ms/ }).waitFor();
  await page.screenshot({ fullPage: true, path: join(folder, `${colorScheme}-${width}.png`) });
  await checkAccess(page, `${colorScheme} ${width}`);
  await page.context().close();
}

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: flags });
try {
  await recordDrums(browser);
  await playKit(browser);
  await playFiles(browser);
  await tune(browser);
  await followLinks(browser);
  await cancel(browser);
  await limitBuilds(browser);
  await operate(browser);
  await isolateMode(browser);
  await openOffline(browser);
  await strikeWithoutSnares(browser);
  await interrupt(browser);
  await lackSound(browser);
  await watchSlowMotion(browser);
  await watchSoundOfFilm(browser);
  await watchPapersDrum(browser);
  await openFirst(browser);
  await touch(browser);
  if (seconds) await playLong(browser);
  for (const scheme of ["light", "dark"]) for (const width of [1100, 360]) await picture(browser, scheme, width);
} catch (error) {
  complain(error.message);
} finally {
  await browser.close();
}
process.exitCode = wrong > 0 ? 1 : 0;
