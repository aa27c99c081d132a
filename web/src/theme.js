// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Light or dark, and the colours that canvases take from the style sheet.

const system = matchMedia("(prefers-color-scheme: dark)");

export function followTheme(store) {
  const apply = () => {
    const wish = store.get("themeWish");
    const theme = wish === "auto" ? (system.matches ? "dark" : "light") : wish;
    document.documentElement.dataset.theme = theme;
    store.set("theme", theme);
  };
  system.addEventListener("change", apply);
  store.watch(["themeWish"], apply);
}

/** The value of a colour of style.css: color("path-1"). */
export function color(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

const kRunColors = 6;
const kStepColors = 10;

export const runColor = (place) => color(`run-${(place % kRunColors) + 1}`);
export const stepColor = (place) => color(`step-${(place % kStepColors) + 1}`);
