// SPDX-License-Identifier: MIT
// The page: what is chosen, struck, shown and recorded.
import { DrumControls } from "./drum_controls.js";
import { DrumView } from "./drum_view.js";
import { EnergyView } from "./energy_view.js";
import { startEngine, textAt } from "./engine.js";
import { FilmView } from "./film_view.js";
import { HeightsView } from "./heights_view.js";
import { actionOf } from "./keys.js";
import { kitOf, listedKit, settingsOfKit } from "./kits.js";
import { MidiMap, listenToMidi } from "./midi.js";
import { ModesView } from "./modes_view.js";
import { Recorder } from "./recorder.js";
import { CHANNELS, RATE, Sound } from "./sound.js";
import { SpectrumView } from "./spectrum_view.js";
import { WaveView } from "./wave_view.js";

const FIRST_DRUM = "tom-12"; // one that slow machines play in real time, too; snare drums take several times as much
const MOST_LOAD = 0.6; // computing time that `automatic` allows, as a share of real time
const GHOST = 1 / 3; // speed of a ghost note, as a share
const CROSS_STICK = 3; // the engine's number of this technique
const CROSS_STICK_PLACE = 0.6; // where its tip lies, as a share of the radius
const RIM = 4; // the engine's number of this technique
const FLOOR = -60; // [dBFS]
const GROUPS = { snare: "Snare drums", tom: "Toms", "bass-drum": "Bass drums", "hand-drum": "Hand drums", timpani: "Timpani",
  cymbal: "Cymbals", kit: "Kits: several drums at once" };

const element = (id) => document.getElementById(id);
const link = new URLSearchParams(location.hash.slice(1)); // the drum that a link names, and what was changed of it

const view = new DrumView(element("drum"));
const heights = new HeightsView(element("heights"));
const film = new FilmView(element("motion"), element("motion-text"), heights, (heights) => view.setHeights(heights));
const energy = new EnergyView(element("energy-bar"), element("energy"));
const spectrum = new SpectrumView(element("spectrum"));
const wave = new WaveView(element("wave"));
const controls = new DrumControls(element("drum-controls"), link, changeDrum);
let presets = []; // { name, comment }, kits with a name of the list
let sound = null;
let modes = null;
let midi = null;
let facts = null; // of the drum or kit that sounds
let tried = null; // the quality that is being built
let chosen = null; // { preset, quality } in the lists for the drum that sounds, and which it was `built` at
let hasMoved = false; // it was changed while it sounded
let refused = ""; // why the drum is not as the link says
let shownPeak = 0; // full scale is 1
let beginsFilm = false; // a stroke for another film came since the last level
let gapsBefore = 0; // in the sound of other drums
let recorder = null;
let last = { drum: 0, share: 0, angle: 0, speed: 1 }; // the last stroke

/* ---- what is shown ---- */

function say(text, isFailure = false) {
  element("status").textContent = text;
  element("status").classList.toggle("failed", isFailure);
}

function fail(reason) {
  showProgress(1);
  say(`This does not work: ${reason}`, true);
}

function showProgress(done) {
  element("progress").value = done;
  element("progress").classList.toggle("done", done >= 1);
  element("cancel").disabled = done >= 1;
}

function showFacts() {
  const load = Math.round(100 * facts.load);
  element("facts").textContent =
    `${tried}: ${facts.modes} modes, built in ${facts.seconds.toFixed(2)} s; takes ${load} % of real time here`;
  element("comment").textContent = presets.find(({ name }) => name === element("preset").value).comment;
}

/* While a stroke is shown in slow motion, its level and spectrum stay. */
function showLevel(now) {
  const isHeld = film.isOn && !beginsFilm;
  const peak = isHeld ? Math.max(now, shownPeak) : now;
  shownPeak = peak;
  beginsFilm = false;
  const level = peak > 0 ? 20 * Math.log10(peak) : -Infinity;
  element("level").value = Math.max(level, FLOOR);
  element("decibels").value = level < FLOOR ? "−∞ dB" : `${level.toFixed(0).replace("-", "−")} dB`;
  view.setLevel(level);
  if (peak === 0 || isOnHold()) return;
  spectrum.show(sound.analyser, isHeld);
  wave.show(sound.analyser, isHeld);
}

const isOnHold = () => element("hold").getAttribute("aria-pressed") === "true";

