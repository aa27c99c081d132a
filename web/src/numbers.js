// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Numbers as they are read.

/** With so many significant digits, without an exponent where that can be avoided. */
export function significant(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-5 || size >= 1e6) return value.toExponential(digits - 1);
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return value.toFixed(Math.min(decimals, 12)).replace("-", "−");
}

export function fixed(value, decimals) {
  return Number.isFinite(value) ? value.toFixed(decimals).replace("-", "−") : "–";
}

export function grouped(value) {
  return Math.round(value).toLocaleString("en-US").replaceAll(",", "\u202f");
}

/** The value at this share of the ordered ones, as surefoot run prints it. */
export function quantile(values, share) {
  const ordered = Float64Array.from(values.filter(Number.isFinite)).sort();
  // The nearest; of two equally near ones the lower (include/surefoot/quantile.hpp).
  return ordered.length ? ordered[Math.ceil(share * (ordered.length - 1) - 0.5)] : NaN;
}

export function duration(seconds) {
  if (seconds < 120) return `${fixed(seconds, 1)} s`;
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, "0")} s`;
}

/** How many decimals a step has, and with it all of its multiples. */
export function decimalsOf(step) {
  for (let decimals = 0; decimals < 12; ++decimals) {
    const whole = step * 10 ** decimals;
    if (Math.abs(whole - Math.round(whole)) < 1e-6 * whole) return decimals;
  }
  return 12;
}

/** A coordinate with what was taken off it: the truth's world may begin far away (UTM). */
export function axisLabel(axis, origin) {
  const less = origin?.["xyz".indexOf(axis)];
  if (!less) return `${axis} [m]`;
  return `${axis} ${less > 0 ? "−" : "+"} ${grouped(Math.abs(less))} [m]`;
}

/** A step of 1, 2 or 5 times a power of ten that makes about so many over the range. */
export function niceStep(range, count) {
  const rough = range / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const factor = [1, 2, 5, 10].find((f) => f * power >= rough) ?? 10;
  return factor * power;
}
