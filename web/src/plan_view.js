// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The paths on a plane: from above over the shadow that the map casts, or unrolled, as height along
// the way.
import { interpolate, isBreak, nearestIndex } from "./data.js";
import { onResize } from "./dom.js";
import { isTaken } from "./loops.js";
import { axisLabel, decimalsOf, fixed, niceStep } from "./numbers.js";
import { pathShades, shadeColors } from "./path_shades.js";
import { ends } from "./path_lines.js";
import { color, runColor } from "./theme.js";

const kMargin = { left: 52, right: 14, top: 12, bottom: 40 }; // [px]
const kStay = 1; // [m] a shorter way is that of somebody who stands,
const kSurroundings = 10; // [m] of whom so much is seen from above
const kReach = 30; // [px] from the pointer to a path that it takes hold of

const strided = (values, offset) => values.filter((_, i) => i % 3 === offset);

/** x to the right, y upwards, equal scales. */
export const kFromAbove = {
  axes: ["x", "y"],
  equal: true,
  shadow: [0, 1], // axes of the map
  loops: true,
  ofRun: ({ path }) => [strided(path.positions, 0), strided(path.positions, 1)],
  ofCorrected: ({ positions }) => [strided(positions, 0), strided(positions, 1)],
  ofTruth: (truth) => [strided(truth.positions, 0), strided(truth.positions, 1)],
};

/** Height over the way, so that a ramp is one in whichever direction it leads. The truth is laid out
 * by the run's way at the same instant: a denser trajectory has another length. */
export const kAlongTheWay = {
  axes: ["way", "z"],
  equal: false,
  shadow: null,
  loops: false, // lines over the whole way say nothing
  ofRun: ({ path, lengths }) => [lengths, strided(path.positions, 2)],
  ofCorrected: ({ positions }, { lengths }) => [lengths, strided(positions, 2)],
  ofTruth: (truth, { scans, lengths }) => [
    truth.times.map((time) => interpolate(scans.times, lengths, time)),
    strided(truth.positions, 2),
  ],
};

