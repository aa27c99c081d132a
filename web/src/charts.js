// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The section with everything over time or path.
import { ChartPanel, showAll } from "./chart_panel.js";
import { axisOf, kCharts } from "./chart_specs.js";
import { choice, el } from "./dom.js";

function shadingLegend() {
  return el(
    "ul.legend",
    {},
    el("li", {}, el("i.block.degenerate"), "degenerate: a direction is hardly observed"),
    el("li", {}, el("i.block.untrusted"), "not to be trusted: pose not measured"),
  );
}

export function addCharts(page, context) {
  const { store } = context;
  const panels = kCharts.map((spec) => new ChartPanel(spec, context));
  const axes = choice(
    "Axis of the charts",
    [
      ["time", "Over time"],
      ["distance", "Along the path"],
    ],
    "time",
    (axis) => {
      store.set("range", null);
      store.set("axis", axis);
    },
  );
  const groups = [...new Set(kCharts.map(({ group }) => group))].map((group) => {
    const members = panels.filter(({ spec }) => spec.group === group);
    return el(
      "div.group",
      {},
      el("h3.group-title", {}, group),
      el("div.charts", {}, ...members.map(({ element }) => element)),
    );
  });
  page.append(
    el(
      "section",
      { "aria-labelledby": "charts-title" },
      el(
        "div.heading",
        {},
        el("h2", { id: "charts-title" }, "Scan by scan"),
        shadingLegend(),
        el("div.controls", {}, axes, showAll(store)),
      ),
      el("p.note", {}, "Hover to mark an instant everywhere; drag to look closer."),
      ...groups,
    ),
  );
  store.watch(["run", "axis", "theme"], () => {
    const axis = axisOf(context);
    for (const panel of panels) panel.update(axis);
    for (const group of groups)
      group.hidden = [...group.lastChild.children].every((panel) => panel.hidden);
  });
  store.watch(["range"], () => panels.forEach((panel) => panel.showRange()));
  let scheduled = false;
  store.watch(["cursor"], () => {
    if (scheduled) return;
    scheduled = true;
    requestAnimationFrame(() => {
      scheduled = false;
      for (const panel of panels) panel.showCursor();
    });
  });
}