/* Spectrum, wave form and slow motion stand still. */
function toggleHold() {
  const holds = !isOnHold();
  element("hold").setAttribute("aria-pressed", String(holds));
  film.setHeld(holds);
}

function showLedger(ledger) {
  energy.show(ledger);
  const gaps = sound.gaps - gapsBefore;
  const help = tried !== "draft" ? "A lower quality helps." : isKit() ? "A drum alone takes less." : "";
  element("gaps").hidden = sound.gaps === undefined;
  element("gaps").textContent = gaps > 0 ? `Gaps in the sound: ${gaps}. ${help}` : "No gaps in the sound";
}

/* ---- the drum ---- */

const preset = () => element("preset").value;
const isKit = () => kitOf(preset()) !== null;
const settings = () => (isKit() ? settingsOfKit(controls.settings) : controls.settings);
/** What stands there: a kit's drums, or the only one. */
const drums = () => facts.drums ?? [facts];

const speed = () => 2 ** Number(element("speed").value); // [m/s]

function setSpeed(velocity) {
  element("speed").value = Math.log2(velocity);
  showSpeed();
}

function showSpeed() {
  const text = `${speed().toFixed(2)} m/s`;
  element("speed-text").value = text;
  element("speed").setAttribute("aria-valuetext", text);
}

function buildDrum(quality) {
  tried = quality;
  say(`Building ${preset()}, ${quality}`);
  showProgress(0);
  sound.build(preset(), settings(), quality);
}

function showLink() {
  link.set("drum", preset());
  link.set("quality", element("quality").value);
  history.replaceState(null, "", `#${link}`);
}

function chooseQuality() {
  showLink();
  const quality = element("quality").value;
  const automatic = isKit() ? "draft" : "live"; // no machine plays all drums of a kit at `live` in a browser
  buildDrum(quality === "automatic" ? automatic : quality);
}

/* Another drum is as it came. */
function chooseDrum() {
  refused = "";
  endSong();
  controls.clear();
  controls.wait();
  chooseQuality();
}

/* A control was moved. */
function changeDrum() {
  showLink();
  buildDrum(tried);
}

/* To the drum that sounds. */
function goBack() {
  element("preset").value = chosen.preset;
  element("quality").value = chosen.quality;
  tried = chosen.built;
  controls.revert(drums()[last.drum]);
  showLink();
}

function cancelBuild() {
  sound.cancel();
  showProgress(1);
  if (facts) goBack();
  say(facts ? "Cancelled; this is the drum before" : "Cancelled; choose a drum");
}

/* The former drum plays on. At first there is none: the link is wrong. */
function failBuild(reason) {
  if (facts) {
    goBack();
    return fail(reason);
  }
  if (!controls.clear()) return fail(reason);
  refused ||= reason;
  changeDrum();
}

/* A machine that cannot play `live` gets `draft`, if the quality is left to the page. */
function useDrum(built) {
  const quality = element("quality").value;
  if (quality === "automatic" && tried === "live" && built.load > MOST_LOAD) {
    buildDrum("draft");
    return;
  }
  const isFirst = !facts;
  facts = built;
  chosen = { preset: preset(), quality, built: tried };
  hasMoved = false;
  if (!drums()[last.drum]) last.drum = 0;
  last = { drum: last.drum, share: 0, angle: drums()[last.drum].angle };
  if (isFirst) setSpeed(facts.velocity);
  showProgress(1);
  showFacts();
  view.show(drums());
  film.show(drums());
  heights.clear();
  modes.show(drums()[last.drum], last.drum);
  showSlowMotion();
  element("drum").classList.toggle("kit", isKit());
  controls.show(drums()[last.drum]);
  if (facts.limited.length > 0) {
    controls.limit(facts.limited, drums()[last.drum].now);
    showLink();
  }
  controls.keep();
  midi.follow(preset(), settings());
  element("song").disabled = false;
  say(["Ready", ...remarks()].join(", "));
  refused = "";
  sound.play();
  gapsBefore = sound.gaps ?? 0;
  showSnares();
}

/* What is not as it was asked for. */
function remarks() {
  const limits = facts.limited.map(([key, note]) => `the ${key.replace("drum.", "").replace(".pitch", " head").replaceAll(".", " ")} goes no further than ${note}`);
  return refused ? [`but not as the address says: ${refused}`, ...limits] : limits;
}

