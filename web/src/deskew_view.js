// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Sweeps as they were measured and as they were deskewed, beside each other: a slice at the
// sensor's height, seen from above over the same slice of the map.
import { choice, el, onResize } from "./dom.js";
import { fixed, niceStep, quantile, significant } from "./numbers.js";
import { paletteBytes, paletteGradient } from "./palette.js";
import { color } from "./theme.js";

const kSlice = [-0.2, 0.8]; // [m] about the sensor: walls, and no ground beneath a small robot
const kShown = 0.8; // share of the slice's points that are in view

/** How far deskewing moved the points [m]: root mean square and the most. */
export function moved({ measured, deskewed }) {
  let [sum, most] = [0, 0];
  for (let i = 0; i < measured.length; i += 3) {
    const step = Math.hypot(...[0, 1, 2].map((axis) => deskewed[i + axis] - measured[i + axis]));
    sum += step * step;
    most = Math.max(most, step);
  }
  return { rms: Math.sqrt((3 * sum) / measured.length), most };
}

class SliceView {
  constructor(canvas, context, kind) {
    this.canvas = canvas;
    this.context = context;
    this.kind = kind;
    onResize(canvas.parentElement, () => this.draw());
  }

  show(sample) {
    this.sample = sample;
    this.draw();
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!this.sample || width === 0 || height === 0) return;
    const ratio = Math.min(devicePixelRatio, 2);
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const canvas = this.canvas.getContext("2d");
    canvas.setTransform(ratio, 0, 0, ratio, 0, 0);
    canvas.clearRect(0, 0, width, height);
    const run = this.context.run();
    const at = run.path.positions.subarray(3 * this.sample.scan, 3 * this.sample.scan + 3);
    const inSlice = (z) => z - at[2] > kSlice[0] && z - at[2] < kSlice[1];
    const scale = Math.min(width, height) / (2 * this.#reach(at, inSlice));
    const x = (value) => width / 2 + (value - at[0]) * scale;
    const y = (value) => height / 2 - (value - at[1]) * scale;
    this.#drawMap(canvas, run.map, x, y, inSlice);
    this.#drawSweep(canvas, x, y, inSlice);
    this.#drawScale(canvas, width, height, scale);
  }

  /** [m] The same for both views, so that they can be compared. */
  #reach(at, inSlice) {
    const { deskewed } = this.sample;
    const ranges = [];
    for (let i = 0; i < deskewed.length; i += 3) {
      if (!inSlice(deskewed[i + 2])) continue;
      ranges.push(Math.hypot(deskewed[i] - at[0], deskewed[i + 1] - at[1]));
    }
    return Math.max(quantile(ranges, kShown) || 10, 3);
  }

  #drawMap(canvas, map, x, y, inSlice) {
    if (!map) return;
    const at = (i, axis) =>
      map.low[axis] + (map.steps[i + axis] / 65535) * (map.high[axis] - map.low[axis]);
    canvas.fillStyle = `rgb(${color("shadow")} / 0.35)`;
    for (let i = 0; i < map.steps.length; i += 3) {
      if (inSlice(at(i, 2))) canvas.fillRect(x(at(i, 0)) - 1, y(at(i, 1)) - 1, 2, 2);
    }
  }

  #drawSweep(canvas, x, y, inSlice) {
    const points = this.sample[this.kind];
    const palette = paletteBytes(this.context.store.get("theme"));
    this.sample.times.forEach((time, i) => {
      if (!inSlice(points[3 * i + 2])) return;
      const [red, green, blue] = palette.subarray(4 * time, 4 * time + 3);
      canvas.fillStyle = `rgb(${red} ${green} ${blue})`;
      canvas.fillRect(x(points[3 * i]) - 1, y(points[3 * i + 1]) - 1, 2, 2);
    });
  }

  #drawScale(canvas, width, height, scale) {
    const length = niceStep(width / scale / 5, 1);
    canvas.fillStyle = color("muted");
    canvas.fillRect(12, height - 14, length * scale, 2);
    canvas.font = `11px ${color("font")}`;
    canvas.fillText(`${significant(length, 2)} m`, 12, height - 20);
  }
}

export function addDeskewing(page, context) {
  if (!context.report.runs.some((run) => run.deskewing.length > 0)) return;
  const kinds = [
    ["measured", "As measured"],
    ["deskewed", "Deskewed"],
  ];
  const controls = el("div.controls", { role: "group", "aria-label": "Sweep" });
  const note = el("p.note");
  const bar = el("i.palette");
  const views = [];
  const cards = kinds.map(([kind, title]) => {
    const canvas = el("canvas", { role: "img", "aria-label": `A sweep from above, ${title}` });
    const holder = el("div.canvas.sweep", {}, canvas);
    views.push(new SliceView(canvas, context, kind));
    return el("figure.card", {}, el("figcaption", {}, el("h3", {}, title)), holder);
  });
  const section = el(
    "section.deskewing",
    { "aria-labelledby": "deskewing-title" },
    el("div.heading", {}, el("h2", { id: "deskewing-title" }, "Within a sweep"), controls),
    note,
    el("div.pair-of-views", {}, ...cards),
    el("div.colours", {}, el("span", {}, "first point"), bar, el("span", {}, "last")),
  );
  page.append(section);
  const show = (sample) => {
    const { rms, most } = moved(sample);
    const time = context.run().scans.times[sample.scan];
    note.textContent =
      `Scan ${sample.scan}, ${fixed(time, 1)} s after the start: deskewing moves its points by ` +
      `${significant(rms, 2)} m (RMS), ${significant(most, 2)} m at most. One metre about the ` +
      "sensor's height, over the map in grey; of the run's sweeps with most motion.";
    views.forEach((view) => view.show(sample));
  };
  context.store.watch(["run"], () => {
    const samples = context.run().deskewing;
    section.hidden = samples.length === 0;
    if (section.hidden) return;
    const names = samples.map((sample, i) => [String(i), `Scan ${sample.scan}`]);
    controls.replaceChildren(choice("Sweep", names, "0", (i) => show(samples[Number(i)])));
    show(samples[0]);
  });
  context.store.watch(["theme"], () => {
    bar.style.background = paletteGradient(context.store.get("theme"));
    views.forEach((view) => view.draw());
  });
}
