// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The section with the views on path and map, and their controls.
import { choice, el, toggle } from "./dom.js";
import { isTaken } from "./loops.js";
import { grouped, significant } from "./numbers.js";
import { paletteGradient } from "./palette.js";
import { pathShades, shadeChoices } from "./path_shades.js";
import { kAlongTheWay, kFromAbove, PlanView } from "./plan_view.js";
import { Scene3d } from "./scene3d.js";
import { runColor } from "./theme.js";

function card(title, note, ...content) {
  return el("figure.card", {}, el("figcaption", {}, el("h3", {}, title), note), ...content);
}

export function mapNote(map) {
  if (!map) return "No map in this run's folder.";
  if (map.shown === map.total) return `All ${grouped(map.total)} map points.`;
  const thinned = map.cube ? `, one per ${significant(map.cube, 2)} m cube` : "";
  return `${grouped(map.shown)} of ${grouped(map.total)} map points${thinned}.`;
}

/** Colours of lines and markers. */
function pathLegend({ run, recording, companions }) {
  const items = companions().map((companion, place) => {
    const swatch = el("i.line");
    swatch.style.background = runColor(place);
    return el("li", { className: companion === run() ? "here" : "" }, swatch, companion.name);
  });
  if (recording().truth) items.push(el("li", {}, el("i.band"), "truth"));
  if (run().corrected) items.push(el("li", {}, el("i.dashes"), "after loops"));
  if (run().loops.some(isTaken)) items.push(el("li", {}, el("i.taken"), "loop"));
  if (!run().loops.every(isTaken)) items.push(el("li", {}, el("i.refused"), "refused"));
  items.push(el("li", {}, el("i.start"), "start"), el("li", {}, el("i.end"), "end"));
  return items;
}

/** What the path is coloured by. */
function shadeControls({ store, run }) {
  const choices = shadeChoices(run());
  if (!choices.some(([key]) => key === store.get("shade"))) store.set("shade", "run");
  if (choices.length === 1) return [];
  return [
    choice("Colour of the path", choices, store.get("shade"), (key) => store.set("shade", key)),
  ];
}

/** The range of the path's colours. */
function shadeRange(context) {
  const shades = pathShades(context);
  if (!shades) return [];
  const bar = el("i.palette");
  bar.style.background = paletteGradient(context.store.get("theme"));
  const text = (value) => el("span", {}, `${significant(value, 2)} m`);
  return [text(shades.low), bar, text(shades.high)];
}

function mapControls(scene, context, legend) {
  const { store, run, recording } = context;
  const map = run().map;
  const modes = [["height", "Height"]];
  if (map?.intensity) modes.push(["intensity", "Intensity"]);
  if (map?.firstSeen) modes.push(["time", "Time"]);
  if (!modes.some(([mode]) => mode === scene.mode)) scene.setMode("height");
  const showLegend = () => {
    const [low, high, unit] = scene.points?.legend(scene.mode) ?? [];
    const bar = el("i.palette");
    bar.style.background = paletteGradient(store.get("theme"));
    const text = (value) => el("span", {}, `${significant(value, 3)} ${unit}`.trim());
    legend.replaceChildren(...(map ? [text(low), bar, text(high)] : []));
  };
  showLegend();
  const size = el("input", { type: "range", min: 0.5, max: 5, step: 0.5, value: scene.pointSize });
  size.addEventListener("input", () => scene.setPointSize(Number(size.value)));
  const reset = el("button", { type: "button" }, "Reset view");
  reset.addEventListener("click", () => scene.resetView());
  const colours = choice("Colour of the map", modes, scene.mode, (mode) => {
    scene.setMode(mode);
    showLegend();
  });
  return [
    map && colours,
    map && el("label.slider", {}, el("span", {}, "Points"), size),
    map && toggle("Map", scene.showMap, (shown) => scene.setMapShown(shown)),
    recording().truth && toggle("Truth", scene.showTruth, (shown) => scene.setTruthShown(shown)),
    reset,
  ].filter(Boolean);
}

export function missingScene(error) {
  return el(
    "p.failure",
    {},
    `The 3-D view needs WebGL, which is not to be had here: ${error.message}`,
  );
}

function addScene(holder, controls, legend, context) {
  const canvas = el("canvas", {
    tabIndex: 0,
    role: "img",
    "aria-label":
      "Map and paths in three dimensions. Drag to turn, right-drag or arrow keys to move, wheel to zoom.",
  });
  holder.append(canvas);
  let scene;
  try {
    scene = new Scene3d(canvas, context);
  } catch (error) {
    holder.replaceChildren(missingScene(error));
    return;
  }
  const { store } = context;
  store.watch(["run"], () => {
    scene.setRun();
    scene.setCursor();
  });
  store.watch(["theme", "shade"], () => scene.setTheme());
  store.watch(["run", "theme"], () =>
    controls.replaceChildren(...mapControls(scene, context, legend)),
  );
  store.watch(["cursor", "playing"], () => scene.setCursor());
}

function addPlan(holder, context, projection, label, onStretch) {
  const canvas = el("canvas", { role: "img", "aria-label": label });
  holder.append(canvas);
  const view = new PlanView(canvas, context, projection, onStretch);
  context.store.watch(["run", "theme"], () => view.setRun());
  context.store.watch(["cursor", "shade"], () => view.draw());
}

export function addViews(page, context) {
  const note = el("p.note");
  const legend = el("ul.legend");
  const colours = el("div.colours");
  const controls = el("div.controls", { role: "group", "aria-label": "3-D view" });
  const shades = el("div.controls");
  const range = el("div.colours");
  const paths = el("div.controls", { role: "group", "aria-label": "Paths" }, shades, range);
  const scene = el("div.canvas.scene");
  const top = el("div.canvas.top");
  const side = el("div.canvas.side");
  const stretch = el("p.note");
  page.append(
    el(
      "section.views",
      { "aria-labelledby": "views-title" },
      el("div.heading", {}, el("h2", { id: "views-title" }, "Path and map"), legend, paths),
      el(
        "div.grid",
        {},
        el(
          "figure.card.wide",
          {},
          el("figcaption", {}, el("h3", {}, "In space"), note),
          scene,
          el("div.below", {}, controls, colours),
        ),
        card("From above", null, top),
        card("Height along the way", stretch, side),
      ),
    ),
  );
  context.store.watch(["run"], () => (note.textContent = mapNote(context.run().map)));
  context.store.watch(["run", "theme"], () => legend.replaceChildren(...pathLegend(context)));
  // Not with the choice itself: who is at it with the keyboard stays there.
  context.store.watch(["run"], () => shades.replaceChildren(...shadeControls(context)));
  context.store.watch(["run", "theme", "shade"], () =>
    range.replaceChildren(...shadeRange(context)),
  );
  addScene(scene, controls, colours, context);
  addPlan(top, context, kFromAbove, "Paths seen from above, x to the right, y upwards, in metres");
  addPlan(
    side,
    context,
    kAlongTheWay,
    "Height of the paths along the way, in metres",
    (factor) => {
      stretch.textContent =
        factor > 1.05 ? `Heights stretched ${significant(factor, 2)} times.` : "";
    },
  );
}
