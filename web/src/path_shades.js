// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The path that is looked at, coloured by a quantity of each scan: its error against the truth, or
// how uncertain it says it is.
import { interpolate } from "./data.js";
import { quantile } from "./numbers.js";
import { paletteBytes } from "./palette.js";

const kPeak = 0.99; // of the values; the rest has the last colour

function errorsOf({ errors, scans }) {
  if (!errors) return null;
  return scans.times.map((time) => interpolate(errors.times, errors.translation_m, time));
}

/** The standard deviation of the position, all axes together [m]. */
export function positionSigma({ scans: { columns, count } }) {
  const axes = ["sigma_x_m", "sigma_y_m", "sigma_z_m"].map((name) => columns[name]);
  if (!axes.every(Boolean)) return null;
  return Float32Array.from({ length: count }, (_, i) => Math.hypot(...axes.map((axis) => axis[i])));
}

const kShades = {
  error: { label: "Error", values: errorsOf },
  sigma: { label: "Sigma", values: positionSigma },
};

/** What this run's path can be coloured by: [["run", "Run"], ["error", "Error"], ...]. */
export function shadeChoices(run) {
  const there = Object.entries(kShades).filter(([, { values }]) => values(run));
  return [["run", "Run"], ...there.map(([key, { label }]) => [key, label])];
}

/** Per scan a number [m] and the range of the colours; null where the run's own colour is chosen. */
export function pathShades({ store, run }) {
  const values = kShades[store.get("shade")]?.values(run());
  return values ? { values, low: 0, high: quantile(values, kPeak) || 1e-3 } : null;
}

/** A colour for each scan. */
export function shadeColors({ values, low, high }, theme) {
  const palette = paletteBytes(theme);
  return Array.from(values, (value) => {
    const share = Math.min(Math.max((value - low) / (high - low), 0), 1);
    const at = 4 * Math.round(255 * (Number.isFinite(share) ? share : 0));
    return `rgb(${palette[at]}, ${palette[at + 1]}, ${palette[at + 2]})`;
  });
}
