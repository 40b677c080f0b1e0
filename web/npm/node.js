// SPDX-License-Identifier: MIT
// The package in node: the engine is read from its file.
import { readFile } from "node:fs/promises";
import { Drum, Kit, TaborError, createNode, kits, load, presets, readWith, render, renderKit, version } from "./index.js";

readWith((url) => readFile(url));

export { Drum, Kit, TaborError, createNode, kits, load, presets, render, renderKit, version };
