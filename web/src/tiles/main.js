// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The tileset.json beside this page, as much of it as the view needs. Draws when something has
// changed, not all the time.
import { TilesRenderer } from "3d-tiles-renderer/three";
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { grouped } from "../numbers.js";
import { Store } from "../store.js";
import { color, followTheme } from "../theme.js";

const kTarget = 8; // [px] of geometricError, which is four times the points' spacing: 2 px apart
const kPointSize = 2; // [px]

class TilesView {
  /** Throws where the browser has no WebGL. */
  constructor(canvas, state, store) {
    this.canvas = canvas;
    this.state = state;
    this.renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: true,
      preserveDrawingBuffer: true,
    });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(50, 1, 0.1, 5000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.listenToKeyEvents(canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.draw());
    this.#load();
    addEventListener("resize", () => this.resize());
    this.resize();
    store.watch(["theme"], () => this.#paint());
    canvas.addEventListener("webglcontextrestored", () => this.#paint());
  }

  #paint() {
    this.renderer.setClearColor(color("scene"));
    this.draw();
  }

  #load() {
    const tiles = new TilesRenderer(new URL("tileset.json", location.href).href);
    this.tiles = tiles;
    tiles.errorTarget = kTarget;
    // From a server's root the library asks for //tiles, which not every server takes for /tiles.
    tiles.registerPlugin({
      preprocessURL: (address) => {
        const url = new URL(address, location.href);
        url.pathname = url.pathname.replace(/^\/+/, "/");
        return url.href;
      },
    });
    tiles.setCamera(this.camera);
    tiles.addEventListener("load-root-tileset", () => this.#look());
    tiles.addEventListener("load-model", ({ scene }) => {
      scene.traverse((object) => {
        if (!object.isPoints) return;
        object.material.size = kPointSize * this.renderer.getPixelRatio();
        object.material.sizeAttenuation = false;
      });
    });
    for (const event of ["needs-update", "needs-render", "load-model", "tiles-load-end"]) {
      tiles.addEventListener(event, () => this.draw());
    }
    tiles.addEventListener("load-error", ({ error }) => {
      this.failed = true;
      this.state.textContent = `Cannot be read: ${error?.message ?? "a tile is missing"}`;
    });
    this.scene.add(tiles.group);
  }

  /** Everything in view, from obliquely above, wherever on the earth it is. */
  #look() {
    const { group, root } = this.tiles;
    new THREE.Matrix4()
      .fromArray(root.transform)
      .invert()
      .decompose(group.position, group.quaternion, group.scale);
    group.updateMatrixWorld(true);
    const [x, y, z, ...half] = root.boundingVolume.box;
    const size = 2 * Math.hypot(half[0], half[4], half[8]);
    const away = size / Math.min(0.7 * this.camera.aspect, 1); // a telephone shows less across
    this.controls.target.set(x, y, z);
    this.camera.position.set(x - 0.35 * away, y - 0.6 * away, z + 0.5 * away);
    this.camera.near = size / 2000;
    this.camera.far = size * 10;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
    this.tiles.setResolutionFromRenderer(this.camera, this.renderer);
    this.draw();
  }

  draw() {
    this.scheduled ??= requestAnimationFrame(() => {
      this.scheduled = undefined;
      this.camera.updateMatrixWorld();
      this.tiles.update();
      this.renderer.render(this.scene, this.camera);
      this.#tell();
    });
  }

  #tell() {
    const { downloading, parsing, visible } = this.tiles.stats;
    const points = grouped(this.renderer.info.render.points);
    const loading = downloading + parsing > 0;
    if (this.tiles.root && !this.failed) {
      this.state.textContent = `${points} points in ${visible} tiles${loading ? ", loading …" : ""}`;
    }
    if (visible > 0 && !loading) document.documentElement.dataset.ready = "";
  }
}

/** This page's folder as a shell takes it. */
function folderHere() {
  try {
    const folder = decodeURIComponent(location.pathname).replace(/\/[^/]*$/, "");
    return `'${folder.replaceAll("'", "'\\''")}'`;
  } catch {
    return "FOLDER"; // its name is no UTF-8
  }
}

const store = new Store({ themeWish: "auto", theme: "light" });
followTheme(store);
const state = document.getElementById("state");
if (location.protocol === "file:") {
  // Browsers keep a page that was opened as a file from reading the files beside it.
  state.textContent = `A browser shows this only from a server. Run: python3 -m http.server --bind 127.0.0.1 -d ${folderHere()}, and open http://127.0.0.1:8000/`;
} else {
  try {
    window.surefootTiles = new TilesView(document.getElementById("map"), state, store);
  } catch (error) {
    state.textContent = `The map cannot be drawn here: ${error.message}`;
  }
}
