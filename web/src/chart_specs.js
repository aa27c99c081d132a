// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What each chart shows of the run that is looked at and of its companions.
import { brokenLine, interpolate } from "./data.js";
import { grouped } from "./numbers.js";
import { color, runColor, stepColor } from "./theme.js";

/** One line of a chart: values at times of its own. */
function line(label, times, values, stroke, more = {}) {
  return { label, times, values, stroke, width: 1.5, ...more };
}

/** The same of a run, whose segments are not joined. */
function runLine(run, label, times, values, stroke, more = {}) {
  return line(label, ...brokenLine(times, values, run.scans), stroke, { gaps: true, ...more });
}

const strided = (values, offset) => values.filter((_, i) => i % 3 === offset);

/** All runs' and the truth's positions or angles. */
function poseLines(context, part, offset) {
  const focus = context.run();
  const lines = context.companions().map((run, place) =>
    runLine(run, run.name, run.scans.times, strided(run.path[part], offset), runColor(place), {
      width: run === focus ? 1.8 : 1.1,
    }),
  );
  const { truth } = context.recording();
  if (truth) {
    const style = { dash: [5, 4], width: 1.1 };
    lines.push(line("truth", truth.times, strided(truth[part], offset), color("truth"), style));
  }
  return lines;
}

function errorLines(context, parts) {
  const run = context.run();
  const { errors } = run;
  if (!errors) return [];
  return parts.map(([label, name], place) =>
    runLine(run, label, errors.times, errors[name], stepColor(2 * place)),
  );
}

function translationErrors(context) {
  const evaluated = context.companions().filter((run) => run.errors);
  if (evaluated.length < 2) {
    return errorLines(context, [
      ["whole", "translation_m"],
      ["horizontal", "horizontal_m"],
      ["vertical, signed", "vertical_m"],
    ]);
  }
  return context
    .companions()
    .flatMap((run, place) =>
      run.errors
        ? [runLine(run, run.name, run.errors.times, run.errors.translation_m, runColor(place))]
        : [],
    );
}

/** A column that says nothing (a method without that stage) is no line. */
const says = (values) => values?.some((value) => Number.isFinite(value) && value !== 0);

export function columnLines(context, columns) {
  const { scans } = context.run();
  return columns
    .filter(([, name]) => says(scans.columns[name]))
    .map(([label, name, scale = 1], place) => {
      const values = scans.columns[name];
      const shown = scale === 1 ? values : values.map((value) => scale * value);
      // Scans that were not registered have none: nothing leads over them.
      return line(label, scans.times, shown, stepColor(2 * place), { gaps: true });
    });
}

/** One line a stage of the registration. */
function stageLines(context, part) {
  const { stages } = context.run().scans;
  return columnLines(
    context,
    stages.map((stage, place) => [stage, `stage${place + 1}_${part}`]),
  );
}

const kAxes = ["x", "y", "z"];
const kTurns = ["roll", "pitch", "yaw"];

/** How uncertain the position is said to be, beside how wrong it is. */
function positionSigmaLines(context) {
  const lines = columnLines(
    context,
    kAxes.map((axis) => [axis, `sigma_${axis}_m`]),
  );
  const { errors } = context.run();
  if (errors && lines.length) {
    const style = { width: 1, dash: [5, 4] };
    const error = color("truth");
    lines.push(line("error", errors.times, errors.translation_m, error, style));
  }
  return lines;
}

/** A row a direction, a dot a scan that hardly sees it; a row's number says nothing, `told` does. */
const kDirections = ["forward", "lateral", "up", "roll", "pitch", "yaw"];
function weakDirectionLines(context) {
  const { scans } = context.run();
  return kDirections.flatMap((direction, row) => {
    const weak = scans.degenerate.map((names) => names.split(" ").includes(direction));
    if (!weak.some(Boolean)) return [];
    const values = weak.map((is) => (is ? row : NaN));
    const count = weak.filter(Boolean).length;
    const told = `${grouped(count)} ${count === 1 ? "scan" : "scans"}`;
    return [line(direction, scans.times, values, stepColor(row), { width: 0, dots: true, told })];
  });
}

