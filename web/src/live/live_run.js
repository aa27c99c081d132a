// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a live run has told so far (src/live_page/page_history.cpp), as the report's views want a run.
import { decodePoints, floats, pathLengths } from "../data.js";

/** Numbers that are added to at the end. */
class Growing {
  #values = new Float32Array(1024);
  #length = 0;

  clear() {
    this.#length = 0;
  }

  add(more) {
    const length = this.#length + more.length;
    if (length > this.#values.length) {
      const larger = new Float32Array(2 * length);
      larger.set(this.all());
      this.#values = larger;
    }
    this.#values.set(more, this.#length);
    this.#length = length;
  }

  all() {
    return this.#values.subarray(0, this.#length);
  }
}

/** In 65536 steps an axis, as the map's points are drawn. */
function inSteps(points, cube) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    if (points[i] < low[i % 3]) low[i % 3] = points[i];
    if (points[i] > high[i % 3]) high[i % 3] = points[i];
  }
  const scale = low.map((value, axis) => 65535 / Math.max(high[axis] - value, 1e-6));
  const steps = new Uint16Array(points.length);
  for (let i = 0; i < points.length; ++i) steps[i] = (points[i] - low[i % 3]) * scale[i % 3];
  const count = points.length / 3;
  return { total: count, shown: count, cube, low, high, steps, intensity: null, firstSeen: null };
}

export class LiveRun {
  state = null; // the last message
  #path = {
    times: new Growing(),
    positions: new Growing(),
    latencies_ms: new Growing(),
    wrong_probabilities: new Growing(),
  };
  #statuses = [];
  #weak = [];
  #points = new Growing();
  #cube = 0;
  #map = null;
  #mapIsOld = false;

  take(news) {
    this.state = news;
    const { path, map } = news;
    if (path.anew) {
      Object.values(this.#path).forEach((series) => series.clear());
      this.#statuses = [];
      this.#weak = [];
    }
    for (const [name, series] of Object.entries(this.#path)) series.add(floats(path[name]));
    for (const status of path.statuses) this.#statuses.push(status);
    for (const weak of path.weak) this.#weak.push(weak);
    if (map.anew) this.#points.clear();
    if (map.positions) this.#points.add(decodePoints(map.positions));
    this.#cube = map.cube_m;
    this.#mapIsOld ||= map.anew || map.positions !== null;
  }

  /** As decodeRun() of data.js makes them. */
  get run() {
    const positions = this.#path.positions.all();
    return {
      index: 0,
      recording: 0,
      name: "live",
      path: { positions, angles: new Float32Array(positions.length) },
      lengths: pathLengths(positions),
      scans: {
        count: positions.length / 3,
        times: this.#path.times.all(),
        status: this.#statuses,
        messages: this.#statuses.map(() => ""),
        degenerate: this.#weak,
        stages: [],
        columns: {
          latency_ms: this.#path.latencies_ms.all(),
          wrong_probability: this.#path.wrong_probabilities.all(),
        },
      },
      map: this.#mapNow(),
      figures: null,
      errors: null,
      deskewing: [],
      loops: [],
      corrected: null,
    };
  }

  /** The same object as long as there are no new points. */
  #mapNow() {
    if (this.#mapIsOld) {
      const points = this.#points.all();
      this.#map = points.length ? inSteps(points, this.#cube) : null;
      this.#mapIsOld = false;
    }
    return this.#map;
  }
}
