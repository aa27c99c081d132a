// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The map as points whose colours the graphics card finds: changing them moves no data.
import * as THREE from "three";

import { paletteBytes } from "./palette.js";

const kVertexShader = `
  uniform vec3 low, extent;
  uniform vec2 heights;
  uniform float mode, until, size, perspective;
  attribute float intensity, seen;
  varying float shade;
  void main() {
    vec3 place = low + position * extent;
    vec4 view = modelViewMatrix * vec4(place, 1.0);
    gl_Position = projectionMatrix * view;
    gl_PointSize = clamp(size * perspective / -view.z, size, 4.0 * size);
    float height = (place.z - heights.x) / max(heights.y - heights.x, 1e-6);
    shade = mode < 0.5 ? height : mode < 1.5 ? intensity : seen;
    if (seen > until) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }`;

const kFragmentShader = `
  uniform sampler2D palette;
  uniform float opacity;
  varying float shade;
  void main() {
    gl_FragColor = vec4(texture2D(palette, vec2(clamp(shade, 0.002, 0.998), 0.5)).rgb, opacity);
  }`;

export const kModes = ["height", "intensity", "time"];

/** Heights between which nearly all points are: a few outliers shall not take the colours. */
export function usualHeights(map) {
  const stride = Math.max(1, Math.floor(map.shown / 20000));
  const heights = [];
  for (let i = 0; i < map.shown; i += stride) heights.push(map.steps[3 * i + 2]);
  heights.sort((a, b) => a - b);
  const at = (share) => {
    const step = heights[Math.floor(share * (heights.length - 1))] / 65535;
    return map.low[2] + step * (map.high[2] - map.low[2]);
  };
  return [at(0.02), at(0.98)];
}

function makeGeometry(map) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(map.steps, 3, true));
  const none = () => new THREE.BufferAttribute(new Uint8Array(map.shown), 1, true);
  const one = (series) => (series ? new THREE.BufferAttribute(series.steps, 1, true) : none());
  geometry.setAttribute("intensity", one(map.intensity));
  geometry.setAttribute("seen", one(map.firstSeen));
  // Positions become metres in the shader alone, so three cannot know where the points are.
  geometry.boundingSphere = new THREE.Sphere(new THREE.Vector3(), Infinity);
  return geometry;
}

export class MapPoints {
  constructor(map) {
    this.map = map;
    this.heights = usualHeights(map);
    const low = new THREE.Vector3(...map.low);
    this.palette = new THREE.DataTexture(new Uint8Array(4 * 256), 256, 1);
    this.palette.colorSpace = THREE.NoColorSpace;
    this.material = new THREE.ShaderMaterial({
      vertexShader: kVertexShader,
      fragmentShader: kFragmentShader,
      uniforms: {
        low: { value: low },
        extent: { value: new THREE.Vector3(...map.high).sub(low) },
        heights: { value: new THREE.Vector2(...this.heights) },
        mode: { value: 0 },
        until: { value: 2 },
        size: { value: 1.5 },
        perspective: { value: 40 },
        opacity: { value: 1 },
        palette: { value: this.palette },
      },
    });
    this.object = new THREE.Points(makeGeometry(map), this.material);
    this.object.frustumCulled = false;
  }

  setTheme(theme) {
    this.palette.image.data.set(paletteBytes(theme));
    this.palette.needsUpdate = true;
  }

  setMode(mode) {
    this.material.uniforms.mode.value = kModes.indexOf(mode);
  }

  setSize(pixels) {
    this.material.uniforms.size.value = pixels;
  }

  /** Hides what was first seen later [s after the run's first scan]; null shows everything. */
  showUntil(seconds) {
    const seen = this.map.firstSeen;
    const width = seen ? seen.high - seen.low : 0;
    this.material.uniforms.until.value =
      seconds === null || !(width > 0) ? 2 : (seconds - seen.low) / width + 1e-5;
  }

  /** What the colours mean: [low, high, unit]. */
  legend(mode) {
    if (mode === "intensity") return [this.map.intensity.low, this.map.intensity.high, ""];
    if (mode === "time") return [this.map.firstSeen.low, this.map.firstSeen.high, "s"];
    return [...this.heights, "m"];
  }

  dispose() {
    this.object.geometry.dispose();
    this.material.dispose();
    this.palette.dispose();
  }
}
