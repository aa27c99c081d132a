// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which scans are not to be taken for granted.

const kUntrusted = new Set(["too_few_matches", "diverged", "lost", "rejected"]);

/** "ok", "degenerate" or "untrusted"; the first scan of a run is as it should be. */
export function gradeOf(run, index) {
  const status = run.scans.status[index];
  if (kUntrusted.has(status)) return "untrusted";
  if (status === "degenerate" || (status === "first_scan" && index > 0)) return "degenerate";
  return "ok";
}

/** Stretches of equal grade that are not ok, from half-way to the neighbours: [{grade, from, to}]. */
export function gradedSpans(run) {
  const { times, count } = run.scans;
  const border = (i) => {
    if (i <= 0) return times[0];
    return i >= count ? times[count - 1] : (times[i - 1] + times[i]) / 2;
  };
  const spans = [];
  for (let i = 0; i < count; ++i) {
    const grade = gradeOf(run, i);
    if (grade === "ok") continue;
    const last = spans.at(-1);
    if (last && last.end === i && last.grade === grade) {
      last.end = i + 1;
      last.to = border(i + 1);
    } else {
      spans.push({ grade, end: i + 1, from: border(i), to: border(i + 1) });
    }
  }
  return spans;
}

export function describeStatus(run, index) {
  const weak = run.scans.degenerate[index];
  const message = run.scans.messages[index];
  const status = run.scans.status[index].replaceAll("_", " ");
  if (message) return `${status}: ${message}`;
  return weak ? `${status}: little is known of ${weak}` : status;
}