/** The steps on top of each other: each line is the sum up to its step; `own` is the step's. */
function stepLines(context) {
  const { scans } = context.run();
  const names = Object.keys(scans.columns).filter(
    (name) => name.startsWith("ms_") && name !== "ms_total" && says(scans.columns[name]),
  );
  const sum = new Float32Array(scans.count);
  const lines = names.map((name, place) => {
    const own = scans.columns[name];
    for (let i = 0; i < scans.count; ++i) sum[i] += own[i];
    const fill = stepColor(place);
    return line(name.slice(3), scans.times, sum.slice(), fill, { own, fill, width: 0 });
  });
  return lines.reverse(); // the highest is painted first
}

/** The weakest direction is told only where it counts as degenerate; the others are points. */
function observabilityLines(context) {
  const lines = stageLines(context, "observability");
  const { scans } = context.run();
  const least = scans.columns.least_information;
  if (!least || !scans.degenerate.some(Boolean)) return lines;
  const values = least.map((value, i) => (scans.degenerate[i] ? value : NaN));
  lines.push(
    line("weakest direction, where degenerate", scans.times, values, stepColor(2), {
      width: 0,
      dots: true,
    }),
  );
  return lines;
}

/** Charts with their unit; `lines` is asked anew when run or theme changes. */
export const kCharts = [
  { group: "Motion", title: "Height", unit: "z [m]", lines: (c) => poseLines(c, "positions", 2) },
  { group: "Motion", title: "Roll", unit: "roll [deg]", lines: (c) => poseLines(c, "angles", 0) },
  { group: "Motion", title: "Pitch", unit: "pitch [deg]", lines: (c) => poseLines(c, "angles", 1) },
  {
    group: "Error against the truth",
    title: "Position",
    unit: "error [m]",
    lines: translationErrors,
  },
  {
    group: "Error against the truth",
    title: "Orientation",
    unit: "error [deg]",
    lines: (c) =>
      errorLines(c, [
        ["tilt", "tilt_deg"],
        ["yaw", "yaw_deg"],
      ]),
  },
  {
    group: "What it says of itself",
    title: "Probability of a wrong pose",
    unit: "probability [1]",
    fromZero: true,
    lines: (c) => columnLines(c, [["probability", "wrong_probability", 1]]),
  },
  {
    group: "What it says of itself",
    title: "Standard deviation of the position",
    unit: "sigma [m]",
    fromZero: true,
    cut: true,
    lines: positionSigmaLines,
  },
  {
    group: "What it says of itself",
    title: "Standard deviation of the attitude",
    unit: "sigma [deg]",
    fromZero: true,
    cut: true,
    lines: (c) =>
      columnLines(
        c,
        kTurns.map((turn) => [turn, `sigma_${turn}_rad`, 180 / Math.PI]),
      ),
  },
  {
    group: "What it says of itself",
    title: "Weak directions",
    unit: "",
    rows: kDirections,
    lines: weakDirectionLines,
  },
  {
    group: "What it says of itself",
    title: "Observability",
    unit: "share [1]",
    fromZero: true,
    lines: observabilityLines,
  },
  {
    group: "Registration, scan by scan",
    title: "Time by step",
    unit: "time [ms]",
    fromZero: true,
    cut: true,
    lines: stepLines,
  },
  {
    group: "Registration, scan by scan",
    title: "Iterations",
    unit: "iterations [1]",
    fromZero: true,
    lines: (c) => stageLines(c, "iterations"),
  },
  {
    group: "Registration, scan by scan",
    title: "Matches",
    unit: "matches [1]",
    fromZero: true,
    lines: (c) => stageLines(c, "matches"),
  },
  {
    group: "Registration, scan by scan",
    title: "Residuals",
    unit: "residual [m]",
    fromZero: true,
    lines: (c) => stageLines(c, "residual_m"),
  },
];

/** From time to the chosen axis, by the path of the run that is looked at. */
export function axisOf(context) {
  if (context.store.get("axis") === "time")
    return { label: "time [s]", at: (time) => time, back: (x) => x };
  const { scans, lengths } = context.run();
  return {
    label: "path [m]",
    at: (time) => interpolate(scans.times, lengths, time),
    back: (x) => interpolate(lengths, scans.times, x),
  };
}
