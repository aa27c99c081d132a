// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A report as a reader meets it. Environment: SUREFOOT_TEST_REPORT, the page of one run with truth
// and map; SUREFOOT_TEST_EVALUATION, what `surefoot eval --json` says of that run;
// SUREFOOT_TEST_BARE, the page of a run without map and truth; SUREFOOT_TEST_LOOPED, the page of a run
// with a loop and a refused one; SUREFOOT_TEST_SINGLE, the page of a run of a single scan, with truth;
// SUREFOOT_TEST_BROWSER, a Chromium.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";

import { assertQuiet, colorsOf, hover, launch, loseGraphics, open, settle } from "./browser.mjs";

const report = process.env.SUREFOOT_TEST_REPORT;
const kViews = [".scene canvas", ".top canvas", ".side canvas"];
let browser;
let page; // the report, light; a test goes on where the last one ended
let complaints;
let requests;
before(async () => {
  browser = await launch(process.env.SUREFOOT_TEST_BROWSER);
  ({ page, complaints, requests } = await open(browser, report));
});
after(() => browser?.close());

const stored = (key) => page.evaluate((name) => window.surefootReport.store.get(name), key);
const times = () =>
  page.evaluate(() => Array.from(window.surefootReport.report.runs[0].scans.times));
const pictures = (views = kViews) => Promise.all(views.map((view) => colorsOf(page, view)));

test("draws every view and chart", async () => {
  for (const { distinct } of await pictures()) assert.ok(distinct >= 20, `${distinct} colours`);
  assert.equal((await page.$$(".chart:not([hidden]) canvas")).length, 12);
});

/** What is written at each axis of the charts when they are drawn anew: those of one are aligned alike. */
async function tickTexts() {
  await page.evaluate(() => {
    const texts = (window.tickTexts = new Map());
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
      if (!texts.has(this.canvas)) texts.set(this.canvas, { center: [], right: [] });
      texts.get(this.canvas)[this.textAlign]?.push(text);
      fillText.call(this, text, ...place);
    };
    window.surefootReport.store.set("axis", "distance");
  });
  await settle(page);
  const axes = await page.evaluate(() =>
    [...window.tickTexts.values()].flatMap(({ center, right }) => [center, right]),
  );
  await page.evaluate(() => window.surefootReport.store.set("axis", "time"));
  await settle(page);
  return axes;
}

test("writes whole numbers of the ticks' step at every axis", async () => {
  const axes = await tickTexts();
  assert.ok(axes.length >= 24, `${axes.length} axes`);
  for (const texts of axes) {
    const numbers = texts.map((text) => Number(text.replace("−", "-"))).filter(Number.isFinite);
    const step = numbers[1] - numbers[0];
    for (let i = 2; i < numbers.length; ++i)
      assert.ok(Math.abs(numbers[i] - numbers[i - 1] - step) < 1e-6 * step, texts.join());
  }
});

test("colours the map by height, intensity and time", async () => {
  const seen = new Set();
  for (const mode of ["height", "intensity", "time"]) {
    await page.click(`.controls label:has(input[value="${mode}"])`);
    await settle(page);
    seen.add((await colorsOf(page, ".scene canvas")).text);
  }
  assert.equal(seen.size, 3);
});

test("colours the path by its error and by what it says of itself", async () => {
  const seen = new Set();
  for (const shade of ["error", "sigma", "run"]) {
    await page.click(`.controls label:has(input[value="${shade}"])`);
    await settle(page);
    for (const { text } of await pictures()) seen.add(text);
  }
  assert.equal(seen.size, 9);
});

test("leaves the keyboard where it chooses the path's colour", async () => {
  await page.focus('.controls input[value="run"]');
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.equal(await stored("shade"), "sigma");
  await page.keyboard.press("ArrowRight"); // round
  assert.equal(await stored("shade"), "run");
});

