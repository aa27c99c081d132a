// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Figures in tables: how the runs compare, errors, scans to look at, facts and parameters.
import { el } from "./dom.js";
import { verdictsOf } from "./loops.js";
import { fixed, grouped, quantile, significant } from "./numbers.js";
import { describeStatus, gradeOf } from "./status.js";

const kStatistics = ["max", "mean", "median", "min", "rmse", "std", "sse"];
const kMostEvents = 300; // rows of the list of scans

/** A cell keeps the whole number in data-value; the text is rounded. */
function number(value, text = significant(value), place = 0) {
  const cell = el("td.number", { "data-value": String(value), title: String(value) }, text);
  if (place) cell.dataset.place = place;
  return cell;
}

function table(caption, columns, rows) {
  return el(
    "div.table",
    {},
    el(
      "table",
      {},
      el("caption", {}, caption),
      el("thead", {}, el("tr", {}, ...columns.map((column) => el("th", { scope: "col" }, column)))),
      el("tbody", {}, ...rows.map((cells) => el("tr", {}, ...cells))),
    ),
  );
}

const rowHead = (text, below) =>
  el("th", { scope: "row" }, text, below ? el("small", {}, below) : null);

const readable = (name) => {
  const [kind, ...words] = name.split("_");
  return `${kind.toUpperCase()} ${words.join(" ").replace("percent", "share")}`;
};

/** Where positions leave a turn open, orientations decide it, too. */
const kAlignments = { se3: "SE(3) alignment", poses: "alignment by positions and orientations" };

function errorTable(run) {
  const rows = Object.entries(run.figures.errors).map(([name, error]) => {
    const row = [
      rowHead(readable(name), error.unit),
      ...kStatistics.map((key) => number(error[key])),
      number(error.count, grouped(error.count)),
    ];
    row.forEach((cell) => (cell.dataset.error = name));
    kStatistics.forEach((key, i) => (row[i + 1].dataset.statistic = key));
    return row;
  });
  const result = table(
    `Absolute and relative pose errors after ${kAlignments[run.evaluation.align]}, as evo defines them`,
    ["Error", "max", "mean", "median", "min", "RMSE", "std", "SSE", "count"],
    rows,
  );
  result.id = "errors";
  return result;
}

function segmentTable(run) {
  const { segments, segments_all: all } = run.figures;
  const row = (
    label,
    { translation_percent: translation, rotation_deg_per_m: rotation, count },
  ) => [rowHead(label), number(translation), number(rotation), number(count, grouped(count))];
  const rows = segments
    .filter(({ count }) => count > 0)
    .map((s) => row(`${significant(s.length_m, 3)} m`, s));
  if (all.count > 0) rows.push(row("all", all));
  if (rows.length === 0) return null;
  return table(
    "Error over stretches, as KITTI defines it",
    ["Length", "translation [%]", "rotation [deg/m]", "count"],
    rows,
  );
}

function driftTable(run) {
  const drift = run.figures.end_drift;
  const row = (label, value, unit) => [rowHead(label, unit), number(value)];
  const rows = [
    row("End drift", drift.total_m, "m"),
    row("of the path", drift.percent, "%"),
    row("horizontal", drift.horizontal_m, "m"),
    row("vertical", drift.vertical_m, "m"),
    row("Path of the truth", drift.path_length_m, "m"),
    row("Truth covered", 100 * run.figures.coverage, "%"),
    [rowHead("Poses compared"), number(run.figures.pairs, grouped(run.figures.pairs))],
  ];
  return table("Where it ended, first poses laid on each other", ["Figure", "value"], rows);
}

/** 1 and 2 for the smallest and the second smallest value. */
function places(values) {
  const ordered = [...new Set(values.filter(Number.isFinite))].sort((a, b) => a - b);
  return values.map((value) => (value === ordered[0] ? 1 : value === ordered[1] ? 2 : 0));
}

/** Runs of one recording beside each other; a run that covers too little is not ranked. Figures that
 * no run has are left out: those of errors where there is no truth. */
function comparisonTable(runs) {
  const error = (name, key) => (run) => run.figures?.errors[name]?.[key] ?? NaN;
  const time = (share) => (run) => quantile(run.scans.columns.ms_total ?? [], share);
  const columns = [
    ["APE max [m]", error("ape_translation", "max")],
    ["mean [m]", error("ape_translation", "mean")],
    ["RMSE [m]", error("ape_translation", "rmse")],
    ["std [m]", error("ape_translation", "std")],
    ["vertical RMSE [m]", error("ape_vertical", "rmse")],
    ["end drift [%]", (run) => run.figures?.end_drift.percent ?? NaN],
    ["median [ms]", time(0.5)],
    ["p99 [ms]", time(0.99)],
  ].filter(([, value]) => runs.some((run) => Number.isFinite(value(run))));
  const compared = runs.some((run) => run.figures);
  const whole = (run) => !run.figures || run.figures.coverage >= 0.95;
  const ranks = columns.map(([, value]) =>
    places(runs.map((run) => (whole(run) ? value(run) : NaN))),
  );
  const rows = runs.map((run, r) => {
    const covered = run.figures ? `${fixed(100 * run.figures.coverage, 1)} %` : "–";
    const untrusted = run.scans.status.filter((_, i) => gradeOf(run, i) === "untrusted").length;
    return [
      rowHead(run.name),
      ...(compared ? [el("td.number", {}, covered)] : []),
      ...columns.map(([, value], c) => number(value(run), significant(value(run), 3), ranks[c][r])),
      number(untrusted, grouped(untrusted)),
    ];
  });
  return table(
    "Runs of this recording; best bold, second underlined",
    ["Run", ...(compared ? ["covered"] : []), ...columns.map(([label]) => label), "untrusted"],
    rows,
  );
}

