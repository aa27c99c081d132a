// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The page of `surefoot check` on a telephone. Environment: SUREFOOT_TEST_CHECK, that page of a
// recording that is not fit; SUREFOOT_TEST_BROWSER, a Chromium.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { launch } from "./browser.mjs";

let browser;
let page;
before(async () => {
  browser = await launch(process.env.SUREFOOT_TEST_BROWSER);
  page = await browser.newPage();
  await page.setViewport({ width: 390, height: 800 });
  await page.goto(`file://${process.env.SUREFOOT_TEST_CHECK}`);
});
after(() => browser?.close());

test("breaks no word, and is no wider than the screen", async () => {
  // Of each word the boxes that it fills: one a line.
  const words = await page.$$eval("th, td:first-child", (cells) =>
    cells.map((cell) => {
      const range = document.createRange();
      range.selectNodeContents(cell);
      return [cell.textContent, range.getClientRects().length];
    }),
  );
  assert.ok(words.some(([word]) => word === "suffers"));
  for (const [word, lines] of words) assert.ok(lines <= 1, `${word} on ${lines} lines`);
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `${width} px wide`);
});

test("writes at the charts what can be read and lies on the page", async () => {
  const texts = await page.$$eval("svg text", (all) =>
    all.map((text) => [text.textContent, text.getBoundingClientRect().toJSON()]),
  );
  assert.ok(texts.length > 20);
  for (const [text, { left, right, height }] of texts) {
    assert.ok(height >= 12, `${text}: ${height} px high`);
    assert.ok(left >= 0 && right <= 390, `${text}: from ${left} to ${right}`);
  }
});
