// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// node build.mjs OUT: bundles src/ to one HTML file that loads nothing, with places for a report's
// title and data.
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

const [output] = process.argv.slice(2);
const [page, script, style] = await Promise.all([
  readFile(join(source, "page.html"), "utf8"),
  bundle("main.js"),
  bundle("style.css"),
]);
const parts = { "{{script}}": inside("script", script), "{{style}}": inside("style", style) };
await writeFile(
  output,
  page.replace(/\{\{(?:script|style)\}\}/g, (place) => parts[place]),
);