function givenTable({ title, columns, rows }) {
  const isWords = columns.map((_, i) => rows.every((cells) => !/^[-−–\d]/.test(cells[i].text)));
  const result = table(
    title,
    columns,
    rows.map((cells) =>
      cells.map(({ text, place }, i) => {
        if (i === 0) return rowHead(text);
        const cell = el(isWords[i] ? "td.words" : "td.number", {}, text);
        if (place) cell.dataset.place = place;
        return cell;
      }),
    ),
  );
  const heads = result.querySelectorAll("thead th");
  isWords.forEach((is, i) => heads[i].classList.toggle("words", is));
  return result;
}

function eventTable(run, store) {
  const events = run.scans.status
    .map((_, i) => i)
    .filter((i) => gradeOf(run, i) !== "ok" || run.scans.messages[i]);
  if (events.length === 0) return el("p.note", {}, "Every scan is ok.");
  const rows = events.slice(0, kMostEvents).map((i) => {
    const jump = el("button.jump", { type: "button" }, `${i}`);
    jump.addEventListener("click", () => store.set("cursor", run.scans.times[i]));
    const status = el("td", {}, describeStatus(run, i));
    status.dataset.grade = gradeOf(run, i);
    return [
      el("td.number", {}, jump),
      number(run.scans.times[i], fixed(run.scans.times[i], 2)),
      status,
    ];
  });
  const more =
    events.length > kMostEvents ? `; the first ${kMostEvents} of ${grouped(events.length)}` : "";
  return table(`Scans with something to tell${more}`, ["Scan", "time [s]", "Status"], rows);
}

function loopTable(run) {
  const rows = verdictsOf(run.loops).map(({ verdict, why, count }) => [
    rowHead(verdict.replaceAll("_", " ")),
    number(count, grouped(count)),
    el("td", {}, why),
  ]);
  const result = table(
    `${grouped(run.loops.length)} places compared with where the robot had been before`,
    ["Verdict", "places", "because"],
    rows,
  );
  result.id = "loops";
  return result;
}

function parameterTable(run) {
  const rows = run.parameters.map(({ name, value, default: usual, unit, help }) => {
    const cell = el("td.number", {}, value);
    if (value !== usual) cell.dataset.place = 1;
    return [
      rowHead(name),
      cell,
      el("td", {}, unit),
      el("td.number", {}, usual),
      el("td", {}, help),
    ];
  });
  return table(
    "Parameters as used; other than the default: bold",
    ["Parameter", "value", "unit", "default", "meaning"],
    rows,
  );
}

function facts(run) {
  return el(
    "dl.facts",
    {},
    ...run.facts.flatMap(([label, text]) => [el("dt", {}, label), el("dd", {}, text)]),
  );
}

const notes = (texts) =>
  texts.length ? el("ul.notes", {}, ...texts.map((text) => el("li", {}, text))) : null;

function folded(title, open, ...content) {
  return el("details", { open }, el("summary", {}, title), ...content);
}

export function addTables(page, context) {
  const { report, store } = context;
  const given = report.tables.map(givenTable);
  const figures = el("div.tables");
  const rest = el("div.rest");
  const heading = el("h2", { id: "tables-title" }, "Figures");
  page.append(
    el(
      "section",
      { "aria-labelledby": "tables-title" },
      heading,
      ...given,
      notes(report.notes) ?? "",
      figures,
    ),
    el("section", { "aria-label": "About the run" }, rest),
  );
  store.watch(["run"], () => {
    const run = context.run();
    const runs = context.companions();
    const parts = runs.length > 1 ? [comparisonTable(runs)] : [];
    if (run.figures) {
      parts.push(errorTable(run), el("div.pair", {}, driftTable(run), segmentTable(run)));
    } else {
      parts.push(
        el("p.note", {}, "No truth was compared with this run, so there are no errors to show."),
      );
    }
    figures.replaceChildren(...parts);
    rest.replaceChildren(
      ...[
        folded("Scans to look at", false, eventTable(run, store)),
        run.loops.length ? folded("Loops", true, loopTable(run)) : null,
        folded("About the run", true, facts(run), notes(run.notes)),
        run.parameters.length ? folded("Parameters", false, parameterTable(run)) : null,
      ].filter(Boolean),
    );
  });
}
