// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What needs no browser: lines that end with a segment, numbers, ticks.
import assert from "node:assert/strict";
import { test } from "node:test";

import { loneValues, peaksOf, timeRange, valueRange } from "../src/chart_range.js";
import { brokenLine, interpolate, isBreak, pathLengths } from "../src/data.js";
import { axisLabel, decimalsOf, duration, fixed, niceStep, quantile } from "../src/numbers.js";

test("no line joins two segments", () => {
  const scans = { times: [0, 1, 2, 3, 4], columns: { segment: [0, 0, 0, 1, 1] } };
  const [times, values] = brokenLine(scans.times, [5, NaN, 7, 8, 9], scans);
  assert.deepEqual([...times], [0, 2, 2.5, 3, 4]); // over the missing one, not over the end
  assert.deepEqual([...values], [5, 7, NaN, 8, 9]);
  assert.ok(isBreak(scans.columns.segment, 3));
  assert.ok(!isBreak(scans.columns.segment, 2));
  assert.ok(!isBreak(undefined, 3)); // a run of before there were segments
  const [all] = brokenLine(scans.times, [1, 2, 3, 4, 5], { times: scans.times, columns: {} });
  assert.deepEqual([...all], scans.times);
});

test("no way leads to a segment that begins with a scan that was rejected", () => {
  const positions = Float32Array.from([0, 0, 0, 3, 0, 4, NaN, NaN, NaN, 100, 0, 0, 101, 0, 0]);
  assert.deepEqual([...pathLengths(positions, [0, 0, 1, 1, 1])], [0, 5, 5, 5, 6]);
  assert.deepEqual([...pathLengths(positions.subarray(0, 9))], [0, 5, 5]);
});

test("a value beside a missing one is there at its own time", () => {
  assert.equal(interpolate([0, 1, 2], [NaN, 5, NaN], 1), 5);
  assert.equal(interpolate([0, 1, 2], [1, 5, 7], 1.5), 6);
});

test("values that no line leads to are told", () => {
  const [nothing, others] = [null, undefined];
  assert.deepEqual(loneValues([1, nothing, 2, 3, nothing, 4], true), [0, 5]);
  assert.deepEqual(loneValues([1, others, 2, nothing, others, 3, others], true), [5]);
  assert.deepEqual(loneValues([nothing, 1, nothing, 2], false), []); // a line leads over the gap
  assert.deepEqual(loneValues([nothing, 1, others], false), [1]);
});

test("a single instant has a range", () => {
  assert.deepEqual(timeRange(2, 2), [1.5, 2.5]);
  assert.deepEqual(timeRange(2, 3), [2, 3]);
  const [low, high] = valueRange({}, null, 0.47, 0.47);
  assert.ok(high - low > 0.04);
});

test("durations have no 60 seconds", () => {
  assert.equal(duration(119.7), "119.7 s");
  assert.equal(duration(179.7), "3 min 00 s");
  assert.equal(duration(125), "2 min 05 s");
});

test("axes tell what was taken off", () => {
  const origin = [512000, -5000, 0];
  const labels = ["x", "y", "z", "way"].map((axis) => axisLabel(axis, origin));
  assert.deepEqual(labels, ["x − 512\u202f000 [m]", "y + 5\u202f000 [m]", "z [m]", "way [m]"]);
  assert.equal(axisLabel("x", undefined), "x [m]"); // of a live run
});

test("quantiles are the nearest values, as surefoot run prints them", () => {
  const fifty = Array.from({ length: 50 }, (_, i) => i);
  assert.equal(quantile(fifty, 0.99), 49); // at 48.51
  assert.equal(quantile(fifty, 0.5), 24); // at 24.5: the lower
  assert.equal(quantile([3, NaN, 1], 1), 3);
  assert.ok(Number.isNaN(quantile([], 0.5)));
});

test("ticks are round", () => {
  assert.equal(niceStep(8.9, 10), 1);
  assert.equal(niceStep(0.43, 4), 0.2);
  assert.equal(fixed(-0.5, 1), "−0.5");
  const steps = [1, 2.5, 50, 0.5, 0.25, 0.0025, 2e-7];
  assert.deepEqual(steps.map(decimalsOf), [0, 1, 0, 1, 2, 4, 7]);
});

test("peaks of one line do not cut what is usual of another", () => {
  const hundred = Array.from({ length: 100 }, (_, i) => 1 + (i % 10) / 10);
  const peaked = hundred.map((value, i) => (i === 50 ? 90 : value));
  const tenfold = hundred.map((value) => 10 * value);
  const lines = [{ values: peaked }, { values: tenfold }];
  const peaks = peaksOf(lines);
  assert.equal(peaks.most, 90);
  const [low, high] = valueRange({ fromZero: true }, peaks, 1, 90);
  assert.equal(low, 0);
  assert.ok(high >= 19 && high < 40, `up to ${high}`);
  assert.equal(peaksOf([{ values: tenfold }, { values: hundred }]), null);
  assert.equal(peaksOf([{ values: [NaN] }, ...lines]).most, 90);
  assert.equal(valueRange({}, peaks, 1, 2)[1], 2.06); // a closer look
});
