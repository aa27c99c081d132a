// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Map, path and charts of a run that goes on: the report's, drawn again as it grows.
import { ChartPanel, showAll } from "../chart_panel.js";
import { axisOf, columnLines } from "../chart_specs.js";
import { el } from "../dom.js";
import { kAlongTheWay, kFromAbove, PlanView } from "../plan_view.js";
import { Scene3d } from "../scene3d.js";
import { mapNote, missingScene } from "../views.js";

const kLeastView = 20; // [m]

const kCharts = [
  {
    title: "From last packet to pose",
    unit: "latency [ms]",
    fromZero: true,
    cut: true,
    lines: (c) => columnLines(c, [["latency", "latency_ms"]]),
  },
  {
    title: "Probability of a wrong pose",
    unit: "probability [1]",
    fromZero: true,
    lines: (c) => columnLines(c, [["probability", "wrong_probability"]]),
  },
];

function card(title, note, holder) {
  return el("figure.card", {}, el("figcaption", {}, el("h3", {}, title), note), holder);
}

/** The scene looks at everything until somebody turns it. */
function addScene(holder, reset, context) {
  const canvas = el("canvas", {
    tabIndex: 0,
    role: "img",
    "aria-label":
      "Map and path in three dimensions. Drag to turn, right-drag to move, wheel to zoom.",
  });
  holder.append(canvas);
  let scene;
  try {
    scene = new Scene3d(canvas, context, kLeastView);
  } catch (error) {
    holder.replaceChildren(missingScene(error));
    return { showRun: () => {}, setTheme: () => {}, setCursor: () => {} };
  }
  let follows = true;
  scene.controls.addEventListener("start", () => (follows = false));
  reset.addEventListener("click", () => {
    follows = true;
    scene.resetView();
  });
  scene.pointSize = 2;
  scene.setRun();
  return {
    showRun: () => {
      scene.showRun();
      scene.setCursor();
      if (follows) scene.resetView();
    },
    setTheme: () => scene.setTheme(),
    setCursor: () => scene.setCursor(),
  };
}

function addPlan(holder, context, projection, label) {
  const canvas = el("canvas", { role: "img", "aria-label": label });
  holder.append(canvas);
  return new PlanView(canvas, context, projection);
}

/** Returns drawPaths() and drawCharts(), to be called when there is more. */
export function addLiveViews(page, context) {
  const note = el("p.note");
  const reset = el("button", { type: "button" }, "See all");
  const holders = {
    scene: el("div.canvas.scene"),
    top: el("div.canvas.top"),
    side: el("div.canvas.side"),
  };
  const panels = kCharts.map((spec) => new ChartPanel(spec, context));
  const whole = showAll(context.store);
  page.append(
    el(
      "section.views",
      { "aria-label": "Path and map" },
      el(
        "div.grid",
        {},
        el(
          "figure.card.wide",
          {},
          el("figcaption", {}, el("h3", {}, "In space"), note),
          holders.scene,
          el("div.below", {}, el("div.controls", {}, reset)),
        ),
        card("From above", null, holders.top),
        card("Height along the way", null, holders.side),
      ),
    ),
    el(
      "section",
      { "aria-label": "Scan by scan" },
      el("div.heading", {}, el("p.note", {}, "Drag to look closer."), el("div.controls", {}, whole)),
      el("div.charts", {}, ...panels.map((panel) => panel.element)),
    ),
  );
  const scene = addScene(holders.scene, reset, context);
  const plans = [
    addPlan(holders.top, context, kFromAbove, "Path seen from above, in metres"),
    addPlan(holders.side, context, kAlongTheWay, "Height of the path along the way, in metres"),
  ];
  const drawPaths = () => {
    scene.showRun();
    for (const plan of plans) plan.setRun();
    const { map } = context.run();
    note.textContent = map ? mapNote(map) : "No points yet.";
  };
  const drawCharts = () => {
    const axis = axisOf(context);
    for (const panel of panels) if (!panel.isHeld) panel.update(axis);
  };
  context.store.watch(["theme"], () => {
    scene.setTheme();
    drawPaths();
    drawCharts();
  });
  context.store.watch(["cursor"], () => {
    scene.setCursor();
    for (const plan of plans) plan.draw();
    for (const panel of panels) panel.showCursor();
  });
  context.store.watch(["range"], () => panels.forEach((panel) => panel.showRange()));
  return { drawPaths, drawCharts };
}
