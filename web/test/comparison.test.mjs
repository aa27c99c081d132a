// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The page of several runs beside each other. Environment: SUREFOOT_TEST_COMPARISON, the page of two
// runs of one recording; SUREFOOT_TEST_BROWSER, a Chromium.
import assert from "node:assert/strict";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { assertQuiet, colorsOf, hover, launch, open, settle } from "./browser.mjs";

let browser;
before(async () => (browser = await launch(process.env.SUREFOOT_TEST_BROWSER)));
after(() => browser?.close());

/** Two maps beside each other: whoever turns one turns the other. */
async function turnsBoth(comparison) {
  const maps = [".card:nth-child(1) .one-map canvas", ".card:nth-child(2) .one-map canvas"];
  const both = () => Promise.all(maps.map((map) => colorsOf(comparison, map)));
  const earlier = await both();
  for (const { distinct } of earlier) assert.ok(distinct >= 20, `${distinct} colours`);
  await hover(comparison, await comparison.$(maps[0]), 0.5, 0.5);
  const box = await (await comparison.$(maps[0])).boundingBox();
  await comparison.mouse.down();
  await comparison.mouse.move(box.x + 0.8 * box.width, box.y + 0.5 * box.height, { steps: 4 });
  await comparison.mouse.up();
  await settle(comparison);
  (await both()).forEach(({ text }, i) => assert.notEqual(text, earlier[i].text, maps[i]));
}

test("shows several runs beside each other, dark where the system is", async () => {
  const opened = await open(browser, process.env.SUREFOOT_TEST_COMPARISON, { theme: "dark" });
  const comparison = opened.page;
  assert.equal(await comparison.$eval("html", (html) => html.dataset.theme), "dark");
  assert.equal((await comparison.$$(".chosen .choice label")).length, 2);
  await comparison.click(".chosen .choice label:nth-child(2)");
  await settle(comparison);
  assert.equal(await comparison.evaluate(() => window.surefootReport.store.get("run")), 1);
  assert.ok(await comparison.$('td[data-place="1"]'));
  await turnsBoth(comparison);
  const first = ".card:nth-child(1) .one-map canvas";
  const { text } = await colorsOf(comparison, first);
  await comparison.click('.controls label:has(input[value="sigma"])');
  await settle(comparison);
  assert.notEqual((await colorsOf(comparison, first)).text, text);
  assertQuiet(opened.complaints, opened.requests);
});

test("says once that there is no WebGL", async () => {
  const { page: plain } = await open(browser, process.env.SUREFOOT_TEST_COMPARISON, {
    first: () => {
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...more);
      };
    },
  });
  assert.equal((await plain.$$(".failure")).length, 1);
  assert.equal(await plain.$eval(".side-by-side", (section) => section.hidden), true);
});

/** The page of two runs with other data. */
async function openChanged(change) {
  const folder = await mkdtemp(join(tmpdir(), "surefoot_report_"));
  const text = await readFile(process.env.SUREFOOT_TEST_COMPARISON, "utf8");
  const changed = text.replace(
    /(id="report-data">)([^<]*)/,
    (_, tag, data) => tag + JSON.stringify(change(JSON.parse(data))),
  );
  await writeFile(join(folder, "changed.html"), changed);
  const opened = await open(browser, join(folder, "changed.html"));
  await rm(folder, { recursive: true });
  return opened;
}

test("fits a telephone where runs have long names", async () => {
  const name = `paper${"+vertical.distance_decay=0.05".repeat(4)}`;
  const { page: named } = await openChanged(({ runs, ...more }) => ({
    ...more,
    runs: runs.map((run, i) => (i === 1 ? { ...run, name } : run)),
  }));
  await named.setViewport({ width: 390, height: 800 });
  await settle(named);
  const width = await named.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `${width} px wide`);
});

test("compares times alone where there is no truth", async () => {
  const { page: untold } = await openChanged(({ runs, ...more }) => ({
    ...more,
    runs: runs.map(({ evaluation, ...run }) => run),
  }));
  const heads = await untold.$$eval(".tables .table:first-child thead th", (all) =>
    all.map(({ textContent }) => textContent),
  );
  assert.deepEqual(heads, ["Run", "median [ms]", "p99 [ms]", "untrusted"]);
});

test("leaves the keyboard where it chooses the recording", async () => {
  const { page: chosen } = await openChanged(({ recordings, runs, ...more }) => {
    const apart = runs.map((run, i) => ({ ...run, recording: i }));
    const named = ["one", "another"].map((name) => ({ ...recordings[0], name }));
    return { ...more, recordings: named, runs: apart };
  });
  await chosen.focus(".chosen select");
  for (const [key, run] of [
    ["ArrowDown", 1],
    ["ArrowUp", 0],
  ]) {
    await chosen.keyboard.press(key);
    assert.equal(await chosen.evaluate(() => window.surefootReport.store.get("run")), run);
  }
});