test("gives every line of a legend its colour", async () => {
  const swatches = await page.$$eval(".chart:not([hidden]) .legend i", (all) =>
    all.map((swatch) => getComputedStyle(swatch).background),
  );
  assert.ok(swatches.length > 11);
  for (const background of swatches) assert.doesNotMatch(background, /^rgba\(0, 0, 0, 0\) none/);
});

test("shows the figures of surefoot eval", async () => {
  const [expected] = JSON.parse(await readFile(process.env.SUREFOOT_TEST_EVALUATION, "utf8"));
  const shown = await page.$$eval("#errors td[data-statistic]", (cells) =>
    cells.map(({ dataset, textContent }) => [
      dataset.error,
      dataset.statistic,
      dataset.value,
      textContent,
    ]),
  );
  assert.equal(shown.length, 7 * Object.keys(expected.errors).length);
  const caption = await page.$eval("#errors caption", (element) => element.textContent);
  assert.match(caption, /after alignment by positions and orientations/);
  for (const [error, statistic, value, text] of shown) {
    const figure = expected.errors[error][statistic];
    assert.equal(Number(value), figure, `${error} ${statistic}`);
    const rounded = Number(text.replaceAll("−", "-"));
    assert.ok(Math.abs(rounded - figure) <= 5.1e-4 * Math.abs(figure), `${text} for ${figure}`);
  }
});

test("shows sweeps as measured and as deskewed", async () => {
  const views = [".card:nth-child(1) .sweep canvas", ".card:nth-child(2) .sweep canvas"];
  const [measured, deskewed] = await pictures(views);
  assert.ok(measured.distinct >= 20 && deskewed.distinct >= 20);
  assert.notEqual(measured.text, deskewed.text);
  assert.match(
    await page.$eval(".deskewing .note", (note) => note.textContent),
    /^Scan \d+, .* by 0\.\d+ m \(RMS\)/,
  );
  await page.click(".deskewing .choice label:nth-child(2)");
  await settle(page);
  assert.notEqual((await pictures(views))[1].text, deskewed.text);
});

test("marks the instant under the pointer everywhere", async () => {
  const earlier = await pictures();
  await hover(page, await page.$(".chart .u-over"), 0.5, 0.5);
  const end = (await times()).at(-1);
  const cursor = await stored("cursor");
  assert.ok(Math.abs(cursor - end / 2) < 0.1 * end, `${cursor} of ${end} s`);
  (await pictures()).forEach(({ text }, i) => assert.notEqual(text, earlier[i].text, kViews[i]));
  const lines = await page.$$eval(".chart:not([hidden]) .u-cursor-x", (cursors) =>
    cursors.map(
      (line) => line.getBoundingClientRect().left - line.parentElement.getBoundingClientRect().left,
    ),
  );
  assert.equal(lines.length, 12);
  for (const left of lines) assert.ok(left > 20, `a cursor at ${left} px`);
  assert.match(await page.$eval(".scrubber .place", (place) => place.textContent), /^\d+\.\d\d s/);
});

test("takes hold of a path", async () => {
  await page.evaluate(() => window.surefootReport.store.set("cursor", null));
  const top = await page.$(".top canvas");
  for (let y = 0.1; y < 0.95 && (await stored("cursor")) === null; y += 0.06)
    await hover(page, top, 0.5, y);
  assert.notEqual(await stored("cursor"), null);
});

test("obeys the keys", async () => {
  await page.focus(".scrubber input");
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  assert.equal(await stored("cursor"), (await times())[1]);
});

test("draws again when the browser gives its graphics back", async () => {
  const { text } = await colorsOf(page, ".scene canvas");
  await loseGraphics(page, ".scene canvas");
  assert.equal((await colorsOf(page, ".scene canvas")).text, text);
});

test("replays the run", async () => {
  await page.click(".play");
  await settle(page);
  const early = await stored("cursor");
  await page.waitForFunction((time) => window.surefootReport.store.get("cursor") > time, {}, early);
  if (await stored("playing")) await page.click(".play");
  assert.equal(await stored("playing"), false);
});

