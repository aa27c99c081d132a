// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A report in a headless Chromium that draws without a graphics card.
import assert from "node:assert/strict";

import puppeteer from "puppeteer-core";

const kPatience = 90_000; // [ms] a busy machine starts a browser slowly

export function launch(executablePath) {
  return puppeteer.launch({
    executablePath,
    headless: "shell",
    timeout: kPatience,
    protocolTimeout: kPatience,
    args: [
      "--no-sandbox",
      "--disable-dev-shm-usage",
      "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
      "--ignore-gpu-blocklist",
    ],
  });
}

/** Opens the file, after `first` has run in it, and waits until it is shown; what it complains of, and asks the network for, is kept. */
export async function open(browser, file, { theme = "light", width = 1100, height = 800, first } = {}) {
  const page = await browser.newPage();
  page.setDefaultTimeout(kPatience);
  const complaints = [];
  const requests = [];
  page.on("console", (message) => {
    if (["error", "warn"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => requests.push(request.url().slice(0, 80)));
  if (first) await page.evaluateOnNewDocument(first);
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: theme }]);
  await page.goto(`file://${file}`);
  await page.waitForSelector("html[data-ready]");
  await settle(page);
  return { page, complaints, requests };
}

/** No complaint, and nothing asked of the network: the file itself is all. */
export function assertQuiet(said, asked) {
  assert.deepEqual(said, []);
  assert.deepEqual(
    asked.filter((url) => !/^(file|data):/.test(url)),
    [],
  );
  assert.equal(asked.filter((url) => url.startsWith("file:")).length, 1);
}

/** Lets the frames be drawn that are due. */
export function settle(page) {
  return page.evaluate(
    () =>
      new Promise((done) =>
        requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 100))),
      ),
  );
}

/** How many different colours a canvas shows, whether most of it is dark, and its whole content. */
export function colorsOf(page, selector) {
  return page.$eval(selector, (canvas) => {
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    const bytes = context.getImageData(0, 0, copy.width, copy.height).data;
    const pixels = new Uint32Array(bytes.buffer);
    const bright = pixels.filter((pixel) => (pixel & 255) > 128).length;
    return {
      distinct: new Set(pixels).size,
      dark: bright < pixels.length / 2,
      text: copy.toDataURL(),
    };
  });
}

/** Moves the pointer over an element, at shares of its size. */
export async function hover(page, element, x, y) {
  await element.scrollIntoView();
  const box = await element.boundingBox();
  await page.mouse.move(box.x + x * box.width, box.y + y * box.height, { steps: 3 });
  await settle(page);
}

/** Takes a canvas its graphics, as a browser may at any time, and gives them back. */
export async function loseGraphics(page, selector) {
  const extension = await page.evaluateHandle(
    (at) => document.querySelector(at).getContext("webgl2").getExtension("WEBGL_lose_context"),
    selector,
  );
  await extension.evaluate((context) => context.loseContext());
  await settle(page);
  await extension.evaluate((context) => context.restoreContext());
  await settle(page);
}