/* They may have been switched while the drum was built. */
function showSnares() {
  const hasSnares = facts.wires.count > 0;
  const strainer = Number(link.get("wires.strainer") ?? facts.preset.strainer);
  element("snares").disabled = !hasSnares;
  element("snares").checked = hasSnares && strainer > 0;
  view.setSnares(element("snares").checked);
  if (strainer !== facts.wires.strainer) moveStrainer(strainer);
}

function moveStrainer(value) {
  hasMoved = true;
  sound.setStrainer(value);
}

const setSnares = (on) => setStrainer(on ? facts.preset.strainer || 1 : 0);

function setStrainer(strainer) {
  showStrainer(strainer);
  moveStrainer(strainer);
}

function showStrainer(strainer) {
  const own = facts.preset.strainer;
  if (strainer === own) link.delete("wires.strainer");
  else link.set("wires.strainer", strainer);
  showLink();
  element("snares").checked = strainer > 0;
  view.setSnares(strainer > 0);
}

const isFilmed = () => element("slow").checked;

function showSlowMotion() {
  const on = isFilmed();
  element("slowness").disabled = !on;
  film.setOn(on);
  sound.film(on);
}

function stepPreset(step) {
  const select = element("preset");
  const count = select.options.length;
  select.selectedIndex = (select.selectedIndex + step + count) % count;
  chooseDrum();
}

/* ---- strokes ---- */

/* A place is a share of the radius, so that it is the same on every drum. */
function strike({ drum = 0, share, ...stroke }) {
  sound.start();
  if (facts) strikePlace({ drum, radius: Math.min(share, 1) * drums()[drum].radius, ...stroke });
}

/* `radius` is in metres. */
function strikePlace({ drum, radius, angle, velocity, technique = 0, striker, note }) {
  const share = radius / drums()[drum].radius;
  last = { drum, share, angle, velocity };
  if (facts.drums) controls.select(facts.drums[drum]); // the drum that was struck last is the one to tune
  modes.show(drums()[drum], drum);
  sound.strike({ drum, velocity, radius, angle, technique, striker, note });
}

/* Where the drum's own stroke goes. */
function strikeDrum(drum, velocity) {
  const { radius, place, angle } = drums()[drum];
  strike({ drum, share: place / radius, angle, velocity });
}

function strikeWith(technique) {
  const share = technique === CROSS_STICK ? CROSS_STICK_PLACE : last.share;
  strike({ ...last, share, velocity: speed(), technique });
}

/* Pens know how hard they are pressed. */
function velocityOf(event) {
  const ghost = event.shiftKey ? GHOST : 1;
  const pressure = event.pointerType === "pen" && event.pressure > 0 ? 2 * event.pressure : 1;
  return speed() * ghost * pressure;
}

function strikeAt(event) {
  if (event.button !== 0) return;
  event.preventDefault();
  element("drum").focus({ focusVisible: false });
  const place = view.placeAt(event);
  if (!place) return;
  strike({ ...place, velocity: velocityOf(event), technique: place.share > 1 ? RIM : 0 });
}

function actByMidi(message) {
  sound.start();
  const action = facts && midi.take(message);
  if (action?.kind === "stroke") strikePlace({ ...action, note: message[1] });
  if (action?.kind === "strainer") setStrainer(action.value);
}

function connectMidi() {
  sound.start();
  const tell = (count) => say(count === 1 ? "1 MIDI input" : `${count} MIDI inputs`);
  listenToMidi(actByMidi, tell).catch((error) => say(`No MIDI: ${error.message}`, true));
}

/* ---- MIDI files ---- */

function showSong(isPlaying) {
  element("song").setAttribute("aria-pressed", String(isPlaying));
  element("song").textContent = isPlaying ? "Stop file" : "MIDI file";
}

const isSinging = () => element("song").getAttribute("aria-pressed") === "true";

function endSong() {
  if (isSinging()) sound.playSong([]);
  showSong(false);
}

function chooseSong() {
  sound.start();
  if (isSinging()) endSong();
  else element("song-file").click();
}

async function playSong(file) {
  if (!file || !facts) return;
  const { said, actions } = await midi.readSong(file, RATE);
  if (!actions) return say(`${file.name}: ${said.join("; ")}`, true);
  say([`Playing ${file.name}`, ...said].join("; "));
  showSong(true);
  sound.playSong(actions);
}

