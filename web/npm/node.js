// SPDX-License-Identifier: MIT
// The package in node: the engine is read from its file.
import { readFile } from "node:fs/promises";
import { Drum, TaborError, load, presets, readWith, render, version } from "./index.js";

readWith((url) => readFile(url));

export { Drum, TaborError, load, presets, render, version };
