// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A live run as who looks at it meets it. Environment: SUREFOOT_TEST_PROGRAM, the program;
// SUREFOOT_TEST_WALK, a bag; SUREFOOT_TEST_BROWSER, a Chromium.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { colorsOf, hover, launch, settle } from "./browser.mjs";

const { SUREFOOT_TEST_PROGRAM: program, SUREFOOT_TEST_WALK: walk } = process.env;
const folder = mkdtempSync(join(tmpdir(), "surefoot_live_"));
let browser;
let run; // the program
let address; // of the page, with the token
let page;
const complaints = [];
const requests = [];

/** The address that the program says its page has. */
function started(child) {
  return new Promise((resolve, reject) => {
    let said = "";
    child.stderr.on("data", (bytes) => {
      said += bytes;
      const found = said.match(/page: (http:\S+)\n/);
      if (found) resolve(found[1]);
    });
    child.on("exit", () => reject(new Error(said)));
  });
}

async function open(url) {
  const opened = await browser.newPage();
  opened.setDefaultTimeout(60_000);
  opened.on("console", (message) => {
    if (["error", "warn"].includes(message.type())) complaints.push(message.text());
  });
  opened.on("pageerror", (error) => complaints.push(error.message));
  opened.on("request", (request) => requests.push(request.url()));
  opened.on("dialog", (dialog) => dialog.accept());
  await opened.setViewport({ width: 1100, height: 900 });
  await opened.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "light" }]);
  await opened.goto(url);
  return opened;
}

before(async () => {
  execFileSync(program, ["map", walk, "-o", "map", "--no-report", "--no-picture", "-q"], { cwd: folder });
  run = spawn(
    program,
    [
      "live",
      "--replay",
      walk,
      "--speed",
      "0.06",
      "--page",
      "0",
      "-o",
      "run",
      "--localize",
      "map",
      "--no-report",
      "--no-picture",
    ],
    { cwd: folder },
  );
  run.stdout.resume();
  address = await started(run);
  browser = await launch(process.env.SUREFOOT_TEST_BROWSER);
  page = await open(address);
  await page.waitForSelector("html[data-ready]");
});
after(async () => {
  await browser?.close();
  run?.kill("SIGKILL");
  rmSync(folder, { recursive: true, force: true });
});

/** Waits until it is so of the run as the page has it. */
const until = (condition) => page.waitForFunction(condition, { polling: 100 });
const press = async (command, answer) => {
  await page.click(`button[data-command="${command}"]`);
  await page.waitForFunction(
    (text) => document.querySelector(".chosen .note").textContent.includes(text),
    { polling: 100 },
    answer,
  );
};

test("draws map, path and charts, and goes on drawing", async () => {
  await until(() => window.surefootLive.live.run.scans.count >= 3);
  await until(() => document.querySelectorAll(".chart:not([hidden]) canvas").length === 2);
  await page.evaluate(() => new Promise((done) => setTimeout(done, 800)));
  await settle(page);
  const first = await colorsOf(page, ".scene canvas");
  assert.ok(first.distinct >= 20, `${first.distinct} colours`);
  const points = await page.evaluate(() => window.surefootLive.live.run.map.total);
  await page.waitForFunction((least) => window.surefootLive.live.run.map.total > least, {}, points);
  await page.evaluate(() => new Promise((done) => setTimeout(done, 1200)));
  await settle(page);
  assert.notEqual((await colorsOf(page, ".scene canvas")).text, first.text);
});

test("shows the figures", async () => {
  const texts = await page.$$eval(".figure dd[data-key]", (all) =>
    Object.fromEntries(all.map((one) => [one.dataset.key, one.textContent])),
  );
  assert.match(texts.status, /^(ok|first scan)$/);
  assert.match(texts.pose, /^−?\d+\.\d\d, −?\d+\.\d\d, −?\d+\.\d\d$/);
  assert.match(texts.way, /^\d+\.\d m$/);
  assert.match(texts.latency, /^\d+\.\d ms$/);
  assert.match(texts.scans, /^\d+$/);
  assert.match(texts.wrong, /^(–|0|[01]\.\d+|\d\.\d+e-\d+)$/);
  assert.equal(await page.$eval("h1", ({ textContent }) => textContent), "walk.mcap");
});

