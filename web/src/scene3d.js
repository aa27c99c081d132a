// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Map and paths in three dimensions. Draws when something has changed, not all the time.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { nearestIndex } from "./data.js";
import { onResize } from "./dom.js";
import { MapPoints } from "./map_points.js";
import { ends, Marker, PathLine } from "./path_lines.js";
import { pathShades, shadeColors } from "./path_shades.js";
import { color, runColor } from "./theme.js";

const kReach = 24; // [px] from the pointer to a path that it takes hold of

/** Middle and size of what is to be seen. */
function extentOf(run, truth, least) {
  const box = new THREE.Box3();
  const point = new THREE.Vector3();
  for (const positions of [run.path.positions, truth?.positions ?? []]) {
    for (let i = 0; i < positions.length; i += 3) {
      if (!Number.isNaN(positions[i])) box.expandByPoint(point.fromArray(positions, i));
    }
  }
  if (box.isEmpty()) box.expandByPoint(point.set(0, 0, 0));
  const size = Math.max(box.getSize(point).length(), least);
  return { middle: box.getCenter(new THREE.Vector3()), size };
}

export class Scene3d {
  /** Throws where the browser has no WebGL. */
  constructor(canvas, context, least = 8) {
    this.context = context;
    this.least = least; // [m] that are seen around a path that is shorter
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: true,
      preserveDrawingBuffer: true,
    });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.1, 5000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.listenToKeyEvents(canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.draw());
    this.scene = new THREE.Scene();
    this.lines = [];
    this.mode = "height";
    this.pointSize = 1.5;
    this.showMap = true;
    this.showTruth = true;
    this.markers = {
      start: new Marker("start", 20),
      end: new Marker("end", 20),
      cursor: new Marker("cursor", 26),
    };
    for (const marker of Object.values(this.markers)) this.scene.add(marker.object);
    onResize(canvas.parentElement, () => this.resize());
    // The browser may take the graphics away for a while; with them goes what was drawn.
    canvas.addEventListener("webglcontextrestored", () => this.setTheme());
    canvas.addEventListener("pointermove", (event) => this.#hover(event));
  }

  setRun() {
    this.showRun();
    this.resize();
    this.resetView();
  }

  /** Draws the run as it is now, from where it is looked at. */
  showRun() {
    for (const line of this.lines) {
      this.scene.remove(line.object);
      line.dispose();
    }
    this.lines = [];
    const run = this.context.run();
    const truth = this.context.recording().truth;
    if (truth) this.#addLine("truth", truth.positions, { width: 2, dashed: true, order: 3 });
    this.setTruthShown(this.showTruth);
    this.context.companions().forEach((companion, place) => {
      const here = companion === run;
      const { segment: segments } = companion.scans.columns;
      if (here) this.#addLine("halo", companion.path.positions, { width: 6, order: 4, segments });
      const style = { width: here ? 3 : 2, order: here ? 5 : 2, segments };
      this.#addLine(place, companion.path.positions, style).focus = here;
    });
    this.#setMap(run.map);
    const [first, last] = ends(run.path.positions);
    this.markers.start.moveTo(run.path.positions, first);
    this.markers.end.moveTo(run.path.positions, last);
    this.setTheme();
  }

  #addLine(role, positions, style) {
    const line = new PathLine(positions, style);
    line.role = role;
    line.setSize(this.canvas.clientWidth, this.canvas.clientHeight);
    this.lines.push(line);
    this.scene.add(line.object);
    return line;
  }

  #setMap(map) {
    if (this.points?.map === map) return;
    if (this.points) {
      this.scene.remove(this.points.object);
      this.points.dispose();
    }
    this.points = map ? new MapPoints(map) : null;
    if (!this.points) return;
    this.points.setMode(this.mode);
    this.points.setSize(this.pointSize * this.renderer.getPixelRatio());
    this.points.object.visible = this.showMap;
    this.scene.add(this.points.object);
  }

  setTheme() {
    this.renderer.setClearColor(color("scene"));
    for (const line of this.lines) {
      const named = typeof line.role === "string";
      line.setColor(named ? color(line.role) : runColor(line.role));
    }
    const shades = pathShades(this.context);
    const focus = this.lines.find((line) => line.focus);
    if (shades && focus) focus.setColors(shadeColors(shades, this.context.store.get("theme")));
    for (const [name, marker] of Object.entries(this.markers)) {
      marker.setColors(color(name), color("halo"));
    }
    this.points?.setTheme(this.context.store.get("theme"));
    this.draw();
  }

  setMode(mode) {
    this.mode = mode;
    this.points?.setMode(mode);
    this.draw();
  }

  setPointSize(pixels) {
    this.pointSize = pixels;
    this.points?.setSize(pixels * this.renderer.getPixelRatio());
    this.draw();
  }

  setMapShown(shown) {
    this.showMap = shown;
    if (this.points) this.points.object.visible = shown;
    this.draw();
  }

  setTruthShown(shown) {
    this.showTruth = shown;
    for (const line of this.lines) {
      if (line.role === "truth") line.object.visible = shown && !line.empty;
    }
    this.draw();
  }

  setCursor() {
    const { store, run } = this.context;
    const cursor = store.get("cursor");
    const { path, scans } = run();
    if (cursor === null) this.markers.cursor.object.visible = false;
    else this.markers.cursor.moveTo(path.positions, nearestIndex(scans.times, cursor));
    // While it replays, the map grows as it did for the robot.
    const grows = store.get("playing") && cursor !== null;
    this.points?.showUntil(grows ? cursor - scans.times[0] : null);
    this.draw();
  }

  /** Everything in view, from obliquely above; from farther where the view is narrow. */
  resetView() {
    const { middle, size } = extentOf(
      this.context.run(),
      this.context.recording().truth,
      this.least,
    );
    this.controls.target.copy(middle);
    this.camera.position
      .copy(middle)
      .add(new THREE.Vector3(-0.45, -0.75, 0.62).multiplyScalar(1.3 * size * Math.max(1, 1.2 / this.camera.aspect)));
    this.camera.near = size / 500;
    this.camera.far = size * 60;
    this.camera.updateProjectionMatrix();
    this.points && (this.points.material.uniforms.perspective.value = 0.6 * size);
    this.controls.update();
    this.draw();
  }

  /** Turns to where another scene looks. */
  lookAs(other) {
    this.following = true;
    this.camera.position.copy(other.camera.position);
    this.controls.target.copy(other.controls.target);
    this.controls.update();
    this.following = false;
    this.draw();
  }

  dispose() {
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    for (const line of this.lines) line.setSize(width, height);
    this.draw();
  }

  draw() {
    this.scheduled ??= requestAnimationFrame(() => {
      this.scheduled = undefined;
      for (const marker of Object.values(this.markers)) {
        marker.setView(this.camera, this.canvas.clientHeight || 1);
      }
      this.renderer.render(this.scene, this.camera);
    });
  }

  #hover(event) {
    if (event.buttons !== 0) return;
    const { path, scans } = this.context.run();
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const point = new THREE.Vector3();
    let best = kReach;
    let index = -1;
    for (let i = 0; i < scans.count; ++i) {
      point.fromArray(path.positions, 3 * i).project(this.camera);
      const x = ((point.x + 1) / 2) * width - event.offsetX;
      const y = ((1 - point.y) / 2) * height - event.offsetY;
      const distance = Math.hypot(x, y);
      if (point.z < 1 && distance < best) [best, index] = [distance, i];
    }
    if (index >= 0) {
      this.context.store.set("playing", false);
      this.context.store.set("cursor", scans.times[index]);
    }
  }
}
