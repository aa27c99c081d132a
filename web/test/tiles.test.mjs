// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A map as 3D Tiles: each tile as glTF's own validator sees it, and the page beside them.
// Environment: SUREFOOT_TEST_TILES, a folder of `surefoot export --tiles`; SUREFOOT_TEST_BROWSER.
import assert from "node:assert/strict";
import { copyFile, mkdir, mkdtemp, readdir, readFile, rm } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join, normalize } from "node:path";
import { after, before, test } from "node:test";

import validator from "gltf-validator";

import { colorsOf, launch, loseGraphics, settle } from "./browser.mjs";

const { SUREFOOT_TEST_TILES: folder, SUREFOOT_TEST_BROWSER: chromium } = process.env;
const asked = [];
const complaints = [];
let browser;
let server;
let page;

before(async () => {
  server = createServer(async (request, response) => {
    asked.push(request.url);
    try {
      const path = normalize(new URL(request.url, "http://h/").pathname);
      const bytes = await readFile(join(folder, path === "/" ? "index.html" : path));
      const type = path === "/" ? "text/html" : "application/octet-stream";
      response.writeHead(200, { "Content-Type": type }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  browser = await launch(chromium);
  page = await browser.newPage();
  page.setDefaultTimeout(60_000);
  page.on("console", (message) => {
    // The library says this of every tileset of version 1.1.
    if (message.text().includes("1.1 or higher have limited support")) return;
    if (["error", "warn"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
});
after(async () => {
  await browser?.close();
  server?.close();
});

test("every tile is valid glTF", async () => {
  const tiles = await readdir(join(folder, "tiles"));
  assert.ok(tiles.length > 1);
  for (const tile of tiles) {
    const bytes = new Uint8Array(await readFile(join(folder, "tiles", tile)));
    const { issues } = await validator.validateBytes(bytes);
    assert.deepEqual(issues.messages, [], tile);
  }
});

test("draws the tiles, from afar and from nearby", async () => {
  await page.setViewport({ width: 500, height: 350 });
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForSelector("html[data-ready]");
  await settle(page);
  const far = await colorsOf(page, "#map");
  assert.ok(far.distinct > 20, `${far.distinct} colours`);
  await page.evaluate(() => {
    const { camera, controls } = window.surefootTiles;
    camera.position.lerp(controls.target, 0.85);
    controls.update();
  });
  await settle(page);
  assert.notEqual((await colorsOf(page, "#map")).text, far.text);
  assert.ok(asked.includes("/tiles/r.glb"));
  assert.match(await page.$eval("#state", ({ textContent }) => textContent), /points in \d+ tiles/);
  assert.deepEqual(complaints, []);
});

test("shows the whole map on a telephone", async () => {
  const telephone = await browser.newPage();
  await telephone.setViewport({ width: 390, height: 800 });
  await telephone.goto(`http://127.0.0.1:${server.address().port}/`);
  await telephone.waitForSelector("html[data-ready]");
  const places = await telephone.evaluate(() => {
    const { camera, tiles } = window.surefootTiles;
    const [x, y, z, ...half] = tiles.root.boundingVolume.box;
    const corners = [];
    for (const i of [-1, 1])
      for (const j of [-1, 1])
        for (const k of [-1, 1])
          corners.push([x + i * half[0], y + j * half[4], z + k * half[8]]);
    return corners.map((corner) => camera.position.clone().set(...corner).project(camera).toArray());
  });
  for (const [across, up] of places) assert.ok(Math.abs(across) < 1 && Math.abs(up) < 1, `${across} ${up}`);
  await telephone.close();
});

test("draws again when the browser gives its graphics back", async () => {
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await settle(page);
  const { text, dark } = await colorsOf(page, "#map");
  assert.ok(dark);
  await loseGraphics(page, "#map");
  assert.equal((await colorsOf(page, "#map")).text, text);
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "light" }]);
});

test("says how it is to be served where it is opened as a file", async () => {
  await page.goto(`file://${join(folder, "index.html")}`);
  const said = () => page.$eval("#state", ({ textContent }) => textContent);
  assert.match(await said(), /http\.server/);
  assert.equal(await page.$eval("html", ({ dataset }) => dataset.theme), "light");
  const odd = await mkdtemp(join(tmpdir(), "it's_"));
  await copyFile(join(folder, "index.html"), join(odd, "index.html"));
  await page.goto(`file://${odd}/index.html`);
  assert.match(await said(), /-d '[^']*it'\\''s_[^']*',/);
  const unreadable = Buffer.concat([Buffer.from(odd), Buffer.from([0x2f, 0x62, 0xe9])]);
  await mkdir(unreadable);
  await copyFile(join(folder, "index.html"), Buffer.concat([unreadable, Buffer.from("/index.html")]));
  await page.goto(`file://${odd}/b%E9/index.html`);
  assert.match(await said(), /-d FOLDER,/);
  await rm(odd, { recursive: true });
});
