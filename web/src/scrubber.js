// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The bar at the bottom: moves the instant that all views mark, by mouse, keys or by itself.

import { nearestIndex } from "./data.js";
import { el } from "./dom.js";
import { fixed } from "./numbers.js";
import { describeStatus, gradeOf } from "./status.js";

const kReplaySeconds = 20; // a whole run takes this long

function describe(run, index) {
  const place = Array.from(run.path.positions.subarray(3 * index, 3 * index + 3));
  const [x, y, z] = place.map((value) => fixed(value, 2));
  return `${fixed(run.scans.times[index], 2)} s · ${fixed(run.lengths[index], 1)} m · x ${x}, y ${y}, z ${z} m`;
}

/** Moves the cursor with the frames until the end of the run. */
function makePlayer({ store, run }) {
  let last = 0;
  const step = (now) => {
    if (!store.get("playing")) return;
    const times = run().scans.times;
    const end = times.at(-1);
    const speed = (end - times[0]) / kReplaySeconds;
    const time = store.get("cursor") + speed * Math.min((now - last) / 1000, 0.2);
    last = now;
    store.set("cursor", Math.min(time, end));
    if (time >= end) store.set("playing", false);
    else requestAnimationFrame(step);
  };
  return () => {
    const times = run().scans.times;
    const cursor = store.get("cursor");
    if (cursor === null || cursor >= times.at(-1)) store.set("cursor", times[0]);
    last = performance.now();
    requestAnimationFrame(step);
  };
}

export function addScrubber(page, context) {
  const { store } = context;
  const play = el("button.play", { type: "button" });
  const slider = el("input", { type: "range", min: 0, step: 1, "aria-label": "Scan" });
  const place = el("span.place");
  const status = el("span.status");
  const bar = el(
    "div.scrubber",
    { role: "group", "aria-label": "Instant" },
    play,
    slider,
    el("output", {}, place, status),
  );
  page.append(bar);
  const start = makePlayer(context);
  play.addEventListener("click", () => store.set("playing", !store.get("playing")));
  slider.addEventListener("input", () => {
    store.set("playing", false);
    store.set("cursor", context.run().scans.times[Number(slider.value)]);
  });
  store.watch(["playing"], () => {
    const playing = store.get("playing");
    play.textContent = playing ? "Pause" : "Replay";
    if (playing) start();
  });
  store.watch(["run", "cursor"], () => {
    const run = context.run();
    bar.hidden = run.scans.count < 2;
    if (bar.hidden) return;
    const cursor = store.get("cursor");
    const index = cursor === null ? 0 : nearestIndex(run.scans.times, cursor);
    slider.max = run.scans.count - 1;
    slider.value = index;
    const text =
      cursor === null ? "Hover a chart or a path, or move this slider" : describe(run, index);
    slider.setAttribute("aria-valuetext", text);
    place.textContent = text;
    status.textContent = cursor === null ? "" : describeStatus(run, index);
    status.dataset.grade = gradeOf(run, index);
  });
}
