// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The report's data as C++ wrote them (src/report/report_json.cpp), with typed arrays in place of
// base64.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

export const floats = (base64) => new Float32Array(bytesOf(base64).buffer);

function sharedTexts({ texts, numbers }) {
  return Array.from(new Uint32Array(bytesOf(numbers).buffer), (number) => texts[number]);
}

function decodeAll(series) {
  return Object.fromEntries(Object.entries(series).map(([name, text]) => [name, floats(text)]));
}

/** Length of the path up to each pose [m]; gaps add nothing, nor does the way from one segment's
 * frame to the next one's. */
export function pathLengths(positions, segments = null) {
  const lengths = new Float32Array(positions.length / 3);
  let sum = 0;
  let last = -1; // the last pose that there is: a segment may begin with scans that have none
  for (let i = 0; i < lengths.length; ++i) {
    const [x, y, z] = positions.subarray(3 * i, 3 * i + 3);
    if (!Number.isNaN(x)) {
      const from = positions.subarray(3 * last, 3 * last + 3);
      const joined = last >= 0 && (!segments || segments[i] === segments[last]);
      if (joined) sum += Math.hypot(x - from[0], y - from[1], z - from[2]);
      last = i;
    }
    lengths[i] = sum;
  }
  return lengths;
}

/** Whether a pose is of another segment than the one before: how they lie to each other is not
 * known, and no line joins them. */
export const isBreak = (segments, i) => Boolean(segments) && i > 0 && segments[i] !== segments[i - 1];

/** Times and values as one line a segment: without values that are missing, with a missing one
 * where a segment ends. Whose scan is none of the run's belongs to the nearest one. */
export function brokenLine(times, values, scans) {
  const segments = scans.columns.segment;
  const [ats, kept] = [[], []];
  let last = null;
  times.forEach((time, i) => {
    if (!Number.isFinite(values[i])) return;
    const segment = segments ? segments[nearestIndex(scans.times, time)] : 0;
    if (last !== null && segment !== last.segment) {
      ats.push((last.time + time) / 2);
      kept.push(NaN);
    }
    ats.push(time);
    kept.push(values[i]);
    last = { time, segment };
  });
  return [Float64Array.from(ats), Float32Array.from(kept)];
}

function decodeMap(map) {
  if (!map) return null;
  return {
    total: map.points,
    shown: map.shown,
    cube: map.cube_m,
    low: map.positions.low,
    high: map.positions.high,
    steps: new Uint16Array(bytesOf(map.positions.values).buffer),
    intensity: map.intensity && { ...map.intensity, steps: bytesOf(map.intensity.values) },
    firstSeen: map.first_seen_s && {
      ...map.first_seen_s,
      steps: new Uint16Array(bytesOf(map.first_seen_s.values).buffer),
    },
  };
}

/** Coordinates that were sent in steps [m]. */
export function decodePoints({ low, high, values }) {
  const steps = new Uint16Array(bytesOf(values).buffer);
  return Float32Array.from(steps, (step, i) => {
    return low[i % 3] + (step / 65535) * (high[i % 3] - low[i % 3]);
  });
}

function decodeSample({ scan, measured, deskewed, times }) {
  return {
    scan,
    measured: decodePoints(measured),
    deskewed: decodePoints(deskewed),
    times: bytesOf(times),
  };
}

function decodePoses({ positions, angles }) {
  return { positions: floats(positions), angles: floats(angles) };
}

function decodeRun(run, index) {
  const path = decodePoses(run.path);
  const columns = decodeAll(run.scans.columns);
  return {
    ...run,
    index,
    path,
    lengths: pathLengths(path.positions, columns.segment),
    scans: {
      ...run.scans,
      times: floats(run.scans.times),
      status: sharedTexts(run.scans.status),
      degenerate: sharedTexts(run.scans.degenerate),
      columns,
    },
    figures: run.evaluation?.figures ?? null,
    errors: run.evaluation ? decodeAll(run.evaluation.errors) : null,
    map: decodeMap(run.map),
    deskewing: run.deskewing.map(decodeSample),
    corrected: run.corrected && decodePoses(run.corrected),
  };
}

function decodeRecording(recording) {
  const truth = recording.truth;
  return {
    ...recording,
    truth: truth && { times: floats(truth.times), ...decodePoses(truth) },
  };
}

export function readReport(text) {
  const report = JSON.parse(text);
  if (report.format !== 3) throw new Error(`data of format ${report.format}; this page reads 3`);
  return {
    ...report,
    recordings: report.recordings.map(decodeRecording),
    runs: report.runs.map(decodeRun),
  };
}

/** Index of the time that is nearest; times ascend. -1 for none. */
export function nearestIndex(times, time) {
  if (times.length === 0) return -1;
  let low = 0;
  let high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle;
    else high = middle;
  }
  return time - times[low] <= times[high] - time ? low : high;
}

/** Linear between the neighbours, constant outside. */
export function interpolate(times, values, time) {
  const last = times.length - 1;
  if (last < 0) return NaN;
  if (time <= times[0]) return values[0];
  if (time >= times[last]) return values[last];
  let index = nearestIndex(times, time);
  if (times[index] > time) --index;
  const step = times[index + 1] - times[index];
  const share = step > 0 ? (time - times[index]) / step : 0;
  if (share === 0) return values[index]; // whose neighbour may be missing
  return values[index] + share * (values[index + 1] - values[index]);
}
