// SPDX-License-Identifier: MIT
// A project that uses the package for npm: plays drums into NAME.wav and NAME.csv of the folder in its argument, and
// looks at what is refused. Prints a line "NAME OPTIONS" for each sound, with what `tabor render` is told
// for the same, and "version VERSION". Status 1 if something is wrong. For test_npm.sh.
import { readFile, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { floatWav } from "./float_wav.mjs";
import { Drum, Kit, TaborError, kits, presets, render, renderKit, version } from "tabor";

const folder = process.argv[2];
const RATE = 48000;
const package_ = dirname(createRequire(import.meta.url).resolve("tabor/tabor.wasm"));
let wrong = 0;

function complain(text) {
  console.error(`FAILED: ${text}`);
  wrong++;
}

function table(strokes) {
  const rows = strokes.map(({ time, velocity, radius, angle, technique = "normal", striker }) =>
    [time, velocity, radius, angle, technique, striker].join(","));
  return ["time,velocity,radius,angle,technique,striker", ...rows, ""].join("\n");
}

let takes = 0;
async function keep(channels, options, strokes, rate = RATE) {
  const name = `take${++takes}`;
  await writeFile(join(folder, `${name}.wav`), floatWav(channels, rate));
  if (strokes) await writeFile(join(folder, `${name}.csv`), table(strokes));
  console.log(`${name} ${options}`);
}

const strokes = [
  { time: 0, velocity: 3, radius: 0.05, angle: 0, striker: "stick" },
  { time: 0.1037, velocity: 8, radius: 0.02, angle: 90, technique: "rimshot", striker: "stick" },
  { time: 0.3, velocity: 2, radius: 0.1, angle: 45, technique: "cross-stick", striker: "stick" },
  { time: 0.3011, velocity: 5, radius: 0.08, angle: -120, striker: "mallet" },
  { time: 0.5, velocity: 4, radius: 0.1, angle: 200, technique: "rim", striker: "stick" },
];

/* ---- sounds ---- */

await keep(await render("snare-14x5.5", strokes, { duration: 0.8 }), "snare-14x5.5 --stereo --duration 0.8", strokes);
await keep(await render("tom-12"), "tom-12 --stereo"); // until it has died away
await keep(await render("frame-drum", [{}], { mics: ["top"], sampleRate: 44100, quality: "studio", duration: 0.3 }),
  "frame-drum --mic top --rate 44100 --quality studio --duration 0.3", null, 44100);

// Blocks of all lengths, strokes given in another order, and one while it plays.
const tuned = { set: { "batter.pitch": "A3", "wires.tension": 8, "room.kind": "booth" }, quality: "draft" };
const drum = await Drum.create("snare-14x5.5", tuned);
const give = ({ time, ...stroke }) => drum.strike({ ...stroke, frame: Math.round(time * RATE) });
strokes.slice(0, -1).reverse().forEach(give);
const parts = [1, 127, 128, 129, 5000, 0, 9999].map((frames) => drum.process(frames));
give(strokes.at(-1));
parts.push(drum.process(0.6 * RATE - drum.frame));
const channels = [0, 1].map((i) => Float32Array.from(parts.flatMap((part) => [...part[i]])));
await keep(channels, "snare-14x5.5 --stereo --quality draft --set batter.pitch=A3 --set wires.tension=8 --set room.kind=booth " +
  "--duration 0.6", strokes);

// After a reset all is as before. Microphones in a room that hears others.
drum.change("wires.strainer", 0);
drum.process(100);
drum.reset();
strokes.forEach(give);
const again = drum.process(0.6 * RATE);
if (!again.every((channel, i) => Buffer.compare(Buffer.from(channel.buffer), Buffer.from(channels[i].buffer)) === 0)) {
  complain("a reset drum sounds different");
}
const hall = { set: { "room.kind": "hall" }, mics: ["top", "right"], duration: 0.4 };
await keep(await render("tom-12", [{}], hall), "tom-12 --set room.kind=hall --mic top --mic right --duration 0.4");

// A browser's entry: no files, the engine by its address.
const browsers = await import(pathToFileURL(join(package_, "index.js")));
await browsers.load(await readFile(join(package_, "tabor.wasm")));
await keep(await browsers.render("piccolo-13x3.5", [{}], { duration: 0.2 }), "piccolo-13x3.5 --stereo --duration 0.2");

/* ---- kits and MIDI ---- */

let seed = Number(process.env.SEED ?? 1);
const random = (below) => {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return Math.floor((seed / 2 ** 32) * below);
};

/** Messages of a second: strokes, controllers, pressures. */
function randomMessages(count) {
  const controllers = [1, 7, 11, 16, 17, 20, 88, 120, 121, 123];
  const kinds = [
    () => [0x99, 35 + random(23), 1 + random(127)], () => [0x99, 35 + random(23), 1 + random(127)],
    () => [0x89, 35 + random(23), 64],
    () => [0xb9, controllers[random(controllers.length)], random(128)],
    () => [0xa9, 35 + random(23), random(128)], () => [0xd9, random(128)],
  ];
  const messages = Array.from({ length: count }, () => ({ tick: random(960), message: kinds[random(kinds.length)]() }));
  return messages.sort((a, b) => a.tick - b.tick);
}

/** A file of 480 ticks a quarter, half a second. */
function midiFile(messages) {
  const varied = (value) => (value < 128 ? [value] : [0x80 | (value >> 7), value & 127]);
  let before = 0;
  const track = messages.flatMap(({ tick, message }) => {
    const bytes = [...varied(tick - before), ...message];
    before = tick;
    return bytes;
  });
  track.push(0, 0xff, 0x2f, 0);
  const length = [24, 16, 8, 0].map((shift) => (track.length >>> shift) & 255);
  return Uint8Array.from([0x4d, 0x54, 0x68, 0x64, 0, 0, 0, 6, 0, 0, 0, 1, 1, 224, 0x4d, 0x54, 0x72, 0x6b, ...length, ...track]);
}

async function keepSong(name, render_, options) {
  const file = midiFile(randomMessages(40));
  await writeFile(join(folder, `song${takes + 1}.mid`), file);
  await keep(await render_(name, file, { quality: "draft" }), `${options} --quality draft --midi-file takes/song${takes + 1}.mid`);
}

const all = await kits();
if (!all.some(({ name, comment }) => name === "standard" && comment.length > 10)) complain("kits() lacks standard");
const songs = Number(process.env.SONGS ?? all.length);
console.log(`# ${songs} songs from seed ${seed}`);
for (let i = 0; i < songs; i++) {
  const { name } = all[i % all.length];
  await keepSong(name, renderKit, `--kit ${name}`);
  await keepSong("snare-14x5.5", render, "snare-14x5.5 --stereo");
}

// Notes that play nothing are said.
const lines = [];
await renderKit("standard", midiFile([[0x99, 38, 90], [0x99, 27, 90], [0x99, 27, 90]].map((message) => ({ tick: 0, message }))),
  { quality: "draft", duration: 0.01, warn: (line) => lines.push(line) });
if (String(lines) !== "notes that play no drum of the kit: 27 (2)") complain(`warnings: ${lines}`);

// The quality of the definition, where the option is not given.
await keep(await render("tom-12", [{}], { set: { "quality.level": "draft" }, duration: 0.1 }),
  "tom-12 --stereo --set quality.level=draft --duration 0.1");

// Strokes and values of the mix, in blocks of all lengths; parts of drums behind it.
const kit = await Kit.create("jazz", { quality: "draft", outputs: ["snare"], set: { "drum.snare.batter.pitch": "A3" } });
if (String(kit.channels) !== "left,right,snare left,snare right") complain(`channels: ${kit.channels}`);
if (Math.abs(kit.pitch("snare") - 220) > 0.5) complain(`A3 of the snare is ${kit.pitch("snare")} Hz`);
const giveKit = () => {
  kit.strike({ drum: "kick", velocity: 4, frame: 100 });
  kit.strike({ drum: "snare", frame: 5000 });
  kit.change("kit.overheads", -6, 4000);
  kit.change("drum.snare.wires.strainer", 0, 9000);
  kit.midi([0x99, 38, 90], 12000);
};
giveKit();
const pieces = [1, 127, 128, 129, 5000, 0, 9999].map((frames) => kit.process(frames));
const [mixLeft, , snareLeft] = [0, 1, 2].map((i) => Float32Array.from(pieces.flatMap((piece) => [...piece[i]])));
kit.reset();
giveKit();
const whole = kit.process(mixLeft.length);
const sameBits = (a, b) => Buffer.compare(Buffer.from(a.buffer), Buffer.from(b.buffer)) === 0;
if (!sameBits(whole[0], mixLeft) || !sameBits(whole[2], snareLeft)) complain("a kit depends on the division into blocks, or on what was before");
if (snareLeft.every((sample) => sample === 0)) complain("the snare's part is silent");
const account = kit.ledger();
if (!(account.injected > 0.1 && Math.abs(account.residual) < 1e-6 * account.injected)) complain(`a kit's ledger has ${account.injected}`);

/* ---- many events ---- */

/** Strokes at frame 5, and a softer one later, in blocks of some frames: the sound, and how many strokes were dropped. */
async function crowd(count, blocks) {
  const drum = await Drum.create("tom-12", { quality: "draft" });
  for (let i = 0; i < count; i++) drum.strike({ velocity: 2, frame: 5 });
  drum.strike({ velocity: 1, frame: 3000 });
  const parts = blocks.map((frames) => drum.process(frames)[0]);
  return { sound: Buffer.concat(parts.map((part) => Buffer.from(part.buffer))), dropped: drum.droppedEvents };
}

const few = await crowd(8, [4800]); // as many sticks as the engine has
const many = await crowd(200, [4800]);
const parted = await crowd(200, [3, 2, 1, 100, 4694]);
if (few.dropped !== 0 || many.dropped !== 192) complain(`dropped: ${few.dropped} of 8 strokes, ${many.dropped} of 200`);
if (Buffer.compare(few.sound, many.sound) !== 0) complain("of 200 strokes at once others act than of 8");
if (Buffer.compare(many.sound, parted.sound) !== 0) complain("many strokes depend on the division into blocks");

/* ---- progress ---- */

const heard = [];
await Drum.create("snare-14x5.5", { quality: "studio", progress: (done) => heard.push(done) });
if (!(heard.length > 2 && heard.at(-1) === 1 && heard.every((done, i) => i === 0 || done >= heard[i - 1]))) complain(`progress: ${heard}`);

/* ---- facts ---- */

console.log(`version ${await version()}`);
const list = await presets();
if (!list.some(({ name, comment }) => name === "tom-12" && comment.length > 10)) complain("presets() lacks tom-12");
if (Math.abs(drum.pitch() - 220) > 0.5) complain(`A3 is ${drum.pitch()} Hz`);
if (!drum.keys.includes("wires.tension") || drum.get("wires.tension") !== "8") complain("get() and keys");
if (String(drum.mics) !== "left,right" || !drum.strikers.includes("mallet")) complain("mics or strikers");
const { injected, residual } = drum.ledger();
if (!(injected > 0.1 && Math.abs(residual) < 1e-6 * injected)) complain(`the ledger has ${injected}, ${residual}`);

/* ---- what is refused ---- */

async function refused(what, text, facts = {}) {
  try {
    await what();
    complain(`accepted: ${what}`);
  } catch (error) {
    if (!(error instanceof TaborError)) complain(`${what}: ${error.stack}`);
    if (!text.test(error.message)) complain(`${what}: ${error.message}`);
    for (const [name, value] of Object.entries(facts)) {
      if (error[name] !== value) complain(`${what}: ${name} is ${error[name]}`);
    }
  }
}

await refused(() => Kit.create("standart"), /standart.*standard/);
await refused(() => Kit.create("standard", { set: { "kit.overhead": 1 } }), /kit\.overhead/);
await refused(() => Kit.create("standard", { set: { "drum.snar.batter.pitch": "A3" } }), /no drum 'snar'; 'drum\.snar\.preset' adds it/);
await refused(() => kit.midi([0x40, 38, 90]), /status of a message = 64: allowed: whole numbers 128 to 255/);
await refused(() => kit.midi([0x99, 38, 128]), /a byte of a message = 128: allowed: whole numbers 0 to 127/);
await refused(() => kit.change("toString", 1), /toString/);
await refused(() => Kit.create("standard", { outputs: ["cymbal"] }), /outputs = 'cymbal': allowed: .*snare/);
await refused(() => kit.strike({ drum: "cymbal" }), /drum = 'cymbal': allowed: .*snare/);
await refused(() => kit.strike(), /drum = 'undefined'/);
await refused(() => kit.change("kit.overheads", 30), /kit\.overheads = 30: allowed: -120 to 24 dB/);
await refused(() => kit.change("kit.overhead_x", 1), /kit\.overhead_x: this does not change/);
await refused(() => kit.change("drum.snare.batter.tension", 3000), /drum\.snare\.batter\.tension.*while the drum rings/);
await refused(() => kit.midiFile(new Uint8Array(10)), /MIDI/);
const create = (set, options) => () => Drum.create("snare-14x5.5", { set, ...options });
await refused(create({ "batter.tension": 5 }), /batter\.tension.*5.*100.*20000/,
  { key: "batter.tension", value: "5", minimum: 100, maximum: 20000 });
await refused(create({ "batter.tention": 3000 }), /batter\.tention.*batter\.tension/, { key: "batter.tention" });
await refused(create({ "batter.pitch": "H3" }), /batter\.pitch.*H3/, { key: "batter.pitch", value: "H3" });
await refused(create({ "batter.pitch": "A8" }), /batter\.pitch/, { key: "batter.pitch" });
await refused(create({}, { sampleRate: 1000 }), /1000/);
await refused(create({ "quality.two_way_bandwidth": 22000 }, { quality: "reference", mostSeconds: 1 }),
  /would take some .* more than the limit of 1 s: lower [a-z._]+/);
await refused(create({}, { mostBytes: 1e6 }), /more than the limit of 1 MB/);
await refused(create({}, { mostSeconds: -1 }), /mostSeconds = -1/);
await refused(create({}, { progress: () => false }), /cancel/);
await refused(create({}, { quality: "best" }), /quality.*best.*draft, live/);
await refused(create({}, { mics: ["topp"] }), /mics.*topp.*top/);
await refused(create({}, { mics: ["top", "top"] }), /twice/);
await refused(() => Drum.create("snare"), /snare/);
await refused(() => render("tom-12", [{ time: -1 }]), /time = -1.*0 to 3600/, { key: "time", minimum: 0 });
await refused(() => render("tom-12", [{}], { duration: 0 }), /duration = 0/);
await refused(() => drum.strike({ velocity: 50 }), /velocity = 50: allowed: 0\.01 to 30 m\/s/, { maximum: 30 });
await refused(() => drum.strike({ velocity: NaN }), /velocity = NaN/);
await refused(() => drum.strike({ radius: 1 }), /radius = 1: allowed: 0 to 0\.1778/);
await refused(() => drum.strike({ technique: "flam" }), /technique = 'flam': allowed: normal, rimshot/);
await refused(() => drum.strike({ striker: "spoon" }), /striker = 'spoon': allowed: stick, mallet/);
await refused(() => drum.strike({ frame: 0 }), /frame = 0/);
await refused(() => drum.process(1.5), /frames = 1\.5: allowed: whole/);
await refused(() => drum.change("batter.tension", 3000), /batter\.tension.*while the drum rings/);
await refused(() => drum.change("wires.strainer", 2), /wires\.strainer = 2: allowed: 0 to 1/);
await refused(() => drum.get("wires.number"), /wires\.number/);

/** Of another type than a number: refused at the call, by name and value. */
async function mistyped(what, text) {
  try {
    await what();
    complain(`accepted: ${what}`);
  } catch (error) {
    if (error.constructor !== TypeError || !text.test(error.message)) complain(`${what}: ${error.stack}`);
  }
}

await mistyped(() => drum.strike("x"), /a stroke: x is no object/);
await mistyped(() => render("tom-12", "x"), /events are an array of strokes, or the bytes of a MIDI file/);
await mistyped(() => drum.strike({ velocity: 3n }), /velocity = 3: its type is bigint, not number/);
await mistyped(() => drum.strike({ velocity: "3" }), /velocity = 3: its type is string/);
await mistyped(() => drum.strike({ radius: { valueOf: () => 0 } }), /radius = .*: its type is object/);
await mistyped(() => drum.strike({ angle: 90n }), /angle = 90/);
await mistyped(() => drum.strike({ frame: 1000000n }), /frame = 1000000/);
await mistyped(() => drum.change("wires.strainer", 1n), /wires\.strainer = 1/);
await mistyped(() => drum.process(10n), /frames = 10/);
await mistyped(create({}, { sampleRate: 48000n }), /sampleRate = 48000/);
await mistyped(() => render("tom-12", [{ time: 1n }]), /time = 1/);
await mistyped(() => render("tom-12", [{}], { duration: 1n }), /duration = 1/);
drum.process(256); // nothing of it is due

process.exitCode = wrong > 0 ? 1 : 0;