function chooseSongFile() {
  playSong(element("song-file").files[0]);
  element("song-file").value = ""; // so that the same file can be chosen again
}

function dropSong(event) {
  if (!event.dataTransfer.types.includes("Files")) return;
  event.preventDefault();
  if (event.type === "drop") playSong(event.dataTransfer.files[0]);
}

/* ---- keys ---- */

/* The keys that strike a drum from the centre to the rim are one for each drum of a kit. */
function strikeByKey({ zone, share }, velocity) {
  if (facts?.drums) {
    if (zone < facts.drums.length) strikeDrum(zone, velocity);
  } else {
    strike({ share, angle: facts?.angle ?? 0, velocity });
  }
}

function act(action) {
  if (action.stroke) strikeByKey(action.stroke, speed());
  if (action.ghost) strikeByKey(action.ghost, GHOST * speed());
  if (action.technique) strikeWith(action.technique);
  if (action.repeat) strike({ ...last, velocity: last.velocity ?? speed() });
  if (action.speed) setSpeed(action.speed);
  if (action.preset) stepPreset(action.preset);
  if (action.hold) toggleHold();
  if (action.snares && !element("snares").disabled) setSnares(!element("snares").checked);
}

/* Lists, boxes and buttons keep their own keys. */
function isTaken(event, key) {
  if (event.ctrlKey || event.altKey || event.metaKey) return true;
  const own = event.target.closest("select, button, summary, a, input");
  return own?.tagName === "SELECT" || (own && (key === " " || key === "enter"));
}

function pressKey(event) {
  const key = event.key.toLowerCase();
  const action = isTaken(event, key) ? null : actionOf(key);
  if (!action) return;
  event.preventDefault();
  act(action);
}

/* ---- recording ---- */

function toggleRecording() {
  const begins = !recorder;
  element("record").setAttribute("aria-pressed", String(begins));
  element("record").textContent = begins ? "Stop recording" : "Record";
  if (begins) recorder = new Recorder(CHANNELS, RATE, command(), facts.drums, midi);
  sound.record(begins);
}

/* What makes the drum's sound again, until it is changed; "" if nothing does. */
function command() {
  if (hasMoved) return "";
  const changes = settings().map(([key, value]) => ` --set ${key}=${value}`).join("");
  const sounds = `--quality ${tried}${changes} --format float -o again.wav`;
  return isKit() ? `tabor render --kit ${kitOf(preset())} --midi-file strokes.mid ${sounds}`
    : `tabor render ${preset()} --stereo --events strokes.csv ${sounds}`;
}

function offer(anchor, blob) {
  URL.revokeObjectURL(anchor.href);
  anchor.hidden = !blob;
  if (blob) anchor.href = URL.createObjectURL(blob);
}

function addRecorded(piece) {
  recorder.add(piece);
  if (piece.last) finishRecording();
  else if (recorder.isFull && element("record").getAttribute("aria-pressed") === "true") toggleRecording();
}

function finishRecording() {
  offer(element("sound-file"), recorder.sound());
  offer(element("strokes-file"), recorder.strokes());
  element("strokes-file").download = `strokes.${recorder.isOfKit ? "mid" : "csv"}`;
  element("strokes-file").textContent = recorder.isOfKit ? "Strokes (MIDI)" : "Strokes (CSV)";
  element("files").hidden = false;
  element("command").hidden = recorder.command === "" || recorder.command !== command();
  element("command-text").textContent = recorder.command;
  element("command-label").textContent = recorder.isOfKit
    ? "The same, of strokes that came by MIDI, and nearly the same of others, if the kit was silent at first:"
    : "The same, if the drum was silent at first:";
  say(`Recorded ${recorder.seconds.toFixed(1)} s`);
  recorder = null;
}

/* ---- the beginning ---- */

async function load(file) {
  const response = await fetch(new URL(file, import.meta.url));
  if (!response.ok) throw new Error(`${file}: ${response.status}`);
  return response.arrayBuffer();
}

function listPresets(engine) {
  const list = (count, name, comment) =>
    Array.from({ length: count }, (_, i) => ({ name: textAt(engine, name(i)), comment: textAt(engine, comment(i)) }));
  const drums = list(engine.preset_count(), engine.preset_name, engine.preset_comment);
  const kits = list(engine.kit_count(), engine.kit_name, engine.kit_comment);
  return [
    ...drums.map((drum, i) => ({ ...drum, category: textAt(engine, engine.preset_category(i)) })),
    ...kits.map(({ name, comment }) => ({ name: listedKit(name), comment, category: "kit" })),
  ];
}

