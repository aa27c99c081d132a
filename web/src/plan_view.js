// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The paths on a plane, over the shadow that the map casts on it: x-y from above, x-z from the side.
import { nearestIndex } from "./data.js";
import { onResize } from "./dom.js";
import { fixed, niceStep } from "./numbers.js";
import { ends } from "./path_lines.js";
import { color, runColor } from "./theme.js";

const kMargin = { left: 52, right: 14, top: 12, bottom: 40 }; // [px]
const kReach = 30; // [px] from the pointer to a path that it takes hold of

function rangeOf(series, axis) {
  let [low, high] = [Infinity, -Infinity];
  for (const positions of series) {
    for (let i = axis; i < positions.length; i += 3) {
      if (positions[i] < low) low = positions[i];
      if (positions[i] > high) high = positions[i];
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
  /** vertical: 1 draws x-y in equal scales, 2 draws x-z with z stretched. */
  constructor(canvas, context, vertical, onStretch = () => {}) {
    this.canvas = canvas;
    this.context = context;
    this.vertical = vertical;
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
    const truth = this.context.recording().truth;
    const series = this.context.companions().map((run) => run.path.positions);
    if (truth) series.push(truth.positions);
    const inner = [
      this.width - kMargin.left - kMargin.right,
      this.height - kMargin.top - kMargin.bottom,
    ];
    this.h = widened(rangeOf(series, 0), 0.08, 4);
    this.v = widened(
      rangeOf(series, this.vertical),
      this.vertical === 1 ? 0.08 : 0.3,
      this.vertical === 1 ? 4 : 1.5,
    );
    if (this.vertical === 1) {
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
    if (map) this.#drawShadow(context, map);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.#drawAxes(context);
  }

  /** How many points fall on each pixel, as ink that grows with the logarithm. */
  #drawShadow(context, map) {
    const [left, top] = [kMargin.left, kMargin.top];
    const [wide, high] = [this.width - left - kMargin.right, this.height - top - kMargin.bottom];
    const [columns, rows] = [Math.max(1, Math.floor(wide)), Math.max(1, Math.floor(high))];
    const counts = new Uint16Array(columns * rows);
    const axes = [0, this.vertical];
    const [gx, gy] = axes.map((axis) => (map.high[axis] - map.low[axis]) / 65535);
    for (let i = 0; i < map.steps.length; i += 3) {
      const x = Math.floor(this.x(map.low[0] + gx * map.steps[i]) - left);
      const y = Math.floor(
        this.y(map.low[this.vertical] + gy * map.steps[i + this.vertical]) - top,
      );
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
      const decimals = Math.max(0, -Math.floor(Math.log10(step)));
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
    context.fillText("x [m]", (kMargin.left + right) / 2, this.height - 7);
    context.save();
    context.translate(13, (kMargin.top + bottom) / 2);
    context.rotate(-Math.PI / 2);
    context.fillText(this.vertical === 1 ? "y [m]" : "z [m]", 0, 0);
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
    const truth = this.context.recording().truth;
    context.lineJoin = "round";
    this.context.companions().forEach((companion, place) => {
      const here = companion === run;
      if (here) this.#line(context, companion.path.positions, color("halo"), 5);
      this.#line(context, companion.path.positions, runColor(place), here ? 2.2 : 1.4);
    });
    if (truth) {
      context.setLineDash([5, 4]);
      this.#line(context, truth.positions, color("truth"), 1.2);
      context.setLineDash([]);
    }
    this.#drawMarkers(context, run);
  }

  #line(context, positions, style, width) {
    context.strokeStyle = style;
    context.lineWidth = width;
    context.beginPath();
    let pen = false;
    for (let i = 0; i < positions.length; i += 3) {
      const missing = Number.isNaN(positions[i]);
      if (!missing)
        context[pen ? "lineTo" : "moveTo"](
          this.x(positions[i]),
          this.y(positions[i + this.vertical]),
        );
      pen = !missing;
    }
    context.stroke();
  }

  #drawMarkers(context, run) {
    const { positions } = run.path;
    const place = (i) => [this.x(positions[3 * i]), this.y(positions[3 * i + this.vertical])];
    const mark = (index, fill, shape) => {
      if (!(index >= 0) || Number.isNaN(positions[3 * index] ?? NaN)) return;
      const [x, y] = place(index);
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

  #hover(event) {
    const { path, scans } = this.context.run();
    let best = kReach;
    let index = -1;
    for (let i = 0; i < scans.count; ++i) {
      const distance = Math.hypot(
        this.x(path.positions[3 * i]) - event.offsetX,
        this.y(path.positions[3 * i + this.vertical]) - event.offsetY,
      );
      if (distance < best) [best, index] = [distance, i];
    }
    if (index >= 0) {
      this.context.store.set("playing", false);
      this.context.store.set("cursor", scans.times[index]);
    }
  }
}
