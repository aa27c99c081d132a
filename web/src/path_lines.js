// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Paths as lines of a width in pixels, drawn through whatever lies before them.
import * as THREE from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

import { isBreak } from "./data.js";

/** Pairs of neighbours that both have a place, in the same of the run's segments, as indices:
 * [0, 1, 1, 2, ...]. */
function neighboursOf(positions, segments) {
  const pairs = [];
  for (let i = 1; 3 * i < positions.length; ++i) {
    if (Number.isNaN(positions[3 * i]) || Number.isNaN(positions[3 * i - 3])) continue;
    if (!isBreak(segments, i)) pairs.push(i - 1, i);
  }
  return pairs;
}

export class PathLine {
  constructor(positions, { width, dashed = false, order, segments = null }) {
    const geometry = new LineSegmentsGeometry();
    this.places = neighboursOf(positions, segments);
    this.empty = this.places.length === 0;
    const coordinates = this.places.flatMap((i) => Array.from(positions.subarray(3 * i, 3 * i + 3)));
    if (!this.empty) geometry.setPositions(coordinates);
    this.material = new LineMaterial({
      linewidth: width,
      dashed,
      dashSize: 0.6,
      gapSize: 0.4,
      depthTest: false,
      transparent: true,
    });
    this.object = new LineSegments2(geometry, this.material);
    if (dashed) this.object.computeLineDistances();
    this.object.renderOrder = order;
    this.object.visible = !this.empty;
    this.object.frustumCulled = false;
  }

  setColor(text) {
    this.material.color = new THREE.Color(text);
    this.material.vertexColors = false;
    this.material.needsUpdate = true;
  }

  /** A colour for each place that the line was made of. */
  setColors(texts) {
    if (this.empty) return;
    const colors = this.places.flatMap((i) => new THREE.Color(texts[i]).toArray());
    this.object.geometry.setColors(colors);
    this.material.color = new THREE.Color("white");
    this.material.vertexColors = true;
    this.material.needsUpdate = true;
  }

  setSize(width, height) {
    this.material.resolution.set(width, height);
  }

  dispose() {
    this.object.geometry.dispose();
    this.material.dispose();
  }
}

const kShapes = {
  start: (context) => context.arc(32, 32, 18, 0, 2 * Math.PI),
  end: (context) => context.rect(16, 16, 32, 32),
  cursor: (context) => context.arc(32, 32, 14, 0, 2 * Math.PI),
};

/** A sign of constant size on the screen. */
export class Marker {
  constructor(shape, pixels) {
    this.shape = shape;
    this.pixels = pixels;
    this.canvas = document.createElement("canvas");
    this.canvas.width = this.canvas.height = 64;
    this.texture = new THREE.CanvasTexture(this.canvas);
    this.texture.colorSpace = THREE.SRGBColorSpace;
    this.material = new THREE.SpriteMaterial({
      map: this.texture,
      depthTest: false,
      sizeAttenuation: false,
    });
    this.object = new THREE.Sprite(this.material);
    this.object.renderOrder = 10;
  }

  setColors(fill, halo) {
    const context = this.canvas.getContext("2d");
    context.clearRect(0, 0, 64, 64);
    context.beginPath();
    kShapes[this.shape](context);
    context.fillStyle = fill;
    context.strokeStyle = halo;
    context.lineWidth = 10;
    context.stroke();
    context.fill();
    this.texture.needsUpdate = true;
  }

  /** Hidden where there is no place. */
  moveTo(positions, index) {
    const place = positions.subarray(3 * index, 3 * index + 3);
    this.object.visible = place.length === 3 && !Number.isNaN(place[0]);
    if (this.object.visible) this.object.position.set(...place);
  }

  setView(camera, height) {
    const size = (2 * Math.tan((camera.fov * Math.PI) / 360) * this.pixels) / height;
    this.object.scale.set(size, size, 1);
  }
}

/** First and last index with a place. */
export function ends(positions) {
  let first = 0;
  let last = positions.length / 3 - 1;
  while (first < last && Number.isNaN(positions[3 * first])) ++first;
  while (last > first && Number.isNaN(positions[3 * last])) --last;
  return [first, last];
}
