// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One chart: uPlot with this page's axes, shading, legend and cursor.
import uPlot from "uplot";

import { loneValues, peaksOf, timeRange, valueRange } from "./chart_range.js";
import { interpolate, nearestIndex } from "./data.js";
import { el } from "./dom.js";
import { decimalsOf, fixed, quantile, significant } from "./numbers.js";
import { gradedSpans } from "./status.js";
import { color } from "./theme.js";

const kHeight = 168; // [px]

/** Lines with times of their own as one table; equal places on the axis share a row. */
function joined(lines, axis) {
  const tables = lines.map(({ times, values }) => {
    const xs = new Float64Array(times.length);
    let last = -Infinity;
    times.forEach((time, i) => (xs[i] = last = Math.max(axis.at(time), last + 1e-7)));
    return [xs, Array.from(values, (value) => (Number.isFinite(value) ? value : null))];
  });
  return tables.length === 1 ? tables[0] : uPlot.join(tables);
}

function shade(plot, spans, axis) {
  const { ctx: context, bbox } = plot;
  context.save();
  context.beginPath();
  context.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  context.clip();
  for (const { grade, from, to } of spans) {
    const left = plot.valToPos(axis.at(from), "x", true);
    const right = plot.valToPos(axis.at(to), "x", true);
    context.fillStyle = color(`shade-${grade}`);
    context.fillRect(left, bbox.top, Math.max(right - left, devicePixelRatio), bbox.height);
  }
  context.restore();
}

function seriesOf({ label, stroke, width, fill, dash, dots = false, gaps = dots }) {
  const lone = (plot, series) => (dots ? null : loneValues(plot.data[series], gaps));
  const points = { show: dots, filter: lone, size: 4, width: 0, fill: stroke };
  return { label, stroke, width, fill, dash, points, spanGaps: !gaps };
}

/** All that a tick's place has: rounded, neighbours would read alike; in no language but the page's. */
const tickTexts = (_plot, splits, _axis, _space, step) =>
  splits.map((value) => fixed(value, decimalsOf(step)));

function axisStyle(more) {
  return {
    values: tickTexts,
    stroke: color("muted"),
    font: `11px ${color("font")}`,
    labelFont: `11px ${color("font")}`,
    grid: { stroke: color("grid"), width: 1 },
    ticks: { show: false },
    ...more,
  };
}

const valueAxis = (unit) => ({
  label: unit,
  labelSize: 16,
  labelGap: 0,
  size: (_, texts) => Math.max(46, 8 + 6.5 * Math.max(...(texts ?? []).map(({ length }) => length))),
});

/** Words in place of numbers. */
const rowAxis = (rows) => ({
  size: 62,
  splits: () => rows.map((_, i) => i),
  values: (_, splits) => splits.map((i) => rows[i]),
});

/** The way back to the whole from what was dragged over. */
export function showAll(store) {
  const button = el("button", { type: "button" }, "Show all");
  button.addEventListener("click", () => store.set("range", null));
  store.watch(["range"], () => (button.hidden = store.get("range") === null));
  return button;
}