test("charts can go along the path, and be looked at closely", async () => {
  await page.click('.controls label:has(input[value="distance"])');
  const plot = await page.$(".chart .u-over");
  await hover(page, plot, 0.3, 0.5);
  const from = await plot.boundingBox();
  await page.mouse.down();
  await page.mouse.move(from.x + 0.7 * from.width, from.y + 0.5 * from.height, { steps: 4 });
  await page.mouse.up();
  await settle(page);
  const [low, high] = await stored("range");
  const length = await page.evaluate(() => window.surefootReport.report.runs[0].lengths.at(-1));
  assert.ok(
    Math.abs(low / length - 0.3) < 0.05 && Math.abs(high / length - 0.7) < 0.05,
    `${low} to ${high} m`,
  );
});

test("is dark where it is asked to be", async () => {
  assert.equal(await page.$eval("html", (html) => html.dataset.theme), "light");
  assert.equal((await colorsOf(page, ".scene canvas")).dark, false);
  await page.focus('header .choice input[value="auto"]');
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await settle(page);
  assert.equal(await page.$eval("html", (html) => html.dataset.theme), "dark");
  assert.equal((await colorsOf(page, ".scene canvas")).dark, true);
});

test("keeps the truth's switch as it is in another theme", async () => {
  const truth = '.controls label.toggle:last-of-type input';
  await page.$eval(truth, (input) => input.click());
  await page.click('header .choice label:has(input[value="light"])');
  await settle(page);
  assert.equal(await page.$eval(truth, ({ checked }) => checked), false);
});

test("fits a telephone", async () => {
  await page.setViewport({ width: 390, height: 800 });
  await settle(page);
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `${width} px wide`);
});

test("has not complained, and asked for nothing", () => assertQuiet(complaints, requests));

test("does without map and truth", async () => {
  const opened = await open(browser, process.env.SUREFOOT_TEST_BARE);
  assert.equal((await opened.page.$$(".chart:not([hidden]) canvas")).length, 10);
  assert.equal(await opened.page.$("#errors"), null);
  const switches = await opened.page.$$eval(".controls label", (all) => all.map((l) => l.textContent));
  assert.ok(!switches.includes("Truth"), switches.join());
  assertQuiet(opened.complaints, opened.requests);
});

test("shows a single scan as a dot, in its surroundings", async () => {
  const opened = await open(browser, process.env.SUREFOOT_TEST_SINGLE);
  const [red, green, blue] = [0xcf, 0x2f, 0x5b]; // the run's colour
  const dot = await opened.page.$eval(
    ".chart:not([hidden]) canvas",
    (canvas, color) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) count += color.every((c, k) => data[i + k] === c);
      return count;
    },
    [red, green, blue],
  );
  assert.ok(dot > 4, `${dot} pixels`);
  assert.ok((await colorsOf(opened.page, ".top canvas")).distinct > 20);
  const figures = await opened.page.$eval(".figures", ({ textContent }) => textContent);
  assert.match(figures, /End drift0 mwithout a way/);
  assertQuiet(opened.complaints, opened.requests);
});

test("draws the loops of a run that closed some, and says why others were refused", async () => {
  const plain = await open(browser, report);
  const without = (await colorsOf(plain.page, ".top canvas")).text;
  assert.equal(await plain.page.$("#loops"), null);
  const opened = await open(browser, process.env.SUREFOOT_TEST_LOOPED);
  assert.notEqual((await colorsOf(opened.page, ".top canvas")).text, without);
  const rows = await opened.page.$$eval("#loops tbody tr", (all) =>
    all.map((row) => row.textContent),
  );
  assert.equal(rows.length, 2);
  assert.match(rows.join(), /taken1every question/);
  assert.match(rows.join(), /free space1something stands/);
  const legend = await opened.page.$eval(".views .legend", (list) => list.textContent);
  assert.match(legend, /after loops.*loop.*refused/);
  assertQuiet(opened.complaints, opened.requests);
});
