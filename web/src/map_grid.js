// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The maps of a recording's runs beside each other, all seen from the same place.
import { el } from "./dom.js";
import { Scene3d } from "./scene3d.js";

const kMaps = 6; // browsers hold some sixteen WebGL contexts

/** The other scenes look from where this one does. */
function follow(scene, others) {
  scene.controls.addEventListener("change", () => {
    if (scene.following) return;
    for (const other of others) other.lookAs(scene);
  });
}

function addScenes(grid, context, runs) {
  const scenes = [];
  for (const run of runs) {
    const canvas = el("canvas", { role: "img", "aria-label": `Map of ${run.name}` });
    const card = el(
      "figure.card",
      {},
      el("figcaption", {}, el("h3", {}, run.name)),
      el("div.canvas.one-map", {}, canvas),
    );
    grid.append(card);
    try {
      scenes.push(new Scene3d(canvas, { ...context, run: () => run }));
    } catch {
      card.remove(); // the large view says why
      break;
    }
  }
  scenes.forEach((scene) => {
    scene.setRun();
    scene.setCursor();
    follow(
      scene,
      scenes.filter((other) => other !== scene),
    );
  });
  scenes.slice(1).forEach((scene) => scene.lookAs(scenes[0]));
  return scenes;
}

export function addMapGrid(page, context) {
  const recordings = new Map();
  for (const run of context.report.runs) {
    if (run.map) recordings.set(run.recording, [...(recordings.get(run.recording) ?? []), run]);
  }
  if (![...recordings.values()].some((runs) => runs.length > 1)) return;
  const note = el("p.note");
  const grid = el("div.maps");
  const section = el(
    "section.side-by-side",
    { "aria-labelledby": "maps-title" },
    el("div.heading", {}, el("h2", { id: "maps-title" }, "Maps beside each other"), note),
    grid,
  );
  page.append(section);
  let shown = null;
  let scenes = [];
  context.store.watch(["run"], () => {
    const { recording } = context.run();
    if (recording === shown) return;
    shown = recording;
    scenes.forEach((scene) => scene.dispose());
    grid.replaceChildren();
    const runs = recordings.get(recording) ?? [];
    section.hidden = runs.length < 2;
    note.textContent = runs.length > kMaps ? `The first ${kMaps} of ${runs.length}.` : "";
    scenes = section.hidden ? [] : addScenes(grid, context, runs.slice(0, kMaps));
    section.hidden = scenes.length < 2;
  });
  context.store.watch(["cursor", "playing"], () => scenes.forEach((scene) => scene.setCursor()));
  context.store.watch(["theme", "shade"], () => scenes.forEach((scene) => scene.setTheme()));
}
