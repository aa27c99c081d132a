// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Title, what is compared, the figures that are asked for first.

import { choice, el } from "./dom.js";
import { duration, fixed, grouped, quantile, significant } from "./numbers.js";
import { gradeOf } from "./status.js";

function keyFigures(run) {
  const { times, count, columns } = run.scans;
  const seconds = count > 1 ? times[count - 1] - times[0] : 0;
  const untrusted = run.scans.status.filter((_, i) => gradeOf(run, i) === "untrusted").length;
  const weak = run.scans.status.filter((_, i) => gradeOf(run, i) === "degenerate").length;
  const total = columns.ms_total ?? new Float32Array();
  const figures = [
    ["Scans", grouped(count), duration(seconds)],
    [
      "Path",
      `${fixed(run.lengths.at(-1) ?? 0, 1)} m`,
      run.map ? `${grouped(run.map.total)} map points` : "no map",
    ],
    [
      "Time per scan",
      `${fixed(quantile(total, 0.5), 1)} ms`,
      `median; p90 ${fixed(quantile(total, 0.9), 1)}, p99 ${fixed(quantile(total, 0.99), 1)}\u00a0ms`,
    ],
    ["Untrusted", grouped(untrusted), `${grouped(weak)} degenerate`],
  ];
  if (run.figures) {
    const { errors, end_drift: drift } = run.figures;
    const ape = errors.ape_translation;
    figures.push(
      ["APE, RMSE", `${significant(ape.rmse, 3)} m`, `at most ${significant(ape.max, 3)} m`],
      drift.percent > 0
        ? ["End drift", `${significant(drift.percent, 3)} %`, `${significant(drift.total_m, 3)} m`]
        : ["End drift", `${significant(drift.total_m, 3)} m`, "without a way"],
    );
  }
  return figures.map(([label, value, below]) =>
    el("div.figure", {}, el("dt", {}, label), el("dd", {}, value), el("dd.below", {}, below)),
  );
}

/** Methods of the recording beside each other; recordings, where there are several, above. */
function runChoice({ report, store, recording, companions, run }) {
  const parts = [];
  if (report.recordings.length > 1) {
    const select = el("select", { "aria-label": "Recording" });
    report.recordings.forEach((item, index) => {
      const first = report.runs.findIndex((candidate) => candidate.recording === index);
      if (first < 0) return;
      select.append(el("option", { value: first, selected: item === recording() }, item.name));
    });
    select.addEventListener("change", () => store.set("run", Number(select.value)));
    parts.push(select);
  }
  if (companions().length > 1) {
    const options = companions().map((item) => [item.index, item.name]);
    parts.push(choice("Run", options, run().index, (index) => store.set("run", index)));
  }
  return parts;
}

export function addHeader(page, context) {
  const { report, store } = context;
  const themes = [
    ["auto", "Auto"],
    ["light", "Light"],
    ["dark", "Dark"],
  ];
  const chosen = el("div.chosen");
  const figures = el("dl.figures", { "aria-label": "Key figures" });
  const subtitle = el("p.subtitle");
  page.append(
    el(
      "header",
      {},
      el(
        "div.titles",
        {},
        el("p.eyebrow", {}, `Surefoot ${report.version}`),
        el("h1", {}, report.title),
        subtitle,
      ),
      choice("Colours of the page", themes, store.get("themeWish"), (wish) =>
        store.set("themeWish", wish),
      ),
    ),
    chosen,
    figures,
  );
  store.watch(["run"], () => {
    const run = context.run();
    const truth = run.figures ? "compared with the truth" : "no truth to compare with";
    const names = [context.recording().name, run.name].filter((name) => name !== report.title);
    subtitle.textContent = `${names.join(", ")}; ${truth}`;
    const focused = chosen.contains(document.activeElement) && document.activeElement;
    chosen.replaceChildren(...runChoice(context));
    chosen.hidden = chosen.childElementCount === 0;
    if (focused) {
      const same = focused.matches("select") ? "select" : `input[value="${CSS.escape(focused.value)}"]`;
      chosen.querySelector(same)?.focus();
    }
    figures.replaceChildren(...keyFigures(run));
  });
}
