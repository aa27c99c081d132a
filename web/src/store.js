// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the views share: which run is looked at, at which instant, along which axis.

export class Store {
  #values;
  #listeners = new Map();

  constructor(values) {
    this.#values = { ...values };
  }

  get(key) {
    return this.#values[key];
  }

  set(key, value) {
    if (Object.is(this.#values[key], value)) return;
    this.#values[key] = value;
    for (const listener of this.#listeners.get(key) ?? []) listener(value);
  }

  /** Calls now and whenever one of the keys changes. */
  watch(keys, listener) {
    for (const key of keys) {
      if (!this.#listeners.has(key)) this.#listeners.set(key, []);
      this.#listeners.get(key).push(() => listener(this));
    }
    listener(this);
  }
}