test("shows a part of the charts closely, and all of them again", async () => {
  const range = () => page.evaluate(() => window.surefootLive.store.get("range"));
  const [button] = await page.$$("section .heading .controls button");
  assert.equal(await button.isVisible(), false);
  const plot = await page.$(".chart .plot");
  await hover(page, plot, 0.3, 0.5);
  const { x, y, width, height } = await plot.boundingBox();
  await page.mouse.down();
  await page.mouse.move(x + 0.5 * width, y + 0.5 * height);
  await page.evaluate(() => new Promise((done) => setTimeout(done, 2500))); // it is not drawn anew
  await page.mouse.move(x + 0.7 * width, y + 0.5 * height);
  await page.mouse.up();
  await settle(page);
  assert.equal((await range()).length, 2);
  await button.click();
  assert.equal(await range(), null);
  await hover(page, plot, 0.3, 0.5); // a slip of the hand is no choice, and holds nothing
  await page.mouse.down();
  await page.mouse.move(x + 0.3 * width + 2, y + 0.5 * height);
  await page.mouse.up();
  await settle(page);
  assert.equal(await plot.$eval(".u-select", (select) => select.offsetWidth), 0);
  assert.equal(await range(), null);
  assert.equal(await button.isVisible(), false);
});

test("keeps the token to itself", async () => {
  assert.doesNotMatch(page.url(), /token/);
  const stranger = await (await browser.createBrowserContext()).newPage();
  await stranger.goto(address.replace(/#.*/, ""));
  await stranger.waitForSelector("html[data-ready]");
  assert.equal((await stranger.$$("button[data-command]")).length, 0);
  assert.match(await stranger.$eval(".chosen", ({ textContent }) => textContent), /look at only/);
  await stranger.goto(address); // in the same tab
  await stranger.waitForSelector("button[data-command]");
  await stranger.close();
});

test("saves the map", async () => {
  await press("save_map", "map.ply");
  assert.ok(statSync(join(folder, "run", "map.ply")).size > 1000);
});

test("takes the token of the address that is opened in its tab", async () => {
  await page.evaluate(() => (location.hash = "token=of-an-earlier-run"));
  await press("pause", "token is missing or wrong");
  assert.doesNotMatch(page.url(), /token/);
  complaints.length = 0; // the browser tells of every refusal
  await page.goto(address);
  await press("save_map", "map.ply");
});

test("searches for its place in the map", async () => {
  await press("localize", "its place in the map is searched for");
});

test("pauses and goes on", async () => {
  await press("pause", "scans are left out");
  await until(() => document.querySelector('[data-command="pause"]').textContent === "Resume");
  await until(() => window.surefootLive.live.state.figures.left_out > 0);
  await press("pause", "scans are used");
  const { used } = await page.evaluate(() => window.surefootLive.live.state.figures);
  await page.waitForFunction(
    (before) => window.surefootLive.live.state.figures.used > before,
    {},
    used,
  );
});

test("begins anew", async () => {
  await press("reset", "begins anew");
  await until(() => window.surefootLive.live.state.scan.segment === 1);
});

test("says so when the run has ended", async () => {
  assert.deepEqual(complaints, []);
  assert.deepEqual(
    requests.filter((url) => !/^(http:\/\/127\.0\.0\.1:|data:)/.test(url)),
    [],
  );
  run.kill("SIGTERM");
  await page.waitForFunction(() => /ended/.test(document.querySelector(".subtitle").textContent));
  await new Promise((done) => (run.exitCode === null ? run.on("exit", done) : done()));
  assert.equal(run.exitCode, 0);
  assert.ok(existsSync(join(folder, "run", "run.yaml")));
});
