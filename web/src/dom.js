// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT

/** An element with properties (or attributes, where they have a dash) and children. */
export function el(tag, properties = {}, ...children) {
  const [name, ...classes] = tag.split(".");
  const element = document.createElement(name);
  if (classes.length) element.className = classes.join(" ");
  for (const [key, value] of Object.entries(properties)) {
    if (key.includes("-") || key === "role" || key === "for") element.setAttribute(key, value);
    else element[key] = value;
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

let groups = 0;

/** Radio buttons that look like one switch; arrow keys move between them. */
export function choice(label, options, chosen, onChange) {
  const name = `choice-${++groups}`;
  const items = options.map(([value, text, hint]) => {
    const input = el("input", { type: "radio", name, value, checked: value === chosen });
    input.addEventListener("change", () => onChange(value));
    return el("label", { title: hint ?? "" }, input, el("span", {}, text));
  });
  return el("div.choice", { role: "radiogroup", "aria-label": label }, ...items);
}

export function toggle(text, checked, onChange) {
  const input = el("input", { type: "checkbox", checked });
  input.addEventListener("change", () => onChange(input.checked));
  return el("label.toggle", {}, input, el("span", {}, text));
}

/** Calls once a frame at most, and only when the element has a size. */
export function onResize(element, callback) {
  new ResizeObserver(() => {
    if (element.clientWidth > 0) requestAnimationFrame(callback);
  }).observe(element);
}