function rangeOf(series) {
  let [low, high] = [Infinity, -Infinity];
  for (const values of series) {
    for (const value of values) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return low <= high ? [low, high] : [-1, 1];
}

function widened([low, high], share, least) {
  const middle = (low + high) / 2;
  const half = Math.max((high - low) * (0.5 + share), least / 2);
  return [middle - half, middle + half];
}

export class PlanView {
  constructor(canvas, context, projection, onStretch = () => {}) {
    this.canvas = canvas;
    this.context = context;
    this.projection = projection;
    this.onStretch = onStretch;
    this.backdrop = document.createElement("canvas");
    onResize(canvas.parentElement, () => this.setRun());
    canvas.addEventListener("pointermove", (event) => this.#hover(event));
  }

  /** Lays out axes and shadow anew; needed when run, size or theme has changed. */
  setRun() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.width = width;
    this.height = height;
    this.ratio = Math.min(devicePixelRatio, 2);
    for (const canvas of [this.canvas, this.backdrop]) {
      canvas.width = Math.round(width * this.ratio);
      canvas.height = Math.round(height * this.ratio);
    }
    this.#layOut();
    this.#drawBackdrop();
    this.draw();
  }

  #layOut() {
    const { equal, ofRun, ofCorrected, ofTruth } = this.projection;
    const { truth } = this.context.recording();
    this.places = this.context.companions().map((run) => ({ run, at: ofRun(run) }));
    const run = this.context.run();
    this.truth = truth ? ofTruth(truth, run) : null;
    this.corrected = run.corrected && ofCorrected(run.corrected, run);
    const others = [this.truth, this.corrected].filter(Boolean);
    const all = [...this.places.map(({ at }) => at), ...others];
    const inner = [
      this.width - kMargin.left - kMargin.right,
      this.height - kMargin.top - kMargin.bottom,
    ];
    const [h, v] = [0, 1].map((axis) => rangeOf(all.map((place) => place[axis])));
    const stands = equal && Math.max(h[1] - h[0], v[1] - v[0]) < kStay;
    const least = stands ? kSurroundings : 4;
    // A level floor must look level: its centimetres are not stretched to a hill.
    this.h = widened(h, equal ? 0.08 : 0.02, least);
    this.v = widened(v, equal ? 0.08 : 0.2, equal ? least : 1.5);
    if (equal) {
      const scale = Math.min(
        inner[0] / (this.h[1] - this.h[0]),
        inner[1] / (this.v[1] - this.v[0]),
      );
      this.h = widened(this.h, 0, inner[0] / scale);
      this.v = widened(this.v, 0, inner[1] / scale);
    }
    this.scale = [inner[0] / (this.h[1] - this.h[0]), inner[1] / (this.v[1] - this.v[0])];
    this.onStretch(this.scale[1] / this.scale[0]);
  }

  x(value) {
    return kMargin.left + (value - this.h[0]) * this.scale[0];
  }

  y(value) {
    return this.height - kMargin.bottom - (value - this.v[0]) * this.scale[1];
  }

  #drawBackdrop() {
    const context = this.backdrop.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.backdrop.width, this.backdrop.height);
    const map = this.context.run().map;
    if (map && this.projection.shadow) this.#drawShadow(context, map);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.#drawAxes(context);
  }

  /** How many points fall on each pixel, as ink that grows with the logarithm. */
  #drawShadow(context, map) {
    const [left, top] = [kMargin.left, kMargin.top];
    const [wide, high] = [this.width - left - kMargin.right, this.height - top - kMargin.bottom];
    const [columns, rows] = [Math.max(1, Math.floor(wide)), Math.max(1, Math.floor(high))];
    const counts = new Uint16Array(columns * rows);
    const [h, v] = this.projection.shadow;
    const [gx, gy] = [h, v].map((axis) => (map.high[axis] - map.low[axis]) / 65535);
    for (let i = 0; i < map.steps.length; i += 3) {
      const x = Math.floor(this.x(map.low[h] + gx * map.steps[i + h]) - left);
      const y = Math.floor(this.y(map.low[v] + gy * map.steps[i + v]) - top);
      if (x >= 0 && y >= 0 && x < columns && y < rows) ++counts[y * columns + x];
    }
    const [red, green, blue] = color("shadow").split(" ").map(Number);
    const image = context.createImageData(columns, rows);
    counts.forEach((count, i) => {
      const ink = count === 0 ? 0 : Math.min(40 + 34 * Math.log2(count + 1), 190);
      image.data.set([red, green, blue, ink], 4 * i);
    });
    const shadow = document.createElement("canvas");
    shadow.width = columns;
    shadow.height = rows;
    shadow.getContext("2d").putImageData(image, 0, 0);
    context.drawImage(
      shadow,
      left * this.ratio,
      top * this.ratio,
      columns * this.ratio,
      rows * this.ratio,
    );
  }

  #drawAxes(context) {
    const bottom = this.height - kMargin.bottom;
    const right = this.width - kMargin.right;
    context.font = `11px ${color("font")}`;
    context.fillStyle = color("muted");
    context.strokeStyle = color("grid");
    context.lineWidth = 1;
    const ticks = ([low, high], pixels, each) => {
      const step = niceStep(high - low, Math.max(2, pixels / 70));
      const decimals = decimalsOf(step);
      for (let k = Math.ceil(low / step); k * step <= high; ++k)
        each(k * step, fixed(k * step, decimals));
    };
    context.beginPath();
    context.textAlign = "center";
    ticks(this.h, right - kMargin.left, (value, text) => {
      context.moveTo(this.x(value), kMargin.top);
      context.lineTo(this.x(value), bottom);
      context.fillText(text, this.x(value), bottom + 15);
    });
    context.textAlign = "right";
    ticks(this.v, (bottom - kMargin.top) * 1.4, (value, text) => {
      context.moveTo(kMargin.left, this.y(value));
      context.lineTo(right, this.y(value));
      context.fillText(text, kMargin.left - 6, this.y(value) + 4);
    });
    context.stroke();
    context.textAlign = "center";
    const { origin } = this.context.recording();
    const [h, v] = this.projection.axes.map((axis) => axisLabel(axis, origin));
    context.fillText(h, (kMargin.left + right) / 2, this.height - 7);
    context.save();
    context.translate(13, (kMargin.top + bottom) / 2);
    context.rotate(-Math.PI / 2);
    context.fillText(v, 0, 0);
    context.restore();
  }

  draw() {
    if (!this.scale) return;
    const context = this.canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(this.backdrop, 0, 0);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    const run = this.context.run();
    context.lineJoin = "round";
    // A band, so that a path that agrees with it can be seen on it.
    if (this.truth) this.#line(context, this.truth, color("truth-band"), 7);
    this.places.forEach(({ run: companion, at }, place) => {
      const here = companion === run;
      const { segment: segments } = companion.scans.columns;
      if (here) this.#line(context, at, color("halo"), 4, segments);
      this.#line(context, at, runColor(place), here ? 2.2 : 1.4, segments);
      if (here) this.#shade(context, at);
    });
    this.#drawLoops(context, run);
    this.#drawMarkers(context, run);
  }

  #line(context, [h, v], style, width, segments = null) {
    context.strokeStyle = style;
    context.lineWidth = width;
    context.beginPath();
    let pen = false;
    for (let i = 0; i < h.length; ++i) {
      const missing = Number.isNaN(v[i]);
      if (isBreak(segments, i)) pen = false;
      if (!missing) context[pen ? "lineTo" : "moveTo"](this.x(h[i]), this.y(v[i]));
      pen = !missing;
    }
    context.stroke();
  }

  /** The way after all loops, and from above the places that were compared, joined: refused ones
   * thin, taken ones on top. */
  #drawLoops(context, run) {
    const [h, v] = this.#placesOf(run);
    const shown = this.projection.loops ? run.loops : [];
    const join = (loops, style, width) => {
      context.strokeStyle = style;
      context.lineWidth = width;
      context.beginPath();
      for (const { scan, place } of loops) {
        if ([h[scan], v[scan], h[place], v[place]].some(Number.isNaN)) continue;
        context.moveTo(this.x(h[place]), this.y(v[place]));
        context.lineTo(this.x(h[scan]), this.y(v[scan]));
      }
      context.stroke();
    };
    join(shown.filter((loop) => !isTaken(loop)), color("loop-refused"), 0.8);
    if (this.corrected) {
      context.setLineDash([7, 5]);
      this.#line(context, this.corrected, color("loop-taken"), 1.6);
      context.setLineDash([]);
    }
    join(shown.filter(isTaken), color("loop-taken"), 2);
  }

  /** The path that is looked at, coloured by what was chosen. */
  #shade(context, [h, v]) {
    const { segment: segments } = this.context.run().scans.columns;
    const shades = pathShades(this.context);
    if (!shades) return;
    const colors = shadeColors(shades, this.context.store.get("theme"));
    context.lineWidth = 3.2;
    for (let i = 1; i < h.length; ++i) {
      if (Number.isNaN(v[i]) || Number.isNaN(v[i - 1]) || isBreak(segments, i)) continue;
      context.strokeStyle = colors[i];
      context.beginPath();
      context.moveTo(this.x(h[i - 1]), this.y(v[i - 1]));
      context.lineTo(this.x(h[i]), this.y(v[i]));
      context.stroke();
    }
  }

  #drawMarkers(context, run) {
    const { positions } = run.path;
    const [h, v] = this.#placesOf(run);
    const mark = (index, fill, shape) => {
      if (!(index >= 0) || Number.isNaN(v[index] ?? NaN)) return;
      const [x, y] = [this.x(h[index]), this.y(v[index])];
      context.beginPath();
      if (shape === "square") context.rect(x - 5, y - 5, 10, 10);
      else context.arc(x, y, shape === "cursor" ? 6.5 : 5.5, 0, 2 * Math.PI);
      context.lineWidth = 2.5;
      context.strokeStyle = color("halo");
      context.fillStyle = color(fill);
      context.fill();
      context.stroke();
    };
    const [first, last] = ends(positions);
    mark(first, "start", "circle");
    mark(last, "end", "square");
    const cursor = this.context.store.get("cursor");
    if (cursor !== null) mark(nearestIndex(run.scans.times, cursor), "cursor", "cursor");
  }

  #placesOf(run) {
    return this.places.find(({ run: companion }) => companion === run).at;
  }

  #hover(event) {
    const { scans } = this.context.run();
    const [h, v] = this.#placesOf(this.context.run());
    let best = kReach;
    let index = -1;
    for (let i = 0; i < scans.count; ++i) {
      const distance = Math.hypot(this.x(h[i]) - event.offsetX, this.y(v[i]) - event.offsetY);
      if (distance < best) [best, index] = [distance, i];
    }
    if (index >= 0) {
      this.context.store.set("playing", false);
      this.context.store.set("cursor", scans.times[index]);
    }
  }
}
