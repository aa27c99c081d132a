// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// node build.mjs report|live|tiles OUT: bundles src/ to one HTML file that loads nothing: a report,
// with places for its title and data, the page of a live run, or one that shows the 3D Tiles beside it.
import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const source = join(dirname(fileURLToPath(import.meta.url)), "src");

async function bundle(entry) {
  const result = await build({
    entryPoints: [join(source, entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["chrome109", "firefox110", "safari16"],
    legalComments: "inline",
    logLevel: "warning",
  });
  return result.outputFiles[0].text;
}

/** Within a script or style element only its own end tag has a meaning. */
function inside(element, text) {
  return text.replaceAll(`</${element}`, `<\\/${element}`);
}

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

const kPages = {
  report: ["page.html", "main.js"],
  live: ["live/page.html", "live/main.js"],
  tiles: ["tiles/page.html", "tiles/main.js"],
};
const [name, output] = process.argv.slice(2);
const [frame, entry] = kPages[name];
const [page, script, style] = await Promise.all([
  readFile(join(source, frame), "utf8"),
  bundle(entry).then((text) => inside("script", text)),
  bundle("style.css").then((text) => inside("style", text)),
]);
const parts = {
  "{{script}}": script,
  "{{style}}": style,
  "{{script-hash}}": hash(script),
  "{{style-hash}}": hash(style),
};
await writeFile(
  output,
  page.replace(/\{\{(?:script|style)(?:-hash)?\}\}/g, (place) => parts[place]),
);
