// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the run says of itself now, in figures.
import { choice, el } from "../dom.js";
import { duration, fixed, grouped, significant } from "../numbers.js";
import { gradeOf } from "../status.js";

/** Roll, pitch, yaw [deg]. */
function anglesOf([x, y, z, w]) {
  const degrees = 180 / Math.PI;
  return [
    degrees * Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    degrees * Math.asin(Math.max(-1, Math.min(1, 2 * (w * y - z * x)))),
    degrees * Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  ];
}

const kUntold = "–";

function figuresOf({ scan, figures, paused }) {
  const { latency_ms: latency } = figures;
  const [x, y, z] = scan?.pose.position ?? [];
  const [roll, pitch, yaw] = scan ? anglesOf(scan.pose.quaternion) : [];
  const grade = scan ? gradeOf({ scans: { status: [scan.status] } }, 0) : "ok";
  const wrong = scan?.wrong_probability ?? null;
  const kept = figures.left_out > 0 ? `, ${grouped(figures.left_out)} left out` : "";
  return [
    [
      "status",
      "Status",
      scan ? scan.status.replaceAll("_", " ") : "waiting",
      scan?.message ?? "",
      grade,
    ],
    ["wrong", "Probability of a wrong pose", wrong === null ? kUntold : significant(wrong, 2), ""],
    ["pose", "x, y, z", scan ? `${fixed(x, 2)}, ${fixed(y, 2)}, ${fixed(z, 2)}` : kUntold, "m"],
    [
      "attitude",
      "Roll, pitch, yaw",
      scan ? `${fixed(roll, 1)}, ${fixed(pitch, 1)}, ${fixed(yaw, 1)}` : kUntold,
      "degrees",
    ],
    [
      "way",
      "Way",
      `${fixed(scan?.way_m ?? 0, 1)} m`,
      scan ? `segment ${scan.segment}, ${duration(scan.time)}` : "",
    ],
    [
      "latency",
      "Latency, median",
      figures.used ? `${fixed(latency.p50, 1)} ms` : kUntold,
      figures.used ? `p99 ${fixed(latency.p99, 1)} ms, at most ${fixed(latency.max, 1)} ms` : "",
    ],
    ["scans", "Scans", grouped(figures.used), `${grouped(figures.dropped)} dropped${kept}`],
    ["weak", "Weak directions", scan?.weak || "none", paused ? "paused" : ""],
  ];
}

/** Returns what shows the news: show(live) and say(text). */
export function addLiveHeader(page, store, commands) {
  const title = el("h1", {}, "Surefoot live");
  const eyebrow = el("p.eyebrow", {}, "Surefoot");
  const connection = el("p.subtitle", { role: "status" }, "no word from the run yet");
  const themes = [
    ["auto", "Auto"],
    ["light", "Light"],
    ["dark", "Dark"],
  ];
  const values = new Map();
  const figures = el("dl.figures.of-now", { "aria-label": "Key figures" });
  page.append(
    el(
      "header",
      {},
      el("div.titles", {}, eyebrow, title, connection),
      choice("Colours of the page", themes, "auto", (wish) => store.set("themeWish", wish)),
    ),
    commands,
    figures,
  );
  const place = (key, label) => {
    if (!values.has(key)) {
      const value = el("dd");
      const below = el("dd.below");
      figures.append(el("div.figure", {}, el("dt", {}, label), value, below));
      value.dataset.key = key;
      values.set(key, [value, below]);
    }
    return values.get(key);
  };
  return {
    say: (text) => (connection.textContent = text),
    show: ({ state }) => {
      document.title = `${state.title} · Surefoot live`;
      title.textContent = state.title;
      eyebrow.textContent = `Surefoot ${state.version}, live`;
      for (const [key, label, text, note, grade] of figuresOf(state)) {
        const [value, below] = place(key, label);
        value.textContent = text;
        below.textContent = note;
        if (grade) value.dataset.grade = grade;
      }
    },
  };
}
