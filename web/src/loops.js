// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Places that a run compared with where it had been before.

export const isTaken = ({ verdict }) => verdict === "taken";

/** How many had each verdict, the commonest first: [{verdict, why, count}]. */
export function verdictsOf(loops) {
  const verdicts = new Map();
  for (const { verdict, why } of loops) {
    const known = verdicts.get(verdict) ?? { verdict, why, count: 0 };
    verdicts.set(verdict, { ...known, count: known.count + 1 });
  }
  return [...verdicts.values()].sort((a, b) => b.count - a.count);
}
