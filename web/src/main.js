// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT

import { addCharts } from "./charts.js";
import { readReport } from "./data.js";
import { el } from "./dom.js";
import { addDeskewing } from "./deskew_view.js";
import { addHeader } from "./header.js";
import { addMapGrid } from "./map_grid.js";
import { addViews } from "./views.js";
import { addScrubber } from "./scrubber.js";
import { Store } from "./store.js";
import { addTables } from "./tables.js";
import { followTheme } from "./theme.js";

const page = document.getElementById("report");

function showReport() {
  const report = readReport(document.getElementById("report-data").textContent);
  const store = new Store({
    run: 0, // index of the run that is looked at
    cursor: null, // [s] the instant that all views mark
    playing: false,
    axis: "time", // of the charts: "time" or "distance"
    range: null, // [low, high] of that axis; null: all
    shade: "run", // what the path is coloured by: "run", "error" or "sigma"
    themeWish: "auto",
    theme: "light",
  });
  followTheme(store);
  const context = {
    report,
    store,
    run: () => report.runs[store.get("run")],
    recording: () => report.recordings[report.runs[store.get("run")].recording],
    /** Runs of the recording that is looked at, with their place among its colours. */
    companions: () => {
      const recording = report.runs[store.get("run")].recording;
      return report.runs.filter((run) => run.recording === recording);
    },
  };
  addHeader(page, context);
  addViews(page, context);
  addMapGrid(page, context);
  addDeskewing(page, context);
  addCharts(page, context);
  addTables(page, context);
  addScrubber(page, context);
  document.documentElement.dataset.ready = "true";
  window.surefootReport = { report, store }; // for the console
}

try {
  showReport();
} catch (error) {
  page.replaceChildren(
    el("p.failure", { role: "alert" }, `This report cannot be shown: ${error.message}`),
  );
  throw error;
}