/** Takes from the link what it cannot say; the first reason is told. */
function checkLink() {
  for (const key of [...link.keys()]) {
    if (key === "drum" || key === "quality" || (key.includes(".") && key !== "quality.level")) continue;
    refused ||= key === "quality.level" ? "quality.level is said by quality=" : `there is no '${key}'`;
    link.delete(key);
  }
}

function fillPresets() {
  checkLink();
  const select = element("preset");
  const groups = {};
  for (const { name, category } of presets) {
    groups[category] ??= Object.assign(document.createElement("optgroup"), { label: GROUPS[category] ?? category });
    groups[category].append(new Option(kitOf(name) ?? name, name));
  }
  select.append(...Object.values(groups));
  const wanted = presets.some(({ name }) => name === link.get("drum"));
  select.value = wanted ? link.get("drum") : FIRST_DRUM;
  if (!wanted && link.has("drum")) {
    controls.clear(); // what was changed of that drum means nothing to another one
    refused = `there is no drum '${link.get("drum")}', this is ${select.value} instead`;
  }
  const quality = element("quality");
  quality.value = link.get("quality") ?? "automatic";
  if (quality.selectedIndex >= 0) return;
  refused ||= `there is no quality '${link.get("quality")}'`;
  quality.value = "automatic";
}

function listen() {
  const heard = {
    progress: showProgress,
    built: useDrum,
    failed: failBuild,
    silent: (reason) => say(`There is no sound: ${reason}`, true),
    started: () => { element("record").disabled = false; },
    struck: (stroke) => {
      const drum = drums()[stroke.drum];
      if (drum) view.mark(stroke.drum, stroke.radius / drum.radius, stroke.angle, stroke.velocity);
      if (isFilmed()) beginsFilm ||= film.expect();
      recorder?.addStroke(stroke);
    },
    level: ({ peak }) => showLevel(peak),
    ledger: showLedger,
    recorded: addRecorded,
    sung: () => showSong(false),
    strained: ({ value }) => {
      hasMoved = true;
      showStrainer(value);
    },
    filmed: (taken) => film.play(taken),
  };
  for (const [type, use] of Object.entries(heard)) {
    sound.addEventListener(type, ({ detail }) => use(detail));
  }
  element("drum").addEventListener("pointerdown", strikeAt);
  element("preset").addEventListener("change", chooseDrum);
  element("quality").addEventListener("change", chooseQuality);
  element("speed").addEventListener("input", showSpeed);
  element("snares").addEventListener("change", (event) => setSnares(event.target.checked));
  element("slow").addEventListener("change", showSlowMotion);
  element("slowness").addEventListener("change", (event) => film.setSlowness(Number(event.target.value)));
  element("cancel").addEventListener("click", cancelBuild);
  element("hold").addEventListener("click", toggleHold);
  element("record").addEventListener("click", toggleRecording);
  element("midi").addEventListener("click", connectMidi);
  element("song").addEventListener("click", chooseSong);
  element("song-file").addEventListener("change", chooseSongFile);
  for (const type of ["dragover", "drop"]) addEventListener(type, dropSong);
  element("midi").hidden = !navigator.requestMIDIAccess;
  addEventListener("keydown", pressKey);
  addEventListener("hashchange", () => location.reload()); // somebody has put in another link
  addEventListener("pointerup", () => { if (facts) sound.start(); }); // when a touch allows sound
  document.addEventListener("visibilitychange", () => { if (!document.hidden) sound.resume(); });
}

async function begin() {
  const bytes = await load("tabor.wasm");
  const engine = await startEngine(bytes);
  presets = listPresets(engine);
  element("version").textContent = textAt(engine, engine.version());
  midi = new MidiMap(engine);
  sound = new Sound(bytes);
  modes = new ModesView(element("modes"), element("mode-text"), element("drive"), (heights) => view.setHeights(heights), sound);
  fillPresets();
  showSpeed();
  listen();
  element("slow").checked = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  showSlowMotion();
  chooseQuality();
}

/* From the second visit on the page needs no network. It works without that, too. */
navigator.serviceWorker?.register("offline.js").catch(() => {});
begin().catch((error) => fail(error.message));
