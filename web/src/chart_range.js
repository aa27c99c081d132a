// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How much of its values a chart shows, and which of them no line leads to.
import { quantile } from "./numbers.js";

const largest = (lines, share) => {
  const values = lines.map((line) => quantile(line.values, share)).filter(Number.isFinite);
  return values.length ? Math.max(...values) : NaN;
};

/** Where to cut values of which a few are so large that in full range all lines would lie flat,
 * and the largest one; null where there are none. What is usual of any line stays in sight. */
export function peaksOf(lines) {
  const usual = largest(lines, 0.95);
  const most = largest(lines, 1);
  return most > 3 * usual ? { top: 1.6 * usual, most } : null;
}

/** The same range, or one about a single instant. */
export const timeRange = (low, high) => (low === high ? [low - 0.5, high + 0.5] : [low, high]);

/** Places of values without a neighbour: null ends a line that has gaps, undefined is of others. */
export function loneValues(values, gaps) {
  const own = [];
  values.forEach((value, i) => {
    if (value !== undefined && (gaps || value !== null)) own.push(i);
  });
  const isThere = (k) => (values[own[k]] ?? null) !== null;
  return own.filter((_, k) => isThere(k) && !isThere(k - 1) && !isThere(k + 1));
}

/** The range of an axis for values from low to high, which are null where there are none. */
export function valueRange(spec, peaks, low, high) {
  if (spec.rows) return [-0.6, spec.rows.length - 0.4];
  if (low === null || high === null) return [0, 1];
  const top = peaks ? Math.min(high, peaks.top) : high;
  const margin = Math.max(top > low ? 0.06 * (top - low) : 0.05 * Math.abs(low), 1e-6);
  return [spec.fromZero ? Math.min(0, low) : low - margin, top + margin];
}