export class ChartPanel {
  constructor(spec, context) {
    this.spec = spec;
    this.context = context;
    this.legend = el("ul.legend");
    this.holder = el("div.plot");
    this.note = el("p.note");
    this.element = el(
      "figure.card.chart",
      {},
      el("figcaption", {}, el("h3", {}, spec.title), this.note, this.legend),
      this.holder,
    );
    new ResizeObserver(() => this.#resize()).observe(this.holder);
  }

  /** Draws anew for another run, axis or theme. Without lines the panel hides. */
  update(axis) {
    this.plot?.destroy();
    this.plot = null;
    this.axis = axis;
    this.lines = this.spec.lines(this.context).filter(({ times }) => times.length > 0);
    this.element.hidden = this.lines.length === 0;
    if (this.element.hidden) return;
    this.peaks = this.spec.cut ? peaksOf(this.lines) : null;
    this.#describe();
    const spans = gradedSpans(this.context.run());
    this.plot = new uPlot(this.#options(spans), joined(this.lines, axis), this.holder);
    this.showCursor();
  }

  /** Somebody drags over it: drawn anew it would lose where that began. */
  get isHeld() {
    return (this.plot?.select.width ?? 0) > 0;
  }

  #options(spans) {
    const { spec, lines, peaks, axis, context } = this;
    return {
      width: Math.max(this.holder.clientWidth, 200),
      height: kHeight,
      legend: { show: false },
      padding: [8, 16, 0, 0],
      cursor: { y: false, points: { show: false }, drag: { x: true, y: false, setScale: false } },
      scales: {
        x: { time: false, range: (plot, low, high) => context.store.get("range") ?? timeRange(low, high) },
        y: { range: (plot, low, high) => valueRange(spec, peaks, low, high) },
      },
      axes: [
        axisStyle({ label: axis.label, labelSize: 16, labelGap: -2, size: 26 }),
        axisStyle(spec.rows ? rowAxis(spec.rows) : valueAxis(spec.unit)),
      ],
      series: [{}, ...lines.map(seriesOf)],
      hooks: {
        drawAxes: [(plot) => shade(plot, spans, axis)],
        setCursor: [(plot) => this.#moved(plot)],
        setSelect: [(plot) => this.#selected(plot)],
      },
    };
  }

  /** For those who do not see the chart. */
  #describe() {
    const { title, unit } = this.spec;
    const parts = this.lines.map(({ label, own, values, told }) => {
      if (told) return `${label} in ${told}`;
      const numbers = own ?? values;
      return `${label} median ${significant(quantile(numbers, 0.5), 3)}, largest ${significant(quantile(numbers, 1), 3)}`;
    });
    this.holder.setAttribute("role", "img");
    this.holder.setAttribute(
      "aria-label",
      `${title} ${unit} over ${this.axis.label}: ${parts.join("; ")}`,
    );
    this.note.textContent = this.peaks
      ? `Peaks up to ${significant(this.peaks.most, 3)} are cut off.`
      : "";
  }

  #resize() {
    if (this.plot && this.holder.clientWidth > 0) {
      this.plot.setSize({ width: this.holder.clientWidth, height: kHeight });
    }
  }

  /** The pointer is over this chart: its place becomes everyone's. */
  #moved(plot) {
    if (!plot.cursor.event || plot.cursor.left < 0) return;
    const time = this.axis.back(plot.posToVal(plot.cursor.left, "x"));
    this.context.store.set("playing", false);
    this.context.store.set("cursor", time);
  }

  #selected(plot) {
    const { left, width } = plot.select;
    plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
    if (width < 4) return;
    const range = [plot.posToVal(left, "x"), plot.posToVal(left + width, "x")];
    this.context.store.set("range", range);
  }

  showRange() {
    if (!this.plot) return;
    const xs = this.plot.data[0];
    const [min, max] = this.context.store.get("range") ?? timeRange(xs[0], xs.at(-1));
    this.plot.setScale("x", { min, max });
  }

  showCursor() {
    if (!this.plot) return;
    const cursor = this.context.store.get("cursor");
    const left = cursor === null ? -10 : this.plot.valToPos(this.axis.at(cursor), "x");
    if (Math.abs(left - this.plot.cursor.left) > 0.5) this.plot.setCursor({ left, top: 0 }, false);
    const entries = this.lines.map((line) => {
      const swatch = el("i.line");
      swatch.style.background = line.stroke;
      if (line.dash) swatch.className = "line dashed";
      const value = cursor === null ? "" : significant(this.#valueAt(line, cursor), 3);
      return el("li", {}, swatch, line.label, el("b", {}, line.told ?? value));
    });
    this.legend.replaceChildren(...entries);
  }

  #valueAt({ times, values, own }, time) {
    if (time < times[0] - 0.5 || time > times.at(-1) + 0.5) return NaN;
    if (this.spec.fromZero) return (own ?? values)[nearestIndex(times, time)];
    return interpolate(times, values, time);
  }
}
